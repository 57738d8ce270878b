// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of overlays.

#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Incremental_overlay_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Overlay_builder.h>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template Overlay_arrays build_overlay<Sequential_tag>(const Delta_complex&, const Correspondence&,
                                                      const Progress_function&);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The overlay by one thread.

#include <CGAL/Intrinsic_triangulations/internal/overlay/Overlay_builder.h>

namespace CGAL::Intrinsic_triangulations::internal {

template Overlay_arrays build_overlay<Sequential_tag>(const Delta_complex&, const Correspondence&,
                                                      const Progress_function&);

} // namespace CGAL::Intrinsic_triangulations::internal

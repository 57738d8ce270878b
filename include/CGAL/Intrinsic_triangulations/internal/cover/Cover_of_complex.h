// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The cover of a surface that is given by lengths.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/config.h>

#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// As make_tufted_cover() for a complex.
Tufted_cover build_cover_of_complex(const Delta_complex& complex, const std::vector<double>& lengths,
                                    const Tufted_cover_options& options);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/cover/Cover_of_complex_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_COVER_OF_COMPLEX_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The first include of the headers that need Eigen: one sentence where it is not found.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REQUIRE_EIGEN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REQUIRE_EIGEN_H

#if !__has_include(<Eigen/SparseCore>)
#error                                                                                                                 \
  "This header needs Eigen 3: install it (Debian: libeigen3-dev) and add its folder (-I/usr/include/eigen3), or link Eigen3::Eigen in CMake"
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_REQUIRE_EIGEN_H

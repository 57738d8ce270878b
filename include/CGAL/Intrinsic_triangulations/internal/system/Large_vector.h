// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The vector that holds one item for each element of a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_LARGE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_LARGE_VECTOR_H

#include <CGAL/Intrinsic_triangulations/internal/system/Huge_page_allocator.h>

#include <boost/container/vector.hpp>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Can be made without a pass that initializes it: `Large_vector<T> v(n, default_init)`.
template <class T>
using Large_vector = boost::container::vector<T, Huge_page_allocator<T>>;

using boost::container::default_init;

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_LARGE_VECTOR_H

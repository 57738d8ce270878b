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

#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief a vector that holds one item for each element of a surface: a vector of Boost with an allocator of its own.
///
/// Unlike a `std::vector`, it can be made without a pass over the memory that initializes it: `Large_vector<T> v(n,
/// boost::container::default_init)`. It is constructed from a range by `Large_vector<T> v(begin, end)`.
template <class T>
using Large_vector = boost::container::vector<T, internal::Huge_page_allocator<T>>;

namespace internal {
using boost::container::default_init;

// Makes room for n elements more, so that to append them does not throw. Amortized as `push_back()`.
template <class Vector>
void make_room(Vector& vector, std::size_t n)
{
  if (vector.capacity() - vector.size() < n)
    vector.reserve(vector.size() + vector.size() / 2 + n);
}
} // namespace internal

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_LARGE_VECTOR_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Products of vectors in space, for any number type.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_VECTOR_PRODUCTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_VECTOR_PRODUCTS_H

#include <array>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class FT>
using Vector_3 = std::array<FT, 3>;

template <class FT>
FT scalar_product(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class FT>
Vector_3<FT> cross_product(const Vector_3<FT>& a, const Vector_3<FT>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_VECTOR_PRODUCTS_H

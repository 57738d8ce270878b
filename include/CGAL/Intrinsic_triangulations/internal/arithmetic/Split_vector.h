// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vectors between points of doubles, and their products.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_VECTOR_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>

#include <boost/config.hpp>

#include <array>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A difference of two points is exact, its products are as good as Split_double_double says.
template <class Number>
using Split_vector = std::array<Split_double_double<Number>, 3>;

// From p to q.
BOOST_FORCEINLINE Split_vector<double> split_vector(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  using Real = Split_double_double<double>;
  return {Real::difference(q[0], p[0]), Real::difference(q[1], p[1]), Real::difference(q[2], p[2])};
}
// From p to q, and from r to s.
BOOST_FORCEINLINE Split_vector<Two_doubles> two_split_vectors(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                                              const std::array<double, 3>& r, const std::array<double, 3>& s)
{
  using Pair = Split_double_double<Two_doubles>;
  return {Pair::difference({q[0], s[0]}, {p[0], r[0]}), Pair::difference({q[1], s[1]}, {p[1], r[1]}),
          Pair::difference({q[2], s[2]}, {p[2], r[2]})};
}

template <class Number>
BOOST_FORCEINLINE Split_double_double<Number> split_scalar_product(const Split_vector<Number>& v, const Split_vector<Number>& w)
{
  return sum(v[0] * w[0], v[1] * w[1], v[2] * w[2]);
}

// The square of the area that two vectors span.
template <class Number>
BOOST_FORCEINLINE Split_double_double<Number> split_squared_area(const Split_vector<Number>& v, const Split_vector<Number>& w)
{
  const Split_double_double<Number> n0 = sum(v[1] * w[2], -(v[2] * w[1])), n1 = sum(v[2] * w[0], -(v[0] * w[2])),
                                    n2 = sum(v[0] * w[1], -(v[1] * w[0]));
  return sum(n0 * n0, n1 * n1, n2 * n2);
}

// The square of a length, in plain numbers.
template <class Number>
BOOST_FORCEINLINE Number rough_square(const Split_vector<Number>& v)
{
  return v[0].hi * v[0].hi + v[1].hi * v[1].hi + v[2].hi * v[2].hi;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_VECTOR_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What CGAL has to know about the compiler's own quadruple-precision type, `__float128`.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_QUADRUPLE_PRECISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_QUADRUPLE_PRECISION_H

#ifdef __SIZEOF_FLOAT128__

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/functional.h>
#include <CGAL/tags.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations::internal {

__extension__ typedef __float128 Float128; // avoids pedantic warnings

// Accurate to one unit in the last place. Not by libquadmath or the C library: which of them is available depends on
// the compiler and the language standard.
inline Float128 square_root(Float128 x)
{
  // Numbers beyond the range of `long double`, from whose root this starts.
  if (x > 0 && x < (std::numeric_limits<long double>::min)())
    return square_root(x * 0x1p200) * 0x1p-100;
  if (x > (std::numeric_limits<long double>::max)() && x - x == 0)
    return square_root(x * 0x1p-200) * 0x1p100;
  const Float128 root = std::sqrt(static_cast<long double>(x));
  if (!(root > 0 && root - root == 0))
    return root; // zero, infinity or NaN
  // One step of Newton's method doubles the 63 or more bits.
  return root + (x - root * root) / (root + root);
}

} // namespace Intrinsic_triangulations::internal

template <>
class Algebraic_structure_traits<Intrinsic_triangulations::internal::Float128>
  : public Algebraic_structure_traits_base<Intrinsic_triangulations::internal::Float128, Field_with_sqrt_tag>
{
public:
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  class Sqrt : public CGAL::cpp98::unary_function<Type, Type>
  {
  public:
    Type operator()(Type x) const { return Intrinsic_triangulations::internal::square_root(x); }
  };
};

template <>
class Real_embeddable_traits<Intrinsic_triangulations::internal::Float128>
  : public INTERN_RET::Real_embeddable_traits_base<Intrinsic_triangulations::internal::Float128, Tag_true>
{
public:
  class Is_finite : public CGAL::cpp98::unary_function<Type, bool>
  {
  public:
    bool operator()(Type x) const { return x - x == 0; }
  };

  class To_double : public CGAL::cpp98::unary_function<Type, double>
  {
  public:
    double operator()(Type x) const { return static_cast<double>(x); }
  };

  // The two doubles next to the number.
  class To_interval : public CGAL::cpp98::unary_function<Type, std::pair<double, double>>
  {
  public:
    std::pair<double, double> operator()(Type x) const
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double nearest = static_cast<double>(x);
      return {nearest > x ? std::nextafter(nearest, -infinity) : nearest,
              nearest < x ? std::nextafter(nearest, infinity) : nearest};
    }
  };
};
} // namespace CGAL

#endif // __SIZEOF_FLOAT128__

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_QUADRUPLE_PRECISION_H

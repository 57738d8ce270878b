// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Sums of products in about 106 bits: for expressions with one bound for their error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>

#include <boost/config.hpp>

#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// An unevaluated sum hi + lo, of doubles or of `Two_doubles`. The parts head + tail == hi are so short
// that their products are exact; a number that is a factor several times is split once.
//
// A sum of up to three products is good to 2^-102 of the sum of their absolute values, a
// quotient and a root to 2^-102 of themselves. Without over- and underflow, that is.
template <class Number>
struct Split_double_double
{
  Number hi, lo, head, tail;

  Split_double_double() = default;
  BOOST_FORCEINLINE Split_double_double(const Number& high, const Number& low) : hi(unfused(high)), lo(low)
  {
    split(hi, head, tail);
  }

  BOOST_FORCEINLINE static Split_double_double difference(const Number& a, const Number& b)
  {
    Number s, e;
    two_sum(a, -b, s, e);
    return {s, e};
  }

  // A product, not yet split: the exact one of the high parts, and the rest.
  struct Product
  {
    Number hi, lo;
    BOOST_FORCEINLINE friend Product operator-(const Product& a) { return {-a.hi, -a.lo}; }
  };
  BOOST_FORCEINLINE friend Product operator*(const Split_double_double& a,
                                             const Split_double_double& b)
  {
    const Number p = unfused(a.hi * b.hi);
    const Number e = ((a.head * b.head - p) + a.head * b.tail + a.tail * b.head) + a.tail * b.tail;
    return {p, e + (a.hi * b.lo + a.lo * b.hi)};
  }

  BOOST_FORCEINLINE friend Split_double_double sum(const Product& a, const Product& b)
  {
    Number s, e, hi, lo;
    two_sum(a.hi, b.hi, s, e);
    two_sum(s, e + (a.lo + b.lo), hi, lo);
    return {hi, lo};
  }
  BOOST_FORCEINLINE friend Split_double_double sum(const Product& a, const Product& b,
                                                   const Product& c)
  {
    Number s, e, t, f, hi, lo;
    two_sum(a.hi, b.hi, s, e);
    two_sum(s, c.hi, t, f);
    two_sum(t, (e + f) + (a.lo + b.lo + c.lo), hi, lo);
    return {hi, lo};
  }
  BOOST_FORCEINLINE friend Split_double_double operator+(const Split_double_double& a,
                                                         const Split_double_double& b)
  {
    return sum(Product{a.hi, a.lo}, Product{b.hi, b.lo});
  }
  BOOST_FORCEINLINE friend Split_double_double operator-(const Split_double_double& a,
                                                         const Split_double_double& b)
  {
    return sum(Product{a.hi, a.lo}, Product{-b.hi, -b.lo});
  }
  BOOST_FORCEINLINE friend Split_double_double operator-(const Split_double_double& a)
  {
    return {-a.hi, -a.lo};
  }

  // a / b, given the rounded reciprocal of b.
  BOOST_FORCEINLINE friend Split_double_double quotient(const Split_double_double& a,
                                                        const Split_double_double& b,
                                                        const Number& reciprocal)
  {
    const Number q = a.hi * reciprocal;
    const Product p = Split_double_double(q, Number(0)) * b;
    Number hi, lo;
    fast_two_sum(q, ((a.hi - p.hi) + (a.lo - p.lo)) * reciprocal, hi, lo);
    return {hi, lo};
  }

  // a.hi is positive.
  BOOST_FORCEINLINE friend Split_double_double square_root(const Split_double_double& a)
  {
    using std::sqrt;
    const Split_double_double root(sqrt(a.hi), Number(0));
    const Product p = root * root;
    Number hi, lo;
    fast_two_sum(root.hi, ((a.hi - p.hi) + (a.lo - p.lo)) / (root.hi + root.hi), hi, lo);
    return {hi, lo};
  }
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H

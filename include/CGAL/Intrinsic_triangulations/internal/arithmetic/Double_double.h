// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Unevaluated sums of two doubles, about 106 bits, and the exact operations that they are built from.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/internal/system/unfused.h>

#include <boost/config.hpp>

namespace CGAL::Intrinsic_triangulations::internal {

// s + e is exactly a + b (Knuth). A `Number` is double, or several of them. Arguments are taken by value, since results
// may replace them, and unfused, since they may be products.
template <class Number>
BOOST_FORCEINLINE void two_sum(Number a, Number b, Number& s, Number& e)
{
  a = unfused(a);
  b = unfused(b);
  s = a + b;
  const Number bb = s - a;
  e = (a - (s - bb)) + (b - bb);
}

// Like two_sum, for |a| >= |b| or a == 0 (Dekker).
template <class Number>
BOOST_FORCEINLINE void fast_two_sum(Number a, Number b, Number& s, Number& e)
{
  a = unfused(a);
  b = unfused(b);
  s = a + b;
  e = b - (s - a);
}

// head + tail is x, and products of such parts are exact, fused with a sum or not (Veltkamp).
template <class Number>
BOOST_FORCEINLINE void split(Number x, Number& head, Number& tail)
{
  const Number c = unfused(Number(134217729.0) * x); // 2^27 + 1
  head = c - (c - x);
  tail = x - head;
}

// p + e is exactly a * b (Dekker), unless something over- or underflows.
template <class Number>
inline void two_product(Number a, Number b, Number& p, Number& e)
{
  Number ah, al, bh, bl;
  split(unfused(a), ah, al);
  split(unfused(b), bh, bl);
  p = unfused(a * b);
  e = ((ah * bh - p) + ah * bl + al * bh) + al * bl;
}

// The double next to a number.
inline double high(double x) { return x; }

// Additions and multiplications have relative errors of at most 2^-103; the caller bounds the error of the whole
// expression.
template <class Number>
struct Basic_double_double
{
  Number hi = 0., lo = 0.;

  static Basic_double_double difference(const Number& a, const Number& b)
  {
    Basic_double_double r;
    two_sum(a, -b, r.hi, r.lo);
    return r;
  }

  friend Basic_double_double operator-(const Basic_double_double& a) { return {-a.hi, -a.lo}; }
  friend Basic_double_double operator+(const Basic_double_double& a, const Basic_double_double& b)
  {
    Number s, e, t, f;
    two_sum(a.hi, b.hi, s, e);
    two_sum(a.lo, b.lo, t, f);
    Basic_double_double r;
    fast_two_sum(s, e + t, r.hi, r.lo);
    fast_two_sum(r.hi, r.lo + f, r.hi, r.lo);
    return r;
  }
  friend Basic_double_double operator-(const Basic_double_double& a, const Basic_double_double& b) { return a + -b; }
  friend Basic_double_double operator*(const Basic_double_double& a, const Basic_double_double& b)
  {
    Number p, e;
    two_product(a.hi, b.hi, p, e);
    Basic_double_double r;
    fast_two_sum(p, e + (a.hi * b.lo + a.lo * b.hi), r.hi, r.lo);
    return r;
  }
  friend Number high(const Basic_double_double& x) { return x.hi; }
};

using Double_double = Basic_double_double<double>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_DOUBLE_DOUBLE_H

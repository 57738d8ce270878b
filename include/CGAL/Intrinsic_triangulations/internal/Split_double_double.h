// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sums of products in about 106 bits: for expressions with one bound for their error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SPLIT_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SPLIT_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/internal/Double_double.h>

#include <boost/config.hpp>

#include <cmath>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// An unevaluated sum hi + lo. The parts head + tail == hi are so short that their products are
// exact (Veltkamp); a number that is a factor several times is split once.
//
// A sum of up to three products is good to 2^-102 of the sum of their absolute values, a
// quotient and a root to 2^-102 of themselves. Without over- and underflow, that is.
struct Split_double_double
{
  double hi, lo, head, tail;

  Split_double_double() = default;
  BOOST_FORCEINLINE Split_double_double(double high, double low) : hi(high), lo(low)
  {
    const double c = 134217729.0 * hi; // 2^27 + 1
    head = c - (c - hi);
    tail = hi - head;
  }

  BOOST_FORCEINLINE static Split_double_double difference(double a, double b)
  {
    double s, e;
    two_sum(a, -b, s, e);
    return {s, e};
  }

  // A product, not yet split: the exact one of the high parts, and the rest.
  struct Product
  {
    double hi, lo;
    BOOST_FORCEINLINE friend Product operator-(const Product& a) { return {-a.hi, -a.lo}; }
  };
  BOOST_FORCEINLINE friend Product operator*(const Split_double_double& a,
                                             const Split_double_double& b)
  {
    const double p = a.hi * b.hi;
    const double e = ((a.head * b.head - p) + a.head * b.tail + a.tail * b.head) + a.tail * b.tail;
    return {p, e + (a.hi * b.lo + a.lo * b.hi)};
  }

  BOOST_FORCEINLINE friend Split_double_double sum(const Product& a, const Product& b)
  {
    double s, e, hi, lo;
    two_sum(a.hi, b.hi, s, e);
    two_sum(s, e + (a.lo + b.lo), hi, lo);
    return {hi, lo};
  }
  BOOST_FORCEINLINE friend Split_double_double sum(const Product& a, const Product& b,
                                                   const Product& c)
  {
    double s, e, t, f, hi, lo;
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

  // a / b, given the rounded reciprocal of b.
  BOOST_FORCEINLINE friend Split_double_double quotient(const Split_double_double& a,
                                                        const Split_double_double& b,
                                                        double reciprocal)
  {
    const double q = a.hi * reciprocal;
    const Product p = Split_double_double(q, 0) * b;
    double hi, lo;
    fast_two_sum(q, ((a.hi - p.hi) + (a.lo - p.lo)) * reciprocal, hi, lo);
    return {hi, lo};
  }

  // Zero for what rounding has made negative.
  BOOST_FORCEINLINE friend Split_double_double square_root(const Split_double_double& a)
  {
    if (!(a.hi > 0))
      return {0, 0};
    const Split_double_double root(std::sqrt(a.hi), 0);
    const Product p = root * root;
    double hi, lo;
    fast_two_sum(root.hi, ((a.hi - p.hi) + (a.lo - p.lo)) / (2 * root.hi), hi, lo);
    return {hi, lo};
  }
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SPLIT_DOUBLE_DOUBLE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Sums of products in about 106 bits: numbers, vectors in space and complex numbers, for expressions with one bound for
// their error.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H

#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>

namespace CGAL::Intrinsic_triangulations::internal {

// An unevaluated sum hi + lo, of doubles or of `Two_doubles`. The parts head + tail == hi are so short that their
// products are exact; a number that is a factor several times is split only once.
//
// Without over- and underflow, the error of a sum of up to three products is at most 2^-102 times the sum of their
// absolute values, and the relative error of a quotient or root is at most 2^-102.
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
  BOOST_FORCEINLINE friend Product operator*(const Split_double_double& a, const Split_double_double& b)
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
  BOOST_FORCEINLINE friend Split_double_double sum(const Product& a, const Product& b, const Product& c)
  {
    Number s, e, t, f, hi, lo;
    two_sum(a.hi, b.hi, s, e);
    two_sum(s, c.hi, t, f);
    two_sum(t, (e + f) + (a.lo + b.lo + c.lo), hi, lo);
    return {hi, lo};
  }
  BOOST_FORCEINLINE friend Split_double_double operator+(const Split_double_double& a, const Split_double_double& b)
  {
    return sum(Product{a.hi, a.lo}, Product{b.hi, b.lo});
  }
  BOOST_FORCEINLINE friend Split_double_double operator-(const Split_double_double& a, const Split_double_double& b)
  {
    return sum(Product{a.hi, a.lo}, Product{-b.hi, -b.lo});
  }
  BOOST_FORCEINLINE friend Split_double_double operator-(const Split_double_double& a) { return {-a.hi, -a.lo}; }

  // a / b, given the rounded reciprocal of b.
  BOOST_FORCEINLINE friend Split_double_double quotient(const Split_double_double& a, const Split_double_double& b,
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
    const Split_double_double root(rounded_sqrt(a.hi), Number(0));
    const Product p = root * root;
    Number hi, lo;
    fast_two_sum(root.hi, ((a.hi - p.hi) + (a.lo - p.lo)) / (root.hi + root.hi), hi, lo);
    return {hi, lo};
  }
};

// A difference of two points is exact; its products are as accurate as Split_double_double promises.
template <class Number>
using Split_vector = std::array<Split_double_double<Number>, 3>;

// From p to q.
BOOST_FORCEINLINE Split_vector<double> split_vector(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  using Real = Split_double_double<double>;
  return {Real::difference(q[0], p[0]), Real::difference(q[1], p[1]), Real::difference(q[2], p[2])};
}
// From p to q, and from r to s.
BOOST_FORCEINLINE Split_vector<Two_doubles> two_split_vectors(const std::array<double, 3>& p,
                                                              const std::array<double, 3>& q,
                                                              const std::array<double, 3>& r,
                                                              const std::array<double, 3>& s)
{
  using Pair = Split_double_double<Two_doubles>;
  return {Pair::difference({q[0], s[0]}, {p[0], r[0]}), Pair::difference({q[1], s[1]}, {p[1], r[1]}),
          Pair::difference({q[2], s[2]}, {p[2], r[2]})};
}

template <class Number>
BOOST_FORCEINLINE Split_double_double<Number> split_scalar_product(const Split_vector<Number>& v,
                                                                   const Split_vector<Number>& w)
{
  return sum(v[0] * w[0], v[1] * w[1], v[2] * w[2]);
}

// The square of the area that two vectors span.
template <class Number>
BOOST_FORCEINLINE Split_double_double<Number> split_squared_area(const Split_vector<Number>& v,
                                                                 const Split_vector<Number>& w)
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

// Operates on both coordinates at once.
class Split_complex
{
  using Pair = Split_double_double<Two_doubles>;
  using Real = Split_double_double<double>;

public:
  Split_complex() = default;
  BOOST_FORCEINLINE Split_complex(const Pair& xy) : xy_(xy) {}
  BOOST_FORCEINLINE Split_complex(double x, double y) : xy_(Two_doubles(x, y), Two_doubles(0.)) {}

  // Two points, from their coordinates.
  BOOST_FORCEINLINE static std::array<Split_complex, 2> two_points(const Pair& x, const Pair& y)
  {
    std::array<Split_complex, 2> result;
    const auto transpose = [&](Two_doubles Pair::*part) {
      result[0].xy_.*part = firsts(x.*part, y.*part);
      result[1].xy_.*part = seconds(x.*part, y.*part);
    };
    transpose(&Pair::hi);
    transpose(&Pair::lo);
    transpose(&Pair::head);
    transpose(&Pair::tail);
    return result;
  }

  BOOST_FORCEINLINE friend Split_complex operator+(const Split_complex& a, const Split_complex& b)
  {
    return a.xy_ + b.xy_;
  }
  BOOST_FORCEINLINE friend Split_complex operator-(const Split_complex& a, const Split_complex& b)
  {
    return a.xy_ - b.xy_;
  }
  BOOST_FORCEINLINE friend Split_complex operator-(const Split_complex& a) { return -a.xy_; }
  BOOST_FORCEINLINE friend Split_complex operator*(const Split_complex& a, const Split_complex& b)
  {
    const auto first = Pair(parts(a.xy_, [](Two_doubles t) { return firsts(t, t); })) * b.xy_;
    const auto second = Pair(parts(a.xy_, [](Two_doubles t) { return seconds(t, t); })) * turned(b.xy_);
    const Two_doubles sign(-1, 1);
    return sum(first, Pair::Product{sign * second.hi, sign * second.lo});
  }
  // Twice the area of the triangle (0, a, b): positive if b is to the left of a.
  BOOST_FORCEINLINE friend Real area_between(const Split_complex& a, const Split_complex& b)
  {
    const auto product = a.xy_ * turned(b.xy_);
    return sum(Real::Product{product.hi.first(), product.lo.first()},
               Real::Product{-product.hi.second(), -product.lo.second()});
  }
  // An upper bound.
  BOOST_FORCEINLINE friend double modulus(const Split_complex& z)
  {
    const Two_doubles size = abs(z.xy_.hi);
    return 1.5 * (size.first() + size.second());
  }

private:
  template <class Function>
  BOOST_FORCEINLINE static Pair parts(const Pair& a, const Function& f)
  {
    Pair result;
    result.hi = f(a.hi);
    result.lo = f(a.lo);
    result.head = f(a.head);
    result.tail = f(a.tail);
    return result;
  }
  BOOST_FORCEINLINE static Pair turned(const Pair& a)
  {
    return parts(a, [](Two_doubles t) { return swapped(t); });
  }

  Pair xy_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_SPLIT_DOUBLE_DOUBLE_H

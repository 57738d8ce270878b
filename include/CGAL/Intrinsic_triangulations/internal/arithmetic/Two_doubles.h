// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Two doubles on which the processor operates at once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_TWO_DOUBLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_TWO_DOUBLES_H

#include <CGAL/Intrinsic_triangulations/internal/system/unfused.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/rounded_sqrt.h>

#include <boost/config.hpp>

#include <array>
#include <cmath>

// By the processor alone, so that the library and all parts of a program agree.
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace CGAL::Intrinsic_triangulations::internal {

// Each operation is done on both numbers and rounded as on one: a formula written for a number type gives its result
// for `double` twice, bit for bit unless the compiler fuses products and sums.
class Two_doubles
{
public:
  Two_doubles() = default;
#ifdef __SSE2__
  Two_doubles(double both) : v_(_mm_set1_pd(both)) {}
  Two_doubles(double first, double second) : v_(_mm_set_pd(second, first)) {}
  double first() const { return _mm_cvtsd_f64(v_); }
  double second() const { return _mm_cvtsd_f64(_mm_unpackhi_pd(v_, v_)); }
  // rounded
  std::array<float, 2> floats() const
  {
    const __m128 f = _mm_cvtpd_ps(v_);
    return {_mm_cvtss_f32(f), _mm_cvtss_f32(_mm_shuffle_ps(f, f, 1))};
  }

  friend Two_doubles operator+(Two_doubles a, Two_doubles b) { return _mm_add_pd(a.v_, b.v_); }
  friend Two_doubles operator-(Two_doubles a, Two_doubles b) { return _mm_sub_pd(a.v_, b.v_); }
  friend Two_doubles operator*(Two_doubles a, Two_doubles b) { return _mm_mul_pd(a.v_, b.v_); }
  friend Two_doubles operator/(Two_doubles a, Two_doubles b) { return _mm_div_pd(a.v_, b.v_); }
  friend Two_doubles operator-(Two_doubles a) { return _mm_xor_pd(_mm_set1_pd(-0.), a.v_); }
  friend Two_doubles rounded_sqrt(Two_doubles a) { return _mm_sqrt_pd(a.v_); }
  friend Two_doubles unfused(Two_doubles a) { return internal::unfused(a.v_); }
  friend Two_doubles abs(Two_doubles a) { return _mm_andnot_pd(_mm_set1_pd(-0.), a.v_); }
  // the larger, or smaller, of each two; b if one of them is NaN
  friend Two_doubles max_of(Two_doubles a, Two_doubles b) { return _mm_max_pd(a.v_, b.v_); }
  friend Two_doubles min_of(Two_doubles a, Two_doubles b) { return _mm_min_pd(a.v_, b.v_); }
  // the first numbers of both, the second ones, and the two numbers of one swapped
  friend Two_doubles firsts(Two_doubles a, Two_doubles b) { return _mm_unpacklo_pd(a.v_, b.v_); }
  friend Two_doubles seconds(Two_doubles a, Two_doubles b) { return _mm_unpackhi_pd(a.v_, b.v_); }
  friend Two_doubles swapped(Two_doubles a) { return _mm_shuffle_pd(a.v_, a.v_, 1); }
  // x where a > b, else y
  friend Two_doubles if_greater(Two_doubles a, Two_doubles b, Two_doubles x, Two_doubles y)
  {
    const __m128d is_greater = _mm_cmpgt_pd(a.v_, b.v_);
    return _mm_or_pd(_mm_and_pd(is_greater, x.v_), _mm_andnot_pd(is_greater, y.v_));
  }

private:
  Two_doubles(__m128d v) : v_(v) {}
  __m128d v_;
#else
  Two_doubles(double both) : v_{both, both} {}
  Two_doubles(double first, double second) : v_{first, second} {}
  double first() const { return v_[0]; }
  double second() const { return v_[1]; }
  std::array<float, 2> floats() const { return {float(v_[0]), float(v_[1])}; }

  friend Two_doubles operator+(Two_doubles a, Two_doubles b) { return {a.v_[0] + b.v_[0], a.v_[1] + b.v_[1]}; }
  friend Two_doubles operator-(Two_doubles a, Two_doubles b) { return {a.v_[0] - b.v_[0], a.v_[1] - b.v_[1]}; }
  friend Two_doubles operator*(Two_doubles a, Two_doubles b) { return {a.v_[0] * b.v_[0], a.v_[1] * b.v_[1]}; }
  friend Two_doubles operator/(Two_doubles a, Two_doubles b) { return {a.v_[0] / b.v_[0], a.v_[1] / b.v_[1]}; }
  friend Two_doubles operator-(Two_doubles a) { return {-a.v_[0], -a.v_[1]}; }
  friend Two_doubles rounded_sqrt(Two_doubles a)
  {
    return {internal::rounded_sqrt(a.v_[0]), internal::rounded_sqrt(a.v_[1])};
  }
  friend Two_doubles unfused(Two_doubles a) { return {internal::unfused(a.v_[0]), internal::unfused(a.v_[1])}; }
  friend Two_doubles abs(Two_doubles a) { return {std::abs(a.v_[0]), std::abs(a.v_[1])}; }
  friend Two_doubles max_of(Two_doubles a, Two_doubles b) { return if_greater(a, b, a, b); }
  friend Two_doubles min_of(Two_doubles a, Two_doubles b) { return if_greater(b, a, a, b); }
  friend Two_doubles firsts(Two_doubles a, Two_doubles b) { return {a.v_[0], b.v_[0]}; }
  friend Two_doubles seconds(Two_doubles a, Two_doubles b) { return {a.v_[1], b.v_[1]}; }
  friend Two_doubles swapped(Two_doubles a) { return {a.v_[1], a.v_[0]}; }
  friend Two_doubles if_greater(Two_doubles a, Two_doubles b, Two_doubles x, Two_doubles y)
  {
    return {a.v_[0] > b.v_[0] ? x.v_[0] : y.v_[0], a.v_[1] > b.v_[1] ? x.v_[1] : y.v_[1]};
  }

private:
  double v_[2];
#endif
};

using Two_points = std::array<Two_doubles, 3>;

inline Two_doubles two(double first, double second) { return {first, second}; }

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_TWO_DOUBLES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points of exact kernels, without rounding.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_METRIC_RATIONAL_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_METRIC_RATIONAL_POINTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// The coordinates of consecutive points, of any number type of CGAL. They arrive as text or as sums of doubles, so only
// the definitions know a type of rational numbers.
class Rational_points
{
public:
  Rational_points();
  ~Rational_points();

  template <class Number>
  void add(const Number& x)
  {
    const auto interval = CGAL::to_interval(x);
    if (interval.first == interval.second)
      return add_double(interval.first);
    const auto& exact = without_laziness(x);
    using Exact = std::decay_t<decltype(exact)>;
    if constexpr (Fraction_traits<Exact>::Is_fraction::value) {
      typename Fraction_traits<Exact>::Numerator_type numerator;
      typename Fraction_traits<Exact>::Denominator_type denominator;
      typename Fraction_traits<Exact>::Decompose()(exact, numerator, denominator);
      add_fraction(decimal(numerator), decimal(denominator));
    } else {
      add_double(0);
      add_parts(exact, 0);
    }
  }

  // Whether all coordinates are doubles.
  bool are_doubles() const;
  // The metric of a surface with these vertices.
  Input_metric metric(const Delta_complex& complex) const;

private:
  struct Coordinates;

  void add_double(double x);
  void add_fraction(const std::string& numerator, const std::string& denominator);
  // Adds to the last coordinate.
  void add_to_last(double part, int exponent);

  template <class Integer>
  static std::string decimal(const Integer& n)
  {
    std::ostringstream digits;
    digits << n;
    return digits.str();
  }

  // x times a power of two, as a sum of doubles.
  template <class Number>
  void add_parts(const Number& x, int exponent)
  {
    double part = CGAL::to_double(x);
    // Parts of very large and small numbers would leave the range of double.
    if (std::abs(part) > 0x1p+900)
      return add_parts(Number(x * Number(0x1p-500)), exponent + 500);
    if (std::abs(part) < 0x1p-500 && x != Number(0))
      return add_parts(Number(x * Number(0x1p+500)), exponent - 500);
    for (Number rest = x; part != 0; part = CGAL::to_double(rest)) {
      add_to_last(part, exponent);
      rest = rest - Number(part);
    }
  }

  std::unique_ptr<Coordinates> coordinates_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_METRIC_RATIONAL_POINTS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Rational_points.

#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Rational_points.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Rational_points::Coordinates
{
  std::vector<Rational> numbers; // three for each point
  bool are_doubles = true;
};

Rational_points::Rational_points() : coordinates_(std::make_unique<Coordinates>()) {}
Rational_points::~Rational_points() = default;

bool Rational_points::are_doubles() const { return coordinates_->are_doubles; }

void Rational_points::add_double(double x) { coordinates_->numbers.emplace_back(x); }

void Rational_points::add_fraction(const std::string& numerator, const std::string& denominator)
{
  const Rational x = Rational(numerator) / Rational(denominator);
  coordinates_->are_doubles = coordinates_->are_doubles && Rational(x.convert_to<double>()) == x;
  coordinates_->numbers.push_back(x);
}

void Rational_points::add_to_last(double part, int exponent)
{
  Rational& last = coordinates_->numbers.back();
  Rational term(part);
  if (exponent > 0)
    mpq_mul_2exp(term.backend().data(), term.backend().data(), mp_bitcnt_t(exponent));
  else
    mpq_div_2exp(term.backend().data(), term.backend().data(), mp_bitcnt_t(-exponent));
  last += term;
  coordinates_->are_doubles = false;
}

Input_metric Rational_points::metric(const Delta_complex& complex) const
{
  const auto point = [this](Vertex_index v) { return coordinates_->numbers.data() + 3 * std::size_t(v.idx()); };
  std::vector<Rational> squared_lengths;
  squared_lengths.reserve(complex.number_of_edges());
  for (Edge_index e : complex.edges()) {
    const Rational *p = point(complex.source(complex.halfedge(e))), *q = point(complex.target(complex.halfedge(e)));
    const Rational x = q[0] - p[0], y = q[1] - p[1], z = q[2] - p[2];
    squared_lengths.push_back(x * x + y * y + z * z);
  }
  return metric_from_squared_lengths(std::move(squared_lengths));
}

} // namespace CGAL::Intrinsic_triangulations::internal

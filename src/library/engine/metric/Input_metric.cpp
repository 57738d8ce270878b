// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Input_metric, and of its functions in rational numbers.

#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include "../../arithmetic/Prime_field.h"
#include "../../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

struct Rational_lengths
{
  std::vector<Rational> squared;
};

inline Bounded_double_double rounded(const Rational& x)
{
  const double hi = x.convert_to<double>();
  const Rational rest = x - Rational(hi);
  const double lo = rest.convert_to<double>();
  const Rational error = rest - Rational(lo);
  return {hi, lo, error == 0 ? 0 : std::abs(lo) * 0x1p-50 + 1e-300};
}

// \pre the metric is given by doubles. Rational numbers would be made canonical after each sum and product.
inline Exact_ring squared_length_in_ring(const Input_metric& metric, const Delta_complex& input, Edge_index e)
{
  if (!metric.lengths().empty()) {
    const Exact_ring l(metric.lengths()[e.idx()]);
    return l * l;
  }
  const Halfedge_index h = input.halfedge(e);
  const auto side = difference<Exact_ring>(metric.points(), input.source(h), input.target(h));
  return scalar_product(side, side);
}

} // namespace internal

Input_metric Input_metric::from_points(Point_vector points)
{
  const int exponent = internal::normalize_points(points);
  return from_normalized_points(std::move(points), exponent);
}

Input_metric Input_metric::from_points(const Delta_complex& input, Point_vector points)
{
  const int exponent = internal::normalize_points(points, internal::Is_used_vertex{input});
  return from_normalized_points(std::move(points), exponent);
}

Input_metric Input_metric::from_lengths(std::vector<double> lengths)
{
  const int exponent = internal::normalize_lengths(lengths);
  return from_normalized_lengths(std::move(lengths), exponent);
}

Input_metric metric_from_squared_lengths(std::vector<Rational> squared_lengths)
{
  const auto metric = [&](int exponent) {
    auto lengths =
      std::make_shared<const internal::Rational_lengths>(internal::Rational_lengths{std::move(squared_lengths)});
    return Input_metric::from_normalized_squared_lengths(std::move(lengths), exponent);
  };
  // The largest length is below 2^largest and at least a quarter of that, unless no length is positive.
  long largest = (std::numeric_limits<long>::min)();
  std::size_t edge = 0;
  for (std::size_t e = 0; e < squared_lengths.size(); ++e) {
    const auto* const s = internal::data(squared_lengths[e]);
    const long size = long(mpz_sizeinbase(mpq_numref(s), 2)) - long(mpz_sizeinbase(mpq_denref(s), 2)) + 1;
    if (mpq_sgn(s) > 0 && size > largest) {
      largest = size;
      edge = e;
    }
  }
  if (largest == (std::numeric_limits<long>::min)())
    return metric(0);
  using Limits = std::numeric_limits<double>;
  if (largest > 2 * Limits::max_exponent || largest < 2 * Limits::min_exponent)
    throw Invalid_surface_error(internal::Defect::OUT_OF_RANGE, edge, 1,
                                "edge " + std::to_string(edge) +
                                  ": its length leaves the range of double; scale the squared lengths");
  const int exponent = internal::unit_exponent<double>(std::ldexp(1., int((largest - 1) / 2)));
  for (Rational& s : squared_lengths)
    if (exponent > 0)
      mpq_div_2exp(s.backend().data(), s.backend().data(), 2 * mp_bitcnt_t(exponent));
    else if (exponent < 0)
      mpq_mul_2exp(s.backend().data(), s.backend().data(), 2 * mp_bitcnt_t(-exponent));
  return metric(exponent);
}

Rational squared_length(const Input_metric& metric, const Delta_complex& input, Edge_index e)
{
  return metric.rational_lengths() ? metric.rational_lengths()->squared[e.idx()]
                                   : internal::rational(internal::squared_length_in_ring(metric, input, e));
}

Rational squared_four_areas(const Input_metric& metric, const Delta_complex& input, Face_index f)
{
  const Halfedge_index h = input.halfedge(f);
  const std::array<Edge_index, 3> e{input.edge(h), input.edge(input.next(h)), input.edge(input.prev(h))};
  const auto from = [&](const auto& squared_length) {
    return squared_four_areas(squared_length(e[0]), squared_length(e[1]), squared_length(e[2]));
  };
  if (metric.rational_lengths())
    return from([&](Edge_index edge) { return metric.rational_lengths()->squared[edge.idx()]; });
  return internal::rational(
    from([&](Edge_index edge) { return internal::squared_length_in_ring(metric, input, edge); }));
}

bool Input_metric::has_area(const Delta_complex& input, Face_index f) const
{
  const internal::Standard_arithmetic arithmetic;
  const Uncertain<Sign> sign = four_areas_double_double(input, f).sign();
  return is_certain(sign) ? get_certain(sign) != ZERO : squared_four_areas(*this, input, f) != 0;
}

void Input_metric::check(const Delta_complex& input) const
{
  internal::Defect_tally offenders;
  for (Edge_index e : input.edges())
    if (squared_length(*this, input, e) <= 0)
      offenders.add(e.idx());
  offenders.refuse(internal::Defect::ZERO_LENGTH_EDGE, "edge ", " does not have a positive length");
  for (Face_index f : input.faces())
    if (squared_four_areas(*this, input, f) < 0)
      offenders.add(f.idx());
  offenders.refuse(internal::Defect::TRIANGLE_INEQUALITY, "the lengths of face ", " violate the triangle inequality");
}

std::uint64_t Input_metric::hash() const
{
  std::uint64_t result = 0;
  const auto add = [&result](std::uint64_t bits) { result = internal::Random_bits(result ^ bits)(); };
  const auto add_number = [&add](double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    add(bits);
  };
  for (const auto& p : points_)
    for (int i = 0; i < 3; ++i)
      add_number(p[i]);
  for (double l : lengths_)
    add_number(l);
  const auto add_integer = [&add](mpz_srcptr n) {
    for (std::size_t i = 0; i < mpz_size(n); ++i)
      add(mpz_getlimbn(n, mp_size_t(i)));
  };
  if (rational_lengths_)
    for (const Rational& s : rational_lengths_->squared) {
      add_integer(mpq_numref(internal::data(s)));
      add_integer(mpq_denref(internal::data(s)));
    }
  return result;
}

double Input_metric::largest_size() const
{
  // The sizes of the doubles as integers, and of their common denominator.
  int above = 0, below = 0;
  const auto look_at = [&](double x) {
    if (x == 0)
      return;
    int exponent = 0;
    std::frexp(x, &exponent);
    above = (std::max)(above, exponent);
    below = (std::max)(below, 53 - exponent);
  };
  for (const auto& p : points_)
    for (int i = 0; i < 3; ++i)
      look_at(p[i]);
  for (double l : lengths_)
    look_at(l);
  double of_rationals = 0;
  if (rational_lengths_)
    for (const Rational& s : rational_lengths_->squared)
      of_rationals = (std::max)({of_rationals, double(mpz_sizeinbase(mpq_numref(internal::data(s)), 2)),
                                 double(mpz_sizeinbase(mpq_denref(internal::data(s)), 2))});
  // q = 4 s s' − (s + s' − s'')² has the denominators of three squared lengths, squared.
  return (std::max)(4. * (above + below) + 16, 12 * of_rationals + 16);
}

internal::Bounded_double_double Input_metric::squared_length_double_double(const Delta_complex& input,
                                                                           Edge_index e) const
{
  if (rational_lengths_)
    return internal::rounded(rational_lengths_->squared[e.idx()]);
  if (!lengths_.empty()) {
    const Double_double l(lengths_[e.idx()]);
    return l * l;
  }
  const Halfedge_index h = input.halfedge(e);
  const auto d = internal::difference<Double_double>(points_, input.source(h), input.target(h));
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2]; // GCC would call scalar_product()
}

internal::Bounded_double_double Input_metric::four_areas_double_double(const Delta_complex& input, Face_index f) const
{
  const Halfedge_index h = input.halfedge(f);
  if (rational_lengths_)
    return sqrt(internal::rounded(squared_four_areas(*this, input, f)));
  if (!lengths_.empty()) {
    // Kahan's order of operations; a difference of doubles is exact.
    std::array<double, 3> l{lengths_[input.edge(h).idx()], lengths_[input.edge(input.next(h)).idx()],
                            lengths_[input.edge(input.prev(h)).idx()]};
    std::sort(l.begin(), l.end());
    const Double_double c(l[0]), b(l[1]), a(l[2]), ab = Double_double::difference(l[2], l[1]);
    return sqrt((a + (b + c)) * (c - ab) * (c + ab) * (a + (b - c)));
  }
  const Vertex_index p = input.source(h);
  const auto u = internal::difference<Double_double>(points_, p, input.target(h)),
             v = internal::difference<Double_double>(points_, p, input.target(input.next(h)));
  const Double_double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2], z = u[0] * v[1] - u[1] * v[0];
  return sqrt(x * x + y * y + z * z).scaled(2);
}
} // namespace CGAL::Intrinsic_triangulations

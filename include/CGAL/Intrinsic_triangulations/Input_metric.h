// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The metric of the input triangulation, exactly as it was given.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Bounded_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Prime_field.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief the squared lengths of the input edges, as exact functions of the given
/// points with `double` coordinates, lengths, or rational squared lengths.
///
/// Coordinates and lengths are multiplied by a power of two, which is exact, if they are
/// so large or so small that products of squared lengths would over- or underflow.
class Input_metric
{
public:
  /// a rational number, exact
  using Rational = internal::Rational;
  /// the points of the vertices, three doubles each
  using Point_vector = internal::Points;

  /// constructs the metric of an empty surface.
  Input_metric() = default;

  /// constructs the metric of a surface in space, from the points of its vertices.
  /// \exception Invalid_surface_error if a coordinate is not finite
  static Input_metric from_points(Point_vector points)
  {
    const int exponent = internal::normalize_points(points);
    return from_normalized_points(std::move(points), exponent);
  }
  /// \brief as above, but ignores the positions of isolated vertices of `input`: in the unit that
  /// `Intrinsic_triangulation` chooses.
  /// \exception Invalid_surface_error if a coordinate is not finite
  static Input_metric from_points(const Delta_complex& input, Point_vector points)
  {
    const int exponent = internal::normalize_points(points, internal::Is_used_vertex{input});
    return from_normalized_points(std::move(points), exponent);
  }
  /// constructs the metric from the length of each edge.
  /// \exception Invalid_surface_error if a length is not positive and finite
  static Input_metric from_lengths(std::vector<double> lengths)
  {
    const int exponent = internal::normalize_lengths(lengths);
    return from_normalized_lengths(std::move(lengths), exponent);
  }
  /// constructs the metric from the exact squared length of each edge.
  static Input_metric from_squared_lengths(std::vector<Rational> squared_lengths)
  {
    Input_metric m;
    m.squared_lengths_ = std::move(squared_lengths);
    // The largest is below 2^largest, and at least a quarter of it, or no length is positive.
    long largest = (std::numeric_limits<long>::min)();
    std::size_t edge = 0;
    for (std::size_t e = 0; e < m.squared_lengths_.size(); ++e) {
      const auto* const s = internal::data(m.squared_lengths_[e]);
      const long size = long(mpz_sizeinbase(mpq_numref(s), 2)) - long(mpz_sizeinbase(mpq_denref(s), 2)) + 1;
      if (mpq_sgn(s) > 0 && size > largest) {
        largest = size;
        edge = e;
      }
    }
    if (largest == (std::numeric_limits<long>::min)())
      return m;
    using Limits = std::numeric_limits<double>;
    if (largest > 2 * Limits::max_exponent || largest < 2 * Limits::min_exponent)
      throw Invalid_surface_error(internal::Defect::OUT_OF_RANGE, edge, 1,
                                  "edge " + std::to_string(edge) +
                                    ": its length leaves the range of double; scale the squared lengths");
    m.exponent_ = internal::unit_exponent<double>(std::ldexp(1., int((largest - 1) / 2)));
    for (Rational& s : m.squared_lengths_)
      if (m.exponent_ > 0)
        mpq_div_2exp(s.backend().data(), s.backend().data(), 2 * mp_bitcnt_t(m.exponent_));
      else if (m.exponent_ < 0)
        mpq_mul_2exp(s.backend().data(), s.backend().data(), 2 * mp_bitcnt_t(-m.exponent_));
    return m;
  }

  /// checks exactly that lengths are positive and satisfy the triangle inequality.
  /// \exception Invalid_surface_error if not
  void check(const Delta_complex& input) const
  {
    internal::Offenders offenders;
    for (Edge_index e : input.edges())
      if (squared_length(input, e) <= 0)
        offenders.add(e.idx());
    if (offenders.count > 0)
      throw Invalid_surface_error(internal::Defect::ZERO_LENGTH_EDGE, offenders.first,
                                  offenders.count,
                                  "edge " + std::to_string(offenders.first) +
                                    " does not have a positive length" + offenders.and_more());
    for (Face_index f : input.faces())
      if (squared_four_areas(input, f) < 0)
        offenders.add(f.idx());
    if (offenders.count > 0)
      throw Invalid_surface_error(internal::Defect::TRIANGLE_INEQUALITY, offenders.first,
                                  offenders.count,
                                  "the lengths of face " + std::to_string(offenders.first) +
                                    " violate the triangle inequality" + offenders.and_more());
  }

  /// returns k such that one unit of this metric is `2^k` units of the input.
  int unit_exponent() const { return exponent_; }
  /// returns the points; empty unless the metric was constructed from points.
  const Point_vector& points() const { return points_; }

  /// returns the squared length of an input edge exactly.
  Rational squared_length(const Delta_complex& input, Edge_index e) const
  {
    if (!squared_lengths_.empty())
      return squared_lengths_[e.idx()];
    if (!lengths_.empty()) {
      const Rational l(lengths_[e.idx()]);
      return l * l;
    }
    const Halfedge_index h = input.halfedge(e);
    const auto &p = points_[input.source(h).idx()], &q = points_[input.target(h).idx()];
    Rational s(0);
    for (int i = 0; i < 3; ++i) {
      const Rational d = Rational(q[i]) - Rational(p[i]);
      s += d * d;
    }
    return s;
  }

  /// returns the square of four times the area of an input face exactly.
  Rational squared_four_areas(const Delta_complex& input, Face_index f) const
  {
    const Halfedge_index h = input.halfedge(f);
    return Intrinsic_triangulations::squared_four_areas(
      squared_length(input, input.edge(h)), squared_length(input, input.edge(input.next(h))),
      squared_length(input, input.edge(input.prev(h))));
  }

  /// \cond SKIP_IN_MANUAL
  static Input_metric from_normalized_points(Point_vector points,
                                             int exponent)
  {
    Input_metric m;
    m.exponent_ = exponent;
    m.points_ = std::move(points);
    return m;
  }
  static Input_metric from_normalized_lengths(std::vector<double> lengths, int exponent)
  {
    Input_metric m;
    m.exponent_ = exponent;
    m.lengths_ = std::move(lengths);
    return m;
  }

  // A number that looks random and depends on what was given, as far as it is needed for a seed.
  std::uint64_t hash() const
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
    for (const Rational& s : squared_lengths_) {
      add_integer(mpq_numref(internal::data(s)));
      add_integer(mpq_denref(internal::data(s)));
    }
    return result;
  }

  // A bound on the number of bits that numerators and denominators of squared lengths, and of the squares of four
  // times the areas, have.
  double largest_size() const
  {
    // Of the doubles as integers, and of their common denominator.
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
    for (const Rational& s : squared_lengths_)
      of_rationals = (std::max)({of_rationals, double(mpz_sizeinbase(mpq_numref(internal::data(s)), 2)),
                                 double(mpz_sizeinbase(mpq_denref(internal::data(s)), 2))});
    // q = 4 s s' − (s + s' − s'')² has the denominators of three squared lengths, squared.
    return (std::max)(4. * (above + below) + 16, 12 * of_rationals + 16);
  }

  using Double_double = internal::Bounded_double_double;

  Double_double squared_length_double_double(const Delta_complex& input, Edge_index e) const
  {
    if (!squared_lengths_.empty())
      return rounded(squared_lengths_[e.idx()]);
    if (!lengths_.empty()) {
      const Double_double l(lengths_[e.idx()]);
      return l * l;
    }
    const Halfedge_index h = input.halfedge(e);
    const auto d = difference(input.source(h), input.target(h));
    return d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
  }

  Double_double four_areas_double_double(const Delta_complex& input, Face_index f) const
  {
    const Halfedge_index h = input.halfedge(f);
    if (!squared_lengths_.empty())
      return sqrt(rounded(squared_four_areas(input, f)));
    if (!lengths_.empty()) {
      // Kahan's order of operations; a difference of doubles is exact.
      std::array<double, 3> l{lengths_[input.edge(h).idx()],
                              lengths_[input.edge(input.next(h)).idx()],
                              lengths_[input.edge(input.prev(h)).idx()]};
      std::sort(l.begin(), l.end());
      const Double_double c(l[0]), b(l[1]), a(l[2]), ab = Double_double::difference(l[2], l[1]);
      return sqrt((a + (b + c)) * (c - ab) * (c + ab) * (a + (b - c)));
    }
    const Vertex_index p = input.source(h);
    const auto u = difference(p, input.target(h)),
               v = difference(p, input.target(input.next(h)));
    const Double_double x = u[1] * v[2] - u[2] * v[1], y = u[2] * v[0] - u[0] * v[2],
                        z = u[0] * v[1] - u[1] * v[0];
    return sqrt(x * x + y * y + z * z).scaled(2);
  }
  /// \endcond

private:
  std::array<Double_double, 3> difference(Vertex_index from, Vertex_index to) const
  {
    const auto &p = points_[from.idx()], &q = points_[to.idx()];
    return {Double_double::difference(q[0], p[0]), Double_double::difference(q[1], p[1]),
            Double_double::difference(q[2], p[2])};
  }

  static Double_double rounded(const Rational& x)
  {
    const double hi = x.convert_to<double>();
    const Rational rest = x - Rational(hi);
    const double lo = rest.convert_to<double>();
    const Rational error = rest - Rational(lo);
    return {hi, lo, error == 0 ? 0 : std::abs(lo) * 0x1p-50 + 1e-300};
  }

  int exponent_ = 0;
  Point_vector points_;
  std::vector<double> lengths_;
  std::vector<Rational> squared_lengths_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_H

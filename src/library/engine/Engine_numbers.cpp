// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Engine_numbers.

#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include "Exact_engine_memory.h"
#include "Side_and_corner.h"
#include "layout/Unfolding.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include "decide/Exact_fallback.h"
#include "layout/Metric_frame.h"
#include "layout/Two_straight_faces.h"
#include "layout/Vertex_positions.h"
#include "decide/corner_signs.h"
#include "layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether double-doubles determine the sum of two cotangents with its sign, or an area.
inline bool is_good_weight(const Bounded_double_double& weight)
{
  return is_certain(weight.sign()) && weight.error() < 0x1p-52 * (1 + std::abs(weight.hi()));
}
inline bool is_good_area(const Bounded_double_double& a) { return a.is_zero() || a.relative_error() < 0x1p-54; }

// The precision of an interval around a number that is needed to the last places.
inline bool is_narrow(double width, double magnitude) { return width <= 0x1p-51 * magnitude; }

// Vectors computed by evaluate(metric), each with an error of at most 2^-50 of its length, or of the last one's length
// if that is longer.
template <std::size_t N, class Evaluate>
std::array<std::complex<double>, N> Engine_numbers::rounded_vectors(Input_surface& surface, const Evaluate& evaluate)
{
  constexpr long largest_precision = 1 << 14; // more is not needed unless a ratio of lengths leaves the range of double
  std::array<std::complex<double>, N> result;
  std::array<double, N> width{};
  const auto is_good = [&] {
    bool are_narrow = true;
    for (std::size_t i = 0; i < N; ++i)
      are_narrow = are_narrow && is_narrow(width[i], (std::max)(std::abs(result[i]), std::abs(result.back())));
    return are_narrow;
  };
  Double_double_metric double_doubles(surface);
  const auto vectors = evaluate(double_doubles);
  for (std::size_t i = 0; i < N; ++i) {
    result[i] = {vectors[i].x().hi(), vectors[i].y().hi()};
    width[i] = vectors[i].x().error();
  }
  for (long precision = 256; !is_good() && precision <= largest_precision; precision = doubled(precision)) {
    Mpfr_metric& metric = surface.mpfr_metric(precision);
    const auto precise_vectors = evaluate(metric);
    width = {};
    const auto middle = [](const Mpfr_interval& x, double& largest_width) {
      const double low = x.lower_double(), high = x.upper_double();
      largest_width = (std::max)(largest_width, high - low);
      return low + (high - low) / 2;
    };
    for (std::size_t i = 0; i < N; ++i)
      result[i] = {middle(precise_vectors[i].x(), width[i]), middle(precise_vectors[i].y(), width[i])};
  }
  return result;
}

Engine_numbers::Edge_beginning Engine_numbers::edge_beginning(Halfedge_index h) const
{
  const Standard_arithmetic arithmetic;
  engine_.prepare();
  Halfedge_index reference;
  const auto vectors = rounded_vectors<2>(*engine_.input_surface(), [&](auto& metric) {
    auto begin = Unfolding<std::decay_t<decltype(metric)>>(complex_, correspondence_, metric).edge_beginning(h);
    reference = begin.reference;
    return std::array{begin.source, begin.vector};
  });
  return {vectors[0], vectors[1], reference};
}

double Engine_numbers::input_angle(Halfedge_index h) const
{
  const Standard_arithmetic arithmetic;
  const auto side = rounded_vectors<1>(*engine_.input_surface(), [&](auto& metric) {
    return std::array{
      Metric_frame<std::decay_t<decltype(metric)>>(correspondence_.input(), metric).ratios(h).at_source};
  });
  return std::atan2((std::max)(side[0].imag(), 0.), side[0].real());
}

double Engine_numbers::length(Edge_index e) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine_.surface_for_query();
  const std::optional<double> l = rounded(sqrt(engine_.squared_length(e, *surface)));
  return std::ldexp(l ? *l : engine_.exact_fallback(*surface).length(e), metric_.unit_exponent());
}

Exact_engine::Corner Engine_numbers::corner(Halfedge_index h) const
{
  const Standard_arithmetic arithmetic;
  return engine_.corner(h, *engine_.prepared_surface());
}

double Engine_numbers::cotangent(Halfedge_index h) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine_.prepared_surface();
  return cotangent(h, engine_.corner(h, *surface), *surface);
}

double Engine_numbers::cotangent(Halfedge_index h, const Corner& corner, Input_surface& surface) const
{
  const double p = corner.p.hi(), four_areas = corner.four_areas.hi();
  if (corner.four_areas.relative_error() < 0x1p-60 && corner.p.error() < 0x1p-60 * (std::abs(p) + four_areas))
    return p / four_areas;
  return engine_.exact_fallback(surface).cotangent(
    h, [](double width, double magnitude) { return width <= 0x1p-51 * (1 + magnitude); });
}

// As cotangent(), with the right sign, and zero only for a right angle.
double Engine_numbers::signed_cotangent(Halfedge_index h, Input_surface& surface) const
{
  const Corner c = engine_.corner(h, surface);
  const Sign sign =
    is_certain(c.p.sign()) ? get_certain(c.p.sign()) : engine_.exact_fallback(surface).sign_of_scalar_product(h);
  if (sign == ZERO)
    return 0;
  const double value = cotangent(h, c, surface);
  return CGAL::sign(value) == sign ? value : engine_.exact_fallback(surface).cotangent(h, is_narrow);
}

double Engine_numbers::angle(Halfedge_index h) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine_.prepared_surface();
  const Corner c = engine_.corner(h, *surface);
  if (c.four_areas.relative_error() < 0x1p-60 && c.p.error() < 0x1p-60 * (std::abs(c.p.hi()) + c.four_areas.hi()))
    return std::atan2(std::abs(c.four_areas.hi()), c.p.hi()); // without the sign of a zero
  Exact_fallback fallback = engine_.exact_fallback(*surface);
  if (engine_.sign_of_area(complex_.face(h), *surface) == ZERO)
    return fallback.sign_of_scalar_product(h) == NEGATIVE ? CGAL_PI : 0;
  const long scale = fallback.scale_of_corner(h);
  const double four_areas = fallback.number_of_corner(
    h, [&](const auto& corner) { return ldexp(corner.four_areas, scale); }, is_narrow);
  const double p = fallback.number_of_corner(
    h, [&](const auto& corner) { return ldexp(corner.p, scale); },
    [&](double width, double magnitude) { return is_narrow(width, (std::max)(magnitude, four_areas)); });
  return std::atan2(four_areas, p);
}

double Engine_numbers::cotangent_weight(Edge_index e) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine_.prepared_surface();
  const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
  if (complex_.is_border(h) || complex_.is_border(g))
    return signed_cotangent(complex_.is_border(h) ? g : h, *surface);
  const Corner k = engine_.corner(h, *surface), l = engine_.corner(g, *surface);
  const Bounded_double_double weight = k.p / k.four_areas + l.p / l.four_areas;
  if (is_good_weight(weight))
    return rounded(weight).value_or(weight.hi());
  if (const auto by_diagonal = engine_.weight_by_other_diagonal(h, {k, l}); by_diagonal && is_good_weight(*by_diagonal))
    return by_diagonal->hi();
  const double sum = cotangent(h, k, *surface) + cotangent(g, l, *surface);
  // Two angles of one triangle sum to less than π.
  const Sign exact_sign = complex_.is_self_glued(e) ? POSITIVE : engine_.test(e, *surface).sign;
  if (exact_sign == ZERO)
    return 0;
  return CGAL::sign(sum) == exact_sign
           ? sum
           : engine_.exact_fallback(*surface).sum_of_cotangents(corners_beside(complex_, e));
}

double Engine_numbers::area(Face_index f) const
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine_.prepared_surface();
  const Halfedge_index h = complex_.halfedge(f);
  const Bounded_double_double a = engine_.corner(h, *surface).four_areas;
  if (is_good_area(a))
    return area_in_input_unit(rounded(a).value_or(a.hi()) / 4, metric_.unit_exponent(), f);
  if (engine_.sign_of_area(f, *surface) == ZERO)
    return 0;
  // In the unit of the input, since in that of the numbers it may be subnormal.
  const int unit = metric_.unit_exponent();
  const double value = engine_.exact_fallback(*surface).number_of_corner(
    h, [&](const auto& corner) { return ldexp(corner.four_areas, 2 * long(unit) - 2); }, is_narrow);
  return unit < 0 ? area_in_input_unit(std::ldexp(value, -2 * unit), unit, f) : value;
}

bool Engine_numbers::is_known_to_be_straight(Face_index f) const
{
  engine_.find_straight_faces();
  return engine_.is_straight(f);
}

Rounded_numbers::Rounded_numbers(const Delta_complex& complex)
  : lengths(complex.number_of_edges(), std::numeric_limits<double>::quiet_NaN()),
    areas(complex.number_of_faces(), std::numeric_limits<double>::quiet_NaN()),
    cotangents(complex.number_of_halfedges(), default_init)
{}

double Rounded_numbers::cotangent_weight(const Delta_complex& complex, Edge_index e) const
{
  const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
  const auto cotangent = [&](Halfedge_index side) {
    const auto& [hi, lo, error] = cotangents[side.idx()];
    return Bounded_double_double(hi, lo, error);
  };
  const Bounded_double_double weight = cotangent(h) + cotangent(g);
  return rounded(weight).value_or(std::numeric_limits<double>::quiet_NaN());
}

double Rounded_numbers::angle(Halfedge_index h, double relative_error) const
{
  const auto& [hi, lo, error] = cotangents[h.idx()];
  return error < relative_error * 0x1p-11 * (1 + std::abs(hi)) ? std::atan2(1., hi)
                                                               : std::numeric_limits<double>::quiet_NaN();
}

void Engine_numbers::find_cotangents(Face_index f, Face_cotangents& result) const
{
  const Standard_arithmetic arithmetic;
  engine_.memory_->may_repeat_flips(complex_, metric_, [&] { engine_.prepare(); });
  const Surface_lease surface = engine_.prepared_surface();
  Double_double_metric metric(*surface);
  metric.interruption().check();
  quickest_corner(f, Unfolding<Double_double_metric>(complex_, correspondence_, metric))
    .get_cotangents(complex_, f, result);
}

// Flips need not be repeated to find straight faces.
std::optional<Engine_numbers::Side_and_corner<Double_with_bound>> Engine_numbers::rounded_corner(Face_index f) const
{
  const Standard_arithmetic arithmetic;
  if (const auto c = engine_.memory_->corner_by_flips(
        complex_, metric_, [&] { engine_.prepare(); }, f, 0x1p-40)) {
    const auto rounded = [](const Bounded_double_double& x) { return Double_with_bound(x); };
    return Side_and_corner<Double_with_bound>{
      complex_.halfedge(f),
      {rounded(c->p), rounded(c->four_areas), rounded(c->s_first), rounded(c->s_second), rounded(c->s_opposite)}};
  }
  engine_.prepare();
  engine_.decisions().interruption.check();
  Double_metric metric(correspondence_.input(), metric_, engine_.decisions().interruption);
  const Unfolding<Double_metric> unfolding(complex_, correspondence_, metric);
  const Halfedge_index side = correspondence_.coordinates().side_with_most_crossings(complex_, f);
  if (engine_.number_of_quantities(side) > Exact_engine::short_strip)
    return std::nullopt;
  return Side_and_corner<Double_with_bound>{side, unfolding.opposite_corner(side)};
}

void Engine_numbers::find_cotangents(Face_index f, Rounded_face_cotangents& result) const
{
  if (const auto c = rounded_corner(f))
    c->get_cotangents(complex_, f, result);
  else
    result.fill({0, std::numeric_limits<double>::infinity()});
}

Double_with_bound Engine_numbers::rounded_four_areas(Face_index f) const
{
  const auto c = rounded_corner(f);
  return c ? c->corner.four_areas : Double_with_bound(0, std::numeric_limits<double>::infinity());
}

void Engine_numbers::find_numbers(const std::size_t first, const std::size_t last, Rounded_numbers& numbers) const
{
  using Real = Bounded_double_double;
  engine_.memory_->may_repeat_flips(complex_, metric_, [&] { engine_.prepare(); });
  const Surface_lease surface = engine_.prepared_surface();
  Double_double_metric metric(*surface);
  const Unfolding<Double_double_metric> unfolding(complex_, correspondence_, metric);
  const auto note_length = [&](Halfedge_index h, const auto& length) {
    const Edge_index e = complex_.edge(h);
    if (h != complex_.halfedge(e) && !complex_.is_border(complex_.halfedge(e)))
      return;
    if (const std::optional<double> l = rounded(length()))
      numbers.lengths[e.idx()] = std::ldexp(*l, metric_.unit_exponent());
  };
  const auto note_cotangents = [&](Halfedge_index side, const std::array<Real, 3>& cotangents) {
    for (const Real& c : cotangents) {
      numbers.cotangents[side.idx()] = {c.hi(), c.lo(), c.error()};
      side = complex_.next(side);
    }
  };
  const auto find = [&](Face_index f) {
    const Side_and_corner<Real> at = quickest_corner(f, unfolding);
    const Corner& c = at.corner;
    note_length(at.side, [&] { return sqrt(c.s_opposite); });
    note_length(complex_.next(at.side), [&] { return sqrt(c.s_second); });
    note_length(complex_.prev(at.side), [&] { return sqrt(c.s_first); });
    note_cotangents(at.side, at.cotangents());
    if (const std::optional<double> four_areas = rounded(c.four_areas); four_areas && *four_areas >= 0)
      numbers.areas[f.idx()] = *four_areas / 4;
  };

  // Straight faces, two at a time.
  std::array<Face_index, 2> straight;
  std::size_t number_of_straight = 0;
  const auto find_straight = [&] {
    const auto corners = [&](Face_index f) {
      const Halfedge_index ij = complex_.halfedge(f);
      return Three_corners{complex_.source(ij), complex_.target(ij), complex_.target(complex_.next(ij))};
    };
    const Two_straight_faces two(metric_.points(), corners(straight[0]), corners(straight[number_of_straight - 1]));
    Two_straight_faces::Numbers known;
    for (std::size_t i = 0; i < number_of_straight; ++i) {
      const Face_index f = straight[i];
      const bool is_known = two.get(i == 1, known);
      const std::optional<double> twice_area = rounded(known.twice_area);
      if (!is_known || !twice_area) {
        find(f);
        continue;
      }
      Halfedge_index side = complex_.halfedge(f);
      for (std::size_t c = 0; c < 3; ++c, side = complex_.next(side))
        note_length(side, [&] { return known.lengths[c]; });
      note_cotangents(side, known.cotangents); // the first one again
      numbers.areas[f.idx()] = *twice_area / 2;
    }
    number_of_straight = 0;
  };
  const Vertex_positions all = engine_.positions();
  for (std::size_t i = first; i < last; ++i) {
    if (i % 1024 == 0)
      engine_.decisions().interruption.check();
    const Face_index f(static_cast<Face_index::size_type>(i));
    if (!engine_.is_straight(f) || all.has_inserted_corner(complex_, complex_.halfedge(f))) {
      find(f);
      continue;
    }
    straight[number_of_straight++] = f;
    if (number_of_straight == 2)
      find_straight();
  }
  if (number_of_straight != 0)
    find_straight();
}

} // namespace CGAL::Intrinsic_triangulations::internal

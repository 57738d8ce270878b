// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From a triangulation to the simplified surface, with the lengths that define it.

#include "Simplifier.h"

#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include "../engine/decide/Exact_fallback.h"
#include "../engine/layout/metric_images.h"

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;

// The exact squared lengths of edges, in the unit of the input.
class Squared_lengths
{
public:
  explicit Squared_lengths(const Exact_engine& engine)
    : engine_(engine), complex_(engine.connectivity()), correspondence_(engine.correspondence())
  {}

  bool is_rational(Edge_index e) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    return correspondence_.coordinates().crossings(e) < 0 && !correspondence_.is_inserted(complex_.source(h)) &&
           !correspondence_.is_inserted(complex_.target(h));
  }

  // The exact squared length if `is_rational(e)`, otherwise one with a relative error below 2^-bits.
  Rational operator()(Edge_index e, long bits) const
  {
    Rational result;
    if (is_rational(e))
      result = squared_length(engine_.metric(), correspondence_.input(),
                              correspondence_.input().edge(correspondence_.input_halfedge(complex_.halfedge(e))));
    else
      mpfr_get_q(result.backend().data(), interval(e, bits).lower());
    const int exponent = 2 * engine_.metric().unit_exponent();
    const Rational unit(Integer(1) << unsigned(std::abs(exponent)));
    return exponent > 0 ? result * unit : result / unit;
  }

private:
  Mpfr_interval interval(Edge_index e, long bits) const
  {
    const Surface_lease surface = engine_.input_surface();
    Exact_fallback exact(complex_, correspondence_, *surface);
    for (long precision = bits + 64;; precision = doubled(precision)) {
      Mpfr_interval s = exact.squared_length(e, precision);
      const Mpfr_interval relative_width = s.width() / s;
      if (relative_width.upper_double() < std::ldexp(1., int(-bits)))
        return s;
    }
  }

  const Exact_engine& engine_;
  const Delta_complex& complex_;
  const Correspondence& correspondence_;
};

// The bits of squared lengths with which a face differs from the exact one by less than 2^-60 of all lengths. If η is
// the relative error, s the longest squared side and a four times the area, eigenvalues of M are below 18 η s² / a²,
// and s / a is at most 1 over the sine of the smallest angle.
long bits_for(const Engine_numbers& numbers, const Delta_complex& complex, Face_index f)
{
  const Halfedge_index h = complex.halfedge(f);
  const double angle = (std::min)({numbers.angle(h), numbers.angle(complex.next(h)), numbers.angle(complex.prev(h))});
  if (!(angle > 0x1p-400))
    throw Invalid_surface_error(Invalid_surface_error::Defect::DEGENERATE_FACE, f.idx(), 1,
                                "face " + std::to_string(f.idx()) +
                                  " of the Delaunay triangulation has no area, and sides that are not edges of the "
                                  "input: repair the surface first");
  return 80 - 2 * std::ilogb(angle);
}

// The thin faces keep their exact sides, so all lengths are given by their squares.
Triangulation with_thin_faces(const Exact_engine& engine, Simplification& s)
{
  const Delta_complex &fine = engine.connectivity(), &coarse = s.map.coarse();
  const Engine_numbers numbers(engine);
  const Squared_lengths squared_lengths(engine);
  std::map<Edge_index, std::pair<Edge_index, long>> sides; // of thin faces, the descriptor before, and the bits
  for (const auto& [f, before] : s.thin_faces) {
    Halfedge_index h = coarse.halfedge(f), g = fine.halfedge(before);
    const bool is_rational = squared_lengths.is_rational(fine.edge(g)) &&
                             squared_lengths.is_rational(fine.edge(fine.next(g))) &&
                             squared_lengths.is_rational(fine.edge(fine.prev(g)));
    const long bits = is_rational ? 0 : bits_for(numbers, fine, before);
    if (!is_rational)
      s.changes[f.idx()] = {std::nextafter(1., 0.), std::nextafter(1., 2.)};
    for (int i = 0; i < 3; ++i, h = coarse.next(h), g = fine.next(g)) {
      std::pair<Edge_index, long>& side = sides[coarse.edge(h)];
      side = {fine.edge(g), (std::max)(side.second, bits)};
    }
  }
  std::vector<Rational> squares;
  for (double l : s.lengths)
    squares.push_back(Rational(l) * Rational(l));
  for (const auto& [e, side] : sides)
    squares[e.idx()] = squared_lengths(side.first, side.second);
  return Triangulation::from_metric(coarse, metric_from_squared_lengths(std::move(squares)));
}

// The changes of all components, each given by the face with the smallest number.
std::vector<std::pair<Face_index, Metric_change>> changes_by_component(const Delta_complex& complex,
                                                                       const std::vector<Metric_change>& changes)
{
  const std::vector<std::size_t> number_of = numbers_of_components(complex);
  std::vector<std::pair<Face_index, Metric_change>> result;
  for (Face_index f : complex.faces()) {
    const std::size_t n = number_of[f.idx()];
    if (n == result.size())
      result.emplace_back(f, changes[f.idx()]);
    Metric_change& change = result[n].second;
    change.shrink = (std::min)(change.shrink, changes[f.idx()].shrink);
    change.stretch = (std::max)(change.stretch, changes[f.idx()].stretch);
  }
  return result;
}

std::vector<Surface_point> places_of_vertices(const Simplification_map& map)
{
  const Delta_complex& fine = map.fine();
  std::vector<Surface_point> points, result(fine.number_of_vertices());
  for (Vertex_index v : fine.vertices())
    if (fine.halfedge(v).is_valid())
      points.push_back({fine.opposite(fine.halfedge(v)), {1, 0, 0}});
  points = map.to_coarse(points);
  std::size_t i = 0;
  for (Vertex_index v : fine.vertices())
    if (fine.halfedge(v).is_valid())
      result[v.idx()] = points[i++];
  return result;
}

} // namespace

std::vector<std::size_t> numbers_of_components(const Delta_complex& complex)
{
  Disjoint_sets sets(complex.number_of_faces());
  for (Edge_index e : complex.edges())
    if (!complex.is_border(e))
      sets.unite(complex.face(complex.halfedge(e)).idx(), complex.face(complex.opposite(complex.halfedge(e))).idx());
  std::vector<std::size_t> result;
  sets.number(result);
  return result;
}

namespace {

std::vector<bool> sharp_edges_of_input(const Exact_engine& engine, double degrees)
{
  std::vector<bool> result(engine.connectivity().number_of_edges());
  if (!(degrees >= 0 && degrees <= 180))
    throw Invalid_argument_error("the angle of sharp edges has to be between 0 and 180 degrees");
  if (degrees == 180)
    return result;
  const auto& points = engine.metric().points();
  if (points.empty())
    throw Invalid_argument_error("only a surface in space has sharp edges, but this one has only edge lengths");
  const Delta_complex &input = engine.correspondence().input(), &complex = engine.connectivity();
  const std::vector<bool> is_sharp =
    sharp_edges(input, std::vector<std::array<double, 3>>(points.begin(), points.end()), degrees);
  for (Edge_index e : complex.edges())
    result[e.idx()] = crossings(engine.correspondence(), e) < 0 &&
                      is_sharp[input.edge(input_halfedge(engine.correspondence(), complex.halfedge(e))).idx()];
  return result;
}

} // namespace

Simplification_options simplification_options(const Exact_engine& engine, std::optional<double> maximum_change,
                                              std::size_t number_of_vertices, double sharp_angle,
                                              Progress_function progress)
{
  const double change =
    maximum_change.value_or(number_of_vertices == 0 ? 0.05 : std::numeric_limits<double>::infinity());
  if (!(change >= 0))
    throw Invalid_argument_error("the maximum change of a simplification has to be a number that is not negative");
  return {change, number_of_vertices, std::vector<bool>(engine.connectivity().number_of_vertices()),
          sharp_edges_of_input(engine, sharp_angle), std::move(progress)};
}

Simplified_surface simplify(const Exact_engine& engine, const Simplification_options& options)
{
  const Standard_arithmetic arithmetic;
  arithmetic.check();
  std::vector<double> lengths;
  for (Edge_index e : engine.connectivity().edges())
    lengths.push_back(Engine_numbers(engine).length(e));
  Simplification s = simplify(engine.connectivity(), std::move(lengths), options);
  Triangulation coarse = s.thin_faces.empty() ? Triangulation::from_lengths(s.map.coarse(), std::move(s.lengths))
                                              : with_thin_faces(engine, s);
  Simplified_surface result{
    std::move(coarse),           std::move(s.kept), places_of_vertices(s.map), 1, 1, std::move(s.changes), {},
    std::move(s.is_constrained), s.reasons,         std::move(s.map)};
  result.changes_of_components = changes_by_component(result.map.coarse(), result.changes_in_faces);
  for (const auto& [face, change] : result.changes_of_components) {
    result.shrink = (std::min)(result.shrink, change.shrink);
    result.stretch = (std::max)(result.stretch, change.stretch);
  }
  flip_to_Delaunay(result.triangulation,
                   parameters::edge_is_constrained_map(boost::make_function_property_map<Edge_index, bool>(
                     [&](Edge_index e) { return bool(result.is_constrained[e.idx()]); })));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

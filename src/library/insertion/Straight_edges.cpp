// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Straight_edges.

#include <CGAL/Intrinsic_triangulations/internal/insertion/Straight_edges.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

void Straight_edges::measure(Edge_index e)
{
  const Delta_complex& complex = engine_.connectivity();
  const Correspondence& correspondence = engine_.correspondence();
  const Input_metric::Point_vector& input_points = engine_.metric().points();
  while (points_.size() < complex.number_of_vertices()) {
    const Vertex_index v(std::uint32_t(points_.size()));
    points_.push_back(correspondence.is_inserted(v)
                        ? point_in_space(correspondence.input(), input_points, correspondence.location(v))
                        : Point{input_points[v.idx()][0], input_points[v.idx()][1], input_points[v.idx()][2]});
  }
  if (deviations_.size() < complex.number_of_edges())
    deviations_.resize(complex.number_of_edges());
  deviations_[e.idx()] = correspondence.coordinates().crossings(e) > 0 ? deviation(complex.halfedge(e)) : 0;
}

// The input triangles along h are laid out in a plane: a crossing divides the input edge there in the ratio of the
// distances of its ends from h.
double Straight_edges::deviation(Halfedge_index h)
{
  const Delta_complex& complex = engine_.connectivity();
  const Delta_complex& input = engine_.correspondence().input();
  const auto input_point = [&](Halfedge_index g) { return engine_.metric().points()[input.source(g).idx()]; };
  const Point &p = points_[complex.source(h).idx()], &q = points_[complex.target(h).idx()];
  const auto [source, vector, reference] = Engine_numbers(engine_).edge_beginning(h);
  const Crossed_halfedges crossed(complex, engine_.correspondence(), h, engine_.decisions().interruption);
  std::array<Halfedge_index, 3> sides = {reference, input.next(reference), input.prev(reference)};
  std::array<Plane_point, 3> corners = {0., 1., shapes_.apex(reference)}; // their sources
  double result = 0;
  for (std::size_t i = 0; i < crossed.size(); ++i) {
    const Halfedge_index beyond = crossed[i], g = input.opposite(beyond);
    const std::size_t s = std::size_t(std::find(sides.begin(), sides.end(), g) - sides.begin());
    if (s == 3) // rounding has put the beginning into another face
      return result;
    const Plane_point a = corners[s], b = corners[(s + 1) % 3];
    const double left = cross_product(vector, a - source), right = cross_product(vector, b - source);
    const double u = (std::min)(1., (std::max)(0., left / (left - right)));
    const Plane_point along = (a + u * (b - a) - source) * std::conj(vector);
    const double t = (std::min)(1., (std::max)(0., along.real() / std::norm(vector)));
    const auto &from = input_point(g), &to = input_point(beyond);
    Point away{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      away[axis] = (1 - u) * from[axis] + u * to[axis] - ((1 - t) * p[axis] + t * q[axis]);
    const double distance = std::hypot(away[0], away[1], away[2]);
    if (distance > result) // no comparison holds beside a face of zero area
      result = distance;
    sides = {beyond, input.next(beyond), input.prev(beyond)};
    corners = {b, a, b + (a - b) * shapes_.apex(beyond)};
  }
  return result;
}

// The rest is for vertices that are merged later.
static constexpr double part_for_curves = 0.8;

// Whether another edge has the same ends, or they are one. Looks at the edges around both ends in turn, so that an end
// of many edges does not matter.
static bool has_parallel(const Delta_complex& complex, Halfedge_index h)
{
  const Halfedge_index g = complex.opposite(h);
  const Vertex_index v = complex.source(h), w = complex.source(g);
  for (Halfedge_index from_v = h, from_w = g; v != w;) {
    from_v = complex.next_around_source(from_v);
    from_w = complex.next_around_source(from_w);
    if (from_v == h || from_w == g)
      return false;
    if (complex.target(from_v) == w || complex.target(from_w) == v)
      break;
  }
  return true;
}

bool Straight_edges::deviates(Face_index f, double maximum_deviation, bool is_thin) const
{
  const Delta_complex& complex = engine_.connectivity();
  const double most = std::ldexp(maximum_deviation, -engine_.metric().unit_exponent());
  std::array<Point, 3> corners;
  double longest = 0;
  Halfedge_index h = complex.halfedge(f);
  for (std::size_t i = 0; i < 3; ++i, h = complex.next(h)) {
    if (deviations_[complex.edge(h).idx()] > part_for_curves * most)
      return true;
    corners[i] = points_[complex.source(h).idx()];
  }
  const auto length = [&](std::size_t i) {
    const Point &p = corners[i % 3], &q = corners[(i + 1) % 3];
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
  };
  std::array<double, 3> sides{};
  for (std::size_t i = 0; i < 3; ++i)
    longest = (std::max)(longest, sides[i] = length(i));
  if (2 * longest > most) // straight edges with the same ends would coincide
    for (int i = 0; i < 3; ++i, h = complex.next(h))
      if (has_parallel(complex, h))
        return true;
  if (is_thin || longest <= most)
    return false;
  std::sort(sides.begin(), sides.end());
  // The cosine of the smallest angle, opposite to the shortest side.
  const double cosine = (sides[1] / sides[2] + sides[2] / sides[1] - sides[0] / sides[1] * (sides[0] / sides[2])) / 2;
  return !(cosine < std::cos(CGAL_PI / 12));
}

} // namespace CGAL::Intrinsic_triangulations::internal

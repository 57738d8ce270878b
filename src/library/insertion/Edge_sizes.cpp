// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Edge_sizes.

#include <CGAL/Intrinsic_triangulations/internal/insertion/Edge_sizes.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include "../measures/Face_directions.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Along an edge of that length the normal turns by the angle, if the surface is bent between the middles of the faces
// beside each edge. Edges that are kept or sharper say nothing about that.
void add_sizes_by_normals(const Exact_engine& engine, const Wanted_sizes& wanted, const std::vector<bool>& is_kept,
                          std::vector<double>& sizes)
{
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex &input = correspondence.input(), &complex = engine.connectivity();
  std::vector<bool> is_left_out(input.number_of_edges());
  for (Edge_index e : complex.edges())
    if (is_kept[e.idx()] && correspondence.coordinates().is_original(e))
      is_left_out[input.edge(correspondence.input_halfedge(complex.halfedge(e))).idx()] = true;
  const auto& metric = engine.metric();
  const Face_directions::Points points(metric.points().begin(), metric.points().end());
  Face_directions directions(input, points, 4 * coordinate_spacing(points));
  const double smallest = std::ldexp(extent(engine), -12);
  for (Edge_index e : input.edges()) {
    if (input.is_border(e) || is_left_out[e.idx()])
      continue;
    const Halfedge_index h = input.halfedge(e), g = input.opposite(h);
    const auto &m = directions(input.face(h)), &n = directions(input.face(g));
    const double turn = 2 * std::asin((std::min)(1., std::hypot(m[0] - n[0], m[1] - n[1], m[2] - n[2]) / 2));
    const double degrees = turn * 180 / CGAL_PI;
    if (degrees > wanted.sharp_edge_angle)
      continue;
    const double width = (std::max)(directions.height_over(h), directions.height_over(g));
    const double size =
      (std::max)(std::ldexp(width, metric.unit_exponent()) * *wanted.normal_angle / degrees, smallest);
    for (Vertex_index v : {input.source(h), input.source(g)})
      if (size < sizes[v.idx()])
        sizes[v.idx()] = size;
  }
}

// Dijkstra's algorithm.
void bound_gradation(const Exact_engine& engine, double gradation, std::vector<double>& sizes)
{
  const Delta_complex& input = engine.correspondence().input();
  Input_shapes shapes(engine);
  using Entry = std::pair<double, Vertex_index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Vertex_index v : input.vertices())
    if (sizes[v.idx()] < infinity && input.halfedge(v).is_valid())
      queue.emplace(sizes[v.idx()], v);
  while (!queue.empty()) {
    const auto [size, v] = queue.top();
    queue.pop();
    if (size > sizes[v.idx()])
      continue;
    for (Halfedge_index h : Halfedges_around(input, v)) {
      double& other = sizes[input.source(h).idx()];
      const double bound = size + gradation * std::ldexp(shapes.length(input.edge(h)), engine.metric().unit_exponent());
      if (bound < other)
        queue.emplace(other = bound, input.source(h));
    }
  }
}

// The integral of 1/h² over a triangle of area 1 where h is linear.
double mean_of_inverse_square(double a, double b, double c)
{
  const auto [low, high] = std::minmax({a, b, c});
  if (high <= 1.5 * low) {
    const double h = (a + b + c) / 3;
    return 1 / (h * h);
  }
  // The side along which it changes most is divided.
  if (std::abs(a - b) < std::abs(b - c) || std::abs(a - b) < std::abs(c - a))
    return mean_of_inverse_square(b, c, a);
  const double middle = (a + b) / 2;
  return (mean_of_inverse_square(a, middle, c) + mean_of_inverse_square(middle, b, c)) / 2;
}

} // namespace

std::vector<double> sizes_of_input(const Exact_engine& engine, Wanted_sizes wanted, const std::vector<bool>& is_kept)
{
  if (!(wanted.gradation > 0 && wanted.gradation < infinity))
    throw Invalid_argument_error("the gradation of sizes has to be positive and finite");
  if (wanted.normal_angle && !(*wanted.normal_angle > 0))
    throw Invalid_argument_error("the largest angle between normals has to be positive");
  if (wanted.normal_angle && engine.metric().points().empty())
    throw Invalid_argument_error("sizes by normals need a surface in space, but this one has only edge lengths");
  for (std::size_t v = 0; v < wanted.given.size(); ++v)
    if (!(wanted.given[v] > 0))
      throw Invalid_argument_error("the size at vertex " + std::to_string(v) + " is not positive");
  std::vector<double> result = std::move(wanted.given);
  if (wanted.normal_angle) {
    result.resize(engine.correspondence().input().number_of_vertices(), infinity);
    add_sizes_by_normals(engine, wanted, is_kept, result);
  }
  const auto is_finite = [](double size) { return size < infinity; };
  if (std::none_of(result.begin(), result.end(), is_finite))
    return {};
  bound_gradation(engine, wanted.gradation, result);
  return result;
}

void Edge_sizes::add_vertices()
{
  const Delta_complex& input = engine_.correspondence().input();
  while (!sizes_.empty() && sizes_.size() < engine_.connectivity().number_of_vertices()) {
    const Surface_point& point = engine_.correspondence().location(Vertex_index(std::uint32_t(sizes_.size())));
    Halfedge_index h = point.halfedge;
    double sum = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i, h = input.next(h))
      if (const double w = point.coordinates[i]; w > 0) { // since a size may be infinite
        sum += w;
        size += w * sizes_[input.source(h).idx()];
      }
    sizes_.push_back(size / sum);
  }
}

double Edge_sizes::number_of_vertices(const std::array<Vertex_index, 3>& corners, double area) const
{
  return number_of_vertices(area, 1) * mean_of_inverse_square(at(corners[0]), at(corners[1]), at(corners[2]));
}

} // namespace CGAL::Intrinsic_triangulations::internal

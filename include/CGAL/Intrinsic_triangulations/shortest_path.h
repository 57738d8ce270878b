// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest paths over the surface, and their lengths.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `shortest_path()`.
struct Shortest_path
{
  std::vector<Halfedge_index> halfedges; ///< each begins where the previous one ends
  double distance = 0;                   ///< the length of the shortest path, up to rounding, in the unit of the input
  bool is_complete = true;               ///< whether it was found; if not, `halfedges` are some path
};

namespace internal {

// Lower bounds of the distances of all vertices from one: straight lines in space, or zero where there is none.
// \param exponent of the unit
template <class Traits>
std::vector<double> straight_distances(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index from,
                                       int exponent)
{
  std::vector<double> result(triangulation.connectivity().number_of_vertices(), 0);
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const auto& metric = engine(triangulation).metric();
    const auto& correspondence = engine(triangulation).correspondence();
    const auto place = [&](std::size_t v) {
      if (v < metric.points().size())
        return metric.points()[v];
      Surface_point p = correspondence.location(Vertex_index(Vertex_index::size_type(v)));
      p.coordinates = with_sum_one(p.coordinates);
      return point_in_space(correspondence.input(), metric.points(), p);
    };
    if (metric.points().empty())
      return result;
    const std::array<double, 3> q = place(from.idx());
    const double rounding = 0x1p-50 * (std::max)({std::abs(q[0]), std::abs(q[1]), std::abs(q[2])});
    for (std::size_t v = 0; v < result.size(); ++v) {
      const std::array<double, 3> p = place(v);
      const double line = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]) * (1 - 0x1p-50) - rounding;
      result[v] = std::ldexp((std::max)(0., line), metric.unit_exponent() - exponent);
    }
  }
  return result;
}

// From a vertex back along the straight ways that gave the distances, which become edges.
template <class Traits>
class Way_back
{
public:
  Way_back(Intrinsic_triangulation<Traits>& triangulation, const Laid_out_faces& faces, const Window_distances& windows,
           const Interruption& interruption)
    : triangulation_(triangulation), faces_(faces), windows_(windows), interruption_(interruption)
  {}

  // The edge from v to the vertex from which the straight way comes. Faces that other straight ways cross stay
  // unchanged.
  // \return the null descriptor if it was not found
  Halfedge_index follow(std::uint32_t v)
  {
    const std::uint32_t side = windows_.arrivals[v].side;
    if (side == Laid_out_faces::none)
      return {};
    v_ = v;
    // v lies at the origin, and the way on the axis. It runs between the last corners on the left and on the right.
    const double sine = std::sin(windows_.arrivals[v].angle), cosine = std::cos(windows_.arrivals[v].angle);
    const Laid_out_faces::Side& first = faces_.side(side);
    corners_ = {{first.apex_x * cosine + first.apex_y * sine, first.apex_y * cosine - first.apex_x * sine},
                {first.length * cosine, -first.length * sine}};
    crossed_.clear();
    if (comes_from(faces_.side(faces_.prev(side)).vertex, corners_[0]))
      return complex().opposite(faces_.halfedge(faces_.prev(side)));
    if (comes_from(faces_.side(faces_.next(side)).vertex, corners_[1]))
      return faces_.halfedge(side);
    const std::uint32_t u = cross_faces(faces_.next(side));
    return u == Laid_out_faces::none ? Halfedge_index() : join_with(u);
  }

private:
  struct Point
  {
    double x, y;
  };
  // An edge that the way crosses.
  struct Crossing
  {
    Edge_index edge;
    std::size_t left, right; // corners
  };

  const Delta_complex& complex() const { return triangulation_.connectivity(); }

  // \return the vertex where the way comes from
  std::uint32_t cross_faces(std::uint32_t crossed)
  {
    std::size_t left = 0, right = 1;
    for (std::size_t i = 0; i < faces_.sides().size(); ++i) {
      const std::uint32_t side = faces_.side(crossed).opposite;
      if (side == Laid_out_faces::none)
        return Laid_out_faces::none;
      crossed_.push_back({complex().edge(faces_.halfedge(side)), left, right});
      const Laid_out_faces::Side& s = faces_.side(side);
      const Point &l = corners_[left], &r = corners_[right];
      const double ex = (r.x - l.x) / s.length, ey = (r.y - l.y) / s.length;
      const Point apex{l.x + s.apex_x * ex - s.apex_y * ey, l.y + s.apex_x * ey + s.apex_y * ex};
      const std::uint32_t vertex = faces_.side(faces_.prev(side)).vertex;
      if (comes_from(vertex, apex))
        return vertex;
      (apex.y > 0 ? left : right) = corners_.size();
      corners_.push_back(apex);
      crossed = apex.y > 0 ? faces_.next(side) : faces_.prev(side);
    }
    return Laid_out_faces::none;
  }

  // Whether the way meets a vertex at a point, and the rest of it is as long as the way from that vertex.
  bool comes_from(std::uint32_t vertex, const Point& p) const
  {
    const double gone = std::hypot(p.x, p.y), whole = windows_.distances[v_];
    return p.x > 0 && std::abs(p.y) <= 1e-5 * gone &&
           std::abs(windows_.distances[vertex] + gone - whole) <= 1e-9 * whole;
  }

  // Flips crossed edges until there are none: edges whose flip reduces the number of crossings, and edges that are not
  // Delaunay once all distances along the way are shortened by the same large factor. After that shortening, the ends
  // of the way are nearer to each other than to anything else, so the way is an edge of the constrained Delaunay
  // triangulation of the faces that it crosses, which can be laid out in the plane. So there is always an edge to flip.
  Halfedge_index join_with(std::uint32_t u)
  {
    Edge_index last;
    std::size_t budget = crossed_.size() * crossed_.size() + 100; // more flips are due to rounding
    for (std::size_t i = 0; i < crossed_.size() && budget > 0;) {
      const Edge_index e = crossed_[i].edge;
      const std::size_t before = i == 0 ? none : other_corner(i - 1, i),
                        behind = i + 1 == crossed_.size() ? none : other_corner(i + 1, i);
      const bool is_less = before == none || behind == none || (corners_[before].y > 0) == (corners_[behind].y > 0);
      if (!(is_less || is_in_circle(corners_[before], corners_[crossed_[i].right], corners_[crossed_[i].left],
                                    corners_[behind])) ||
          !complex().is_flippable(e) ||
          triangulation_.flip(e) != Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED) {
        ++i;
        continue;
      }
      interruption_.check();
      --budget;
      last = e;
      if (is_less)
        crossed_.erase(crossed_.begin() + std::ptrdiff_t(i));
      else
        crossed_[i] = corners_[before].y > 0 ? Crossing{e, before, behind} : Crossing{e, behind, before};
      i -= i > 0; // the edge before it may now be flipped, too
    }
    if (!crossed_.empty())
      return {};
    const Halfedge_index h = complex().halfedge(last), g = complex().opposite(h);
    const auto joins = [&](Halfedge_index k) {
      return complex().source(k).idx() == v_ && complex().target(k).idx() == u;
    };
    return joins(h) ? h : joins(g) ? g : Halfedge_index();
  }

  // Whether s lies in the circle through p, q and r, which are counterclockwise, after that shortening.
  static bool is_in_circle(const Point& p, const Point& q, const Point& r, const Point& s)
  {
    const double px = p.x - s.x, py = p.y - s.y, qx = q.x - s.x, qy = q.y - s.y, rx = r.x - s.x, ry = r.y - s.y;
    return px * qy * ry * (ry - qy) + qx * ry * py * (py - ry) + rx * py * qy * (qy - py) > 0;
  }

  // The corner of one crossing that it does not share with its neighbor.
  std::size_t other_corner(std::size_t i, std::size_t neighbor) const
  {
    return crossed_[i].left == crossed_[neighbor].left ? crossed_[i].right : crossed_[i].left;
  }

  static constexpr std::size_t none = std::size_t(-1);

  Intrinsic_triangulation<Traits>& triangulation_;
  const Laid_out_faces& faces_;
  const Window_distances& windows_;
  const Interruption& interruption_;
  std::uint32_t v_ = 0;
  std::vector<Point> corners_;
  std::vector<Crossing> crossed_;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief finds a shortest path between two vertices, and flips edges until it consists of edges.
///
/// Straight lines are followed from the source as by `geodesic_distances()` without a tolerance; for a surface in
/// space, those first that are nearest to the target (A*: the straight line in space is a lower bound). They are traced
/// back, and the edges that they cross are flipped until the lines are edges. `Geodesic_path_network` proves that the
/// path is locally shortest; its length then equals `distance` up to rounding.
///
/// \param triangulation a triangulation, preferably Delaunay, so that paths cross few faces. It is flipped along the
///   path
/// \param source, target vertices
/// \param np the named parameters of `geodesic_distances()`, except for the tolerance
/// \return the path; it has no edges if both vertices are the same
/// \exception Invalid_argument_error if there is no such vertex, or no path
/// \exception Cancelled_error if the visitor asks for it
/// \exception Undecided_error as `flip()` of `Intrinsic_triangulation`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Shortest_path shortest_path(Intrinsic_triangulation<Traits>& triangulation, Vertex_index source, Vertex_index target,
                            const NamedParameters& np = parameters::default_values())
{
  const Delta_complex& complex = triangulation.connectivity();
  const internal::Row_of_vertex row(complex);
  for (Vertex_index v : {source, target})
    internal::require_vertex(v, row.number_of_rows());
  Shortest_path result;
  if (source == target)
    return result;
  const internal::Laid_out_faces faces(triangulation, row);
  const internal::Interruption interruption(internal::go_further_function_of(np));
  const internal::Window_distances windows = internal::propagate_windows_to(
    faces, source.idx(), target.idx(), internal::straight_distances(triangulation, target, faces.exponent()),
    internal::number_of_ways(np, complex), interruption);
  result.is_complete = windows.is_complete;
  result.distance = std::ldexp(windows.distances[target.idx()], faces.exponent());
  internal::Way_back<Traits> way(triangulation, faces, windows, interruption);
  for (Vertex_index v = target; v != source; v = complex.target(result.halfedges.back())) {
    const Halfedge_index h = way.follow(v.idx());
    if (h.is_valid()) {
      result.halfedges.push_back(h);
      continue;
    }
    const std::vector<Halfedge_index> rest = shortest_edge_path(triangulation, source, v);
    for (auto rest_h = rest.rbegin(); rest_h != rest.rend(); ++rest_h)
      result.halfedges.push_back(complex.opposite(*rest_h));
    result.is_complete = false;
    break;
  }
  std::reverse(result.halfedges.begin(), result.halfedges.end());
  for (Halfedge_index& h : result.halfedges)
    h = complex.opposite(h);
  return result;
}

namespace internal {

// A path over stops, with the reports of all its parts.
struct Path_over_stops
{
  std::vector<Surface_point> points; // on the input
  double distance = 0;               // the length of the shortest path
  double initial_length = 0, length = 0;
  std::uint64_t flips = 0, maximum_number_of_flips = (std::numeric_limits<std::uint64_t>::max)();
  bool is_geodesic = true;
  Geodesic_status status = Geodesic_status::GEODESIC;

  // Continues along a path of a network, which is shortened.
  // \param np the visitor
  template <class Traits, class NamedParameters>
  void append(const Intrinsic_triangulation<Traits>& triangulation, Geodesic_path_network<Traits>& network,
              std::size_t path, const NamedParameters& np)
  {
    const std::function<bool()> go_further = go_further_function_of(np);
    const auto goes_on = [&go_further] { return !go_further || go_further(); };
    initial_length += network.length(path);
    flips += network.shorten(parameters::visitor(goes_on).maximum_number(maximum_number_of_flips - flips)).flips;
    length += network.length(path);
    is_geodesic = network.is_geodesic(path) && is_geodesic;
    status = (std::max)(status, network.status(path));
    const std::vector<Surface_point> part = geodesic_points(triangulation, network.halfedges(path));
    if (!points.empty() && !part.empty())
      points.pop_back();
    points.insert(points.end(), part.begin(), part.end());
  }

  // Continues along the shortest path to the next stop. As the search for it flips edges, the network forgets others.
  // \param np those of `shortest_path()`, with its exceptions
  template <class Traits, class NamedParameters>
  void append_shortest(Intrinsic_triangulation<Traits>& triangulation, Geodesic_path_network<Traits>& network,
                       Vertex_index from, Vertex_index to, const NamedParameters& np)
  {
    network.rewind();
    const Shortest_path found = shortest_path(triangulation, from, to, np);
    distance += found.distance;
    append(triangulation, network, network.add_path(found.halfedges), np);
  }
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H

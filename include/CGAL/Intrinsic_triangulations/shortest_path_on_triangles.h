// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest paths on triangles that need not form a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Divided_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Row_of_cover_vertex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `shortest_path_on_triangles()`.
struct Path_on_triangles
{
  std::vector<std::array<double, 3>> positions; ///< from the first stop to the last, rounded; straight lines join them
  /// the same points, each in a triangle that has the next one, too: a source for `sources_on_cover()`. Empty if all stops
  /// are one vertex, and that has no triangle
  std::vector<Point_in_triangle> points;
  double length = 0;       ///< the sum of the lengths of the lines
  double distance = 0;     ///< the length of the shortest path, up to rounding
  bool is_complete = true; ///< whether it was found; if not, some lines are missing
};

namespace internal {

// A part of a way within a sheet.
struct Straight_part
{
  // A point of a side of a face, by its fraction: with 0, the vertex where the side begins.
  struct End
  {
    std::uint32_t side;
    double place;
  };
  End from, to;
};

// The parts of the shortest way to a row, the last one first.
// \return whether all were found
bool straight_parts(const Laid_out_faces& faces, const Window_distances& windows, std::uint32_t row,
                    std::vector<Straight_part>& parts);

// A part of a path, on one sheet or along a flat edge.
struct Part_on_sheets
{
  // A vertex, or a point of a border edge of the input.
  struct Place
  {
    Vertex_index vertex;
    Surface_point point;
  };
  std::array<Place, 2> ends;
  const Tufted_cover::Flat_edge* flat_edge = nullptr;
};

// A vertex, and what a message calls it.
struct Path_stop
{
  std::uint32_t vertex;
  std::string name;
};

// The shortest path from stop to stop.
template <class NamedParameters>
Path_on_triangles path_over_sheets(const Points& points, const std::vector<Index_triangle>& triangles,
                                   const std::vector<Path_stop>& stops, const NamedParameters& np)
{
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;
  const std::function<bool()> go_further = go_further_function_of(np);
  const auto goes_on = [&go_further] { return !go_further || go_further(); };
  const auto options = parameters::visitor(goes_on);
  Tufted_cover cover =
    make_tufted_cover(points, triangles, parameters::surface_cover(Surface_cover::SHEETS).visitor(goes_on));
  Triangulation& sheets = cover.triangulation;
  const Row_of_cover_vertex row(cover);
  Points places; // of the cover
  for (std::uint32_t v : cover.vertex_of)
    places.push_back(points[v]);
  Path_on_triangles result;
  const auto row_at = [&](std::size_t i) { return cover.representative[stops[i].vertex]; };

  // A path changes sheets at points of edges that no flip removes, and at vertices.
  using Part = Part_on_sheets;
  std::vector<Part> parts;
  std::vector<double> distances; // from stop to stop
  std::vector<std::size_t> ends; // their parts
  {
    Triangulation flipped(sheets);
    flip_to_Delaunay(flipped, options);
    const Laid_out_faces faces(flipped, row);
    const auto on_sheets = [&](const Straight_part::End& end) {
      const Halfedge_index h = faces.halfedge(end.side);
      return end.place > 0 ? Part::Place{{}, {h, {1 - end.place, end.place, 0}}}
                           : Part::Place{flipped.connectivity().source(h), {}};
    };
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      if (const std::uint32_t from = row_at(i), to = row_at(i + 1); from != to) {
        const Window_distances windows = propagate_windows(
          faces, 0, {{{from, 0, 0, {}}}, {}}, number_of_ways(np, sheets.input()), Interruption(go_further), {to});
        if (!std::isfinite(windows.distances[to]))
          throw Invalid_argument_error("no path leads from " + stops[i].name + " to " + stops[i + 1].name);
        distances.push_back(std::ldexp(windows.distances[to], faces.exponent()));
        std::vector<Straight_part> found;
        result.is_complete = straight_parts(faces, windows, to, found) && windows.is_complete && result.is_complete;
        const std::size_t first = parts.size();
        for (auto part = found.rbegin(); part != found.rend(); ++part) {
          if (faces.is_flat_edge(part->to.side)) {
            parts.push_back({{}, &cover.flat_edges[faces.flat_edge(part->to.side)]});
            parts.back().ends[0].vertex = Vertex_index(faces.side(part->to.side).row);
            parts.back().ends[1].vertex = Vertex_index(faces.side(part->from.side).row);
            continue;
          }
          const Part::Place begin = on_sheets(part->to), end = on_sheets(part->from);
          if (begin.vertex.is_valid() && parts.size() > first && !parts.back().flat_edge &&
              parts.back().ends[1].vertex == begin.vertex)
            parts.back().ends[1] = end; // it bends within a sheet
          else
            parts.push_back({{begin, end}});
        }
      } else {
        distances.push_back(0);
      }
      ends.push_back(parts.size());
    }
  }
  for (Part& part : parts)
    for (Part::Place& end : part.ends)
      if (!part.flat_edge && !end.vertex.is_valid())
        end.vertex = vertex_at_point(sheets, end.point);
  flip_to_Delaunay(sheets, options);
  const auto add = [&](const Point_in_triangle& p, const std::array<double, 3>& place) {
    result.points.push_back(p);
    result.positions.push_back(place);
  };
  const auto add_on_cover = [&](const Surface_point& p) {
    add(point_below_cover(cover, points, triangles, p), point_in_space(sheets.input(), places, p));
  };
  Geodesic_path_network<Filtered_edge_length_traits> network(sheets);
  for (std::size_t i = 0, n = 0; i < ends.size(); ++i) {
    double length = 0;
    for (; n < ends[i]; ++n) {
      // Its first point replaces the last one of the part before, which is the same on another sheet.
      if (!result.points.empty()) {
        result.points.pop_back();
        result.positions.pop_back();
      }
      const Part& part = parts[n];
      if (part.flat_edge) {
        length += part.flat_edge->length;
        for (const Part::Place& end : part.ends)
          add(vertex_below_cover(cover, points, triangles, part.flat_edge->face, end.vertex), places[end.vertex.idx()]);
        continue;
      }
      Path_over_stops line;
      line.append_shortest(sheets, network, part.ends[0].vertex, part.ends[1].vertex, np);
      length += line.length;
      for (const Surface_point& p : line.points)
        add_on_cover(p);
    }
    // Where a part was not traced back, another path may be as short.
    result.is_complete = result.is_complete && std::abs(length - distances[i]) <= 1e-9 * distances[i];
    result.length += length;
    result.distance += distances[i];
  }
  for (std::size_t t = 0; t < triangles.size() && result.points.empty(); ++t)
    for (std::size_t k = 0; k < 3 && result.points.empty(); ++k)
      if (cover.representative[triangles[t][k]] == row_at(0))
        result.points.push_back(vertex_below_cover(cover, points, triangles, t, Vertex_index(row_at(0))));
  if (result.positions.empty())
    result.positions.push_back(points[stops.front().vertex]);
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief finds a shortest path between two vertices of any triangles.
///
/// As for `geodesic_distances()` of a cover made of sheets, the path goes from each face at an edge into all others,
/// however many there are and whether they can be oriented or not.
///
/// \tparam PointRange a range of points whose coordinates are `p[0]`, `p[1]` and `p[2]`
/// \tparam TriangleRange a range of random access ranges of three vertex indices each
/// \param points the vertices
/// \param triangles the faces
/// \param source, target vertices
/// \param np the named parameters of `geodesic_distances()`, except for the tolerance
/// \return the path; it has one position if both vertices are at the same point
/// \exception Invalid_argument_error if there is no such vertex, or no path
/// \exception Invalid_surface_error as `make_tufted_cover()`
/// \exception Cancelled_error if the visitor asks for it
/// \exception Undecided_error as `flip()` of `Intrinsic_triangulation`
template <class PointRange, class TriangleRange, class NamedParameters = parameters::Default_named_parameters>
Path_on_triangles shortest_path_on_triangles(const PointRange& points, const TriangleRange& triangles,
                                             std::size_t source, std::size_t target,
                                             const NamedParameters& np = parameters::default_values())
{
  const internal::Points places = internal::copy_points(points);
  const std::vector<internal::Index_triangle> faces = internal::copy_triangles(triangles, places.size());
  std::vector<internal::Path_stop> stops;
  for (std::size_t v : {source, target}) {
    internal::require_vertex(v, places.size()); // not yet narrowed
    stops.push_back({std::uint32_t(v), "vertex " + std::to_string(v)});
  }
  return internal::path_over_sheets(places, faces, stops, np);
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief finds a path over any triangles that is shortest from each of its stops to the next one: a curve as a source
/// of distances.
/// \param points, triangles as above
/// \param stops points of the triangles, at least one; those that are no vertices become vertices, rounded
/// \param np as above
/// \return the path; it has one position if all stops are at the same point
/// \exception Invalid_point_error if a stop is not a point of a triangle. \exception Invalid_argument_error if there is
///   none, or no path leads to one
/// \exception Invalid_surface_error, Cancelled_error, Undecided_error as above
template <class PointRange, class TriangleRange, class NamedParameters = parameters::Default_named_parameters>
Path_on_triangles shortest_path_on_triangles(const PointRange& points, const TriangleRange& triangles,
                                             const std::vector<Point_in_triangle>& stops,
                                             const NamedParameters& np = parameters::default_values())
{
  if (stops.empty())
    throw Invalid_argument_error("a path needs stops");
  internal::Points places = internal::copy_points(points);
  std::vector<internal::Index_triangle> faces = internal::copy_triangles(triangles, places.size());
  internal::Divided_triangles divided(std::move(places), std::move(faces));
  std::vector<internal::Path_stop> vertices;
  for (const Point_in_triangle& p : stops)
    vertices.push_back({divided.vertex_at(p), "the point in triangle " + std::to_string(p.triangle)});
  Path_on_triangles result = internal::path_over_sheets(divided.points(), divided.triangles(), vertices, np);
  for (Point_in_triangle& p : result.points)
    p = divided.in_given_triangle(p);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H

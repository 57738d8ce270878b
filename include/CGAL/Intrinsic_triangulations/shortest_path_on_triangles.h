// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest paths on triangles that need not form a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
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
  std::vector<std::array<double, 3>> positions; ///< from source to target, rounded; straight lines join them
  std::vector<std::size_t> triangles;           ///< for each line, a triangle in which it lies
  double length = 0;                            ///< the sum of the lengths of the lines
  double distance = 0;                          ///< the length of the shortest path, up to rounding
  bool is_complete = true;                      ///< whether it was found; if not, some lines are missing
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
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;
  const std::function<bool()> go_further = internal::go_further_function_of(np);
  const auto goes_on = [&go_further] { return !go_further || go_further(); };
  const auto options = parameters::visitor(goes_on);
  Tufted_cover cover =
    make_tufted_cover(points, triangles, parameters::surface_cover(Surface_cover::SHEETS).visitor(goes_on));
  Triangulation& sheets = cover.triangulation;
  const Delta_complex& input = sheets.input();
  const internal::Row_of_cover_vertex row(cover);
  for (std::size_t v : {source, target})
    internal::require_vertex(Vertex_index(Vertex_index::size_type(v)), row.number_of_rows());
  std::vector<std::array<double, 3>> places; // of the cover
  for (std::uint32_t v : cover.vertex_of)
    places.push_back({to_double(points[v][0]), to_double(points[v][1]), to_double(points[v][2])});
  Path_on_triangles result;
  const std::uint32_t from = cover.representative[source], to = cover.representative[target];
  result.positions.push_back(places[from]);
  if (from == to)
    return result;

  // A path changes sheets at points of edges that no flip removes, and at vertices.
  using Part = internal::Part_on_sheets;
  std::vector<Part> parts;
  {
    Triangulation flipped(sheets);
    flip_to_Delaunay(flipped, options);
    const internal::Laid_out_faces faces(flipped, row);
    const internal::Window_distances windows =
      internal::propagate_windows(faces, 0, {{{from, 0, 0, {}}}, {}}, internal::number_of_ways(np, input),
                                  internal::Interruption(go_further), {to});
    if (!std::isfinite(windows.distances[to]))
      throw Invalid_argument_error("no path leads from vertex " + std::to_string(source) + " to vertex " +
                                   std::to_string(target));
    result.distance = std::ldexp(windows.distances[to], faces.exponent());
    std::vector<internal::Straight_part> found;
    result.is_complete = internal::straight_parts(faces, windows, to, found) && windows.is_complete;
    const auto on_sheets = [&](const internal::Straight_part::End& end) {
      const Halfedge_index h = faces.halfedge(end.side);
      return end.place > 0 ? Part::Place{{}, {h, {1 - end.place, end.place, 0}}}
                           : Part::Place{flipped.connectivity().source(h), {}};
    };
    for (auto part = found.rbegin(); part != found.rend(); ++part) {
      if (faces.is_flat_edge(part->to.side)) {
        parts.push_back({{}, &cover.flat_edges[faces.flat_edge(part->to.side)]});
        parts.back().ends[1].vertex = Vertex_index(faces.side(part->from.side).row);
        continue;
      }
      const Part::Place begin = on_sheets(part->to), end = on_sheets(part->from);
      if (begin.vertex.is_valid() && !parts.empty() && !parts.back().flat_edge &&
          parts.back().ends[1].vertex == begin.vertex)
        parts.back().ends[1] = end; // it bends within a sheet
      else
        parts.push_back({{begin, end}});
    }
  }
  for (Part& part : parts)
    for (Part::Place& end : part.ends)
      if (!part.flat_edge && !end.vertex.is_valid())
        end.vertex = vertex_at_point(sheets, end.point);
  flip_to_Delaunay(sheets, options);
  for (const Part& part : parts) {
    if (part.flat_edge) {
      result.length += part.flat_edge->length;
      result.triangles.push_back(part.flat_edge->face);
      result.positions.push_back(places[part.ends[1].vertex.idx()]);
      continue;
    }
    const Shortest_path path = shortest_path(sheets, part.ends[0].vertex, part.ends[1].vertex, np);
    Geodesic_path_network<Filtered_edge_length_traits> network(sheets);
    const std::size_t number = network.add_path(path.halfedges);
    network.shorten(options);
    const std::vector<Surface_point> line = geodesic_points(sheets, network.halfedges(number));
    result.length += network.length(number);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      result.triangles.push_back(cover.face_of[input.face(line[i].halfedge).idx()]);
      result.positions.push_back(point_in_space(input, places, line[i + 1]));
    }
  }
  // Where a part was not traced back, another path may be as short.
  result.is_complete = result.is_complete && std::abs(result.length - result.distance) <= 1e-9 * result.distance;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_ON_TRIANGLES_H

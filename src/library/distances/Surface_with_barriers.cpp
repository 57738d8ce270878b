// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From a surface to the one that is cut open along barriers, and back.

#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>

#include "../gluing/Cut_faces.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include "../connectivity/checked_coordinates.h"
#include "coordinates_in_part.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

using Coordinates = std::array<double, 3>;

// The point that divides a segment. \param t from 0 to 1
Coordinates between(const Coordinates& from, const Coordinates& to, double t)
{
  Coordinates result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = (std::max)(0., (1 - t) * from[i] + t * to[i]);
  return result;
}

} // namespace

Surface_with_barriers::Surface_with_barriers(const Delta_complex& input,
                                             const std::vector<std::array<double, 3>>& points,
                                             const std::vector<std::vector<Surface_point>>& barriers)
  : input_(input), cut_(internal::cut_along_paths(input, points, barriers)),
    first_(input.number_of_faces() + 1, cut_.triangles.size())
{
  connectivity_ = make_Delta_complex_from_triangles(cut_.points.size(), cut_.triangles);
  for (std::size_t t = cut_.triangles.size(); t-- > 0;)
    first_[cut_.input_faces[t]] = t;
  const std::size_t n = input.number_of_vertices();
  for (std::size_t i = 0; i < cut_.locations.size(); ++i)
    if (cut_.locations[i].dimension() == 0)
      copies_.insert(
        {internal::Cut_faces::vertex_at(input_, cut_.locations[i]), Vertex_index(Vertex_index::size_type(n + i))});
}

std::vector<Vertex_index> Surface_with_barriers::copies(Vertex_index v) const
{
  std::vector<Vertex_index> result{v};
  for (auto [copy, end] = copies_.equal_range(v); copy != end; ++copy)
    result.push_back(copy->second);
  return result;
}

std::vector<Geodesic_source> Surface_with_barriers::sources(const std::vector<Geodesic_source>& of_input) const
{
  std::vector<Geodesic_source> result;
  for (const Geodesic_source& source : of_input) {
    result.push_back({{}, source.offset});
    Parts& parts = result.back().parts;
    for (const std::vector<Surface_point>& part : source.parts) {
      for (std::size_t i = 0; i + 1 < part.size(); ++i)
        add_segment(checked(part[i]), checked(part[i + 1]), parts);
      if (part.size() == 1)
        add_point(checked(part.front()), parts);
    }
  }
  return result;
}

Geodesic_distances Surface_with_barriers::of_nearer_sides(Geodesic_distances found) const
{
  for (const auto& [v, copy] : copies_)
    if (found.distances[copy.idx()] < found.distances[v.idx()]) {
      found.distances[v.idx()] = found.distances[copy.idx()];
      if (!found.nearest_sources.empty())
        found.nearest_sources[v.idx()] = found.nearest_sources[copy.idx()];
    }
  found.distances.resize(input_.number_of_vertices());
  if (!found.nearest_sources.empty())
    found.nearest_sources.resize(input_.number_of_vertices());
  return found;
}

std::vector<Surface_point> Surface_with_barriers::on_input(const std::vector<Surface_point>& path) const
{
  std::vector<Surface_point> result;
  for (const Surface_point& p : path) {
    const Face_index f = connectivity_.face(p.halfedge);
    const Halfedge_index h = input_.halfedge(Face_index(cut_.input_faces[f.idx()]));
    const std::array<Coordinates, 3> around = corners(f.idx(), h);
    const Coordinates c = coordinates_from(connectivity_, p, connectivity_.halfedge(f));
    Surface_point q{h, {0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        q.coordinates[k] += c[i] * around[i][k];
    result.push_back(q);
  }
  return result;
}

Surface_point Surface_with_barriers::checked(const Surface_point& p) const
{
  const std::optional<Coordinates> coordinates = internal::checked_coordinates(p.coordinates);
  if (p.halfedge.idx() >= input_.number_of_halfedges() || input_.is_border(p.halfedge) || !coordinates)
    throw Invalid_point_error("a point of a source does not lie on the surface: it needs a face, and coordinates that "
                              "are finite, not negative and not all zero");
  return {p.halfedge, internal::on_near_edges(*coordinates)};
}

// The coordinates of the corners of a triangle, relative to a halfedge of its face.
std::array<Coordinates, 3> Surface_with_barriers::corners(std::size_t triangle, Halfedge_index h) const
{
  std::array<Coordinates, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t v = cut_.triangles[triangle][i], n = input_.number_of_vertices();
    const Vertex_index at{Vertex_index::size_type(v)};
    const Surface_point p = v < n ? source_at_vertex(input_, at).parts.front().front() : cut_.locations[v - n];
    internal::find_coordinates(input_, h, p, result[i]);
  }
  return result;
}

void Surface_with_barriers::add_point(const Surface_point& p, Parts& parts) const
{
  if (p.dimension() > 0)
    return add_segment(p, p, parts);
  for (Vertex_index v : copies(internal::Cut_faces::vertex_at(input_, p)))
    parts.push_back(source_at_vertex(connectivity_, v).parts.front());
}

// Adds the segment on both sides of an edge, which may be a barrier.
void Surface_with_barriers::add_segment(const Surface_point& p, const Surface_point& q, Parts& parts) const
{
  Coordinates to;
  if (!internal::find_coordinates(input_, p.halfedge, q, to))
    throw Invalid_point_error("two consecutive points of a curve do not lie in the face of the first, face " +
                              std::to_string(input_.face(p.halfedge).idx()));
  add_segment_in_face(p.halfedge, p.coordinates, to, parts);
  Halfedge_index side = p.halfedge;
  for (std::size_t i = 0; i < 3; ++i, side = input_.next(side)) {
    const Halfedge_index beyond = input_.opposite(side);
    const Coordinates& from = p.coordinates;
    if (from[(i + 2) % 3] == 0 && to[(i + 2) % 3] == 0 && !input_.is_border(beyond))
      add_segment_in_face(beyond, {from[(i + 1) % 3], from[i], 0}, {to[(i + 1) % 3], to[i], 0}, parts);
  }
}

// Adds the parts of the segment in the triangles of a face.
void Surface_with_barriers::add_segment_in_face(Halfedge_index h, const Coordinates& from, const Coordinates& to,
                                                Parts& parts) const
{
  constexpr double on_side = 1e-12;
  const std::size_t f = input_.face(h).idx();
  for (std::size_t t = first_[f]; t < cut_.triangles.size() && cut_.input_faces[t] == f; ++t) {
    const std::array<Coordinates, 3> around = corners(t, h);
    const Coordinates a = internal::coordinates_in_part(around, from), b = internal::coordinates_in_part(around, to);
    double begin = 0, end = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double rise = b[i] - a[i], zero = (-on_side - a[i]) / rise;
      if (a[i] < -on_side && b[i] < -on_side)
        end = -1;
      else if (a[i] < -on_side)
        begin = (std::max)(begin, zero);
      else if (b[i] < -on_side)
        end = (std::min)(end, zero);
    }
    const Halfedge_index side = connectivity_.halfedge(Face_index(Face_index::size_type(t)));
    if (from == to && end == 1)
      parts.push_back({{side, between(a, b, 0)}});
    else if (from != to && end - begin > on_side)
      parts.push_back({{side, between(a, b, begin)}, {side, between(a, b, end)}});
  }
}

} // namespace CGAL::Intrinsic_triangulations

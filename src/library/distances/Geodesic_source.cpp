// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Geodesic_source.h.

#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

std::vector<Surface_point> points_of_edge(const Delta_complex& input, Edge_index e)
{
  Halfedge_index h = input.halfedge(e);
  if (input.is_border(h))
    h = input.opposite(h);
  return {{h, {1, 0, 0}}, {h, {0, 1, 0}}};
}

} // namespace

Geodesic_source source_at_vertex(const Delta_complex& input, Vertex_index v)
{
  if (v.idx() >= input.number_of_vertices() || !input.halfedge(v).is_valid())
    throw Invalid_argument_error("there is no vertex " + std::to_string(v.idx()) + " with a face");
  const Halfedge_index h = input.halfedge(v), away = input.opposite(h);
  return {{{input.is_border(away) ? Surface_point{h, {0, 1, 0}} : Surface_point{away, {1, 0, 0}}}}};
}

Geodesic_source source_at_edge(const Delta_complex& input, Edge_index e)
{
  if (e.idx() >= input.number_of_edges())
    throw Invalid_argument_error("there is no edge " + std::to_string(e.idx()));
  return {{points_of_edge(input, e)}};
}

Geodesic_source source_of_region(const Delta_complex& input, const std::vector<Face_index>& faces)
{
  std::vector<bool> is_in_region(input.number_of_faces(), false), has_vertex(input.number_of_vertices(), false);
  for (Face_index f : faces) {
    if (f.idx() >= input.number_of_faces())
      throw Invalid_argument_error("there is no face " + std::to_string(f.idx()));
    is_in_region[f.idx()] = true;
  }
  Geodesic_source result;
  for (Face_index f : faces) {
    const Halfedge_index first = input.halfedge(f);
    for (Halfedge_index h : {first, input.next(first), input.prev(first)}) {
      if (!has_vertex[input.source(h).idx()])
        result.parts.push_back({{h, {1, 0, 0}}});
      has_vertex[input.source(h).idx()] = true;
      const Halfedge_index g = input.opposite(h);
      if (!input.is_border(g) && !is_in_region[input.face(g).idx()])
        result.parts.push_back({{h, {1, 0, 0}}, {h, {0, 1, 0}}});
    }
  }
  return result;
}

std::vector<Surface_point> points_of_cover(const Tufted_cover& cover,
                                           const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                           const std::vector<Point_in_triangle>& points)
{
  const Delta_complex& input = cover.triangulation.input();
  std::vector<Face_index> face_over(triangles.size());
  for (Face_index f : input.faces())
    if (!cover.is_back[f.idx()])
      face_over[cover.face_of[f.idx()]] = f;
  std::vector<Surface_point> result;
  for (const Point_in_triangle& p : points) {
    if (p.triangle >= triangles.size() || !face_over[p.triangle].is_valid())
      throw Invalid_point_error("there is no triangle " + std::to_string(p.triangle) +
                                " with area: give a point in another one");
    const Halfedge_index h = input.halfedge(face_over[p.triangle]);
    const std::array<Halfedge_index, 3> sides{h, input.next(h), input.prev(h)};
    Surface_point q{h, {0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (cover.vertex_of[input.source(sides[i]).idx()] == cover.representative[triangles[p.triangle][j]])
          q.coordinates[i] = p.coordinates[j];
    result.push_back(q);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Geodesic_source.h.

#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include "Cover_locator.h"

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

std::vector<Geodesic_source> sources_on_cover(const Tufted_cover& cover,
                                              const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                              const std::vector<std::vector<Point_in_triangle>>& curves)
{
  const internal::Cover_locator locator(cover, triangles);
  std::vector<Geodesic_source> result;
  for (const std::vector<Point_in_triangle>& curve : curves)
    result.push_back(locator.source(curve));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

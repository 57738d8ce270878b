// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Geodesic_source.h.

#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>

#include "coordinates_in_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

using Triple = std::array<double, 3>;

// The barycentric coordinates of a point on the sides of a triangle.
Triple coordinates_on_sides(const std::array<Triple, 3>& corners, const Triple& p)
{
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Triple &a = corners[i], &b = corners[(i + 1) % 3];
    if (!internal::are_collinear(a, b, p))
      continue;
    std::size_t k = 0;
    for (std::size_t j = 1; j < 3; ++j)
      if (std::abs(b[j] - a[j]) > std::abs(b[k] - a[k]))
        k = j;
    const double part = (p[k] - a[k]) / (b[k] - a[k]);
    result[i] = 1 - part;
    result[(i + 1) % 3] = part;
    break;
  }
  return result;
}

// A point of a triangle that was cut, in the part where it lies.
// \param first_part, next_part the parts
Surface_point point_in_part(const Tufted_cover& cover, const std::array<std::uint32_t, 3>& triangle, const Triple& p,
                            Face_index first_part, const std::vector<Face_index>& next_part)
{
  const Delta_complex& input = cover.triangulation.input();
  const auto& points = internal::engine(cover.triangulation).metric().points();
  std::array<Triple, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = points[cover.representative[triangle[i]]];
  Surface_point result;
  double largest = -std::numeric_limits<double>::infinity();
  for (Face_index f = first_part; f.is_valid(); f = next_part[f.idx()]) {
    const Halfedge_index h = input.halfedge(f);
    std::array<Triple, 3> of_part;
    for (std::size_t i = 0; i < 3; ++i) {
      const Halfedge_index side = i == 0 ? h : i == 1 ? input.next(h) : input.prev(h);
      of_part[i] = coordinates_on_sides(corners, points[input.source(side).idx()]);
    }
    Surface_point q{h, internal::coordinates_in_part(of_part, p)};
    const double least = *std::min_element(q.coordinates.begin(), q.coordinates.end());
    double sum = 0;
    for (double& x : q.coordinates)
      sum += x = (std::max)(0., x);
    for (double& x : q.coordinates)
      x /= sum;
    if (least > largest) {
      largest = least;
      result = q;
    }
  }
  return result;
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
  std::vector<Face_index> face_over(triangles.size()), next(input.number_of_faces());
  for (Face_index f : input.faces())
    if (!cover.is_back[f.idx()] || !cover.is_half[f.idx()]) {
      next[f.idx()] = face_over[cover.face_of[f.idx()]];
      face_over[cover.face_of[f.idx()]] = f;
    }
  std::vector<Surface_point> result;
  for (const Point_in_triangle& p : points) {
    if (p.triangle >= triangles.size() || !face_over[p.triangle].is_valid())
      throw Invalid_point_error("there is no triangle " + std::to_string(p.triangle) +
                                " with area: give a point in another one");
    if (next[face_over[p.triangle].idx()].is_valid()) {
      result.push_back(point_in_part(cover, triangles[p.triangle], p.coordinates, face_over[p.triangle], next));
      continue;
    }
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

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
#include <set>
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

// A part of a triangle that was cut: its first side, and its corners in barycentric coordinates of the triangle.
struct Part
{
  Halfedge_index first;
  std::array<Triple, 3> corners;
};

class Cover_locator
{
public:
  Cover_locator(const Tufted_cover& cover, const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : cover_(cover), triangles_(triangles), input_(cover.triangulation.input()),
      points_(internal::engine(cover.triangulation).metric().points()), face_over_(triangles.size()),
      next_(input_.number_of_faces())
  {
    for (Face_index f : input_.faces())
      if (!cover.is_back[f.idx()] || !cover.is_half[f.idx()]) {
        next_[f.idx()] = face_over_[cover.face_of[f.idx()]];
        face_over_[cover.face_of[f.idx()]] = f;
      }
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (!face_over_[t].is_valid())
        flat_.push_back(t);
  }

  std::vector<Surface_point> points(const std::vector<Point_in_triangle>& curve) const
  {
    std::vector<Surface_point> result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Surface_point p = point(curve[i]);
      if (i > 0 && is_cut(curve[i - 1].triangle))
        cross_parts(parts_of(curve[i - 1].triangle), p, result);
      else
        result.push_back(p);
    }
    return result;
  }

private:
  bool is_cut(std::size_t t) const { return face_over_[t].is_valid() && next_[face_over_[t].idx()].is_valid(); }
  std::array<Halfedge_index, 3> sides(Halfedge_index h) const { return {h, input_.next(h), input_.prev(h)}; }
  Triple corner(std::size_t t, std::size_t i) const { return points_[cover_.representative[triangles_[t][i]]]; }

  std::vector<Part> parts_of(std::size_t t) const
  {
    const std::array<Triple, 3> corners{corner(t, 0), corner(t, 1), corner(t, 2)};
    std::vector<Part> result;
    for (Face_index f = face_over_[t]; f.is_valid(); f = next_[f.idx()]) {
      Part part{input_.halfedge(f), {}};
      for (std::size_t i = 0; i < 3; ++i)
        part.corners[i] = coordinates_on_sides(corners, points_[input_.source(sides(part.first)[i]).idx()]);
      result.push_back(part);
    }
    return result;
  }

  Surface_point point(const Point_in_triangle& p) const
  {
    if (p.triangle >= triangles_.size())
      throw Invalid_point_error("there is no triangle " + std::to_string(p.triangle));
    if (!face_over_[p.triangle].is_valid())
      return point_on_edge(p);
    if (is_cut(p.triangle))
      return point_in_part(parts_of(p.triangle), p.coordinates);
    Surface_point q{input_.halfedge(face_over_[p.triangle]), {0, 0, 0}};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (cover_.vertex_of[input_.source(sides(q.halfedge)[i]).idx()] ==
            cover_.representative[triangles_[p.triangle][j]])
          q.coordinates[i] = p.coordinates[j];
    return q;
  }

  // A point of a triangle without area lies on an edge between corners of the triangles that form a segment with it.
  Surface_point point_on_edge(const Point_in_triangle& p) const
  {
    std::set<std::uint32_t> corners;
    for (std::uint32_t v : triangles_[p.triangle])
      corners.insert(cover_.representative[v]);
    for (std::size_t before = 0; before < corners.size();) {
      before = corners.size();
      for (std::size_t t : flat_) {
        const auto is_new = [&](std::uint32_t v) { return corners.count(cover_.representative[v]) == 0; };
        if (std::count_if(triangles_[t].begin(), triangles_[t].end(), is_new) == 1)
          for (std::uint32_t v : triangles_[t])
            corners.insert(cover_.representative[v]);
      }
    }
    const double sum = p.coordinates[0] + p.coordinates[1] + p.coordinates[2];
    for (Halfedge_index h : input_.halfedges()) {
      const std::size_t a = input_.source(h).idx(), b = input_.target(h).idx();
      if (input_.is_border(h) || corners.count(cover_.vertex_of[a]) == 0 || corners.count(cover_.vertex_of[b]) == 0)
        continue;
      std::size_t k = 0; // the axis along which the edge is longest
      for (std::size_t j = 1; j < 3; ++j)
        if (std::abs(points_[b][j] - points_[a][j]) > std::abs(points_[b][k] - points_[a][k]))
          k = j;
      double x = 0;
      for (std::size_t i = 0; i < 3; ++i)
        x += p.coordinates[i] / sum * (corner(p.triangle, i)[k] - points_[a][k]);
      const double part = x / (points_[b][k] - points_[a][k]);
      if (part >= 0 && part <= 1)
        return {h, {1 - part, part, 0}};
    }
    throw Invalid_point_error("triangle " + std::to_string(p.triangle) +
                              " has no area, and no other triangle has the edge where the point lies: give a point in "
                              "another one");
  }

  // The point in the part where it lies deepest.
  static Surface_point point_in_part(const std::vector<Part>& parts, const Triple& p)
  {
    Surface_point result;
    double largest = -std::numeric_limits<double>::infinity();
    for (const Part& part : parts) {
      const Triple c = internal::coordinates_in_part(part.corners, p);
      const double least = *std::min_element(c.begin(), c.end());
      if (least > largest) {
        largest = least;
        result = {part.first, inside(c)};
      }
    }
    return result;
  }

  static Triple inside(Triple c)
  {
    double sum = 0;
    for (double& x : c)
      sum += x = (std::max)(0., x);
    for (double& x : c)
      x /= sum;
    return c;
  }

  // Whether a point lies in one of the parts, and where in the triangle.
  bool find_in_triangle(const std::vector<Part>& parts, const Surface_point& p, Triple& result) const
  {
    Triple c;
    for (const Part& part : parts)
      if (internal::find_coordinates(input_, part.first, p, c)) {
        for (std::size_t k = 0; k < 3; ++k)
          result[k] = c[0] * part.corners[0][k] + c[1] * part.corners[1][k] + c[2] * part.corners[2][k];
        return true;
      }
    return false;
  }

  // Appends a point in the triangle of the last one, after a point wherever another part is entered.
  void cross_parts(const std::vector<Part>& parts, const Surface_point& to, std::vector<Surface_point>& curve) const
  {
    struct Way
    {
      const Part* part;
      double begin, end; // from 0 to 1
      std::size_t entered;
      Triple from, to;
    };
    Triple start, target;
    std::vector<Way> ways;
    if (find_in_triangle(parts, curve.back(), start) && find_in_triangle(parts, to, target))
      for (const Part& part : parts) {
        Way way{&part,
                0,
                1,
                3,
                internal::coordinates_in_part(part.corners, start),
                internal::coordinates_in_part(part.corners, target)};
        for (std::size_t k = 0; k < 3; ++k) {
          const double at = way.from[k] / (way.from[k] - way.to[k]);
          if (way.from[k] < 0 && way.to[k] < 0)
            way.end = -1;
          else if (way.from[k] < 0 && at > way.begin) {
            way.begin = at;
            way.entered = k;
          } else if (way.to[k] < 0)
            way.end = (std::min)(way.end, at);
        }
        if (way.end > way.begin)
          ways.push_back(way);
      }
    std::sort(ways.begin(), ways.end(), [](const Way& v, const Way& w) { return v.begin < w.begin; });
    double reached = 0;
    const Part* last = nullptr;
    for (const Way& way : ways) {
      if (way.end <= reached)
        continue;
      Surface_point p{way.part->first, {}};
      for (std::size_t k = 0; k < 3; ++k)
        p.coordinates[k] = k == way.entered ? 0 : way.from[k] + way.begin * (way.to[k] - way.from[k]);
      p.coordinates = inside(p.coordinates);
      if (reached > 0)
        curve.push_back(p);
      else if (Triple c; internal::find_coordinates(input_, p.halfedge, curve.back(), c))
        curve.back() = {p.halfedge, c};
      else
        curve.back() = p;
      reached = way.end;
      last = way.part;
    }
    Triple c;
    if (last == nullptr || internal::find_coordinates(input_, last->first, to, c))
      curve.push_back(to);
    else
      curve.push_back({last->first, inside(internal::coordinates_in_part(last->corners, target))});
  }

  const Tufted_cover& cover_;
  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  const Delta_complex& input_;
  const Input_metric::Point_vector& points_;
  std::vector<std::size_t> flat_;            // the triangles without parts
  std::vector<Face_index> face_over_, next_; // the first part of each triangle, and the next one
};

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

std::vector<std::vector<Surface_point>> points_of_cover(const Tufted_cover& cover,
                                                        const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                                        const std::vector<std::vector<Point_in_triangle>>& parts)
{
  const Cover_locator locator(cover, triangles);
  std::vector<std::vector<Surface_point>> result;
  for (const std::vector<Point_in_triangle>& part : parts)
    result.push_back(locator.points(part));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and curves of triangles on the cover of these.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COVER_LOCATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COVER_LOCATOR_H

#include "coordinates_in_part.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Divided_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Cover_locator
{
  using Triple = std::array<double, 3>;

  // Of a triangle that was cut: its first side, and its corners in barycentric coordinates of the triangle.
  struct Part
  {
    Halfedge_index first;
    std::array<Triple, 3> corners;
  };

public:
  // \param cover, triangles must outlive this
  Cover_locator(const Tufted_cover& cover, const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : cover_(cover), triangles_(triangles), input_(cover.triangulation.input()),
      points_(engine(cover.triangulation).metric().points()), face_over_(triangles.size()),
      next_(input_.number_of_faces())
  {
    for (Face_index f : input_.faces())
      if (!cover.is_back[f.idx()] || !cover.is_half[f.idx()]) {
        next_[f.idx()] = face_over_[cover.face_of[f.idx()]];
        face_over_[cover.face_of[f.idx()]] = f;
      }
    for (std::size_t t = 0; t < triangles.size(); ++t)
      if (!face_over_[t].is_valid() && has_three_corners(t))
        flat_.push_back(t);
  }

  // \exception Invalid_point_error if a point does not lie in a triangle with an area or on an edge of one, or two
  //   consecutive ones not in that of the first
  Geodesic_source source(const std::vector<Point_in_triangle>& curve) const
  {
    Geodesic_source result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Point_in_triangle q = checked_point(curve[i], triangles_.size());
      const Surface_point p = point(q);
      if (i > 0) {
        const std::size_t before = with_area(curve[i - 1], q);
        if (before != curve[i - 1].triangle) {
          if (result.parts.back().size() == 1)
            result.parts.pop_back();
          result.parts.push_back({point(seen_from(before, checked_point(curve[i - 1], triangles_.size())))});
        }
        std::vector<Surface_point>& part = result.parts.back();
        const bool goes_on = lies_over(before, p, part.back());
        const Surface_point end = goes_on ? p : point(seen_from(before, q));
        if (is_cut(before))
          cross_parts(parts_of(before), end, part);
        else
          part.push_back(end);
        if (goes_on || i + 1 == curve.size())
          continue;
      }
      result.parts.push_back({p});
    }
    return result;
  }

private:
  // Whether a curve through a triangle, which has come to `last`, reaches p where the cover is glued to it.
  bool lies_over(std::size_t t, const Surface_point& p, const Surface_point& last) const
  {
    Triple c;
    return is_cut(t) ? find_in_triangle(parts_of(t), p, c)
                     : find_coordinates(
                         input_, face_over_[t].is_valid() ? input_.halfedge(face_over_[t]) : last.halfedge, p, c);
  }

  // The triangle of p; if it has no area, one that has, and both points on its border, if there is one.
  std::size_t with_area(const Point_in_triangle& p, const Point_in_triangle& q) const
  {
    const auto has = [&](std::size_t t, const Point_in_triangle& point) {
      bool result = true;
      for (std::size_t k = 0; k < 3; ++k)
        result = result && (point.coordinates[k] == 0 ||
                            std::any_of(triangles_[t].begin(), triangles_[t].end(), [&](std::uint32_t v) {
                              return cover_.representative[v] == cover_.representative[triangles_[point.triangle][k]];
                            }));
      return result;
    };
    for (std::size_t t = 0; t < triangles_.size() && !face_over_[p.triangle].is_valid(); ++t)
      if (face_over_[t].is_valid() && has(t, p) && has(t, q))
        return t;
    return p.triangle;
  }

  // A point in a triangle with the same corners, as far as they count.
  Point_in_triangle seen_from(std::size_t t, const Point_in_triangle& p) const
  {
    Point_in_triangle result{t, {0, 0, 0}};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto is_corner = [&](std::uint32_t v) {
        return cover_.representative[v] == cover_.representative[triangles_[p.triangle][k]];
      };
      const auto corner = std::find_if(triangles_[t].begin(), triangles_[t].end(), is_corner);
      if (p.coordinates[k] > 0 && (corner == triangles_[t].end() || !face_over_[t].is_valid()))
        throw Invalid_point_error(
          "a curve leads over triangle " + std::to_string(t) + " to a point of triangle " + std::to_string(p.triangle) +
          (face_over_[t].is_valid() ? " that is not in the former: give it a point at each edge that it crosses"
                                    : ", and the former has no area: give the curve points in other triangles"));
      if (p.coordinates[k] > 0)
        result.coordinates[std::size_t(corner - triangles_[t].begin())] = p.coordinates[k];
    }
    return result;
  }

  bool has_three_corners(std::size_t t) const
  {
    const auto [a, b, c] = triangles_[t];
    const std::vector<std::uint32_t>& r = cover_.representative;
    return r[a] != r[b] && r[b] != r[c] && r[c] != r[a];
  }
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

  // A point of a triangle without area lies at a vertex, or on an edge between corners of those with which it forms a
  // segment.
  Surface_point point_on_edge(const Point_in_triangle& p) const
  {
    std::set<std::uint32_t> at;
    for (std::size_t k = 0; k < 3; ++k)
      if (p.coordinates[k] > 0)
        at.insert(cover_.representative[triangles_[p.triangle][k]]);
    for (Halfedge_index h : input_.halfedges())
      if (at.size() == 1 && !input_.is_border(h) && cover_.vertex_of[input_.source(h).idx()] == *at.begin())
        return {h, {1, 0, 0}};
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
        x += p.coordinates[i] * (corner(p.triangle, i)[k] - points_[a][k]);
      const double part = x / (points_[b][k] - points_[a][k]);
      if (part >= 0 && part <= 1)
        return {h, {1 - part, part, 0}};
    }
    throw Invalid_point_error("triangle " + std::to_string(p.triangle) +
                              " has no area, and no other triangle has the edge where the point lies: give a point in "
                              "another one");
  }

  // In the part where it lies deepest.
  static Surface_point point_in_part(const std::vector<Part>& parts, const Triple& p)
  {
    Surface_point result;
    double largest = -std::numeric_limits<double>::infinity();
    for (const Part& part : parts) {
      const Triple c = coordinates_in_part(part.corners, p);
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
      if (find_coordinates(input_, part.first, p, c)) {
        for (std::size_t k = 0; k < 3; ++k)
          result[k] = c[0] * part.corners[0][k] + c[1] * part.corners[1][k] + c[2] * part.corners[2][k];
        return true;
      }
    return false;
  }

  // Goes on to a point in the triangle of the last one, with a point where a part is entered.
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
        Way way{&part, 0, 1, 3, coordinates_in_part(part.corners, start), coordinates_in_part(part.corners, target)};
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
      else if (Triple c; find_coordinates(input_, p.halfedge, curve.back(), c))
        curve.back() = {p.halfedge, c};
      else
        curve.back() = p;
      reached = way.end;
      last = way.part;
    }
    Triple c;
    if (last == nullptr || find_coordinates(input_, last->first, to, c))
      curve.push_back(to);
    else
      curve.push_back({last->first, inside(coordinates_in_part(last->corners, target))});
  }

  const Tufted_cover& cover_;
  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  const Delta_complex& input_;
  const Input_metric::Point_vector& points_;
  std::vector<std::size_t> flat_;            // the triangles with three corners, but without parts
  std::vector<Face_index> face_over_, next_; // the first part of each triangle, and the next one
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_COVER_LOCATOR_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Divided_triangles.h.

#include <CGAL/Intrinsic_triangulations/internal/distances/Divided_triangles.h>

#include "../connectivity/checked_coordinates.h"
#include "coordinates_in_part.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Divided_triangles::Divided_triangles(Points points, std::vector<Index_triangle> triangles)
  : points_(std::move(points)), triangles_(std::move(triangles)), number_of_given_(triangles_.size())
{
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    parts_.push_back({t, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
}

std::uint32_t Divided_triangles::vertex_at(const Point_in_triangle& given)
{
  const Point_in_triangle p = checked_point(given, number_of_given_);
  std::size_t deepest = 0;
  std::array<double, 3> coordinates{};
  double most = -std::numeric_limits<double>::infinity();
  const auto visit = [&](std::size_t i) {
    const std::array<double, 3> c = coordinates_in_part(parts_[i].corners, p.coordinates);
    if (const double least = *std::min_element(c.begin(), c.end()); least > most) {
      most = least;
      deepest = i;
      coordinates = c;
    }
  };
  visit(p.triangle);
  for (std::size_t i = number_of_given_; i < parts_.size(); ++i)
    if (parts_[i].triangle == p.triangle)
      visit(i);
  for (double& x : coordinates)
    x = (std::max)(0., x);
  return add_vertex(deepest, on_near_edges(coordinates));
}

std::uint32_t Divided_triangles::add_vertex(std::size_t i, const std::array<double, 3>& coordinates)
{
  const Index_triangle corners = triangles_[i];
  std::vector<std::size_t> on;
  for (std::size_t k = 0; k < 3; ++k)
    if (coordinates[k] > 0)
      on.push_back(k);
  if (on.size() == 1)
    return corners[on.front()];
  const auto v = std::uint32_t(points_.size());
  std::array<double, 3> place{0, 0, 0};
  for (std::size_t k : on)
    for (std::size_t x = 0; x < 3; ++x)
      place[x] += coordinates[k] * points_[corners[k]][x];
  points_.push_back(place);
  // All triangles with these corners: the one, or those at the edge.
  for (std::size_t f = 0, n = triangles_.size(); f < n; ++f) {
    std::array<double, 3> in_given{0, 0, 0};
    bool has_all = on.size() == 2 || f == i;
    for (std::size_t k : on) {
      const auto at = std::find(triangles_[f].begin(), triangles_[f].end(), corners[k]);
      has_all = has_all && at != triangles_[f].end();
      if (has_all)
        for (std::size_t x = 0; x < 3; ++x)
          in_given[x] += coordinates[k] * parts_[f].corners[std::size_t(at - triangles_[f].begin())][x];
    }
    if (!has_all)
      continue;
    const Index_triangle whole = triangles_[f];
    const Part part = parts_[f];
    bool is_first = true;
    for (std::size_t k : on) {
      Index_triangle t = whole;
      Part p = part;
      const auto at = std::size_t(std::find(t.begin(), t.end(), corners[k]) - t.begin());
      t[at] = v;
      p.corners[at] = in_given;
      if (is_first) {
        triangles_[f] = t;
        parts_[f] = p;
      } else {
        triangles_.push_back(t);
        parts_.push_back(p);
      }
      is_first = false;
    }
  }
  return v;
}

Point_in_triangle Divided_triangles::in_given_triangle(const Point_in_triangle& p) const
{
  Point_in_triangle result{parts_[p.triangle].triangle, {0, 0, 0}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      result.coordinates[k] += p.coordinates[i] * parts_[p.triangle].corners[i][k];
  return result;
}

Point_in_triangle checked_point(const Point_in_triangle& p, std::size_t number_of_triangles)
{
  if (p.triangle >= number_of_triangles)
    throw Invalid_point_error("there is no triangle " + std::to_string(p.triangle) + ": there are " +
                              std::to_string(number_of_triangles) + ", counted from 0");
  const std::optional<std::array<double, 3>> coordinates = checked_coordinates(p.coordinates);
  if (!coordinates)
    throw Invalid_point_error("the barycentric coordinates of a point in triangle " + std::to_string(p.triangle) +
                              " have to be finite and not negative, and one of them positive");
  return {p.triangle, on_near_edges(*coordinates)};
}

Point_in_triangle vertex_below_cover(const Tufted_cover& cover, const Points& points,
                                     const std::vector<Index_triangle>& triangles, std::size_t triangle, Vertex_index v)
{
  std::array<std::array<double, 3>, 3> places;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t corner = cover.representative[triangles[triangle][k]];
    if (corner == cover.vertex_of[v.idx()]) {
      Point_in_triangle result{triangle, {0, 0, 0}};
      result.coordinates[k] = 1;
      return result;
    }
    if (!points.empty())
      places[k] = points[corner];
  }
  return {triangle, coordinates_on_sides(places, points[cover.vertex_of[v.idx()]])};
}

Point_in_triangle point_below_cover(const Tufted_cover& cover, const Points& points,
                                    const std::vector<Index_triangle>& triangles, const Surface_point& p)
{
  const Delta_complex& input = cover.triangulation.input();
  Point_in_triangle result{cover.face_of[input.face(p.halfedge).idx()], {0, 0, 0}};
  Halfedge_index h = p.halfedge;
  for (std::size_t i = 0; i < 3; ++i, h = input.next(h))
    if (p.coordinates[i] > 0) {
      const Point_in_triangle corner = vertex_below_cover(cover, points, triangles, result.triangle, input.source(h));
      for (std::size_t k = 0; k < 3; ++k)
        result.coordinates[k] += p.coordinates[i] * corner.coordinates[k];
    }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of sides_of_curve.h.

#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include "../gluing/Cut_faces.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

// Of the triangles into which a curve divides the faces: whether they lie to its left.
std::vector<Sign> sides_of_triangles(const internal::Cut_faces& faces)
{
  const std::vector<std::array<std::uint32_t, 3>>& triangles = faces.triangles();
  const auto key = internal::Cut_faces::key;
  std::vector<Sign> of_triangle(triangles.size(), ZERO);
  std::unordered_set<std::uint64_t> seam;
  std::vector<std::uint32_t> open;
  bool has_left = false, has_right = false;
  const auto mark = [&](std::uint32_t t, Sign sign) {
    if (of_triangle[t] == ZERO)
      open.push_back(t);
    else if (of_triangle[t] != sign)
      throw Invalid_argument_error("the curve does not separate its left side from its right one, so distances have no "
                                   "sign: it has to be closed, or to lead from border to border, and to cut something "
                                   "off");
    of_triangle[t] = sign;
    (sign == POSITIVE ? has_left : has_right) = true;
  };
  const auto mark_beside = [&](std::uint32_t from, std::uint32_t to, Sign sign) {
    const auto beside = faces.sides().find(key(from, to));
    if (beside != faces.sides().end())
      mark(beside->second / 3, sign);
  };
  for (const auto& [from, to] : faces.seam()) {
    seam.insert({key(from, to), key(to, from)});
    mark_beside(from, to, POSITIVE);
    mark_beside(to, from, NEGATIVE);
  }
  if (faces.seam().empty())
    throw Invalid_argument_error("the curve has no length, and therefore no sides, so distances have no sign");
  if (!has_left || !has_right)
    throw Invalid_argument_error(std::string("nothing lies to the ") + (has_left ? "right" : "left") +
                                 " of the curve, which follows the border: distances have no sign");
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      if (seam.count(key(from, to)) == 0)
        mark_beside(to, from, of_triangle[t]);
    }
  }
  for (Sign& sign : of_triangle) // those of other components
    if (sign == ZERO)
      sign = POSITIVE;
  return of_triangle;
}

// The smallest barycentric coordinate of a point in a triangle; negative outside.
double depth_in_triangle(const internal::Cut_faces& faces, const Surface_point& p, std::uint32_t triangle)
{
  std::array<std::array<double, 3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = faces.coordinates(p.halfedge, faces.triangles()[triangle][i]);
  const auto area = [](const auto& a, const auto& b, const auto& c) {
    return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  };
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
    result = (std::min)(result, area(corners[i], corners[(i + 1) % 3], p.coordinates));
  return result / area(corners[0], corners[1], corners[2]);
}

} // namespace

std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<Surface_point>& curve)
{
  const internal::Cut_faces faces(input, {curve});
  const std::vector<Sign> of_triangle = sides_of_triangles(faces);
  std::vector<Sign> result(faces.number_of_vertices(), POSITIVE);
  for (std::size_t t = 0; t < of_triangle.size(); ++t)
    for (std::uint32_t v : faces.triangles()[t])
      result[v] = of_triangle[t];
  for (const auto& [from, to] : faces.seam())
    result[from] = result[to] = ZERO;
  result.resize(input.number_of_vertices());
  return result;
}

std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<Surface_point>& curve,
                                 const std::vector<Surface_point>& points)
{
  const internal::Cut_faces faces(input, {curve});
  const std::vector<Sign> of_triangle = sides_of_triangles(faces);
  std::vector<std::vector<std::uint32_t>> triangles_in(input.number_of_faces());
  for (std::uint32_t t = 0; t < of_triangle.size(); ++t)
    triangles_in[faces.input_faces()[t]].push_back(t);
  std::vector<Sign> result;
  for (const Surface_point& p : points) { // in the triangle in which it lies deepest
    double deepest = -std::numeric_limits<double>::infinity();
    result.push_back(POSITIVE);
    for (std::uint32_t t : triangles_in[input.face(p.halfedge).idx()]) {
      const double depth = depth_in_triangle(faces, p, t);
      if (depth > deepest) {
        deepest = depth;
        result.back() = of_triangle[t];
      }
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

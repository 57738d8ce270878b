// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Conformal_map.h.

#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include "../connectivity/checked_coordinates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace {

// The barycentric coordinates of p in a triangle; the least is negative outside.
std::array<double, 3> planar_coordinates(const std::array<Conformal_map::Point, 3>& t, const Conformal_map::Point& p)
{
  std::array<Conformal_map::Point, 3> d; // from p
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = {t[i][0] - p[0], t[i][1] - p[1]};
    largest = (std::max)({largest, std::abs(d[i][0]), std::abs(d[i][1])});
  }
  std::array<double, 3> result;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto &q = d[(i + 1) % 3], &r = d[(i + 2) % 3];
    sum += result[i] = q[0] / largest * (r[1] / largest) - q[1] / largest * (r[0] / largest);
  }
  for (double& x : result)
    x = sum > 0 ? x / sum : -std::numeric_limits<double>::infinity();
  return result;
}

// The point with these barycentric coordinates.
Conformal_map::Point planar_point(const std::array<Conformal_map::Point, 3>& t, const std::array<double, 3>& x)
{
  return {x[0] * t[0][0] + x[1] * t[1][0] + x[2] * t[2][0], x[0] * t[0][1] + x[1] * t[1][1] + x[2] * t[2][1]};
}

// The triangle for which `coordinates` gives the largest least coordinate.
template <class Coordinates>
std::pair<std::size_t, std::array<double, 3>> best_triangle(std::size_t first, std::size_t end,
                                                            const Coordinates& coordinates)
{
  std::pair<std::size_t, std::array<double, 3>> best{first, {1, 0, 0}};
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = first; i < end; ++i) {
    const std::array<double, 3> x = coordinates(i);
    const double least = (std::min)({x[0], x[1], x[2]});
    if (least > largest) {
      largest = least;
      best = {i, x};
    }
  }
  for (double& x : best.second)
    x = (std::max)(x, 0.);
  best.second = internal::with_sum_one(best.second);
  return best;
}

} // namespace

Conformal_map::Point Conformal_map::to_plane(const Surface_point& point) const
{
  const std::array<double, 3> at = internal::checked_coordinates(input, point);
  const Face_index f = input.face(point.halfedge);
  if (first_of_face[f.idx()] == first_of_face[f.idx() + 1]) // all of it has one image, up to rounding
    return input_uv[input.halfedge(f).idx()];
  const auto [i, x] = best_triangle(first_of_face[f.idx()], first_of_face[f.idx() + 1], [&](std::size_t j) {
    return planar_coordinates(in_face(j), {at[1], at[2]});
  });
  return planar_point(uv[i], x);
}

Surface_point Conformal_map::to_surface(const Point& point) const
{
  if (!std::isfinite(point[0]) || !std::isfinite(point[1]) || triangles.empty())
    throw Invalid_point_error("a coordinate is not finite, or the map has no triangle");
  const auto [i, x] =
    best_triangle(0, triangles.size(), [&](std::size_t j) { return planar_coordinates(uv[j], point); });
  const Face_index f = input_faces[i];
  Surface_point result{input.halfedge(f), {0, 0, 0}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::array<double, 3> y = coordinates_in_face(places[triangles[i][k]], f);
    for (std::size_t c = 0; c < 3; ++c)
      result.coordinates[c] += x[k] * y[c];
  }
  return result;
}

// The coordinates of a point in a face or on its border, relative to `input.halfedge(f)`.
std::array<double, 3> Conformal_map::coordinates_in_face(const Surface_point& p, Face_index f) const
{
  std::array<double, 3> result{1, 0, 0};
  internal::find_coordinates(input, input.halfedge(f), p, result);
  return result;
}

Conformal_map::Point Conformal_map::in_face(const Surface_point& p, Face_index f) const
{
  const std::array<double, 3> x = coordinates_in_face(p, f);
  return {x[1], x[2]};
}

std::array<Conformal_map::Point, 3> Conformal_map::in_face(std::size_t triangle) const
{
  const auto& [a, b, c] = triangles[triangle];
  const Face_index f = input_faces[triangle];
  return {in_face(places[a], f), in_face(places[b], f), in_face(places[c], f)};
}

Conformal_map::Point Conformal_map::extended(std::size_t triangle, const Point& p) const
{
  return planar_point(uv[triangle], planar_coordinates(in_face(triangle), p));
}

} // namespace CGAL::Intrinsic_triangulations

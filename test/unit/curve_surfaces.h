// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces and lines for tests of distances from curves.

#ifndef IDT_TEST_CURVE_SURFACES_H
#define IDT_TEST_CURVE_SURFACES_H

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace curve_surfaces {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point = std::array<double, 3>;
using Points = std::vector<Point>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Curve = std::vector<IT::Surface_point>;

struct Mesh
{
  Points points;
  Triangles triangles;

  Triangulation Delaunay() const
  {
    Triangulation result(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    IT::flip_to_Delaunay(result);
    return result;
  }
};

// A grid of m by n squares, each cut in two.
inline Mesh grid(std::uint32_t m, std::uint32_t n, const std::function<Point(double, double)>& place)
{
  Mesh result;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= m; ++x)
      result.points.push_back(place(x, y));
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < m; ++x) {
      const std::uint32_t v = y * (m + 1) + x;
      result.triangles.push_back({v, v + 1, v + m + 2});
      result.triangles.push_back({v, v + m + 2, v + m + 1});
    }
  return result;
}

// Inner vertices are moved at random, so that Delaunay edges cross those of the input.
inline Mesh shaken_plane(std::uint32_t m, std::uint32_t n)
{
  std::mt19937 random(3);
  const auto shift = [&random] { return 0.6 * (double(random() % 1024) / 1024 - 0.5); };
  return grid(m, n, [&](double x, double y) -> Point {
    const bool is_inner = x > 0 && x < m && y > 0 && y < n;
    const double dx = shift(), dy = shift();
    return is_inner ? Point{x + dx, y + dy, 0} : Point{x, y, 0};
  });
}

inline Mesh hills(std::uint32_t n, double height)
{
  std::mt19937 random(7);
  return grid(n, n, [&](double x, double y) -> Point { return {x, y, height * double(random() % 1024) / 1024}; });
}

// The straight line from a vertex.
inline Curve line(const Triangulation& triangulation, IT::Vertex_index v, double angle, double length)
{
  const IT::Halfedge_index h = triangulation.input().opposite(triangulation.input().halfedge(v));
  return IT::trace_geodesic(triangulation, IT::direction_at_vertex(triangulation, h, angle), length).points;
}

} // namespace curve_surfaces

#endif // IDT_TEST_CURVE_SURFACES_H

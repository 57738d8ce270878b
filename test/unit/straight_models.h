// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Models of which tests make straight triangles, and how far these are away, by sampling.

#ifndef IDT_TEST_STRAIGHT_MODELS_H
#define IDT_TEST_STRAIGHT_MODELS_H

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace straight_models {

namespace IT = CGAL::Intrinsic_triangulations;

using Kernel = CGAL::Simple_cartesian<double>;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Model
{
  Points points;
  Triangles triangles;

  IT::Delta_complex complex() const { return IT::make_Delta_complex_from_triangles(points.size(), triangles); }
  Triangulation triangulation() const { return Triangulation(complex(), points); }
};

inline Model box(double y, double z)
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, y, 0}, {1, y, 0}, {0, 0, z}, {1, 0, z}, {0, y, z}, {1, y, z}},
          {{0, 2, 3},
           {0, 3, 1},
           {4, 5, 7},
           {4, 7, 6},
           {0, 1, 5},
           {0, 5, 4},
           {2, 6, 7},
           {2, 7, 3},
           {0, 4, 6},
           {0, 6, 2},
           {1, 3, 7},
           {1, 7, 5}}};
}

// A graph over a grid of n by n squares.
template <class Height>
Model graph(std::uint32_t n, const Height& height)
{
  Model result;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j)
      result.points.push_back({double(i) / n, double(j) / n, height(double(i) / n, double(j) / n)});
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      result.triangles.push_back({a, b, b + 1});
      result.triangles.push_back({a, b + 1, a + 1});
    }
  return result;
}

inline IT::Refinement_report refine(Triangulation& t, const std::vector<bool>& is_kept, double longest)
{
  const auto map = boost::make_function_property_map<IT::Edge_index, bool>(
    [&](IT::Edge_index e) { return e.idx() < is_kept.size() && is_kept[e.idx()]; });
  return IT::refine_Delaunay(
    t, CGAL::parameters::minimum_angle(25).maximum_edge_length(longest).edge_is_constrained_map(map));
}

// By the closest point of each triangle, from the definition of that point.
inline double distance(const std::array<double, 3>& from, const Points& points, const Triangles& triangles)
{
  const Kernel::Point_3 p(from[0], from[1], from[2]);
  double result = std::numeric_limits<double>::infinity();
  for (const auto& t : triangles) {
    std::array<Kernel::Point_3, 3> c;
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = {points[t[i]][0], points[t[i]][1], points[t[i]][2]};
    for (std::size_t i = 0; i < 3; ++i)
      result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, Kernel::Segment_3(c[i], c[(i + 1) % 3]))));
    const Kernel::Plane_3 plane(c[0], c[1], c[2]);
    const Kernel::Point_3 foot = plane.projection(p);
    const Kernel::Vector_3 normal = plane.orthogonal_vector();
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i)
      is_inside = is_inside && CGAL::cross_product(c[(i + 1) % 3] - c[i], foot - c[i]) * normal >= 0;
    if (is_inside)
      result = (std::min)(result, std::sqrt(CGAL::squared_distance(p, foot)));
  }
  return result;
}

inline double farthest_sample(const Points& points, const Triangles& triangles, const Points& others,
                              const Triangles& other_triangles)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  double result = 0;
  for (const auto& t : triangles)
    for (int sample = 0; sample < 4; ++sample) {
      double u = uniform(random), v = uniform(random);
      if (u + v > 1)
        u = 1 - u, v = 1 - v;
      std::array<double, 3> p{};
      for (std::size_t i = 0; i < 3; ++i)
        p[i] = (1 - u - v) * points[t[0]][i] + u * points[t[1]][i] + v * points[t[2]][i];
      result = (std::max)(result, distance(p, others, other_triangles));
    }
  return result;
}

} // namespace straight_models

#endif // IDT_TEST_STRAIGHT_MODELS_H

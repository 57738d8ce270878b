// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces of the garden: as small, as bad and as extreme as possible.

#ifndef IDT_TEST_PROPERTY_GARDEN_SURFACES_H
#define IDT_TEST_PROPERTY_GARDEN_SURFACES_H

#include "property/garden.h"

#include "samples/sample_surfaces.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace garden {

struct Named_surface
{
  std::string name;
  Surface surface;
};

inline samples::Indexed_triangles scaled(samples::Indexed_triangles surface, double factor)
{
  for (std::array<double, 3>& p : surface.points)
    for (double& x : p)
      x *= factor;
  return surface;
}

inline samples::Indexed_triangles tetrahedron()
{
  return {{{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}, {0.5, 0.25, 1}}, {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}}};
}

inline samples::Indexed_triangles hinge(double height)
{
  return {{{0, 0, 0}, {8, 0, 0}, {3, height, 0}, {5, -height, 0}}, {{{0, 1, 2}}, {{0, 3, 1}}}};
}

// Disjoint copies, side by side.
inline samples::Indexed_triangles copies(const samples::Indexed_triangles& surface, unsigned number)
{
  samples::Indexed_triangles result;
  for (unsigned copy = 0; copy < number; ++copy) {
    const auto first = std::uint32_t(result.points.size());
    for (const std::array<double, 3>& p : surface.points)
      result.points.push_back({p[0] + 2. * copy, p[1], p[2]});
    for (const std::array<std::uint32_t, 3>& t : surface.triangles)
      result.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return result;
}

// A vertex of that degree, raised over a regular polygon.
inline samples::Indexed_triangles fan(std::uint32_t degree)
{
  samples::Indexed_triangles result{{{0, 0, 0.5}}, {}};
  for (std::uint32_t i = 0; i < degree; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / degree;
    result.points.push_back({std::cos(angle), std::sin(angle), 0});
    result.triangles.push_back({0, i + 1, (i + 1) % degree + 1});
  }
  return result;
}

inline samples::Indexed_triangles Moebius_strip(unsigned n = 6)
{
  samples::Indexed_triangles result;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    for (int side : {-1, 1}) {
      const double radius = 2 + side * 0.5 * std::cos(angle / 2);
      result.points.push_back({radius * std::cos(angle), radius * std::sin(angle), side * 0.5 * std::sin(angle / 2)});
    }
    const bool is_last = i + 1 == n; // where the sides are exchanged
    const std::uint32_t a = 2 * i, b = a + 1, c = is_last ? 1 : a + 2, d = is_last ? 0 : a + 3;
    result.triangles.push_back({a, c, b});
    result.triangles.push_back({b, c, d});
  }
  return result;
}

inline std::vector<Named_surface> garden_surfaces()
{
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<Named_surface> result{
    {"one triangle", samples::Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {0.25, 1, 0}}, {{{0, 1, 2}}}}},
    {"hinge with a flip", hinge(1)},
    {"square, a tie",
     samples::Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{{0, 1, 2}}, {{0, 2, 3}}}}},
    {"tetrahedron", tetrahedron()},
    {"two triangles, a sphere", samples::Glued_triangles{2, {{0, 5}, {1, 4}, {2, 3}}, {3, 4, 5, 5, 4, 3}}},
    {"pillow", samples::pillow(20)},
    {"one-vertex torus", samples::one_vertex_torus()},
    {"sheared torus", samples::sheared_one_vertex_torus(7.3)},
    {"triangle glued to itself", samples::self_glued_triangle()},
    {"sphere of two cones", samples::self_glued_sphere()},
    {"random gluing", samples::random_gluing(20, 5, false, true)},
    {"random open gluing", samples::random_gluing(21, 6, true)},
    {"Moebius strip", Moebius_strip()},
    {"50 tetrahedra", copies(tetrahedron(), 50)},
    {"20 triangles, all border", copies({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}}, 20)},
    {"vertex of degree 1000", fan(1000)},
    {"needle", samples::Indexed_triangles{{{0, 0, 0}, {1e-9, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}}},
    {"needle hinge", hinge(1e-9)},
    {"cap", samples::cap()},
    {"cap without area", samples::cap(0)},
    {"three points on a line", samples::Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{{0, 1, 2}}}}},
    {"edge of length zero", samples::Indexed_triangles{{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}}},
    {"coordinates of 1e150", scaled(tetrahedron(), 1e150)},
    {"coordinates of 1e-150", scaled(tetrahedron(), 1e-150)},
    {"disk of 1e150", scaled(samples::bumpy_dome(8, 5), 1e150)},
    {"disk of 1e-150", scaled(samples::bumpy_dome(8, 5), 1e-150)},
    {"coordinates of 1e300", scaled(tetrahedron(), 1e300)},
    {"1e150 beside 1e-150", samples::Indexed_triangles{{{0, 0, 0}, {1e150, 0, 0}, {0, 1e-150, 0}}, {{{0, 1, 2}}}}},
    {"lengths of 1e150", samples::one_vertex_torus(1e150, 1.25e150, 2e150)},
    {"lengths of 1e-150", samples::one_vertex_torus(1e-150, 1.25e-150, 2e-150)},
    {"lengths 1, 1, 3", samples::Glued_triangles{1, {}, {1, 1, 3}}},
    {"lengths 1, 1, 2", samples::Glued_triangles{1, {}, {1, 1, 2}}},
    {"infinite coordinate", samples::Indexed_triangles{{{0, 0, 0}, {infinity, 0, 0}, {0, 1, 0}}, {{{0, 1, 2}}}}},
    {"NaN for a length", samples::Glued_triangles{1, {}, {1, infinity - infinity, 1}}},
    {"vertex without a face", samples::Indexed_triangles{{{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {0, 1, 0}}, {{{0, 2, 3}}}}},
    {"no face", samples::Indexed_triangles{{{0, 0, 0}}, {}}},
    {"edge with three faces", samples::Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}},
                                                         {{{0, 1, 2}}, {{1, 0, 3}}, {{0, 1, 4}}}}},
    {"two fans at a vertex",
     samples::Indexed_triangles{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{{0, 1, 2}}, {{0, 3, 4}}}}},
    {"bumpy sphere", samples::bumpy_sphere(10, 7)},
    {"bumpy dome", samples::bumpy_dome(10, 6)},
    {"disk with spike", samples::disk_with_spike(8, 6)},
    {"bad torus", samples::bad_torus(8, 8)},
    {"helical tube", samples::helical_tube(30)},
    {"prism", samples::prism(12)},
    {"Schwarz lantern", samples::Schwarz_lantern(6, 12)},
    {"sliver sheet", samples::sliver_sheet(8)},
    {"strip", samples::strip(40, 12)},
    {"random diagonal grid", samples::random_diagonal_grid(6, 6)},
    {"sheared grid", samples::sheared_grid(6, 6)},
    {"latitude-longitude sphere", samples::latitude_longitude_sphere(8, 6)}};
  return result;
}

} // namespace garden

#endif // IDT_TEST_PROPERTY_GARDEN_SURFACES_H

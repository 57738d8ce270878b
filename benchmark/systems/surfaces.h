// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The surfaces for all systems: samples of this package, and families of bad triangles, ties, extreme lengths and
// gluings, each with a parameter that goes from harmless to hard.

#ifndef IDT_BENCHMARK_SYSTEMS_SURFACES_H
#define IDT_BENCHMARK_SYSTEMS_SURFACES_H

#include "own_triangulation.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace systems {

struct Named_surface
{
  std::string name;
  Surface surface;
};

inline Surface surface_of(const samples::Indexed_triangles& mesh)
{
  Surface surface;
  surface.number_of_vertices = mesh.points.size();
  surface.points = mesh.points;
  surface.triangles = triangles_of(IT::make_Delta_complex_from_triangles(mesh.points.size(), mesh.triangles));
  return surface;
}

inline Surface surface_of(const samples::Glued_triangles& gluing)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
  Surface surface;
  surface.number_of_vertices = complex.number_of_vertices();
  surface.triangles = triangles_of(complex);
  surface.triangles.lengths = gluing.side_lengths;
  return surface;
}

namespace internal {

inline samples::Indexed_triangles scaled(samples::Indexed_triangles mesh, double factor)
{
  for (std::array<double, 3>& p : mesh.points)
    for (double& x : p)
      x *= factor;
  return mesh;
}

// Far from the origin, where coordinates have few digits left.
inline samples::Indexed_triangles moved(samples::Indexed_triangles mesh, double by)
{
  for (std::array<double, 3>& p : mesh.points)
    for (double& x : p)
      x += by;
  return mesh;
}

inline samples::Indexed_triangles rotated(samples::Indexed_triangles mesh, std::uint64_t seed)
{
  samples::rotate_sample(mesh.points, seed);
  return mesh;
}

// Needles around one vertex, with their bases on a circle or on a spiral of a few turns.
inline samples::Indexed_triangles fan(std::size_t n, double height)
{
  samples::Indexed_triangles mesh;
  mesh.points.push_back({0, 0, height});
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * double(i) / double(n), radius = 1 + 0.3 * std::sin(7 * angle);
    mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  for (std::size_t i = 0; i < n; ++i)
    samples::append_triangle(mesh, 0, 1 + i, 1 + (i + 1) % n);
  return mesh;
}

// The surface of a box of unit cubes, each square in two triangles, as voxel models have it: every diagonal is a tie.
inline samples::Indexed_triangles box(int n, std::uint64_t seed)
{
  samples::Indexed_triangles mesh;
  samples::Sample_random random(seed);
  std::map<std::array<int, 3>, std::size_t> number_of;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = number_of.insert({p, mesh.points.size()});
    if (is_new)
      mesh.points.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (bool is_upper : {false, true})
      for (int u = 0; u < n; ++u)
        for (int v = 0; v < n; ++v) {
          std::array<std::size_t, 4> corner{};
          for (int i = 0; i < 4; ++i) {
            std::array<int, 3> p{};
            p[axis] = is_upper ? n : 0;
            p[(axis + 1) % 3] = u + (i == 1 || i == 2);
            p[(axis + 2) % 3] = v + (i >= 2);
            corner[std::size_t(is_upper ? i : 3 - i)] = vertex(p);
          }
          const std::size_t k = random.coin();
          samples::append_triangle(mesh, corner[k], corner[k + 1], corner[k + 2]);
          samples::append_triangle(mesh, corner[k], corner[k + 2], corner[(k + 3) % 4]);
        }
  return mesh;
}

// A tetrahedron whose apex is above one corner of its base.
inline samples::Indexed_triangles tetrahedron(double height)
{
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.1, height}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

} // namespace internal

inline std::vector<Named_surface> generated_surfaces()
{
  using namespace internal;
  std::vector<Named_surface> result;
  const auto add = [&result](const std::string& name, const auto& mesh) { result.push_back({name, surface_of(mesh)}); };
  for (const samples::Sample& sample : samples::sample_names())
    std::visit([&](const auto& mesh) { add(sample.name, mesh); }, samples::make_sample(sample.name));

  // Smooth shapes.
  add("bumpy-sphere-40000", samples::bumpy_sphere(200, 101));
  add("bad-torus-80000", samples::bad_torus(200, 200));
  add("torus-40000", samples::torus(200, 100));
  add("latitude-longitude-1000x4", samples::latitude_longitude_sphere(1000, 4));
  add("bumpy-dome-twisted", samples::bumpy_dome(24, 40, 0.2, 25));
  add("spike-100", samples::disk_with_spike(40, 25, 100, 0.02));
  add("lantern-8x16", samples::Schwarz_lantern(8, 16));
  add("lantern-16x1024", samples::Schwarz_lantern(16, 1024));
  add("tetrahedron", tetrahedron(1));
  add("tetrahedron-needle", tetrahedron(1e8));
  add("fan-1000", fan(1000, 0.5));
  add("fan-1000-needles", fan(1000, 1e6));

  // Ties, exact and broken by rounding.
  add("prism-5", samples::prism(5));
  add("prism-80-rotated", samples::prism(80, 1));
  add("prism-300-rotated", samples::prism(300, 2));
  add("grid-rotated", samples::random_diagonal_grid(40, 40, 1, 1));
  add("grid-45000", samples::random_diagonal_grid(150, 150, 1));
  add("grid-45000-rotated", samples::random_diagonal_grid(150, 150, 1, 3));
  add("box-20", box(20, 1));
  add("box-20-rotated", rotated(box(20, 1), 1));
  add("box-80", box(80, 2));

  // Many flips.
  add("sheared-grid-0.3", samples::sheared_grid(40, 40, 0.3));
  add("sheared-grid-20", samples::sheared_grid(40, 40, 20));
  add("sheared-grid-200", samples::sheared_grid(20, 20, 200));
  add("sheared-grid-rotated", rotated(samples::sheared_grid(40, 40, 5), 1));
  add("strip-100", samples::strip(100, 20));
  add("strip-thin", samples::strip(1000, 60, 1e-3));
  add("strip-wide", samples::strip(1000, 60, 30));
  add("pillow-20", samples::pillow(20));
  add("pillow-100-rotated", rotated(samples::pillow(100), 1));
  add("pillow-100-thin", samples::pillow(100, 1e-4));
  add("pillow-1000", samples::pillow(1000));
  add("tube-1", samples::helical_tube(60, 1));
  add("tube-1000", samples::helical_tube(60, 1000));
  add("tube-1e6", samples::helical_tube(60, 1e6));

  // Caps and slivers.
  add("cap-0", samples::cap(0));
  add("cap-0-rotated", samples::cap(0, 1));
  add("cap-1e-5", samples::cap(1e-5));
  add("cap-1e-10-rotated", samples::cap(1e-10, 1));
  add("cap-1e-15", samples::cap(1e-15));
  add("cap-1e-15-rotated", samples::cap(1e-15, 2));
  add("slivers-1e-3", samples::sliver_sheet(40, 1e-3, 1e-3));
  add("slivers-1e-6", samples::sliver_sheet(40, 1e-6, 1e-6));
  add("slivers-1e-12", samples::sliver_sheet(40, 1e-12, 1e-12));

  // Units, and few digits.
  add("sphere-unit-1e-20", scaled(samples::bumpy_sphere(40, 21), 1e-20));
  add("sphere-unit-1e20", scaled(samples::bumpy_sphere(40, 21), 1e20));
  add("sphere-unit-1e-120", scaled(samples::bumpy_sphere(40, 21), 1e-120));
  add("sphere-unit-1e120", scaled(samples::bumpy_sphere(40, 21), 1e120));
  add("sphere-moved-1e8", moved(samples::bumpy_sphere(40, 21), 1e8));
  add("sphere-moved-1e12", moved(samples::bumpy_sphere(40, 21), 1e12));

  // Gluings.
  add("one-vertex-torus-sheared-10", samples::sheared_one_vertex_torus(10));
  add("one-vertex-torus-sheared-1000", samples::sheared_one_vertex_torus(1000));
  add("one-vertex-torus-sheared-50000", samples::sheared_one_vertex_torus(50000));
  add("self-glued-sphere", samples::self_glued_sphere(1, 5, 1.9));
  add("gluing-20", samples::random_gluing(20, 1, false, true));
  add("gluing-300", samples::random_gluing(300, 2, false, true));
  add("gluing-300-border", samples::random_gluing(300, 3, true, true));
  add("gluing-5000", samples::random_gluing(5000, 4, false, true));
  return result;
}

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_SURFACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the matrices of the Laplace-Beltrami operator cost: from a finished intrinsic Delaunay
// triangulation, and from the mesh; beside CGAL's Heat_method_3, which makes the triangulation
// alone.
//
//   operators_benchmark [MESH...]
//
// Without MESH, table1/horse.off from the folder in the environment variable IDT_DATA_DIR, or from
// shared/data beside the checkout, is taken, the sample bumpy sphere, and a grid whose triangles are
// stretched by 50, so that edges are flipped many times. Each round runs every method once. The output is the median of the rounds in nanoseconds an edge, and the
// ratio to Heat_method_3, the number to use on a busy machine.

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

constexpr std::size_t rounds = 11;

// The result is destroyed after the clock has stopped.
template <class Function>
double seconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  const auto result = function();
  const auto end = std::chrono::steady_clock::now();
  (void)result;
  return std::chrono::duration<double>(end - start).count();
}

double seconds_of_heat_method(const Mesh& mesh)
{
  const auto start = std::chrono::steady_clock::now();
  const CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh> triangulation(mesh);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void measure(const std::string& name, const Mesh& mesh)
{
  const auto triangulation = IT::intrinsic_Delaunay_triangulation(mesh).triangulation;
  const std::vector<std::pair<const char*, std::function<double()>>> methods = {
    {"Heat_method_3, triangulation alone", [&] { return seconds_of_heat_method(mesh); }},
    {"stiffness_matrix", [&] { return seconds([&] { return IT::stiffness_matrix(triangulation); }); }},
    {"cotangent_weights", [&] { return seconds([&] { return IT::cotangent_weights(triangulation); }); }},
    {"lumped_mass_matrix", [&] { return seconds([&] { return IT::lumped_mass_matrix(triangulation); }); }},
    {"Galerkin_mass_matrix", [&] { return seconds([&] { return IT::Galerkin_mass_matrix(triangulation); }); }},
    {"mesh -> triangulation, L, M", [&] { return seconds([&] { return IT::intrinsic_Delaunay_Laplacian(mesh); }); }}};
  std::vector<std::vector<double>> times(methods.size());
  for (std::size_t round = 0; round <= rounds; ++round)
    for (std::size_t i = 0; i < methods.size(); ++i) {
      const double time = methods[i].second();
      if (round > 0) // in the first, caches and memory are cold
        times[i].push_back(time);
    }
  std::printf("%s, %zu edges\n", name.c_str(), std::size_t(mesh.number_of_edges()));
  double reference = 0;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    std::nth_element(times[i].begin(), times[i].begin() + rounds / 2, times[i].end());
    const double median = times[i][rounds / 2];
    reference = i == 0 ? median : reference;
    std::printf("  %-36s %8.1f ns an edge  %6.3f of Heat_method_3\n", methods[i].first,
                1e9 * median / double(mesh.number_of_edges()), median / reference);
  }
}

// A grid of stretched and slightly bent squares with random corners, cut into triangles.
Mesh stretched_grid(std::size_t n, double stretch)
{
  samples::Indexed_triangles grid;
  std::mt19937_64 random(1);
  const auto moved = [&](std::size_t i) {
    return i == 0 || i == n - 1 ? double(i) : double(i) + 0.5 * (double(random() >> 11) * 0x1p-53 - 0.5);
  };
  const double size = double(n);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const double x = moved(i), y = moved(j);
      grid.points.push_back({stretch * x, y, 0.1 * size * std::sin(6 * x / size) * std::cos(6 * y / size)});
    }
  for (std::size_t j = 0; j + 1 < n; ++j)
    for (std::size_t i = 0; i + 1 < n; ++i) {
      const auto a = std::uint32_t(j * n + i), c = std::uint32_t(a + n);
      grid.triangles.push_back({a, a + 1, c + 1});
      grid.triangles.push_back({a, c + 1, c});
    }
  return mesh_of(grid);
}

} // namespace

int main(int argc, char** argv)
{
  keep_freed_memory();
  for (int i = 1; i < argc; ++i)
    measure(std::filesystem::path(argv[i]).stem().string(), read_mesh(argv[i]));
  if (argc > 1)
    return EXIT_SUCCESS;
  if (const std::optional<Mesh> horse = read_horse())
    measure("horse", *horse);
  measure("bumpy_sphere_700x351", mesh_of(samples::bumpy_sphere(700, 351)));
  measure("stretched_grid_317x317", stretched_grid(317, 50));
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What calls of the Python package cost without Python: benchmark/python_overhead runs it and compares.
//
//   python_calls CASE SIDE   CASE is laplacian, triangulation or flips, on a sheared grid of SIDE x SIDE vertices
//
// Prints the milliseconds of a call for each line that it reads, and last by how many bytes memory grew at most.

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <sys/resource.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Clock = std::chrono::steady_clock;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

long peak_bytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: python_calls laplacian|triangulation|flips SIDE\n";
    return 2;
  }
  const std::string name = argv[1];
  const auto n = std::uint32_t(std::atoi(argv[2]));
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x)
      points.push_back({x + 0.6 * y, double(y), 0});
  for (std::uint32_t y = 0; y + 1 < n; ++y)
    for (std::uint32_t x = 0; x + 1 < n; ++x) {
      const std::uint32_t a = y * n + x;
      triangles.push_back({a, a + 1, a + n + 1});
      triangles.push_back({a, a + n + 1, a + n});
    }
  const long before = peak_bytes();
  std::string line;
  while (std::getline(std::cin, line)) {
    const Clock::time_point start = Clock::now();
    double checked = 0;
    Clock::time_point end;
    if (name == "laplacian") {
      const IT::Tufted_Laplacian result = IT::tufted_Laplacian(points, triangles);
      end = Clock::now();
      checked = result.mass.coeff(0, 0);
    } else {
      Triangulation t(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
      if (name == "flips")
        IT::flip_to_Delaunay(t);
      end = Clock::now();
      checked = t.length(IT::Edge_index(0));
    }
    std::cout << std::chrono::duration<double, std::milli>(end - start).count() << std::endl;
    if (!(checked > 0))
      return 1;
  }
  std::cout << peak_bytes() - before << std::endl;
}

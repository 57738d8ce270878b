// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What validation costs beside reading: `is_clean()`, which the command asks for each
// mesh, and `examine_polygons()`, which says what is wrong. The goal is a tenth.
//
//   validation_benchmark FILE...
//
// Times are processor times of one thread, each the median of seven rounds.

#include "input/read_surface.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <exception>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Function>
double seconds(const Function& function)
{
  std::vector<double> times;
  for (int round = 0; round < 7; ++round) {
    const std::clock_t start = std::clock();
    function();
    times.push_back(double(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::nth_element(times.begin(), times.begin() + 3, times.end());
  return times[3];
}

void measure(const char* path)
{
  const idt::Surface_input input = idt::read_surface(path);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(input.points.size(), input.triangles);
  const double reading = seconds([&] { idt::read_surface(path); });
  const double question = seconds([&] { IT::is_clean(complex, input.points); });
  const double examination = seconds([&] { idt::examine(input); });
  std::printf("%s: %zu edges; reading %.4f s, validation %.4f s (%.3f), examination %.4f s (%.3f)\n", path,
              std::size_t(complex.number_of_edges()), reading, question, question / reading, examination,
              examination / reading);
}

} // namespace

int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
    try {
      measure(argv[i]);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      return 2;
    }
}

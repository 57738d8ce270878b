// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time and memory for each edge, from small surfaces to large ones.
//
//   scaling [SIDE...]   tori of SIDE by SIDE vertices (100, 316, 1000, 3162)
//
// Memory is the peak of the resident set, less what was resident when the mesh was ready: all that
// intrinsic_Delaunay_triangulation() takes beside its input. (Linux; elsewhere it is not printed.)

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// In bytes; 0 if unknown.
double resident(const char* what)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.rfind(what, 0) == 0)
      return 1024 * std::atof(line.c_str() + std::string(what).size());
  return 0;
}

template <class Traits, class ConcurrencyTag>
void measure(const char* name, const Mesh& mesh)
{
  const double edges = double(mesh.number_of_edges());
  const int rounds = edges < 1e6 ? 7 : 3;
  std::vector<double> seconds;
  double peak = 0, flips = 0;
  for (int round = 0; round < rounds; ++round) {
    std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins anew
    const double before = resident("VmRSS:");
    const auto start = std::chrono::steady_clock::now();
    const auto t = IT::intrinsic_Delaunay_triangulation<ConcurrencyTag>(mesh, CGAL::parameters::geom_traits(Traits()));
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    flips = double(t.report.flips);
    peak = (std::max)(peak, resident("VmHWM:") - before);
  }
  std::nth_element(seconds.begin(), seconds.begin() + rounds / 2, seconds.end());
  std::printf("| %zu | %s | %.0f | %.2f | %.1f | %.0f |\n", std::size_t(mesh.number_of_vertices()), name, edges,
              flips / edges, 1e9 * seconds[std::size_t(rounds / 2)] / edges, peak / edges);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  std::vector<int> sides;
  for (int i = 1; i < argc; ++i)
    sides.push_back(std::atoi(argv[i]));
  if (sides.empty())
    sides = {100, 316, 1000, 3162};
  std::printf("| vertices | | edges | flips an edge | ns an edge | bytes an edge |\n"
              "| ---: | --- | ---: | ---: | ---: | ---: |\n");
  for (int side : sides) {
    const Mesh mesh = mesh_of(samples::bad_torus(std::size_t(side), std::size_t(side)));
    measure<IT::Edge_length_traits<double>, CGAL::Sequential_tag>("double", mesh);
    measure<IT::Filtered_edge_length_traits, CGAL::Sequential_tag>("exact", mesh);
#ifdef CGAL_LINKED_WITH_TBB
    measure<IT::Filtered_edge_length_traits, CGAL::Parallel_tag>("exact, Parallel_tag", mesh);
#endif
  }
}

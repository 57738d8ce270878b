// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it costs to triangulate gluings that are twisted very far.
//
//   twists
//
// For each surface the median time of 101 calls of intrinsic_Delaunay_triangulation(), from the gluing in memory to the
// finished triangulation.

#include "samples/sample_exact_gluings.h"

#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

void measure(const char* name, const IT::Exact_gluing& gluing)
{
  std::vector<double> times;
  std::string flips, twists, status;
  for (int round = 0; round < 101; ++round) {
    const auto start = std::chrono::steady_clock::now();
    const auto result = IT::intrinsic_Delaunay_triangulation(gluing, CGAL::parameters::fast_forward(true));
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    flips = result.untwisting.number_of_flips.str();
    twists = std::to_string(result.untwisting.twists.size());
    status = result.report.status == IT::Flip_status::DELAUNAY ? "Delaunay" : "not finished";
  }
  std::nth_element(times.begin(), times.begin() + 50, times.end());
  if (flips.size() > 20)
    flips = "10^" + std::to_string(flips.size() - 1);
  std::printf("%-34s %16s %8s %9.3f ms  %s\n", name, flips.c_str(), twists.c_str(), 1e3 * times[50], status.c_str());
}

} // namespace

int main()
{
  const IT::Integer n("1000000000000"), huge = pow(IT::Integer(10), 10000);
  std::printf("%-34s %16s %8s %12s\n", "surface", "flips", "twists", "time");
  measure("torus, shear 10^12", samples::sheared_one_vertex_torus(n));
  measure("Fibonacci torus of size 10^12", samples::Fibonacci_torus(59));
  measure("genus 2, shears 10^12 and -10^12", samples::sheared_genus_two(n, -n));
  measure("torus, shear 10^10000", samples::sheared_one_vertex_torus(huge));
}

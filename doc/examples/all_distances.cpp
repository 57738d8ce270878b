// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distances between all vertices of a surface within a few percent, on all cores: the mean distance of each vertex from
// all others, and the largest distance of two. What is printed of them is proven.
//
//   all_distances [MESH [CHANGE]]

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

int main(int argc, char** argv)
{
  samples::Indexed_triangles surface;
  if (argc > 1)
    IT::read_triangles(argv[1], surface.points, surface.triangles);
  else
    surface = samples::bumpy_sphere(40, 30, 0.1);
  const double change = argc > 2 ? std::atof(argv[2]) : 0.05;
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  const auto begin = std::chrono::steady_clock::now();
  const IT::Simplified_surface simplified = IT::simplify_surface(t, CGAL::parameters::maximum_change(change));
  const IT::Simplified_distances distances(simplified);
  const std::size_t n = distances.number_of_vertices();
  std::cout << n << " vertices, " << simplified.kept.size() << " after simplification; distances between "
            << simplified.shrink << " and " << simplified.stretch << " times what they were\n";

  // Each thread writes its own elements.
  std::vector<double> mean_lower(n), mean_upper(n), farthest_lower(n), farthest_upper(n);
  distances.from_each<CGAL::Parallel_if_available_tag>([&](IT::Vertex_index v, const IT::Distance_intervals& found) {
    const auto mean = [&](const std::vector<double>& d) { return std::accumulate(d.begin(), d.end(), 0.) / double(n); };
    mean_lower[v.idx()] = mean(found.lower);
    mean_upper[v.idx()] = mean(found.upper);
    farthest_lower[v.idx()] = *std::max_element(found.lower.begin(), found.lower.end());
    farthest_upper[v.idx()] = *std::max_element(found.upper.begin(), found.upper.end());
  });
  const std::size_t center = std::size_t(std::min_element(mean_upper.begin(), mean_upper.end()) - mean_upper.begin()),
                    end = std::size_t(std::max_element(farthest_lower.begin(), farthest_lower.end()) -
                                      farthest_lower.begin());
  std::cout << "the mean distance of vertex " << center << " is the least: between " << mean_lower[center] << " and "
            << mean_upper[center] << "\nthe largest distance of two vertices is between " << farthest_lower[end]
            << " and " << *std::max_element(farthest_upper.begin(), farthest_upper.end()) << "\n"
            << std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() << " s\n";

  // From two of them also on the surface itself.
  for (std::size_t i : {center, end}) {
    const IT::Vertex_index v(static_cast<IT::Vertex_index::size_type>(i));
    const std::vector<double> exact =
      IT::geodesic_distances(t, std::vector<IT::Vertex_index>{v}, CGAL::parameters::tolerance(0.)).distances;
    const double farthest = *std::max_element(exact.begin(), exact.end());
    if (!(farthest_lower[i] <= farthest * (1 + 1e-9) && farthest <= farthest_upper[i] * (1 + 1e-9)))
      return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

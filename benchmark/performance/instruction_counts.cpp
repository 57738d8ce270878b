// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One fixed run for the script benchmark/instruction_counts, which counts its instructions.
//
//   instruction_counts CASE   see the list in main()

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <boost/config.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Filtered = IT::Filtered_edge_length_traits;

// Instructions in functions of this name are counted.
template <class Function>
BOOST_NOINLINE auto counted(const Function& f)
{
  return f();
}

template <class Traits>
auto triangulate(const Mesh& mesh)
{
  return IT::intrinsic_Delaunay_triangulation(mesh, CGAL::parameters::geom_traits(Traits()));
}

} // namespace

int main(int argc, char** argv)
{
  const auto is = [&](const char* name) { return argc == 2 && std::strcmp(argv[1], name) == 0; };
  const Mesh torus = mesh_of(samples::bad_torus(100, 100));
  std::size_t result = 0;
  if (is("double"))
    result = counted([&] { return triangulate<IT::Edge_length_traits<double>>(torus).report.flips; });
  else if (is("exact"))
    result = counted([&] { return triangulate<Filtered>(torus).report.flips; });
  else if (is("ties")) {
    const Mesh grid = mesh_of(samples::random_diagonal_grid(100, 100, 1, 3));
    result = counted([&] { return triangulate<Filtered>(grid).report.tests; });
  } else if (is("one_tie")) { // the first edge that is tested
    samples::Indexed_triangles surface = samples::bad_torus(100, 100);
    const auto i = std::uint32_t(surface.points.size()), j = i + 1, k = i + 2, l = i + 3;
    for (const auto& [x, y, z] : {std::array{4, 0, 0}, std::array{8, 0, 0}, std::array{6, 2, 0}, std::array{6, 0, 2}})
      surface.points.push_back({double(x), double(y), double(z)});
    surface.triangles.insert(surface.triangles.begin(), {{i, j, k}, {j, i, l}});
    const Mesh mesh = mesh_of(surface);
    result = counted([&] { return triangulate<Filtered>(mesh).report.flips; });
  } else if (is("pillow")) {
    const Mesh pillow = mesh_of(samples::pillow(300));
    result = counted([&] { return triangulate<Filtered>(pillow).report.flips; });
  } else if (is("overlay")) {
    const auto t = triangulate<Filtered>(torus).triangulation;
    result = counted([&] { return IT::Overlay(t).number_of_segments(); });
  } else if (is("positions")) {
    const auto t = triangulate<Filtered>(torus).triangulation;
    const IT::Overlay overlay(t);
    result = counted([&] {
               return IT::Overlay_positions(IT::internal::engine(t), overlay);
             }).on_input_edge(*overlay.crossings().begin()) > 0;
  } else if (is("stiffness")) {
    const auto t = triangulate<Filtered>(torus).triangulation;
    result = counted([&] { return std::size_t(IT::stiffness_matrix(t).nonZeros()); });
  } else {
    std::fprintf(stderr, "usage: instruction_counts double|exact|ties|one_tie|pillow|overlay|positions|stiffness\n");
    return 2;
  }
  std::printf("%zu\n", result); // so that nothing is optimized away
}

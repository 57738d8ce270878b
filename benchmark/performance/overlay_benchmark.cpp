// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cost of the overlay: time for each of its elements (vertices, segments and faces), its growth with their number,
// and the cost of the integers from which it is built.
//
//   overlay_benchmark [ROUNDS]
//
// Times are processor times of one thread, each the median of the rounds (7), in which all
// methods run one after the other. table1/horse.off is taken from the folder in the environment
// variable IDT_DATA_DIR, or from shared/data beside the checkout, if it is there.

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstdint>
#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Heat_method_triangulation = CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh>;

template <class Function>
double seconds(const Function& function)
{
  const std::clock_t start = std::clock();
  function();
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Costs
{
  double elements = 0; // of the overlay
  double graph = 0, positions = 0;
  double triangulation = 0;
  double journal = 0;  // the added time for logging flips, in double, which needs no log
  double integers = 0; // the same, plus computing the integers from the log
  double input = 0;    // integers and input connectivity, when the flips are done
  double heat_method = 0;
};

// In double, from the mesh, with or without logging flips.
double seconds_in_double(const Mesh& mesh, bool notes_flips)
{
  return seconds([&] {
    auto t = IT::intrinsic_triangulation(mesh, CGAL::parameters::geom_traits(IT::Edge_length_traits<double>()));
    if (notes_flips) // for integers, which need no metric
      t.keep_input(IT::Input_metric::from_points({}));
    IT::flip_to_Delaunay(t);
  });
}

// The flips of a triangulation, each as the halfedges around the edge before it.
struct Recorder
{
  bool go_further(const IT::Progress&) { return true; }
  void after_flip(IT::Edge_index e)
  {
    const IT::Hinge_halfedges now = complex.hinge(e);
    flips.push_back({now.ij, now.lj, now.jk, now.ji, now.ki, now.il});
  }
  const IT::Delta_complex& complex;
  std::vector<IT::Hinge_halfedges> flips;
};

// The integers alone, from the log.
double seconds_for_integers(const Mesh& mesh)
{
  auto t = IT::intrinsic_triangulation(mesh);
  const IT::Delta_complex input = t.connectivity();
  Recorder recorder{t.connectivity(), {}};
  IT::flip_to_Delaunay(t, CGAL::parameters::visitor(std::ref(recorder)));
  return seconds([&] {
    IT::internal::Normal_coordinates coordinates(input);
    for (const IT::Hinge_halfedges& around : recorder.flips)
      coordinates.flip(around);
  });
}

Costs measure(const Mesh& mesh, int rounds, bool with_heat_method)
{
  std::vector<double> graph, positions, triangulation, without, with, integers, input, heat_method;
  Costs costs;
  for (int round = 0; round <= rounds; ++round) {
    std::optional<decltype(IT::intrinsic_triangulation(mesh))> t;
    triangulation.push_back(seconds([&] { t.emplace(IT::intrinsic_Delaunay_triangulation(mesh).triangulation); }));
    without.push_back(seconds_in_double(mesh, false));
    with.push_back(seconds_in_double(mesh, true));
    integers.push_back(seconds_for_integers(mesh));
    input.push_back(seconds([&] { IT::internal::engine(*t); }));
    std::optional<IT::Overlay> overlay;
    graph.push_back(seconds([&] { overlay.emplace(*t); }));
    std::optional<IT::Overlay_positions> crossings;
    positions.push_back(seconds([&] { crossings.emplace(IT::internal::engine(*t), *overlay); }));
    costs.elements = double(overlay->number_of_vertices()) + overlay->number_of_segments() + overlay->number_of_faces();
    if (with_heat_method)
      heat_method.push_back(seconds([&] { const Heat_method_triangulation h(mesh); }));
    if (round == 0) // does not count: caches and memory are cold
      for (std::vector<double>* values :
           {&graph, &positions, &triangulation, &without, &with, &integers, &input, &heat_method})
        values->clear();
  }
  costs.graph = median(graph);
  costs.positions = median(positions);
  costs.triangulation = median(triangulation);
  costs.journal = median(with) - median(without);
  costs.integers = costs.journal + median(integers);
  costs.input = median(input);
  if (with_heat_method)
    costs.heat_method = median(heat_method);
  return costs;
}

void report(const std::string& name, const Costs& costs)
{
  const double per_element = 1e9 / costs.elements;
  std::printf("%-20s %11.0f %9.2f %7.1f %9.1f %9.2f %9.2f", name.c_str(), costs.elements,
              1e3 * (costs.graph + costs.positions), per_element * costs.graph,
              per_element * (costs.graph + costs.positions), 1 + costs.integers / (costs.triangulation - costs.journal),
              costs.input / costs.triangulation);
  if (costs.heat_method > 0)
    std::printf(" %9.2f %9.2f", costs.graph / costs.heat_method, (costs.graph + costs.positions) / costs.heat_method);
  std::printf("\n");
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv)
{
  keep_freed_memory();
  const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 7;
  std::printf("elements: of the overlay; ms: graph and positions; ns: for each element; integers: time\n"
              "of triangulation and integers over what it were without them; input: integers and input\n"
              "connectivity afterwards, over the time of the triangulation; heat: over the time that the class of "
              "CGAL's Heat_method_3\n"
              "takes for its triangulation\n\n"
              "%-20s %11s %9s %7s %9s %9s %9s %9s %9s\n",
              "surface", "elements", "ms", "ns", "ns with", "integers", "input", "heat", "heat with");
  std::printf("%-20s %11s %9s %7s %9s %9s %9s %9s %9s\n", "", "", "", "graph", "positions", "", "", "graph",
              "positions");
  report("prism 2880", measure(mesh_of(samples::prism(2880)), rounds, true));
  report("prism 2880, rotated", measure(mesh_of(samples::prism(2880, 1)), rounds, true));
  if (const std::optional<Mesh> horse = read_horse())
    report("horse", measure(*horse, rounds, true));
  report("torus 1000 x 1000", measure(mesh_of(samples::bad_torus(1000, 1000)), rounds, true));

  // The slope of the line that fits best, of the logarithms.
  std::vector<std::pair<double, double>> graph, with_positions;
  for (std::size_t n : {26, 46, 82, 146, 260, 462, 820}) {
    const Costs costs = measure(mesh_of(samples::bad_torus(n, n)), rounds, false);
    report("torus " + std::to_string(n) + " x " + std::to_string(n), costs);
    graph.emplace_back(std::log(costs.elements), std::log(costs.graph));
    with_positions.emplace_back(std::log(costs.elements), std::log(costs.graph + costs.positions));
  }
  const auto slope = [](const std::vector<std::pair<double, double>>& points) {
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [a, b] : points) {
      x += a;
      y += b;
      xx += a * a;
      xy += a * b;
    }
    const double n = double(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
  };
  std::printf("\nslope of log time over log elements: graph %.3f, with positions %.3f\n", slope(graph),
              slope(with_positions));
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a CGAL::Surface_mesh to its finished intrinsic Delaunay triangulation: the traits of
// this package, and the class of CGAL's Heat_method_3, on the same meshes in one process.
//
//   idt_benchmark [OPTION...] [MESH...]
//
// MESH is a file that CGAL reads, or the name of a built-in sample surface. Without one, a
// torus of a million vertices, a bumpy sphere of a quarter of a million, a sheared grid each of whose
// edges is flipped more than once, and table1/horse.off
// from the folder in the environment variable IDT_DATA_DIR, or from shared/data beside the
// checkout, are taken. Options are those of Google Benchmark, for instance
// `--benchmark_format=json`; IDT_BENCHMARK_ROUNDS sets the number of rounds (7).
//
// In each round every method runs once, in an order that changes from round to round, as a method
// finds in the caches what the one before has left there. What counts is the median of the rounds: a
// machine that slows down or speeds up in between does so for all methods alike. The last lines, on the
// standard error, are the ratios.

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/tags.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Heat_method_triangulation = CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh>;

struct Run
{
  double seconds;
  std::uint64_t flips; // 0 if the method does not tell
};

struct Method
{
  const char* name;
  Run (*run)(const Mesh&);
};

// The result is destroyed after the clock has stopped.
template <class Construct>
auto timed(const Construct& construct, double& seconds)
{
  const auto start = std::chrono::steady_clock::now();
  auto result = construct();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

template <class Traits, class ConcurrencyTag = CGAL::Sequential_tag>
Run run_package(const Mesh& mesh)
{
  Run run{};
  const auto t = timed(
    [&] { return IT::intrinsic_Delaunay_triangulation<ConcurrencyTag>(mesh, CGAL::parameters::geom_traits(Traits())); },
    run.seconds);
  run.flips = t.report.flips;
  return run;
}

Run run_heat_method(const Mesh& mesh)
{
  Run run{};
  const auto start = std::chrono::steady_clock::now();
  const Heat_method_triangulation t(mesh); // refers to itself, so that it cannot be returned
  run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return run;
}

// The last one is the reference for the others.
const std::vector<Method> methods{
  {"Edge_length_traits<double>", run_package<IT::Edge_length_traits<double>>},
  {"Filtered_edge_length_traits", run_package<IT::Filtered_edge_length_traits>},
#ifdef CGAL_LINKED_WITH_TBB
  {"Filtered, Parallel_tag", run_package<IT::Filtered_edge_length_traits, CGAL::Parallel_tag>},
#endif
  {"Half_angle_traits<double>", run_package<IT::Half_angle_traits<double>>},
  {"Heat_method_3", run_heat_method}};

struct Input
{
  std::string name;
  std::function<Mesh()> make;
};

Input input(const std::string& name)
{
  for (const samples::Sample& sample : samples::sample_names())
    if (sample.name == name)
      return {name, [name] {
                const auto surface = samples::make_sample(name);
                if (const auto* triangles = std::get_if<samples::Indexed_triangles>(&surface))
                  return mesh_of(*triangles);
                std::cerr << name << ": has lengths alone, and is no mesh\n";
                std::exit(2);
              }};
  return {std::filesystem::path(name).stem().string(), [name] { return read_mesh(name); }};
}

std::vector<Input> default_inputs()
{
  std::vector<Input> inputs{{"bad_torus_1000x1000", [] { return mesh_of(samples::bad_torus(1000, 1000)); }},
                            {"bumpy_sphere_700x351", [] { return mesh_of(samples::bumpy_sphere(700, 351)); }},
                            {"sheared_grid_300x300", [] { return mesh_of(samples::sheared_grid(300, 300, 3.3)); }}};
  if (const std::string horse = horse_path(); !horse.empty())
    inputs.insert(inputs.begin(), input(horse));
  return inputs;
}

// The medians of all methods on one mesh, measured when the first of them is requested.
class Comparison
{
public:
  explicit Comparison(Input input) : input_(std::move(input)) {}

  const std::string& name() const { return input_.name; }
  bool is_measured() const { return !medians_.empty(); }
  std::size_t number_of_edges() const { return number_of_edges_; }
  const Run& median(std::size_t method)
  {
    if (!is_measured())
      measure();
    return medians_[method];
  }
  double ratio(std::size_t method) { return median(methods.size() - 1).seconds / median(method).seconds; }

private:
  void measure()
  {
    const char* const variable = std::getenv("IDT_BENCHMARK_ROUNDS");
    const std::size_t rounds = std::max(1, variable ? std::atoi(variable) : 7);
    const Mesh mesh = input_.make();
    number_of_edges_ = mesh.number_of_edges();
    std::vector<std::vector<Run>> runs(methods.size());
    for (const Method& method : methods) // one round does not count: caches and memory are cold
      method.run(mesh);
    std::vector<std::size_t> order(methods.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::mt19937 random; // the same orders each time
    for (std::size_t round = 0; round < rounds; ++round) {
      std::shuffle(order.begin(), order.end(), random);
      for (std::size_t method : order)
        runs[method].push_back(methods[method].run(mesh));
    }
    for (std::vector<Run>& of_method : runs) {
      const auto middle = of_method.begin() + std::ptrdiff_t(of_method.size() / 2);
      std::nth_element(of_method.begin(), middle, of_method.end(),
                       [](const Run& a, const Run& b) { return a.seconds < b.seconds; });
      medians_.push_back(*middle);
    }
  }

  Input input_;
  std::size_t number_of_edges_ = 0;
  std::vector<Run> medians_;
};

void report(benchmark::State& state, Comparison& comparison, std::size_t method)
{
  for (auto _ : state)
    state.SetIterationTime(comparison.median(method).seconds);
  state.counters["edges"] = double(comparison.number_of_edges());
  state.counters["flips"] = double(comparison.median(method).flips);
  state.counters["ns_per_edge"] = 1e9 * comparison.median(method).seconds / double(comparison.number_of_edges());
  state.counters["times_as_fast"] = comparison.ratio(method);
}

} // namespace

int main(int argc, char** argv)
{
  keep_freed_memory();
  benchmark::Initialize(&argc, argv);
  std::vector<Input> inputs;
  for (int i = 1; i < argc; ++i)
    if (argv[i][0] == '-') {
      std::cerr << "unknown option " << argv[i] << "\n";
      return 2;
    } else
      inputs.push_back(input(argv[i]));
  std::vector<Comparison> comparisons;
  for (Input& each : inputs.empty() ? inputs = default_inputs() : inputs)
    comparisons.emplace_back(std::move(each));
  for (Comparison& comparison : comparisons)
    for (std::size_t method = 0; method < methods.size(); ++method)
      benchmark::RegisterBenchmark(
        (comparison.name() + "/" + methods[method].name).c_str(),
        [&comparison, method](benchmark::State& state) { report(state, comparison, method); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  for (Comparison& comparison : comparisons)
    for (std::size_t method = 0; comparison.is_measured() && method + 1 < methods.size(); ++method)
      std::fprintf(stderr, "%-24s %-28s %6.2f times as fast as %s\n", comparison.name().c_str(), methods[method].name,
                   comparison.ratio(method), methods.back().name);
}

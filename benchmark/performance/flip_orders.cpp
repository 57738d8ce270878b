// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does it matter in what order edges are flipped? The paper's stack, a queue, the worst edge first and
// sweeps over all edges, beside flip_to_Delaunay(), on surfaces with many flips.
//
//   flip_orders [FILE|SAMPLE...]
//
// Prints for each surface and order the number of flips, the number of tests for each flip, and the
// time for each flip. Decisions are exact, so that each order ends; in none of them are
// trivial tests left out, as flip_to_Delaunay() does.

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <functional>
#include <queue>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using IT::Edge_index;

// Edges are taken from the end (a stack) or from the beginning (a queue).
template <bool is_stack>
class Line
{
public:
  void push(const Triangulation&, Edge_index e) { edges_.push_back(e); }
  bool is_empty() const { return edges_.empty(); }
  Edge_index pop()
  {
    const Edge_index e = is_stack ? edges_.back() : edges_.front();
    is_stack ? edges_.pop_back() : edges_.pop_front();
    return e;
  }

private:
  std::deque<Edge_index> edges_;
};

// The edge with the smallest cotangent weight, as it was when the edge was pushed.
class Worst_first
{
public:
  void push(const Triangulation& t, Edge_index e)
  {
    const IT::Delta_complex& c = t.connectivity();
    double weight = 0;
    if (c.is_flippable(e))
      for (IT::Halfedge_index h : {c.halfedge(e), c.opposite(c.halfedge(e))})
        weight += t.traits().compute_cotangent_object()(t.face_data(c.face(h)), t.edge_data(c.edge(h)),
                                                        t.edge_data(c.edge(c.next(h))), t.edge_data(c.edge(c.prev(h))));
    edges_.push({-weight, e.idx()});
  }
  bool is_empty() const { return edges_.empty(); }
  Edge_index pop()
  {
    const Edge_index e(edges_.top().second);
    edges_.pop();
    return e;
  }

private:
  std::priority_queue<std::pair<double, std::uint32_t>> edges_;
};

struct Run
{
  std::uint64_t flips = 0, tests = 0;
  double seconds = 0;
};

// Flips the edges among `is_pending` that are not Delaunay, in the order of the container.
template <class Container>
Run flip_in_order(Triangulation& t)
{
  Run run;
  Container container;
  std::vector<bool> is_pending(t.connectivity().number_of_edges(), true);
  for (Edge_index e : t.connectivity().edges())
    container.push(t, e);
  while (!container.is_empty()) {
    const Edge_index e = container.pop();
    is_pending[e.idx()] = false;
    const IT::Delta_complex& c = t.connectivity();
    if (!c.is_flippable(e))
      continue;
    ++run.tests;
    if (CGAL::certainly(IT::internal::Whole_triangulation<Triangulation::Traits>(t).test_and_recompute(e)))
      continue;
    IT::internal::Whole_triangulation<Triangulation::Traits>(t).flip_not_Delaunay(e);
    ++run.flips;
    for (IT::Halfedge_index h : {c.halfedge(e), c.opposite(c.halfedge(e))})
      for (IT::Halfedge_index side : {c.next(h), c.prev(h)})
        if (const Edge_index s = c.edge(side); !is_pending[s.idx()]) {
          is_pending[s.idx()] = true;
          container.push(t, s);
        }
  }
  return run;
}

// All edges again and again, until a sweep flips none.
Run flip_in_sweeps(Triangulation& t)
{
  Run run;
  for (std::uint64_t before = ~std::uint64_t(0); before != run.flips;) {
    before = run.flips;
    for (Edge_index e : t.connectivity().edges()) {
      if (!t.connectivity().is_flippable(e))
        continue;
      ++run.tests;
      if (!CGAL::certainly(IT::internal::Whole_triangulation<Triangulation::Traits>(t).test_and_recompute(e))) {
        IT::internal::Whole_triangulation<Triangulation::Traits>(t).flip_not_Delaunay(e);
        ++run.flips;
      }
    }
  }
  return run;
}

Run flip_as_the_package(Triangulation& t)
{
  const IT::Flip_report report = IT::flip_to_Delaunay(t);
  return {report.flips, report.tests, 0};
}

const std::pair<const char*, Run (*)(Triangulation&)> orders[] = {{"flip_to_Delaunay", flip_as_the_package},
                                                                  {"stack", flip_in_order<Line<true>>},
                                                                  {"queue", flip_in_order<Line<false>>},
                                                                  {"worst first", flip_in_order<Worst_first>},
                                                                  {"sweeps", flip_in_sweeps}};

Mesh surface(const std::string& name)
{
  for (const samples::Sample& sample : samples::sample_names())
    if (sample.name == name) {
      const auto made = samples::make_sample(name);
      if (const auto* triangles = std::get_if<samples::Indexed_triangles>(&made))
        return mesh_of(*triangles);
      std::fprintf(stderr, "%s has lengths alone, and is no mesh\n", name.c_str());
      std::exit(2);
    }
  return read_mesh(name);
}

void compare(const std::string& name, const Mesh& mesh)
{
  for (const auto& [order, flip] : orders) {
    Triangulation t = IT::intrinsic_triangulation(mesh);
    const auto start = std::chrono::steady_clock::now();
    Run run = flip(t);
    run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double flips = double(run.flips == 0 ? 1 : run.flips);
    std::printf("| %s | %s | %llu | %.1f | %.0f |\n", name.c_str(), order, static_cast<unsigned long long>(run.flips),
                double(run.tests) / flips, 1e9 * run.seconds / flips);
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char** argv)
{
  std::printf("| surface | order | flips | tests a flip | ns a flip |\n"
              "| --- | --- | ---: | ---: | ---: |\n");
  for (int i = 1; i < argc; ++i)
    compare(std::filesystem::path(argv[i]).stem().string(), surface(argv[i]));
  if (argc > 1)
    return 0;
  compare("pillow(1000)", mesh_of(samples::pillow(1000)));
  compare("sheared_grid(300, 300, 20.3)", mesh_of(samples::sheared_grid(300, 300, 20.3)));
  compare("Schwarz_lantern(100, 2000)", mesh_of(samples::Schwarz_lantern(100, 2000)));
  compare("bad_torus(500, 500)", mesh_of(samples::bad_torus(500, 500)));
}

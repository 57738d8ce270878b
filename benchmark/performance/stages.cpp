// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What each stage costs, from plain arrays or a Surface_mesh to overlay and matrix, with one thread and
// with all, beside what it would cost to stream the bytes once that the stage reads and writes; and CGAL's
// way from the same arrays.
//
//   stages [MESH...]
//
// Without a mesh, a torus of a million vertices and table1/horse.off (as idt_benchmark) are taken.
// All stages run one after the other in each of seven rounds; what counts is the median. Bytes are
// those of the arrays alone, of which each is counted once.

#include "benchmark_meshes.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Heat_method_triangulation = CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh>;

#ifdef CGAL_LINKED_WITH_TBB
using All_threads_tag = CGAL::Parallel_tag;
#else
using All_threads_tag = CGAL::Sequential_tag;
#endif

template <class Function>
double seconds(const Function& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values)
{
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Of a pass that reads one large array and writes another.
double seconds_per_byte()
{
  constexpr std::size_t n = std::size_t(1) << 25;
  std::vector<std::uint64_t> from(n, 1), to(n, 2);
  std::vector<double> times;
  for (int round = 0; round < 5; ++round)
    times.push_back(seconds([&] {
      for (std::size_t i = 0; i < n; ++i)
        to[i] = from[i] + std::uint64_t(round);
    }));
  return median(times) / double(2 * n * sizeof(std::uint64_t));
}

struct Stage
{
  const char* name;
  double bytes; // all together
  std::vector<double> one_thread, all_threads;
};

class Stages
{
public:
  explicit Stages(const Mesh& mesh) : mesh_(mesh), edges_(double(mesh.number_of_edges()))
  {
    for (Mesh::Vertex_index v : mesh.vertices())
      points_.push_back({mesh.point(v)[0], mesh.point(v)[1], mesh.point(v)[2]});
    for (Mesh::Face_index f : mesh.faces()) {
      const Mesh::Halfedge_index h = mesh.halfedge(f);
      triangles_.push_back(
        {std::uint32_t(mesh.source(h)), std::uint32_t(mesh.target(h)), std::uint32_t(mesh.target(mesh.next(h)))});
    }
  }

  void run()
  {
    for (int round = 0; round < 8; ++round) {
      run_with<CGAL::Sequential_tag>(&Stage::one_thread, round > 0);
      run_with<All_threads_tag>(&Stage::all_threads, round > 0);
      const double time = seconds([&] {
        const Mesh copy = mesh_of({points_, triangles_});
        const Heat_method_triangulation t(copy);
      });
      if (round > 0)
        Heat_method_from_arrays_.push_back(time);
    }
  }

  void print(const char* name, double per_byte) const
  {
    std::printf("\n%s, %.0f edges\n\n"
                "| stage | ns an edge | all threads | bytes an edge | ns to stream them |\n"
                "| --- | ---: | ---: | ---: | ---: |\n",
                name, edges_);
    for (const Stage& stage : stages_)
      std::printf("| %s | %.1f | %.1f | %.0f | %.1f |\n", stage.name, 1e9 * median(stage.one_thread) / edges_,
                  1e9 * median(stage.all_threads) / edges_, stage.bytes / edges_,
                  1e9 * per_byte * stage.bytes / edges_);
    const double ours = median(stages_[1].one_thread) + median(stages_[2].one_thread) + median(stages_[3].one_thread);
    std::printf("\nfrom arrays: CGAL %.1f ns an edge, here %.1f, a %.1fth\n",
                1e9 * median(Heat_method_from_arrays_) / edges_, 1e9 * ours / edges_,
                median(Heat_method_from_arrays_) / ours);
  }

private:
  template <class Function>
  void stage(const char* name, double bytes, std::vector<double> Stage::*times, bool counts, const Function& function)
  {
    const double time = seconds(function);
    if (!counts)
      return;
    auto position = std::find_if(stages_.begin(), stages_.end(), [&](const Stage& s) { return s.name == name; });
    if (position == stages_.end())
      position = stages_.insert(position, Stage{name, bytes, {}, {}});
    ((*position).*times).push_back(time);
  }

  template <class ConcurrencyTag>
  void run_with(std::vector<double> Stage::*times, bool counts)
  {
    const double v = double(points_.size()), e = edges_, f = double(triangles_.size());
    const double complex_bytes = 2 * e * sizeof(IT::Delta_complex::Halfedge) + 4 * (v + f),
                 mesh_bytes = 2 * e * 16 + 4 * (v + f), points_bytes = 24 * v,
                 metric_bytes = 8 * e + 16 * f + 8 * e; // squared lengths, areas, bounds
    std::optional<IT::Delta_complex> complex;
    stage("connectivity, from a Surface_mesh", mesh_bytes + complex_bytes, times, counts,
          [&] { complex = IT::make_Delta_complex<ConcurrencyTag>(mesh_); });
    stage("connectivity, from arrays (one thread)", 12 * f + complex_bytes, times, counts,
          [&] { complex = IT::make_Delta_complex_from_triangles(points_.size(), triangles_); });
    std::optional<Triangulation> t;
    stage("lengths, areas, bounds", complex_bytes + points_bytes + metric_bytes, times, counts, [&] {
      t.emplace(std::move(*complex), Triangulation::Point_vector(points_.begin(), points_.end()),
                IT::Filtered_edge_length_traits(), ConcurrencyTag());
    });
    stage("tests and flips", complex_bytes + metric_bytes + 2 * e, times, counts,
          [&] { IT::flip_to_Delaunay<ConcurrencyTag>(*t); });
    stage("tests where nothing flips", 8 * e + e, times, counts, [&] { IT::flip_to_Delaunay<ConcurrencyTag>(*t); });
    stage("integers and input connectivity", 2 * complex_bytes, times, counts,
          [&] { IT::internal::engine<ConcurrencyTag>(*t); });
    std::optional<IT::Overlay> overlay;
    overlay = IT::make_overlay<ConcurrencyTag>(*t); // for its size
    const double overlay_bytes = 28. * overlay->number_of_segments() + 4. * overlay->number_of_vertices() +
                                 12. * overlay->number_of_faces() + 16 * e;
    stage("overlay: graph", 2 * complex_bytes + overlay_bytes, times, counts,
          [&] { overlay = IT::make_overlay<ConcurrencyTag>(*t); });
    std::optional<IT::Overlay_positions> positions;
    stage("overlay: positions", overlay_bytes + 16. * overlay->number_of_crossings() + points_bytes, times, counts,
          [&] {
            positions.emplace(IT::internal::engine(*t), *overlay, IT::Progress_function(),
                              IT::internal::threads<ConcurrencyTag>());
          });
    stage("cotangent weights", complex_bytes + metric_bytes + 8 * e, times, counts,
          [&] { IT::cotangent_weights<ConcurrencyTag>(*t); });
    stage("stiffness matrix", complex_bytes + metric_bytes + 12 * (2 * e + v), times, counts,
          [&] { IT::stiffness_matrix<ConcurrencyTag>(*t); });
    stage("lumped mass matrix", complex_bytes + 8 * f + 12 * v, times, counts,
          [&] { IT::lumped_mass_matrix<ConcurrencyTag>(*t); });
  }

  const Mesh& mesh_;
  double edges_;
  std::vector<std::array<double, 3>> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Stage> stages_;
  std::vector<double> Heat_method_from_arrays_;
};

} // namespace

int main(int argc, char** argv)
{
  keep_freed_memory();
  const double per_byte = seconds_per_byte();
  std::printf("streaming: %.1f GB/s\n", 1e-9 / per_byte);
  const auto measure = [per_byte](const char* name, const Mesh& mesh) {
    Stages stages(mesh);
    stages.run();
    stages.print(name, per_byte);
    std::fflush(stdout);
  };
  for (int i = 1; i < argc; ++i)
    measure(argv[i], read_mesh(argv[i]));
  if (argc > 1)
    return 0;
  measure("torus of bad triangles", mesh_of(samples::bad_torus(1000, 1000)));
  if (const auto horse = read_horse())
    measure("horse", *horse);
}

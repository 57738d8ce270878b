// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances by heat beside those of CGAL's Heat_method_3: errors against exact distances, and times.
//
//   heat_distances [MESH...]   on surfaces whose distances are known, and on meshes, against
//                              Surface_mesh_shortest_path

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Surface_mesh_geodesic_distances_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace Ours = CGAL::Intrinsic_triangulations::Heat_method_3;
namespace Theirs = CGAL::Heat_method_3;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

struct Problem
{
  std::string name;
  Mesh mesh;
  std::vector<Vertex> sources;
  std::vector<double> exact;
};

Mesh mesh_of(const samples::Indexed_triangles& sample)
{
  Mesh mesh;
  for (const auto& [x, y, z] : sample.points)
    mesh.add_vertex({x, y, z});
  for (const auto& t : sample.triangles)
    mesh.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  return mesh;
}

// An octahedron, each face cut into n² triangles, on the unit sphere.
Mesh octahedral_sphere(int n)
{
  samples::Indexed_triangles result;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](int x, int y, int z) {
    const auto [it, is_new] = numbers.insert({{x, y, z}, std::uint32_t(numbers.size())});
    if (is_new) {
      const double r = std::hypot(x, y, z);
      result.points.push_back({x / r, y / r, z / r});
    }
    return it->second;
  };
  for (int side = 0; side < 8; ++side) {
    const int sx = side & 1 ? -1 : 1, sy = side & 2 ? -1 : 1, sz = side & 4 ? -1 : 1;
    const auto corner = [&](int i, int j) { return vertex(sx * i, sy * j, sz * (n - i - j)); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (sx * sy * sz < 0)
        std::swap(b, c);
      result.triangles.push_back({a, b, c});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < n)
          add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
  }
  return mesh_of(result);
}

double straight(const Mesh& mesh, Vertex v, Vertex w)
{
  return std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
}

void set_exact(Problem& problem, const std::function<double(Vertex, Vertex)>& distance)
{
  for (Vertex v : problem.mesh.vertices()) {
    double nearest = distance(v, problem.sources.front());
    for (Vertex s : problem.sources)
      nearest = (std::min)(nearest, distance(v, s));
    problem.exact.push_back(nearest);
  }
}

Problem on_sphere(const std::string& name, Mesh mesh)
{
  Problem result{name, std::move(mesh), {Vertex(500)}, {}};
  set_exact(result, [&](Vertex v, Vertex w) { return 2 * std::asin((std::min)(1., straight(result.mesh, v, w) / 2)); });
  return result;
}

// \pre the mesh is flat and convex
Problem flat(const std::string& name, Mesh mesh, bool from_border)
{
  Problem result{name, std::move(mesh), {}, {}};
  for (Vertex v : result.mesh.vertices())
    if (from_border && result.mesh.is_border(v))
      result.sources.push_back(v);
  if (!from_border)
    result.sources.push_back(Vertex(0));
  set_exact(result, [&](Vertex v, Vertex w) { return straight(result.mesh, v, w); });
  return result;
}

Problem of_file(const std::string& path)
{
  Problem result{path.substr(path.rfind('/') + 1), {}, {Vertex(0)}, {}};
  if (!CGAL::Polygon_mesh_processing::IO::read_polygon_mesh(path, result.mesh))
    throw std::runtime_error(path + ": cannot be read");
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> exact(result.mesh);
  exact.add_source_point(Vertex(0));
  for (Vertex v : result.mesh.vertices())
    result.exact.push_back(exact.shortest_distance_to_source_points(v).first);
  return result;
}

template <class Distances>
void measure(const Problem& problem, const char* method)
{
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  };
  Mesh mesh = problem.mesh;
  auto map = mesh.add_property_map<Vertex, double>("v:distance", 0).first;
  double first = 1e9, further = 1e9;
  for (int run = 0; run < 3; ++run) {
    const auto start = Clock::now();
    Distances distances(mesh);
    distances.add_sources(problem.sources);
    distances.estimate_geodesic_distances(map);
    first = (std::min)(first, seconds(start));
    distances.clear_sources();
    distances.add_source(Vertex(Vertex::size_type(mesh.number_of_vertices() / 2)));
    const auto again = Clock::now();
    distances.estimate_geodesic_distances(map);
    further = (std::min)(further, seconds(again));
    distances.clear_sources();
    distances.add_sources(problem.sources);
    distances.estimate_geodesic_distances(map);
  }
  double mean = 0, largest = 0, scale = 0, least_part = 1;
  for (Vertex v : mesh.vertices()) {
    const double exact = problem.exact[v], error = std::abs(map[v] - exact);
    if (!std::isfinite(exact))
      continue;
    mean += error / double(mesh.number_of_vertices());
    largest = (std::max)(largest, error);
    scale = (std::max)(scale, exact);
    if (exact > 0)
      least_part = (std::min)(least_part, map[v] / exact);
  }
  std::printf("| %s | %s | %.2f %% | %.2f %% | %.3f | %.3f s | %.4f s |\n", problem.name.c_str(), method,
              100 * mean / scale, 100 * largest / scale, least_part, first, further);
  std::fflush(stdout);
}

void measure_all(const Problem& problem)
{
  measure<Theirs::Surface_mesh_geodesic_distances_3<Mesh, Theirs::Direct>>(problem, "CGAL, `Direct`");
  measure<Theirs::Surface_mesh_geodesic_distances_3<Mesh, Theirs::Intrinsic_Delaunay>>(problem,
                                                                                       "CGAL, `Intrinsic_Delaunay`");
  measure<Ours::Surface_mesh_geodesic_distances_3<Mesh, Ours::Intrinsic_Delaunay>>(problem,
                                                                                   "here, `Intrinsic_Delaunay`");
}

} // namespace

int main(int argc, char** argv)
{
  std::puts("| surface | method | mean error | largest error | least part of the distance | first distances | another "
            "source |\n"
            "| --- | --- | ---: | ---: | ---: | ---: | ---: |");
  namespace IT = CGAL::Intrinsic_triangulations;
  measure_all(on_sphere("sphere of 10,002 vertices", octahedral_sphere(50)));
  measure_all(on_sphere("sphere of circles of latitude", mesh_of(samples::latitude_longitude_sphere(140, 72))));
  measure_all(flat("square, sources on the border", mesh_of(samples::sheared_grid(40, 40, 0)), true));
  measure_all(flat("parallelogram of needles, shear 1", mesh_of(samples::sheared_grid(60, 60, 1)), false));
  measure_all(flat("parallelogram of needles, shear 5", mesh_of(samples::sheared_grid(60, 60, 5)), false));
  for (int i = 1; i < argc; ++i)
    measure_all(of_file(argv[i]));
}

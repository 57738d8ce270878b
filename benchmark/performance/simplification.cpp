// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Simplification: how many vertices are left, what is proven of distances and what is true of them, and the time; the same
// of CGAL's decimation by quadrics (Garland and Heckbert) at equal numbers of vertices; and eigenvalues.
//
//   simplification MESH...                 at most 1, 5 and 20 %
//   simplification --eigenvalues MESH...   the first 20: of the mesh, of the simplified surface, and of that refined
//
// True changes are those from two vertices to all others, by exact distances. A decimated vertex stands for the nearest
// vertex of the mesh. Processor time.

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/eigenvalues.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_policies.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace SMS = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

double seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

Triangulation Delaunay_triangulation(const Points& points, const Triangles& triangles)
{
  Triangulation result(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(result);
  return result;
}

std::vector<double> exact_distances(const Triangulation& t, std::size_t v)
{
  return IT::geodesic_distances(t, {IT::Vertex_index(IT::Vertex_index::size_type(v))}, CGAL::parameters::tolerance(0.))
    .distances;
}

// Of distances, relative to the exact ones.
struct Changes
{
  double least = 1, most = 1, squares = 0;
  std::size_t number = 0;

  void add(double found, double exact)
  {
    if (!(exact > 0) || !std::isfinite(exact))
      return;
    least = (std::min)(least, found / exact);
    most = (std::max)(most, found / exact);
    squares += (found / exact - 1) * (found / exact - 1);
    ++number;
  }
  double rms() const { return std::sqrt(squares / double(number)); }
};

void decimate(const Points& points, const Triangles& triangles, const Triangulation& fine, std::size_t n)
{
  Mesh mesh;
  for (const auto& p : points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  const double begin = seconds();
  SMS::GarlandHeckbert_policies<Mesh, Kernel> policies(mesh);
  const SMS::Count_stop_predicate<Mesh> stop(mesh.number_of_edges() - 3 * (points.size() - n));
  SMS::edge_collapse(mesh, stop,
                     CGAL::parameters::get_cost(policies.get_cost()).get_placement(policies.get_placement()));
  const double end = seconds();
  mesh.collect_garbage();
  Points left;
  Triangles faces;
  std::vector<std::size_t> nearest;
  for (Mesh::Vertex_index v : mesh.vertices()) {
    const auto& q = mesh.point(v);
    left.push_back({q.x(), q.y(), q.z()});
    const auto distance = [&](const std::array<double, 3>& p) {
      return CGAL::squared_distance(q, Kernel::Point_3(p[0], p[1], p[2]));
    };
    nearest.push_back(std::size_t(
      std::min_element(points.begin(), points.end(), [&](auto& p, auto& r) { return distance(p) < distance(r); }) -
      points.begin()));
  }
  for (Mesh::Face_index f : mesh.faces()) {
    faces.emplace_back();
    std::size_t i = 0;
    for (Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      faces.back()[i++] = v;
  }
  const Triangulation coarse = Delaunay_triangulation(left, faces);
  Changes changes;
  for (std::size_t v : {std::size_t(0), left.size() / 2}) {
    const std::vector<double> exact = exact_distances(fine, nearest[v]), found = exact_distances(coarse, v);
    for (std::size_t w = 0; w < left.size(); ++w)
      changes.add(found[w], exact[nearest[w]]);
  }
  std::printf("   quadrics: %zu vertices, true %.3f to %.3f, rms %.4f, %.2f us a vertex\n", left.size(), changes.least,
              changes.most, changes.rms(), 1e6 * (end - begin) / double(points.size()));
}

void measure(const Points& points, const Triangles& triangles)
{
  Triangulation fine = Delaunay_triangulation(points, triangles);
  const std::array<std::size_t, 2> sources{0, points.size() / 2};
  const std::array<std::vector<double>, 2> exact{exact_distances(fine, sources[0]), exact_distances(fine, sources[1])};
  for (double change : {0.01, 0.05, 0.2}) {
    const double begin = seconds();
    const IT::Simplified_surface s = IT::simplify_surface(fine, CGAL::parameters::maximum_change(change));
    const double end = seconds();
    const IT::Simplified_distances distances(s);
    Changes changes;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto found = distances.from({IT::Vertex_index(IT::Vertex_index::size_type(sources[i]))}).distances;
      for (std::size_t v = 0; v < found.size(); ++v)
        changes.add(found[v], exact[i][v]);
    }
    const double used =
      (std::max)(std::log(changes.least) / std::log(s.shrink), std::log(changes.most) / std::log(s.stretch));
    std::printf(
      "%4.0f %%: %zu vertices, %.2f %%; proven %.4f to %.4f, true %.4f to %.4f: %.2f of it; rms %.5f; %.1f us a "
      "vertex\n",
      100 * change, s.kept.size(), 100 * double(s.kept.size()) / double(points.size()), s.shrink, s.stretch,
      changes.least, changes.most, used, changes.rms(), 1e6 * (end - begin) / double(points.size()));
    if (change == 0.05)
      decimate(points, triangles, fine, s.kept.size());
  }
}

std::vector<double> eigenvalues(const Triangulation& t)
{
  return IT::smallest_eigenvalues(IT::stiffness_matrix(t), IT::lumped_mass_matrix(t), 20);
}

void compare_eigenvalues(const Points& points, const Triangles& triangles)
{
  Triangulation fine = Delaunay_triangulation(points, triangles);
  IT::Simplified_surface s = IT::simplify_surface(fine);
  const std::vector<double> expected = eigenvalues(fine), coarse = eigenvalues(s.triangulation);
  IT::refine_Delaunay(s.triangulation);
  const std::vector<double> refined = eigenvalues(s.triangulation);
  std::printf("%zu vertices, %zu simplified, %zu refined; differences in percent:\n", points.size(), s.kept.size(),
              std::size_t(s.triangulation.connectivity().number_of_vertices()));
  for (std::size_t i = 1; i < expected.size(); ++i)
    std::printf("%10.4g  %+6.2f  %+6.2f\n", expected[i], 100 * (coarse[i] / expected[i] - 1),
                100 * (refined[i] / expected[i] - 1));
}

} // namespace

int main(int argc, char** argv)
{
  const bool has_eigenvalues = argc > 1 && std::string(argv[1]) == "--eigenvalues";
  for (int i = has_eigenvalues ? 2 : 1; i < argc; ++i)
    try {
      Points points;
      Triangles triangles;
      IT::read_triangles(argv[i], points, triangles);
      std::printf("%s, %zu vertices\n", argv[i], points.size());
      (has_eigenvalues ? compare_eigenvalues : measure)(points, triangles);
      std::fflush(stdout);
    } catch (const std::exception& error) {
      std::printf("%s\n", error.what());
    }
}

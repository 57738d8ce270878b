// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same surface as a Polyhedron_3 and as a Surface_mesh: any model of CGAL's graph concepts is
// an input, and the result does not depend on which. The Polyhedron_3 has another kernel, too.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Exact_predicates_inexact_constructions_kernel>;

namespace {

// The part of the result that does not depend on how edges are numbered.
template <class TriangleMesh>
std::vector<double> sorted_lengths(const TriangleMesh& mesh)
{
  const auto [idt, report] = IT::intrinsic_Delaunay_triangulation(mesh);
  std::vector<double> lengths;
  for (IT::Edge_index e : idt.connectivity().edges())
    lengths.push_back(idt.length(e));
  std::sort(lengths.begin(), lengths.end());
  std::cout << lengths.size() << " edges, " << report.flips << " flips, from " << lengths.front() << " to "
            << lengths.back() << '\n';
  return lengths;
}

} // namespace

int main()
{
  const samples::Indexed_triangles sample = samples::bumpy_sphere(40, 21);
  Mesh mesh;
  for (const auto& p : sample.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : sample.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  Polyhedron polyhedron;
  CGAL::copy_face_graph(mesh, polyhedron);

  // Decisions are exact and lengths within 1 ulp, in whatever order edges are flipped.
  const std::vector<double> of_mesh = sorted_lengths(mesh), of_polyhedron = sorted_lengths(polyhedron);
  const bool is_fine = std::equal(of_mesh.begin(), of_mesh.end(), of_polyhedron.begin(), of_polyhedron.end(),
                                  [](double a, double b) { return a - b <= 1e-15 * a && b - a <= 1e-15 * a; });
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}

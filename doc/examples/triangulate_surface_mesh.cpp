// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a CGAL::Surface_mesh to its intrinsic Delaunay triangulation, and queries of the result.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

int main()
{
  // A sample, so that no file is needed; CGAL::IO::read_polygon_mesh() reads one.
  const samples::Indexed_triangles sample = samples::bumpy_sphere();
  Mesh mesh;
  for (const auto& p : sample.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for (const auto& t : sample.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));

  const auto [idt, report] = IT::intrinsic_Delaunay_triangulation(mesh);

  std::cout << "vertices " << mesh.number_of_vertices() << ", edges " << mesh.number_of_edges() << ", flips "
            << report.flips << '\n';

  // An edge keeps its number: it is the edge of the mesh, or the edge that flips have made of it.
  const IT::Element_numbers numbers = IT::element_numbers(idt);
  const double longest = *std::max_element(numbers.lengths.begin(), numbers.lengths.end()),
               smallest_weight = *std::min_element(numbers.cotangent_weights.begin(), numbers.cotangent_weights.end());
  std::cout << "longest edge " << longest << ", smallest weight " << smallest_weight << '\n';

  // Connectivity and lengths as a Surface_mesh, for algorithms that work on one.
  const auto result = IT::to_surface_mesh(idt, mesh);
  const bool is_simplicial = IT::is_simplicial(idt.connectivity());
  std::cout << "as a mesh: " << result.number_of_faces() << " faces, "
            << (is_simplicial ? "simplicial" : "with loops or multiple edges") << '\n';

  const bool is_fine = report.status == IT::Flip_status::DELAUNAY && smallest_weight >= 0 &&
                       result.number_of_faces() == mesh.number_of_faces() && result.is_valid();
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}

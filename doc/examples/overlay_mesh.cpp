// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay of a mesh and its intrinsic Delaunay triangulation as an ordinary mesh: a function
// that is linear on the intrinsic triangles is linear on each of its faces.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <sstream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  // Two triangles with a fold along their common edge, which is flipped.
  Mesh mesh;
  const auto i = mesh.add_vertex({0, 0, 0}), j = mesh.add_vertex({4, 0, 0}), k = mesh.add_vertex({2, 1, 0}),
             l = mesh.add_vertex({2, 0, 1});
  mesh.add_face(i, j, k);
  mesh.add_face(j, i, l);
  const auto idt = IT::intrinsic_Delaunay_triangulation(mesh).triangulation;

  Mesh overlay = IT::overlay_to_surface_mesh(IT::Common_subdivision(idt), mesh);
  // Each of these maps exists already: that one is returned, not a new one.
  const auto input_face = overlay.add_property_map<Mesh::Face_index, std::uint32_t>("f:input_face").first;
  const auto intrinsic_face = overlay.add_property_map<Mesh::Face_index, std::uint32_t>("f:intrinsic_face").first;
  for (auto f : overlay.faces())
    std::cout << "a piece of input face " << input_face[f] << " and intrinsic face " << intrinsic_face[f] << '\n';

  // Values at the vertices, interpolated on the intrinsic triangles.
  const double values[] = {0, 0, 1, 3};
  const auto intrinsic_point =
    overlay.add_property_map<Mesh::Halfedge_index, IT::Surface_point>("h:intrinsic_point").first;
  auto value = overlay.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  for (auto h : overlay.halfedges())
    if (!overlay.is_border(h))
      value[overlay.target(h)] = IT::interpolate(idt.connectivity(), values, intrinsic_point[h]);
  // The one crossing is half-way from k to l.
  const Mesh::Vertex_index crossing(4);
  std::cout << "at " << overlay.point(crossing) << ": " << value[crossing] << '\n';

  IT::triangulate_overlay_faces(overlay); // for a program that takes only triangles
  std::ostringstream file;
  CGAL::IO::write_PLY(file, overlay); // with kinds, labels, faces and values
  std::cout << file.str();
  return overlay.number_of_vertices() == 5 && overlay.number_of_faces() == 4 && std::abs(value[crossing] - 2) < 1e-12
           ? EXIT_SUCCESS
           : EXIT_FAILURE;
}

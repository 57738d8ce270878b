// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A disk with a tall spike is mapped to the unit disk by the harmonic map of its intrinsic Delaunay
// triangulation, and written as a textured mesh. The map is linear on the intrinsic triangles, and
// so on the faces of the overlay: these are the mesh.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[])
{
  const samples::Indexed_triangles sample = samples::disk_with_spike();
  Mesh mesh;
  for (const auto& p : sample.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& t : sample.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  const auto idt = IT::intrinsic_Delaunay_triangulation(mesh).triangulation;
  const IT::Planar_points uv = IT::harmonic_parameterization(idt);
  std::vector<double> us, vs;
  for (const std::array<double, 2>& p : uv) {
    us.push_back(p[0]);
    vs.push_back(p[1]);
  }

  // Each corner of the overlay knows its place in an intrinsic triangle.
  Mesh overlay = IT::overlay_to_surface_mesh(IT::Common_subdivision(idt), mesh);
  IT::triangulate_overlay_faces(overlay);
  // The map exists already: that one is returned, not a new one.
  const auto place = overlay.add_property_map<Mesh::Halfedge_index, IT::Surface_point>("h:intrinsic_point").first;
  std::ostringstream obj;
  obj.precision(17);
  for (auto v : overlay.vertices())
    obj << "v " << overlay.point(v) << '\n';
  std::size_t corners = 0, turned_over = 0;
  for (auto f : overlay.faces()) {
    std::ostringstream face;
    std::vector<std::array<double, 2>> image;
    for (auto h : overlay.halfedges_around_face(overlay.halfedge(f))) {
      image.push_back(
        {IT::interpolate(idt.connectivity(), us, place[h]), IT::interpolate(idt.connectivity(), vs, place[h])});
      obj << "vt " << (1 + image.back()[0]) / 2 << ' ' << (1 + image.back()[1]) / 2 << '\n';
      face << ' ' << overlay.target(h).idx() + 1 << '/' << ++corners;
    }
    obj << 'f' << face.str() << '\n';
    const auto [a, b, c] = std::array<std::array<double, 2>, 3>{image[0], image[1], image[2]};
    if ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < -1e-14)
      ++turned_over;
  }
  if (argc > 1) // Blender and MeshLab open it; any picture will do as texture
    std::ofstream(argv[1]) << obj.str();

  std::cout << overlay.number_of_faces() << " textured triangles, " << turned_over << " turned over\n";
  const bool is_fine = turned_over == 0 && mesh.number_of_faces() < overlay.number_of_faces() &&
                       IT::check_parameterization(idt.connectivity(), uv).is_locally_injective();
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}

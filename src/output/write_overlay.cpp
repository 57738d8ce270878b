// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"
#include "input/formats/vtp.h"

#include <CGAL/Intrinsic_triangulations/overlay_surface_mesh.h>

#include <CGAL/IO/io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/IO/OBJ.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace idt {

void write_overlay(std::ostream& os, const Triangulation_result& result, Mesh_format format)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points;
  points.reserve(result.surface.points.size());
  for (const auto& [x, y, z] : result.surface.points)
    points.emplace_back(x, y, z);
  const auto mesh = IT::internal::overlay_to_surface_mesh_without_corners(
    *result.outcome.subdivision, points);
  const auto all_digits = CGAL::parameters::stream_precision(17);
  switch (format) {
  case Mesh_format::PLY:
    // Binary: as text, CGAL would flush each line to the disk.
    CGAL::IO::set_binary_mode(os);
    CGAL::IO::write_PLY(os, mesh,
                        "overlay of an input triangulation and an intrinsic one\n"
                        "kind of a vertex: 0 vertex of the surface, 1 crossing\n"
                        "input_face, intrinsic_face of a face: those that contain it\n"
                        "label of an edge: 0 input, 1 intrinsic, 2 both");
    return;
  case Mesh_format::OFF:
    CGAL::IO::write_OFF(os, mesh, all_digits);
    return;
  case Mesh_format::OBJ:
    CGAL::IO::write_OBJ(os, mesh, all_digits);
    return;
  case Mesh_format::VTP: {
    std::vector<std::array<double, 3>> places;
    places.reserve(mesh.number_of_vertices());
    for (const auto v : mesh.vertices())
      places.push_back({{mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()}});
    Flat_polygons polygons;
    for (const auto f : mesh.faces()) {
      for (const auto v : vertices_around_face(mesh.halfedge(f), mesh))
        polygons.corners.push_back(static_cast<std::uint32_t>(v));
      polygons.ends.push_back(polygons.corners.size());
    }
    write_vtp(os, places, polygons);
    return;
  }
  case Mesh_format::STL:
  case Mesh_format::TS:
    break; // the command line does not allow them
  }
}

} // namespace idt

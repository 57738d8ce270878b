// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Textured_mesh.h"

#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <Eigen/Core>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

Textured_mesh make_map_over_input(const Surface& surface, const IT::Planar_points& uv)
{
  Textured_mesh mesh{surface.points, uv, {}};
  const IT::Delta_complex& complex = surface.connectivity;
  mesh.faces.reserve(complex.number_of_faces());
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    mesh.faces.push_back({complex.source(h).idx(), complex.target(h).idx(), complex.target(complex.next(h)).idx()});
  }
  return mesh;
}

Textured_mesh make_map_over_intrinsic(const Surface& surface, const IT::Common_subdivision& subdivision,
                                      const IT::Planar_points& uv)
{
  const IT::Overlay& graph = subdivision.overlay();
  Textured_mesh mesh;
  mesh.points.reserve(graph.number_of_vertices());
  for (IT::Overlay::Vertex v : graph.vertices())
    mesh.points.push_back(subdivision.point(v, surface.points));

  std::vector<Eigen::Vector2d> images;
  images.reserve(uv.size());
  for (const auto& [u, v] : uv)
    images.emplace_back(u, v);
  mesh.uv.reserve(graph.number_of_vertices());
  for (const Eigen::Vector2d& p : IT::interpolate_intrinsic_values(subdivision, images))
    mesh.uv.push_back({p.x(), p.y()});

  mesh.faces.reserve(graph.number_of_faces());
  for (IT::Overlay::Face f : graph.faces()) {
    std::vector<std::size_t>& corners = mesh.faces.emplace_back();
    const IT::Overlay::Halfedge first = graph.halfedge(f);
    IT::Overlay::Halfedge h = first;
    do {
      corners.push_back(graph.target(h).idx());
      h = graph.next(h);
    } while (h != first);
  }
  return mesh;
}

} // namespace idt

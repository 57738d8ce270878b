// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's class inside the heat method. It is internal there, its Laplacian is private, and it knows no overlay.

#include "run_system.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/internal/Intrinsic_Delaunay_triangulation_3.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace {

using namespace systems;
using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using Heat_method_triangulation = CGAL::Heat_method_3::Intrinsic_Delaunay_triangulation_3<Mesh>;

Result run(Task task, const Surface& surface)
{
  if (task != Task::TRIANGULATION)
    throw Not_offered{"the class has no public function for this"};
  if (surface.is_gluing())
    throw Not_offered{"needs points"};
  Mesh mesh;
  for (const auto& p : surface.points)
    mesh.add_vertex({p[0], p[1], p[2]});
  for (const auto& f : surface.triangles.corners)
    if (mesh.add_face(Mesh::Vertex_index(f[0]), Mesh::Vertex_index(f[1]), Mesh::Vertex_index(f[2])) ==
        Mesh::null_face())
      throw Not_offered{"no Surface_mesh"};

  Result result;
  std::optional<Heat_method_triangulation> triangulation;
  {
    const Stopwatch stopwatch(result.triangulation_seconds);
    triangulation.emplace(mesh);
  }
  const Mesh& flipped = triangulation->triangle_mesh();
  std::vector<Mesh::Halfedge_index> halfedges;
  std::vector<std::int64_t> side_of(flipped.number_of_halfedges(), -1);
  for (Mesh::Face_index f : flipped.faces()) {
    result.triangles.corners.emplace_back();
    Mesh::Halfedge_index h = flipped.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = flipped.next(h)) {
      side_of[h] = std::int64_t(halfedges.size());
      halfedges.push_back(h);
      result.triangles.corners.back()[i] = triangulation->v2v.at(flipped.source(h));
      // The class publishes only the corners of each face in the plane.
      const auto a = get(triangulation->hcmap(), flipped.prev(h)), b = get(triangulation->hcmap(), h);
      result.triangles.lengths.push_back(std::hypot(a.first - b.first, a.second - b.second));
    }
  }
  for (Mesh::Halfedge_index h : halfedges)
    result.triangles.opposite.push_back(side_of[flipped.opposite(h)]);
  return result;
}

} // namespace

int main(int argc, char** argv) { return run_system(argc, argv, run); }

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// geometry-central: its class with integer coordinates, or the one with signposts, as its authors call them by
// default. Each gives triangulation, overlay ("common subdivision") and Laplacian, and takes gluings without loops.

#include "run_system.h"

#include "geometrycentral/surface/edge_length_geometry.h"
#include "geometrycentral/surface/integer_coordinates_intrinsic_triangulation.h"
#include "geometrycentral/surface/manifold_surface_mesh.h"
#include "geometrycentral/surface/signpost_intrinsic_triangulation.h"
#include "geometrycentral/surface/vertex_position_geometry.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace {

using namespace systems;
namespace gc = geometrycentral::surface;
#ifdef IDT_INTEGER_COORDINATES
using Triangulation = gc::IntegerCoordinatesIntrinsicTriangulation;
#else
using Triangulation = gc::SignpostIntrinsicTriangulation;
#endif

std::unique_ptr<gc::ManifoldSurfaceMesh> make_mesh(const Surface& surface)
{
  std::vector<std::vector<std::size_t>> polygons;
  for (const auto& f : surface.triangles.corners)
    polygons.push_back({f[0], f[1], f[2]});
  if (!surface.is_gluing())
    return std::make_unique<gc::ManifoldSurfaceMesh>(polygons);
  const std::size_t none = geometrycentral::INVALID_IND;
  std::vector<std::vector<std::tuple<std::size_t, std::size_t>>> twins(polygons.size());
  for (std::size_t side = 0; side < surface.triangles.number_of_sides(); ++side) {
    const std::int64_t opposite = surface.triangles.opposite[side];
    twins[side / 3].emplace_back(opposite < 0 ? none : std::size_t(opposite) / 3,
                                 opposite < 0 ? none : std::size_t(opposite) % 3);
  }
  return std::make_unique<gc::ManifoldSurfaceMesh>(polygons, twins);
}

std::unique_ptr<gc::IntrinsicGeometryInterface> make_geometry(gc::ManifoldSurfaceMesh& mesh, const Surface& surface)
{
  if (surface.is_gluing()) {
    gc::EdgeData<double> lengths(mesh);
    for (gc::Face f : mesh.faces()) {
      std::size_t side = 3 * f.getIndex();
      for (gc::Halfedge h : f.adjacentHalfedges())
        lengths[h.edge()] = surface.triangles.lengths[side++];
    }
    return std::make_unique<gc::EdgeLengthGeometry>(mesh, lengths);
  }
  gc::VertexData<geometrycentral::Vector3> positions(mesh);
  for (gc::Vertex v : mesh.vertices()) {
    const auto& p = surface.points[v.getIndex()];
    positions[v] = {p[0], p[1], p[2]};
  }
  return std::make_unique<gc::VertexPositionGeometry>(mesh, positions);
}

Result run(Task task, const Surface& surface)
{
  const std::unique_ptr<gc::ManifoldSurfaceMesh> mesh = make_mesh(surface);
  const std::unique_ptr<gc::IntrinsicGeometryInterface> geometry = make_geometry(*mesh, surface);
  Result result;
  std::optional<Triangulation> t;
  gc::CommonSubdivision* subdivision = nullptr;
  {
    const Stopwatch stopwatch(result.triangulation_seconds);
#ifdef IDT_MOLLIFICATION
    t.emplace(*mesh, *geometry, IDT_MOLLIFICATION);
#else
    t.emplace(*mesh, *geometry);
#endif
    t->flipToDelaunay();
  }
  {
    const Stopwatch stopwatch(result.task_seconds);
    if (task == Task::OVERLAY) {
      subdivision = &t->getCommonSubdivision();
      subdivision->constructMesh(false);
    }
    if (task == Task::LAPLACIAN)
      t->requireCotanLaplacian();
  }
  if (task == Task::LAPLACIAN) {
    for (int k = 0; k < t->cotanLaplacian.outerSize(); ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(t->cotanLaplacian, k); it; ++it)
        result.Laplacian.push_back({std::uint32_t(it.row()), std::uint32_t(it.col()), it.value()});
    return result;
  }
  std::vector<gc::Halfedge> halfedges;
  gc::HalfedgeData<std::int64_t> side_of(*t->intrinsicMesh, -1);
  for (gc::Face f : t->intrinsicMesh->faces()) {
    result.triangles.corners.emplace_back();
    std::size_t i = 0;
    for (gc::Halfedge h : f.adjacentHalfedges()) {
      result.triangles.corners.back()[i++] = std::uint32_t(h.vertex().getIndex());
      side_of[h] = std::int64_t(halfedges.size());
      halfedges.push_back(h);
    }
  }
  for (gc::Halfedge h : halfedges) {
    result.triangles.opposite.push_back(side_of[h.twin()]);
    result.triangles.lengths.push_back(t->edgeLengths[h.edge()]);
    if (subdivision)
      result.crossings.push_back(std::int64_t(subdivision->intersectionsB(h.edge())));
  }
  return result;
}

} // namespace

int main(int argc, char** argv) { return run_system(argc, argv, run); }

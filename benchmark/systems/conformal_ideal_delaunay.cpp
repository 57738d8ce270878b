// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// ConformalIdealDelaunay: the first step of its maps, which makes the input Delaunay by Euclidean flips (no scale
// factors, no Ptolemy flips), with its overlay. Surfaces with a border are doubled there, so that their step
// triangulates another surface; they are left out.

#include "run_system.h"

#include "ConformalIdealDelaunayMapping.hh"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace {

using namespace systems;

double length(const Surface& surface, std::size_t side)
{
  if (surface.is_gluing())
    return surface.triangles.lengths[side];
  const auto &p = surface.points[surface.triangles.source(side)], &q = surface.points[surface.triangles.target(side)];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Its halfedges are our sides.
OverlayProblem::Mesh<double> make_mesh(const Surface& surface)
{
  const Triangles& triangles = surface.triangles;
  OverlayProblem::Mesh<double> mesh;
  mesh.out.assign(surface.number_of_vertices, -1);
  for (std::size_t side = 0; side < triangles.number_of_sides(); ++side) {
    mesh.n.push_back(int(Triangles::next(side)));
    mesh.to.push_back(int(triangles.target(side)));
    mesh.f.push_back(int(side / 3));
    mesh.opp.push_back(int(triangles.opposite[side]));
    mesh.out[triangles.source(side)] = int(side);
    mesh.l.push_back(length(surface, side));
    mesh.R.push_back(0);
  }
  for (std::size_t f = 0; f < triangles.corners.size(); ++f)
    mesh.h.push_back(int(3 * f));
  for (std::size_t v = 0; v < surface.number_of_vertices; ++v)
    mesh.v_rep.push_back(int(v));
  mesh.type.assign(mesh.n.size(), 0);
  mesh.type_input = mesh.type;
  mesh.Th_hat.assign(surface.number_of_vertices, 0);
  return mesh;
}

template <class Mesh>
void make_Delaunay(Mesh& mesh, const Surface& surface)
{
  const Eigen::VectorXd scale_factors = Eigen::VectorXd::Zero(Eigen::Index(surface.number_of_vertices));
  DelaunayStats statistics;
  SolveStats<double> more_statistics;
  ConformalIdealDelaunay<double>::MakeDelaunay(mesh, scale_factors, statistics, more_statistics, false);
}

Result run(Task task, const Surface& surface)
{
  if (task == Task::LAPLACIAN)
    throw Not_offered{"no Laplacian of its own"};
  for (std::int64_t opposite : surface.triangles.opposite)
    if (opposite < 0)
      throw Not_offered{"doubles surfaces with a border"};
  Result result;
  auto mesh = make_mesh(surface);
  std::optional<OverlayProblem::OverlayMesh<double>> overlay;
  if (task == Task::OVERLAY) { // its flips change the overlay, too
    const Stopwatch stopwatch(result.triangulation_seconds);
    overlay.emplace(mesh);
    make_Delaunay(*overlay, surface);
    mesh = overlay->cmesh();
  } else {
    const Stopwatch stopwatch(result.triangulation_seconds);
    make_Delaunay(mesh, surface);
  }

  std::vector<int> halfedges;
  std::vector<std::int64_t> side_of(mesh.n.size(), -1);
  for (int first : mesh.h) {
    result.triangles.corners.emplace_back();
    int h = first;
    for (std::size_t i = 0; i < 3; ++i, h = mesh.n[std::size_t(h)]) {
      result.triangles.corners.back()[i] = std::uint32_t(mesh.v0(h));
      side_of[std::size_t(h)] = std::int64_t(halfedges.size());
      halfedges.push_back(h);
    }
  }
  for (int h : halfedges) {
    result.triangles.opposite.push_back(side_of[std::size_t(mesh.opp[std::size_t(h)])]);
    result.triangles.lengths.push_back(mesh.l[std::size_t(mesh.e(h))]);
    if (overlay) {
      std::int64_t crossings = 0;
      for (int part = overlay->first_segment[std::size_t(h)];
           overlay->vertex_type[std::size_t(overlay->to[std::size_t(part)])] == SEGMENT_VERTEX;
           part = overlay->next_segment(part))
        ++crossings;
      result.crossings.push_back(crossings);
    }
  }
  return result;
}

} // namespace

int main(int argc, char** argv) { return run_system(argc, argv, run); }

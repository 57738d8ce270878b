// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// libigl: triangulation and Laplacian of an indexed triangle mesh.

#include "run_system.h"

#include <igl/edge_lengths.h>
#include <igl/intrinsic_delaunay_cotmatrix.h>
#include <igl/intrinsic_delaunay_triangulation.h>

#include <Eigen/Core>
#include <Eigen/Sparse>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

using namespace systems;

Result run(Task task, const Surface& surface)
{
  if (task == Task::OVERLAY)
    throw Not_offered{"no overlay"};
  if (surface.is_gluing())
    throw Not_offered{"sides with the same vertices are glued"};
  Eigen::MatrixXd points(surface.points.size(), 3);
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    points.row(Eigen::Index(v)) << surface.points[v][0], surface.points[v][1], surface.points[v][2];
  const std::size_t number_of_faces = surface.triangles.corners.size();
  Eigen::MatrixXi faces(number_of_faces, 3);
  for (std::size_t f = 0; f < number_of_faces; ++f)
    for (std::size_t i = 0; i < 3; ++i)
      faces(Eigen::Index(f), Eigen::Index(i)) = int(surface.triangles.corners[f][i]);

  Result result;
  if (task == Task::LAPLACIAN) {
    Eigen::SparseMatrix<double> matrix;
    {
      const Stopwatch stopwatch(result.task_seconds); // with the triangulation, which this function makes first
      igl::intrinsic_delaunay_cotmatrix(points, faces, matrix);
    }
    for (int k = 0; k < matrix.outerSize(); ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, k); it; ++it)
        result.Laplacian.push_back({std::uint32_t(it.row()), std::uint32_t(it.col()), -it.value()});
    return result;
  }

  Eigen::MatrixXd lengths;
  Eigen::MatrixXi flipped, directed_edges, edges;
  Eigen::VectorXi edge_of;
  std::vector<std::vector<int>> sides_of_edge;
  {
    const Stopwatch stopwatch(result.triangulation_seconds);
    Eigen::MatrixXd input_lengths;
    igl::edge_lengths(points, faces, input_lengths);
    igl::intrinsic_delaunay_triangulation(input_lengths, faces, lengths, flipped, directed_edges, edges, edge_of,
                                          sides_of_edge);
  }
  // Edge c of a face is opposite to its corner c, and sides are numbered by c first.
  const auto side = [&](int number) {
    return 3 * (std::size_t(number) % number_of_faces) + (std::size_t(number) / number_of_faces + 1) % 3;
  };
  result.triangles.opposite.assign(3 * number_of_faces, -1);
  for (const std::vector<int>& sides : sides_of_edge)
    if (sides.size() == 2) {
      result.triangles.opposite[side(sides[0])] = std::int64_t(side(sides[1]));
      result.triangles.opposite[side(sides[1])] = std::int64_t(side(sides[0]));
    }
  for (Eigen::Index f = 0; f < flipped.rows(); ++f) {
    result.triangles.corners.push_back(
      {std::uint32_t(flipped(f, 0)), std::uint32_t(flipped(f, 1)), std::uint32_t(flipped(f, 2))});
    for (Eigen::Index i = 0; i < 3; ++i)
      result.triangles.lengths.push_back(lengths(f, (i + 2) % 3));
  }
  return result;
}

} // namespace

int main(int argc, char** argv) { return run_system(argc, argv, run); }

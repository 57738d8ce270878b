// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// This package as one of the systems, judged like the others.

#include "own_triangulation.h"
#include "run_system.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <Eigen/Sparse>

#include <cstdint>
#include <optional>

namespace {

using namespace systems;

Result run(Task task, const Surface& surface)
{
  Result result;
  std::optional<Own_triangulation> t;
  std::optional<IT::Common_subdivision> subdivision;
  Eigen::SparseMatrix<double> matrix;
  {
    const Stopwatch stopwatch(result.triangulation_seconds);
    t.emplace(make_own_triangulation(surface));
    IT::flip_to_Delaunay(*t);
  }
  {
    const Stopwatch stopwatch(result.task_seconds);
    if (task == Task::OVERLAY)
      subdivision.emplace(*t);
    if (task == Task::LAPLACIAN)
      matrix = IT::stiffness_matrix(*t);
  }
  const IT::Delta_complex& complex = t->connectivity();
  if (task == Task::LAPLACIAN) {
    for (int k = 0; k < matrix.outerSize(); ++k)
      for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, k); it; ++it)
        result.Laplacian.push_back({std::uint32_t(it.row()), std::uint32_t(it.col()), it.value()});
    return result;
  }
  result.triangles = triangles_of(complex);
  for (IT::Halfedge_index h : halfedges_of_sides(complex)) {
    result.triangles.lengths.push_back(t->length(complex.edge(h)));
    if (subdivision)
      result.crossings.push_back(std::int64_t(subdivision->overlay().intrinsic_crossings(complex.edge(h)).size()));
  }
  return result;
}

} // namespace

int main(int argc, char** argv) { return run_system(argc, argv, run); }

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A smooth field on a nonmanifold mesh: a box with an open compartment, whose walls meet three and four at an edge.
// Heat enters at one corner and leaves at another; the field in between is harmonic.

#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <Eigen/SparseCholesky>

#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Place = std::array<int, 3>;

// Triangles with obtuse corners, which share the vertices on their common edges.
class Walls
{
public:
  // A rectangle of n times m squares, which are cut along the same diagonal.
  void add(const Place& corner, const Place& right, const Place& up, int n, int m)
  {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < m; ++j) {
        const auto vertex = [&](int a, int b) {
          return number({corner[0] + a * right[0] + b * up[0], corner[1] + a * right[1] + b * up[1],
                         corner[2] + a * right[2] + b * up[2]});
        };
        triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
        triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
      }
  }
  std::size_t number(const Place& p)
  {
    const auto [found, is_new] = numbers_.insert({p, points.size()});
    if (is_new)
      points.push_back({p[0] + 0.7 * p[1] + 0.3 * p[2], 0.4 * p[1], 0.4 * p[2]});
    return found->second;
  }

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;

private:
  std::map<Place, std::size_t> numbers_;
};

} // namespace

int main()
{
  Walls walls;
  const int n = 8;
  for (int side : {0, n}) {
    walls.add({0, 0, side}, {1, 0, 0}, {0, 1, 0}, n, n); // bottom and top
    walls.add({0, side, 0}, {1, 0, 0}, {0, 0, 1}, n, n); // front and back
  }
  walls.add({0, n / 2, 0}, {1, 0, 0}, {0, 0, 1}, n, n); // a wall in the middle
  walls.add({0, 0, n / 2}, {1, 0, 0}, {0, 1, 0}, n, n); // and one across it

  const IT::Tufted_Laplacian Laplacian = IT::tufted_Laplacian(walls.points, walls.triangles);
  std::cout << Laplacian.report.nonmanifold_edges << " edges with more than two faces, "
            << Laplacian.report.border_edges << " with one; " << Laplacian.flips.flips << " flips\n"
            << "smallest weight: " << Laplacian.minimum_weight << '\n';

  // L u = 0 except at two vertices, where u is 0 and 1.
  const auto cold = Eigen::Index(walls.number({0, 0, 0})), hot = Eigen::Index(walls.number({n, n, n}));
  Eigen::SparseMatrix<double> system = Laplacian.stiffness;
  Eigen::VectorXd right = -system.col(hot);
  for (Eigen::Index v : {cold, hot}) {
    system.prune([v](Eigen::Index row, Eigen::Index column, double) { return row != v && column != v; });
    system.coeffRef(v, v) = 1;
    right[v] = v == hot;
  }
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(system).solve(right);
  std::cout << "the field is between " << u.minCoeff() << " and " << u.maxCoeff() << '\n';

  // With nonnegative weights, each value is a mean of its neighbours' values: none is outside the range of the given
  // ones.
  const bool is_good = Laplacian.report.nonmanifold_edges > 0 && Laplacian.minimum_weight >= 0 &&
                       u.minCoeff() >= -1e-12 && u.maxCoeff() <= 1 + 1e-12;
  return is_good ? EXIT_SUCCESS : EXIT_FAILURE;
}

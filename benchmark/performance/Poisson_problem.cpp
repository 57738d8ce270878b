// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The effect of triangles on a solution: a Poisson problem with a known solution, by linear finite elements over the
// input, over its intrinsic Delaunay triangulation, and over that after refinement. Prints a table.
//
// The surfaces are isometric to a part of the plane, where u = cos(2x) exp(y) solves -Laplacian(u) = 3 u. Its values
// are given on the border, and 3 u as a function that is linear on each triangle.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Matrix = Eigen::SparseMatrix<double>;
using Point_2 = Eigen::Vector2d;

// A surface, and the positions of its vertices in the plane.
struct Flat_surface
{
  samples::Indexed_triangles triangles;
  std::vector<Point_2> plane;
};

double solution(const Point_2& p) { return std::cos(2 * p.x()) * std::exp(p.y()); }

Point_2 gradient(const Point_2& p) { return Point_2(-2 * std::sin(2 * p.x()), std::cos(2 * p.x())) * std::exp(p.y()); }

// The square in rows of triangles with angles close to 180 degrees; with flatter and flatter ones, linear elements do
// not converge (I. Babuška, A. K. Aziz, "On the angle condition in the finite element method", 1976).
Flat_surface flat_triangles(std::uint32_t columns, std::uint32_t rows)
{
  Flat_surface result;
  std::vector<std::uint32_t> first;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    first.push_back(std::uint32_t(result.plane.size()));
    const double y = double(row) / rows;
    const auto add = [&](double x) {
      result.plane.emplace_back(x, y);
      result.triangles.points.push_back({x, y, 0});
    };
    add(0);
    for (std::uint32_t i = 1; i < columns + row % 2; ++i)
      add((i - row % 2 / 2.) / columns);
    add(1);
  }
  // Between rows of n + 1 and n + 2 points.
  for (std::uint32_t row = 0; row < rows; ++row) {
    const std::uint32_t shift = row % 2, s = first[row + shift], l = first[row + 1 - shift];
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (shift == 0)
        result.triangles.triangles.push_back({a, b, c});
      else
        result.triangles.triangles.push_back({b, a, c});
    };
    for (std::uint32_t i = 0; i < columns; ++i)
      add(s + i, s + i + 1, l + i + 1);
    for (std::uint32_t i = 0; i <= columns; ++i)
      add(l + i + 1, l + i, s + i);
  }
  return result;
}

// A sheet folded along parallel lines: random points on the folds, and between them needles.
Flat_surface folded_sheet(std::uint32_t strips, std::uint32_t points)
{
  Flat_surface result;
  std::mt19937 random(1);
  const double width = 1. / strips;
  for (std::uint32_t fold = 0; fold <= strips; ++fold) {
    std::vector<double> heights = {0, 1};
    for (std::uint32_t i = 2; i < points; ++i)
      heights.push_back((random() % 65535 + 1) / 65536.);
    std::sort(heights.begin(), heights.end());
    for (double y : heights) {
      result.plane.emplace_back(fold * width, y);
      result.triangles.points.push_back({0.6 * fold * width, y, fold % 2 * 0.8 * width});
    }
  }
  for (std::uint32_t strip = 0; strip < strips; ++strip) {
    std::uint32_t left = strip * points, right = left + points;
    const std::uint32_t last_left = right - 1, last_right = right + points - 1;
    while (left < last_left || right < last_right) {
      const bool takes_left = right == last_right || (left < last_left && random() % 2 == 0);
      result.triangles.triangles.push_back({left, right, takes_left ? left + 1 : right + 1});
      ++(takes_left ? left : right);
    }
  }
  return result;
}

Flat_surface sheared_squares(std::size_t n, double shear)
{
  Flat_surface result;
  result.triangles = samples::sheared_grid(n, n, shear);
  for (std::array<double, 3>& p : result.triangles.points) {
    for (double& x : p)
      x /= double(n);
    result.plane.emplace_back(p[0], p[1]);
  }
  return result;
}

struct Errors
{
  double L2 = 0, H1 = 0; // of the function and of its gradient, relative to those of the solution
};

// \param plane where the vertices lie
Eigen::VectorXd solve(const Triangulation& t, const std::vector<Point_2>& plane)
{
  const IT::Delta_complex& complex = t.connectivity();
  Eigen::VectorXd exact{Eigen::Index(plane.size())};
  std::vector<bool> is_on_border(plane.size());
  for (IT::Halfedge_index h : complex.halfedges())
    if (complex.is_border(h))
      is_on_border[complex.source(h).idx()] = true;
  std::vector<Eigen::Triplet<double>> entries;
  int columns = 0;
  for (IT::Vertex_index v : complex.vertices()) {
    exact[Eigen::Index(v.idx())] = solution(plane[v.idx()]);
    if (!is_on_border[v.idx()])
      entries.emplace_back(int(v.idx()), columns++, 1);
  }
  Matrix select(exact.size(), columns);
  select.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd on_border = exact - select * (select.transpose() * exact);
  const Matrix stiffness = IT::stiffness_matrix(t);
  const Eigen::SimplicialLDLT<Matrix> solver(select.transpose() * stiffness * select);
  const Eigen::VectorXd load = IT::Galerkin_mass_matrix(t) * (3 * exact) - stiffness * on_border;
  return on_border + select * solver.solve(select.transpose() * load);
}

Errors errors(const Triangulation& t, const std::vector<Point_2>& plane, const Eigen::VectorXd& u)
{
  const IT::Delta_complex& complex = t.connectivity();
  Errors error, norm;
  for (IT::Face_index f : complex.faces()) {
    std::array<Point_2, 3> p;
    Eigen::Vector3d values;
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h)) {
      p[i] = plane[complex.source(h).idx()];
      values[Eigen::Index(i)] = u[Eigen::Index(complex.source(h).idx())];
    }
    Eigen::Matrix2d sides;
    sides << p[1] - p[0], p[2] - p[0];
    const double area = std::abs(sides.determinant()) / 2;
    if (area == 0)
      continue;
    const Point_2 slope = sides.transpose().inverse() * Point_2(values[1] - values[0], values[2] - values[0]);
    // Seven points, exact to degree 5.
    const auto add = [&](double a, double b, double c, double weight) {
      const Point_2 q = a * p[0] + b * p[1] + c * p[2];
      error.L2 += weight * area * std::pow(a * values[0] + b * values[1] + c * values[2] - solution(q), 2);
      error.H1 += weight * area * (slope - gradient(q)).squaredNorm();
      norm.L2 += weight * area * std::pow(solution(q), 2);
      norm.H1 += weight * area * gradient(q).squaredNorm();
    };
    add(1. / 3, 1. / 3, 1. / 3, 0.225);
    const double root = std::sqrt(15.);
    for (const double sign : {-1., 1.}) {
      const double a = (6 + sign * root) / 21, b = 1 - 2 * a, weight = (155 + sign * root) / 1200;
      add(a, a, b, weight);
      add(a, b, a, weight);
      add(b, a, a, weight);
    }
  }
  return {std::sqrt(error.L2 / norm.L2), std::sqrt(error.H1 / norm.H1)};
}

void print_row(const char* name, const char* kind, const Triangulation& t, const Flat_surface& surface)
{
  std::vector<Point_2> plane = surface.plane;
  const IT::Delta_complex& complex = t.connectivity();
  for (std::size_t v = plane.size(); v < complex.number_of_vertices(); ++v)
    plane.push_back(IT::interpolate(t.input(), surface.plane, t.location(IT::Vertex_index(v))));
  double smallest = 180, largest = 0;
  for (IT::Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h)) {
      const double angle = IT::angle(t, h) * 180 / CGAL_PI;
      smallest = std::min(smallest, angle);
      largest = std::max(largest, angle);
    }
  const Errors e = errors(t, plane, solve(t, plane));
  std::printf("| %s | %s | %zu | %.2f | %.2f | %.2e | %.2e |\n", name, kind, std::size_t(complex.number_of_vertices()),
              smallest, largest, e.L2, e.H1);
}

void study(const char* name, const Flat_surface& surface)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.triangles.points.size(), surface.triangles.triangles),
                  surface.triangles.points);
  print_row(name, "input", t, surface);
  IT::flip_to_Delaunay(t);
  print_row(name, "iDT", t, surface);
  IT::refine_Delaunay(t);
  print_row(name, "refined iDT", t, surface);
}

} // namespace

int main()
{
  std::printf(
    "| surface | triangulation | vertices | smallest angle | largest angle | error of u | error of its gradient |\n"
    "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n");
  study("flat triangles", flat_triangles(20, 800));
  study("folded sheet", folded_sheet(80, 12));
  study("sheared squares", sheared_squares(30, 4));
}

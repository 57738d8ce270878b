// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a bad mesh to the solution of an equation and a picture of it, in five steps, as doc/tutorial.md explains them.
//
//   tutorial [OVERLAY.ply]

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/number_type_config.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Matrix = Eigen::SparseMatrix<double>;

namespace {

constexpr int number_of_strips = 6, number_along = 60, slant = 20;
const double slope = 0.6; // of the strips in space

// A square sheet of paper with sides of length 1, folded like an accordion. The triangles of each strip are long, thin
// and slanted.
Mesh folded_sheet()
{
  Mesh mesh;
  const double width = 1. / number_of_strips;
  for (int i = 0; i <= number_of_strips; ++i)
    for (int j = 0; j <= number_along; ++j)
      mesh.add_vertex(Point(i * width * std::cos(slope), double(j) / number_along, i % 2 * width * std::sin(slope)));
  const auto at = [](int i, int j) { return Mesh::Vertex_index(Mesh::size_type(i * (number_along + 1) + j)); };
  for (int i = 0; i < number_of_strips; ++i) {
    int left = 0, right = 0;
    while (left < number_along || right < number_along)
      if (right < number_along && right < left + slant) {
        mesh.add_face(at(i, left), at(i + 1, right), at(i + 1, right + 1));
        ++right;
      } else {
        mesh.add_face(at(i, left), at(i + 1, right), at(i, left + 1));
        ++left;
      }
  }
  return mesh;
}

// The point of the paper that lies at a point in space.
std::array<double, 2> on_paper(const Point& p) { return {p.x() / std::cos(slope), p.y()}; }

// With no heat flow through the border, -Δu = 2π² u.
double wave(const std::array<double, 2>& p) { return std::cos(CGAL_PI * p[0]) * std::cos(CGAL_PI * p[1]); }

template <class Triangulation>
double smallest_angle(const Triangulation& t)
{
  double smallest = CGAL_PI;
  const std::vector<double> angles = IT::opposite_angles(t);
  for (IT::Halfedge_index h : t.connectivity().halfedges())
    if (!t.connectivity().is_border(h))
      smallest = std::min(smallest, angles[h.idx()]);
  return smallest * 180 / CGAL_PI;
}

// Solves u - Δu = f by finite elements. The values of f at the vertices are given.
template <class Triangulation>
Eigen::VectorXd solve(const Triangulation& t, const Eigen::VectorXd& f)
{
  const Matrix stiffness = IT::stiffness_matrix(t), mass = IT::Galerkin_mass_matrix(t);
  const Eigen::SimplicialLDLT<Matrix> solver(mass + stiffness);
  return solver.solve(mass * f);
}

// With f = (1 + 2π²) wave, the solution is the wave. Returns the largest error at a vertex.
template <class Triangulation>
double largest_error(const Triangulation& t, const Eigen::VectorXd& wave_at_vertices)
{
  return (solve(t, (1 + 2 * CGAL_PI * CGAL_PI) * wave_at_vertices) - wave_at_vertices).cwiseAbs().maxCoeff();
}

} // namespace

int main(int argc, char** argv)
{
  // 1. A mesh, and its triangles as they are.
  const Mesh mesh = folded_sheet();
  Eigen::VectorXd wave_of_mesh(Eigen::Index(mesh.number_of_vertices()));
  for (auto v : mesh.vertices())
    wave_of_mesh[Eigen::Index(v.idx())] = wave(on_paper(mesh.point(v)));
  const auto as_given = IT::intrinsic_triangulation(mesh);
  const double error_as_given = largest_error(as_given, wave_of_mesh);
  std::cout << "as given: smallest angle " << smallest_angle(as_given) << " degrees, error " << error_as_given << '\n';

  // 2. The intrinsic Delaunay triangulation of the same surface, with the same vertices.
  auto [t, report] = IT::intrinsic_Delaunay_triangulation(mesh);
  const double error_of_Delaunay = largest_error(t, wave_of_mesh);
  std::cout << report.flips << " flips: smallest angle " << smallest_angle(t) << " degrees, error " << error_of_Delaunay
            << '\n';

  // 3. New vertices on the same surface, until no angle is below 25 degrees.
  const IT::Refinement_report refinement = IT::refine_Delaunay(t);
  std::cout << refinement.insertions + refinement.segment_splits << " new vertices: smallest angle "
            << smallest_angle(t) << " degrees\n";

  // 4. The equation on the refined triangulation. New vertices come after those of the mesh.
  const IT::Common_subdivision subdivision(t);
  std::vector<Point> points;
  for (auto v : mesh.vertices())
    points.push_back(mesh.point(v));
  Eigen::VectorXd wave_of_all(Eigen::Index(t.connectivity().number_of_vertices()));
  for (IT::Vertex_index v : t.connectivity().vertices()) {
    const auto [x, y, z] = subdivision.point(IT::Overlay::Vertex(v.idx()), points);
    wave_of_all[Eigen::Index(v.idx())] = wave(on_paper({x, y, z}));
  }
  const double error_of_refined = largest_error(t, wave_of_all);
  std::cout << "refined: error " << error_of_refined << '\n';

  // 5. Back to the surface in space: on each face of the overlay, the solution is linear.
  const Eigen::VectorXd u = solve(t, (1 + 2 * CGAL_PI * CGAL_PI) * wave_of_all);
  Mesh overlay = IT::overlay_to_surface_mesh(subdivision, mesh);
  // That map exists already, and is returned; property_map() does the same, but its result changed with CGAL 6.
  const auto intrinsic_point =
    overlay.add_property_map<Mesh::Halfedge_index, IT::Surface_point>("h:intrinsic_point").first;
  auto value = overlay.add_property_map<Mesh::Vertex_index, double>("v:value").first;
  for (auto h : overlay.halfedges())
    if (!overlay.is_border(h))
      value[overlay.target(h)] = IT::interpolate(t.connectivity(), u, intrinsic_point[h]);
  if (argc > 1) {
    std::ofstream file(argv[1]);
    CGAL::IO::write_PLY(file, overlay);
  }
  std::cout << "the overlay has " << overlay.number_of_faces() << " faces\n";

  const bool is_fine = refinement.status == IT::Refinement_status::REFINED && smallest_angle(t) >= 25 &&
                       error_of_Delaunay < error_as_given && error_of_refined < error_of_Delaunay;
  return is_fine ? EXIT_SUCCESS : EXIT_FAILURE;
}

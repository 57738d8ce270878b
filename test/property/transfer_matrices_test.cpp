// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrices of interpolation and of the L2-optimal projection, against integrals that are
// computed in another way: over the triangles of the overlay by the lengths of their sides.

#include "overlay_surfaces.h"

#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using test_surfaces::Overlaid;
using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;

double norm(const Matrix& a) { return a.norm(); }

// The mass matrix of the functions that are linear on the triangles into which fans cut the faces of the overlay. Areas
// are computed from the positions of the corners in the plane of the input face.
Matrix overlay_mass_matrix(const Overlaid& s)
{
  const IT::Overlay& overlay = s.overlay();
  std::vector<Eigen::Triplet<double>> entries;
  for (IT::Overlay::Face f : overlay.faces()) {
    const IT::Halfedge_index first = s.input().halfedge(overlay.input_face(f));
    const auto corners = test_surfaces::laid_out(
      s.input(), first, [&](IT::Halfedge_index h) { return s.input_length(h); }, s.input_area(overlay.input_face(f)));
    std::vector<test_surfaces::Point_2> places;
    std::vector<int> vertices;
    IT::Overlay::Halfedge h = overlay.halfedge(f);
    do {
      const double t = s.positions().on_input_side(overlay, h);
      places.push_back(test_surfaces::combination(
        corners, test_surfaces::coordinates_from(s.input(), {overlay.input_side(h), {1 - t, t, 0}}, first)));
      vertices.push_back(int(overlay.target(h).idx()));
      h = overlay.next(h);
    } while (h != overlay.halfedge(f));
    for (std::size_t i = 1; i + 1 < places.size(); ++i) {
      const auto &a = places[0], &b = places[i], &c = places[i + 1];
      const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
      const std::array<int, 3> triangle{vertices[0], vertices[i], vertices[i + 1]};
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          entries.emplace_back(triangle[j], triangle[k], j == k ? area / 6 : area / 12);
    }
  }
  Matrix result(overlay.number_of_vertices(), overlay.number_of_vertices());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// A sixth of the area of a face for each corner, a twelfth for each pair.
template <class Area>
Matrix mass_matrix(const IT::Delta_complex& complex, const Area& area)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    for (IT::Halfedge_index a : {h, complex.next(h), complex.prev(h)})
      for (IT::Halfedge_index b : {h, complex.next(h), complex.prev(h)})
        entries.emplace_back(complex.target(a).idx(), complex.target(b).idx(), a == b ? area(f) / 6 : area(f) / 12);
  }
  Matrix result(complex.number_of_vertices(), complex.number_of_vertices());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

TEST(Transfer_matrices, interpolation_is_that_of_the_functions)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const Vector values = Vector::Random(s.input().number_of_vertices());
    const auto expect_equal = [&](const Matrix& matrix, const std::vector<double>& expected) {
      ASSERT_EQ(matrix.rows(), Eigen::Index(expected.size()));
      EXPECT_NEAR((matrix * values - Eigen::Map<const Vector>(expected.data(), matrix.rows())).norm(), 0,
                  1e-14 * std::sqrt(double(matrix.rows())));
    };
    expect_equal(IT::input_interpolation_matrix(s.subdivision), IT::interpolate_input_values(s.subdivision, values));
    expect_equal(IT::intrinsic_interpolation_matrix(s.subdivision),
                 IT::interpolate_intrinsic_values(s.subdivision, values));
  });
}

TEST(Transfer_matrices, integrals_are_those_over_the_overlay)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Transfer_mass_matrices mass = IT::transfer_mass_matrices(s.subdivision);
    const Matrix on_overlay = overlay_mass_matrix(s), from_input = IT::input_interpolation_matrix(s.subdivision),
                 from_intrinsic = IT::intrinsic_interpolation_matrix(s.subdivision);
    const double tolerance = 1e-13 * norm(mass.input);
    EXPECT_LE(norm(Matrix(from_input.transpose() * on_overlay * from_input - mass.input)), tolerance);
    EXPECT_LE(norm(Matrix(from_intrinsic.transpose() * on_overlay * from_intrinsic - mass.intrinsic)), tolerance);
    EXPECT_LE(norm(Matrix(from_intrinsic.transpose() * on_overlay * from_input - mass.mixed)), tolerance);

    EXPECT_LE(norm(Matrix(mass_matrix(s.input(), [&](IT::Face_index f) { return s.input_area(f); }) - mass.input)),
              tolerance);
    EXPECT_LE(norm(Matrix(mass_matrix(s.intrinsic(), [&](IT::Face_index f) { return s.triangulation.area(f); }) -
                          mass.intrinsic)),
              tolerance);
  });
}

TEST(Transfer_matrices, rows_sum_to_integrals_and_all_to_the_area)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Transfer_mass_matrices mass = IT::transfer_mass_matrices(s.subdivision);
    const Vector ones = Vector::Ones(mass.mixed.rows());
    double area = 0;
    for (IT::Face_index f : s.input().faces())
      area += s.input_area(f);
    EXPECT_NEAR(ones.dot(mass.mixed * ones), area, 1e-13 * area);
    const Vector rows = mass.mixed * ones, columns = mass.mixed.transpose() * ones, intrinsic = mass.intrinsic * ones,
                 input = mass.input * ones;
    for (Eigen::Index v = 0; v < ones.size(); ++v) {
      EXPECT_NEAR(rows[v], intrinsic[v], 1e-13 * intrinsic[v]);
      EXPECT_NEAR(columns[v], input[v], 1e-13 * input[v]);
    }
  });
}

TEST(Transfer_matrices, the_projection_is_optimal)
{
  test_surfaces::for_each_overlaid_surface([](const std::string& name, const Overlaid& s) {
    SCOPED_TRACE(name);
    const IT::Transfer_mass_matrices mass = IT::transfer_mass_matrices(s.subdivision);
    const IT::L2_projection to_input = IT::L2_projection_to_input(mass),
                            to_intrinsic = IT::L2_projection_to_intrinsic(mass);
    const Matrix on_overlay = overlay_mass_matrix(s), from_input = IT::input_interpolation_matrix(s.subdivision),
                 from_intrinsic = IT::intrinsic_interpolation_matrix(s.subdivision);
    const Vector values = Vector::Random(mass.mixed.rows()), ones = Vector::Ones(mass.mixed.rows());
    const auto check = [&](const IT::L2_projection& project, const Matrix& from_source, const Matrix& from_target) {
      EXPECT_NEAR((project(ones) - ones).lpNorm<Eigen::Infinity>(), 0, 1e-11);
      const Vector projected = project(values);
      // The residual is orthogonal to every function on the target.
      const Vector residual = from_target * projected - from_source * values;
      const Vector products = from_target.transpose() * (on_overlay * residual);
      EXPECT_LE(products.lpNorm<Eigen::Infinity>(), 1e-13 * norm(on_overlay));
      // Both have the same integral, and nothing is nearer.
      const Vector whole = on_overlay * Vector::Ones(on_overlay.rows());
      EXPECT_NEAR(whole.dot(residual), 0, 1e-12 * whole.lpNorm<1>());
      const auto error = [&](const Vector& u) {
        const Vector r = from_target * u - from_source * values;
        return r.dot(on_overlay * r);
      };
      const double smallest = error(projected);
      EXPECT_LE(smallest, error(values) + 1e-28); // of the same values at the vertices
      for (int i = 0; i < 5; ++i)
        EXPECT_LE(smallest, error(projected + 1e-3 * Vector::Random(values.size())) * (1 + 1e-12));
    };
    {
      SCOPED_TRACE("to the input");
      check(to_input, from_intrinsic, from_input);
    }
    SCOPED_TRACE("to the intrinsic triangulation");
    check(to_intrinsic, from_input, from_intrinsic);
  });
}

// A function that is linear on both triangulations is its own projection, and so is every function if nothing was
// flipped.
TEST(Transfer_matrices, the_projection_leaves_functions_of_the_target_as_they_are)
{
  const samples::Indexed_triangles grid = samples::sheared_grid(12, 12, 3.3);
  const Overlaid sheared(grid), unflipped(samples::random_diagonal_grid(8, 8, 1, 0));
  ASSERT_GT(sheared.overlay().number_of_crossings(), 100u);
  ASSERT_EQ(unflipped.overlay().number_of_crossings(), 0u);
  Eigen::MatrixXd places(grid.points.size(), 2);
  for (std::size_t v = 0; v < grid.points.size(); ++v)
    places.row(Eigen::Index(v)) << grid.points[v][0], grid.points[v][1];
  const auto mass = IT::transfer_mass_matrices(sheared.subdivision);
  EXPECT_LE((IT::L2_projection_to_input(mass)(places) - places).norm(), 1e-11);
  EXPECT_LE((IT::L2_projection_to_intrinsic(mass)(places) - places).norm(), 1e-11);

  const auto same = IT::transfer_mass_matrices(unflipped.subdivision);
  const Vector values = Vector::Random(same.mixed.rows());
  EXPECT_LE((IT::L2_projection_to_intrinsic(same)(values) - values).norm(), 1e-12);
}

TEST(Transfer_matrices, isolated_vertices_keep_their_values)
{
  samples::Indexed_triangles surface = samples::sheared_grid(3, 3);
  surface.points.push_back({7, 7, 7});
  const Overlaid s(surface);
  const auto project = IT::L2_projection_to_input(IT::transfer_mass_matrices(s.subdivision));
  const Vector values = Vector::Random(Eigen::Index(surface.points.size()));
  EXPECT_EQ(project(values)[values.size() - 1], values[values.size() - 1]);
}

} // namespace

// The projection does not depend on the unit, but areas may leave the range of double.
TEST(Transfer_matrices, areas_out_of_range_are_errors)
{
  const auto projected = [](double scale) {
    samples::Indexed_triangles surface = samples::bumpy_sphere(6, 7);
    for (auto& p : surface.points)
      for (double& x : p)
        x *= scale;
    const Overlaid s(surface);
    const auto matrices = IT::transfer_mass_matrices(s.subdivision);
    Vector values(s.input().number_of_vertices());
    for (Eigen::Index v = 0; v < values.size(); ++v)
      values[v] = double(v % 3);
    return Vector(IT::L2_projection_to_input(matrices)(values));
  };
  const Vector expected = projected(1);
  for (double scale : {1e-150, 1e150})
    EXPECT_LT((projected(scale) - expected).norm(), 1e-10);
  for (double scale : {1e-160, 1e-170, 1e-290, 1e160, 1e300})
    EXPECT_THROW(projected(scale), IT::Invalid_surface_error) << scale;
}

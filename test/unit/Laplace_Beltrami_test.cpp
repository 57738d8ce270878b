// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stiffness and mass against dense finite elements, on surfaces with loops and multiple edges
// as well; weights against the exact ones.

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace {

using namespace test_surfaces;
using Filtered = IT::Filtered_edge_length_traits;
using Double = IT::Edge_length_traits<double>;
using Matrix = Eigen::SparseMatrix<double>;
using Dense = Eigen::MatrixXd;

// The finite element matrices, corner by corner, from gradients in the plane of each face.
struct Finite_elements
{
  Dense stiffness, mass;
};

template <class Triangulation>
Finite_elements finite_elements(const Triangulation& t)
{
  const IT::Delta_complex& c = t.connectivity();
  const Eigen::Index n = c.number_of_vertices();
  Finite_elements result{Dense::Zero(n, n), Dense::Zero(n, n)};
  for (IT::Face_index f : c.faces()) {
    const IT::Halfedge_index h[3] = {c.halfedge(f), c.next(c.halfedge(f)), c.prev(c.halfedge(f))};
    const double l = t.length(c.edge(h[0])), m = t.length(c.edge(h[1])), k = t.length(c.edge(h[2]));
    const double x = (l * l + k * k - m * m) / (2 * l), y = std::sqrt(k * k - x * x);
    const Eigen::Vector2d corner[3] = {{0, 0}, {l, 0}, {x, y}};
    const double area = l * y / 2;
    Eigen::Vector2d gradient[3];
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d side = corner[(i + 2) % 3] - corner[(i + 1) % 3];
      gradient[i] = Eigen::Vector2d(-side.y(), side.x()) / (2 * area);
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const Eigen::Index v = c.source(h[i]).idx(), w = c.source(h[j]).idx();
        result.stiffness(v, w) += area * gradient[i].dot(gradient[j]);
        result.mass(v, w) += area / (i == j ? 6 : 12);
      }
  }
  return result;
}

void expect_sorted_and_complete(const Matrix& m)
{
  EXPECT_TRUE(m.isCompressed());
  for (int c = 0; c < m.outerSize(); ++c) {
    int last = -1;
    bool has_diagonal = false;
    for (Matrix::InnerIterator i(m, c); i; ++i) {
      EXPECT_LT(last, i.row());
      last = int(i.row());
      has_diagonal = has_diagonal || i.row() == c;
    }
    EXPECT_TRUE(has_diagonal);
  }
}

template <class Triangulation>
void expect_finite_elements(const Triangulation& t)
{
  const Finite_elements expected = finite_elements(t);
  const Matrix stiffness = IT::stiffness_matrix(t), Galerkin = IT::Galerkin_mass_matrix(t),
               lumped = IT::lumped_mass_matrix(t);
  expect_sorted_and_complete(stiffness);
  expect_sorted_and_complete(Galerkin);
  const double largest = expected.stiffness.cwiseAbs().maxCoeff();
  EXPECT_LE((Dense(stiffness) - expected.stiffness).cwiseAbs().maxCoeff(), 1e-8 * (1 + largest));
  EXPECT_LE((Dense(Galerkin) - expected.mass).cwiseAbs().maxCoeff(), 1e-9 * expected.mass.sum());
  EXPECT_LE((Dense(lumped).diagonal() - expected.mass.rowwise().sum()).cwiseAbs().maxCoeff(),
            1e-9 * expected.mass.sum());
  EXPECT_EQ(lumped.nonZeros(), lumped.rows());
  EXPECT_TRUE(Dense(stiffness) == Dense(stiffness).transpose());
  EXPECT_TRUE(Dense(IT::stiffness_matrix(t, IT::Stiffness_factor::ONE)) == 2 * Dense(stiffness));
  EXPECT_TRUE(Dense(IT::stiffness_matrix(t.connectivity(), IT::cotangent_weights(t))) == Dense(stiffness));
}

} // namespace

TEST(Laplace_Beltrami, finite_elements_before_and_after_flips)
{
  for (const Surface& surface : generic_surfaces(false)) {
    SCOPED_TRACE(surface.name);
    auto filtered = triangulation<Filtered>(surface);
    auto rounded = triangulation<Double>(surface);
    expect_finite_elements(filtered);
    expect_finite_elements(rounded);
    IT::flip_to_Delaunay(filtered);
    IT::flip_to_Delaunay(rounded);
    expect_finite_elements(filtered);
    expect_finite_elements(rounded);
  }
}

TEST(Laplace_Beltrami, one_vertex_leaves_nothing_of_the_stiffness)
{
  const auto t = triangulation<Filtered>(from_gluing("", samples::one_vertex_torus()));
  const Matrix stiffness = IT::stiffness_matrix(t), mass = IT::Galerkin_mass_matrix(t);
  EXPECT_EQ(stiffness.nonZeros(), 1);
  EXPECT_EQ(stiffness.coeff(0, 0), 0);
  EXPECT_NEAR(mass.coeff(0, 0), 2 * t.area(IT::Face_index(0)), 1e-12);
}

TEST(Laplace_Beltrami, a_vertex_without_faces_has_a_zero_on_the_diagonal)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  const auto v = mesh.add_vertex({0, 0, 0}), w = mesh.add_vertex({1, 0, 0});
  mesh.add_vertex({5, 5, 5});
  mesh.add_face(v, w, mesh.add_vertex({0, 1, 0}));
  const auto [L, M] = IT::intrinsic_Delaunay_Laplacian(mesh);
  ASSERT_EQ(L.rows(), 4);
  EXPECT_EQ(L.coeff(2, 2), 0);
  EXPECT_EQ(M.coeff(2, 2), 0);
  // cot 90° = 0 opposite to the longest side, cot 45° = 1 opposite to the others.
  EXPECT_EQ(L.coeff(1, 3), 0);
  EXPECT_NEAR(L.coeff(0, 1), -0.5, 1e-15);
  EXPECT_NEAR(L.coeff(0, 0), 1, 1e-15);
  EXPECT_NEAR(M.coeff(0, 0), 1. / 6, 1e-15);
}

TEST(Laplace_Beltrami, the_flipped_edge_is_in_the_intrinsic_operator_alone)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  const auto i = mesh.add_vertex({0, 0, 0}), j = mesh.add_vertex({4, 0, 0}), k = mesh.add_vertex({2, 1, 0}),
             l = mesh.add_vertex({2, -1, 0});
  mesh.add_face(i, j, k);
  mesh.add_face(j, i, l);
  const Matrix extrinsic = IT::extrinsic_Laplacian(mesh).stiffness,
               intrinsic = IT::intrinsic_Delaunay_Laplacian(mesh).stiffness;
  EXPECT_NEAR(extrinsic.coeff(0, 1), 0.75, 1e-14); // both opposite angles have cotangent -3/4
  EXPECT_EQ(extrinsic.coeff(2, 3), 0);
  EXPECT_EQ(intrinsic.coeff(0, 1), 0);
  EXPECT_NEAR(intrinsic.coeff(2, 3), -0.75, 1e-14);
}

TEST(Cotangent_weights, as_near_to_the_exact_ones_as_stated)
{
  std::vector<Surface> surfaces = generic_surfaces(false);
  for (Surface& surface : std::vector<Surface>{from_triangles("strip", samples::strip(300, 20)),
                                               from_triangles("sliver sheet", samples::sliver_sheet(12)),
                                               from_triangles("cap", samples::cap())})
    surfaces.push_back(std::move(surface));
  for (const Surface& surface : surfaces) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<Filtered>(surface);
    IT::flip_to_Delaunay(t);
    const IT::Delta_complex& c = t.connectivity();
    const std::vector<double> weights = IT::cotangent_weights(t), areas = IT::face_areas(t);
    for (IT::Edge_index e : c.edges()) {
      double tolerance = 1;
      for (IT::Halfedge_index h : {c.halfedge(e), c.opposite(c.halfedge(e))})
        tolerance += c.is_border(h) ? 0 : std::abs(t.cotangent(h));
      EXPECT_NEAR(weights[e.idx()], t.cotangent_weight(e), 1.01 * 0x1p-32 * tolerance) << e;
      if (c.is_flippable(e)) {
        EXPECT_EQ(CGAL::sign(weights[e.idx()]), t.sign_of_cotangent_weight(e)) << e;
      }
    }
    for (IT::Face_index f : c.faces())
      EXPECT_NEAR(areas[f.idx()], t.area(f), 1.01 * 0x1p-32 * t.area(f)) << f;
  }
}

// Bit for bit, the numbers from one corner of each face; a missing number is queried.
TEST(Rounded_numbers, are_those_of_single_edges_and_faces)
{
  std::vector<Surface> surfaces = generic_surfaces(false);
  for (Surface& surface : std::vector<Surface>{from_triangles("sliver sheet", samples::sliver_sheet(12)),
                                               from_triangles("cap", samples::cap())})
    surfaces.push_back(std::move(surface));
  std::size_t found = 0, numbers = 0;
  for (const Surface& surface : surfaces)
    for (const bool is_refined : {false, true}) {
      SCOPED_TRACE(surface.name);
      auto t = triangulation<Filtered>(surface);
      // Points in faces of zero area can be those of others.
      const IT::Delta_complex input = t.connectivity();
      if (is_refined && std::any_of(input.faces().begin(), input.faces().end(), [&](IT::Face_index f) {
            return IT::internal::engine(t).sign_of_area(f) != CGAL::POSITIVE;
          }))
        continue;
      IT::flip_to_Delaunay(t);
      for (std::uint32_t f = 0; is_refined && f < 20 && f < input.number_of_faces(); ++f)
        IT::insert_vertex(t, IT::Surface_point{input.halfedge(IT::Face_index(f)), {0.25, 0.5, 0.25}});
      const IT::Delta_complex& c = t.connectivity();
      IT::internal::Rounded_numbers rounded(c);
      const IT::internal::Engine_numbers element_numbers(IT::internal::engine(t));
      const std::size_t half = c.number_of_faces() / 2;
      element_numbers.find_numbers(half, c.number_of_faces(), rounded);
      element_numbers.find_numbers(0, half, rounded);
      const auto expect_same = [&](double x, double expected) {
        ++numbers;
        if (std::isnan(x))
          return true;
        ++found;
        return x == expected;
      };
      for (IT::Edge_index e : c.edges()) {
        EXPECT_TRUE(expect_same(rounded.lengths[e.idx()], t.length(e))) << e;
        if (!c.is_border(e)) {
          const double weight = rounded.cotangent_weight(c, e);
          EXPECT_TRUE(std::isnan(weight) || expect_same(weight, t.cotangent_weight(e))) << e;
        }
      }
      for (IT::Face_index f : c.faces())
        EXPECT_TRUE(expect_same(std::ldexp(rounded.areas[f.idx()], 2 * t.unit_exponent()), t.area(f))) << f;
    }
  EXPECT_GT(found, numbers - numbers / 20);
}

// The bound of the stored cotangents, without which the statement above is luck.
TEST(Cotangent_weights, the_bound_of_a_stored_cotangent_holds)
{
  std::size_t close = 0, corners = 0;
  for (const Surface& surface : generic_surfaces(false)) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<Filtered>(surface);
    IT::flip_to_Delaunay(t);
    const IT::Delta_complex& c = t.connectivity();
    for (IT::Halfedge_index h : c.halfedges()) {
      if (c.is_border(h))
        continue;
      const IT::Bounded_double stored = t.traits().compute_bounded_cotangent_object()(
        t.face_data(c.face(h)), t.edge_data(c.edge(h)), t.edge_data(c.edge(c.next(h))), t.edge_data(c.edge(c.prev(h))));
      const double exact = t.cotangent(h);
      EXPECT_LE(std::abs(stored.value - exact), stored.error + 0x1p-49 * (1 + std::abs(exact))) << h;
      ++corners;
      close += stored.error <= 0x1p-30 * (1 + std::abs(exact));
    }
  }
  EXPECT_GE(close, corners / 2); // an infinite error would be a bound, too
}

// cotangent_weights() gets bounds from any traits that have the functor.
template <class Base, bool is_known>
struct Traits_with_bounds : Base
{
  struct Compute_bounded_cotangent
  {
    template <class Face_data, class Edge_data>
    IT::Bounded_double operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
                                  const Edge_data& ki) const
    {
      ++*number_of_calls;
      const double exact = typename Base::Compute_cotangent()(ijk, ij, jk, ki);
      return {exact, is_known ? 0x1p-50 * (1 + std::abs(exact)) : std::numeric_limits<double>::infinity()};
    }
    std::size_t* number_of_calls;
  };
  Compute_bounded_cotangent compute_bounded_cotangent_object() const { return {number_of_calls.get()}; }

  std::shared_ptr<std::size_t> number_of_calls = std::make_shared<std::size_t>(0);
};

template <class Base, bool is_known>
void expect_same_weights()
{
  const samples::Indexed_triangles sphere = samples::bumpy_sphere(12, 9);
  const auto complex = IT::make_Delta_complex_from_triangles(sphere.points.size(), sphere.triangles);
  const IT::Intrinsic_triangulation<Base> expected(complex, sphere.points);
  const IT::Intrinsic_triangulation<Traits_with_bounds<Base, is_known>> t(complex, sphere.points);
  const std::vector<double> weights = IT::cotangent_weights(t);
  EXPECT_EQ(*t.traits().number_of_calls, complex.number_of_halfedges());
  for (IT::Edge_index e : complex.edges())
    EXPECT_NEAR(weights[e.idx()], expected.cotangent_weight(e), 1e-13) << e;
}

TEST(Cotangent_weights, any_traits_may_bound_cotangents)
{
  expect_same_weights<Double, true>();
  expect_same_weights<Double, false>();
  expect_same_weights<Filtered, true>();
  expect_same_weights<Filtered, false>();
}

// If no stored number suffices, one corner of each face gives the weights of its edges.
TEST(Cotangent_weights, from_one_corner_of_each_face)
{
  using Traits = Traits_with_bounds<Filtered, false>;
  for (const samples::Indexed_triangles& surface :
       {samples::bad_torus(20, 16), samples::bumpy_sphere(12, 9), samples::random_diagonal_grid(12, 9, 1, 0),
        samples::random_diagonal_grid(12, 9, 1, 1)}) {
    const auto complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
    IT::Intrinsic_triangulation<Traits> t(complex, surface.points);
    IT::flip_to_Delaunay(t);
    const std::vector<double> weights = IT::cotangent_weights(t);
    for (IT::Edge_index e : t.connectivity().edges()) {
      const IT::Halfedge_index h = t.connectivity().halfedge(e);
      double size = 1;
      for (IT::Halfedge_index side : {h, t.connectivity().opposite(h)})
        if (!t.connectivity().is_border(side))
          size += std::abs(t.cotangent(side));
      const double exact = t.cotangent_weight(e);
      ASSERT_LE(std::abs(weights[e.idx()] - exact), 0x1p-45 * size) << e;
      ASSERT_EQ(CGAL::sign(weights[e.idx()]), CGAL::sign(exact)) << e;
    }
  }
}

TEST(Cotangent_weights, a_tie_is_exactly_zero_and_nothing_is_negative)
{
  for (std::uint64_t rotation : {0, 1}) {
    auto t = triangulation<Filtered>(from_triangles("", samples::random_diagonal_grid(12, 9, 1, rotation)));
    IT::flip_to_Delaunay(t);
    std::size_t zeros = 0;
    const std::vector<double> weights = IT::cotangent_weights(t);
    for (IT::Edge_index e : t.connectivity().edges()) {
      if (t.connectivity().is_border(e))
        continue;
      EXPECT_GE(weights[e.idx()], 0) << e;
      zeros += weights[e.idx()] == 0;
    }
    if (rotation == 0) {
      EXPECT_EQ(zeros, 12u * 9u);
    }
  }
}

TEST(Cotangent_weights, a_face_without_area_is_an_error_that_names_it)
{
  const auto flat = samples::cap(0);
  const auto expect_error = [](const auto& t) {
    try {
      IT::stiffness_matrix(t);
      FAIL();
    } catch (const IT::Invalid_surface_error& error) {
      EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::DEGENERATE_FACE);
      EXPECT_NE(std::string(error.what()).find("face " + std::to_string(error.element())), std::string::npos);
      EXPECT_EQ(t.area(IT::Face_index(std::uint32_t(error.element()))), 0);
    }
  };
  expect_error(triangulation<Filtered>(from_triangles("", flat)));
  expect_error(triangulation<Double>(from_triangles("", flat)));
}

TEST(Cotangent_weights, large_and_small_units)
{
  for (double scale : {1e-150, 1e-30, 1e60, 1e150}) {
    const Surface surface = from_triangles("", samples::bumpy_sphere(5, 4));
    std::vector<std::array<double, 3>> points;
    for (const auto& p : surface.points)
      points.push_back({scale * p[0], scale * p[1], scale * p[2]});
    const IT::Intrinsic_triangulation<Filtered> large(surface.connectivity, points);
    const auto unit = triangulation<Filtered>(surface);
    const std::vector<double> weights = IT::cotangent_weights(large), expected = IT::cotangent_weights(unit);
    for (std::size_t e = 0; e < weights.size(); ++e)
      EXPECT_NEAR(weights[e], expected[e], 1e-9 * (1 + std::abs(expected[e])));
    const double area = IT::face_areas(large)[0] / scale / scale;
    EXPECT_NEAR(area, IT::face_areas(unit)[0], 1e-9 * area);
  }
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Requirements on each floating-point type as the number type of the traits: it must reach the triangulation of exact
// decisions, from any form of input, with numbers of its own precision. The header uses `Number_types`, a list of types
// for GoogleTest.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/boost_multiprecision_floats.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/multiprecision/mpfr.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace float_type_tests {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::convert_number;

// Of several times the precision of the types under test.
using Reference =
  boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<150>, boost::multiprecision::et_off>;

template <class FT>
constexpr int precision = std::numeric_limits<FT>::digits;
#ifdef __SIZEOF_FLOAT128__
template <>
constexpr int precision<__float128> = 113; // the standard library does not always know it
#endif

// Surfaces with flips and without ties, whose numbers are near one; the smaller one is small enough for exact numbers.
inline const samples::Indexed_triangles& surface()
{
  static const samples::Indexed_triangles triangles = samples::bad_torus(9, 8);
  return triangles;
}
inline const samples::Indexed_triangles& small_surface()
{
  static const samples::Indexed_triangles triangles = samples::bad_torus(4, 4);
  return triangles;
}

// The surface with all coordinates multiplied by a number of the kernel.
template <class Mesh, class Point, class FT>
Mesh mesh_of(const samples::Indexed_triangles& triangles, const FT& factor)
{
  Mesh mesh;
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertices;
  for (const auto& p : triangles.points) {
    vertices.push_back(add_vertex(mesh));
    put(get(CGAL::vertex_point, mesh), vertices.back(), Point(FT(p[0]) * factor, FT(p[1]) * factor, FT(p[2]) * factor));
  }
  for (const auto& [i, j, k] : triangles.triangles)
    CGAL::Euler::add_face(std::array{vertices[i], vertices[j], vertices[k]}, mesh);
  return mesh;
}

// The largest error, in units of the last place of numbers near one.
template <class FT>
double error(const FT& x, const Reference& exact)
{
  const Reference difference = convert_number<Reference>(x) - exact;
  return std::ldexp(CGAL::to_double(Reference(CGAL::abs(difference) / (1 + CGAL::abs(exact)))), precision<FT>);
}

template <class Triangulation, class Exact>
void expect_close(const Triangulation& triangulation, const Exact& exact, double bound)
{
  double largest = 0;
  for (IT::Edge_index e : triangulation.connectivity().edges())
    largest = (std::max)({largest, error(triangulation.length(e), exact.length(e)),
                          error(triangulation.cotangent_weight(e), exact.cotangent_weight(e))});
  for (IT::Face_index f : triangulation.connectivity().faces())
    largest = (std::max)(largest, error(triangulation.area(f), exact.area(f)));
  EXPECT_LT(largest, bound);
}

// Whether the surface, which `construct` makes for any traits, becomes the same triangulation as by exact decisions.
template <class FT, class ExactTraits = IT::Filtered_edge_length_traits, class Construct>
void expect_triangulation(const Construct& construct)
{
  auto exact = construct(ExactTraits());
  EXPECT_GT(IT::flip_to_Delaunay(exact).flips, 5u);
  auto reference = construct(IT::Edge_length_traits<Reference>());
  IT::flip_to_Delaunay(reference);
  ASSERT_TRUE(reference.connectivity() == exact.connectivity());
  for (IT::Edge_index e : exact.connectivity().edges()) {
    const double length = CGAL::to_double(exact.length(e));
    EXPECT_NEAR(CGAL::to_double(reference.length(e)), length, 1e-15 * length);
  }

  auto by_lengths = construct(IT::Edge_length_traits<FT>());
  EXPECT_EQ(IT::flip_to_Delaunay(by_lengths).status, IT::Flip_status::DELAUNAY);
  ASSERT_TRUE(by_lengths.connectivity() == exact.connectivity());
  expect_close(by_lengths, reference, 64);
  auto by_half_angles = construct(IT::Half_angle_traits<FT>());
  EXPECT_EQ(IT::flip_to_Delaunay(by_half_angles).status, IT::Flip_status::DELAUNAY);
  ASSERT_TRUE(by_half_angles.connectivity() == exact.connectivity());
  expect_close(by_half_angles, reference, 1024);
}

template <class Mesh>
auto from(const Mesh& mesh)
{
  return
    [&mesh](const auto& traits) { return IT::intrinsic_triangulation(mesh, CGAL::parameters::geom_traits(traits)); };
}

template <class FT>
class Float_type : public testing::Test
{};
TYPED_TEST_SUITE(Float_type, Number_types);

// Exact numbers reach the type with all of its digits, also where they are beyond double.
TYPED_TEST(Float_type, is_next_to_an_exact_number)
{
  using Rational = CGAL::Exact_predicates_exact_constructions_kernel::FT;
  using Real = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
  const TypeParam one(1), ulp(std::ldexp(1., 1 - precision<TypeParam>));
  const TypeParam third = convert_number<TypeParam>(Rational(1) / 3);
  EXPECT_LE(CGAL::abs(TypeParam(third * 3 - one)), ulp);
  EXPECT_EQ(third, one / 3);
  const TypeParam root = convert_number<TypeParam>(CGAL::sqrt(Real(2)));
  EXPECT_LE(CGAL::abs(TypeParam(root * root - 2)), 4 * ulp);
  EXPECT_LE(CGAL::abs(TypeParam(root - CGAL::sqrt(TypeParam(2)))), ulp);
  for (double power : {0x1p-900, 0x1p900}) {
    const Rational beyond_double = Rational(power) * Rational(power) / 3;
    EXPECT_EQ(convert_number<TypeParam>(beyond_double), third * TypeParam(power) * TypeParam(power));
    EXPECT_EQ(convert_number<TypeParam>(Rational(-beyond_double)), -third * TypeParam(power) * TypeParam(power));
  }
  EXPECT_EQ(convert_number<TypeParam>(Rational(0)), TypeParam(0));
  const auto back = convert_number<IT::internal::Rational>(third); // exact
  EXPECT_EQ(convert_number<TypeParam>(back), third);
  EXPECT_NE(back, convert_number<IT::internal::Rational>(TypeParam(third + third * ulp)));
}

TYPED_TEST(Float_type, takes_arrays_of_points_and_triangles)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(surface().points.size(), surface().triangles);
  expect_triangulation<TypeParam>([&](const auto& traits) {
    return IT::Intrinsic_triangulation<std::decay_t<decltype(traits)>>(complex, surface().points, traits);
  });
}

TYPED_TEST(Float_type, takes_lengths)
{
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(surface().points.size(), surface().triangles);
  const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> in_space(complex, surface().points);
  expect_triangulation<TypeParam>([&](const auto& traits) {
    using Traits = std::decay_t<decltype(traits)>;
    std::vector<typename Traits::FT> lengths;
    for (IT::Edge_index e : complex.edges())
      lengths.emplace_back(in_space.length(e));
    return IT::Intrinsic_triangulation<Traits>::from_lengths(complex, std::move(lengths), traits);
  });
}

TYPED_TEST(Float_type, takes_meshes_with_points_of_doubles)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  expect_triangulation<TypeParam>(from(mesh_of<CGAL::Surface_mesh<Point>, Point>(surface(), 1.)));
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  expect_triangulation<TypeParam>(from(mesh_of<CGAL::Surface_mesh<Kernel::Point_3>, Kernel::Point_3>(surface(), 1.)));
  expect_triangulation<TypeParam>(from(mesh_of<CGAL::Polyhedron_3<Kernel>, Kernel::Point_3>(surface(), 1.)));
}

// A third is not representable in any of the types.
TYPED_TEST(Float_type, takes_meshes_with_rational_points)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const Kernel::FT third = Kernel::FT(1) / 3;
  expect_triangulation<TypeParam>(
    from(mesh_of<CGAL::Surface_mesh<Kernel::Point_3>, Kernel::Point_3>(surface(), third)));
}

TYPED_TEST(Float_type, takes_meshes_with_algebraic_points)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt;
  expect_triangulation<TypeParam, IT::Edge_length_traits<Kernel::FT>>(
    from(mesh_of<CGAL::Surface_mesh<Kernel::Point_3>, Kernel::Point_3>(small_surface(), CGAL::sqrt(Kernel::FT(2)))));
}

// Without traits, surfaces given in these types are decided exactly.
TYPED_TEST(Float_type, takes_meshes_with_its_own_points)
{
  using Point = typename CGAL::Simple_cartesian<TypeParam>::Point_3;
  const TypeParam third = TypeParam(1) / TypeParam(3);
  const auto mesh = mesh_of<CGAL::Surface_mesh<Point>, Point>(surface(), third);
  expect_triangulation<TypeParam>(from(mesh));
}

} // namespace float_type_tests

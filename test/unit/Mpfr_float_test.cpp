// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The MPFR number type: scopes of precision, and a triangulation at each precision.

#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>

#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Mpfr_float;
using IT::Mpfr_precision;
using IT::precision_in_bits;
using Algebraic = CGAL::Algebraic_structure_traits<Mpfr_float>;
using Real = CGAL::Real_embeddable_traits<Mpfr_float>;

static_assert(std::is_same<Algebraic::Algebraic_category, CGAL::Field_with_sqrt_tag>::value, "");
static_assert(!Algebraic::Is_exact::value, "");
static_assert(Real::Is_real_embeddable::value, "");
static_assert(std::is_same<Real::Boolean, bool>::value, "");

namespace {

// The default precision.
int default_bits() { return precision_in_bits(Mpfr_float()); }

template <class Kernel>
CGAL::Surface_mesh<typename Kernel::Point_3> squeezed_sphere()
{
  using Point = typename Kernel::Point_3;
  CGAL::Surface_mesh<Point> sphere;
  CGAL::make_icosahedron(sphere, Point(0, 0, 0), 2.);
  for (auto v : sphere.vertices()) {
    const Point p = sphere.point(v);
    sphere.point(v) = Point(p.x(), p.y() / 5, p.z());
  }
  return sphere;
}

template <class Kernel>
void expect_triangulation_of(int bits)
{
  const Mpfr_precision guard(bits);
  const auto sphere = squeezed_sphere<Kernel>();
  const auto [idt, report] =
    IT::intrinsic_Delaunay_triangulation(sphere, CGAL::parameters::geom_traits(IT::Edge_length_traits<Mpfr_float>()));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(report.flips, 0u);
  for (IT::Edge_index e : idt.connectivity().edges()) {
    EXPECT_TRUE(idt.is_locally_Delaunay(e));
    EXPECT_EQ(precision_in_bits(idt.edge_data(e)), guard.bits());
    EXPECT_EQ(precision_in_bits(idt.length(e)), guard.bits());
    EXPECT_EQ(precision_in_bits(idt.cotangent_weight(e)), guard.bits());
  }
  Mpfr_float area(0), area_before(0);
  for (IT::Face_index f : idt.connectivity().faces()) {
    EXPECT_EQ(precision_in_bits(idt.face_data(f)), guard.bits());
    area += idt.area(f);
  }
  const auto before =
    IT::intrinsic_triangulation(sphere, CGAL::parameters::geom_traits(IT::Edge_length_traits<Mpfr_float>()));
  for (IT::Face_index f : before.connectivity().faces())
    area_before += before.area(f);
  // The error of the area shows that all these bits are used.
  const Mpfr_float error = CGAL::abs(area - area_before) / area_before;
  EXPECT_LT(error, Mpfr_float(std::ldexp(64., -bits)));
}

} // namespace

TEST(Mpfr_precision, is_the_least_that_suffices_and_is_restored)
{
  const int before = default_bits();
  for (int bits : {1, 2, 16, 24, 53, 64, 65, 113, 128, 256, 257, 500, 1000, 4096}) {
    const Mpfr_precision guard(bits);
    EXPECT_GE(guard.bits(), bits);
    EXPECT_LE(guard.bits(), std::max(bits + 3, 5)) << bits; // a digit has 3.3 bits
    EXPECT_EQ(default_bits(), guard.bits());
    {
      const Mpfr_precision inner(2 * bits);
      EXPECT_EQ(default_bits(), inner.bits());
    }
    EXPECT_EQ(default_bits(), guard.bits());
  }
  EXPECT_EQ(default_bits(), before);
  EXPECT_EQ(Mpfr_precision(64).bits(), 65);
  EXPECT_EQ(Mpfr_precision(128).bits(), 128);
  EXPECT_EQ(Mpfr_precision(256).bits(), 257);
}

TEST(Mpfr_precision, survives_every_operation)
{
  for (int bits : {24, 64, 128, 256, 1000}) {
    const Mpfr_precision guard(bits);
    const Mpfr_float x(2), y(0.1), z(3u), l(0.1L);
    Mpfr_float sum = x;
    sum += y;
    sum *= 3;
    Mpfr_float assigned;
    assigned = sum;
    Mpfr_float from_double;
    from_double = 0.1;
    std::swap(assigned, from_double);
    const std::vector<Mpfr_float> values{x,
                                         y,
                                         z,
                                         l,
                                         sum,
                                         assigned,
                                         from_double,
                                         -x,
                                         x + y,
                                         x - y,
                                         x * y,
                                         x / z,
                                         x + 1,
                                         2 * y,
                                         1. / z,
                                         y / 7.,
                                         Mpfr_float("0.1"),
                                         CGAL::sqrt(x),
                                         CGAL::abs(-y),
                                         CGAL::square(y),
                                         (std::max)(x, y),
                                         Algebraic::Integral_division()(x, z),
                                         CGAL::sqrt(x * y + z) / (x - y * 2)};
    for (const Mpfr_float& v : values)
      EXPECT_EQ(precision_in_bits(v), guard.bits());
    EXPECT_EQ(default_bits(), guard.bits());
  }
}

TEST(Mpfr_float, computes_to_its_precision)
{
  const Mpfr_precision guard(256);
  const Mpfr_float two(2);
  const Mpfr_float error = CGAL::abs(CGAL::sqrt(two) * CGAL::sqrt(two) - two);
  EXPECT_LT(error, Mpfr_float(std::ldexp(1., -250)));
  EXPECT_NE(Mpfr_float("0.1"), Mpfr_float(0.1));
}

TEST(Mpfr_float, has_signs_and_an_order)
{
  const Mpfr_float zero(0), small(1e-300), big(1e300);
  const Mpfr_float tiny = small * small; // not a double
  EXPECT_EQ(CGAL::sign(tiny), CGAL::POSITIVE);
  EXPECT_EQ(CGAL::sign(-tiny), CGAL::NEGATIVE);
  EXPECT_EQ(CGAL::sign(zero), CGAL::ZERO);
  EXPECT_EQ(CGAL::compare(tiny, small), CGAL::SMALLER);
  EXPECT_EQ(CGAL::compare(big, small), CGAL::LARGER);
  EXPECT_EQ(CGAL::compare(big, big), CGAL::EQUAL);
  EXPECT_EQ(CGAL::compare(small, 1), CGAL::SMALLER);
  EXPECT_EQ(CGAL::abs(-big), big);
  EXPECT_TRUE(CGAL::is_zero(zero));
  EXPECT_FALSE(CGAL::is_zero(tiny));
  EXPECT_TRUE(CGAL::is_positive(tiny));
  EXPECT_TRUE(CGAL::is_negative(-tiny));
  EXPECT_TRUE(CGAL::is_finite(big * big));
  EXPECT_FALSE(CGAL::is_finite(big / zero));
  EXPECT_FALSE(CGAL::is_finite(zero / zero));
}

TEST(Mpfr_float, is_enclosed_by_neighboring_doubles)
{
  const Mpfr_precision guard(128);
  const double infinity = std::numeric_limits<double>::infinity();
  const Mpfr_float third = Mpfr_float(1) / 3;
  for (const Mpfr_float& x : {third, Mpfr_float(-third), Mpfr_float(third * 1e-310)}) {
    const std::pair<double, double> range = CGAL::to_interval(x);
    EXPECT_LT(Mpfr_float(range.first), x);
    EXPECT_GT(Mpfr_float(range.second), x);
    EXPECT_EQ(std::nextafter(range.first, infinity), range.second);
    EXPECT_TRUE(CGAL::to_double(x) == range.first || CGAL::to_double(x) == range.second);
  }
  EXPECT_EQ(CGAL::to_interval(Mpfr_float(0.1)), std::make_pair(0.1, 0.1));
  EXPECT_EQ(CGAL::to_double(third), 1. / 3.);
  const Mpfr_float huge = Mpfr_float(1e300) * 1e300;
  EXPECT_EQ(CGAL::to_interval(huge), std::make_pair((std::numeric_limits<double>::max)(), infinity));
  EXPECT_EQ(CGAL::to_interval(Mpfr_float(1 / huge)).first, 0.);
  EXPECT_GT(CGAL::to_interval(Mpfr_float(1 / huge)).second, 0.);
}

TEST(Mpfr_float, runs_the_triangulation_at_64_128_and_256_bits)
{
  for (int bits : {64, 128, 256}) {
    SCOPED_TRACE(bits);
    expect_triangulation_of<CGAL::Exact_predicates_inexact_constructions_kernel>(bits);
    expect_triangulation_of<CGAL::Exact_predicates_exact_constructions_kernel>(bits);
  }
}

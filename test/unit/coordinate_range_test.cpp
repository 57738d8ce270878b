// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// At the ends of the range of double, the examination refuses exactly the surfaces that the constructors refuse, for
// the same reason.

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/number_utils.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Defect = IT::Invalid_surface_error::Defect;
using Points = std::vector<std::array<double, 3>>;
using Triangles = std::vector<std::array<std::size_t, 3>>;

constexpr double least = 0x1p-1074;
constexpr double infinity = std::numeric_limits<double>::infinity();
// The smallest number whose square is not rounded to zero.
const double smallest_root = std::sqrt(2.) * 0x1p-538;

template <class Construct>
std::optional<Defect> refusal(const Construct& construct)
{
  try {
    construct();
    return std::nullopt;
  } catch (const IT::Invalid_surface_error& error) {
    return error.defect();
  }
}

template <class Traits>
std::optional<Defect> refusal_of_constructor(const Points& points, const Triangles& triangles)
{
  return refusal([&] {
    const IT::Intrinsic_triangulation<Traits> t(IT::make_Delta_complex_from_triangles(points.size(), triangles),
                                                points);
    for (IT::Edge_index e : t.connectivity().edges())
      EXPECT_TRUE(t.squared_length(e) >= 0 && t.edge_data(e) > 0 && std::isfinite(t.edge_data(e)));
    for (IT::Face_index f : t.connectivity().faces()) {
      const IT::Halfedge_index h = t.connectivity().halfedge(f);
      EXPECT_TRUE(std::isfinite(t.traits().compute_area_object()(t.face_data(f), t.edge_data(t.connectivity().edge(h)),
                                                                 t.edge_data(t.connectivity().edge(h)),
                                                                 t.edge_data(t.connectivity().edge(h)))));
    }
    const IT::Input_metric metric = IT::Input_metric::from_points(t.connectivity(), {points.begin(), points.end()});
    EXPECT_EQ(metric.unit_exponent(), t.unit_exponent());
    metric.check(t.connectivity());
  });
}

// Returns their common message.
std::optional<Defect> common_refusal(const Points& points, const Triangles& triangles)
{
  const IT::Surface_report report = IT::examine_polygons(points, triangles);
  const std::string text = IT::message(report);
  const std::optional<Defect> examination = refusal([&] { IT::throw_if_fatal(report); });
  EXPECT_EQ(examination, refusal_of_constructor<IT::Filtered_edge_length_traits>(points, triangles)) << text;
  EXPECT_EQ(examination, refusal_of_constructor<IT::Edge_length_traits<double>>(points, triangles)) << text;
  std::size_t findings = report.gaps.size();
  for (const IT::Finding& finding : report.findings)
    findings += finding.defect != IT::Invalid_surface_error::Defect::SEVERAL_COMPONENTS;
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(points.size(), triangles);
  EXPECT_EQ(IT::is_clean(complex, points), findings == 0) << text;
  return examination;
}

struct Case
{
  const char* name;
  std::optional<Defect> refusal;
  Points points;
  Triangles triangles = {{0, 1, 2}};
};

const std::optional<Defect> none;

const Case cases[] = {
  {"the smallest triangle", none, {{0, 0, 0}, {least, 0, 0}, {0, least, 0}}},
  {"coordinates below all normal numbers", none, {{1e-320, 0, 0}, {3e-320, 1e-320, 0}, {0, 2e-320, 5e-321}}},
  {"a difference that is subnormal", none, {{0x1p-1022, 0, 0}, {0x1.1p-1022, 0, 0}, {0, 0x1p-1022, 0}}},
  {"the largest triangle", none, {{-1.7e308, 0, 0}, {1.7e308, 0, 0}, {0, 1.7e308, -1.7e308}}},
  {"a unit in the last place, far away",
   none,
   {{1e308, 0, 0}, {std::nextafter(1e308, infinity), 1e292, 0}, {1e308, 0, 1e292}}},
  {"a small edge beside 1", none, {{0, 0, 0}, {1e-150, 0, 0}, {0, 1, 0}}},
  {"an edge whose square vanishes", Defect::OUT_OF_RANGE, {{0, 0, 0}, {1e-200, 0, 0}, {0, 1, 0}}},
  {"a subnormal edge beside 1", Defect::OUT_OF_RANGE, {{0, 0, 0}, {1e-320, 0, 0}, {0, 1, 0}}},
  {"the shortest edge beside 1", none, {{0, 0, 0}, {smallest_root, 0, 0}, {0, 1, 0}}},
  {"a little less", Defect::OUT_OF_RANGE, {{0, 0, 0}, {std::nextafter(smallest_root, 0.), 0, 0}, {0, 1, 0}}},
  {"three components, each of which vanishes",
   Defect::OUT_OF_RANGE,
   {{0, 0, 0}, {0x1p-538, 0x1p-538, 0x1p-538}, {0, 1, 0}}},
  {"squares that fit, but not their products", Defect::OUT_OF_RANGE, {{0, 0, 0}, {1e-150, 0, 0}, {0, 1e140, 0}}},
  {"a coordinate that is lost, no short edge", Defect::OUT_OF_RANGE, {{1e-320, 0, 0}, {1e250, 0, 0}, {0, 1e250, 0}}},
  {"some of its bits are lost", Defect::OUT_OF_RANGE, {{0x1.8p-900, 0, 0}, {0x1p276, 0, 0}, {0, 0x1p276, 0}}},
  {"none of its bits is lost", none, {{0x1p-900, 0, 0}, {0x1p275, 0, 0}, {0, 0x1p275, 0}}},
  {"a tiny surface in a plane far away", none, {{1e308, 0, 0}, {1e308, 1e-300, 0}, {1e308, 0, 1e-300}}},
  {"a large surface in a plane nearly through zero", none, {{1e-320, 0, 0}, {1e-320, 1e300, 0}, {1e-320, 0, 1e300}}},
  {"an isolated vertex far away", none, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1e300, 0, 0}}},
  {"a tiny surface beside an isolated vertex", none, {{0, 0, 0}, {1e-250, 0, 0}, {0, 1e-250, 0}, {1, 0, 0}}},
  {"an isolated vertex that would overflow", none, {{0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}, {1e300, 0, 0}}},
  {"an isolated vertex that would underflow", none, {{0, 0, 0}, {1e300, 0, 0}, {0, 1e300, 0}, {1e-320, 0, 0}}},
  {"an isolated vertex that is nowhere", Defect::NOT_FINITE, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {infinity, 0, 0}}},
  {"a coincidence", Defect::ZERO_LENGTH_EDGE, {{1e-320, 0, 0}, {1e-320, 0, 0}, {0, 1e-320, 0}}},
  {"two components, one of them too small",
   Defect::OUT_OF_RANGE,
   {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}},
   {{0, 1, 2}, {3, 4, 5}}}};

TEST(Coordinate_range, Of_the_examination_is_that_of_the_constructors)
{
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(common_refusal(c.points, c.triangles), c.refusal);
  }
}

TEST(Coordinate_range, Is_the_same_for_coordinates_of_any_magnitude)
{
  std::mt19937 random(11);
  const auto number = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  std::size_t accepted = 0, refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const int middle = number(-1074, 1022), width = number(0, 3) == 0 ? 2200 : number(0, 700);
    Points points;
    for (int v = 0; v < 5; ++v) {
      points.emplace_back();
      for (double& x : points.back())
        if (number(0, 2) != 0)
          x = std::ldexp(number(-8, 8) / 8., (std::max)(-1071, (std::min)(1023, middle + number(-width, width) / 2)));
    }
    const Triangles triangles = {{0, 1, 2}, {2, 1, 3}};
    // If there are several defects, each function looks for them in its own order.
    bool has_coincidence = false;
    for (const auto& [a, b] : std::vector<std::array<std::size_t, 2>>{{0, 1}, {1, 2}, {2, 0}, {1, 3}, {3, 2}})
      has_coincidence = has_coincidence || points[a] == points[b];
    if (has_coincidence)
      continue;
    ++(common_refusal(points, triangles) ? refused : accepted);
    ASSERT_FALSE(HasFailure()) << round;
  }
  EXPECT_GT(accepted, 500u);
  EXPECT_GT(refused, 500u);
}

TEST(Coordinate_range, Names_the_vertex_whose_coordinate_is_lost)
{
  const Points points = {{1e250, 0, 0}, {1e-320, 0, 0}, {0, 1e250, 0}};
  const IT::Surface_report report = IT::examine_polygons(points, Triangles{{0, 1, 2}});
  const IT::Finding* const finding = report.find(IT::Invalid_surface_error::Defect::OUT_OF_RANGE);
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(report.first_fatal(), finding);
  EXPECT_EQ(finding->elements, std::vector<std::size_t>{1});
  EXPECT_TRUE(finding->edges.empty());
  EXPECT_NE(IT::message(report).find("vertex 1 at (9.99989e-321, 0, 0)"), std::string::npos) << IT::message(report);
}

// Four times an area may be subnormal in the unit of the stored numbers, or in that of the input, and has few bits
// then.
TEST(Coordinate_range, Of_numbers_of_a_face_far_smaller_than_the_surface)
{
  struct Small_face
  {
    int leg, surface; // as powers of two
  };
  for (const Small_face& face : {Small_face{-200, 332}, {-505, 0}, {-515, 0}, {-530, 0}, {100, 632}, {490, 1000}}) {
    SCOPED_TRACE(face.leg);
    const double h = std::ldexp(1., face.leg), l = std::ldexp(1., face.surface);
    const Points points = {{0, 0, 0}, {3 * h, 0, 0}, {0, 4 * h, 0}, {0, 0, l}};
    const Triangles triangles = {{0, 1, 2}, {1, 0, 3}};
    const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
      IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
    const IT::Delta_complex& complex = t.connectivity();
    const IT::Face_index f(0);
    EXPECT_DOUBLE_EQ(t.area(f), 6 * h * h);
    for (IT::Halfedge_index side :
         {complex.halfedge(f), complex.next(complex.halfedge(f)), complex.prev(complex.halfedge(f))}) {
      const std::size_t at = complex.target(complex.next(side)).idx();
      EXPECT_NEAR(IT::angle(t, side),
                  at == 0   ? std::atan2(1., 0.)
                  : at == 1 ? std::atan2(4., 3.)
                            : std::atan2(3., 4.),
                  1e-15);
    }
  }
}

// A square with one corner moved by the smallest number is not a tie, but its coordinate underflows when it is scaled
// with the others.
TEST(Coordinate_range, Of_decisions_that_the_smallest_number_makes)
{
  const double q = 0x1p25;
  for (double y : {least, -least, 0.})
    for (bool other_diagonal : {false, true}) {
      const Points points = {{0, 0, 0}, {q, y, 0}, {q, q, 0}, {0, q, 0}};
      const Triangles triangles = other_diagonal ? Triangles{{0, 1, 2}, {0, 2, 3}} : Triangles{{0, 1, 3}, {1, 2, 3}};
      IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
        IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
      const bool is_Delaunay = y == 0 || (y > 0) != other_diagonal;
      EXPECT_EQ(IT::flip_to_Delaunay(t).flips, is_Delaunay ? 0u : 1u) << y << other_diagonal;
      const auto verification = IT::verify_Delaunay(t);
      EXPECT_TRUE(verification.is_Delaunay());
      EXPECT_EQ(verification.ties, y == 0 ? 1u : 0u);
    }
}

// The cotangent is smaller than any double.
TEST(Coordinate_range, Of_weights_that_the_smallest_number_makes)
{
  for (double q : {1., 0x1p25})
    for (double y : {least, -least, 0.}) {
      const Points points = {{0, 0, 0}, {q, y, 0}, {0, q, 0}};
      const IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> t(
        IT::make_Delta_complex_from_triangles(points.size(), Triangles{{0, 1, 2}}), points);
      for (IT::Edge_index e : t.connectivity().edges()) {
        const IT::Halfedge_index h = t.connectivity().halfedge(e);
        if (t.connectivity().source(h).idx() != 0 && t.connectivity().target(h).idx() != 0) {
          EXPECT_EQ(CGAL::sign(t.cotangent_weight(e)), CGAL::sign(y)) << q << ' ' << y;
          EXPECT_EQ(CGAL::sign(IT::cotangent_weights(t)[e.idx()]), CGAL::sign(y)) << q << ' ' << y;
        }
      }
    }
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A common subdivision is independent: flips, copies and the end of its source do not change it.

#include "overlay_surfaces.h"

#include "library/engine/history/Flip_log.h"
#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using test_surfaces::Triangulation;

static_assert(std::is_constructible<IT::Point_location, const IT::Common_subdivision&>::value, "");
static_assert(!std::is_constructible<IT::Point_location, IT::Common_subdivision>::value,
              "it refers to the subdivision");

Triangulation Delaunay_triangulation(const samples::Indexed_triangles& surface)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  IT::flip_to_Delaunay(t);
  return t;
}

// Its results: combinatorics, positions, areas (from the exact geometry) and locations (from all of it).
std::vector<double> answers(const IT::Common_subdivision& s)
{
  std::vector<double> result = IT::face_areas(s);
  for (IT::Overlay::Vertex x : s.overlay().crossings())
    result.insert(result.end(), {double(s.overlay().input_edge(x).idx()), double(s.overlay().intrinsic_edge(x).idx()),
                                 s.positions().on_input_edge(x), s.positions().on_intrinsic_edge(x)});
  const IT::Point_location location(s);
  for (IT::Face_index f : s.input().faces()) {
    const IT::Surface_point p = location.input_to_intrinsic({s.input().halfedge(f), {1, 1, 1}});
    result.push_back(double(p.halfedge.idx()));
    result.insert(result.end(), p.coordinates.begin(), p.coordinates.end());
  }
  return result;
}

TEST(Common_subdivision, later_flips_do_not_change_it)
{
  Triangulation t = Delaunay_triangulation(samples::bad_torus(10, 12));
  const IT::Common_subdivision subdivision(t);
  ASSERT_GT(subdivision.overlay().number_of_crossings(), 50u);
  const std::vector<double> before = answers(subdivision);
  std::size_t flips = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    if (t.connectivity().is_flippable(e))
      flips += t.flip(e) == Triangulation::Flip_outcome::FLIPPED;
  ASSERT_GT(flips, 50u);
  EXPECT_EQ(answers(subdivision), before);
  EXPECT_NE(answers(IT::Common_subdivision(t)), before);
}

TEST(Common_subdivision, outlives_what_it_was_made_from)
{
  auto t = std::make_unique<Triangulation>(Delaunay_triangulation(samples::bumpy_sphere(16, 10)));
  auto first = std::make_unique<IT::Common_subdivision>(*t);
  const std::vector<double> expected = answers(*first);
  t.reset();
  EXPECT_EQ(answers(*first), expected);
  const IT::Common_subdivision copy = *first;
  const IT::Common_subdivision moved = std::move(*first);
  first.reset();
  EXPECT_EQ(answers(copy), expected);
  EXPECT_EQ(answers(moved), expected);
}

TEST(Common_subdivision, of_a_triangulation_that_is_given_up)
{
  Triangulation t = Delaunay_triangulation(samples::bumpy_sphere(16, 10));
  const std::vector<double> expected = answers(IT::Common_subdivision(t));
  Triangulation unasked = Delaunay_triangulation(samples::bumpy_sphere(16, 10));
  for (Triangulation* given_up : {&t, &unasked}) { // with integers, and with a log of flips
    const IT::Common_subdivision subdivision(std::move(*given_up));
    EXPECT_EQ(answers(subdivision), expected);
    EXPECT_EQ(given_up->connectivity().number_of_edges(), 0u); // nothing was copied
  }
}

TEST(Common_subdivision, forgets_who_could_interrupt_what_was_given_up)
{
  Triangulation t = Delaunay_triangulation(samples::bumpy_sphere(16, 10));
  bool goes_on = true;
  t.set_interruption([&] { return goes_on; });
  const IT::Common_subdivision subdivision(std::move(t));
  goes_on = false;
  EXPECT_NO_THROW(IT::internal::engine(subdivision).decisions().interruption.check());
}

// From a triangulation whose integers were not computed yet.
TEST(Common_subdivision, prepares_the_integers)
{
  const samples::Indexed_triangles surface = samples::bad_torus(10, 12);
  const IT::Delta_complex input = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  const Triangulation t = Delaunay_triangulation(surface);
  IT::Intrinsic_triangulation<IT::Edge_length_traits<double>> rounded(input, surface.points);
  rounded.keep_input(
    IT::Input_metric::from_points(IT::Input_metric::Point_vector(surface.points.begin(), surface.points.end())));
  const IT::Delta_complex& complex = rounded.connectivity();
  bool is_changed = true;
  while (is_changed) {
    is_changed = false;
    for (IT::Edge_index e : complex.edges()) {
      // Queries a copy, so that only the log exists.
      if (!complex.is_flippable(e) || decltype(rounded)(rounded).sign_of_cotangent_weight(e) != CGAL::NEGATIVE)
        continue;
      rounded.flip(e);
      is_changed = true;
    }
  }
  ASSERT_GT(IT::internal::Engine_access::engine(rounded).log().size(), 0u);
  const IT::Common_subdivision subdivision(rounded);
  ASSERT_GT(subdivision.overlay().number_of_crossings(), 50u);
  EXPECT_EQ(subdivision.overlay().number_of_crossings(), IT::Overlay(t).number_of_crossings());
  double area = 0, expected = 0;
  for (double a : IT::face_areas(subdivision))
    area += a;
  for (IT::Face_index f : t.connectivity().faces())
    expected += t.area(f);
  EXPECT_NEAR(area, expected, 1e-12 * expected);
}

// Claims that every hinge is convex.
struct Careless_traits : IT::Edge_length_traits<double>
{
  struct Construct_flipped_hinge
  {
    bool operator()(const Hinge_data& h, Flipped_hinge_data& flipped) const
    {
      IT::Edge_length_traits<double>::Construct_flipped_hinge()(h, flipped);
      return true;
    }
  };
  Construct_flipped_hinge construct_flipped_hinge_object() const { return {}; }
};

// The other diagonal of a dart runs outside of it, so there is no crossing to be located.
TEST(Common_subdivision, of_what_is_no_triangulation_of_the_surface)
{
  for (double height : {0., 0.25}) { // in a plane, and bent
    const samples::Indexed_triangles dart{{{0, 0, 0}, {4, 0, 0}, {-1, 1, height}, {-1, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
    IT::Intrinsic_triangulation<Careless_traits> t(
      IT::make_Delta_complex_from_triangles(dart.points.size(), dart.triangles), dart.points);
    t.keep_input(IT::Input_metric::from_points({dart.points.begin(), dart.points.end()}));
    for (IT::Edge_index e : t.connectivity().edges())
      if (t.connectivity().is_flippable(e))
        t.flip(e);
    try {
      IT::Common_subdivision subdivision(t);
      FAIL() << "was accepted";
    } catch (const IT::Undecided_error& error) {
      EXPECT_NE(std::string(error.what()).find("is no straight line"), std::string::npos) << error.what();
    }
  }
}

// The points are the caller's: as they were, moved, or of another type.
TEST(Common_subdivision, points_in_space)
{
  const samples::Indexed_triangles kite{{{0, 0, 0}, {8, 0, 0}, {3, 2, 0}, {2, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}};
  const IT::Common_subdivision subdivision(Delaunay_triangulation(kite));
  ASSERT_EQ(subdivision.overlay().number_of_crossings(), 1u);
  const IT::Overlay::Vertex x = *subdivision.overlay().crossings().begin();
  const auto p = subdivision.point(x, kite.points);
  EXPECT_NEAR(p[0], 7. / 3, 1e-15);
  EXPECT_EQ(p[1], 0);
  EXPECT_EQ(p[2], 0);
  std::vector<std::array<float, 3>> lifted;
  for (const auto& q : kite.points)
    lifted.push_back({float(q[0]), float(q[1]), 5});
  EXPECT_EQ(subdivision.point(x, lifted)[2], 5);
  EXPECT_EQ(subdivision.point(IT::Overlay::Vertex(2), kite.points), (std::array<double, 3>{3, 2, 0}));
}

} // namespace

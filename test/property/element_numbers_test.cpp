// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers of all elements equal those of single queries, for every kind of traits.

#include "flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>
#include <vector>

namespace {

using namespace test_surfaces;
using Filtered = IT::Filtered_edge_length_traits;
using Exact = IT::Edge_length_traits<CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT>;
using Tag = CGAL::Parallel_if_available_tag;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Traits>
void expect_those_of_single_elements(const IT::Intrinsic_triangulation<Traits>& t)
{
  const IT::Delta_complex& c = t.connectivity();
  const IT::Element_numbers numbers = IT::element_numbers<Tag>(t);
  const std::vector<double> cotangents = IT::cotangents<Tag>(t), angles = IT::opposite_angles<Tag>(t);
  ASSERT_EQ(numbers.lengths.size(), c.number_of_edges());
  ASSERT_EQ(numbers.cotangent_weights.size(), c.number_of_edges());
  ASSERT_EQ(numbers.areas.size(), c.number_of_faces());
  ASSERT_EQ(cotangents.size(), c.number_of_halfedges());
  EXPECT_EQ(IT::edge_lengths<Tag>(t), numbers.lengths);
  for (IT::Edge_index e : c.edges()) {
    EXPECT_EQ(numbers.lengths[e.idx()], CGAL::to_double(t.length(e))) << e;
    const double weight = CGAL::to_double(t.cotangent_weight(e));
    const bool is_decided_otherwise = weight < 0 && !c.is_border(e) && CGAL::certainly(t.is_locally_Delaunay(e));
    EXPECT_EQ(numbers.cotangent_weights[e.idx()], is_decided_otherwise ? 0 : weight) << e;
  }
  for (IT::Face_index f : c.faces())
    EXPECT_EQ(numbers.areas[f.idx()], CGAL::to_double(t.area(f))) << f;
  for (IT::Halfedge_index h : c.halfedges()) {
    const double cotangent = c.is_border(h) ? 0 : CGAL::to_double(t.cotangent(h));
    const double error = Traits::Uses_exact_geometry::value ? 0x1p-49 * (1 + std::abs(cotangent)) : 0;
    EXPECT_NEAR(cotangents[h.idx()], cotangent, error) << h;
    EXPECT_NEAR(angles[h.idx()], c.is_border(h) ? 0 : IT::angle(t, h), 0x1p-48) << h;
  }
}

template <class Traits>
void expect_summary_of_weights(const IT::Intrinsic_triangulation<Traits>& t)
{
  IT::Weight_summary expected;
  const std::vector<double> weights = IT::element_numbers(t).cotangent_weights;
  for (IT::Edge_index e : t.connectivity().edges()) {
    const double w = weights[e.idx()];
    expected.infinite += std::isinf(w);
    if (t.connectivity().is_border(e))
      continue;
    expected.negative += w < 0;
    if (std::isfinite(w))
      expected.smallest = (std::min)(w, expected.smallest.value_or(w));
  }
  const IT::Weight_summary summary = IT::summarize_cotangent_weights(t);
  EXPECT_EQ(summary.smallest, expected.smallest);
  EXPECT_EQ(summary.negative, expected.negative);
  EXPECT_EQ(summary.infinite, expected.infinite);
}

template <class Traits>
class Element_numbers : public testing::Test
{};
using Types = testing::Types<Filtered, IT::Edge_length_traits<double>, IT::Edge_length_traits<float>,
                             IT::Edge_length_traits<CGAL::Interval_nt<>>, IT::Half_angle_traits<double>, Exact>;
TYPED_TEST_SUITE(Element_numbers, Types);

TYPED_TEST(Element_numbers, are_those_of_single_elements)
{
  const bool is_slow = std::is_same<TypeParam, Exact>::value;
  for (const Surface& surface : generic_surfaces(is_slow)) {
    SCOPED_TRACE(surface.name);
    auto t = triangulation<TypeParam>(surface);
    ASSERT_NO_FATAL_FAILURE(expect_those_of_single_elements(t));
    if (!is_slow) // among sums of roots, to compare lengths takes very long
      expect_summary_of_weights(t);
    IT::flip_to_Delaunay(t);
    ASSERT_NO_FATAL_FAILURE(expect_those_of_single_elements(t));
    expect_summary_of_weights(t);
  }
}

TYPED_TEST(Element_numbers, progress_is_reported_and_cancels)
{
  const auto t = triangulation<TypeParam>(from_triangles("torus", samples::torus(8, 6)));
  double last = -1;
  const IT::Element_numbers numbers = IT::element_numbers(t, CGAL::parameters::visitor([&](double fraction) {
                                                            EXPECT_TRUE(fraction >= last && fraction <= 1);
                                                            last = fraction;
                                                            return true;
                                                          }));
  EXPECT_GE(last, 0);
  EXPECT_EQ(numbers.lengths, IT::edge_lengths(t));
  const auto no = CGAL::parameters::visitor([](double) { return false; });
  EXPECT_THROW(IT::element_numbers(t, no), IT::Cancelled_error);
  EXPECT_THROW(IT::edge_lengths(t, no), IT::Cancelled_error);
  EXPECT_THROW(IT::cotangents(t, no), IT::Cancelled_error);
  EXPECT_THROW(IT::opposite_angles(t, no), IT::Cancelled_error);
}

// A square whose lower side has a vertex in its middle, and a face without area behind it.
template <class Traits>
IT::Intrinsic_triangulation<Traits> with_flat_face()
{
  return triangulation<Traits>(from_triangles("flat face", {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0}},
                                                            {{4, 2, 3}, {4, 1, 2}, {0, 4, 3}, {0, 1, 4}}}));
}

template <class Traits>
void expect_infinite_numbers()
{
  const auto t = with_flat_face<Traits>();
  const IT::Delta_complex& c = t.connectivity();
  const IT::Face_index flat(3);
  const IT::Element_numbers numbers = IT::element_numbers(t);
  const std::vector<double> cotangents = IT::cotangents(t);
  EXPECT_EQ(numbers.areas[3], 0);
  std::size_t infinite = 0;
  for (IT::Edge_index e : c.edges()) {
    const IT::Halfedge_index h = c.halfedge(e), g = c.opposite(h);
    const bool is_beside = c.face(h) == flat || c.face(g) == flat;
    infinite += is_beside;
    EXPECT_EQ(std::isinf(numbers.cotangent_weights[e.idx()]), is_beside) << e;
    for (IT::Halfedge_index side : {h, g})
      if (c.face(side) == flat) { // the angle at the vertex in the middle is π
        EXPECT_EQ(cotangents[side.idx()], c.target(c.next(side)) == IT::Vertex_index(4) ? -infinity : infinity) << side;
      }
  }
  EXPECT_EQ(infinite, 3u);
  EXPECT_EQ(IT::summarize_cotangent_weights(t).infinite, 3u);
  expect_summary_of_weights(t);
  EXPECT_THROW(IT::cotangent_weights(t), IT::Invalid_surface_error);
}

TEST(Infinite_numbers, beside_a_face_of_zero_area)
{
  expect_infinite_numbers<Filtered>();
  expect_infinite_numbers<IT::Edge_length_traits<double>>();
  expect_infinite_numbers<Exact>();
}

TYPED_TEST(Element_numbers, of_lengths_of_another_number_type)
{
  using Triangulation = IT::Intrinsic_triangulation<TypeParam>;
  using FT = typename Triangulation::FT;
  const Surface surface = from_gluing("torus", samples::one_vertex_torus(1, 1.25, 2));
  const std::vector<FT> lengths(surface.lengths.begin(), surface.lengths.end());
  const std::vector<float> floats = surface.lengths;
  EXPECT_EQ(IT::edge_lengths(Triangulation::from_lengths(surface.connectivity, floats)),
            IT::edge_lengths(Triangulation::from_lengths(surface.connectivity, lengths)));
}

TEST(Exact_edge_lengths, do_not_depend_on_the_number_type)
{
  const Surface surface = from_triangles("bumpy sphere", samples::bumpy_sphere(12, 8));
  auto t = triangulation<Filtered>(surface);
  auto rounded = triangulation<IT::Edge_length_traits<float>>(surface);
  rounded.keep_input(IT::internal::engine(t).metric());
  IT::flip_to_Delaunay(t);
  IT::flip_to_Delaunay(rounded);
  const std::vector<double> lengths = IT::exact_edge_lengths(rounded);
  EXPECT_EQ(IT::exact_edge_lengths(t), IT::edge_lengths(t));
  ASSERT_EQ(t.connectivity().number_of_edges(), rounded.connectivity().number_of_edges());
  std::size_t same = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    same += lengths[e.idx()] == t.length(e);
  EXPECT_GT(same, lengths.size() * 9 / 10); // of the edges that both have
  EXPECT_NE(lengths, IT::edge_lengths(rounded));
}

// Counts tests, and nothing else.
struct Watcher : IT::Default_visitor
{
  void after_test(IT::Edge_index, CGAL::Uncertain<bool> is_Delaunay)
  {
    ++tests;
    not_Delaunay += CGAL::certainly(!is_Delaunay);
  }
  std::uint64_t tests = 0, not_Delaunay = 0;
};

TEST(Flip_visitor, may_be_told_of_each_test)
{
  // An edge with the same face on both sides counts as tested, but needs no test.
  for (const Surface& surface :
       {from_triangles("torus", samples::torus(12, 8)), from_triangles("sphere", samples::bumpy_sphere(12, 8))}) {
    auto t = triangulation<Filtered>(surface), other = t;
    Watcher watcher;
    const IT::Flip_report report = IT::flip_to_Delaunay<Tag>(t, CGAL::parameters::visitor(std::ref(watcher)));
    EXPECT_EQ(watcher.tests, report.tests);
    EXPECT_GE(watcher.not_Delaunay, report.flips);
    EXPECT_GT(report.flips, 0u);
    const IT::Flip_report expected = IT::flip_to_Delaunay(other);
    EXPECT_EQ(report.tests, expected.tests);
    EXPECT_EQ(report.flips, expected.flips);
    EXPECT_EQ(IT::edge_lengths(t), IT::edge_lengths(other));
  }
}

} // namespace

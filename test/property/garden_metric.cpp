// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The garden, by the algorithms that need no linear algebra.

#include "overlay_triangulations.h"
#include "property/Incremental_overlay_check.h"
#include "property/garden.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>
#include <type_traits>

namespace garden {
namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

int Euler_characteristic(const IT::Delta_complex& complex)
{
  return int(complex.number_of_vertices()) - int(complex.number_of_edges()) + int(complex.number_of_faces());
}

// Half-angle tangents lose the area of slivers, as the paper has them.
template <class Traits>
constexpr double area_tolerance = std::is_same<Traits, IT::Half_angle_traits<double>>::value ? 2 : 1e-6;

template <class Traits>
void triangulate(const Surface& surface)
{
  auto t = triangulation<Traits>(surface);
  const int before = Euler_characteristic(t.connectivity());
  const double area = sum(IT::face_areas(t));
  const IT::Flip_report report = IT::flip_to_Delaunay(t, CGAL::parameters::maximum_number(100000));
  // Rounded decisions may contradict each other, but the run ends.
  EXPECT_NE(report.status, IT::Flip_status::BUDGET_EXHAUSTED);
  if (Traits::Has_exact_decisions::value) {
    EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  }
  EXPECT_TRUE(t.connectivity().is_valid(true));
  EXPECT_EQ(Euler_characteristic(t.connectivity()), before);
  expect_near(sum(IT::face_areas(t)), area, area_tolerance<Traits> * area, "area");
  for (double l : IT::edge_lengths(t))
    EXPECT_TRUE(l > 0 && std::isfinite(l)) << l;
}

void examine(const Surface& surface)
{
  const samples::Indexed_triangles& s = in_space(surface);
  IT::throw_if_fatal(IT::examine_polygons(s.points, s.triangles), "surface");
}

void verify(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Delaunay_verification verification = IT::verify_Delaunay(t);
  EXPECT_TRUE(verification.is_Delaunay());
  // Ties are the edges that the tessellation does without.
  const IT::Delaunay_tessellation tessellation(t);
  std::size_t ties = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    ties += tessellation.is_tie(e);
  EXPECT_EQ(ties, verification.ties);
}

void overlay(const Surface& surface)
{
  Triangulation t = triangulation<IT::Filtered_edge_length_traits>(surface);
  const IT::Delta_complex input = t.connectivity();
  IT::Incremental_overlay incremental(input);
  IT::flip_to_Delaunay(t, CGAL::parameters::visitor(std::ref(incremental)));
  const IT::Overlay overlay(t);
  EXPECT_TRUE(overlay_check::is_valid(incremental));
  EXPECT_TRUE(overlay_check::are_same_overlay(overlay, incremental));
  EXPECT_EQ(int(overlay.number_of_vertices()) - int(overlay.number_of_segments()) + int(overlay.number_of_faces()),
            Euler_characteristic(input));
  EXPECT_EQ(IT::intrinsic_triangulation_of(overlay).number_of_faces(), t.connectivity().number_of_faces());
  EXPECT_TRUE(IT::intrinsic_triangulation_of(overlay).is_valid(true));
  EXPECT_TRUE(IT::input_triangulation_of(overlay).is_valid(true));
}

void positions(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Common_subdivision subdivision(t);
  const IT::Overlay_positions& positions = subdivision.positions();
  const double area = sum(IT::face_areas(t));
  expect_near(sum(IT::face_areas(subdivision)), area, 1e-6 * area, "area of the overlay");
  for (IT::Overlay::Vertex x : subdivision.overlay().crossings()) {
    EXPECT_TRUE(positions.on_input_edge(x) >= 0 && positions.on_input_edge(x) <= 1);
    EXPECT_TRUE(positions.on_intrinsic_edge(x) >= 0 && positions.on_intrinsic_edge(x) <= 1);
  }
}

// Constants stay constant.
void transfer(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Common_subdivision subdivision(t);
  const IT::Overlay& overlay = subdivision.overlay();
  const IT::Delta_complex& input = subdivision.input();
  const std::vector<double> ones(input.number_of_vertices(), 1), at_corners(input.number_of_halfedges(), 1);
  for (double x : IT::interpolate_input_values(subdivision, ones))
    expect_near(x, 1, 1e-12, "input value");
  for (double x : IT::interpolate_intrinsic_values(subdivision, ones))
    expect_near(x, 1, 1e-12, "intrinsic value");
  const auto corners = IT::interpolate_input_corner_values(subdivision, at_corners);
  for (IT::Overlay::Halfedge h : overlay.halfedges())
    if (!overlay.is_border(h))
      expect_near(corners[h.idx()], 1, 1e-12, "corner value");
}

// To the intrinsic triangulation and back; coordinates of thin faces say little.
void locate(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Common_subdivision subdivision(t);
  const IT::Point_location location(subdivision);
  const IT::Delta_complex& input = subdivision.input();
  for (IT::Face_index f : input.faces()) {
    const IT::Surface_point center{input.halfedge(f), {0.25, 0.25, 0.5}};
    const IT::Surface_point there = location.input_to_intrinsic(center), back = location.intrinsic_to_input(there);
    for (const IT::Surface_point& p : {there, back}) {
      expect_near(p.coordinates[0] + p.coordinates[1] + p.coordinates[2], 1, 1e-9, "sum of coordinates");
      EXPECT_GE(*std::min_element(p.coordinates.begin(), p.coordinates.end()), 0);
    }
  }
}

// Meshes for display: as many elements, and no NaN.
void copy_to_mesh(const Surface& surface)
{
  std::vector<Point_3> points;
  for (const std::array<double, 3>& p : in_space(surface).points)
    points.emplace_back(p[0], p[1], p[2]);
  const Triangulation t = Delaunay_triangulation(surface);
  const IT::Common_subdivision subdivision(t);
  const auto copy = IT::to_surface_mesh(t, points);
  EXPECT_TRUE(copy.is_valid(false));
  EXPECT_EQ(copy.number_of_faces(), t.connectivity().number_of_faces());
  auto mesh = IT::overlay_to_surface_mesh(subdivision, points);
  EXPECT_EQ(mesh.number_of_faces(), subdivision.overlay().number_of_faces());
  IT::triangulate_overlay_faces(mesh);
  EXPECT_TRUE(mesh.is_valid(false));
  for (auto v : mesh.vertices())
    for (int i = 0; i < 3; ++i)
      EXPECT_TRUE(std::isfinite(mesh.point(v)[i]));
}

void write_and_read(const Surface& surface)
{
  const Triangulation t = Delaunay_triangulation(surface);
  const std::vector<double> lengths = IT::edge_lengths(t);
  std::stringstream stream;
  IT::write_gluing(stream, t.connectivity(), lengths);
  const IT::Gluing gluing = IT::read_gluing(stream);
  EXPECT_EQ(gluing.lengths, lengths);
  EXPECT_EQ(gluing.complex.number_of_faces(), t.connectivity().number_of_faces());
}

// Afterwards each triangle has the margin.
void mollify(const Surface& surface)
{
  const IT::Delta_complex complex = connectivity(surface);
  const std::vector<double> before = IT::edge_lengths(triangulation<IT::Edge_length_traits<double>>(surface));
  for (bool is_local : {false, true}) {
    std::vector<double> lengths = before;
    const IT::Mollification_report report =
      (is_local ? IT::mollify_lengths_locally : IT::mollify_lengths)(complex, lengths, 1e-3);
    for (IT::Face_index f : complex.faces()) {
      IT::Halfedge_index h = complex.halfedge(f);
      for (int i = 0; i < 3; ++i, h = complex.next(h)) {
        const double a = lengths[complex.edge(h).idx()], b = lengths[complex.edge(complex.next(h)).idx()],
                     c = lengths[complex.edge(complex.prev(h)).idx()];
        EXPECT_GE(a + b, (c + report.delta) * (1 - 1e-12));
      }
    }
    IT::Intrinsic_triangulation<IT::Edge_length_traits<double>>::from_lengths(complex, lengths);
  }
}

} // namespace

std::vector<Algorithm> metric_algorithms()
{
  return {{"examine", examine},
          {"double", triangulate<IT::Edge_length_traits<double>>},
          {"half angles", triangulate<IT::Half_angle_traits<double>>},
          {"filtered", triangulate<IT::Filtered_edge_length_traits>},
          {"verify", verify},
          {"overlay", overlay},
          {"positions", positions},
          {"transfer", transfer},
          {"locate", locate},
          {"mesh", copy_to_mesh},
          {"gluing file", write_and_read},
          {"mollify", mollify}};
}

} // namespace garden

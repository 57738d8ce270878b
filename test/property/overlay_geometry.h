// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lays the overlay of a surface out in the plane, face by face, and checks it.

#ifndef IDT_TEST_PROPERTY_OVERLAY_GEOMETRY_H
#define IDT_TEST_PROPERTY_OVERLAY_GEOMETRY_H

#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace overlay_geometry {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Halfedge_index;
using IT::Overlay;
using IT::Overlay_positions;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Point_2 = std::array<double, 2>;
using Point_3 = std::array<double, 3>;

constexpr double tolerance = 1e-12;

struct Overlay_numbers
{
  std::uint32_t simple = 0;  // intrinsic edges that cross one input edge
  std::uint32_t longest = 0; // the most segments of an intrinsic edge
  std::uint32_t crossings = 0;
};

// Edge lengths and face areas of one triangulation; its faces in the plane.
class Faces_in_plane
{
public:
  explicit Faces_in_plane(const Triangulation& t) : complex_(t.connectivity())
  {
    for (Edge_index e : complex_.edges())
      lengths_.push_back(t.length(e));
    for (Face_index f : complex_.faces())
      areas_.push_back(t.area(f));
  }

  const Delta_complex& complex() const { return complex_; }
  double length(Edge_index e) const { return lengths_[e.idx()]; }
  double area(Face_index f) const { return areas_[f.idx()]; }
  double length_of_longest_side(Face_index f) const { return length(complex_.edge(longest_side(f))); }

  // The point on a side of a face, at that fraction of the side. The longest side is on the x-axis:
  // any other would enlarge the rounding errors.
  Point_2 point(Halfedge_index side, double fraction) const
  {
    const Point_2 p = corner(side), q = corner(complex_.next(side));
    return {p[0] + fraction * (q[0] - p[0]), p[1] + fraction * (q[1] - p[1])};
  }

private:
  Halfedge_index longest_side(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    return std::max({h, complex_.next(h), complex_.prev(h)}, [this](Halfedge_index a, Halfedge_index b) {
      return length(complex_.edge(a)) < length(complex_.edge(b));
    });
  }

  Point_2 corner(Halfedge_index h) const
  {
    const Halfedge_index ij = longest_side(complex_.face(h));
    const double l = length(complex_.edge(ij)), jk = length(complex_.edge(complex_.next(ij))),
                 ki = length(complex_.edge(complex_.prev(ij)));
    if (h == ij)
      return {0, 0};
    if (h == complex_.next(ij))
      return {l, 0};
    return {(l + (ki - jk) * (ki + jk) / l) / 2, 2 * area(complex_.face(h)) / l};
  }

  Delta_complex complex_;
  std::vector<double> lengths_;
  std::vector<double> areas_;
};

class Overlay_geometry_check
{
public:
  // The input in the plane, the flipped triangulation and the points of its vertices, if any.
  Overlay_geometry_check(const Faces_in_plane& input, const Triangulation& t, const std::vector<Point_3>& points)
    : input_(input), intrinsic_(t), points_(points), subdivision_(t)
  {}

  void run() const
  {
    ASSERT_NO_FATAL_FAILURE(check_order());
    ASSERT_NO_FATAL_FAILURE(check_faces());
    check_lengths_in_space();
  }

  Overlay_numbers numbers() const
  {
    Overlay_numbers n;
    n.crossings = overlay_.number_of_crossings();
    for (Edge_index e : intrinsic_.complex().edges()) {
      const auto segments = std::uint32_t(overlay_.intrinsic_segments(e).size());
      n.simple += segments == 2;
      n.longest = std::max(n.longest, segments);
    }
    return n;
  }

private:
  void check_order() const
  {
    for (Edge_index e : intrinsic_.complex().edges()) {
      double last = 0;
      for (Overlay::Vertex x : overlay_.intrinsic_crossings(e)) {
        ASSERT_LE(last, positions_.on_intrinsic_edge(x));
        last = positions_.on_intrinsic_edge(x);
      }
      ASSERT_LE(last, 1);
    }
    for (Edge_index e : input_.complex().edges()) {
      double last = 0;
      for (std::uint32_t i = 0; i + 1 < overlay_.number_of_input_segments(e); ++i) {
        const Overlay::Vertex x = overlay_.input_crossing(e, i);
        ASSERT_LE(last, positions_.on_input_edge(x));
        last = positions_.on_input_edge(x);
      }
      ASSERT_LE(last, 1);
    }
  }

  // The corners of an overlay face in the plane of an input face and in that of an intrinsic one.
  void check_faces() const
  {
    std::vector<double> input_areas(input_.complex().number_of_faces(), 0),
      intrinsic_areas(intrinsic_.complex().number_of_faces(), 0);
    std::vector<Point_2> in_input, in_intrinsic;
    for (Overlay::Face f : overlay_.faces()) {
      in_input.clear();
      in_intrinsic.clear();
      const Overlay::Halfedge first = overlay_.halfedge(f);
      Overlay::Halfedge h = first;
      do {
        in_input.push_back(input_.point(overlay_.input_side(h), positions_.on_input_side(overlay_, h)));
        in_intrinsic.push_back(intrinsic_.point(overlay_.intrinsic_side(h), positions_.on_intrinsic_side(overlay_, h)));
        h = overlay_.next(h);
      } while (h != first);
      const Face_index o = overlay_.input_face(f), c = overlay_.intrinsic_face(f);
      const double size = std::max(input_.length_of_longest_side(o), intrinsic_.length_of_longest_side(c));
      ASSERT_NO_FATAL_FAILURE(check_convex(in_input, input_.length_of_longest_side(o))) << f;
      ASSERT_NO_FATAL_FAILURE(check_convex(in_intrinsic, intrinsic_.length_of_longest_side(c))) << f;
      ASSERT_NO_FATAL_FAILURE(check_congruent(in_input, in_intrinsic, size)) << f;
      input_areas[o.idx()] += std::abs(area(in_input));
      intrinsic_areas[c.idx()] += std::abs(area(in_intrinsic));
    }
    ASSERT_NO_FATAL_FAILURE(check_areas(input_, input_areas)) << "input";
    ASSERT_NO_FATAL_FAILURE(check_areas(intrinsic_, intrinsic_areas)) << "intrinsic";
  }

  static double cross_product(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  static double area(const std::vector<Point_2>& polygon)
  {
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      sum += cross_product(polygon[0], polygon[i - 1], polygon[i]);
    return sum / 2;
  }

  static void check_convex(const std::vector<Point_2>& p, double size)
  {
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = i + 1; j < p.size(); ++j)
        for (std::size_t k = j + 1; k < p.size(); ++k)
          ASSERT_GE(cross_product(p[i], p[j], p[k]), -tolerance * size * size);
  }

  static void check_congruent(const std::vector<Point_2>& p, const std::vector<Point_2>& q, double size)
  {
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = i + 1; j < p.size(); ++j)
        ASSERT_NEAR(std::hypot(p[i][0] - p[j][0], p[i][1] - p[j][1]), std::hypot(q[i][0] - q[j][0], q[i][1] - q[j][1]),
                    tolerance * size);
  }

  static void check_areas(const Faces_in_plane& faces, const std::vector<double>& areas)
  {
    for (Face_index f : faces.complex().faces()) {
      const double size = faces.length_of_longest_side(f);
      ASSERT_NEAR(areas[f.idx()], faces.area(f), tolerance * size * size) << f;
    }
  }

  // Points in space are as exact as their coordinates are large.
  void check_lengths_in_space() const
  {
    if (points_.empty())
      return;
    for (Edge_index e : intrinsic_.complex().edges()) {
      double sum = 0, size = intrinsic_.length(e);
      for (Overlay::Segment s : overlay_.intrinsic_segments(e)) {
        const Overlay::Vertex v = overlay_.source(overlay_.halfedge(s)), w = overlay_.target(overlay_.halfedge(s));
        const Point_3 p = subdivision_.point(v, points_), q = subdivision_.point(w, points_);
        sum += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        if (overlay_.is_crossing(v))
          for (Halfedge_index h : ends_at_crossing(v))
            for (double x : points_[input_.complex().target(h).idx()])
              size = std::max(size, std::abs(x));
      }
      ASSERT_NEAR(sum, intrinsic_.length(e), tolerance * size) << e;
    }
  }

  std::array<Halfedge_index, 2> ends_at_crossing(Overlay::Vertex x) const
  {
    const Halfedge_index h = input_.complex().halfedge(overlay_.input_edge(x));
    return {h, input_.complex().opposite(h)};
  }

  const Faces_in_plane& input_;
  const Faces_in_plane intrinsic_;
  const std::vector<Point_3>& points_;
  const IT::Common_subdivision subdivision_;
  const Overlay& overlay_ = subdivision_.overlay();
  const Overlay_positions& positions_ = subdivision_.positions();
};

inline Overlay_numbers check_overlay(Triangulation t, const std::vector<Point_3>& points)
{
  const Faces_in_plane input(t);
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  const Overlay_geometry_check check(input, t, points);
  check.run();
  return check.numbers();
}

inline Overlay_numbers check_overlay(const samples::Indexed_triangles& surface)
{
  return check_overlay(
    Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points),
    surface.points);
}

inline Overlay_numbers check_overlay(const samples::Glued_triangles& surface)
{
  const Delta_complex complex = IT::make_Delta_complex_from_gluing(surface.number_of_faces, surface.glued_sides);
  return check_overlay(Triangulation::from_lengths(complex, test_surfaces::edge_lengths(surface, complex)), {});
}

} // namespace overlay_geometry

#endif // IDT_TEST_PROPERTY_OVERLAY_GEOMETRY_H

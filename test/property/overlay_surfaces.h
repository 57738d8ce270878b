// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces with their overlays, for tests of transfer.

#ifndef IDT_TEST_PROPERTY_OVERLAY_SURFACES_H
#define IDT_TEST_PROPERTY_OVERLAY_SURFACES_H

#include "flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace test_surfaces {

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// An intrinsic Delaunay triangulation and its common subdivision with the input.
struct Overlaid
{
  explicit Overlaid(Triangulation t) : triangulation(flipped(std::move(t))), subdivision(triangulation) {}
  explicit Overlaid(const samples::Indexed_triangles& surface)
    : Overlaid(
        Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points))
  {}

  const IT::Delta_complex& input() const { return subdivision.input(); }
  const IT::Delta_complex& intrinsic() const { return subdivision.intrinsic(); }
  const IT::Overlay& overlay() const { return subdivision.overlay(); }
  const IT::Overlay_positions& positions() const { return subdivision.positions(); }
  double input_length(IT::Halfedge_index h) const
  {
    const IT::Input_metric& metric = IT::internal::engine(triangulation).metric();
    return std::ldexp(std::sqrt(metric.squared_length_double_double(input(), input().edge(h)).hi()),
                      metric.unit_exponent());
  }
  double input_area(IT::Face_index f) const
  {
    const IT::Input_metric& metric = IT::internal::engine(triangulation).metric();
    return std::ldexp(metric.four_areas_double_double(input(), f).hi(), 2 * metric.unit_exponent() - 2);
  }
  double intrinsic_length(IT::Halfedge_index h) const { return triangulation.length(intrinsic().edge(h)); }

  Triangulation triangulation;
  IT::Common_subdivision subdivision;

private:
  static Triangulation flipped(Triangulation t)
  {
    IT::flip_to_Delaunay(t);
    return t;
  }
};

// Loops, multiple edges, faces that meet themselves, borders, and faces of zero area.
template <class Check>
void for_each_overlaid_surface(const Check& check)
{
  for (const Surface& surface : generic_surfaces(false))
    check(surface.name, Overlaid(triangulation<IT::Filtered_edge_length_traits>(surface)));
  check("cap", Overlaid(samples::cap()));
  check("exact cap", Overlaid(samples::cap(0)));
  check("prism", Overlaid(samples::prism(30, 1)));
  check("pillow", Overlaid(samples::pillow(40)));
  check("sheared grid", Overlaid(samples::sheared_grid(12, 12)));
  check("strip", Overlaid(samples::strip(60, 20)));
}

// The face to the left of h in the plane, h along the x-axis. The area tells how high it is: for
// thin faces three lengths do not.
using Point_2 = std::array<double, 2>;
template <class Length>
std::array<Point_2, 3> laid_out(const IT::Delta_complex& complex, IT::Halfedge_index h, const Length& length,
                                double area)
{
  const double ij = length(h), jk = length(complex.next(h)), ki = length(complex.prev(h));
  return {Point_2{0, 0}, Point_2{ij, 0}, Point_2{(ij * ij + (ki - jk) * (ki + jk)) / (2 * ij), 2 * area / ij}};
}

inline Point_2 combination(const std::array<Point_2, 3>& corners, const std::array<double, 3>& b)
{
  return {b[0] * corners[0][0] + b[1] * corners[1][0] + b[2] * corners[2][0],
          b[0] * corners[0][1] + b[1] * corners[1][1] + b[2] * corners[2][1]};
}

inline double distance(const Point_2& p, const Point_2& q) { return std::hypot(p[0] - q[0], p[1] - q[1]); }

// The coordinates of the same point relative to another halfedge of the face.
inline std::array<double, 3> coordinates_from(const IT::Delta_complex& complex, const IT::Surface_point& point,
                                              IT::Halfedge_index h)
{
  std::array<double, 3> b = point.coordinates;
  for (IT::Halfedge_index g = point.halfedge; g != h; g = complex.next(g))
    std::rotate(b.begin(), b.begin() + 1, b.end());
  return b;
}

template <class Random>
std::array<double, 3> random_coordinates(Random& random)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  double a = uniform(random), b = uniform(random);
  if (a + b > 1) {
    a = 1 - a;
    b = 1 - b;
  }
  return {1 - a - b, a, b};
}

template <class Random>
IT::Surface_point random_point(const IT::Delta_complex& complex, Random& random)
{
  IT::Halfedge_index h;
  do
    h = IT::Halfedge_index(std::uint32_t(random() % complex.number_of_halfedges()));
  while (complex.is_border(h));
  return {h, random_coordinates(random)};
}

} // namespace test_surfaces

#endif // IDT_TEST_PROPERTY_OVERLAY_SURFACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths of edges between inserted vertices, against a layout with 500 digits that is written apart: in the plane,
// triangle by triangle, from the points in space and the barycentric coordinates.

#include "evaluation_data.h"
#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/multiprecision/mpfr.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Number =
  boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<500>, boost::multiprecision::et_off>;

struct Point_2
{
  Number x, y;
};

class Layout
{
public:
  Layout(const Triangulation& triangulation, const std::vector<std::array<double, 3>>& points)
    : correspondence_(IT::internal::engine(triangulation).correspondence()), input_(correspondence_.input()),
      points_(points)
  {}

  // Of a path from a vertex to another one through the faces beside the input edges that it crosses, given as halfedges
  // of the faces before them. If there are none, the path lies in the face of `face`.
  Number distance(IT::Vertex_index from, IT::Vertex_index to, const std::vector<IT::Halfedge_index>& crossed,
                  IT::Halfedge_index face) const
  {
    const IT::Halfedge_index first = crossed.empty() ? face : crossed[0];
    std::array<Point_2, 3> corners{Point_2{0, 0}, Point_2{length(first), 0}, Point_2{}};
    corners[2] = apex(first, corners[0], corners[1]);
    const Point_2 source = position(from, first, corners);
    IT::Halfedge_index h = first;
    for (std::size_t i = 0; i < crossed.size(); ++i) {
      // The edge, seen from the face behind it, where it runs the other way.
      const std::size_t side = crossed[i] == h ? 0 : crossed[i] == input_.next(h) ? 1 : 2;
      const Point_2 p = corners[(side + 1) % 3], q = corners[side];
      h = input_.opposite(crossed[i]);
      corners = {p, q, apex(h, p, q)};
    }
    const Point_2 target = position(to, h, corners);
    const Number x = target.x - source.x, y = target.y - source.y;
    return sqrt(x * x + y * y);
  }

private:
  Number squared_length(IT::Halfedge_index h) const
  {
    Number sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Number d = Number(points_[input_.target(h).idx()][i]) - Number(points_[input_.source(h).idx()][i]);
      sum += d * d;
    }
    return sum;
  }
  Number length(IT::Halfedge_index h) const { return sqrt(squared_length(h)); }

  // To the left of the way from p to q, which is h.
  Point_2 apex(IT::Halfedge_index h, const Point_2& p, const Point_2& q) const
  {
    const Number s = squared_length(h), t = squared_length(input_.prev(h)), u = squared_length(input_.next(h));
    const Number along = (s + t - u) / (2 * s), height = sqrt(Number(t / s - along * along));
    const Number x = q.x - p.x, y = q.y - p.y;
    return {p.x + along * x - height * y, p.y + along * y + height * x};
  }

  Point_2 position(IT::Vertex_index v, IT::Halfedge_index h, const std::array<Point_2, 3>& corners) const
  {
    const std::array<IT::Halfedge_index, 3> sides{h, input_.next(h), input_.prev(h)};
    if (!correspondence_.is_inserted(v)) {
      for (std::size_t i = 0; i < 3; ++i)
        if (input_.source(sides[i]) == v)
          return corners[i];
      ADD_FAILURE() << v << " is no corner";
      return {};
    }
    const IT::Surface_point& location = correspondence_.location(v);
    IT::Halfedge_index g = location.halfedge;
    Point_2 result{0, 0};
    Number sum = 0;
    for (std::size_t i = 0; i < 3;
         ++i, g = input_.next(g)) // by their vertices, as a point of an edge may name the other face
      if (location.coordinates[i] != 0)
        for (std::size_t j = 0; j < 3; ++j)
          if (input_.source(sides[j]) == input_.source(g)) {
            result.x += location.coordinates[i] * corners[j].x;
            result.y += location.coordinates[i] * corners[j].y;
            sum += location.coordinates[i];
          }
    return {result.x / sum, result.y / sum};
  }

  const IT::internal::Correspondence& correspondence_;
  const IT::Delta_complex& input_;
  const std::vector<std::array<double, 3>>& points_;
};

// Refines a surface, and compares at most this many lengths. \return the largest error, in units in the last place
double largest_error(const samples::Indexed_triangles& surface, std::size_t number)
{
  Triangulation triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                              surface.points);
  EXPECT_GT(IT::refine_Delaunay(triangulation).insertions, 0u);
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::Delta_complex& input = triangulation.input();
  const IT::Overlay overlay(triangulation);
  const Layout layout(triangulation, surface.points);
  double largest = 0;
  const std::size_t step = complex.number_of_edges() / number + 1;
  for (std::size_t i = 0; i < complex.number_of_edges(); i += step) {
    const IT::Edge_index e{std::uint32_t(i)};
    const IT::Halfedge_index h = complex.halfedge(e);
    std::vector<IT::Halfedge_index> crossed;
    for (IT::Overlay::Vertex x : overlay.intrinsic_crossings(e))
      crossed.push_back(overlay.crossing_input_halfedge(x));
    IT::Overlay::Halfedge part = overlay.halfedge(*overlay.intrinsic_segments(e).begin());
    if (overlay.is_border(part))
      part = overlay.opposite(part);
    const Number exact = layout.distance(complex.source(h), complex.target(h), crossed,
                                         input.halfedge(overlay.input_face(overlay.face(part))));
    const double length = triangulation.length(e);
    const double ulp = std::nextafter(length, std::numeric_limits<double>::infinity()) - length;
    largest = std::max(largest, double(abs(Number(length) - exact) / ulp));
  }
  return largest;
}

TEST(Inserted_lengths, are_good_to_one_unit_in_the_last_place)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bad_torus(20, 20), samples::bumpy_dome(), samples::disk_with_spike(), samples::Schwarz_lantern(),
        samples::cap(), samples::prism(), samples::pillow(60), samples::helical_tube(), samples::sheared_grid(),
        samples::latitude_longitude_sphere(20, 10)})
    EXPECT_LE(largest_error(surface, 500), 1);
}

TEST(Inserted_lengths, of_meshes)
{
  if (evaluation_data().empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  for (const char* name : {"table1/cathead", "table1/bunnyhead", "table1/beautiful_freak", "table1/hygeia",
                           "good/meshlab_bunny10k_2_clean", "good/thingicsg_NO_PRINT_feeder_guide_arm",
                           "good/conff_hand", "good/rxmesh_giraffe", "good/trimesh_featuretype_2",
                           "good/mepp_rgb_nefertiti_unix", "good/manifoldlib_Offset1"}) {
    SCOPED_TRACE(name);
    std::ifstream file(evaluation_data() / (std::string(name) + ".off"));
    std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
    std::vector<std::vector<std::size_t>> polygons;
    ASSERT_TRUE(CGAL::IO::read_OFF(file, points, polygons));
    samples::Indexed_triangles surface;
    for (const auto& p : points)
      surface.points.push_back({p.x(), p.y(), p.z()});
    for (const std::vector<std::size_t>& p : polygons)
      surface.triangles.push_back({std::uint32_t(p.at(0)), std::uint32_t(p.at(1)), std::uint32_t(p.at(2))});
    EXPECT_LE(largest_error(surface, 500), 1);
  }
}

} // namespace

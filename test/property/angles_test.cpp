// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles, cone angles and tangent vectors against coordinates in the plane and the theorem of Gauss and Bonnet, from
// regular triangles to needles, caps and faces of zero area; and is_Delaunay().

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <CGAL/Interval_nt.h>

#include <boost/property_map/function_property_map.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Face_index;
using IT::Filtered_edge_length_traits;
using IT::Halfedge_index;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<Filtered_edge_length_traits>;
using Vector = std::complex<double>;

const double pi = std::acos(-1.);

template <class Traits = Filtered_edge_length_traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const samples::Indexed_triangles& surface)
{
  return IT::Intrinsic_triangulation<Traits>(
    IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

template <class Traits = Filtered_edge_length_traits>
IT::Intrinsic_triangulation<Traits> pillow_of_zero_area()
{
  return IT::Intrinsic_triangulation<Traits>::from_lengths(
    IT::make_Delta_complex_from_gluing(2, std::vector<std::array<int, 2>>{{0, 3}, {1, 5}, {2, 4}}), {1, 2, 3});
}

// The angle opposite to h in the plane z = 0, with an exact scalar product and area: the coordinates have few digits.
long double planar_angle(const Triangulation& t, const samples::Indexed_triangles& surface, Halfedge_index h)
{
  const Delta_complex& c = t.connectivity();
  const auto point = [&](Vertex_index v) { return surface.points[v.idx()]; };
  const auto i = point(c.source(h)), j = point(c.target(h)), k = point(c.target(c.next(h)));
  const long double x = i[0] - k[0], y = i[1] - k[1], u = j[0] - k[0], v = j[1] - k[1];
  return std::atan2(std::abs(x * v - y * u), x * u + y * v);
}

void expect_planar_angles(const Triangulation& t, const samples::Indexed_triangles& surface)
{
  const std::vector<double> all = IT::opposite_angles(t),
                            rough = IT::opposite_angles(t, CGAL::parameters::relative_error(0x1p-20));
  ASSERT_EQ(all.size(), t.connectivity().number_of_halfedges());
  for (Halfedge_index h : t.connectivity().halfedges())
    if (!t.connectivity().is_border(h)) {
      const long double exact = planar_angle(t, surface, h);
      ASSERT_LE(std::abs(IT::angle(t, h) - exact), 0x1p-49L * exact) << h;
      ASSERT_LE(std::abs(all[h.idx()] - exact), 0x1p-49L * exact) << h;
      ASSERT_LE(std::abs(rough[h.idx()] - exact), 0x1p-20L * exact) << h;
    }
}

// A sheet of n x n cells, `height` high, each of them cut by its long diagonal: the larger the shear is, the longer.
samples::Indexed_triangles sheared_sheet(unsigned n, double shear, double height)
{
  samples::Indexed_triangles surface;
  for (unsigned y = 0; y <= n; ++y)
    for (unsigned x = 0; x <= n; ++x)
      surface.points.push_back({x + shear * y, height * y, 0});
  for (unsigned y = 0; y < n; ++y)
    for (unsigned x = 0; x < n; ++x) {
      const unsigned i = y * (n + 1) + x, above = i + n + 1;
      surface.triangles.push_back({i, i + 1, above + 1});
      surface.triangles.push_back({i, above + 1, above});
    }
  return surface;
}

TEST(Angles, are_those_of_the_plane_for_needles_and_caps)
{
  for (const double shear : {0.5, 1.25, 3.5, 1024.5})
    for (const double height : {1., 0x1p-10, 0x1p-30, 0x1p20}) {
      const samples::Indexed_triangles surface = sheared_sheet(5, shear, height);
      Triangulation t = make_triangulation(surface);
      expect_planar_angles(t, surface);
      ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
      expect_planar_angles(t, surface);
    }
}

// Corners on a line, up to the rounding of their coordinates: double-doubles keep half of the digits of such an area.
TEST(Angles, of_the_thinnest_faces_come_from_multiple_precision)
{
  using IT::Rational;
  using Rational_vector = std::array<Rational, 3>;
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {0.1, 0.7, 0.3}, {3 * 0.1, 3 * 0.7, 3 * 0.3}};
  surface.triangles = {{0, 1, 2}};
  const Triangulation t = make_triangulation(surface);
  const Delta_complex& c = t.connectivity();
  for (Halfedge_index h : c.halfedges()) {
    if (c.is_border(h))
      continue;
    const auto& k = surface.points[c.target(c.next(h)).idx()];
    const auto from_k = [&](Vertex_index v) {
      const auto& p = surface.points[v.idx()];
      return Rational_vector{Rational(p[0]) - Rational(k[0]), Rational(p[1]) - Rational(k[1]),
                             Rational(p[2]) - Rational(k[2])};
    };
    const Rational_vector a = from_k(c.source(h)), b = from_k(c.target(h));
    Rational scalar_product(0), squared_area(0);
    for (std::size_t x = 0; x < 3; ++x) {
      const std::size_t y = (x + 1) % 3;
      const Rational coordinate = a[x] * b[y] - a[y] * b[x];
      scalar_product += a[x] * b[x];
      squared_area += coordinate * coordinate;
    }
    ASSERT_GT(squared_area, 0);
    const double exact = std::atan2(std::sqrt(squared_area.convert_to<double>()), scalar_product.convert_to<double>());
    EXPECT_NEAR(IT::angle(t, h) / exact, 1, 1.25 * 0x1p-49) << h;
  }
}

template <class Traits>
void expect_angles_of_zero_area()
{
  const auto t = pillow_of_zero_area<Traits>();
  const Delta_complex& c = t.connectivity();
  for (Halfedge_index h : c.halfedges())
    EXPECT_EQ(IT::angle(t, h), c.edge(h) == Edge_index(2) ? pi : 0) << h;
  double sum = 0;
  for (Vertex_index v : c.vertices())
    sum += IT::angle_defect(t, v);
  EXPECT_NEAR(sum, 4 * pi, 1e-12);
  for (const Vector& v : IT::halfedge_vectors_in_vertex(t))
    EXPECT_TRUE(std::isfinite(v.real()) && std::isfinite(v.imag()));
  for (const Vector& v : IT::halfedge_vectors_in_face(t))
    EXPECT_TRUE(std::isfinite(v.real()) && std::abs(v.imag()) < 1e-14);
}

TEST(Angles, of_zero_area_are_0_and_0_and_pi)
{
  expect_angles_of_zero_area<Filtered_edge_length_traits>();
  expect_angles_of_zero_area<IT::Edge_length_traits<double>>();
  expect_angles_of_zero_area<IT::Half_angle_traits<long double>>();
  expect_angles_of_zero_area<IT::Edge_length_traits<CGAL::Interval_nt<>>>();

  // Two of the lengths are the same double.
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {0x1p-60, 0, 0}, {1, 0, 0}};
  surface.triangles = {{0, 1, 2}};
  const Triangulation t = make_triangulation(surface);
  EXPECT_EQ(IT::cone_angle(t, Vertex_index(0)), 0);
  EXPECT_EQ(IT::cone_angle(t, Vertex_index(1)), pi);
  EXPECT_EQ(IT::cone_angle(t, Vertex_index(2)), 0);
}

template <class Traits>
void expect_same_cone_angles_after_flips(const samples::Indexed_triangles& surface, double euler_characteristic,
                                         double tolerance)
{
  auto t = make_triangulation<Traits>(surface);
  std::vector<double> before;
  double sum = 0;
  for (Vertex_index v : t.connectivity().vertices()) {
    before.push_back(IT::cone_angle(t, v));
    sum += IT::angle_defect(t, v);
  }
  EXPECT_NEAR(sum, 2 * pi * euler_characteristic, tolerance * double(before.size()));
  ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
  for (Vertex_index v : t.connectivity().vertices())
    EXPECT_NEAR(IT::cone_angle(t, v), before[v.idx()], tolerance) << v;
}

TEST(Angles, flips_keep_the_cone_angles_whose_defects_sum_to_the_Euler_characteristic)
{
  expect_same_cone_angles_after_flips<Filtered_edge_length_traits>(samples::bumpy_sphere(), 2, 0x1p-45);
  expect_same_cone_angles_after_flips<Filtered_edge_length_traits>(samples::sheared_grid(), 1, 0x1p-45);
  expect_same_cone_angles_after_flips<IT::Edge_length_traits<double>>(samples::bumpy_sphere(), 2, 1e-10);
  expect_same_cone_angles_after_flips<IT::Half_angle_traits<double>>(samples::bumpy_sphere(), 2, 1e-10);
}

TEST(Angles, an_isolated_vertex_has_none)
{
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
  surface.triangles = {{0, 1, 2}};
  const Triangulation t = make_triangulation(surface);
  EXPECT_EQ(IT::cone_angle(t, Vertex_index(3)), 0);
  EXPECT_EQ(IT::angle_defect(t, Vertex_index(3)), 2 * pi);
  EXPECT_DOUBLE_EQ(IT::angle_defect(t, Vertex_index(0)), pi / 2);
}

// Vectors in the plane z = 0.
Vector in_plane(const samples::Indexed_triangles& surface, Vertex_index v, Vertex_index w)
{
  const auto &p = surface.points[v.idx()], &q = surface.points[w.idx()];
  return Vector(q[0] - p[0], q[1] - p[1]);
}

// Where the surface is flat, vectors are differences of coordinates, turned so that the first axis is that of the
// input.
TEST(Halfedge_vectors, at_flat_vertices_are_those_of_the_plane)
{
  const samples::Indexed_triangles surface = sheared_sheet(5, 2.25, 1);
  Triangulation t = make_triangulation(surface);
  const Delta_complex input = t.connectivity();
  ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
  const Delta_complex& c = t.connectivity();
  const std::vector<Vector> vectors = IT::halfedge_vectors_in_vertex(t);
  for (Halfedge_index h : c.halfedges()) {
    const Vertex_index v = c.source(h);
    Halfedge_index axis = input.opposite(input.halfedge(v));
    if (!input.is_border(input.halfedge(v)))
      for (Halfedge_index g : input.halfedges())
        if (input.source(g) == v)
          axis = std::min(axis, g);
    const Vector along = in_plane(surface, v, input.target(axis)),
                 turned = in_plane(surface, v, c.target(h)) * std::conj(along);
    EXPECT_NEAR(vectors[h.idx()].real(), turned.real() / std::abs(along), 1e-12);
    EXPECT_NEAR(vectors[h.idx()].imag(), turned.imag() / std::abs(along), 1e-12);
  }
}

TEST(Halfedge_vectors, remain_the_same_whatever_is_flipped_and_inserted)
{
  for (const samples::Indexed_triangles& surface : {samples::bumpy_sphere(14, 9), samples::bumpy_dome(12, 9),
                                                    samples::bad_torus(11, 9), samples::disk_with_spike(12, 6)}) {
    Triangulation t = make_triangulation(surface);
    const std::vector<Vector> before = IT::halfedge_vectors_in_vertex(t);
    ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
    const auto expect_same = [&] {
      const std::vector<Vector> after = IT::halfedge_vectors_in_vertex(t);
      const Delta_complex& c = t.connectivity();
      const IT::internal::Correspondence& correspondence = IT::internal::engine(t).correspondence();
      std::size_t kept = 0;
      for (Halfedge_index h : c.halfedges())
        if (correspondence.coordinates().crossings(c.edge(h)) < 0 && !correspondence.is_inserted(c.source(h)) &&
            !correspondence.is_inserted(c.target(h))) {
          const Halfedge_index g = correspondence.input_halfedge(h);
          const double length = t.length(c.edge(h));
          EXPECT_NEAR(after[h.idx()].real(), before[g.idx()].real(), 1e-12 * length);
          EXPECT_NEAR(after[h.idx()].imag(), before[g.idx()].imag(), 1e-12 * length);
          ++kept;
        }
      EXPECT_GT(kept, 0u);
    };
    expect_same();
    for (std::uint32_t h = 0; h < 90; h += 9)
      if (!t.input().is_border(Halfedge_index(h)))
        IT::insert_vertex(t, {Halfedge_index(h), {0.25, 0.5, 0.25}});
    IT::flip_to_Delaunay(t);
    expect_same();
  }
}

// ... where no edge of the input is left at a vertex.
TEST(Halfedge_vectors, are_found_over_crossed_edges)
{
  const samples::Indexed_triangles surface = sheared_sheet(9, 4.25, 1);
  Triangulation t = make_triangulation(surface);
  IT::flip_to_Delaunay(t);
  const Delta_complex& c = t.connectivity();
  const IT::internal::Correspondence& correspondence = IT::internal::engine(t).correspondence();
  const auto crossings = [&](Halfedge_index h) { return correspondence.coordinates().crossings(c.edge(h)); };
  std::size_t number = 0;
  for (Halfedge_index h : c.halfedges())
    if (crossings(h) > 0) {
      const Halfedge_index axis = IT::internal::first_axis(correspondence.input(), c.source(h));
      const Vector turned = in_plane(surface, c.source(h), c.target(h)) *
                            std::conj(in_plane(surface, c.source(h), correspondence.input().target(axis)));
      const double difference =
        IT::internal::direction_on_input(IT::internal::engine(t), h) - std::atan2(turned.imag(), turned.real());
      EXPECT_NEAR(std::remainder(difference, 2 * pi), 0, 1e-12);
      ++number;
    }
  EXPECT_GT(number, 100u);
}

TEST(Halfedge_vectors, at_inserted_vertices_have_the_axis_of_their_location)
{
  const samples::Indexed_triangles surface = sheared_sheet(5, 2.25, 1);
  const Triangulation before = make_triangulation(surface);
  const Delta_complex& input = before.connectivity();
  for (Halfedge_index location : input.halfedges())
    for (std::array<double, 3> at :
         {std::array<double, 3>{0.25, 0.25, 0.5}, {0.125, 0.875, 0}, {0, 0.5, 0.5}, {0.75, 0, 0.25}}) {
      if (input.is_border(location))
        continue;
      Triangulation t = before;
      const Vertex_index v = IT::insert_vertex(t, {location, at});
      IT::flip_to_Delaunay(t);
      const Delta_complex& c = t.connectivity();
      const Halfedge_index stored = t.location(v).halfedge;
      const auto point = [&](Vertex_index w) { return surface.points[w.idx()]; };
      std::array<double, 2> p{0, 0};
      Halfedge_index h = location;
      for (std::size_t i = 0; i < 3; ++i, h = input.next(h))
        for (std::size_t k = 0; k < 2; ++k)
          p[k] += at[i] * point(input.source(h))[k];
      const Vector axis = in_plane(surface, input.source(stored), input.target(stored));
      const std::vector<Vector> vectors = IT::halfedge_vectors_in_vertex(t);
      IT::internal::for_each_halfedge_from(c, v, [&](Halfedge_index g) {
        const auto q = point(c.target(g));
        const Vector turned = Vector(q[0] - p[0], q[1] - p[1]) * std::conj(axis);
        EXPECT_NEAR(vectors[g.idx()].real(), turned.real() / std::abs(axis), 1e-12);
        EXPECT_NEAR(vectors[g.idx()].imag(), turned.imag() / std::abs(axis), 1e-12);
      });
    }
}

// The apex of a cube's corner has a cone angle of 3π/2, scaled to 2π.
TEST(Halfedge_vectors, at_a_cone_have_their_angles_scaled)
{
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}};
  const Triangulation t = make_triangulation(surface);
  const Delta_complex& c = t.connectivity();
  const std::vector<Vector> vectors = IT::halfedge_vectors_in_vertex(t);
  Halfedge_index h = IT::internal::first_axis(c, Vertex_index(0));
  for (int i = 0; i < 3; ++i, h = c.next_around_source(h)) {
    const double l = t.length(c.edge(h));
    EXPECT_NEAR(vectors[h.idx()].real(), l * std::cos(2 * pi * i / 3), 1e-14);
    EXPECT_NEAR(vectors[h.idx()].imag(), l * std::sin(2 * pi * i / 3), 1e-14);
  }
}

TEST(Halfedge_vectors, of_a_face_close_up_around_its_area)
{
  Triangulation t = make_triangulation(samples::bumpy_sphere());
  ASSERT_GT(IT::flip_to_Delaunay(t).flips, 0u);
  const Delta_complex& c = t.connectivity();
  const std::vector<Vector> vectors = IT::halfedge_vectors_in_face(t);
  for (Face_index f : c.faces()) {
    const Halfedge_index h = c.halfedge(f);
    const Vector &a = vectors[h.idx()], &b = vectors[c.next(h).idx()], &d = vectors[c.prev(h).idx()];
    const double longest = std::max({a.real(), t.length(c.edge(c.next(h))), t.length(c.edge(c.prev(h)))});
    EXPECT_EQ(a.real(), t.length(c.edge(h)));
    EXPECT_NEAR(std::abs(b), t.length(c.edge(c.next(h))), 1e-14 * longest);
    EXPECT_NEAR(std::abs(d), t.length(c.edge(c.prev(h))), 1e-14 * longest);
    EXPECT_NEAR((a + b + d).real(), 0, 1e-13 * longest);
    EXPECT_NEAR((a + b + d).imag(), 0, 1e-13 * longest);
    EXPECT_NEAR((b * std::conj(a)).imag(), 2 * t.area(f), 1e-13 * longest * longest); // counterclockwise
  }
}

TEST(Is_Delaunay, after_the_flips_and_not_before)
{
  Triangulation t = make_triangulation(samples::sheared_grid());
  EXPECT_FALSE(IT::is_Delaunay(t));
  // Every edge that is not Delaunay is constrained.
  std::vector<bool> is_bad;
  for (Edge_index e : t.connectivity().edges())
    is_bad.push_back(!t.is_locally_Delaunay(e));
  const auto skip = [&](std::size_t but) {
    return CGAL::parameters::edge_is_constrained_map(boost::make_function_property_map<Edge_index>(
      [&is_bad, but](Edge_index e) { return e.idx() != but && is_bad[e.idx()]; }));
  };
  EXPECT_TRUE(IT::is_Delaunay(t, skip(is_bad.size())));
  const auto one = std::size_t(std::find(is_bad.begin(), is_bad.end(), true) - is_bad.begin());
  EXPECT_FALSE(IT::is_Delaunay(t, skip(one)));

  ASSERT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  EXPECT_TRUE(IT::is_Delaunay(t));
}

TEST(Is_Delaunay, ties_are_and_intervals_cannot_tell)
{
  EXPECT_TRUE(IT::is_Delaunay(make_triangulation(samples::random_diagonal_grid(10, 10, 1, 0))));
  using Interval_traits = IT::Edge_length_traits<CGAL::Interval_nt<>>;
  const auto ties = make_triangulation<Interval_traits>(sheared_sheet(5, 0, 1 / 3.));
  EXPECT_FALSE(CGAL::is_certain(IT::is_Delaunay(ties)));
  EXPECT_TRUE(CGAL::certainly_not(IT::is_Delaunay(make_triangulation<Interval_traits>(samples::sheared_grid()))));
}

} // namespace

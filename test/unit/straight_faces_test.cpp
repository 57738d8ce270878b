// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Double-doubles, and doubles, of triangles in space with one bound for all their errors, against numbers of 100
// digits.

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "library/engine/decide/corner_signs.h"
#include "library/engine/layout/Developed_faces.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include "library/engine/layout/Two_straight_faces.h"
#include "library/arithmetic/Residues.h"
#include "library/engine/layout/Vertex_positions.h"
#include "library/engine/layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <boost/multiprecision/mpfr.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::internal::Bounded_double_double;
using IT::internal::Points;
using Number = boost::multiprecision::mpfr_float_100;
using Point = std::array<double, 3>;
using Triangle = std::array<Point, 3>;

// Of any shape and size, from equilateral ones to those that are flat up to rounding.
std::vector<Triangle> triangles()
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] { return Point{coordinate(random), coordinate(random), coordinate(random)}; };
  std::vector<Triangle> result;
  for (int exponent = 0; exponent > -60; exponent -= 2)
    for (int i = 0; i < 20; ++i) {
      Triangle t{point(), point(), point()};
      result.push_back(t);
      for (int c = 0; c < 3; ++c) // near to the line of the others, or to one of them
        t[2][c] = i % 2 == 0 ? (t[0][c] + t[1][c]) / 2 + std::ldexp(t[2][c], exponent)
                             : t[0][c] + std::ldexp(t[2][c], exponent);
      result.push_back(t);
      for (Point& p : t)
        for (double& x : p)
          x = std::ldexp(x, exponent);
      result.push_back(t);
    }
  return result;
}

Number scalar_product(const std::array<Number, 3>& v, const std::array<Number, 3>& w)
{
  return v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
}
std::array<Number, 3> difference(const Point& p, const Point& q)
{
  return {Number(p[0]) - q[0], Number(p[1]) - q[1], Number(p[2]) - q[2]};
}

// Four numbers at the corner of p: the squared lengths of pq and pr, their scalar product, and twice the area.
struct Corner
{
  Corner(const Point& p, const Point& q, const Point& r)
  {
    const auto u = difference(q, p), v = difference(r, p);
    s = scalar_product(u, u);
    s_second = scalar_product(v, v);
    product = scalar_product(u, v);
    twice_area = sqrt(Number(s * s_second - product * product));
  }
  Number s, s_second, product, twice_area;
};

void expect_within(const Number& exact, const Bounded_double_double& x)
{
  const Number error = abs(Number(x.hi()) + x.lo() - exact);
  EXPECT_LE(error, x.error()) << exact << ' ' << x.hi();
}

TEST(Two_straight_faces, bounds_hold)
{
  const std::vector<Triangle> all = triangles();
  std::size_t number_of_known = 0, number_of_accurate = 0;
  for (std::size_t i = 0; i + 1 < all.size(); i += 2) {
    Points points;
    for (const Triangle& t : {all[i], all[i + 1]})
      points.insert(points.end(), t.begin(), t.end());
    using V = IT::Vertex_index;
    const IT::internal::Two_straight_faces two(points, {V(0), V(1), V(2)}, {V(3), V(4), V(5)});
    for (bool is_second : {false, true}) {
      IT::internal::Two_straight_faces::Numbers numbers;
      if (!two.get(is_second, numbers))
        continue;
      ++number_of_known;
      const Triangle& t = all[i + is_second];
      number_of_accurate += IT::internal::rounded(numbers.twice_area).has_value();
      for (std::size_t c = 0; c < 3; ++c) { // the side from c to the next corner, and the angle opposite to it
        const Corner at_side(t[c], t[(c + 1) % 3], t[(c + 2) % 3]), opposite(t[(c + 2) % 3], t[c], t[(c + 1) % 3]);
        expect_within(sqrt(at_side.s), numbers.lengths[c]);
        expect_within(Number(opposite.product / opposite.twice_area), numbers.cotangents[c]);
        expect_within(opposite.twice_area, numbers.twice_area);
      }
    }
  }
  EXPECT_GT(number_of_known, all.size() / 2);
  EXPECT_GT(number_of_accurate, all.size() / 2); // an infinite error would be a bound, too
}

TEST(Two_straight_faces, nothing_is_known_without_area)
{
  const Points points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  using V = IT::Vertex_index;
  const IT::internal::Two_straight_faces two(points, {V(0), V(1), V(2)}, {V(0), V(1), V(3)});
  IT::internal::Two_straight_faces::Numbers numbers;
  EXPECT_FALSE(two.get(false, numbers));
  ASSERT_TRUE(two.get(true, numbers));
  EXPECT_EQ(numbers.twice_area.hi(), 1);
  EXPECT_EQ(numbers.cotangents[2].hi(), 1);
}

using IT::internal::Straight_corner;

// The corner at p, which is returned exactly.
Corner expect_within(const Point& p, const Point& q, const Point& r, const Straight_corner& found)
{
  const Corner exact(p, q, r);
  expect_within(2 * exact.product, found.p);
  expect_within(2 * exact.twice_area, found.four_areas);
  expect_within(exact.s, found.s_first);
  expect_within(exact.s_second, found.s_second);
  expect_within(Corner(q, r, p).s, found.s_opposite);
  return exact;
}

TEST(Straight_corner, bounds_in_doubles_hold)
{
  const std::vector<Triangle> all = triangles();
  std::size_t number_of_known = 0;
  for (const Triangle& t : all)
    for (std::size_t c = 0; c < 3; ++c) {
      const Point &i = t[c], &j = t[(c + 1) % 3], &k = t[(c + 2) % 3];
      const auto found = IT::internal::straight_corner_in_doubles(i, j, k);
      if (!found)
        continue;
      ++number_of_known;
      const Corner exact = expect_within(k, i, j, *found);
      EXPECT_LT(found->s_opposite.relative_error(), 4.9 * 0x1p-53); // else it would not be stored
      EXPECT_LE(found->four_areas.error(), Number(0x1p-48 * sqrt(Number(exact.s * exact.s_second))));
    }
  EXPECT_GT(number_of_known, 2 * all.size());
  EXPECT_FALSE(IT::internal::straight_corner_in_doubles(Point{1, 0, 0}, Point{2, 0, 0}, Point{0, 0, 0}));
}

// What differences of coordinates lose is nearly as large as the bounds here: right angles whose products cancel, and
// sides whose squared lengths are rounded most, just above a power of two.
TEST(Straight_corner, bounds_in_doubles_hold_where_differences_are_rounded)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  for (int n = 0; n < 20000; ++n) {
    const bool is_right = n % 2 == 0;
    const auto one = [&] { return 1 + 0x1p-6 * number(random); };
    const auto small = [&] { return 0x1p-3 * number(random); };
    const Point k{-0x1p-8 * number(random), -0x1p-8 * number(random), -0x1p-8 * number(random)},
      i{one(), is_right ? one() : small(), small()}, j{is_right ? one() : small(), is_right ? -one() : one(), small()};
    const auto found = IT::internal::straight_corner_in_doubles(i, j, k);
    ASSERT_TRUE(found);
    expect_within(k, i, j, *found);
  }
}

// Four points on a circle, up to rounding: the exact sign is that of the sum of products of 100 digits.
TEST(Straight_corner, signs_in_doubles_are_right)
{
  std::mt19937 random(2);
  std::uniform_real_distribution<double> number(0, 1);
  std::size_t number_of_known = 0;
  for (int n = 0; n < 2000; ++n) {
    const double slope = number(random), size = std::ldexp(1, -(n % 8));
    const auto point = [&](double quarter) {
      const double angle = 1.570796 * (quarter + number(random)), x = size * std::cos(angle);
      return Point{1 + x * std::cos(slope), size * std::sin(angle), x * std::sin(slope)};
    };
    const Point i = point(0), l = point(1), j = point(2), k = point(3);
    const auto at_k = IT::internal::straight_corner_in_doubles(i, j, k),
               at_l = IT::internal::straight_corner_in_doubles(j, i, l);
    ASSERT_TRUE(at_k && at_l);
    const Corner exact_k(k, i, j), exact_l(l, j, i);
    const Number sum = exact_k.product * exact_l.twice_area + exact_l.product * exact_k.twice_area;
    if (const auto sign = IT::internal::sign_in_doubles({*at_k, *at_l})) {
      ++number_of_known;
      EXPECT_EQ(int(*sign), sum.sign()) << n;
    }
  }
  EXPECT_GT(number_of_known, 500);
}

TEST(Developed_faces, bounds_in_doubles_hold)
{
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
  const IT::Halfedge_index first = complex.halfedge(IT::Face_index(0));
  std::size_t number_of_known = 0;
  for (const Triangle& t : triangles()) {
    const auto point = [&](IT::Vertex_index v) { return t[v.idx()]; };
    const Point i = point(complex.source(first)), j = point(complex.target(first)),
                k = point(complex.target(complex.next(first)));
    const auto corner = IT::internal::straight_corner(i, j, k);
    IT::internal::Developed_faces faces;
    if (corner)
      faces.insert(complex, {first, *corner, {}});
    if (!faces.contains(first))
      continue;
    ++number_of_known;
    const Straight_corner found = faces.corner(complex, complex.next(first), true); // opposite to jk
    const Corner exact = expect_within(i, j, k, found);
    // Positions have the errors of the longest side.
    EXPECT_LE(found.four_areas.error(),
              Number(0x1p-48 * sqrt(Number(exact.s * exact.s_second)) + 0x1p-90 * (exact.s + exact.s_second)));
  }
  EXPECT_GT(number_of_known, triangles().size() / 2);
}

// A flip of two triangles in a plane makes triangles whose corners are known. The first one may be kept before or not,
// and the second one, too, or be given by any of its corners.
TEST(Developed_faces, bounds_hold_after_a_flip)
{
  using V = IT::Vertex_index;
  const IT::Delta_complex before =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}});
  const std::vector<IT::Surface_point> no_locations;
  const IT::internal::Vertex_positions::Inserted none_inserted;
  IT::Edge_index e;
  for (IT::Edge_index each : before.edges())
    if (!before.is_border(each))
      e = each;
  const IT::Hinge_halfedges around = before.hinge(e);
  IT::internal::Interruption none;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> coordinate(0.1, 1);
  for (int n = 0; n < 1200; ++n) {
    const double size = std::ldexp(1, -1 - n % 20); // of what makes the corners k and l lie near one end or the other
    const auto apex = [&](double side) {
      const double x = size * coordinate(random);
      return Point{n % 2 == 0 ? x : 1 - x, side * size * coordinate(random), 0};
    };
    Points points(4);
    points[before.source(around.ij).idx()] = {0, 0, 0};
    points[before.target(around.ij).idx()] = {1, 0.001 * size * coordinate(random), 0};
    points[before.target(around.jk).idx()] = apex(1);
    points[before.target(around.il).idx()] = apex(-1);
    IT::Delta_complex complex = before;
    const IT::internal::Vertex_positions positions(before, points, no_locations, none_inserted);
    IT::internal::Residue_rings rings(IT::internal::random_prime_fields(1), none);
    const auto corner = [&](IT::Halfedge_index h, int turns) {
      for (; turns != 0; --turns)
        h = before.next(h);
      return IT::internal::Known_corner{h, IT::internal::straight_corner(before, positions, h),
                                        IT::internal::image_of_straight_corner(before, positions, h, rings)};
    };
    IT::internal::Developed_faces faces;
    const int kept = n / 2 % 4;
    for (IT::Halfedge_index h : {around.ij, around.ji})
      if ((kept >> (h == around.ji) & 1) != 0)
        faces.insert(complex, corner(h, n / 8 % 3));
    faces.flip(complex, around, [&](IT::Halfedge_index h) { return std::make_optional(corner(h, n / 8 / 3 % 3)); });
    ASSERT_TRUE(faces.contains(around.ij) && faces.contains(around.ji)) << n;
    complex.flip(around);
    for (IT::Halfedge_index first : {around.ij, around.ji})
      for (IT::Halfedge_index h : {first, complex.next(first), complex.prev(first)}) {
        const auto point = [&](V v) { return points[v.idx()]; };
        const Straight_corner found = faces.corner(complex, h);
        const Corner exact = expect_within(point(complex.target(complex.next(h))), point(complex.source(h)),
                                           point(complex.target(h)), found);
        // Positions relative to a corner that is far away have its errors.
        if (n / 8 % 9 == 0) {
          EXPECT_LE(found.four_areas.error(), 0x1p-88 * sqrt(Number(exact.s * exact.s_second))) << n;
        }
        const auto image = faces.image_of_corner(complex, h);
        ASSERT_TRUE(image);
        const auto expected = IT::internal::image_of_straight_corner(complex, positions, h, rings);
        for (auto number : {&IT::internal::Triangle_corner<IT::internal::Residues>::p,
                            &IT::internal::Triangle_corner<IT::internal::Residues>::four_areas,
                            &IT::internal::Triangle_corner<IT::internal::Residues>::s_opposite})
          EXPECT_TRUE(((*image).*number - expected.*number).is_zero()) << n;
      }
  }
}

TEST(Developed_faces, inaccurate_ones_are_forgotten)
{
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(4, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {1, 0, 3}});
  const IT::Hinge_halfedges around = complex.hinge(IT::Edge_index(0));
  ASSERT_FALSE(complex.is_border(IT::Edge_index(0)));
  for (double error : {0x1p-80, 0x1p-50}) {
    Straight_corner corner = *IT::internal::straight_corner(Point{0, 0, 0}, Point{1, 0, 0}, Point{0.375, 1, 0});
    IT::internal::Developed_faces faces;
    faces.insert(complex, {around.ij, corner, {}});
    ASSERT_TRUE(faces.contains(around.ij));
    corner.p = {corner.p.hi(), corner.p.lo(), error};
    faces.flip(complex, around, [&](IT::Halfedge_index h) {
      return std::make_optional(IT::internal::Known_corner{h, corner, {}});
    });
    EXPECT_EQ(faces.contains(around.ij), error < 0x1p-61);
    EXPECT_EQ(faces.contains(around.ji), error < 0x1p-61);
  }
}

TEST(Straight_corner, bounds_hold)
{
  const std::vector<Triangle> all = triangles();
  std::size_t number_of_known = 0;
  for (const Triangle& t : all)
    for (std::size_t c = 0; c < 3; ++c) {
      const Point &i = t[c], &j = t[(c + 1) % 3], &k = t[(c + 2) % 3];
      const auto found = IT::internal::straight_corner(i, j, k);
      if (!found)
        continue;
      ++number_of_known;
      const Corner exact = expect_within(k, i, j, *found);
      EXPECT_LT(found->s_opposite.relative_error(), 0x1p-98);
      EXPECT_LE(found->four_areas.error(), Number(0x1p-95 * sqrt(Number(exact.s * exact.s_second))));
      EXPECT_LE(found->p.error(), found->four_areas.error());
    }
  EXPECT_GT(number_of_known, 2 * all.size());
  // A right angle, which other numbers can prove, and no area
  EXPECT_FALSE(IT::internal::straight_corner(Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 0}));
  EXPECT_FALSE(IT::internal::straight_corner(Point{1, 0, 0}, Point{2, 0, 0}, Point{0, 0, 0}));
}

Number value(const Bounded_double_double& x) { return Number(x.hi()) + x.lo(); }
Number value(const IT::internal::Double_with_bound& x) { return Number(x.hi()); }

// \param ratios what finds them
// \param largest_error of a ratio with an absolute value of 1
template <class Find>
void expect_bounds_of_ratios(const Find& find, double largest_error)
{
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
  std::size_t number_of_known = 0;
  const std::vector<Triangle> all = triangles();
  for (const Triangle& t : all) {
    const Points points(t.begin(), t.end());
    const IT::Halfedge_index h = complex.halfedge(IT::Face_index(0));
    const auto ratios = find(complex, points, h);
    if (!ratios)
      continue;
    ++number_of_known;
    const std::size_t i = complex.source(h).idx();
    const Corner corner(t[i], t[(i + 1) % 3], t[(i + 2) % 3]);
    const Number x = corner.product / corner.s, y = corner.twice_area / corner.s;
    const auto expect_in_disk = [&](const Number& re, const Number& im, const auto& disk) {
      const Number dx = value(disk.x()) - re, dy = value(disk.y()) - im;
      EXPECT_LE(Number(sqrt(dx * dx + dy * dy)), disk.radius());
      EXPECT_LE(disk.radius(), largest_error * (1 + disk.modulus()));
    };
    expect_in_disk(x, y, ratios->at_source);
    expect_in_disk(Number(1 - x), Number(-y), ratios->at_target);
  }
  EXPECT_GT(number_of_known, all.size() * 9 / 10);
  EXPECT_FALSE(find(complex, Points{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}}, complex.halfedge(IT::Face_index(0))));
  EXPECT_FALSE(find(complex, Points(), complex.halfedge(IT::Face_index(0))));
}

TEST(Ratios_in_space, bounds_hold)
{
  expect_bounds_of_ratios(IT::internal::ratios_in_space, 0x1p-90);
  const IT::Delta_complex complex =
    IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}});
  EXPECT_FALSE(IT::internal::ratios_in_space(complex, Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                                             complex.halfedge(IT::Face_index(0))));
}

TEST(Ratios_in_space, bounds_of_rounded_ones_hold)
{
  expect_bounds_of_ratios(IT::internal::rounded_ratios_in_space, 0x1p-46);
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random polygons with holes in random planes: by exact arithmetic, the triangles have exactly the area that the ring
// encloses, and none lies on the wrong side.

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = CGAL::Exact_rational;
using Exact_vector = std::array<Exact, 3>;
using Points = std::vector<std::array<double, 3>>;
using Indices = std::vector<std::size_t>;

// A plane in space, and points near it.
class Random_plane
{
public:
  Random_plane(std::mt19937& random, double noise) : random_(random), noise_(noise), scale_(std::exp2(number(-40, 40)))
  {
    std::array<double, 3> p = {1, 0, 0}, q = {0, 1, 0}; // level, or not
    if (number(0, 1) < 0.8)
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] += number(-1, 1) / 2;
        q[i] += number(-1, 1) / 2;
      }
    normalize(p);
    const double along = p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
    for (std::size_t i = 0; i < 3; ++i)
      q[i] -= along * p[i];
    normalize(q);
    axes_ = {p, q, {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}};
    std::rotate(axes_.begin(), axes_.begin() + std::ptrdiff_t(number(0, 3)), axes_.end());
    for (double& x : origin_)
      x = scale_ * number(-3, 3);
  }

  double number(double least, double greatest)
  {
    return std::uniform_real_distribution<double>(least, greatest)(random_);
  }

  std::size_t add_point(double x, double y)
  {
    const double z = noise_ * number(-1, 1);
    std::array<double, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = origin_[i] + scale_ * (x * axes_[0][i] + y * axes_[1][i] + z * axes_[2][i]);
    points.push_back(p);
    return points.size() - 1;
  }

  Points points;

private:
  static void normalize(std::array<double, 3>& v)
  {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& x : v)
      x /= length;
  }

  std::mt19937& random_;
  const double noise_;
  double scale_;
  std::array<std::array<double, 3>, 3> axes_;
  std::array<double, 3> origin_;
};

// A band between two jagged lines with star-shaped holes beside each other. A slit goes straight down from each.
struct Band : Random_plane
{
  Band(std::mt19937& random, std::size_t holes, std::size_t corners, double noise)
    : Random_plane(random, noise * 2 * double(holes + 1))
  {
    const std::size_t n = (std::max<std::size_t>)(1, corners / (3 * holes + 2));
    for (std::size_t h = 0; h < holes; ++h) {
      add_line(2. * double(h), 0.9, n, -3, -2);
      add_hole(2. * double(h) + 1, n);
    }
    add_line(2. * double(holes), 0.9, (std::max<std::size_t>)(n, 2), -3, -2);
    const std::size_t bottom = polygon.size();
    add_line(0, 2. * double(holes) + 0.9, n * (holes + 1), 2, 3);
    polygon.push_back(add_point(2. * double(holes) + 0.9, number(2, 3)));
    std::reverse(polygon.begin() + std::ptrdiff_t(bottom), polygon.end());
  }

  Indices polygon;
  std::size_t touching_holes = 0;

private:
  void add_line(double x, double width, std::size_t n, double low, double high)
  {
    for (std::size_t i = 0; i < n; ++i)
      polygon.push_back(add_point(x + width * double(i) / double(n), number(low, high)));
  }

  // The slit occurs once or twice, begins at a corner or inside a side, or has no length.
  void add_hole(double x, std::size_t n)
  {
    const int kind = int(number(0, 4));
    const bool is_doubled = kind == 1 || kind == 2, is_within_side = kind == 2, is_touching = kind == 3;
    if (is_within_side)
      polygon.push_back(add_point(x - 0.05, -2.5));
    const std::size_t end = add_point(x, is_within_side ? -2.5 : is_touching ? -2 : number(-3, -2));
    const std::size_t size = (std::max<std::size_t>)(3, n), first = is_touching ? end : add_point(x, -2);
    polygon.insert(polygon.end(), {end, first});
    for (std::size_t i = 1; i < size; ++i) {
      const double angle = -std::acos(-1.) * (0.5 + 2 * double(i) / double(size)), r = number(0.2, 0.7);
      polygon.push_back(add_point(x + r * std::cos(angle), r * std::sin(angle)));
    }
    const auto back = [&](std::size_t v) {
      if (is_doubled)
        points.push_back(points[v]);
      polygon.push_back(is_doubled ? points.size() - 1 : v);
    };
    back(first);
    back(end);
    if (is_within_side)
      polygon.push_back(add_point(x + 0.05, -2.5));
    touching_holes += is_touching;
  }
};

Exact_vector cross(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  Exact_vector result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = Exact(p[j]) * Exact(q[k]) - Exact(p[k]) * Exact(q[j]);
  }
  return result;
}

// Twice the vector of the area that a ring encloses.
template <class Ring>
Exact_vector area(const Points& points, const Ring& ring)
{
  Exact_vector sum = {0, 0, 0};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Exact_vector part = cross(points[ring[i]], points[ring[(i + 1) % ring.size()]]);
    for (std::size_t j = 0; j < 3; ++j)
      sum[j] += part[j];
  }
  return sum;
}

double dot(const Exact_vector& v, const Exact_vector& w)
{
  return CGAL::to_double(v[0] * w[0] + v[1] * w[1] + v[2] * w[2]);
}

void expect_whole(const Points& points, const Indices& polygon)
{
  const IT::Polygon_triangles cut = IT::triangulate_polygon(points, polygon, 0);
  EXPECT_EQ(cut.warning, "");
  const Exact_vector all = area(points, polygon);
  Exact_vector sum = {0, 0, 0};
  double wrong = 0; // area on the wrong side
  for (const auto& triangle : cut.triangles) {
    const Exact_vector part = area(points, triangle);
    for (std::size_t j = 0; j < 3; ++j)
      sum[j] += part[j];
    wrong -= (std::min)(0., dot(part, all));
  }
  EXPECT_TRUE(sum == all);
  EXPECT_LE(wrong, 1e-12 * dot(all, all));
}

// With slits closed, it is a disk with holes.
void expect_disk_with_holes(const Band& given, std::size_t holes)
{
  const IT::Repaired_polygons repaired = IT::repair_polygons(given.points, std::vector<Indices>{given.polygon});
  const IT::Surface_report report = IT::examine_polygons(repaired.points, repaired.triangles);
  EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
  EXPECT_EQ(report.number_of_components, 1u);
  if (given.touching_holes == 0) {
    EXPECT_EQ(long(repaired.points.size()) - long(report.number_of_edges) + long(report.number_of_faces),
              1 - long(holes));
  }
  Exact_vector sum = {0, 0, 0};
  for (const auto& triangle : repaired.triangles) {
    const Exact_vector part = area(repaired.points, triangle);
    for (std::size_t j = 0; j < 3; ++j)
      sum[j] += part[j];
  }
  EXPECT_TRUE(sum == area(given.points, given.polygon));
}

void cut_random_polygons(int rounds, std::size_t most_corners)
{
  std::mt19937 random(3);
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE(round);
    const std::size_t holes = std::uniform_int_distribution<std::size_t>(0, 8)(random);
    const double bits = std::uniform_real_distribution<double>(1.6, std::log2(double(most_corners)))(random),
                 noise = round % 3 == 0 ? 0 : std::pow(10, std::uniform_real_distribution<double>(-16, -3)(random));
    const Band given(random, holes, std::size_t(std::exp2(bits)), noise);
    expect_whole(given.points, given.polygon);
    expect_disk_with_holes(given, holes);
  }
}

TEST(Cut_polygons, have_the_area_that_they_enclose) { cut_random_polygons(60, 300); }
TEST(Cut_polygons, of_many_corners_have_the_area_that_they_enclose) { cut_random_polygons(400, 2000); }

TEST(Cut_polygons, may_touch_themselves_within_a_side)
{
  // A hole hangs at the upper side and touches the lower one; a spike runs back along a side, another over a corner.
  const std::vector<std::vector<std::array<double, 2>>> rings = {
    {{0, 0}, {4, 0}, {4, 4}, {2, 4}, {2, 3}, {3, 1.5}, {2, 0}, {1, 1.5}, {2, 3}, {2, 4}, {0, 4}},
    {{0, 0}, {4, 0}, {3, 0}, {3, 2}, {0, 2}},
    {{0, 0}, {2, 0}, {2, -1}, {2, 3}, {2, 1}, {0, 1}}};
  std::mt19937 random(4);
  for (int round = 0; round < 90; ++round) {
    SCOPED_TRACE(round);
    Random_plane plane(random, round % 2 == 0 ? 0 : 1e-9);
    Indices polygon;
    for (const auto& [x, y] : rings[std::size_t(round) % 3])
      polygon.push_back(plane.add_point(x, y));
    expect_whole(plane.points, polygon);
  }
}

std::string refusal(const Points& points)
{
  Indices polygon;
  for (std::size_t i = 0; i < points.size(); ++i)
    polygon.push_back(i);
  try {
    IT::triangulate_polygon(points, polygon, 7);
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::WRONG_TOPOLOGY);
    EXPECT_EQ(error.element(), 7u);
    return error.what();
  }
  return "";
}

TEST(Cut_polygons, that_cross_themselves_are_named)
{
  EXPECT_EQ(
    refusal({{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}),
    "face 7 crosses itself: its sides 0-1 and 2-3 meet at (1, 1, 0); put its corners into order, or make a vertex "
    "there");
  // Not quite planar, with different lobes, in a slanted plane; a star.
  EXPECT_NE(refusal({{0, 0, 0.001}, {2, 2, -0.001}, {2, 0, 0.001}, {0, 2, 0}}), "");
  EXPECT_NE(refusal({{0, 0, 0}, {5, 0, 0}, {1, 3, 3}, {1, -1, -1}}), "");
  Points star;
  for (int i = 0; i < 5; ++i)
    star.push_back({std::cos(2.51327412287 * i), std::sin(2.51327412287 * i), 0});
  EXPECT_NE(refusal(star), "");
  // A hole in the direction of the outer ring.
  EXPECT_EQ(refusal({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 1, 0}})
              .substr(0, 55),
            "face 7 winds twice around a part of itself, beside vert");
  // The sides of this one miss each other.
  EXPECT_EQ(refusal({{0, 0, 0}, {2, 2, 1}, {2, 0, 0}, {0, 2, 0}}), "");
}

} // namespace

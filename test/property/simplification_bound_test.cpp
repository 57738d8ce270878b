// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bound of a simplification: against exact distances, and against its own steps, repeated with 100 digits.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

std::vector<std::pair<std::string, samples::Indexed_triangles>> curved_surfaces()
{
  return {{"sphere", samples::bumpy_sphere(18, 12, 0.1)},
          {"dome", samples::bumpy_dome(14, 9, 0.05)},
          {"torus", samples::torus(20, 10)},
          {"bad torus", samples::bad_torus(14, 14)},
          {"spike", samples::disk_with_spike(12, 8, 0.5)},
          {"lantern", samples::Schwarz_lantern(8, 12)},
          {"globe", samples::latitude_longitude_sphere(20, 10)}};
}

std::vector<double> distances_from(const Triangulation& triangulation, IT::Vertex_index v)
{
  return IT::geodesic_distances(triangulation, std::vector<IT::Vertex_index>{v}, CGAL::parameters::tolerance(0.))
    .distances;
}

TEST(Simplification_bound, exact_distances_of_all_vertices_are_within_it)
{
  double least_used = 1;
  std::vector<double> used;
  for (const auto& [name, surface] : curved_surfaces())
    for (double change : {0.02, 0.2, 1.}) {
      SCOPED_TRACE(name + " " + std::to_string(change));
      Triangulation fine = triangulation_of(surface);
      IT::Simplified_surface result = IT::simplify_surface(fine, CGAL::parameters::maximum_change(change));
      ASSERT_LT(result.kept.size(), surface.points.size());
      EXPECT_GE(result.shrink, 1 / (1 + change));
      EXPECT_LE(result.stretch, 1 + change);
      // Removed vertices become vertices at their places, so that all pairs can be tested.
      const auto kept = result.kept.size();
      std::vector<IT::Vertex_index> image(surface.points.size());
      for (std::size_t v = 0; v < kept; ++v)
        image[result.kept[v].idx()] = IT::Vertex_index(IT::Vertex_index::size_type(v));
      for (IT::Vertex_index v : fine.connectivity().vertices())
        if (!image[v.idx()].is_valid() && v.idx() % 5 == 0)
          image[v.idx()] = IT::insert_vertex(result.triangulation, result.places[v.idx()]);
      double shrink = 1, stretch = 1;
      for (IT::Vertex_index v : fine.connectivity().vertices()) {
        if (!image[v.idx()].is_valid() || v.idx() % 3 != 0)
          continue;
        const std::vector<double> before = distances_from(fine, v),
                                  after = distances_from(result.triangulation, image[v.idx()]);
        for (IT::Vertex_index w : fine.connectivity().vertices()) {
          if (!image[w.idx()].is_valid() || w == v)
            continue;
          const double factor = after[image[w.idx()].idx()] / before[w.idx()];
          ASSERT_GE(factor, result.shrink * (1 - 1e-9)) << v << " " << w;
          ASSERT_LE(factor, result.stretch * (1 + 1e-9)) << v << " " << w;
          shrink = (std::min)(shrink, factor);
          stretch = (std::max)(stretch, factor);
        }
      }
      used.push_back(
        (std::max)(std::log(shrink) / std::log(result.shrink), std::log(stretch) / std::log(result.stretch)));
      least_used = (std::min)(least_used, used.back());
    }
  // The bound is not absurdly large either.
  std::sort(used.begin(), used.end());
  EXPECT_GT(used[used.size() / 2], 1. / 6);
}

// ------------------------------------------------------------------------------------ the steps, with 100 digits

using Real = boost::multiprecision::cpp_bin_float_100;

struct Point
{
  Real x, y;
};
Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
Real determinant(const Point& p, const Point& q, const Point& r)
{
  const Point a = q - p, b = r - p;
  return a.x * b.y - a.y * b.x;
}

using Triangle = std::array<Point, 3>;

// The third corner, where two circles meet to the left of the first side.
Point third_corner(const Point& p, const Point& q, const Real& from_p, const Real& from_q)
{
  const Point d = q - p;
  const Real length = sqrt(d.x * d.x + d.y * d.y);
  const Real along = (from_p * from_p - from_q * from_q + length * length) / (2 * length);
  const Real across = sqrt(from_p * from_p - along * along);
  return {p.x + (along * d.x - across * d.y) / length, p.y + (along * d.y + across * d.x) / length};
}

struct Factors
{
  Real down = 1, up = 1;
};

// The singular values of the linear map from one triangle to another.
Factors singular_values(const Triangle& from, const Triangle& to)
{
  const Point a = from[1] - from[0], b = from[2] - from[0], c = to[1] - to[0], d = to[2] - to[0];
  const Real area = a.x * b.y - a.y * b.x;
  const Real xx = (c.x * b.y - d.x * a.y) / area, xy = (d.x * a.x - c.x * b.x) / area,
             yx = (c.y * b.y - d.y * a.y) / area, yy = (d.y * a.x - c.y * b.x) / area;
  const Real e = (xx + yy) / 2, f = (xx - yy) / 2, g = (yx + xy) / 2, h = (yx - xy) / 2;
  const Real q = sqrt(e * e + h * h), r = sqrt(f * f + g * g);
  return {q - r, q + r};
}

// Whether no side of either triangle has the other one behind it.
bool overlap(const Triangle& one, const Triangle& two)
{
  const auto separates = [](const Triangle& t, const Triangle& other) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Real area = determinant(t[0], t[1], t[2]);
      if (std::all_of(other.begin(), other.end(),
                      [&](const Point& p) { return determinant(t[i], t[(i + 1) % 3], p) < Real(1e-60) * area; }))
        return true;
    }
    return false;
  };
  return !separates(one, two) && !separates(two, one);
}

// Repeats all steps, and checks that each of them is a map from one side to the other.
class Replay
{
public:
  explicit Replay(const IT::Simplification_map& map) : map_(map), factors_(map.sides().size())
  {
    for (const auto& step : map.steps())
      take(step);
  }
  const Factors& of_face(IT::Face_index f) const { return factors_[map_.number_of_coarse_face(f)]; }

private:
  using Step = IT::Simplification_map::Step;
  using Numbered = IT::Simplification_map::Triangle;

  void take(const Step& step)
  {
    const Numbered *const old = map_.triangles(step), *const fresh = old + step.number_of_old;
    const std::vector<Point> image = layout(step, fresh, step.number_of_new);
    Real area = 0, old_area = 0;
    for (std::size_t i = 0; i < step.number_of_new; ++i) {
      const Triangle t = corners(image, fresh[i]);
      ASSERT_GT(determinant(t[0], t[1], t[2]), 0);
      area += determinant(t[0], t[1], t[2]);
    }
    for (std::size_t i = 0; i < step.number_of_old; ++i) {
      const Triangle target = corners(image, old[i]);
      ASSERT_GT(determinant(target[0], target[1], target[2]), 0);
      old_area += determinant(target[0], target[1], target[2]);
      expect_same_side(old[i], fresh, step.number_of_new, step.number_of_points - 1);
      const std::array<double, 3>& sides = map_.sides()[old[i].number];
      const Point p{0, 0}, q{sides[0], 0};
      const Factors f = singular_values({p, q, third_corner(p, q, sides[2], sides[1])}, target);
      for (std::size_t k = 0; k < step.number_of_new; ++k)
        if (overlap(target, corners(image, fresh[k])))
          merge(factors_[fresh[k].number], factors_[old[i].number], f,
                is_first_.insert({fresh[k].number, true}).second);
    }
    ASSERT_LT(abs(old_area - area), Real(1e-70) * area) << "faces do not cover the hole once";
  }

  static void merge(Factors& result, const Factors& old, const Factors& f, bool is_first)
  {
    const Factors product{old.down * f.down, old.up * f.up};
    if (is_first)
      result = product;
    result.down = (std::min)(result.down, product.down);
    result.up = (std::max)(result.up, product.up);
  }

  // The side on the link is a side of a new triangle, with the same length.
  void expect_same_side(const Numbered& old, const Numbered* fresh, std::size_t n, std::uint32_t center) const
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t p = old.corners[i], q = old.corners[(i + 1) % 3];
      if (p == center || q == center)
        continue;
      bool is_found = false;
      for (std::size_t k = 0; k < n; ++k)
        for (std::size_t j = 0; j < 3; ++j)
          is_found = is_found || (fresh[k].corners[j] == p && fresh[k].corners[(j + 1) % 3] == q &&
                                  map_.sides()[fresh[k].number][j] == map_.sides()[old.number][i]);
      EXPECT_TRUE(is_found) << "a side of the hole changed its length";
    }
  }

  static Triangle corners(const std::vector<Point>& points, const Numbered& t)
  {
    return {points[t.corners[0]], points[t.corners[1]], points[t.corners[2]]};
  }

  std::vector<Point> layout(const Step& step, const Numbered* triangles, std::size_t n) const
  {
    std::vector<Point> result(step.number_of_points);
    std::map<std::uint32_t, bool> is_placed;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& c = triangles[i].corners;
      const auto& sides = map_.sides()[triangles[i].number];
      if (i == 0) {
        result[c[1]] = {sides[0], 0};
        is_placed[c[0]] = is_placed[c[1]] = true;
      }
      for (std::size_t k = 0; k < 3; ++k)
        if (!is_placed[c[(k + 2) % 3]]) {
          result[c[(k + 2) % 3]] =
            third_corner(result[c[k]], result[c[(k + 1) % 3]], sides[(k + 2) % 3], sides[(k + 1) % 3]);
          is_placed[c[(k + 2) % 3]] = true;
          break;
        }
    }
    Real sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_GE(step.place[k], 0);
      sum += step.place[k];
      result.back().x += step.place[k] * result[triangles[0].corners[k]].x;
      result.back().y += step.place[k] * result[triangles[0].corners[k]].y;
    }
    result.back().x /= sum;
    result.back().y /= sum;
    return result;
  }

  const IT::Simplification_map& map_;
  std::vector<Factors> factors_;
  std::map<std::uint32_t, bool> is_first_;
};

void expect_replayed(Triangulation fine, double change)
{
  const IT::Simplified_surface result = IT::simplify_surface(fine, CGAL::parameters::maximum_change(change));
  const Replay replay(result.map);
  for (IT::Face_index f : result.map.coarse().faces()) {
    EXPECT_LE(Real(result.changes_in_faces[f.idx()].shrink), replay.of_face(f).down);
    EXPECT_GE(Real(result.changes_in_faces[f.idx()].stretch), replay.of_face(f).up);
  }
}

TEST(Simplification_bound, steps_repeated_with_100_digits_stay_within_it)
{
  for (const auto& [name, surface] : curved_surfaces()) {
    SCOPED_TRACE(name);
    expect_replayed(triangulation_of(surface), 0.1);
  }
}

TEST(Simplification_bound, steps_repeated_on_hard_surfaces_stay_within_it)
{
  expect_replayed(triangulation_of(samples::sliver_sheet(8, 1e-3, 1e-3)), 0.2);
  expect_replayed(triangulation_of(samples::cap(1e-4)), 0.2);
  expect_replayed(triangulation_of(samples::helical_tube(40, 30)), 0.2);
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const samples::Glued_triangles gluing = samples::random_gluing(60, seed, seed == 2, true);
    const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
    expect_replayed(Triangulation::from_lengths(complex, std::vector<double>(complex.number_of_edges(), 1.)), 1);
  }
}

} // namespace

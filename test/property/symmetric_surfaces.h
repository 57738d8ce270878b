// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Folded sheets with an exact symmetry: four vertices lie on a circle across any number of folds, no two of them
// parallel, so that the tie has as many independent square roots.

#ifndef IDT_TEST_PROPERTY_SYMMETRIC_SURFACES_H
#define IDT_TEST_PROPERTY_SYMMETRIC_SURFACES_H

#include "samples/sample_surface_types.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace symmetric_surfaces {

namespace IT = CGAL::Intrinsic_triangulations;
using Point = std::array<double, 3>;

// All surfaces are disks without a vertex inside, so that each has one layout in the plane.
struct Surface
{
  samples::Indexed_triangles mesh;
  // Vertices on a circle, counterclockwise; no other vertex is inside of it.
  std::array<std::uint32_t, 4> corners{};
};

inline IT::Delta_complex connectivity(const Surface& surface)
{
  return IT::make_Delta_complex_from_triangles(surface.mesh.points.size(), surface.mesh.triangles);
}

using Rational = IT::Rational;

// By edges.
inline std::vector<Rational> squared_lengths(const Surface& surface)
{
  const IT::Delta_complex complex = connectivity(surface);
  std::vector<Rational> result;
  for (IT::Edge_index e : complex.edges()) {
    const IT::Halfedge_index h = complex.halfedge(e);
    const Point &p = surface.mesh.points[complex.source(h).idx()], &q = surface.mesh.points[complex.target(h).idx()];
    Rational s = 0;
    for (std::size_t i = 0; i < 3; ++i)
      s += (Rational(p[i]) - Rational(q[i])) * (Rational(p[i]) - Rational(q[i]));
    result.push_back(s);
  }
  return result;
}

// The edge that is a diagonal of the corners, or none.
inline IT::Edge_index diagonal_of_corners(const IT::Delta_complex& complex, const Surface& surface)
{
  for (IT::Edge_index e : complex.edges()) {
    const std::uint32_t p = complex.source(complex.halfedge(e)).idx(), q = complex.target(complex.halfedge(e)).idx();
    for (std::size_t i = 0; i < 4; ++i)
      if (p == surface.corners[i] && q == surface.corners[(i + 2) % 4])
        return e;
  }
  return {};
}

// A fold from bottom to top, with a vertex on it or none.
struct Column
{
  static constexpr std::uint32_t none = std::uint32_t(-1);
  std::uint32_t bottom, top, between = none;
};

class Sheet
{
public:
  enum class Diagonal {
    RISING,
    FALLING
  };

  std::uint32_t add(const Point& p)
  {
    mesh_.points.push_back(p);
    return std::uint32_t(mesh_.points.size() - 1);
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.push_back({a, b, c}); }

  // Two triangles between neighbouring folds, a to the left of b.
  void add_strip(const Column& a, const Column& b, Diagonal diagonal)
  {
    if (diagonal == Diagonal::RISING) {
      add_at_right_fold(a.bottom, b);
      add_at_left_fold(b.top, a);
    } else {
      add_at_left_fold(b.bottom, a);
      add_at_right_fold(a.top, b);
    }
  }

  // As above, but the triangle at the upper border is cut in two, at a quarter of the border.
  void add_strip_with_cut(const Column& a, const Column& b, Diagonal diagonal)
  {
    const Point &p = mesh_.points[a.top], &q = mesh_.points[b.top];
    const std::uint32_t cut = add({(3 * p[0] + q[0]) / 4, (3 * p[1] + q[1]) / 4, (3 * p[2] + q[2]) / 4});
    const std::uint32_t apex = diagonal == Diagonal::RISING ? a.bottom : b.bottom;
    if (diagonal == Diagonal::RISING)
      add_triangle(a.bottom, b.bottom, b.top);
    else
      add_triangle(a.bottom, b.bottom, a.top);
    add_triangle(apex, b.top, cut);
    add_triangle(apex, cut, a.top);
  }

  Surface finish(const std::array<std::uint32_t, 4>& corners) { return {std::move(mesh_), corners}; }

private:
  void add_at_left_fold(std::uint32_t apex, const Column& a)
  {
    if (a.between == Column::none)
      return add_triangle(a.bottom, apex, a.top);
    add_triangle(a.bottom, apex, a.between);
    add_triangle(a.between, apex, a.top);
  }
  void add_at_right_fold(std::uint32_t apex, const Column& b)
  {
    if (b.between == Column::none)
      return add_triangle(apex, b.bottom, b.top);
    add_triangle(apex, b.bottom, b.between);
    add_triangle(apex, b.between, b.top);
  }

  samples::Indexed_triangles mesh_;
};

inline Sheet::Diagonal diagonal(bool is_falling)
{
  return is_falling ? Sheet::Diagonal::FALLING : Sheet::Diagonal::RISING;
}

// The positions of the folds, in [0, 1), and the heights of their ends above the plane: small, so that the layout is
// close to the view from above. All numbers are multiples of 2^-20, and their sums are exact.
class Random_folds
{
public:
  explicit Random_folds(int number) : random_(5), spacing_(1. / (number + 1)) {}
  double position(int i) { return rounded((i + uniform(0, 0.5)) * spacing_); }
  double height() { return rounded(uniform(-0.05, 0.05) * spacing_); }

private:
  static double rounded(double x) { return std::round(std::ldexp(x, 20)) * 0x1p-20; }
  double uniform(double a, double b) { return a + (b - a) * double(random_() >> 11) * 0x1p-53; }

  std::mt19937_64 random_;
  double spacing_;
};

constexpr double far_away = 64; // where the folds end

// A sheet and its mirror image across a fold. With `has_cuts`, triangles of one half are cut: then both halves
// are congruent, but not their triangles, and roots of one are rational multiples of roots of the other.
inline Surface mirrored_sheet(int folds_on_each_side, bool has_cuts = false)
{
  Random_folds random(folds_on_each_side);
  Sheet sheet;
  const double a = random.height(), b = random.height();
  const Column middle{sheet.add({0, -far_away, a}), sheet.add({0, far_away, b})};
  Column left = middle, right = middle;
  for (int i = 1; i <= folds_on_each_side; ++i) {
    const double x = random.position(i), bottom = random.height(), top = random.height();
    const Column next_left{sheet.add({-x, -far_away, bottom}), sheet.add({-x, far_away, top})},
      next_right{sheet.add({x, -far_away, bottom}), sheet.add({x, far_away, top})};
    sheet.add_strip(next_left, left, diagonal(i % 2 == 0));
    if (has_cuts)
      sheet.add_strip_with_cut(right, next_right, diagonal(i % 2 == 1));
    else
      sheet.add_strip(right, next_right, diagonal(i % 2 == 1));
    left = next_left;
    right = next_right;
  }
  const double p = random.height(), q = random.height();
  const std::array<std::uint32_t, 4> corners{sheet.add({1.25, 0.3125, p}), sheet.add({-1.25, 0.3125, p}),
                                             sheet.add({-1.25, -0.3125, q}), sheet.add({1.25, -0.3125, q})};
  sheet.add_triangle(right.top, right.bottom, corners[0]);
  sheet.add_triangle(right.bottom, corners[3], corners[0]);
  sheet.add_triangle(left.bottom, left.top, corners[1]);
  sheet.add_triangle(corners[2], left.bottom, corners[1]);
  return sheet.finish(corners);
}

// A flat regular polygon with equal arms at some of its sides. The map turns the plane by one side, and may
// reflect space in it: to the arms this makes no difference.
struct Star
{
  Point outward, along, up;          // of the first side
  double distance, half_side, reach; // the side, and where the arm ends; in these vectors
  std::function<Point(const Point&)> turn;
  int number_of_sides;
};

inline Surface star(const Star& shape, const std::array<int, 4>& arms, int folds)
{
  const auto point = [&](int side, double a, double b, double c) {
    Point p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = a * shape.outward[i] + b * shape.along[i] + c * shape.up[i];
    for (; side > 0; --side)
      p = shape.turn(p);
    return p;
  };
  Sheet sheet;
  std::vector<std::uint32_t> polygon;
  for (int i = 0; i < shape.number_of_sides; ++i)
    polygon.push_back(sheet.add(point(i, shape.distance, -shape.half_side, 0)));
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sheet.add_triangle(polygon[0], polygon[i - 1], polygon[i]);
  std::array<std::uint32_t, 4> corners;
  for (std::size_t arm = 0; arm < 4; ++arm) {
    Random_folds random(folds); // the same for each arm
    const std::size_t side = std::size_t(arms[arm]);
    Column last{polygon[side], polygon[(side + 1) % polygon.size()]};
    for (int i = 1; i <= folds; ++i) {
      const double a = shape.distance + shape.reach * random.position(i), end = 1.25 * shape.half_side;
      const double bottom = random.height(), top = random.height();
      const Column next{sheet.add(point(arms[arm], a, -end, bottom)), sheet.add(point(arms[arm], a, end, top))};
      sheet.add_strip(last, next, diagonal(i % 2 == 1));
      last = next;
    }
    corners[arm] = sheet.add(point(arms[arm], shape.distance + shape.reach, 0.3125, random.height()));
    sheet.add_triangle(last.bottom, corners[arm], last.top);
  }
  return sheet.finish(corners);
}

inline Star square()
{
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 10, 10, 2, [](const Point& p) { return Point{-p[1], p[0], p[2]}; }, 4};
}
// In the plane x + y + z = 0.
inline Star hexagon()
{
  return {{2, -1, -1}, {0, 1, -1}, {1, 1, 1}, 8, 8, 1, [](const Point& p) { return Point{-p[1], -p[2], -p[0]}; }, 6};
}

// Four arms, turned by 90 degrees: the corners form a square.
inline Surface quarter_turns(int folds) { return star(square(), {0, 1, 2, 3}, folds); }
// Arms turned by 60 degrees: a trapezoid.
inline Surface sixth_turns(int folds) { return star(hexagon(), {0, 1, 2, 3}, folds); }
// Symmetric about a point: a rectangle.
inline Surface half_turn(int folds) { return star(hexagon(), {0, 1, 3, 4}, folds); }

// A part of a periodic sheet: a translation combined with a reflection maps the folds to folds. The corners are four
// of the images of one point: a trapezoid whose legs and whose diagonals the glide maps to each other.
// Two of them lie inside; there the sheet is slit from the border.
inline Surface glided_sheet(int folds_in_a_period)
{
  constexpr int periods = 4;
  constexpr double offset = 0.25; // of the point from the axis
  Random_folds random(folds_in_a_period - 1);
  std::vector<Point> folds; // position and heights of the ends
  for (int i = 0; i < folds_in_a_period; ++i) {
    const double x = i == 0 ? 0 : random.position(i), bottom = random.height(), top = random.height();
    folds.push_back({x, bottom, top});
  }
  Sheet sheet;
  std::vector<std::uint32_t> corners;
  Column last{};
  for (int i = 0; i <= periods * folds_in_a_period; ++i) {
    const int period = i / folds_in_a_period, number = i % folds_in_a_period;
    const bool is_reflected = period % 2 == 1;
    const Point& fold = folds[std::size_t(number)];
    const double x = period + fold[0], bottom = fold[is_reflected ? 2 : 1], top = fold[is_reflected ? 1 : 2];
    Column column{sheet.add({x, -far_away, bottom}), sheet.add({x, far_away, top})};
    if (number == 0 && period != 2) {
      const double y = is_reflected ? offset : -offset;
      column.between = sheet.add({x, y, (bottom + top) / 2 + y / far_away * ((top - bottom) / 2)});
      corners.push_back(column.between);
    }
    if (i > 0) {
      // The strip belongs to the fold before it.
      const int before = i - 1;
      const bool is_odd = (before % folds_in_a_period + before / folds_in_a_period) % 2 == 1;
      sheet.add_strip(last, column, diagonal(is_odd));
    }
    last = column;
    if (column.between != Column::none && is_reflected)
      last.top = sheet.add({x, far_away, top});
  }
  return sheet.finish({corners[0], corners[3], corners[2], corners[1]});
}

} // namespace symmetric_surfaces

#endif // IDT_TEST_PROPERTY_SYMMETRIC_SURFACES_H

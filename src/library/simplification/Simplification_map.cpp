// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Carries points through the steps of a simplification.

#include "flat_layout.h"
#include "../connectivity/checked_coordinates.h"

#include <CGAL/Intrinsic_triangulations/Simplification_map.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace {

constexpr std::uint32_t no_triangle = std::uint32_t(-1);

} // namespace

// The points of a step in the plane.
struct Simplification_map::Layout
{
  Layout(const Simplification_map& map, const Step& step) : points(step.number_of_points, {0, 0})
  {
    const Triangle* const fresh = map.triangles(step) + step.number_of_old;
    std::vector<bool> is_placed(step.number_of_points, false);
    for (std::uint32_t i = 0; i < step.number_of_new; ++i) {
      const Triangle& t = fresh[i];
      std::array<double, 3> sides = map.sides_[t.number];
      std::array<std::uint32_t, 3> corners = t.corners;
      if (i == 0) {
        points[corners[1]] = {sides[0], 0};
        is_placed[corners[0]] = is_placed[corners[1]] = true;
      }
      while (is_placed[corners[2]]) { // turn until the new point is the third corner
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        std::rotate(sides.begin(), sides.begin() + 1, sides.end());
      }
      const double four_areas =
        std::sqrt((std::max)(0., squared_four_areas_from_lengths(sides[0], sides[1], sides[2])));
      points[corners[2]] =
        internal::third_corner(points[corners[0]], points[corners[1]], sides[0], sides[2], sides[1], four_areas);
      is_placed[corners[2]] = true;
    }
    points.back() = position(fresh[0], step.place);
  }

  Planar_vector<double> position(const Triangle& t, const Coordinates& b) const
  {
    Planar_vector<double> result(0, 0);
    for (std::size_t i = 0; i < 3; ++i)
      result = result + points[t.corners[i]] * Planar_vector<double>(b[i], 0);
    return result;
  }
  // Outside of the triangle, some are negative.
  Coordinates coordinates(const Triangle& t, const Planar_vector<double>& p) const
  {
    const Planar_vector<double> a = points[t.corners[0]] - p, b = points[t.corners[1]] - p,
                                c = points[t.corners[2]] - p;
    Coordinates result{internal::determinant(b, c), internal::determinant(c, a), internal::determinant(a, b)};
    const double sum = result[0] + result[1] + result[2];
    for (double& x : result)
      x /= sum;
    return result;
  }

  std::vector<Planar_vector<double>> points;
};

// Carries points through one step, or back: from triangles to their replacements.
class Simplification_map::Carrier
{
public:
  using Triangles = Iterator_range<const Triangle*>;

  Carrier(const Simplification_map& map, const Step& step, bool is_forward) : map_(map), step_(step)
  {
    const Triangle *const first = map.triangles(step), *const middle = first + step.number_of_old;
    from_ = Triangles(first, middle);
    to_ = Triangles(middle, middle + step.number_of_new);
    if (!is_forward)
      std::swap(from_, to_);
  }

  const Triangles& from() const { return from_; }
  const Triangles& to() const { return to_; }

  // Returns the other triangle in which a point lies. A point at a remaining corner is there exactly.
  std::uint32_t carry(const Triangle& t, Coordinates& coordinates)
  {
    const auto one = std::find(coordinates.begin(), coordinates.end(), 1.);
    if (one != coordinates.end())
      for (const Triangle& other : to_) {
        const auto same =
          std::find(other.corners.begin(), other.corners.end(), t.corners[std::size_t(one - coordinates.begin())]);
        if (same == other.corners.end())
          continue;
        coordinates = {0, 0, 0};
        coordinates[std::size_t(same - other.corners.begin())] = 1;
        return other.number;
      }
    const Planar_vector<double> p = layout().position(t, coordinates);
    std::uint32_t result = no_triangle;
    double best = -std::numeric_limits<double>::infinity();
    for (const Triangle& other : to_) {
      const Coordinates b = layout().coordinates(other, p);
      const double least = *std::min_element(b.begin(), b.end());
      if (result == no_triangle || least > best) {
        best = least;
        result = other.number;
        coordinates = b;
      }
    }
    clamp(coordinates);
    return result;
  }

  // Finds the part of a line in a triangle that lies in one of the others: from `first` to `last` of its length.
  bool clip(const Triangle& t, const Coordinates& begin, const Coordinates& end, const Triangle& other, double& first,
            double& last, Coordinates& from, Coordinates& to)
  {
    const Coordinates a = layout().coordinates(other, layout().position(t, begin)),
                      b = layout().coordinates(other, layout().position(t, end));
    for (std::size_t i = 0; i < 3; ++i) {
      const double u = std::abs(a[i]) < 1e-12 ? 0 : a[i], v = std::abs(b[i]) < 1e-12 ? 0 : b[i];
      if (u <= 0 && v <= 0 && (u < 0 || v < 0))
        return false;
      if (u < 0)
        first = (std::max)(first, u / (u - v));
      if (v < 0)
        last = (std::min)(last, u / (u - v));
    }
    if (!(last > first))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = a[i] + first * (b[i] - a[i]);
      to[i] = a[i] + last * (b[i] - a[i]);
    }
    clamp(from);
    clamp(to);
    return true;
  }

private:
  const Layout& layout()
  {
    if (!layout_)
      layout_.emplace(map_, step_);
    return *layout_;
  }
  static void clamp(Coordinates& coordinates)
  {
    double sum = 0;
    for (double& x : coordinates)
      sum += x = (std::max)(x, 0.);
    for (double& x : coordinates)
      x /= sum;
  }

  const Simplification_map& map_;
  const Step& step_;
  Triangles from_{nullptr, nullptr}, to_{nullptr, nullptr};
  std::optional<Layout> layout_; // made when it is needed
};

Simplification_map::Simplification_map(const Delta_complex& complex, const std::vector<double>& lengths)
  : fine_(complex)
{
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    add_triangle({lengths[complex.edge(h).idx()], lengths[complex.edge(complex.next(h)).idx()],
                  lengths[complex.edge(complex.prev(h)).idx()]});
  }
}

void Simplification_map::add_step(std::uint32_t number_of_old, std::uint32_t number_of_points,
                                  const std::array<double, 3>& place)
{
  const std::size_t first =
    steps_.empty() ? 0 : steps_.back().first + steps_.back().number_of_old + steps_.back().number_of_new;
  steps_.push_back(
    {first, number_of_old, std::uint32_t(triangles_.size() - first) - number_of_old, number_of_points, place});
}

void Simplification_map::finish(const Delta_complex& complex, std::vector<std::uint32_t> numbers)
{
  coarse_ = complex;
  coarse_numbers_ = std::move(numbers);
}

namespace {

using Coordinates = std::array<double, 3>;

// Points by the triangles that they are in.
class Points_by_triangle
{
public:
  explicit Points_by_triangle(std::size_t number_of_triangles) : first_(number_of_triangles, no_triangle) {}
  void add(std::uint32_t triangle, std::uint32_t point)
  {
    if (point >= next_.size())
      next_.resize(point + 1, no_triangle);
    next_[point] = std::exchange(first_[triangle], point);
  }
  template <class F>
  void take(std::uint32_t triangle, const F& f)
  {
    for (std::uint32_t p = std::exchange(first_[triangle], no_triangle); p != no_triangle;) {
      const std::uint32_t next = next_[p];
      f(p);
      p = next;
    }
  }

private:
  std::vector<std::uint32_t> first_, next_;
};

} // namespace

// Goes through the steps in order, or backward.
template <class F>
void Simplification_map::for_each_step(bool is_forward, const F& f) const
{
  if (is_forward)
    for (auto step = steps_.begin(); step != steps_.end(); ++step)
      f(Carrier(*this, *step, true));
  else
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step)
      f(Carrier(*this, *step, false));
}

std::vector<Surface_point> Simplification_map::carried(const std::vector<Surface_point>& points, bool is_forward) const
{
  const Delta_complex &from = is_forward ? fine_ : coarse_, &to = is_forward ? coarse_ : fine_;
  Points_by_triangle by_triangle(sides_.size());
  std::vector<Coordinates> coordinates;
  coordinates.reserve(points.size());
  for (const Surface_point& point : points) {
    coordinates.push_back(internal::checked_coordinates(from, point));
    by_triangle.add(number_of_face(from.face(point.halfedge), is_forward), std::uint32_t(coordinates.size() - 1));
  }
  for_each_step(is_forward, [&](Carrier carrier) {
    for (const Triangle& t : carrier.from())
      by_triangle.take(t.number, [&](std::uint32_t p) { by_triangle.add(carrier.carry(t, coordinates[p]), p); });
  });
  std::vector<Surface_point> result(points.size());
  for (Face_index f : to.faces())
    by_triangle.take(number_of_face(f, !is_forward), [&](std::uint32_t p) {
      result[p] = {to.halfedge(f), coordinates[p]};
    });
  return result;
}

std::vector<Surface_point> Simplification_map::to_coarse(const std::vector<Surface_point>& points) const
{
  return carried(points, true);
}
std::vector<Surface_point> Simplification_map::to_fine(const std::vector<Surface_point>& points) const
{
  return carried(points, false);
}

std::vector<Simplification_map::Line> Simplification_map::lines_to_fine(const std::vector<Line_part>& lines) const
{
  Points_by_triangle by_triangle(sides_.size());
  struct Part
  {
    std::size_t line;
    double begin; // where on the line
    double end;
    Coordinates from, to;
  };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& [from, to] = lines[i];
    if (to.halfedge != from.halfedge)
      throw Invalid_point_error("the ends of line " + std::to_string(i) + " do not have the same halfedge");
    parts.push_back(
      {i, 0, 1, internal::checked_coordinates(coarse_, from), internal::checked_coordinates(coarse_, to)});
    by_triangle.add(number_of_face(coarse_.face(from.halfedge), false), std::uint32_t(i));
  }
  std::vector<std::pair<std::uint32_t, Part>> found;
  for_each_step(false, [&](Carrier carrier) {
    for (const Triangle& t : carrier.from())
      by_triangle.take(t.number, [&](std::uint32_t p) {
        const Part whole = parts[p];
        found.clear();
        for (const Triangle& other : carrier.to()) {
          double first = 0, last = 1;
          Part part = whole;
          if (!carrier.clip(t, whole.from, whole.to, other, first, last, part.from, part.to))
            continue;
          part.begin = whole.begin + first * (whole.end - whole.begin);
          part.end = whole.begin + last * (whole.end - whole.begin);
          found.emplace_back(other.number, part);
        }
        std::sort(found.begin(), found.end(),
                  [](const auto& a, const auto& b) { return a.second.begin < b.second.begin; });
        // A part along an edge was found on both sides of it.
        double reached = -1;
        bool is_first = true;
        for (const auto& [number, part] : found) {
          if (part.end - reached <= 1e-12)
            continue;
          reached = part.end;
          if (is_first)
            parts[p] = part;
          else
            parts.push_back(part);
          by_triangle.add(number, is_first ? p : std::uint32_t(parts.size() - 1));
          is_first = false;
        }
      });
  });
  std::vector<std::pair<Part, Face_index>> ends;
  for (Face_index f : fine_.faces())
    by_triangle.take(f.idx(), [&](std::uint32_t p) { ends.emplace_back(parts[p], f); });
  std::sort(ends.begin(), ends.end(), [](const auto& a, const auto& b) {
    return a.first.line != b.first.line ? a.first.line < b.first.line : a.first.begin < b.first.begin;
  });
  std::vector<Line> result(lines.size());
  for (const auto& [part, f] : ends) {
    const Halfedge_index h = fine_.halfedge(f);
    result[part.line].push_back({Surface_point{h, part.from}, Surface_point{h, part.to}});
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: two sheets that lie on each other are zipped from the fold between them.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Point = std::array<double, 3>;

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

// Where the lines pq and rs are nearest to each other: two parameters, which are not numbers on parallel lines.
std::array<double, 2> nearest_parameters(const Point& p, const Point& q, const Point& r, const Point& s)
{
  const Point u = difference(q, p), v = difference(s, r), w = difference(p, r);
  const double uu = scalar_product(u, u), uv = scalar_product(u, v), vv = scalar_product(v, v),
               uw = scalar_product(u, w), vw = scalar_product(v, w), determinant = uu * vv - uv * uv;
  return {(uv * vw - vv * uw) / determinant, (uu * vw - uv * uw) / determinant};
}

} // namespace

// Where two triangles at the edge ab lie on each other, divides them until they have a part in common that begins at
// ab, and leaves this part out.
// \return the triangles that have changed; empty if there was nothing to do
std::vector<std::uint32_t> Thin_part_merger::zip(std::uint32_t a, std::uint32_t b)
{
  const std::vector<std::uint32_t> there = triangles_at(a, b);
  if (there.size() != 2 || after(mesh_.triangles[there[0]], a) == after(mesh_.triangles[there[1]], a))
    return {};
  const bool is_second = after(mesh_.triangles[there[0]], a) != b;
  Fold fold{a, b, 0, 0, there[is_second], there[!is_second]};
  if (after(mesh_.triangles[fold.s], a) != b || after(mesh_.triangles[fold.t], b) != a)
    return {};
  fold.c = after(mesh_.triangles[fold.s], b);
  fold.d = after(mesh_.triangles[fold.t], a);
  const auto& points = map_.points();
  // In degrees. Where a wall or a film was between them, curved sheets may have other facets on each side.
  const auto was_apart = [this](std::uint32_t v) { return is_merged_[v] || is_at_film_[v]; };
  const double largest_fold = was_apart(a) && was_apart(b) ? 20 : 1;
  if (is_fixed(a) || is_fixed(b) || is_fixed(fold.c) || is_fixed(fold.d) ||
      !(dihedral_angle(points[a], points[b], points[fold.c], points[fold.d]) < largest_fold))
    return {};
  for (std::uint32_t t : {fold.s, fold.t}) // other steps may help
    if (!is_waiting_[t]) {
      to_look_at_.push_back(t);
      is_waiting_[t] = true;
    }
  const Fold other{b, a, fold.d, fold.c, fold.t, fold.s};
  using Step = std::vector<std::uint32_t> (Thin_part_merger::*)(const Fold&);
  const auto is_flat = [&](std::uint32_t v) {
    const Triangle corners{a, b, v};
    const double longest = (std::max)({length(a, b), length(b, v), length(v, a)});
    return 2 * area(corners) <= longest * near_;
  };
  for (Step step :
       {&Thin_part_merger::contract_fold, &Thin_part_merger::zip_to_corner, &Thin_part_merger::flatten_fold})
    for (const Fold& one : {fold, other})
      if (std::vector<std::uint32_t> changed = (this->*step)(one); !changed.empty())
        return changed;
  if (is_flat(fold.c) || is_flat(fold.d))
    return {};
  for (Step step :
       {&Thin_part_merger::zip_to_side, &Thin_part_merger::flip_to_side, &Thin_part_merger::zip_to_crossing})
    for (const Fold& one : {fold, other})
      if (std::vector<std::uint32_t> changed = (this->*step)(one); !changed.empty())
        return changed;
  return {};
}

// The corner d becomes c, which is near it. Both triangles are left out.
std::vector<std::uint32_t> Thin_part_merger::zip_to_corner(const Fold& fold)
{
  const std::uint32_t c = fold.c, d = fold.d;
  if (c != d && length(c, d) > near_)
    return {};
  Change change = c == d ? Change{} : contraction(d, c);
  if (c != d) {
    const auto at = std::find(change.triangles.begin(), change.triangles.end(), fold.t) - change.triangles.begin();
    change.triangles.erase(change.triangles.begin() + at);
    change.corners.erase(change.corners.begin() + at);
    change.beside.erase(std::remove(change.beside.begin(), change.beside.end(), fold.s), change.beside.end());
  }
  leave_out(change, fold.s, {fold.a, fold.b, c});
  leave_out(change, fold.t, {fold.b, fold.a, d});
  if (!is_near_enough(change))
    return {};
  if (c != d)
    merge_vertex(d, c);
  return finish(change, fold, c);
}

// Contracts a short side of s.
std::vector<std::uint32_t> Thin_part_merger::contract_fold(const Fold& fold)
{
  const Triangle corners{fold.a, fold.b, fold.c};
  for (std::uint32_t from : corners)
    for (std::uint32_t to : corners)
      if (from != to && length(from, to) <= near_)
        if (Change change = contraction(from, to); is_near_enough(change)) {
          merge_vertex(from, to);
          return finish(change, fold, to);
        }
  return {};
}

// A corner of s that is near the opposite side divides the triangle beyond, and s vanishes.
std::vector<std::uint32_t> Thin_part_merger::flatten_fold(const Fold& fold)
{
  const Triangle corners{fold.a, fold.b, fold.c};
  const auto& points = map_.points();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t p = corners[i], q = corners[(i + 1) % 3], r = corners[(i + 2) % 3];
    const double x = fraction_between(points[q], points[r], points[p]);
    const std::vector<std::uint32_t> there = triangles_at(q, r);
    if (!(x > 0 && x < 1) || there.size() != 2 || distance(points[p], between(points[q], points[r], x)) > near_)
      continue;
    const std::uint32_t beyond = there[there[0] == fold.s], e = after(mesh_.triangles[beyond], q);
    Change change{{fold.s, beyond}, {{p, q, e}, {p, e, r}}, {}};
    if (e == p || after(mesh_.triangles[beyond], r) != q || number_of_triangles_at(p, e) > 0 ||
        gain(change, places(change)).second < 1.01 || !is_near_enough(change))
      continue;
    divide_mark(q, r, p);
    return finish(change, fold, fold.c);
  }
  return {};
}

// The corner c becomes one of the other triangle, or of its side beyond, and divides that.
std::vector<std::uint32_t> Thin_part_merger::zip_to_side(const Fold& fold)
{
  const auto [a, b, c, d, s, t] = fold;
  const Point& p = map_.points()[c];
  Space_triangle seen = map_.corners({b, a, d});
  for (Point& q : seen)
    q = difference(q, p);
  auto [coordinates, squared] = nearest_to_origin(seen);
  const Point normal = normal_of(seen);
  const double height = scalar_product(normal, seen[0]), squared_near = near_ * near_,
               squared_height = height * height / scalar_product(normal, normal);
  if (c == d || coordinates[2] == 0 || !(squared_height <= maximum_deviation_ * maximum_deviation_) ||
      !(squared - squared_height <= squared_near))
    return {};
  for (std::size_t i = 0; i < 2; ++i) { // a side that is near enough
    const Point q = between(seen[i], seen[2], std::clamp(fraction_between(seen[i], seen[2], {0, 0, 0}), 0., 1.));
    if (coordinates[1 - i] > 0 && scalar_product(q, q) - squared_height <= squared_near)
      coordinates[1 - i] = 0;
  }
  std::uint32_t end = d; // the other end of the side, if one is divided
  Change change;
  leave_out(change, s, {a, b, c});
  leave_out(change, t, {b, a, c});
  if (coordinates[0] > 0) // not on the side ad
    change_triangle(change, add_triangle(t), {a, d, c});
  if (coordinates[0] == 0 || coordinates[1] > 0)
    change_triangle(change, add_triangle(t), {d, b, c});
  if (coordinates[0] == 0 || coordinates[1] == 0) {
    end = coordinates[0] > 0 ? b : a;
    const std::vector<std::uint32_t> there = triangles_at(end, d);
    if (there.size() != 2)
      return {};
    divide_triangle(change, there[there[0] == t], end, d, c);
  }
  if (!can_be_left_out(change))
    return {};
  divide_mark(end, d, c);
  return finish(change, fold, c);
}

// Makes a side of s an edge of the sheet beyond, too, by flips there. If need be, c gets a copy in that sheet. (S. W. Sloan,
// "A fast algorithm for generating constrained Delaunay triangulations", 1993.) No vertices are added but copies, so that
// two sheets have as many triangles in common as both together have at first.
std::vector<std::uint32_t> Thin_part_merger::flip_to_side(const Fold& fold)
{
  const auto [a, b, c, d, s, t] = fold;
  const Point normal = normal_of(map_.corners({a, b, c}));
  constexpr std::size_t most_flips_for_each = 8; // pair of triangles that goes, so that the steps end
  if (c == d || number_of_flipped_sides_ > most_flips_for_each * (number_of_zips_ + most_around))
    return {};
  for (std::uint32_t from : {b, a}) {
    std::uint32_t left = from == b ? a : d, right = from == b ? d : b, before = t;
    if (!(side(normal, from, c, left) > 0 && side(normal, from, c, right) < 0 && side(normal, left, right, c) > 0))
      continue;
    ++number_of_flipped_sides_;
    std::deque<Line> crossed;
    std::vector<std::uint32_t> changed;
    std::optional<std::uint32_t> to;
    while (!to) {
      const std::vector<std::uint32_t> there = triangles_at(left, right);
      if (there.size() != 2 || crossed.size() == most_around || is_marked(left, right) ||
          (is_fixed(left) && is_fixed(right)))
        return {};
      crossed.push_back({left, right});
      before = there[there[0] == before];
      const std::uint32_t e = after(mesh_.triangles[before], left);
      if (after(mesh_.triangles[before], right) != left)
        return {};
      const Point &p = map_.points()[e], &q = map_.points()[from], &r = map_.points()[c];
      if (distance(p, between(q, r, std::clamp(fraction_between(q, r, p), 0., 1.))) <= near_)
        to = e;
      else if (side(normal, right, e, c) >= 0 && side(normal, e, left, c) >= 0) {
        to = add_copy(before, c);
        if (*to == c)
          return {};
        changed = at_vertex_[*to];
      } else
        (side(normal, from, c, e) > 0 ? left : right) = e;
    }
    if (flip_across(crossed, from, *to, normal, changed))
      return changed;
  }
  return {};
}

// Puts a copy of a vertex into a triangle, or on a side that is near.
// \return the copy, or the vertex itself if that is not possible
std::uint32_t Thin_part_merger::add_copy(std::uint32_t t, std::uint32_t v)
{
  const auto [a, b, c] = mesh_.triangles[t];
  const std::uint32_t copy = add_vertex(map_.points()[v]);
  const auto& points = map_.points();
  Change change;
  Line side{copy, copy};
  for (const auto& [p, q] : {Line{a, b}, Line{b, c}, Line{c, a}})
    if (distance(points[v], between(points[p], points[q], fraction_between(points[p], points[q], points[v]))) <= near_)
      side = {p, q};
  if (side[0] == copy) {
    change_triangle(change, t, {a, b, copy});
    change_triangle(change, add_triangle(t), {b, c, copy});
    change_triangle(change, add_triangle(t), {c, a, copy});
  } else {
    const std::vector<std::uint32_t> there = triangles_at(side[0], side[1]);
    if (there.size() != 2 || (is_fixed(side[0]) && is_fixed(side[1])))
      return v;
    for (std::uint32_t one : there)
      divide_triangle(change, one, side[0], side[1], copy);
  }
  if (!is_near_enough(change))
    return v;
  make(change);
  divide_mark(side[0], side[1], copy);
  return copy;
}

// Flips the edges that cross a line in a sheet.
// \param normal which is about that of the sheet, or opposite to it
// \param changed receives the triangles that have changed
bool Thin_part_merger::flip_across(std::deque<Line> crossed, std::uint32_t from, std::uint32_t to, const Point& normal,
                                   std::vector<std::uint32_t>& changed)
{
  const auto are_apart = [&, this](std::uint32_t v, std::uint32_t w, const Line& line) {
    const double x = side(normal, line[0], line[1], v), y = side(normal, line[0], line[1], w);
    return (x < 0 && y > 0) || (x > 0 && y < 0);
  };
  for (std::size_t rest = crossed.size() * (crossed.size() + 1); !crossed.empty() && rest > 0; --rest) {
    const auto [v, w] = crossed.front();
    const std::vector<std::uint32_t> there = triangles_at(v, w);
    if (there.size() != 2)
      return false;
    const bool is_second = after(mesh_.triangles[there[0]], v) != w;
    const std::uint32_t s = there[is_second], t = there[!is_second];
    const std::uint32_t x = after(mesh_.triangles[s], w), y = after(mesh_.triangles[t], v);
    crossed.pop_front();
    if (!are_apart(v, w, {x, y}) || !are_apart(x, y, {v, w})) { // not convex, unless others are flipped first
      crossed.push_back({v, w});
      continue;
    }
    Change change{{s, t}, {{v, y, x}, {y, w, x}}, {}};
    const bool is_last = (x == from && y == to) || (x == to && y == from); // may be a side of both sheets
    if ((number_of_triangles_at(x, y) > 0 && !is_last) || !is_near_enough(change))
      return false;
    make(change);
    changed.insert(changed.end(), {s, t});
    if (x != from && x != to && y != from && y != to && are_apart(x, y, {from, to}))
      crossed.push_back({x, y});
  }
  return crossed.empty();
}

// Positive where x lies left of vw, as seen against the normal.
double Thin_part_merger::side(const Point& normal, std::uint32_t v, std::uint32_t w, std::uint32_t x) const
{
  const auto& points = map_.points();
  return scalar_product(normal, cross_product(difference(points[w], points[v]), difference(points[x], points[v])));
}

// The sides bc and ad cross, or ca and db do. They get a common point there.
std::vector<std::uint32_t> Thin_part_merger::zip_to_crossing(const Fold& fold)
{
  const auto [a, b, c, d, s, t] = fold;
  if (c == d)
    return {};
  for (const auto& [near_c, near_d] : {std::array{b, a}, std::array{a, b}}) { // the other ends of these sides
    const auto& points = map_.points();
    const auto [x, y] = nearest_parameters(points[near_c], points[c], points[near_d], points[d]);
    if (!(x > 0 && x < 1 && y > 0 && y < 1))
      continue;
    const Point p = between(points[near_c], points[c], x), q = between(points[near_d], points[d], y);
    const std::vector<std::uint32_t> at_s = triangles_at(near_c, c), at_t = triangles_at(near_d, d);
    const auto is_near = [&](std::uint32_t v) { return distance(points[v], p) < near_; };
    if (distance(p, q) > maximum_deviation_ || is_near(a) || is_near(b) || is_near(c) || is_near(d) ||
        at_s.size() != 2 || at_t.size() != 2)
      continue;
    const std::uint32_t v = add_vertex(between(p, q, 0.5));
    Change change;
    leave_out(change, s, {a, b, v});
    leave_out(change, t, {b, a, v});
    change_triangle(change, add_triangle(s), near_c == b ? Triangle{a, v, c} : Triangle{v, b, c});
    change_triangle(change, add_triangle(t), near_d == a ? Triangle{b, v, d} : Triangle{v, a, d});
    divide_triangle(change, at_s[at_s[0] == s], near_c, c, v);
    divide_triangle(change, at_t[at_t[0] == t], near_d, d, v);
    if (!can_be_left_out(change))
      continue;
    divide_mark(near_c, c, v);
    divide_mark(near_d, d, v);
    return finish(change, fold, v);
  }
  return {};
}

// Whether the triangles stay near the surface, and their area falls by at least half of what is left out, so that the
// steps end.
bool Thin_part_merger::can_be_left_out(Change& change)
{
  double rest = 0, left_out = 0, before = 0;
  for (std::size_t i = 0; i < change.triangles.size(); ++i) {
    const Triangle &old = mesh_.triangles[change.triangles[i]], &now = change.corners[i];
    before += is_removed(old) ? 0 : area(old);
    (is_of_film_[now[0]] ? left_out : rest) += is_removed(now) ? 0 : area(now);
  }
  return rest <= before - left_out / 2 && is_near_enough(change);
}

// A triangle that is left out stays where it is, on vertices of its own, so that the proof of the distance knows it.
void Thin_part_merger::leave_out(Change& change, std::uint32_t t, Triangle corners)
{
  for (std::uint32_t& v : corners) {
    is_at_film_[v] = true;
    v = add_vertex(map_.points()[v]);
    is_of_film_[v] = true;
  }
  change.triangles.push_back(t);
  change.corners.push_back(corners);
}

void Thin_part_merger::change_triangle(Change& change, std::uint32_t t, const Triangle& corners)
{
  const bool vanishes = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  change.triangles.push_back(t);
  change.corners.push_back(vanishes ? Triangle{0, 0, 0} : corners);
}

// The side of a triangle between v and w gets the vertex x.
void Thin_part_merger::divide_triangle(Change& change, std::uint32_t t, std::uint32_t v, std::uint32_t w,
                                       std::uint32_t x)
{
  if (after(mesh_.triangles[t], v) != w)
    std::swap(v, w);
  const std::uint32_t opposite = after(mesh_.triangles[t], w);
  change_triangle(change, t, {v, x, opposite});
  change_triangle(change, add_triangle(t), {x, w, opposite});
}

void Thin_part_merger::divide_mark(std::uint32_t v, std::uint32_t w, std::uint32_t x)
{
  if (!is_marked(v, w))
    return;
  for (std::uint32_t end : {v, w}) {
    std::replace(marked_[end].begin(), marked_[end].end(), end == v ? w : v, x);
    marked_[x].push_back(end);
  }
}

// \pre is_near_enough(change)
std::vector<std::uint32_t> Thin_part_merger::finish(const Change& change, const Fold& fold, std::uint32_t apex)
{
  const auto& points = map_.points();
  if (area_of_films_ == 0)
    place_of_film_ = points[apex];
  for (std::size_t i = 0; i < change.triangles.size(); ++i)
    if (is_of_film_[change.corners[i][0]])
      area_of_films_ += area(change.corners[i]) / 2;
  number_of_zips_ += std::any_of(change.corners.begin(), change.corners.end(),
                                 [this](const Triangle& corners) { return is_of_film_[corners[0]]; });
  make(change);
  for (std::uint32_t v : {fold.a, fold.b}) {
    const std::uint32_t w = v == fold.a ? fold.b : fold.a;
    if (number_of_triangles_at(v, w) == 0)
      marked_[v].erase(std::remove(marked_[v].begin(), marked_[v].end(), w), marked_[v].end());
  }
  for (std::uint32_t v : {fold.a, fold.b, apex}) {
    separate_fans_around(v);
    look_at(v, change.triangles);
  }
  return change.triangles;
}

} // namespace CGAL::Intrinsic_triangulations::internal

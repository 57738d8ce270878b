// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: films, two sheets of triangles that lie on each other.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>

#include <algorithm>
#include <cmath>
#include <iterator>
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

double Thin_part_merger::area(const Triangle& t) const
{
  const Space_triangle corners = map_.corners(t);
  return four_areas_3(corners[0], corners[1], corners[2]) / 4;
}

// Components that enclose a volume, and are not films as a whole. Nothing would be left of the latter.
std::vector<bool> Thin_part_merger::find_solids() const
{
  struct Sum
  {
    double volume = 0, area = 0;
    bool is_closed = true;
    std::uint32_t origin = 0;
  };
  std::vector<Sum> sums(map_.points().size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (const Triangle& corners = mesh_.triangles[t]; !is_removed(corners)) {
      Sum& sum = sums[component_of(t)];
      if (sum.area == 0)
        sum.origin = corners[0];
      const Point& origin = map_.points()[sum.origin];
      const Point p = difference(map_.points()[corners[0]], origin);
      const Point q = difference(map_.points()[corners[1]], origin), r = difference(map_.points()[corners[2]], origin);
      sum.volume += scalar_product(p, cross_product(q, r)) / 6;
      sum.area += area(corners);
      for (std::size_t i = 0; i < 3; ++i)
        sum.is_closed = sum.is_closed && number_of_triangles_at(corners[i], corners[(i + 1) % 3]) > 1;
    }
  // The area and the volume of films do not count.
  const auto is_thick = [d = maximum_deviation_](const Sum& sum) {
    return 2 * sum.volume > d * sum.area && sum.volume > d * d * d;
  };
  std::vector<std::uint32_t> triangles;
  std::vector<Space_box> boxes;
  for (Sum& sum : sums)
    sum.volume = std::abs(sum.volume);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (const Sum& sum = sums[component_of(t)]; !is_removed(mesh_.triangles[t]) && sum.is_closed && !is_thick(sum)) {
      triangles.push_back(t);
      boxes.emplace_back(map_.corners(mesh_.triangles[t]));
    }
  const Box_tree tree(std::move(boxes));
  std::vector<std::pair<std::uint32_t, double>> films; // triangles of films, and how thick these are
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (const double thickness = thickness_at(triangles[i], triangles, tree); thickness < maximum_deviation_)
      films.emplace_back(triangles[i], thickness);
  for (const auto& [t, thickness] : films) {
    const double own = area(mesh_.triangles[t]);
    sums[component_of(t)].area -= own;
    sums[component_of(t)].volume -= own * thickness / 2;
  }
  std::vector<bool> result;
  for (const Sum& sum : sums)
    result.push_back(sum.is_closed && is_thick(sum));
  return result;
}

// How far the nearest triangle that is turned the other way is from the middle of a triangle, or the deviation if it is
// farther.
double Thin_part_merger::thickness_at(std::uint32_t t, const std::vector<std::uint32_t>& triangles,
                                      const Box_tree& tree) const
{
  const Space_triangle corners = map_.corners(mesh_.triangles[t]);
  const Point normal = normal_of(corners);
  Point middle{};
  for (const Point& p : corners)
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] += p[i] / 3;
  double result = maximum_deviation_;
  for (std::uint32_t i : tree.near(Space_box({middle, middle, middle}), maximum_deviation_)) {
    Space_triangle seen = map_.corners(mesh_.triangles[triangles[i]]);
    if (scalar_product(normal_of(seen), normal) >= 0 || component_of(triangles[i]) != component_of(t))
      continue;
    for (Point& p : seen)
      p = difference(p, middle);
    result = (std::min)(result, std::sqrt(nearest_to_origin(seen).second));
  }
  return result;
}

// Leaves out films, which enclose no volume, from the folds at their rims inward.
void Thin_part_merger::leave_films_out()
{
  if (is_solid_.empty())
    is_solid_ = find_solids();
  std::vector<std::array<std::uint32_t, 2>> edges;
  const auto add_edges_of = [&](std::uint32_t t) {
    const Triangle& corners = mesh_.triangles[t];
    if (!is_removed(corners) && !is_left_out(t) && is_solid_[component_of(t)])
      for (std::size_t i = 0; i < 3; ++i)
        edges.push_back({corners[i], corners[(i + 1) % 3]});
  };
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    add_edges_of(t);
  for (std::size_t rest = 16 * mesh_.triangles.size(); !edges.empty() && rest > 0; --rest) {
    const auto [v, w] = edges.back();
    edges.pop_back();
    if (rest % 256 == 0)
      report(0.8);
    for (std::uint32_t t : zip(v, w))
      add_edges_of(t);
  }
}

// Whether a triangle of a solid lies on the one beyond a side.
bool Thin_part_merger::is_folded(std::uint32_t t) const
{
  if (is_solid_.empty() || !is_solid_[component_of(t)])
    return false;
  const Triangle& corners = mesh_.triangles[t];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = corners[i], w = corners[(i + 1) % 3];
    const auto& points = map_.points();
    for (std::uint32_t other : triangles_at(v, w)) {
      const Triangle& beyond = mesh_.triangles[other];
      const std::uint32_t x = after(beyond, after(beyond, v) == w ? w : v);
      if (other != t && dihedral_angle(points[v], points[w], points[corners[(i + 2) % 3]], points[x]) <
                          Straight_mesh::smallest_dihedral_angle)
        return true;
    }
  }
  return false;
}

// Where two triangles at the edge ab lie on each other, divides them until they have a part in common that begins at
// ab, and leaves this part out.
// \return the triangles that have changed; empty if there was nothing to do
std::vector<std::uint32_t> Thin_part_merger::zip(std::uint32_t a, std::uint32_t b)
{
  constexpr double largest_fold = 1; // degrees
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
  for (Step step : {&Thin_part_merger::zip_to_side, &Thin_part_merger::zip_to_crossing})
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
    if (v < images_.size())
      vertices_of_films_.push_back(v);
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

// Vertices of which nothing but films is left are merged with one nearby.
void Thin_part_merger::find_images_of_films()
{
  std::vector<std::uint32_t> lonely, others;
  std::copy_if(vertices_of_films_.begin(), vertices_of_films_.end(), std::back_inserter(lonely),
               [this](std::uint32_t v) { return at_vertex_[v].empty() && images_[v] == v; });
  if (lonely.empty())
    return;
  std::vector<Space_box> boxes;
  for (std::uint32_t v = 0; v < at_vertex_.size(); ++v)
    if (!at_vertex_[v].empty() && !is_of_film_[v]) {
      const Point& p = map_.points()[v];
      others.push_back(v);
      boxes.emplace_back(Space_triangle{p, p, p});
    }
  if (others.empty())
    return;
  const Box_tree tree(std::move(boxes));
  for (std::uint32_t v : lonely) {
    const Point& p = map_.points()[v];
    std::vector<std::uint32_t> found;
    for (double distance = maximum_deviation_; found.empty(); distance *= 2)
      found = tree.near(Space_box({p, p, p}), distance);
    const auto is_nearer = [&](std::uint32_t i, std::uint32_t j) {
      return length(v, others[i]) < length(v, others[j]);
    };
    images_[v] = others[*std::min_element(found.begin(), found.end(), is_nearer)];
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

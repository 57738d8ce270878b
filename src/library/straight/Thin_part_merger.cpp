// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: the order of its steps, what a change must bring, contractions, flips and moves.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

// The part of the deviation that changes use if it suffices.
static constexpr double usual_part = 0.8;

static constexpr std::pair<int, double> no_gain{(std::numeric_limits<int>::min)(), 0};

static double distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

Thin_part_merger::Thin_part_merger(Straight_map& map, Straight_triangles& mesh, double thin_angle,
                                   double maximum_deviation, const Progress_function& progress)
  : map_(map), mesh_(mesh), progress_(progress), thin_angle_(thin_angle), maximum_deviation_(maximum_deviation),
    most_((2 * maximum_deviation - map.bound(maximum_deviation)) * (1 - 1e-9)), at_vertex_(map.points().size()),
    marked_(map.points().size()), images_(map.points().size()), is_waiting_(mesh.triangles.size()),
    is_stuck_(mesh.triangles.size())
{
  std::iota(images_.begin(), images_.end(), 0u);
  Disjoint_sets components(map.points().size());
  for (const Triangle& t : mesh_.triangles) {
    components.unite(t[0], t[1]);
    components.unite(t[1], t[2]);
  }
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    for (std::uint32_t v : mesh_.triangles[t])
      at_vertex_[v].push_back(t);
    stand_for_face_.resize((std::max)(stand_for_face_.size(), std::size_t(mesh_.faces[t].idx()) + 1));
    stand_for_face_[mesh_.faces[t].idx()].push_back(t);
    component_of_face_.resize(stand_for_face_.size());
    component_of_face_[mesh_.faces[t].idx()] = components.find(mesh_.triangles[t][0]);
  }
  for (const std::vector<std::uint32_t>& triangles : stand_for_face_)
    if (triangles.size() > 1) // of a divided face
      for (std::uint32_t t : triangles)
        stands_for_[t] = {mesh_.faces[t]};
  for (const auto& [v, w] : mesh_.marked_edges) {
    marked_[v].push_back(w);
    marked_[w].push_back(v);
  }
}

Straight_map::Distance Thin_part_merger::operator()()
{
  // The thinnest come last, and are looked at first.
  std::vector<std::pair<double, std::uint32_t>> bad;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (maximum_deviation_ > 0 && is_bad(t))
      bad.emplace_back(smallest_angle(map_.corners(mesh_.triangles[t])).first, t);
  std::sort(bad.rbegin(), bad.rend());
  for (const auto& [angle, t] : bad) {
    to_look_at_.push_back(t);
    is_waiting_[t] = true;
  }
  // Where nothing else improves, short sides are contracted nevertheless, which leaves coarser triangles.
  std::vector<std::uint32_t> stuck;
  double fraction = 0;
  for (double done = 1; !to_look_at_.empty() || !stuck.empty(); ++done) {
    fraction = (std::max)(fraction, 0.8 * done / (done + double(to_look_at_.size() + stuck.size())));
    report(fraction);
    const bool is_forced = to_look_at_.empty();
    lowest_with_normal_ = 0;
    needed_gain_ = {0, is_forced ? std::numeric_limits<double>::infinity() : 1.01};
    std::vector<std::uint32_t>& list = is_forced ? stuck : to_look_at_;
    const std::uint32_t t = list.back();
    list.pop_back();
    (is_forced ? is_stuck_ : is_waiting_)[t] = false;
    if (is_bad(t) && !(is_forced ? force(t) : improve(t)) && !is_forced && !is_stuck_[t]) {
      stuck.push_back(t);
      is_stuck_[t] = true;
    }
  }
  if (maximum_deviation_ > 0)
    remove_pieces();
  const Straight_map::Distance result = largest_distance();
  for (std::uint32_t& image : images_)
    while (image < images_.size() && images_[image] != image)
      image = images_[image];
  mesh_.marked_edges.clear();
  for (std::uint32_t v = 0; v < marked_.size(); ++v)
    for (std::uint32_t w : marked_[v])
      if (v < w && number_of_triangles_at(v, w) > 0)
        mesh_.marked_edges.push_back({v, w});
  std::sort(mesh_.marked_edges.begin(), mesh_.marked_edges.end());
  mesh_.marked_edges.erase(std::unique(mesh_.marked_edges.begin(), mesh_.marked_edges.end()), mesh_.marked_edges.end());
  return result;
}

bool Thin_part_merger::is_thin(std::uint32_t t, double angle) const
{
  constexpr double smallest_corner = 0.1;
  return angle < thin_angle_ && !(mesh_.is_kept[t] && angle > smallest_corner);
}

// Whether a triangle is thin, or has a side with too many other triangles.
bool Thin_part_merger::is_bad(std::uint32_t t) const
{
  const Triangle& corners = mesh_.triangles[t];
  return !is_removed(corners) &&
         (is_thin(t, smallest_angle(map_.corners(corners)).first) ||
          number_of_triangles_at(corners[0], corners[1]) > 2 || number_of_triangles_at(corners[1], corners[2]) > 2 ||
          number_of_triangles_at(corners[2], corners[0]) > 2);
}

std::vector<std::uint32_t> Thin_part_merger::triangles_at(std::uint32_t v, std::uint32_t w) const
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t : at_vertex_[v])
    if (std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), w) != 0)
      result.push_back(t);
  return result;
}

std::vector<std::uint32_t> Thin_part_merger::neighbors(std::uint32_t v) const
{
  std::vector<std::uint32_t> result;
  for (std::uint32_t t : at_vertex_[v])
    for (std::uint32_t w : mesh_.triangles[t])
      if (w != v)
        result.push_back(w);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool Thin_part_merger::is_on_border(std::uint32_t v) const
{
  const std::vector<std::uint32_t> around = neighbors(v);
  return std::any_of(around.begin(), around.end(), [&](std::uint32_t w) { return number_of_triangles_at(v, w) == 1; });
}

bool Thin_part_merger::is_marked(std::uint32_t v, std::uint32_t w) const
{
  return std::count(marked_[v].begin(), marked_[v].end(), w) != 0;
}

double Thin_part_merger::length(std::uint32_t v, std::uint32_t w) const
{
  return distance(map_.points()[v], map_.points()[w]);
}

void Thin_part_merger::look_at(std::uint32_t v)
{
  for (std::uint32_t t : at_vertex_[v])
    if (!is_waiting_[t]) {
      to_look_at_.push_back(t);
      is_waiting_[t] = true;
    }
}

void Thin_part_merger::replace(std::uint32_t t, const Triangle& corners)
{
  Triangle& old = mesh_.triangles[t];
  if (!is_removed(old))
    for (std::uint32_t v : old)
      at_vertex_[v].erase(std::find(at_vertex_[v].begin(), at_vertex_[v].end(), t));
  old = corners;
  if (!is_removed(old))
    for (std::uint32_t v : old)
      at_vertex_[v].push_back(t);
}

// Adds a triangle that gets its corners later, and stands for nothing.
// \param beside another triangle of the same face
std::uint32_t Thin_part_merger::add_triangle(std::uint32_t beside)
{
  const auto t = std::uint32_t(mesh_.triangles.size());
  mesh_.triangles.push_back({0, 0, 0});
  mesh_.faces.push_back(mesh_.faces[beside]);
  mesh_.is_kept.push_back(false);
  is_waiting_.push_back(false);
  is_stuck_.push_back(false);
  stands_for_[t];
  return t;
}

std::uint32_t Thin_part_merger::add_vertex(const Point& p)
{
  at_vertex_.emplace_back();
  marked_.emplace_back();
  return map_.add_vertex(p);
}

// ------------------------------------------------------------------ distances

std::vector<Face_index> Thin_part_merger::faces_of(const std::vector<std::uint32_t>& triangles) const
{
  std::vector<Face_index> result;
  for (std::uint32_t t : triangles)
    if (const auto faces = stands_for_.find(t); faces != stands_for_.end())
      result.insert(result.end(), faces->second.begin(), faces->second.end());
    else
      result.push_back(mesh_.faces[t]);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Thin_part_merger::Surface_part Thin_part_merger::surface_in(const std::vector<Face_index>& faces)
{
  Surface_part result;
  for (Face_index f : faces) {
    const std::vector<Space_triangle> one = map_.surface_in(f);
    result.triangles.insert(result.triangles.end(), one.begin(), one.end());
    result.faces.resize(result.triangles.size(), f);
  }
  return result;
}

std::vector<Space_triangle> Thin_part_merger::in_space(const std::vector<Triangle>& triangles) const
{
  std::vector<Space_triangle> result;
  for (const Triangle& t : triangles)
    if (!is_removed(t))
      result.push_back(map_.corners(t));
  return result;
}

// The largest distance, or not much more.
Straight_map::Distance Thin_part_merger::largest_distance()
{
  Straight_map::Distance result;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (!is_removed(mesh_.triangles[t]) && stands_for_.count(t) == 0)
      if (const Straight_map::Distance own = map_.distance_on(mesh_.faces[t]); own.value > result.value)
        result = own;
  std::vector<std::uint32_t> changed;
  for (const auto& [t, faces] : stands_for_)
    changed.push_back(t);
  const auto are_all_near = [&](double distance) {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (Face_index f : faces_of(changed)) {
      report(0.9);
      std::vector<Triangle> corners;
      for (std::uint32_t t : stand_for_face_[f.idx()])
        corners.push_back(mesh_.triangles[t]);
      if (!are_near(map_.surface_in(f), in_space(corners), distance, pairs))
        return false;
    }
    return std::all_of(changed.begin(), changed.end(), [&](std::uint32_t t) {
      report(0.9);
      return are_near(in_space({mesh_.triangles[t]}), surface_in(stands_for_[t]).triangles, distance, pairs);
    });
  };
  if (changed.empty())
    return result;
  // Increases the distance where the bound cannot be kept.
  double distance = (std::max)(result.value, most_ > 0 ? usual_part * most_ : map_.largest_coordinate() * 0x1p-20);
  for (const double step = (most_ - distance) / 4; !are_all_near(distance);)
    distance = distance < most_ ? (std::min)(distance + step, most_) : distance * 1.25;
  if (distance > result.value)
    result = {distance, map_.points()[mesh_.triangles[changed[0]][0]]};
  return result;
}

static std::array<double, 3> normal_of(const Space_triangle& p)
{
  std::array<double, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) - (p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
  }
  return result;
}

// How many fewer thin triangles there are, and by what factor the smallest angle grows; the least gain of all if a
// triangle turns over. The normals of thin and of low triangles mean nothing.
// \param before where the triangles were
Thin_part_merger::Gain Thin_part_merger::gain(const Change& change, const std::vector<Space_triangle>& before) const
{
  const auto has_normal = [this](const Space_triangle& p, double angle, const Point& normal) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(longest, distance(p[i], p[(i + 1) % 3]));
    return angle >= thin_angle_ && std::hypot(normal[0], normal[1], normal[2]) >= lowest_with_normal_ * longest;
  };
  double old_angle = 180, new_angle = 180;
  int number_of_thin = 0; // how many fewer there are
  std::vector<bool> had_normal;
  std::vector<Point> normals;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double angle = smallest_angle(before[i]).first;
    number_of_thin += is_thin(change.triangles[i], angle);
    if (!mesh_.is_kept[change.triangles[i]])
      old_angle = (std::min)(old_angle, angle);
    const Point normal = normal_of(before[i]);
    had_normal.push_back(has_normal(before[i], angle, normal));
    if (had_normal.back())
      normals.push_back(normal);
  }
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (is_removed(change.corners[i]))
      continue;
    const Space_triangle now = map_.corners(change.corners[i]);
    const double angle = smallest_angle(now).first;
    const Point n = normal_of(now);
    const auto is_turned = [&](const Point& m) { return m[0] * n[0] + m[1] * n[1] + m[2] * n[2] < 0; };
    if (has_normal(now, angle, n) &&
        (had_normal[i] ? is_turned(normal_of(before[i]))
                       : !normals.empty() && std::all_of(normals.begin(), normals.end(), is_turned)))
      return no_gain;
    number_of_thin -= is_thin(change.triangles[i], angle);
    if (!mesh_.is_kept[change.triangles[i]])
      new_angle = (std::min)(new_angle, angle);
  }
  const double growth = old_angle > 0 ? new_angle / old_angle : std::numeric_limits<double>::infinity();
  return {number_of_thin, new_angle > 0 ? growth : 0};
}

// Whether fewer angles are small, or the smallest one grows.
bool Thin_part_merger::improves(const Change& change, const std::vector<Space_triangle>& before) const
{
  return needed_gain_ < gain(change, before);
}

bool Thin_part_merger::is_within(Change& change, double distance)
{
  change.stands_for.clear();
  const std::vector<Face_index> faces = faces_of(change.triangles);
  const Surface_part surface = surface_in(faces);
  std::vector<std::uint32_t> triangles;
  for (std::size_t i = 0; i < change.triangles.size(); ++i)
    if (!is_removed(change.corners[i]))
      triangles.push_back(change.triangles[i]);
  std::vector<Space_triangle> now = in_space(change.corners);
  std::vector<std::array<std::uint32_t, 2>> pairs;
  if (!are_near(now, surface.triangles, distance, pairs))
    return false;
  for (const auto& [t, f] : pairs)
    change.stands_for.emplace_back(triangles[t], surface.faces[f]);
  std::vector<std::uint32_t> changed = change.triangles, others = change.beside;
  std::sort(changed.begin(), changed.end());
  for (Face_index f : faces)
    for (std::uint32_t t : stand_for_face_[f.idx()])
      if (!std::binary_search(changed.begin(), changed.end(), t))
        others.push_back(t);
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  triangles.insert(triangles.end(), others.begin(), others.end());
  for (std::uint32_t t : others)
    now.push_back(map_.corners(mesh_.triangles[t]));
  pairs.clear();
  if (!are_near(surface.triangles, now, distance, pairs))
    return false;
  for (const auto& [f, t] : pairs)
    change.stands_for.emplace_back(triangles[t], surface.faces[f]);
  std::sort(change.stands_for.begin(), change.stands_for.end());
  change.stands_for.erase(std::unique(change.stands_for.begin(), change.stands_for.end()), change.stands_for.end());
  return true;
}

// \pre is_near_enough(change)
void Thin_part_merger::make(const Change& change)
{
  std::vector<std::uint32_t> changed = change.triangles;
  std::sort(changed.begin(), changed.end());
  for (Face_index f : faces_of(changed)) {
    std::vector<std::uint32_t>& all = stand_for_face_[f.idx()];
    const auto is_changed = [&](std::uint32_t t) { return std::binary_search(changed.begin(), changed.end(), t); };
    all.erase(std::remove_if(all.begin(), all.end(), is_changed), all.end());
  }
  for (std::size_t i = 0; i < change.triangles.size(); ++i) {
    replace(change.triangles[i], change.corners[i]);
    if (is_removed(change.corners[i]))
      stands_for_.erase(change.triangles[i]);
    else
      stands_for_[change.triangles[i]].clear();
  }
  for (const auto& [t, f] : change.stands_for)
    add_face(t, f);
}

void Thin_part_merger::add_face(std::uint32_t t, Face_index f)
{
  std::vector<Face_index>& own = stands_for_.try_emplace(t, std::vector<Face_index>{mesh_.faces[t]}).first->second;
  if (std::find(own.begin(), own.end(), f) != own.end())
    return;
  own.push_back(f);
  stand_for_face_[f.idx()].push_back(t);
}

// Where the triangles of a change are.
std::vector<Space_triangle> Thin_part_merger::places(const Change& change) const
{
  std::vector<Space_triangle> result;
  for (std::uint32_t t : change.triangles)
    result.push_back(map_.corners(mesh_.triangles[t]));
  return result;
}

bool Thin_part_merger::try_to_make(Change& change)
{
  if (!improves(change, places(change)) || !is_near_enough(change))
    return false;
  make(change);
  return true;
}

// Prefers triangles that are no farther away than needed.
bool Thin_part_merger::is_near_enough(Change& change)
{
  return is_within(change, usual_part * most_) || is_within(change, most_);
}

// ---------------------------------------------------------------------- steps

bool Thin_part_merger::improve(std::uint32_t t)
{
  std::array<std::tuple<double, std::uint32_t, std::uint32_t>, 3> sides;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh_.triangles[t][i], w = mesh_.triangles[t][(i + 1) % 3];
    sides[i] = {length(v, w), v, w};
  }
  std::sort(sides.begin(), sides.end());
  for (const auto& [length, v, w] : sides)
    if (number_of_triangles_at(v, w) > 2)
      return separate(v, w) || separate(w, v);
  for (const auto& [length, v, w] : sides)
    if (contract(v, w) || contract(w, v))
      return true;
  for (const auto& [length, v, w] : sides)
    if (length <= maximum_deviation_ && cut_tube(v, w))
      return true;
  for (std::size_t i = 3; i-- > 0;) // the longest first
    if (flip(t, std::get<1>(sides[i]), std::get<2>(sides[i])))
      return true;
  const Triangle corners = mesh_.triangles[t];
  return std::any_of(corners.begin(), corners.end(), [this](std::uint32_t v) { return move_to_mean(v); });
}

// First tries every step that leaves fewer thin triangles, then the contraction of a short side that leaves the fewest;
// if need be, one that turns over triangles that are lower than the deviation.
bool Thin_part_merger::force(std::uint32_t t)
{
  const Triangle corners = mesh_.triangles[t];
  for (std::uint32_t v : corners)
    for (std::uint32_t w : neighbors(v))
      if (contract(v, w) || contract(w, v))
        return true;
  for (std::uint32_t v : corners)
    if (move_along_edges(v))
      return true;
  needed_gain_ = no_gain;
  for (double low : {0., maximum_deviation_}) {
    lowest_with_normal_ = low;
    std::vector<std::tuple<Gain, std::uint32_t, std::uint32_t>> contractions;
    for (std::uint32_t v : corners)
      for (std::uint32_t w : corners)
        if (v != w && length(v, w) <= maximum_deviation_ && is_contractible(v, w)) {
          const Change change = contraction(v, w);
          contractions.emplace_back(gain(change, places(change)), v, w);
        }
    std::sort(contractions.rbegin(), contractions.rend());
    for (const auto& [gain, v, w] : contractions)
      if (contract(v, w))
        return true;
  }
  return false;
}

// Whether the triangles stay a manifold of the same kind: the links of both vertices have nothing in common but the link
// of the edge. (T. Dey, H. Edelsbrunner, S. Guha, D. Nekhayev, "Topology preserving edge contraction", 1999.)
bool Thin_part_merger::is_contractible(std::uint32_t from, std::uint32_t to)
{
  // Marked edges stay where they are, except for parts that are shorter than the deviation.
  if (length(from, to) > maximum_deviation_ && !marked_[from].empty() &&
      !(marked_[from].size() == 2 && is_marked(from, to)))
    return false;
  const std::vector<std::uint32_t> a = neighbors(from), b = neighbors(to);
  std::vector<std::uint32_t> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  const std::size_t number = number_of_triangles_at(from, to);
  if (is_fixed(from) || both.size() != number || number > 2)
    return false;
  for (std::uint32_t v : {from, to}) // an edge of three triangles is not part of a surface, but may become so
    for (std::uint32_t w : v == from ? a : b)
      if (number_of_triangles_at(v, w) > 2)
        return false;
  const auto has_in_link = [&](std::uint32_t v) {
    return std::any_of(at_vertex_[v].begin(), at_vertex_[v].end(), [&](std::uint32_t t) {
      return std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), both[0]) != 0 &&
             std::count(mesh_.triangles[t].begin(), mesh_.triangles[t].end(), both[1]) != 0;
    });
  };
  if (number == 2 && has_in_link(from) && has_in_link(to)) // the edge between them
    return false;
  return number == 1 || !(is_on_border(from) && is_on_border(to));
}

Thin_part_merger::Change Thin_part_merger::contraction(std::uint32_t from, std::uint32_t to) const
{
  Change change;
  change.triangles = at_vertex_[from];
  for (std::uint32_t t : change.triangles) {
    Triangle corners = mesh_.triangles[t];
    std::replace(corners.begin(), corners.end(), from, to);
    const bool vanishes = std::count(corners.begin(), corners.end(), to) == 2;
    change.corners.push_back(vanishes ? Triangle{to, to, to} : corners);
  }
  for (std::uint32_t t : at_vertex_[to])
    if (std::count(change.triangles.begin(), change.triangles.end(), t) == 0)
      change.beside.push_back(t);
  return change;
}

bool Thin_part_merger::contract(std::uint32_t from, std::uint32_t to)
{
  if (!is_contractible(from, to))
    return false;
  Change change = contraction(from, to);
  if (!try_to_make(change))
    return false;
  if (from < images_.size())
    images_[from] = to;
  for (std::uint32_t w : std::exchange(marked_[from], {})) {
    std::replace(marked_[w].begin(), marked_[w].end(), from, to);
    if (w != to)
      marked_[to].push_back(w);
  }
  marked_[to].erase(std::remove(marked_[to].begin(), marked_[to].end(), to), marked_[to].end());
  look_at(to);
  return true;
}

std::uint32_t Thin_part_merger::after(const Triangle& corners, std::uint32_t v)
{
  return corners[std::size_t(std::find(corners.begin(), corners.end(), v) - corners.begin() + 1) % 3];
}

// Replaces the side ab of a triangle by the line from its third corner c to that of the triangle beyond. A marked side is
// bent to c, and so is one of the border, where the triangle vanishes.
bool Thin_part_merger::flip(std::uint32_t t, std::uint32_t a, std::uint32_t b)
{
  if (after(mesh_.triangles[t], a) != b)
    std::swap(a, b);
  const std::uint32_t c = after(mesh_.triangles[t], b);
  const std::vector<std::uint32_t> there = triangles_at(a, b);
  const bool is_bent = is_marked(a, b);
  if (there.size() > 2 || number_of_triangles_at(b, c) > 2 || number_of_triangles_at(c, a) > 2 ||
      (is_fixed(a) && is_fixed(b)))
    return false;
  if (is_bent || there.size() == 1) { // the height of c
    Space_triangle seen = map_.corners({a, b, b});
    for (Point& p : seen)
      for (std::size_t i = 0; i < 3; ++i)
        p[i] -= map_.points()[c][i];
    if (nearest_to_origin(seen).second > maximum_deviation_ * maximum_deviation_)
      return false;
  }
  Change change;
  if (there.size() == 1) {
    if (number_of_triangles_at(b, c) != 2 || number_of_triangles_at(c, a) != 2 || is_on_border(c))
      return false;
    change = {{t}, {{a, a, a}}, {}};
    for (std::uint32_t v : {a, b})
      for (std::uint32_t n : triangles_at(v, c))
        if (n != t)
          change.beside.push_back(n);
  } else {
    const std::uint32_t n = there[there[0] == t];
    const std::uint32_t d = after(mesh_.triangles[n], a);
    if (after(mesh_.triangles[n], b) != a || d == c || number_of_triangles_at(c, d) != 0 ||
        (mesh_.is_kept[n] && smallest_angle(map_.corners(mesh_.triangles[n])).first < thin_angle_))
      return false;
    change = {{t, n}, {{a, d, c}, {d, b, c}}, {}};
  }
  if (!try_to_make(change))
    return false;
  number_of_bent_border_edges_ += there.size() == 1;
  for (std::uint32_t n : change.triangles)
    mesh_.is_kept[n] = false;
  if (is_bent && there.size() == 2)
    mesh_.faces[t] = mesh_.faces[there[there[0] == t]];
  if (is_bent)
    for (std::uint32_t v : {a, b}) {
      marked_[v].push_back(c);
      marked_[c].push_back(v);
      marked_[v].erase(std::remove(marked_[v].begin(), marked_[v].end(), v == a ? b : a), marked_[v].end());
    }
  for (std::uint32_t v : {a, b, c})
    look_at(v);
  return true;
}

// Moves a vertex toward the mean of its neighbors.
bool Thin_part_merger::move_to_mean(std::uint32_t v)
{
  if (!marked_[v].empty() || is_on_border(v))
    return false;
  Point mean{};
  const std::vector<std::uint32_t> around = neighbors(v);
  for (std::uint32_t w : around)
    for (std::size_t i = 0; i < 3; ++i)
      mean[i] += map_.points()[w][i] / double(around.size());
  return move(v, {mean}, {1, 0.5, 0.25});
}

// Moves a vertex toward a neighbor or away from it; a vertex of a line moves along the line.
bool Thin_part_merger::move_along_edges(std::uint32_t v)
{
  const bool is_on_line = marked_[v].size() == 2;
  if (!is_on_line && (!marked_[v].empty() || is_on_border(v)))
    return false;
  std::vector<Point> toward;
  for (std::uint32_t w : is_on_line ? marked_[v] : neighbors(v))
    toward.push_back(map_.points()[w]);
  return move(v, toward, is_on_line ? std::vector<double>{0.5, 0.25, 0.1} : std::vector{0.5, 0.25, 0.1, -0.1, -0.25});
}

// Moves a vertex by one of these parts toward one of these points.
bool Thin_part_merger::move(std::uint32_t v, const std::vector<Point>& toward, const std::vector<double>& parts)
{
  if (is_fixed(v))
    return false;
  const Point old = map_.points()[v];
  Change change{at_vertex_[v], {}, {}};
  for (std::uint32_t t : change.triangles)
    change.corners.push_back(mesh_.triangles[t]);
  const std::vector<Space_triangle> before = places(change);
  for (double part : parts)
    for (const Point& end : toward) {
      Point p = old;
      for (std::size_t i = 0; i < 3; ++i)
        p[i] += part * (end[i] - old[i]);
      map_.move_vertex(v, p);
      if (improves(change, before) && is_near_enough(change)) {
        make(change);
        look_at(v);
        return true;
      }
    }
  map_.move_vertex(v, old);
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal

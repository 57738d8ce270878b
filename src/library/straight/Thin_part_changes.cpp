// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: what a change of triangles brings, and whether it stays near the surface.

#include "Thin_part_merger.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace CGAL::Intrinsic_triangulations::internal {

// The part of the deviation that changes use if it suffices.
static constexpr double usual_part = 0.8;

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

// How many fewer thin triangles there are, and by what factor the smallest angle grows; the least gain of all if a
// triangle turns over. The normals of thin and of low triangles mean nothing.
// \param before where the triangles were
Thin_part_merger::Gain Thin_part_merger::gain(const Change& change, const std::vector<Space_triangle>& before) const
{
  const auto has_normal = [this](const Space_triangle& p, double angle, const Point& normal) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = (std::max)(
        longest, std::hypot(p[i][0] - p[(i + 1) % 3][0], p[i][1] - p[(i + 1) % 3][1], p[i][2] - p[(i + 1) % 3][2]));
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
  return (is_within(change, usual_part * most_) || is_within(change, most_)) && !makes_crossings(change);
}

// Whether a triangle then crosses another one where that is forbidden.
bool Thin_part_merger::makes_crossings(const Change& change)
{
  const auto is_forbidden = [&](const auto& pair) { return mesh_.must_not_cross[pair.second.idx()]; };
  if (!face_tree_ || std::none_of(change.stands_for.begin(), change.stands_for.end(), is_forbidden))
    return false;
  std::map<std::uint32_t, Triangle> changed;
  for (std::size_t i = 0; i < change.triangles.size(); ++i)
    changed[change.triangles[i]] = change.corners[i];
  for (const auto& [s, corners] : changed) {
    if (is_removed(corners) || is_of_film_[corners[0]])
      continue;
    std::map<std::uint32_t, Triangle> others = changed;
    for (std::uint32_t f : face_tree_->near(Space_box(map_.corners(corners)), most_))
      for (std::uint32_t t : stand_for_face_[f])
        others.try_emplace(t, mesh_.triangles[t]); // unless it has changed
    for (const auto& [t, there] : others)
      if (t != s && !is_removed(there) && !is_of_film_[there[0]] && do_cross(map_.points(), corners, there))
        return true;
  }
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal

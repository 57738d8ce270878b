// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: the order of its steps, and which triangles meet.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

Thin_part_merger::Thin_part_merger(Straight_map& map, Straight_triangles& mesh, double thin_angle,
                                   double maximum_deviation, const Progress_function& progress)
  : map_(map), mesh_(mesh), progress_(progress), thin_angle_(thin_angle), maximum_deviation_(maximum_deviation),
    most_((2 * maximum_deviation - map.bound(maximum_deviation)) * (1 - 1e-9)), at_vertex_(map.points().size()),
    marked_(map.points().size()), images_(map.points().size()), is_of_film_(map.points().size()),
    is_merged_(map.points().size()), is_at_film_(map.points().size()), is_waiting_(mesh.triangles.size()),
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
  if (!mesh_.must_not_cross.empty()) {
    std::vector<Space_box> boxes;
    for (std::uint32_t f = 0; f < mesh_.must_not_cross.size(); ++f) {
      const std::vector<Space_triangle> parts = map_.surface_in(Face_index(f));
      boxes.emplace_back(parts[0]);
      for (const Space_triangle& part : parts)
        boxes.back().add(Space_box(part));
    }
    face_tree_.emplace(std::move(boxes));
  }
  for (const auto& [v, w] : mesh_.marked_edges) {
    marked_[v].push_back(w);
    marked_[w].push_back(v);
  }
}

Straight_map::Distance Thin_part_merger::operator()()
{
  if (maximum_deviation_ > 0)
    leave_cavities_out();
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
  improve_all();
  constexpr int most_rounds = 4;
  for (int round = 0; round < most_rounds && maximum_deviation_ > 0; ++round) {
    leave_films_out();
    if (to_look_at_.empty())
      break;
    improve_all();
  }
  if (maximum_deviation_ > 0) {
    leave_crumbs_out();
    remove_pieces();
  }
  find_images_of_films();
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

// Improves the triangles that are to be looked at, and then others, until nothing helps.
void Thin_part_merger::improve_all()
{
  // Where nothing else improves, short sides are contracted nevertheless, which leaves coarser triangles.
  std::vector<std::uint32_t> stuck;
  double fraction = 0;
  for (double done = 1; !to_look_at_.empty() || !stuck.empty(); ++done) {
    fraction = (std::max)(fraction, 0.8 * done / (done + double(to_look_at_.size() + stuck.size())));
    report(fraction);
    const bool is_forced = to_look_at_.empty();
    lowest_with_normal_ = 0;
    needed_gain_ = {0, is_forced ? std::numeric_limits<double>::infinity() : 1.1};
    std::vector<std::uint32_t>& list = is_forced ? stuck : to_look_at_;
    const std::uint32_t t = list.back();
    list.pop_back();
    (is_forced ? is_stuck_ : is_waiting_)[t] = false;
    if (is_bad(t) && !(is_forced ? force(t) : improve(t)) && !is_forced && !is_stuck_[t]) {
      stuck.push_back(t);
      is_stuck_[t] = true;
    }
  }
}

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
    if (!is_hub(v))
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

bool Thin_part_merger::is_thin(std::uint32_t t, double angle) const
{
  constexpr double smallest_corner = 0.1;
  return angle < thin_angle_ && !(mesh_.is_kept[t] && angle > smallest_corner);
}

// Whether a triangle is thin, or has a side with too many other triangles.
bool Thin_part_merger::is_bad(std::uint32_t t) const
{
  const Triangle& corners = mesh_.triangles[t];
  return !is_removed(corners) && !is_left_out(t) &&
         (is_thin(t, smallest_angle(map_.corners(corners)).first) ||
          number_of_triangles_at(corners[0], corners[1]) > 2 || number_of_triangles_at(corners[1], corners[2]) > 2 ||
          number_of_triangles_at(corners[2], corners[0]) > 2 ||
          (!is_solid_.empty() && is_solid_[component_of(t)] && is_folded(t)));
}

std::vector<std::uint32_t> Thin_part_merger::triangles_at(std::uint32_t v, std::uint32_t w) const
{
  if (at_vertex_[w].size() < at_vertex_[v].size())
    std::swap(v, w);
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
  const Point &p = map_.points()[v], &q = map_.points()[w];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Around a hub, those that have changed are enough.
void Thin_part_merger::look_at(std::uint32_t v, const std::vector<std::uint32_t>& changed)
{
  for (std::uint32_t t : is_hub(v) ? changed : at_vertex_[v])
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
  is_of_film_.push_back(false);
  is_at_film_.push_back(false);
  is_merged_.push_back(false);
  return map_.add_vertex(p);
}

} // namespace CGAL::Intrinsic_triangulations::internal

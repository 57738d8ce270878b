// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Thin_part_merger: films, two sheets of triangles that lie on each other.

#include "Thin_part_merger.h"

#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

double Thin_part_merger::area(const Triangle& t) const { return area_of(map_.corners(t)); }

void Thin_part_merger::add(Bulk& bulk, std::uint32_t t) const
{
  const Triangle& corners = mesh_.triangles[t];
  if (bulk.area == 0)
    bulk.origin = corners[0];
  const Point& origin = map_.points()[bulk.origin];
  const Point p = difference(map_.points()[corners[0]], origin);
  const Point q = difference(map_.points()[corners[1]], origin), r = difference(map_.points()[corners[2]], origin);
  bulk.volume += scalar_product(p, cross_product(q, r)) / 6;
  bulk.area += area(corners);
  for (std::size_t i = 0; i < 3; ++i)
    bulk.is_closed = bulk.is_closed && number_of_triangles_at(corners[i], corners[(i + 1) % 3]) > 1;
}

// Whether it is thicker than a film on average.
// \pre its volume is not negative, unless films were subtracted
bool Thin_part_merger::is_thick(const Bulk& bulk) const
{
  return 2 * bulk.volume > maximum_deviation_ * bulk.area && bulk.volume > smallest_volume();
}

// Components that enclose a volume, and are not films as a whole. Nothing would be left of the latter.
std::vector<bool> Thin_part_merger::find_solids() const
{
  std::vector<Bulk> bulks(map_.points().size());
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (!is_removed(mesh_.triangles[t]))
      add(bulks[component_of(t)], t);
  std::vector<std::uint32_t> triangles;
  std::vector<Space_box> boxes;
  for (Bulk& bulk : bulks)
    bulk.volume = std::abs(bulk.volume);
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t)
    if (const Bulk& bulk = bulks[component_of(t)];
        !is_removed(mesh_.triangles[t]) && bulk.is_closed && !is_thick(bulk) && bulk.volume > smallest_volume()) {
      triangles.push_back(t);
      boxes.emplace_back(map_.corners(mesh_.triangles[t]));
    }
  const Box_tree tree(std::move(boxes));
  std::vector<std::pair<std::uint32_t, double>> films; // triangles of films, and how thick these are
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    if (const double thickness = thickness_at(triangles[i], triangles, tree); thickness < maximum_deviation_)
      films.emplace_back(triangles[i], thickness);
  for (const auto& [t, thickness] : films) { // their area and volume do not count
    const double own = area(mesh_.triangles[t]);
    bulks[component_of(t)].area -= own;
    bulks[component_of(t)].volume -= own * thickness / 2;
  }
  std::vector<bool> result;
  for (const Bulk& bulk : bulks)
    result.push_back(bulk.is_closed && is_thick(bulk));
  return result;
}

// How far the nearest triangle that is turned the other way is from the middle of a triangle, or the deviation if it is
// farther.
double Thin_part_merger::thickness_at(std::uint32_t t, const std::vector<std::uint32_t>& triangles,
                                      const Box_tree& tree) const
{
  const Space_triangle corners = map_.corners(mesh_.triangles[t]);
  const Point normal = unit_normal_of(corners);
  Point middle{};
  for (const Point& p : corners)
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] += p[i] / 3;
  for (double d = maximum_deviation_ / 256;; d *= 4) {
    double result = (std::min)(d, maximum_deviation_);
    for (std::uint32_t i : tree.near(Space_box({middle, middle, middle}), result)) {
      Space_triangle seen = map_.corners(mesh_.triangles[triangles[i]]);
      constexpr double largest_cosine = -0.5; // as on both sides of a film
      if (component_of(triangles[i]) != component_of(t) ||
          !(scalar_product(unit_normal_of(seen), normal) < largest_cosine))
        continue;
      for (Point& p : seen)
        p = difference(p, middle);
      result = (std::min)(result, std::sqrt(nearest_to_origin(seen).second));
    }
    if (result < d || d >= maximum_deviation_)
      return result;
  }
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

// Leaves out cavities that are no more than films: components in the box of a solid, turned the other way.
void Thin_part_merger::leave_cavities_out()
{
  struct Component
  {
    Bulk bulk;
    Space_box box;
    std::vector<std::uint32_t> triangles;
    bool is_fixed = false;
  };
  std::map<std::uint32_t, Component> components;
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    const Space_box box(map_.corners(mesh_.triangles[t]));
    Component& component = components.try_emplace(component_of(t), Component{{}, box, {}}).first->second;
    add(component.bulk, t);
    component.box.add(box);
    component.triangles.push_back(t);
    for (std::uint32_t v : mesh_.triangles[t])
      component.is_fixed = component.is_fixed || is_fixed(v);
  }
  const auto size_of = [](Bulk bulk) {
    bulk.volume = std::abs(bulk.volume);
    return bulk;
  };
  std::vector<const Component*> solids;
  for (const auto& [root, component] : components)
    if (is_thick(size_of(component.bulk)))
      solids.push_back(&component);
  for (const auto& [root, inner] : components) {
    const auto is_around = [inside = &inner](const Component* outer) {
      bool result = outer->bulk.volume * inside->bulk.volume < 0;
      for (std::size_t i = 0; i < 3; ++i)
        result = result && outer->box.low[i] < inside->box.low[i] && inside->box.high[i] < outer->box.high[i];
      return result;
    };
    if (inner.bulk.is_closed && !inner.is_fixed && !is_thick(size_of(inner.bulk)) &&
        std::any_of(solids.begin(), solids.end(), is_around))
      leave_out(inner.triangles, inner.bulk);
  }
}

// Leaves out closed triangles as a whole.
void Thin_part_merger::leave_out(const std::vector<std::uint32_t>& triangles, const Bulk& bulk)
{
  Change change;
  for (std::uint32_t t : triangles)
    leave_out(change, t, mesh_.triangles[t]);
  if (!is_near_enough(change))
    return;
  if (area_of_films_ == 0)
    place_of_film_ = map_.points()[mesh_.triangles[triangles[0]][0]];
  area_of_films_ += bulk.area / 2;
  make(change);
}

// Leaves out what stays beside films that were left out and is no more than a film, such as corners at their rims. The
// largest piece of each solid stays.
void Thin_part_merger::leave_crumbs_out()
{
  std::map<std::uint32_t, std::vector<std::vector<std::uint32_t>>> pieces_of; // each component
  for (const auto& [root, piece] : pieces())
    if (is_solid_[component_of(piece[0])])
      pieces_of[component_of(piece[0])].push_back(piece);
  const auto is_smaller = [](const auto& piece, const auto& other) { return piece.size() < other.size(); };
  for (auto& [component, pieces] : pieces_of) {
    pieces.erase(std::max_element(pieces.begin(), pieces.end(), is_smaller));
    for (const std::vector<std::uint32_t>& piece : pieces) {
      Bulk bulk;
      bool is_at_film = false;
      for (std::uint32_t t : piece) {
        add(bulk, t);
        for (std::uint32_t v : mesh_.triangles[t])
          is_at_film = is_at_film || is_at_film_[v];
      }
      bulk.volume = std::abs(bulk.volume);
      if (!is_thick(bulk) && bulk.is_closed && is_at_film)
        leave_out(piece, bulk);
    }
  }
}

// Whether a triangle lies on the one beyond a side.
bool Thin_part_merger::is_folded(std::uint32_t t) const
{
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

// Vertices of which nothing but films is left are merged with one nearby.
void Thin_part_merger::find_images_of_films()
{
  std::vector<std::uint32_t> lonely, others;
  for (std::uint32_t v = 0; v < images_.size(); ++v)
    if (is_at_film_[v] && at_vertex_[v].empty() && images_[v] == v)
      lonely.push_back(v);
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

} // namespace CGAL::Intrinsic_triangulations::internal

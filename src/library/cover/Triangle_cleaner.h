// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The triangles of a cover before they are glued: vertices at one place may be merged, and faces that lost a corner are
// removed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_TRIANGLE_CLEANER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_TRIANGLE_CLEANER_H

#include "Flat_face_remover.h"

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// For each vertex, whether it has a face.
inline std::vector<bool> have_faces(std::size_t number_of_vertices, const std::vector<Index_triangle>& triangles)
{
  std::vector<bool> result(number_of_vertices, false);
  for (const Index_triangle& t : triangles)
    for (std::uint32_t v : t)
      result[v] = true;
  return result;
}

// Triangles with corners at three different places; each corner is the vertex that represents the given one.
struct Cleaned_triangles
{
  std::vector<Index_triangle> triangles;
  std::vector<std::uint32_t> input_face;     // of each triangle
  std::vector<std::uint32_t> representative; // of each vertex
  std::vector<Wire> wires;                   // of faces that lost a corner
  Tufted_cover_report report;                // numbers of vertices and faces, dropped and merged ones
};

// \param merged pairs of vertices to unite, besides those that the options merge
// \exception Invalid_surface_error if the point of a vertex with a face is not finite, or as Coincident_vertices::ERROR
//   demands
// \pre the vertices exist
class Triangle_cleaner
{
public:
  Triangle_cleaner(const Points& points, std::vector<Index_triangle> triangles, const Cover_options& options)
    : points_(points), options_(options)
  {
    result_.triangles = std::move(triangles);
    result_.report.number_of_vertices = points.size();
    result_.report.number_of_faces = result_.triangles.size();
  }

  Cleaned_triangles run(const std::vector<Vertex_number_pair>& merged)
  {
    check_points();
    result_.input_face.resize(result_.triangles.size());
    std::iota(result_.input_face.begin(), result_.input_face.end(), std::uint32_t(0));
    result_.report.repeated_corner_faces = remove_if([](const Index_triangle& t) { return repeats_a_corner(t); });
    Disjoint_sets sets(points_.size());
    for (const auto& [v, w] : merged)
      sets.unite(v, w);
    if (options_.is_welded)
      weld(sets);
    treat_short_edges(sets);
    name_representatives(sets);
    count_unreferenced();
    return std::move(result_);
  }

private:
  static bool repeats_a_corner(const Index_triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

  // Also checks vertices that no face names: the constructors of triangulations refuse them, too.
  void check_points() const
  {
    for (std::size_t v = 0; v < points_.size(); ++v)
      for (double x : points_[v])
        if (!std::isfinite(x))
          throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_FINITE, v, 1,
                                      "vertex " + std::to_string(v) + " has a coordinate that is not finite");
  }

  // Returns how many triangles were removed.
  template <class Condition>
  std::size_t remove_if(const Condition& condition)
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < result_.triangles.size(); ++i)
      if (!condition(result_.triangles[i])) {
        result_.triangles[n] = result_.triangles[i];
        result_.input_face[n++] = result_.input_face[i];
      }
    const std::size_t removed = result_.triangles.size() - n;
    result_.triangles.resize(n);
    result_.input_face.resize(n);
    return removed;
  }

  void weld(Disjoint_sets& sets) const
  {
    const std::vector<bool> has_face = have_faces(points_.size(), result_.triangles);
    std::vector<std::uint32_t> order;
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      if (has_face[v])
        order.push_back(v);
    std::sort(order.begin(), order.end(), [this](std::uint32_t v, std::uint32_t w) { return points_[v] < points_[w]; });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (points_[order[i - 1]] == points_[order[i]])
        sets.unite(order[i - 1], order[i]);
  }

  // The first corner of a side whose ends are at the same place but are different vertices, or 3.
  int find_short_side(const Index_triangle& t, Disjoint_sets& sets) const
  {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = t[i], w = t[(i + 1) % 3];
      if (points_[v] == points_[w] && sets.find(v) != sets.find(w))
        return i;
    }
    return 3;
  }

  void treat_short_edges(Disjoint_sets& sets)
  {
    if (options_.coincident_vertices == Coincident_vertices::DROP) {
      result_.report.zero_length_faces =
        remove_if([&](const Index_triangle& t) { return find_short_side(t, sets) < 3; });
      return;
    }
    for (std::size_t f = 0; f < result_.triangles.size(); ++f) {
      const Index_triangle& t = result_.triangles[f];
      for (int i = find_short_side(t, sets); i < 3; i = find_short_side(t, sets)) {
        const std::uint32_t v = t[i], w = t[(i + 1) % 3];
        if (options_.coincident_vertices == Coincident_vertices::ERROR)
          throw Invalid_surface_error(Invalid_surface_error::Defect::ZERO_LENGTH_EDGE, v, 1,
                                      "vertices " + std::to_string(v) + " and " + std::to_string(w) + " of face " +
                                        std::to_string(result_.input_face[f]) +
                                        " are at the same place; merge them, or drop the face");
        sets.unite(v, w);
      }
    }
  }

  void name_representatives(Disjoint_sets& sets)
  {
    result_.representative.resize(points_.size());
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      result_.representative[v] = sets.find(v);
      result_.report.merged_vertices += result_.representative[v] != v;
    }
    if (result_.report.merged_vertices == 0)
      return;
    for (Index_triangle& t : result_.triangles)
      for (std::uint32_t& v : t)
        v = result_.representative[v];
    for (std::size_t f = 0; f < result_.triangles.size(); ++f) {
      const auto& [a, b, c] = result_.triangles[f];
      if (const std::uint32_t other = a == b ? c : b; repeats_a_corner(result_.triangles[f]) && other != a)
        result_.wires.push_back({{a, other}, result_.input_face[f]});
    }
    result_.report.collapsed_faces = remove_if([](const Index_triangle& t) { return repeats_a_corner(t); });
  }

  void count_unreferenced()
  {
    const std::vector<bool> has_row = have_faces(points_.size(), result_.triangles);
    for (std::uint32_t v = 0; v < points_.size(); ++v)
      result_.report.unreferenced_vertices += !has_row[result_.representative[v]];
  }

  const Points& points_;
  const Cover_options& options_;
  Cleaned_triangles result_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_TRIANGLE_CLEANER_H

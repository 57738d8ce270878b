// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of crossing_triangles.h.

#include "crossing_triangles.h"
#include "nearness.h"

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Intersections_3/Segment_3_Triangle_3.h>
#include <CGAL/Intersections_3/Triangle_3_Triangle_3.h>

#include <algorithm>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using Crossing_kernel = Exact_predicates_inexact_constructions_kernel;

class Crossing_test
{
public:
  explicit Crossing_test(const std::vector<std::array<double, 3>>& points) : points_(points) {}

  bool has_area(const Index_triangle& t) const { return !collinear(at(t[0]), at(t[1]), at(t[2])); }

  bool operator()(Index_triangle s, Index_triangle t) const
  {
    // Common corners come first.
    const auto is_common = [](const Index_triangle& other) {
      return [&other](std::uint32_t v) { return std::count(other.begin(), other.end(), v) != 0; };
    };
    const Index_triangle all = s;
    const auto end = std::stable_partition(s.begin(), s.end(), is_common(t));
    std::stable_partition(t.begin(), t.end(), is_common(all));
    switch (end - s.begin()) {
    case 0:
      return do_intersect(triangle(s), triangle(t));
    case 1:
      return do_intersect(Crossing_kernel::Segment_3(at(s[1]), at(s[2])), triangle(t)) ||
             do_intersect(Crossing_kernel::Segment_3(at(t[1]), at(t[2])), triangle(s));
    case 2: {
      const Crossing_kernel::Point_3 p = at(s[0]), q = at(s[1]), a = at(s[2]), b = at(t[2]);
      return coplanar(p, q, a, b) && coplanar_orientation(p, q, a, b) == POSITIVE;
    }
    default:
      return false;
    }
  }

private:
  Crossing_kernel::Point_3 at(std::uint32_t v) const { return {points_[v][0], points_[v][1], points_[v][2]}; }
  Crossing_kernel::Triangle_3 triangle(const Index_triangle& t) const { return {at(t[0]), at(t[1]), at(t[2])}; }

  const std::vector<std::array<double, 3>>& points_;
};

} // namespace

std::vector<std::array<std::uint32_t, 2>> crossing_triangles(const std::vector<std::array<double, 3>>& points,
                                                             const std::vector<Index_triangle>& triangles,
                                                             const std::function<void()>& go_on)
{
  const Crossing_test cross(points);
  std::vector<std::uint32_t> with_area;
  std::vector<Space_box> boxes;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (cross.has_area(triangles[t])) {
      const auto& [u, v, w] = triangles[t];
      with_area.push_back(t);
      boxes.emplace_back(Space_triangle{points[u], points[v], points[w]});
    }
  std::vector<std::array<std::uint32_t, 2>> result;
  const Box_tree tree(std::move(boxes));
  for (std::uint32_t i = 0; i < with_area.size(); ++i) {
    go_on();
    for (std::uint32_t k : tree.near(tree.box(i), 0))
      if (k > i && cross(triangles[with_area[i]], triangles[with_area[k]]))
        result.push_back({with_area[i], with_area[k]});
  }
  return result;
}

bool do_cross(const std::vector<std::array<double, 3>>& points, const Index_triangle& s, const Index_triangle& t)
{
  const auto box = [&](const Index_triangle& u) {
    return Space_box(Space_triangle{points[u[0]], points[u[1]], points[u[2]]});
  };
  const Crossing_test cross(points);
  return box(s).is_near(box(t), 0) && cross.has_area(s) && cross.has_area(t) && cross(s, t);
}

Surface_crossings::Surface_crossings(const Common_subdivision& subdivision,
                                     const std::vector<std::array<double, 3>>& points,
                                     const std::function<void()>& go_on)
  : input_faces_(subdivision.intrinsic().number_of_faces()), crossed_(subdivision.input().number_of_faces())
{
  const Overlay& overlay = subdivision.overlay();
  for (Overlay::Face f : overlay.faces())
    input_faces_[overlay.intrinsic_face(f).idx()].push_back(overlay.input_face(f).idx());
  for (std::vector<std::uint32_t>& faces : input_faces_)
    std::sort(faces.begin(), faces.end());
  const Delta_complex& input = subdivision.input();
  std::vector<Index_triangle> triangles;
  for (Face_index f : input.faces()) {
    const Halfedge_index h = input.halfedge(f);
    triangles.push_back({input.source(h).idx(), input.target(h).idx(), input.source(input.prev(h)).idx()});
  }
  const auto with_neighbors = [&](std::uint32_t f) { // since a line where triangles cross may move to them
    std::vector<std::uint32_t> result{f};
    const Halfedge_index h = input.halfedge(Face_index(f));
    for (Halfedge_index side : {h, input.next(h), input.prev(h)})
      if (!input.is_border(input.edge(side)))
        result.push_back(input.face(input.opposite(side)).idx());
    return result;
  };
  for (const auto& [s, t] : crossing_triangles(points, triangles, go_on))
    for (std::uint32_t f : with_neighbors(s))
      for (std::uint32_t g : with_neighbors(t)) {
        crossed_[f].push_back(g);
        crossed_[g].push_back(f);
      }
}

bool Surface_crossings::has(const std::vector<Face_index>& faces, const std::vector<Face_index>& others) const
{
  for (Face_index f : faces)
    for (std::uint32_t input_face : input_faces_[f.idx()])
      for (std::uint32_t crossed : crossed_[input_face])
        for (Face_index other : others)
          if (std::binary_search(input_faces_[other.idx()].begin(), input_faces_[other.idx()].end(), crossed))
            return true;
  return false;
}

} // namespace CGAL::Intrinsic_triangulations::internal

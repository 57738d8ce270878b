// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The edges that refinement splits but does not flip: border edges and constrained ones. Whole ones it does not split.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Measured_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <class Traits>
class Segments
{
public:
  Segments(const Delta_complex& complex, const Correspondence& correspondence, Input_shapes& shapes,
           const Measured_faces<Traits>& faces, std::vector<bool> is_segment, const std::vector<bool>& is_whole)
    : complex_(complex), correspondence_(correspondence), shapes_(shapes), faces_(faces),
      is_segment_(std::move(is_segment)), is_whole_(is_whole),
      is_empty_(std::find(is_segment_.begin(), is_segment_.end(), true) == is_segment_.end())
  {}

  bool is_empty() const { return is_empty_; }
  bool contains(Edge_index e) const { return is_segment_[e.idx()]; }
  bool contains(Halfedge_index h) const { return contains(complex_.edge(h)); }
  bool is_whole(Edge_index e) const { return e.idx() < is_whole_.size() && is_whole_[e.idx()]; }
  void add(Edge_index e)
  {
    is_segment_[e.idx()] = true;
    is_empty_ = false;
  }
  // New edges are not segments.
  void resize() { is_segment_.resize(complex_.number_of_edges(), false); }

  bool has_segment(Vertex_index v) const
  {
    for (Halfedge_index h : Halfedges_around(complex_, v))
      if (contains(h))
        return true;
    return false;
  }

  // Segments that meet at a small angle are split on concentric shells around the corner.
  void find_small_corner(Vertex_index v)
  {
    if (!is_empty() && has_small_corner(v))
      small_corners_.insert(v);
  }

  // A corner of the input between two segments can force a small angle opposite to an edge between points at the same
  // distance from it. (G. Miller, S. Pav, N. Walkington, "When and why Ruppert's algorithm works", 2003.)
  bool is_between_shells(Halfedge_index h) const
  {
    // A vertex on an input edge, seen from one end of that edge.
    struct View
    {
      Halfedge_index from_end;
      double distance = 0;
    };
    const Delta_complex& input = correspondence_.input();
    const auto views = [&](Vertex_index v) {
      std::array<View, 2> result;
      if (!correspondence_.is_inserted(v) || correspondence_.location(v).dimension() != 1)
        return result;
      const Surface_point& p = correspondence_.location(v);
      const Halfedge_index along = side_of(input, p);
      const auto [a, b] = coordinates_on_edge(input, p, along);
      const double l = shapes_.length(input.edge(along));
      result[0] = {along, l * b};
      result[1] = {input.opposite(along), l * a};
      return result;
    };
    for (const auto& [g, d] : views(complex_.source(h)))
      for (const auto& [k, e] : views(complex_.target(h)))
        if (g.is_valid() && k.is_valid() && g != k && input.source(g) == input.source(k) &&
            std::abs(d - e) < 1e-9 * d && small_corners_.count(input.source(g)) != 0)
          return true;
    return false;
  }

  // An edge is encroached if an opposite angle is larger than a right one.
  bool is_encroached(Edge_index e) const
  {
    for (Halfedge_index h : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(h)) {
        const double a = faces_.length(complex_.next(h)) / faces_.length(h),
                     b = faces_.length(complex_.prev(h)) / faces_.length(h);
        if (a * a + b * b < 1)
          return true;
      }
    return false;
  }

  // A segment that a vertex at this point would encroach on, among those that bound the triangles with the point in
  // their circumcircles. A whole one is only in the way of a triangle whose slope over it is too small.
  std::optional<Edge_index> encroached_by(const Walk_end& end, double smallest_slope) const
  {
    if (is_empty())
      return std::nullopt;
    struct Side
    {
      Halfedge_index halfedge;
      Plane_point point;
    };
    std::vector<Side> sides{{end.halfedge, end.weights[1] + end.weights[2] * faces_.apex(end.halfedge)}};
    const auto push_others = [&](Side s, Plane_point z) {
      sides.push_back({complex_.next(s.halfedge), (s.point - 1.) / (z - 1.)});
      sides.push_back({complex_.prev(s.halfedge), (s.point - z) / -z});
    };
    push_others(sides[0], faces_.apex(end.halfedge));
    for (std::size_t i = 0; i < sides.size() && i < 300; ++i) {
      const Side s = sides[i];
      if (contains(s.halfedge)) {
        const Edge_index e = complex_.edge(s.halfedge);
        if (std::real(s.point * std::conj(s.point - 1.)) < 0 &&
            !(is_whole(e) && slope(s.point) >= (std::min)(smallest_slope, slope(faces_.apex(s.halfedge)))))
          return e;
        continue;
      }
      const Side behind{complex_.opposite(s.halfedge), 1. - s.point};
      const Plane_point z = faces_.apex(behind.halfedge), center(0.5, (std::norm(z) - z.real()) / (2 * z.imag()));
      if (std::norm(behind.point - center) < std::norm(center))
        push_others(behind, z);
    }
    return std::nullopt;
  }

  // Halfway, but at a power of two from a corner where two segments meet at a small angle, so that they are split at
  // the same distances from it.
  double split_position(Halfedge_index h, double begin, double end) const
  {
    const bool at_source = small_corners_.count(complex_.source(h)) != 0,
               at_target = small_corners_.count(complex_.target(h)) != 0;
    if (at_source == at_target)
      return (begin + end) / 2;
    const double l = faces_.length(h);
    double shell = std::ldexp(1., std::ilogb(l));
    while (shell > 2 * l / 3)
      shell /= 2;
    const double part = shell / l * (end - begin);
    return at_source ? begin + part : end - part;
  }

private:
  // The tangent of the smaller angle at 0 and 1 of a triangle whose third corner is above them.
  static double slope(Plane_point apex) { return apex.imag() / (std::max)(apex.real(), 1 - apex.real()); }

  // Whether two segments meet at v at less than 60 degrees.
  bool has_small_corner(Vertex_index v) const
  {
    for (Halfedge_index h : Halfedges_around(complex_, v))
      if (contains(h)) {
        double sum = 0;
        for (Halfedge_index side = complex_.opposite(h); !complex_.is_border(side);) {
          sum += faces_.angle(side);
          side = complex_.next_around_source(side);
          if (contains(side)) {
            if (sum < CGAL_PI / 3)
              return true;
            break;
          }
        }
      }
    return false;
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  Input_shapes& shapes_;
  const Measured_faces<Traits>& faces_;
  std::vector<bool> is_segment_;
  const std::vector<bool>& is_whole_; // of the first edges
  bool is_empty_;
  std::unordered_set<Vertex_index> small_corners_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SEGMENTS_H

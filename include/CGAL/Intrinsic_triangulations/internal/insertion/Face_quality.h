// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What refinement knows of faces: how large they are, which of them it makes smaller, and what keeps it from doing so.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Lengths of edges as doubles, in the unit of the input, and the shapes of faces.
template <class Traits>
class Measured_faces
{
public:
  explicit Measured_faces(Intrinsic_triangulation<Traits>& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity())
  {}

  void measure_all()
  {
    lengths_.resize(complex_.number_of_edges());
    for (Edge_index e : complex_.edges())
      measure(e);
  }
  // To be called again for what changes.
  void measure(Edge_index e)
  {
    lengths_[e.idx()] = has_good_length(e) ? std::ldexp(std::sqrt(squared_length(e)), triangulation_.unit_exponent())
                                           : CGAL::to_double(triangulation_.length(e));
  }
  // All edges at v, which may be new; its faces are measured anew first if flips have left numbers that are not good.
  void measure_star(Vertex_index v)
  {
    lengths_.resize(complex_.number_of_edges());
    bool are_good = true;
    for (Halfedge_index h : Halfedges_around(complex_, v))
      are_good = are_good && has_good_length(complex_.edge(h));
    if (!are_good)
      Whole_triangulation<Traits>(triangulation_).recompute(v);
    for (Halfedge_index h : Halfedges_around(complex_, v))
      measure(complex_.edge(h));
  }
  double length(Edge_index e) const { return lengths_[e.idx()]; }
  double length(Halfedge_index h) const { return length(complex_.edge(h)); }
  Plane_point apex(Halfedge_index h) const
  {
    return third_corner(length(h), length(complex_.next(h)), length(complex_.prev(h)));
  }
  Halfedge_index longest_side(Face_index f) const
  {
    return side_with_largest(complex_, f, [&](Halfedge_index h) { return length(h); });
  }
  Halfedge_index shortest_side(Face_index f) const
  {
    return side_with_largest(complex_, f, [&](Halfedge_index h) { return -length(h); });
  }
  double circumradius(Face_index f) const
  {
    const Halfedge_index h = longest_side(f);
    const double jk = length(complex_.next(h)), ki = length(complex_.prev(h)), height = apex(h).imag();
    return height > 0 ? jk / length(h) * ki / height / 2 : (std::numeric_limits<double>::infinity)();
  }
  // The angle at the source of h, in its face.
  double angle(Halfedge_index h) const
  {
    const Halfedge_index longest = longest_side(complex_.face(h));
    const Plane_point z = apex(longest);
    if (h == longest)
      return std::atan2(z.imag(), z.real());
    if (h == complex_.next(longest))
      return std::atan2(z.imag(), 1 - z.real());
    return CGAL_PI - std::atan2(z.imag(), z.real()) - std::atan2(z.imag(), 1 - z.real());
  }

private:
  double squared_length(Edge_index e) const
  {
    return triangulation_.traits().compute_squared_length_object()(triangulation_.edge_data(e));
  }
  // Whether the numbers that flips keep are good to 30 bits.
  bool has_good_length(Edge_index e) const
  {
    double error = (std::numeric_limits<double>::infinity)();
    for (Halfedge_index side : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(side))
        error = (std::min)(error, triangulation_.face_data(complex_.face(side)).error);
    return error <= 0x1p-30 * squared_length(e);
  }

  Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  std::vector<double> lengths_; // of the edges
};

// The edges that refinement splits and does not flip: those on the border, and constrained ones.
template <class Traits>
class Segments
{
public:
  Segments(const Delta_complex& complex, const Correspondence& correspondence, Input_shapes& shapes,
           const Measured_faces<Traits>& faces, std::vector<bool> is_segment)
    : complex_(complex), correspondence_(correspondence), shapes_(shapes), faces_(faces),
      is_segment_(std::move(is_segment)),
      is_empty_(std::find(is_segment_.begin(), is_segment_.end(), true) == is_segment_.end())
  {}

  bool is_empty() const { return is_empty_; }
  bool contains(Edge_index e) const { return is_segment_[e.idx()]; }
  bool contains(Halfedge_index h) const { return contains(complex_.edge(h)); }
  void add(Edge_index e)
  {
    is_segment_[e.idx()] = true;
    is_empty_ = false;
  }
  // New edges are no segments.
  void resize() { is_segment_.resize(complex_.number_of_edges(), false); }

  bool has_segment(Vertex_index v) const
  {
    for (Halfedge_index h : Halfedges_around(complex_, v))
      if (contains(h))
        return true;
    return false;
  }

  // Where segments meet in a small angle, they are split as shells around the corner demand.
  void find_small_corner(Vertex_index v)
  {
    if (!is_empty() && has_small_corner(v))
      small_corners_.insert(v);
  }

  // A corner of the input between two segments can force a small angle opposite to an edge between points at the same
  // distance from it. (G. Miller, S. Pav, N. Walkington, "When and why Ruppert's algorithm works", 2003.)
  bool is_between_shells(Halfedge_index h) const
  {
    // A vertex on an input edge, as seen from one end of that.
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
      Halfedge_index along = p.halfedge;
      std::size_t i = 0;
      for (; p.coordinates[(i + 2) % 3] != 0; ++i)
        along = input.next(along);
      const double l = shapes_.length(input.edge(along));
      result[0] = {along, l * p.coordinates[(i + 1) % 3]};
      result[1] = {input.opposite(along), l * p.coordinates[i]};
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

  // A segment that a vertex at this point would encroach on: among those that bound the triangles with the point in
  // their circumcircles.
  std::optional<Edge_index> encroached_by(const Walk_end& end) const
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
        if (std::real(s.point * std::conj(s.point - 1.)) < 0)
          return complex_.edge(s.halfedge);
        continue;
      }
      const Side behind{complex_.opposite(s.halfedge), 1. - s.point};
      const Plane_point z = faces_.apex(behind.halfedge), center(0.5, (std::norm(z) - z.real()) / (2 * z.imag()));
      if (std::norm(behind.point - center) < std::norm(center))
        push_others(behind, z);
    }
    return std::nullopt;
  }

  // Halfway, but at a distance that is a power of two from a corner where two segments meet in a small angle: so they
  // are split at the same distances from it.
  double split_position(Halfedge_index h, double begin, double end) const
  {
    const bool at_source = small_corners_.count(complex_.source(h)) != 0,
               at_target = small_corners_.count(complex_.target(h)) != 0;
    if (at_source == at_target)
      return (begin + end) / 2;
    const double l = faces_.length(h);
    double shell = std::exp2(std::floor(std::log2(l)));
    while (shell > 2 * l / 3)
      shell /= 2;
    const double part = shell / l * (end - begin);
    return at_source ? begin + part : end - part;
  }

private:
  // Whether two segments meet at v in less than 60 degrees.
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
  bool is_empty_;
  std::unordered_set<Vertex_index> small_corners_;
};

// Vertices with a small sum of angles, where refinement has to keep its distance: see doc/termination.md. Lengths are in the unit of the input.
class Small_cones
{
public:
  Small_cones(const Exact_engine& engine, Input_shapes& shapes)
    : input_(engine.correspondence().input()), unit_exponent_(engine.metric().unit_exponent()), shapes_(shapes)
  {}

  void add(Vertex_index v, double angle) { cones_.emplace(v, Cone{angle, 0}); }
  bool contains(Vertex_index v) const { return cones_.count(v) != 0; }
  std::vector<Vertex_index> vertices() const
  {
    std::vector<Vertex_index> result;
    for (const auto& cone : cones_)
      result.push_back(cone.first);
    std::sort(result.begin(), result.end());
    return result;
  }

  // A circle around v of this radius lies in the input faces there: the smallest height from v.
  double radius_of_input_faces(Vertex_index v) const
  {
    double radius = (std::numeric_limits<double>::infinity)();
    for (Halfedge_index h : Halfedges_around(input_, v)) {
      const double height = shapes_.four_areas(input_.face(h)) / (2 * shapes_.length(input_.edge(input_.prev(h))));
      radius = (std::min)(radius, std::ldexp(height, unit_exponent_));
    }
    return radius;
  }

  // Keeps the circumcircle of the triangle free that a vertex at this distance makes with v.
  void protect(Vertex_index v, double distance)
  {
    Cone& cone = cones_.at(v);
    constexpr double for_rounding = 1 + 1e-9;
    cone.radius = distance / std::cos(cone.angle / 2) * for_rounding;
  }

  bool is_too_close(const Surface_point& point) const
  {
    if (cones_.empty())
      return false;
    std::array<double, 3> w = point.coordinates;
    Halfedge_index h = point.halfedge;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto cone = cones_.find(input_.source(h));
      if (cone != cones_.end()) {
        const double distance = std::abs(w[1] + w[2] * shapes_.apex(h)) * shapes_.length(input_.edge(h));
        if (std::ldexp(distance, unit_exponent_) < cone->second.radius)
          return true;
      }
      h = input_.next(h);
      std::rotate(w.begin(), w.begin() + 1, w.end());
    }
    return false;
  }

private:
  struct Cone
  {
    double angle;
    double radius; // of the circle that is kept free
  };

  const Delta_complex& input_;
  const int unit_exponent_;
  Input_shapes& shapes_;
  std::unordered_map<Vertex_index, Cone> cones_;
};

// Which triangles are made smaller; `refine_Delaunay()` says what the members mean.
struct Refinement_criteria
{
  double minimum_angle = 25;
  double maximum_circumradius = (std::numeric_limits<double>::infinity)();
  double maximum_edge_length = (std::numeric_limits<double>::infinity)();
  bool splits_encroached_edges = false;
  double minimum_size = 0;
};

template <class Traits>
class Face_quality
{
public:
  Face_quality(const Delta_complex& complex, const Refinement_criteria& criteria, const Measured_faces<Traits>& faces,
               const Segments<Traits>& segments, const Small_cones& cones)
    : complex_(complex), criteria_(criteria), faces_(faces), segments_(segments), cones_(cones),
      sine_of_minimum_angle_(std::sin(minimum_angle()))
  {}

  const Refinement_criteria& criteria() const { return criteria_; }
  // In radians.
  double minimum_angle() const { return criteria_.minimum_angle / 180 * CGAL_PI; }

  bool is_below_smallest_size(Face_index f) const
  {
    return faces_.length(faces_.shortest_side(f)) < criteria_.minimum_size;
  }
  bool is_too_large(Face_index f) const
  {
    return is_too_large(faces_.length(faces_.longest_side(f)), faces_.circumradius(f));
  }
  bool has_small_angle(Face_index f) const
  {
    return has_small_angle(faces_.length(faces_.shortest_side(f)), faces_.circumradius(f));
  }
  // Whether a triangle with these measures would be refined, if nothing keeps its angles.
  bool is_bad(double shortest, double longest, double circumradius) const
  {
    return is_too_large(longest, circumradius) || has_small_angle(shortest, circumradius);
  }
  bool is_too_small(double angle) const { return angle < minimum_angle(); }

  // Whether f is to be refined.
  bool is_bad(Face_index f) const
  {
    if (is_below_smallest_size(f))
      return false;
    if (is_too_large(f))
      return true;
    const Halfedge_index h = complex_.halfedge(f);
    if (!has_small_angle(f))
      return false;
    for (Halfedge_index corner : {h, complex_.next(h), complex_.prev(h)})
      if (is_to_be_enlarged(corner))
        return true;
    return false;
  }
  bool is_to_be_enlarged(Halfedge_index corner) const
  {
    return is_too_small(faces_.angle(corner)) && !obstacle_at(corner) &&
           !segments_.is_between_shells(complex_.next(corner));
  }
  // Whether refinement cannot change the corner at the source of h.
  std::optional<Refinement_obstacle> obstacle_at(Halfedge_index h) const
  {
    if (segments_.contains(h) && segments_.contains(complex_.prev(h)))
      return Refinement_obstacle::SMALL_INPUT_ANGLE;
    if (cones_.contains(complex_.source(h)))
      return Refinement_obstacle::CONE;
    return std::nullopt;
  }

private:
  bool is_too_large(double longest, double circumradius) const
  {
    return longest > criteria_.maximum_edge_length || circumradius > criteria_.maximum_circumradius;
  }
  // The sine of the smallest angle is the shortest side over the diameter of the circumcircle.
  bool has_small_angle(double shortest, double circumradius) const
  {
    return !(shortest > 2 * circumradius * sine_of_minimum_angle_ * (1 + 1e-9));
  }

  const Delta_complex& complex_;
  const Refinement_criteria criteria_;
  const Measured_faces<Traits>& faces_;
  const Segments<Traits>& segments_;
  const Small_cones& cones_;
  const double sine_of_minimum_angle_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delaunay refinement: Ruppert's algorithm on a surface, with vertices that small cones are protected by.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Refinement_report.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Small_cones.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/settle_around.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Segments are the edges that are not flipped: on the border, or constrained.
template <class Traits, class Visitor>
class Delaunay_refiner
{
public:
  using Triangulation = Intrinsic_triangulation<Traits>;

  Delaunay_refiner(Triangulation& triangulation, const Refinement_criteria& criteria, std::vector<bool> is_segment, Visitor& visitor,
                   std::uint64_t maximum_number)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), geometry_(triangulation.exact_geometry()),
      correspondence_(geometry_.correspondence()), shapes_(geometry_), criteria_(criteria), is_segment_(std::move(is_segment)),
      visitor_(visitor), maximum_number_(maximum_number),
      has_segments_(std::find(is_segment_.begin(), is_segment_.end(), true) != is_segment_.end()), cones_(geometry_, shapes_), sine_of_minimum_angle_(std::sin(criteria.minimum_angle / 180 * CGAL_PI))
  {}

  Refinement_report operator()()
  {
    try {
      refine_all();
    } catch (const Cancelled_error&) {
      if (report_.status != Refinement_status::CANCELLED) // it was not the visitor
        throw;
    }
    return std::move(report_);
  }

  // Asks the visitor once more within a step.
  bool asks_further()
  {
    if (!visitor_.go_further(report_.insertions + report_.segment_splits, report_.flips))
      report_.status = Refinement_status::CANCELLED;
    return report_.status != Refinement_status::CANCELLED;
  }

private:
  void refine_all()
  {
    lengths_.resize(complex_.number_of_edges());
    for (Edge_index e : complex_.edges())
      measure(e);
    fix_faces_without_area();
    find_cones();
    if (goes_on())
      protect_cones();
    if (criteria_.splits_encroached_edges)
      for (Edge_index e : complex_.edges())
        if (is_segment_[e.idx()])
          segments_.push_back(e);
    for (Face_index f : complex_.faces())
      note(f);
    while (has_candidates() && goes_on()) {
      if (!segments_.empty()) {
        const Edge_index e = segments_.back();
        segments_.pop_back();
        if (is_encroached(e))
          split_segment(e);
        continue;
      }
      const Candidate candidate = bad_faces_.top();
      bad_faces_.pop();
      if (is_bad(candidate.face) && circumradius(candidate.face) == candidate.radius)
        refine(candidate.face);
    }
    list_unrefined_faces();
  }

  static constexpr double smallest_whole_cone = CGAL_PI / 3;

  // Faces with a small angle come first, and of these those with the shortest side: what is inserted close to it improves those
  // that have longer ones (A. Ungor, "Off-centers", 2009). Of the faces with sides of the same size up to a root of two, and of those that are only too
  // large, the largest is next: edges around it cross the fewest small faces.
  struct Candidate
  {
    int order_of_size;
    double radius; // of the circumcircle
    Face_index face;
    bool operator<(const Candidate& other) const
    {
      if (order_of_size != other.order_of_size)
        return other.order_of_size < order_of_size;
      if (radius != other.radius)
        return radius < other.radius;
      return other.face.idx() < face.idx();
    }
  };

  bool has_candidates() const { return !segments_.empty() || !bad_faces_.empty(); }
  bool goes_on()
  {
    if (report_.status != Refinement_status::REFINED)
      return false;
    if (asks_further() && report_.insertions + report_.segment_splits >= maximum_number_ && has_candidates())
      report_.status = Refinement_status::BUDGET_EXHAUSTED;
    return report_.status == Refinement_status::REFINED;
  }

  // Lengths, in the unit of the input, and shapes.
  double length(Edge_index e) const { return lengths_[e.idx()]; }
  double squared_length(Edge_index e) const { return triangulation_.traits().compute_squared_length_object()(triangulation_.edge_data(e)); }
  // Whether the numbers that flips keep are good to 30 bits.
  bool has_good_length(Edge_index e) const
  {
    double error = (std::numeric_limits<double>::infinity)();
    for (Halfedge_index side : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(side))
        error = (std::min)(error, triangulation_.face_data(complex_.face(side)).error);
    return error <= 0x1p-30 * squared_length(e);
  }
  void measure(Edge_index e)
  {
    lengths_[e.idx()] = has_good_length(e) ? std::ldexp(std::sqrt(squared_length(e)), triangulation_.unit_exponent())
                                           : CGAL::to_double(triangulation_.length(e));
  }
  // Of all edges at v, once its faces are measured anew if flips have left numbers that are not good.
  void measure_star(Vertex_index v)
  {
    bool are_good = true;
    const Halfedge_index first = complex_.halfedge(v);
    Halfedge_index h = first;
    do {
      are_good = are_good && has_good_length(complex_.edge(h));
      h = complex_.next_around_target(h);
    } while (h != first);
    if (!are_good)
      triangulation_.refine(v);
    do {
      measure(complex_.edge(h));
      h = complex_.next_around_target(h);
    } while (h != first);
  }
  double length(Halfedge_index h) const { return length(complex_.edge(h)); }
  Plane_point apex(Halfedge_index h) const
  {
    return third_corner(length(h), length(complex_.next(h)), length(complex_.prev(h)));
  }
  Halfedge_index longest_side(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    Halfedge_index result = h;
    for (Halfedge_index side : {complex_.next(h), complex_.prev(h)})
      if (length(side) > length(result))
        result = side;
    return result;
  }
  Halfedge_index shortest_side(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    Halfedge_index result = h;
    for (Halfedge_index side : {complex_.next(h), complex_.prev(h)})
      if (length(side) < length(result))
        result = side;
    return result;
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

  // Whether refinement cannot change the corner at the source of h.
  std::optional<Refinement_obstacle> obstacle_at(Halfedge_index h) const
  {
    if (is_segment(h) && is_segment(complex_.prev(h)))
      return Refinement_obstacle::SMALL_INPUT_ANGLE;
    if (cones_.contains(complex_.source(h)))
      return Refinement_obstacle::CONE;
    return std::nullopt;
  }
  bool is_segment(Halfedge_index h) const { return is_segment_[complex_.edge(h).idx()]; }

  bool is_too_large(Face_index f) const
  {
    return length(longest_side(f)) > criteria_.maximum_edge_length || circumradius(f) > criteria_.maximum_circumradius;
  }
  // The sine of the smallest angle is the shortest side over the diameter of the circumcircle.
  bool has_small_angle(Face_index f) const
  {
    return !(length(shortest_side(f)) > 2 * circumradius(f) * sine_of_minimum_angle_ * (1 + 1e-9));
  }
  bool is_too_small(double angle) const { return angle < criteria_.minimum_angle / 180 * CGAL_PI; }

  // Whether f is to be refined.
  bool is_bad(Face_index f) const
  {
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
    return is_too_small(angle(corner)) && !obstacle_at(corner) && !is_between_shells(complex_.next(corner));
  }
  // The number of roots of two that a length is worth, rounded down.
  static int half_octave(double length)
  {
    int exponent = 0;
    const double fraction = std::frexp(length, &exponent);
    return 2 * exponent + (fraction * fraction >= 0.5 ? 1 : 0);
  }
  int order_of_size(Face_index f) const
  {
    return has_small_angle(f) ? half_octave(length(shortest_side(f))) : (std::numeric_limits<int>::max)();
  }
  void note(Face_index f)
  {
    if (is_bad(f))
      bad_faces_.push({order_of_size(f), circumradius(f), f});
  }

  // A corner of the input between two segments can force a small angle opposite to an edge between points at the same distance from it.
  // (G. Miller, S. Pav, N. Walkington, "When and why Ruppert's algorithm works", 2003.)
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
        if (g.is_valid() && k.is_valid() && g != k && input.source(g) == input.source(k) && std::abs(d - e) < 1e-9 * d &&
            small_corners_.count(input.source(g)) != 0)
          return true;
    return false;
  }

  // An edge is encroached if an opposite angle is larger than a right one.
  bool is_encroached(Edge_index e) const
  {
    for (Halfedge_index h : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(h)) {
        const double a = length(complex_.next(h)) / length(h), b = length(complex_.prev(h)) / length(h);
        if (a * a + b * b < 1)
          return true;
      }
    return false;
  }

  // Faces without area are left at the border and at constrained edges: their longest side is one. They are kept as they are.
  void fix_faces_without_area()
  {
    for (Face_index f : complex_.faces())
      if (!has_area(triangulation_, f)) {
        const Halfedge_index h = complex_.halfedge(f);
        for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
          is_segment_[complex_.edge(side).idx()] = has_segments_ = true;
      }
  }

  void find_cones()
  {
    std::vector<double> sum(complex_.number_of_vertices(), 0);
    std::vector<bool> is_on_border(complex_.number_of_vertices(), false);
    for (Halfedge_index h : complex_.halfedges())
      if (complex_.is_border(h))
        is_on_border[complex_.source(h).idx()] = true;
    for (Face_index f : complex_.faces()) {
      const Halfedge_index ij = longest_side(f);
      const Plane_point z = apex(ij);
      const double at_i = std::atan2(z.imag(), z.real()), at_j = std::atan2(z.imag(), 1 - z.real());
      sum[complex_.source(ij).idx()] += at_i;
      sum[complex_.target(ij).idx()] += at_j;
      sum[complex_.source(complex_.prev(ij)).idx()] += CGAL_PI - at_i - at_j;
    }
    for (Vertex_index v : complex_.vertices()) {
      if (!complex_.halfedge(v).is_valid() || correspondence_.is_inserted(v))
        continue;
      if (!is_on_border[v.idx()] && sum[v.idx()] < smallest_whole_cone && !(has_segments_ && has_segment(v)))
        cones_.add(v, sum[v.idx()]);
      if (has_segments_ && has_small_corner(v))
        small_corners_.emplace(v, true);
    }
  }
  bool has_segment(Vertex_index v) const
  {
    const Halfedge_index first = complex_.halfedge(v);
    Halfedge_index h = first;
    do {
      if (is_segment(h))
        return true;
      h = complex_.next_around_target(h);
    } while (h != first);
    return false;
  }
  // Whether two segments meet at v in less than 60 degrees.
  bool has_small_corner(Vertex_index v) const
  {
    const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    Halfedge_index h = first;
    do {
      if (is_segment(h)) {
        double sum = 0;
        for (Halfedge_index side = h; !complex_.is_border(side);) {
          sum += angle(side);
          side = complex_.next_around_source(side);
          if (is_segment(side)) {
            if (sum < smallest_whole_cone)
              return true;
            break;
          }
        }
      }
      h = complex_.next_around_source(h);
    } while (h != first);
    return false;
  }

  // A vertex close to a small cone makes a triangle around it that no other vertex disturbs: those that would lie in its circumcircle are
  // not inserted.
  void protect_cones()
  {
    for (Vertex_index v : cones_.vertices()) {
      const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
      Halfedge_index nearest = first, h = first;
      while ((h = complex_.next_around_source(h)) != first)
        if (length(h) < length(nearest))
          nearest = h;
      const double radius = (std::min)(length(nearest) / 3, cones_.radius_of_input_faces(v) / 2);
      const double t = radius / length(nearest);
      const auto place = point_on_input(complex_, geometry_, shapes_, nearest, {1 - t, t, 0}, [&](Halfedge_index x) { return apex(x); });
      if (!(t > 0) || !place)
        continue;
      const std::optional<Vertex_index> p = insert(*place);
      if (!p)
        continue;
      Halfedge_index to_p = complex_.halfedge(*p);
      const Halfedge_index last = to_p;
      while (complex_.source(to_p) != v && (to_p = complex_.next_around_target(to_p)) != last) {
      }
      if (complex_.source(to_p) == v)
        cones_.protect(v, length(to_p));
    }
  }
  // Inserts a vertex for a face, or splits the segment that is in the way.
  void refine(Face_index f)
  {
    if (const std::optional<Walk_end> end = walk_to_off_center(f))
      if (!insert_or_split(f, end))
        return;
    if (const std::optional<Refinement_obstacle> reason = refine_at_circumcenter(f))
      left_[f] = {circumradius(f), *reason};
  }

  // A vertex on the bisector of the shortest side ij makes a triangle with that whose angles are large enough already if it is as close as this.
  // It needs no circumcenter farther away, and leaves more room (A. Ungor). The factor is 1 for an angle that just meets the bound; others need fewer vertices.
  std::optional<Walk_end> walk_to_off_center(Face_index f) const
  {
    const Halfedge_index h = shortest_side(f);
    const Plane_point z = apex(h);
    const double farthest = 0.85 / (2 * std::tan(criteria_.minimum_angle / 360 * CGAL_PI));
    if (!(std::norm(z) - z.real() > farthest * 2 * z.imag()) || !(z.imag() > 0) || !is_to_be_enlarged(complex_.prev(h)))
      return std::nullopt;
    return walk(h, Plane_point(0.5, farthest));
  }

  // \return why that cannot be done, if so
  std::optional<Refinement_obstacle> refine_at_circumcenter(Face_index f)
  {
    const Halfedge_index h = longest_side(f);
    const Plane_point z = apex(h);
    // Far outside, the height is of no importance.
    constexpr double farthest = 64;
    const double below = std::abs(z) * std::abs(z) - z.real(), height = 2 * z.imag();
    const double y = below <= -farthest * height ? -farthest : below / height;
    if (y >= 0)
      return insert_or_split(f, walk(h, {0.5, y}));
    if (is_segment(h))
      return split(f, complex_.edge(h));
    return insert_or_split(f, walk(complex_.opposite(h), {0.5, -y}));
  }
  // From the middle of h to a point in the frame of h, if that is not too far.
  std::optional<Walk_end> walk(Halfedge_index h, Plane_point end) const
  {
    return walk_straight(
      complex_, h, 0.5, end, false, [&](Halfedge_index g) { return apex(g); }, [&](Edge_index e) { return is_segment_[e.idx()]; });
  }
  std::optional<Refinement_obstacle> insert_or_split(Face_index f, const std::optional<Walk_end>& end)
  {
    if (!end)
      return Refinement_obstacle::UNREPRESENTABLE;
    if (end->barrier.is_valid())
      return split(f, complex_.edge(end->barrier));
    if (const std::optional<Edge_index> e = encroached_by(*end))
      return split(f, *e);
    const auto place = point_on_input(complex_, geometry_, shapes_, end->halfedge, end->weights, [&](Halfedge_index g) { return apex(g); });
    if (!place)
      return Refinement_obstacle::UNREPRESENTABLE;
    if (cones_.is_too_close(place->point))
      return Refinement_obstacle::CONE;
    if (is_too_fine(f, place->point) || !insert(*place))
      return Refinement_obstacle::UNREPRESENTABLE;
    return std::nullopt;
  }
  std::optional<Refinement_obstacle> split(Face_index f, Edge_index e)
  {
    if (complex_.is_self_glued(e))
      return insert_at_centroid(complex_.face(complex_.halfedge(e)));
    if (!split_segment(e))
      return Refinement_obstacle::UNREPRESENTABLE;
    note(f);
    return std::nullopt;
  }
  // A segment with the same face on both sides has different ones then: the edge from the new vertex to the tip of that face is Delaunay, since
  // the angles opposite to it are smaller than those at the base.
  std::optional<Refinement_obstacle> insert_at_centroid(Face_index f)
  {
    const auto place = point_on_input(complex_, geometry_, shapes_, complex_.halfedge(f), {1. / 3, 1. / 3, 1. / 3}, [&](Halfedge_index g) { return apex(g); });
    if (!place || is_too_fine(f, place->point) || !insert(*place))
      return Refinement_obstacle::UNREPRESENTABLE;
    return std::nullopt;
  }
  // Whether the face is so small that coordinates in the input face are too coarse.
  bool is_too_fine(Face_index f, const Surface_point& point) const
  {
    const Delta_complex& input = correspondence_.input();
    double size = 0;
    for (Halfedge_index h : {point.halfedge, input.next(point.halfedge), input.prev(point.halfedge)})
      size = (std::max)(size, shapes_.length(input.edge(h)));
    return circumradius(f) < std::ldexp(size, geometry_.metric().unit_exponent() - 46);
  }

  // A segment that a vertex at this point would encroach on: among those that bound the triangles with the point in their circumcircles.
  std::optional<Edge_index> encroached_by(const Walk_end& end)
  {
    if (!has_segments_)
      return std::nullopt;
    struct Side
    {
      Halfedge_index halfedge;
      Plane_point point;
    };
    std::vector<Side> sides{{end.halfedge, end.weights[1] + end.weights[2] * apex(end.halfedge)}};
    const auto push_others = [&](Side s, Plane_point z) {
      sides.push_back({complex_.next(s.halfedge), (s.point - 1.) / (z - 1.)});
      sides.push_back({complex_.prev(s.halfedge), (s.point - z) / -z});
    };
    push_others(sides[0], apex(end.halfedge));
    for (std::size_t i = 0; i < sides.size() && i < 300; ++i) {
      const Side s = sides[i];
      if (is_segment(s.halfedge)) {
        if (std::real(s.point * std::conj(s.point - 1.)) < 0)
          return complex_.edge(s.halfedge);
        continue;
      }
      const Side behind{complex_.opposite(s.halfedge), 1. - s.point};
      const Plane_point z = apex(behind.halfedge), center(0.5, (std::norm(z) - z.real()) / (2 * z.imag()));
      if (std::norm(behind.point - center) < std::norm(center))
        push_others(behind, z);
    }
    return std::nullopt;
  }

  // \return nothing if a vertex lies there
  std::optional<Vertex_index> insert(const Point_to_insert& place)
  {
    if (!(shapes_.four_areas(correspondence_.input().face(place.point.halfedge)) > 0))
      return std::nullopt;
    const Triangle_piece piece = Piece_search(complex_, geometry_)(place.start, place.point);
    if (vertex_at(complex_, correspondence_, piece.side, place.point))
      return std::nullopt;
    const Vertex_index v = triangulation_.split_face(piece, place.point);
    ++report_.insertions;
    settle(v);
    return v;
  }

  // \return whether there is a point to split it at
  bool split_segment(Edge_index e)
  {
    const Delta_complex& input = correspondence_.input();
    if (!correspondence_.coordinates().is_original(e) || complex_.is_self_glued(e) || side_without_area(triangulation_, e))
      return false;
    Halfedge_index h = complex_.halfedge(e), along = correspondence_.input_halfedge(h);
    if (input.is_border(along)) {
      h = complex_.opposite(h);
      along = input.opposite(along);
    }
    const auto position = [&](Vertex_index v, double at_vertex) {
      if (!correspondence_.is_inserted(v))
        return at_vertex;
      const auto [a, b] = coordinates_on_edge(input, correspondence_.location(v), along);
      return b / (a + b);
    };
    const double begin = position(complex_.source(h), 0), end = position(complex_.target(h), 1);
    const double t = std::ldexp(std::nearbyint(std::ldexp(split_position(h, begin, end), 52)), -52);
    if (!(begin < t && t < end))
      return false;
    const Vertex_index v = triangulation_.split_edge(h, Surface_point{along, {1 - t, t, 0}});
    ++report_.segment_splits;
    is_segment_.resize(complex_.number_of_edges(), false);
    // Of the edges that lead to the new vertex, these are its parts.
    const Halfedge_index first = complex_.halfedge(v);
    Halfedge_index g = first;
    do {
      if (correspondence_.coordinates().is_original(complex_.edge(g)))
        is_segment_[complex_.edge(g).idx()] = true;
      g = complex_.next_around_target(g);
    } while (g != first);
    settle(v);
    return true;
  }
  // Halfway, but at a distance that is a power of two from a corner where two segments meet in a small angle: so they are split at the same
  // distances from it.
  double split_position(Halfedge_index h, double begin, double end) const
  {
    const bool at_source = small_corners_.count(complex_.source(h)) != 0, at_target = small_corners_.count(complex_.target(h)) != 0;
    if (at_source == at_target)
      return (begin + end) / 2;
    const double l = length(h);
    double shell = std::exp2(std::floor(std::log2(l)));
    while (shell > 2 * l / 3)
      shell /= 2;
    const double part = shell / l * (end - begin);
    return at_source ? begin + part : end - part;
  }

  void settle(Vertex_index v)
  {
    is_segment_.resize(complex_.number_of_edges(), false);
    flipped_.clear();
    const auto is_fixed = boost::make_function_property_map<Edge_index, bool>([&](Edge_index e) { return is_segment_[e.idx()]; });
    report_.flips += settle_around(triangulation_, v, is_fixed, stack_, [&](Edge_index e) { flipped_.push_back(e); });
    visitor_.after_insertion(v);
    lengths_.resize(complex_.number_of_edges());
    measure_star(v);
    const auto is_at_v = [&](Edge_index e) { return complex_.source(complex_.halfedge(e)) == v || complex_.target(complex_.halfedge(e)) == v; };
    flipped_.erase(std::remove_if(flipped_.begin(), flipped_.end(), is_at_v), flipped_.end());
    for (Edge_index e : flipped_)
      measure(e);
    const Halfedge_index first = complex_.halfedge(v);
    Halfedge_index h = first;
    const auto note_faces = [&](Halfedge_index h) {
      if (!complex_.is_border(h))
        note(complex_.face(h));
    };
    do {
      note_faces(h);
      if (criteria_.splits_encroached_edges)
        for (Halfedge_index side : {h, complex_.prev(h)})
          if ((side == h || !complex_.is_border(h)) && is_segment(side))
            segments_.push_back(complex_.edge(side));
      h = complex_.next_around_target(h);
    } while (h != first);
    for (Edge_index e : flipped_)
      for (Halfedge_index side : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
        note_faces(side);
  }

  void list_unrefined_faces()
  {
    for (Face_index f : complex_.faces()) {
      const Halfedge_index h = complex_.halfedge(f);
      bool is_below = is_too_large(f);
      if (!is_below && !has_small_angle(f))
        continue;
      std::optional<Refinement_obstacle> reason;
      for (Halfedge_index corner : {h, complex_.next(h), complex_.prev(h)})
        if (is_too_small(angle(corner))) {
          is_below = true;
          if (const auto obstacle = obstacle_at(corner))
            reason = obstacle;
          else if (is_between_shells(complex_.next(corner)))
            reason = Refinement_obstacle::SMALL_INPUT_ANGLE;
        }
      if (!is_below)
        continue;
      const auto left = left_.find(f);
      if (left != left_.end() && left->second.first == circumradius(f))
        reason = left->second.second;
      report_.unrefined.push_back({f, reason.value_or(Refinement_obstacle::BUDGET)});
    }
  }

  Triangulation& triangulation_;
  const Delta_complex& complex_;
  const Exact_geometry& geometry_;
  const Correspondence& correspondence_;
  const Input_shapes shapes_;
  const Refinement_criteria criteria_;
  std::vector<bool> is_segment_;
  std::vector<double> lengths_; // of the edges, in the unit of the input
  Visitor& visitor_;
  const std::uint64_t maximum_number_;
  bool has_segments_;
  Refinement_report report_;
  std::priority_queue<Candidate> bad_faces_;
  std::vector<Edge_index> segments_, stack_, flipped_;
  Small_cones cones_;
  const double sine_of_minimum_angle_;
  std::unordered_map<Vertex_index, bool> small_corners_;
  std::unordered_map<Face_index, std::pair<double, Refinement_obstacle>> left_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delaunay refinement: Ruppert's algorithm on a surface, with vertices that protect small cones.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Face_quality.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Steiner_point_search.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/settle_around.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/number_type_config.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A run that may be discarded. It ends when a larger minimum size may need far fewer vertices.
struct Refinement_trial
{
  double size = 0; // new vertices with a shorter edge are counted; 0 if this is not a trial
  std::uint64_t maximum_number = (std::numeric_limits<std::uint64_t>::max)(); // of them
};

// Segments are the edges that are not flipped: on the border, constrained, or whole.
template <class Traits, class Visitor>
class Delaunay_refiner
{
public:
  using Triangulation = Intrinsic_triangulation<Traits>;

  Delaunay_refiner(Triangulation& triangulation, const Refinement_criteria& criteria, std::vector<bool> is_segment,
                   const std::vector<bool>& is_whole, Visitor& visitor, std::uint64_t maximum_number,
                   const Refinement_trial& trial)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), engine_(engine(triangulation)),
      correspondence_(engine_.correspondence()), shapes_(engine_), visitor_(visitor), maximum_number_(maximum_number),
      trial_(trial), faces_(triangulation),
      segments_(complex_, correspondence_, shapes_, faces_, std::move(is_segment), is_whole), cones_(engine_, shapes_),
      straight_(engine_, shapes_), sizes_(engine_, criteria.sizes, criteria.maximum_edge_length),
      quality_(complex_, criteria, faces_, segments_, cones_, straight_, sizes_),
      search_(complex_, faces_, segments_, quality_)
  {}

  // \exception Too_many_vertices_error if about that many are needed, and more than these
  Refinement_report operator()(std::uint64_t most_vertices)
  {
    report_.minimum_size = quality_.criteria().minimum_size;
    faces_.measure_all();
    for (Edge_index e : complex_.edges())
      measure_deviation(e);
    if (const double number = number_for_sizes(); number > double(most_vertices))
      throw Too_many_vertices_error(std::uint64_t((std::min)(number, 1e18)), most_vertices);
    refine_all();
    return std::move(report_);
  }

  // About how many vertices faces need that are too large, by their areas and longest sides. Before refinement, they must
  // have been measured.
  double number_for_sizes() const
  {
    double sum = 0;
    for (Face_index f : complex_.faces()) {
      if (!quality_.is_too_large(f) || left_.count(f) != 0)
        continue;
      const Halfedge_index h = faces_.longest_side(f);
      const Vertex_index a = complex_.source(h), b = complex_.target(h);
      const double r = quality_.criteria().maximum_circumradius;
      const double inside = (std::max)(sizes_.number_of_vertices({a, b, complex_.target(complex_.next(h))}, area(f)),
                                       Edge_sizes::number_of_vertices(area(f), std::sqrt(3.) * r));
      // Each face has half a vertex, and each edge belongs to two faces.
      sum += (std::max)({0., inside - 0.5, (faces_.length(h) / sizes_.longest_between(a, b) - 1) / 2});
    }
    return sum;
  }

  // The number of new vertices that had an edge shorter than the size of the trial when inserted.
  std::uint64_t number_of_close_vertices() const { return number_of_close_vertices_; }
  // Whether they were too many. Then nothing is listed.
  bool is_given_up() const { return number_of_close_vertices_ > trial_.maximum_number; }

  // Asks the visitor once more within a step.
  bool asks_further()
  {
    return visitor_.go_further(Progress{0, 0, report_.flips, report_.insertions + report_.segment_splits});
  }

private:
  void refine_all()
  {
    fix_faces_without_area();
    find_cones();
    if (goes_on())
      protect_cones();
    if (quality_.criteria().splits_encroached_edges)
      for (Edge_index e : complex_.edges())
        if (segments_.contains(e))
          segments_to_test_.push_back(e);
    for (Face_index f : complex_.faces())
      note(f);
    while (has_candidates() && goes_on()) {
      if (!segments_to_test_.empty()) {
        const Edge_index e = segments_to_test_.back();
        segments_to_test_.pop_back();
        if (segments_.is_encroached(e) && faces_.length(e) >= 2 * quality_.criteria().minimum_size)
          split_segment(e);
        continue;
      }
      const Candidate candidate = bad_faces_.top();
      bad_faces_.pop();
      if (quality_.is_bad(candidate.face) && faces_.circumradius(candidate.face) == candidate.radius) {
        if constexpr (!Visitor::Is_silent::value)
          tell_progress(candidate.face);
        refine(candidate.face);
      }
    }
    if (!is_given_up())
      list_unrefined_faces();
  }

  static constexpr double smallest_whole_cone = CGAL_PI / 3;
  // Maximum walk length in edges: a longer walk is circling a needle thinner than the face. A vertex there lies in the
  // circumcircle of the face, too, and no closer to its corners than half of a side.
  static constexpr std::size_t farthest_walk = std::size_t(1) << 14;

  // Faces with a small angle come first, in the order of their shortest sides: a vertex near a short side improves
  // faces with longer ones, too (A. Ungor, "Off-centers", 2009). Among faces with sides of the same size up to a fourth
  // root of two, and among those that are only too large, the largest is next: edges around it cross the fewest small
  // faces.
  struct Candidate
  {
    int order_of_size; // of the shortest side, in fourth roots of two, if an angle is small
    double radius;     // of the circumcircle
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

  bool has_candidates() const { return !segments_to_test_.empty() || !bad_faces_.empty(); }
  bool goes_on()
  {
    if (report_.status != Refinement_status::REFINED || is_given_up())
      return false;
    if (!asks_further())
      throw Cancelled_error("the refinement was cancelled");
    if (report_.insertions + report_.segment_splits >= maximum_number_ && has_candidates())
      report_.status = Refinement_status::BUDGET_EXHAUSTED;
    return report_.status == Refinement_status::REFINED;
  }

  void tell_progress(Face_index next)
  {
    progress_.points = report_.insertions + report_.segment_splits;
    progress_.waiting_faces = bad_faces_.size() + 1;
    progress_.face = next;
    progress_.size = faces_.length(faces_.shortest_side(next));
    progress_.minimum_size = quality_.criteria().minimum_size;
    progress_.is_on_trial = progress_.size < trial_.size;
    if (progress_.points >= next_estimate_) {
      progress_.estimated_points = estimated_points();
      while (next_estimate_ <= progress_.points)
        next_estimate_ *= 2;
    }
    visitor_.before_step(progress_);
  }
  // With thin faces that have sides of the present size.
  std::uint64_t estimated_points() const
  {
    double sum = number_for_sizes();
    for (Face_index f : complex_.faces())
      if (const double s = faces_.length(faces_.shortest_side(f));
          s < 2 * progress_.size && quality_.is_bad(f) && left_.count(f) == 0 && !quality_.is_too_large(f))
        sum += area(f) / (2 * s * s);
    return static_cast<std::uint64_t>((std::min)(sum, 1e18));
  }
  double area(Face_index f) const
  {
    const Halfedge_index h = faces_.longest_side(f);
    return faces_.length(h) * faces_.length(h) * faces_.apex(h).imag() / 2;
  }

  void measure_deviation(Edge_index e)
  {
    if (std::isfinite(quality_.criteria().maximum_deviation))
      straight_.measure(e);
  }

  void note(Face_index f)
  {
    if (!quality_.is_bad(f))
      return;
    const double shortest = (std::max)(faces_.length(faces_.shortest_side(f)), (std::numeric_limits<double>::min)());
    int order_of_size = (std::numeric_limits<int>::max)();
    if (quality_.has_small_angle(f)) { // sides are often nearly powers of two, which the unit of length must not round
      int exponent;
      const double part = std::frexp(shortest, &exponent);
      order_of_size = 4 * exponent + static_cast<int>(std::floor(4 * std::log2(part)));
    }
    bad_faces_.push({order_of_size, faces_.circumradius(f), f});
  }

  // Faces without area remain at the border and at constrained edges, where their longest side is such an edge. They
  // are kept as they are.
  void fix_faces_without_area()
  {
    for (Face_index f : complex_.faces())
      if (!has_positive_area(triangulation_, f)) {
        const Halfedge_index h = complex_.halfedge(f);
        for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
          segments_.add(complex_.edge(side));
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
      const Halfedge_index ij = faces_.longest_side(f);
      const Plane_point z = faces_.apex(ij);
      const double at_i = std::atan2(z.imag(), z.real()), at_j = std::atan2(z.imag(), 1 - z.real());
      sum[complex_.source(ij).idx()] += at_i;
      sum[complex_.target(ij).idx()] += at_j;
      sum[complex_.source(complex_.prev(ij)).idx()] += CGAL_PI - at_i - at_j;
    }
    for (Vertex_index v : complex_.vertices()) {
      if (!complex_.halfedge(v).is_valid() || correspondence_.is_inserted(v))
        continue;
      if (!is_on_border[v.idx()] && sum[v.idx()] < smallest_whole_cone &&
          (segments_.is_empty() || !segments_.has_segment(v)))
        cones_.add(v, sum[v.idx()]);
      segments_.find_small_corner(v);
    }
  }
  // A vertex close to a small cone makes a triangle around it that no other vertex disturbs: vertices in its
  // circumcircle are not inserted.
  void protect_cones()
  {
    for (Vertex_index v : cones_.vertices()) {
      const Halfedge_index first = complex_.opposite(complex_.halfedge(v));
      Halfedge_index nearest = first, h = first;
      while ((h = complex_.next_around_source(h)) != first)
        if (faces_.length(h) < faces_.length(nearest))
          nearest = h;
      const double radius =
        (std::min)(faces_.length(nearest) / 3, quality_.radius_of_protected_cone(v, cones_.radius_of_input_faces(v)));
      const double t = radius / faces_.length(nearest);
      const auto place =
        point_on_input(engine_, shapes_, nearest, {1 - t, t, 0}, [&](Halfedge_index x) { return faces_.apex(x); });
      if (!(t > 0) || !place)
        continue;
      const std::optional<Vertex_index> p = insert(*place);
      if (!p)
        continue;
      for (Halfedge_index to_p : Halfedges_around(complex_, *p))
        if (complex_.source(to_p) == v) {
          cones_.protect(v, faces_.length(to_p));
          break;
        }
    }
  }
  // Inserts a vertex for a face, or splits the segment that is in the way.
  void refine(Face_index f)
  {
    if (const std::optional<Walk_end> end = walk_to_better_point(f))
      if (!insert_or_split(f, *end))
        return;
    if (const std::optional<Refinement_obstacle> reason = refine_at_circumcenter(f))
      left_[f] = {faces_.circumradius(f), *reason};
  }

  // The walk to a place where a vertex enlarges the smallest angle, if needed.
  std::optional<Walk_end> walk_to_better_point(Face_index f)
  {
    const Halfedge_index h = faces_.shortest_side(f);
    if (!(faces_.apex(h).imag() > 0) || !quality_.is_to_be_enlarged(complex_.prev(h)))
      return std::nullopt;
    return walk(h, search_(h));
  }

  // \return why that is impossible, if so
  std::optional<Refinement_obstacle> refine_at_circumcenter(Face_index f)
  {
    const Halfedge_index h = faces_.longest_side(f);
    const Plane_point z = faces_.apex(h);
    // Far outside, the height does not matter.
    constexpr double farthest = 64;
    const double below = std::abs(z) * std::abs(z) - z.real(), height = 2 * z.imag();
    const double y = below <= -farthest * height ? -farthest : below / height;
    if (y >= 0)
      return insert_or_split(f, walk(h, {0.5, y}));
    if (segments_.contains(h))
      return split(f, complex_.edge(h));
    return insert_or_split(f, walk(complex_.opposite(h), {0.5, -y}));
  }
  // From the middle of h to a point in the frame of h, or until the walk is too far.
  Walk_end walk(Halfedge_index h, Plane_point end) const
  {
    return walk_straight(
      complex_, h, 0.5, end, false, [&](Halfedge_index g) { return faces_.apex(g); },
      [&](Edge_index e) { return segments_.contains(e); }, farthest_walk);
  }
  std::optional<Refinement_obstacle> insert_or_split(Face_index f, const Walk_end& end)
  {
    if (end.barrier.is_valid())
      return split(f, complex_.edge(end.barrier));
    if (const std::optional<Edge_index> e = segments_.encroached_by(end, std::tan(quality_.minimum_angle())))
      return split(f, *e);
    const auto place =
      point_on_input(engine_, shapes_, end.halfedge, end.weights, [&](Halfedge_index g) { return faces_.apex(g); });
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
    if (segments_.is_whole(e))
      return Refinement_obstacle::WHOLE_EDGE;
    if (complex_.is_self_glued(e))
      return insert_at_centroid(complex_.face(complex_.halfedge(e)));
    if (!split_segment(e))
      return Refinement_obstacle::UNREPRESENTABLE;
    note(f);
    return std::nullopt;
  }
  // A segment with the same face on both sides then has different ones: the edge from the new vertex to the tip of that
  // face is Delaunay, since its opposite angles are smaller than those at the base.
  std::optional<Refinement_obstacle> insert_at_centroid(Face_index f)
  {
    const auto place = point_on_input(engine_, shapes_, complex_.halfedge(f), {1. / 3, 1. / 3, 1. / 3},
                                      [&](Halfedge_index g) { return faces_.apex(g); });
    if (!place || is_too_fine(f, place->point) || !insert(*place))
      return Refinement_obstacle::UNREPRESENTABLE;
    return std::nullopt;
  }
  // Whether the face is so small that coordinates in the input face are too coarse.
  bool is_too_fine(Face_index f, const Surface_point& point)
  {
    const Delta_complex& input = correspondence_.input();
    double size = 0;
    for (Halfedge_index h : {point.halfedge, input.next(point.halfedge), input.prev(point.halfedge)})
      size = (std::max)(size, shapes_.length(input.edge(h)));
    return faces_.circumradius(f) < std::ldexp(size, engine_.metric().unit_exponent() - 46);
  }

  // \return nothing if a vertex lies there
  std::optional<Vertex_index> insert(const Point_to_insert& place)
  {
    if (!(shapes_.four_areas(correspondence_.input().face(place.point.halfedge)) > 0))
      return std::nullopt;
    const Triangle_piece piece = piece_of_point(engine_, place.start, place.point);
    if (vertex_at(complex_, correspondence_, piece.side, place.point))
      return std::nullopt;
    const Vertex_index v = Whole_triangulation<Traits>(triangulation_).split_face(piece, place.point);
    ++report_.insertions;
    settle(v);
    return v;
  }

  // \return whether there is a point to split it at
  bool split_segment(Edge_index e)
  {
    const Delta_complex& input = correspondence_.input();
    if (segments_.is_whole(e) || !correspondence_.coordinates().is_original(e) || complex_.is_self_glued(e) ||
        side_without_area(triangulation_, e))
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
    const double t = std::ldexp(std::nearbyint(std::ldexp(segments_.split_position(h, begin, end), 52)), -52);
    if (!(begin < t && t < end))
      return false;
    const Vertex_index v =
      Whole_triangulation<Traits>(triangulation_).split_edge(h, Surface_point{along, {1 - t, t, 0}});
    ++report_.segment_splits;
    segments_.resize();
    // The edges to the new vertex that are parts of the segment.
    for (Halfedge_index g : Halfedges_around(complex_, v))
      if (correspondence_.coordinates().is_original(complex_.edge(g)))
        segments_.add(complex_.edge(g));
    settle(v);
    return true;
  }
  void settle(Vertex_index v)
  {
    segments_.resize();
    flipped_.clear();
    const auto is_fixed =
      boost::make_function_property_map<Edge_index, bool>([&](Edge_index e) { return segments_.contains(e); });
    settle_around(triangulation_, v, is_fixed, stack_, [&](Edge_index e) {
      ++report_.flips;
      flipped_.push_back(e);
    });
    if (trial_.size == 0)
      visitor_.after_insertion(v);
    sizes_.add_vertices();
    faces_.measure_star(v);
    const auto is_at_v = [&](Edge_index e) {
      return complex_.source(complex_.halfedge(e)) == v || complex_.target(complex_.halfedge(e)) == v;
    };
    flipped_.erase(std::remove_if(flipped_.begin(), flipped_.end(), is_at_v), flipped_.end());
    for (Edge_index e : flipped_) {
      faces_.measure(e);
      measure_deviation(e);
    }
    for (Halfedge_index h : Halfedges_around(complex_, v))
      measure_deviation(complex_.edge(h));
    const auto note_faces = [&](Halfedge_index h) {
      if (!complex_.is_border(h))
        note(complex_.face(h));
    };
    bool is_close = false;
    for (Halfedge_index h : Halfedges_around(complex_, v)) {
      is_close = is_close || faces_.length(h) < trial_.size;
      note_faces(h);
      if (quality_.criteria().splits_encroached_edges)
        for (Halfedge_index side : {h, complex_.prev(h)})
          if ((side == h || !complex_.is_border(h)) && segments_.contains(side))
            segments_to_test_.push_back(complex_.edge(side));
    }
    number_of_close_vertices_ += is_close;
    for (Edge_index e : flipped_)
      for (Halfedge_index side : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
        note_faces(side);
  }

  void list_unrefined_faces()
  {
    for (Face_index f : complex_.faces()) {
      const Halfedge_index h = complex_.halfedge(f);
      bool is_below = quality_.is_too_large(f);
      if (!is_below && !quality_.has_small_angle(f))
        continue;
      std::optional<Refinement_obstacle> reason;
      for (Halfedge_index corner : {h, complex_.next(h), complex_.prev(h)})
        if (quality_.is_too_small(faces_.angle(corner))) {
          is_below = true;
          if (const auto obstacle = quality_.obstacle_at(corner))
            reason = obstacle;
          else if (!reason && segments_.is_between_shells(complex_.next(corner)))
            reason = Refinement_obstacle::BESIDE_SMALL_INPUT_ANGLE;
        }
      if (!is_below)
        continue;
      const auto left = left_.find(f);
      if (left != left_.end() && left->second.first == faces_.circumradius(f))
        reason = left->second.second;
      if (!reason && quality_.is_below_smallest_size(f))
        reason = Refinement_obstacle::TOO_SMALL;
      for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
        if (!reason && segments_.is_whole(complex_.edge(side)))
          reason = Refinement_obstacle::WHOLE_EDGE;
      report_.unrefined.push_back(
        {f, reason.value_or(report_.status == Refinement_status::REFINED ? Refinement_obstacle::UNREPRESENTABLE
                                                                         : Refinement_obstacle::BUDGET)});
    }
  }

  Triangulation& triangulation_;
  const Delta_complex& complex_;
  const Exact_engine& engine_;
  const Correspondence& correspondence_;
  Input_shapes shapes_;
  Visitor& visitor_;
  const std::uint64_t maximum_number_;
  const Refinement_trial trial_;
  std::uint64_t number_of_close_vertices_ = 0;
  Measured_faces<Traits> faces_;
  Segments<Traits> segments_;
  Refinement_report report_;
  Refinement_progress progress_;
  std::uint64_t next_estimate_ = 1024;
  std::priority_queue<Candidate> bad_faces_;
  std::vector<Edge_index> segments_to_test_, stack_, flipped_;
  Small_cones cones_;
  Straight_edges straight_;
  Edge_sizes sizes_;
  const Face_quality<Traits> quality_;
  Steiner_point_search<Traits> search_;
  std::unordered_map<Face_index, std::pair<double, Refinement_obstacle>> left_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_DELAUNAY_REFINER_H

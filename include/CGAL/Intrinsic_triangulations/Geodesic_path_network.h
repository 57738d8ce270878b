// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Paths and closed curves along intrinsic edges, shortened by flips until they are geodesics.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_NETWORK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_NETWORK_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Linked_paths.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Wedge.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsGeodesics
///
/// \brief paths and closed curves along the edges of an intrinsic triangulation, which flips shorten until they are
/// locally shortest.
///
/// Where the angle on one side of an inner vertex is less than π, edges in between are flipped until the way round the
/// vertex is shorter. This comparison is exact, and an angle of exactly π is straight; so a path that is reported as a
/// geodesic is one. Paths may use the same edges, in any direction. They move independently of each other, but edges of
/// the network are never flipped: a path that can only be shortened across another, which does not move away, is
/// blocked. Paths stay on their side of constrained edges and of the border: an angle with such an edge inside counts
/// as straight.
///
/// The triangulation is flipped, but stays a triangulation of the same surface. Do not change it by other means while
/// the network exists: insert vertices first. Until it is rewound, a network keeps some 200 bytes for each flip.
///
/// \tparam Traits traits with exact geometry, such as `Filtered_edge_length_traits`
///
/// Source: N. Sharp, K. Crane, "You can find geodesic paths in triangle meshes by just flipping edges" (2020). The
/// exact decisions, the proof of termination (doc/termination.md) and the treatment of loops are ours.
template <class Traits>
class Geodesic_path_network
{
  static_assert(Traits::Uses_exact_geometry::value, "geodesics need traits that use exact geometry");

public:
  /// the triangulation
  using Triangulation = Intrinsic_triangulation<Traits>;

  /// \brief constructs a network without paths.
  /// \param triangulation is flipped by `shorten()` and must outlive the network
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{edge_is_constrained_map}
  ///     \cgalParamDescription{which edges paths must not cross; copied}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key and `bool` as value}
  ///     \cgalParamDefault{none}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Geodesic_path_network(Triangulation& triangulation, const NamedParameters& np = parameters::default_values())
    : triangulation_(triangulation), geometry_(triangulation), paths_(complex()),
      is_fixed_(complex().number_of_vertices(), false)
  {
    if constexpr (internal::has_edge_constraints<NamedParameters>)
      is_constrained_ = [map = internal::edge_constraints_of(np)](Edge_index e) { return bool(get(map, e)); };
  }
  /// \cond SKIP_IN_MANUAL
  Geodesic_path_network(const Geodesic_path_network&) = delete;
  Geodesic_path_network& operator=(const Geodesic_path_network&) = delete;
  /// \endcond

  /// \brief adds a path with fixed ends.
  /// \param halfedges a range of halfedges, each of which begins where the previous one ends
  /// \return the number of the path: 0, 1, 2, ...
  /// \exception Invalid_argument_error if there is no such halfedge, or one begins elsewhere
  template <class HalfedgeRange>
  std::size_t add_path(const HalfedgeRange& halfedges)
  {
    return add(std::vector<Halfedge_index>(std::begin(halfedges), std::end(halfedges)), false);
  }
  /// \brief adds a closed curve.
  ///
  /// \param halfedges as for `add_path()`; the first begins where the last ends
  /// \return the number of the path
  /// \exception Invalid_argument_error as `add_path()`, or if the curve is not closed
  template <class HalfedgeRange>
  std::size_t add_closed_path(const HalfedgeRange& halfedges)
  {
    return add(std::vector<Halfedge_index>(std::begin(halfedges), std::end(halfedges)), true);
  }

  /// fixes a vertex: paths through it keep passing through it.
  void fix(Vertex_index v) { is_fixed_[v.idx()] = true; }

  /// \brief undoes all flips, and removes all paths and fixed vertices: network and triangulation are as they were when
  /// the network was constructed.
  ///
  /// So one triangulation serves many paths. Never throws. O(number of flips).
  void rewind()
  {
    geometry_.flips().undo(0);
    paths_.clear();
    outcomes_.clear();
    std::fill(is_fixed_.begin(), is_fixed_.end(), false);
  }

  /// \brief shortens all paths until they are locally shortest.
  ///
  /// \tparam NamedParameters a sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamVisitor{is called after each flip and can cancel; pass `std::ref()` to keep its state}
  ///   \cgalParamNBegin{maximum_number}
  ///     \cgalParamDescription{the number of flips after which the algorithm gives up}
  ///     \cgalParamType{`std::uint64_t`}
  ///     \cgalParamDefault{unlimited: the algorithm ends}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \return the report. With any status, triangulation and paths are valid, and no path is longer than before. This
  /// also holds after an exception, which leaves the paths unfinished
  /// \exception Undecided_error as `sign_of_cotangent_weight()`
  /// \exception Cancelled_error if the visitor asks for it
  template <class NamedParameters = parameters::Default_named_parameters>
  Geodesic_report shorten(const NamedParameters& np = parameters::default_values())
  {
    const internal::Standard_arithmetic arithmetic;
    auto observer = internal::observer_of(np);
    budget_ = internal::maximum_number_of(np);
    report_ = {};
    is_stopped_ = false;
    go_further_ = [&] { return observer.go_further(report_.tests, report_.flips); };
    after_flip_ = [&](Edge_index e) { observer.after_flip(e); };
    const internal::Interruption_scope<Triangulation> scope(triangulation_, go_further_);
    for (Outcome& outcome : outcomes_)
      if (outcome.status != Geodesic_status::CONTRACTIBLE)
        outcome.status = Geodesic_status::GEODESIC;
    try {
      Queue queue;
      for (std::size_t p = 0; p < paths_.size(); ++p)
        push_path(p, queue);
      settle(queue);
    } catch (...) {
      is_stopped_ = true;
      sum_up();
      throw;
    }
    sum_up();
    return report_;
  }

  /// \name Paths
  /// @{

  /// returns the number of paths.
  std::size_t number_of_paths() const { return paths_.size(); }
  /// returns whether path `p` is a closed curve.
  bool is_closed(std::size_t p) const { return paths_.is_closed(p); }
  /// returns how the last `shorten()` left path `p`.
  Geodesic_status status(std::size_t p) const { return outcomes_[p].status; }
  /// \brief returns the vertex to which a contractible curve was shrunk.
  /// \pre `status(p)` is `CONTRACTIBLE`
  Vertex_index contraction(std::size_t p) const { return outcomes_[p].contraction; }

  /// returns the halfedges of path `p` in the current triangulation: none if it was shrunk to a point.
  std::vector<Halfedge_index> halfedges(std::size_t p) const { return paths_.halfedges(p); }
  /// returns the length of path `p`, within one unit in the last place for each of its edges.
  double length(std::size_t p) const
  {
    double sum = 0;
    for (Halfedge_index h : halfedges(p))
      sum += triangulation_.length(complex().edge(h));
    return sum;
  }
  /// \brief decides whether path `p` is locally shortest: whether at each inner vertex that is not fixed, the angle on
  /// either side is at least π, or contains the border or a constrained edge. A curve that was shrunk to a point is.
  /// \exception Undecided_error as `sign_of_cotangent_weight()`
  bool is_geodesic(std::size_t p)
  {
    const std::vector<Halfedge_index> sides = halfedges(p);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (i + 1 == sides.size() && !is_closed(p))
        break;
      const Halfedge_index a = sides[i], b = sides[(i + 1) % sides.size()];
      if (is_fixed_[complex().target(a).idx()])
        continue;
      if (complex().opposite(a) == b)
        return false;
      for (bool is_on_left : {true, false})
        if (angle_of_bend(a, b, is_on_left))
          return false;
    }
    return true;
  }
  /// decides whether all paths are locally shortest.
  bool is_geodesic()
  {
    for (std::size_t p = 0; p < paths_.size(); ++p)
      if (!is_geodesic(p))
        return false;
    return true;
  }
  /// @}

private:
  using Linked_paths = internal::Linked_paths;
  using Segment_index = Linked_paths::Segment_index;

  struct Outcome
  {
    Geodesic_status status = Geodesic_status::GEODESIC;
    Vertex_index contraction; // if the path was shrunk to a point
  };
  // A place between two segments that may be shortened, or a loop, which is both segments.
  struct Bend
  {
    double angle;
    Segment_index before, after;
    bool is_on_left;
    friend bool operator<(const Bend& a, const Bend& b) { return a.angle > b.angle; } // the sharpest comes first
  };
  using Queue = std::priority_queue<Bend>;

  const Delta_complex& complex() const { return triangulation_.connectivity(); }

  // The corners on one side of the way from a to b.
  internal::Wedge wedge_between(Halfedge_index a, Halfedge_index b, bool is_on_left) const
  {
    return is_on_left ? internal::Wedge{b, complex().opposite(a)} : internal::Wedge{complex().opposite(a), b};
  }

  // An estimate of the angle on one side of the way from a to b, if it may be shortened there.
  std::optional<double> angle_of_bend(Halfedge_index a, Halfedge_index b, bool is_on_left)
  {
    const internal::Wedge wedge = wedge_between(a, b, is_on_left);
    return is_fenced(wedge) ? std::nullopt : geometry_.angle_below_pi(wedge);
  }

  bool is_constrained(Edge_index e) const { return is_constrained_ && is_constrained_(e); }

  // Whether a constrained edge lies inside of the wedge.
  bool is_fenced(const internal::Wedge& wedge) const
  {
    if (!is_constrained_)
      return false;
    for (Halfedge_index h = wedge.first; h != wedge.last && !complex().is_border(h);) {
      h = complex().next_around_source(h);
      if (h != wedge.last && is_constrained(complex().edge(h)))
        return true;
    }
    return false;
  }

  void sum_up()
  {
    for (Outcome& outcome : outcomes_) {
      if (is_stopped_ && outcome.status != Geodesic_status::CONTRACTIBLE)
        outcome.status = Geodesic_status::UNFINISHED;
      if (outcome.status != Geodesic_status::CONTRACTIBLE)
        report_.status = (std::max)(report_.status, outcome.status);
    }
  }

  std::size_t add(const std::vector<Halfedge_index>& halfedges, bool is_closed)
  {
    internal::make_room(outcomes_, 1);
    const std::size_t p = paths_.add(halfedges, is_closed);
    outcomes_.emplace_back();
    return p;
  }

  // Replaces two consecutive segments, or a loop if they are the same.
  // \param is_on_left whether the new ones lie on their left
  void replace(Segment_index a, Segment_index b, const std::vector<Halfedge_index>& halfedges, bool is_on_left,
               Queue& queue)
  {
    const std::uint32_t p = paths_[a].path;
    const Vertex_index start = complex().source(paths_[a].halfedge);
    const bool was_straight = paths_[b].is_straight[!is_on_left];
    const auto [before, first, last] = paths_.replace(a, b, halfedges);
    if (paths_.is_closed(p) && paths_.first(p) == Linked_paths::none) {
      outcomes_[p] = {Geodesic_status::CONTRACTIBLE, start};
      return;
    }
    // On the side of the old segments, no angle between the new ones is below π, and the angles at their ends have
    // grown.
    const bool are_convex = a != b && first != Linked_paths::none;
    if (before != Linked_paths::none) {
      std::array<bool, 2>& is_straight = paths_.is_straight(before);
      is_straight[is_on_left] = false;
      is_straight[!is_on_left] = is_straight[!is_on_left] && are_convex;
    }
    push(before, queue);
    for (Segment_index s = first; s != Linked_paths::none; s = paths_[s].next) {
      if (are_convex)
        paths_.is_straight(s)[!is_on_left] = s != last || was_straight;
      push(s, queue);
      if (s == last)
        break;
    }
  }

  void push_path(std::size_t p, Queue& queue)
  {
    for (Segment_index s = paths_.first(p); s != Linked_paths::none; s = paths_.following(s))
      push(s, queue);
  }

  // Queues the sides of the vertex after a segment on which the path bends.
  void push(Segment_index a, Queue& queue)
  {
    if (a == Linked_paths::none || paths_[a].next == Linked_paths::none)
      return;
    const Segment_index b = paths_[a].next;
    const Halfedge_index g = paths_[a].halfedge, h = paths_[b].halfedge;
    if (is_fixed_[complex().target(g).idx()])
      return;
    if (g == complex().opposite(h)) {
      queue.push({0, a, b, true});
      return;
    }
    for (bool is_on_left : {true, false}) {
      if (paths_[a].is_straight[is_on_left])
        continue;
      if (const std::optional<double> angle = angle_of_bend(g, h, is_on_left))
        queue.push({*angle, a, b, is_on_left});
      else
        paths_.is_straight(a)[is_on_left] = true;
    }
  }

  bool goes_on()
  {
    ++report_.tests;
    is_stopped_ = is_stopped_ || report_.flips >= budget_;
    if (!is_stopped_ && !go_further_())
      throw Cancelled_error("the search for shorter paths was cancelled");
    return !is_stopped_;
  }

  bool shorten_wedge(const internal::Wedge& wedge, bool is_below_pi)
  {
    return geometry_.shorten(
      wedge, is_below_pi, [&](Edge_index e) { return !paths_.is_used(e) && !is_constrained(e); },
      [&] { return goes_on(); },
      [&](Edge_index e) {
        ++report_.flips;
        after_flip_(e);
      });
  }

  // The outer side of a wedge, from the end of its last halfedge to that of the first, or in reverse.
  std::vector<Halfedge_index> outer_side(const internal::Wedge& wedge, bool is_backward) const
  {
    std::vector<Halfedge_index> result;
    for (Halfedge_index h = wedge.first; h != wedge.last; h = complex().next_around_source(h))
      result.push_back(complex().next(h));
    if (is_backward) {
      std::reverse(result.begin(), result.end());
      for (Halfedge_index& h : result)
        h = complex().opposite(h);
    }
    return result;
  }

  // Processes a queue. Blocked places are tried again as long as anything else moves.
  void settle(Queue& queue)
  {
    std::vector<Bend> blocked;
    for (;;) {
      const std::uint64_t steps = report_.steps;
      while (!queue.empty()) {
        const Bend bend = queue.top();
        queue.pop();
        if (paths_.are_consecutive(bend.before, bend.after) && !straighten(bend, queue))
          blocked.push_back(bend);
        if (is_stopped_)
          return;
      }
      if (report_.steps == steps || blocked.empty())
        break;
      for (const Bend& bend : blocked)
        queue.push(bend);
      blocked.clear();
    }
    for (const Bend& bend : blocked)
      if (paths_.are_consecutive(bend.before, bend.after)) {
        Geodesic_status& status = outcomes_[paths_[bend.before].path].status;
        const bool is_loop = bend.before == bend.after;
        status = (std::max)(status, is_loop ? Geodesic_status::NOT_IMPROVABLE : Geodesic_status::BLOCKED);
      }
  }

  // Returns whether the path was shortened there.
  bool straighten(const Bend& bend, Queue& queue)
  {
    if (bend.before == bend.after)
      return straighten_loop(bend.before, bend.is_on_left, queue);
    const Halfedge_index a = paths_[bend.before].halfedge, b = paths_[bend.after].halfedge;
    std::vector<Halfedge_index> way;
    if (complex().opposite(a) != b) {
      const internal::Wedge wedge = wedge_between(a, b, bend.is_on_left);
      if (!shorten_wedge(wedge, true))
        return false;
      way = outer_side(wedge, bend.is_on_left);
    }
    ++report_.steps;
    replace(bend.before, bend.after, way, bend.is_on_left, queue);
    return true;
  }

  // A loop of one edge bends at its vertex, but a step there would move both of its ends at once. If the triangle on
  // that side is glued to itself, the loop goes round a single vertex. Otherwise it is led round the third corner of
  // the triangle, which makes it longer, then taken off its vertex and shortened like any path. All of this is undone
  // unless the result is certainly shorter.
  bool straighten_loop(Segment_index s, bool is_on_left, Queue& queue)
  {
    const std::uint32_t p = paths_[s].path;
    const Halfedge_index loop = paths_[s].halfedge;
    const Halfedge_index g = is_on_left ? loop : complex().opposite(loop);
    const Halfedge_index x = complex().opposite(complex().prev(g)), y = complex().opposite(complex().next(g));
    if (x == complex().next(g)) {
      replace(s, s, {}, is_on_left, queue);
      outcomes_[p].contraction = complex().target(x);
      ++report_.steps;
      return true;
    }
    const internal::Wedge wedge = wedge_between(y, x, true);
    if (is_fenced(wedge))
      return false;
    const internal::Bounded_double_double length_before = precise_length(p);
    const std::uint64_t steps_before = report_.steps;
    const std::size_t changes_before = geometry_.flips().size();
    bool is_shorter = false;
    try {
      is_shorter =
        leads_round(s, wedge, is_on_left) &&
        (paths_.first(p) == Linked_paths::none || certainly((precise_length(p) - length_before).sign() == NEGATIVE));
    } catch (...) {
      undo(s, loop, changes_before);
      throw;
    }
    if (is_shorter) {
      ++report_.steps;
      push_path(p, queue);
    } else {
      undo(s, loop, changes_before);
      report_.steps = steps_before;
    }
    return is_shorter;
  }

  // Replaces a loop by the outer side of a wedge, and shortens the path as far as possible without leading a loop round
  // a corner.
  // \return whether that succeeded
  bool leads_round(Segment_index s, const internal::Wedge& wedge, bool is_on_left)
  {
    paths_.remove(s);
    const bool is_shortened = shorten_wedge(wedge, false);
    paths_.revive(s);
    if (!is_shortened)
      return false;
    Queue queue;
    replace(s, s, outer_side(wedge, is_on_left), is_on_left, queue);
    while (!queue.empty() && !is_stopped_) {
      const Bend bend = queue.top();
      queue.pop();
      if (paths_.are_consecutive(bend.before, bend.after) && bend.before != bend.after)
        straighten(bend, queue);
    }
    return !is_stopped_;
  }

  // Turns a path back into the loop that it was after the given number of changes. Never throws.
  void undo(Segment_index s, Halfedge_index loop, std::size_t changes_before)
  {
    geometry_.flips().undo(changes_before);
    paths_.restore_loop(s, loop);
  }

  // In double-doubles: loops beside a band that is nearly a cylinder have nearly the same length. In the unit of the
  // metric.
  internal::Bounded_double_double precise_length(std::size_t p) const
  {
    internal::Bounded_double_double sum;
    for (Halfedge_index h : halfedges(p)) {
      const Halfedge_index side = complex().is_border(h) ? complex().opposite(h) : h;
      sum = sum + sqrt(internal::Engine_numbers(internal::engine(triangulation_)).corner(side).s_opposite);
    }
    return sum;
  }

  Triangulation& triangulation_;
  internal::Wedge_geometry<Traits> geometry_;
  std::function<bool(Edge_index)> is_constrained_;
  Linked_paths paths_;
  std::vector<Outcome> outcomes_; // of each path
  std::vector<bool> is_fixed_;    // each vertex

  // of the run:
  Geodesic_report report_;
  std::uint64_t budget_ = 0;
  bool is_stopped_ = false;
  std::function<bool()> go_further_;
  std::function<void(Edge_index)> after_flip_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESIC_PATH_NETWORK_H

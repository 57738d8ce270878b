// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The input triangulation beside the current one.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Kept_crossings.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Rotation_system.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Each flip as the halfedges around the edge before it. In parts, so that it grows without being
// copied, and takes over what others have noted.
class Flip_journal
{
public:
  void push_back(const Hinge_halfedges& flip)
  {
    if (parts_.empty() || parts_.back().size() == parts_.back().capacity())
      begin_part();
    parts_.back().push_back(flip);
  }
  // \pre the last flip was noted by push_back()
  void pop_back() { parts_.back().pop_back(); }
  // So many calls of append() do not throw then.
  void make_room(std::size_t number) { parts_.reserve(parts_.size() + number); }
  void append(std::vector<Hinge_halfedges> flips)
  {
    const std::size_t n = size();
    parts_.push_back(std::move(flips));
    size_of_full_parts_ = n;
  }
  std::size_t size() const { return parts_.empty() ? 0 : size_of_full_parts_ + parts_.back().size(); }

  template <class Function>
  void for_each(const Function& f) const
  {
    for (const std::vector<Hinge_halfedges>& part : parts_)
      for (const Hinge_halfedges& flip : part)
        f(flip);
  }
  // From the last to the first.
  template <class Function>
  void for_each_backwards(const Function& f) const
  {
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part)
      for (auto flip = part->rbegin(); flip != part->rend(); ++flip)
        f(*flip);
  }

private:
  void begin_part()
  {
    constexpr std::size_t size_of_part = 2048;
    const std::size_t n = size();
    parts_.emplace_back();
    size_of_full_parts_ = n;
    parts_.back().reserve(size_of_part);
  }

  std::vector<std::vector<Hinge_halfedges>> parts_;
  std::size_t size_of_full_parts_ = 0; // of all but the last
};

// Relates a triangulation to the input triangulation from which flips have produced it.
//
// How a flip changes the integers depends only on the halfedges around the edge. So flips are logged
// in a journal. When the integers are needed, they are computed from it, and the input connectivity
// is recovered. From then on each flip updates the integers at once, until `begin_journal()` is called.
class Correspondence
{
public:
  Correspondence() = default;
  // With what is known from elsewhere.
  // \param coordinates the integers of the current triangulation
  // \param locations where the vertices lie that follow those of the input
  Correspondence(Delta_complex input, Normal_coordinates coordinates, std::vector<Surface_point> locations)
    : is_prepared_(true), knows_input_(true), input_(std::move(input)), coordinates_(std::move(coordinates)),
      locations_(std::move(locations))
  {}

  // Whether the integers are up to date, so that `coordinates()`, `input()` and `input_halfedge()` are available.
  bool is_prepared() const { return is_prepared_; }

  // The number of flips in the journal: those that were made before `prepare()`, or since `begin_journal()`.
  std::size_t number_of_journaled_flips() const { return journal_.size(); }

  // Logs flips again from now on, until the next `prepare()`. O(1).
  void begin_journal() { is_prepared_ = false; }

  // The edges of these flips, in order.
  std::vector<Edge_index> journaled_flips(const Delta_complex& complex) const;

  // Computes the integers and recovers the input. O(size + number of flips) if there is a journal,
  // and O(1) otherwise.
  // \param complex the current connectivity
  // \return the edges that were flipped before, in order; the journal is then cleared
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`. Nothing is changed then, but
  //   the integers can no longer be computed, even if the flips are undone
  // The integers and the input do not depend on each other, so that two threads can compute them.
  std::vector<Edge_index> prepare(const Delta_complex& complex,
                                  const Block_runner& run = block_runner<Sequential_tag>());

  // Records the flip of the edge that the halfedges are around; to be called before the connectivity is flipped. O(1).
  // An exception leaves everything as it was.
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`, if `is_prepared()`
  void flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (!is_prepared_) {
      journal_.push_back(around);
      return;
    }
    if (locations_.empty()) { // it is soon found what the new edge crosses
      const Edge_index e = complex.edge(around.ij);
      crossings_.forget(e, coordinates_.number_of_crossings(e));
      if (coordinates_.flip(around) > longest_walk)
        turn_around_flipped(complex, around);
      return;
    }
    flip_with_crossings(complex, around);
    turn_around_flipped(complex, around);
  }
  // Undoes a flip, the last one that was not undone, before that is done in the connectivity. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Delta_complex& complex, Hinge_halfedges around)
  {
    if (!is_prepared_)
      return journal_.pop_back();
    crossings_.forget(complex.edge(around.ij), coordinates_.number_of_crossings(complex.edge(around.ij)));
    for (int i = 0; i < 3; ++i) { // as four flips are the identity
      around = {around.ij, around.ki, around.il, around.ji, around.lj, around.jk};
      coordinates_.flip(around);
      turn_around_flipped(complex, around);
    }
  }
  // So many calls of append() do not throw then.
  void make_room_for_journals(std::size_t number) { journal_.make_room(number); }
  // Records flips from other journals, each given by the halfedges around the edge before it.
  // \pre not `is_prepared()`
  void append(std::vector<Hinge_halfedges> flips)
  {
    CGAL_precondition(!is_prepared_);
    journal_.append(std::move(flips));
  }

  // ---------------- New vertices
  // An exception leaves everything as it was.

  // Follows the insertion of a vertex into a face; to be called before `split_face(piece.side)` of the
  // connectivity. O(1).
  // \param complex the current connectivity
  // \param piece the piece of the triangle that contains the vertex
  // \param location where the vertex lies: strictly inside a face of the input
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `is_prepared()`
  void split_face(const Delta_complex& complex, const Triangle_piece& piece, const Surface_point& location);
  // Follows the insertion of a vertex on an edge that coincides with an input edge; to be called before `split_edge(h)`
  // of the connectivity. O(1).
  // \param complex the current connectivity
  // \param h the halfedge that is split
  // \param location where the vertex lies: on that input edge
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `is_prepared()`
  void split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location);

  // Follows the join of two edges; to be called before `unsplit_edge(h)` of the connectivity. O(1).
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `is_inserted()` of the target of `h`
  void unsplit_edge(const Delta_complex& complex, Halfedge_index h);
  // Follows the removal of an inserted vertex, after that of the connectivity. O(1). Never throws.
  void remove(const Removed_elements& removed);

  // Whether `v` is no vertex of the input. \pre `is_prepared()`
  bool is_inserted(Vertex_index v) const { return v.idx() >= input_.number_of_vertices(); }
  // The number of inserted vertices.
  std::size_t number_of_inserted_vertices() const { return locations_.size(); }
  void forget_crossings() { crossings_.clear(); }
  // What edges cross, as far as it was found before.
  const Kept_crossings& kept_crossings() const { return crossings_; }
  // Those of all inserted vertices.
  const std::vector<Surface_point>& locations() const { return locations_; }
  // Where an inserted vertex lies on the input. The coordinates are exact once they are divided by their sum.
  // \pre `is_inserted(v)`
  const Surface_point& location(Vertex_index v) const { return locations_[v.idx() - input_.number_of_vertices()]; }

  // The integers. \pre `is_prepared()`
  const Normal_coordinates& coordinates() const { return coordinates_; }

  // The input connectivity: the same vertices, edges, halfedges and faces as at
  // the beginning; `halfedge(v)` and `halfedge(f)` may be different incident halfedges.
  // \pre `is_prepared()`
  const Delta_complex& input() const { return input_; }

  // The roundabout of `h`: the first input halfedge at or after `h`, counterclockwise
  // around its source. O(1).
  //
  // For a halfedge that leaves a vertex inserted on an input edge it is one of the two halfedges of that edge, taken
  // from there on; for one that leaves a vertex inside an input face there is none.
  // \pre `is_prepared()`
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    const Roundabout r = coordinates_.roundabout(h);
    Halfedge_index result = r.base;
    if (!result.is_valid())
      return result;
    for (std::uint64_t step = 0; step < r.steps; ++step) // at most longest_walk
      result = input_.next_around_source(result);
    return result;
  }

private:
  // More steps than this are replaced: around most vertices, there are never as many.
  static constexpr std::uint64_t longest_walk = 16;

  // Walks that stay long, as where memory is short, are right as well. Few are long, so that one thread replaces what
  // all have found: there is one table for that.
  void shorten_walks(const std::vector<Edge_index>& edges, const Block_runner& run);
  void shorten_walk(Halfedge_index h);

  void flip_with_crossings(const Delta_complex& complex, const Hinge_halfedges& around);
  BOOST_NOINLINE void turn_around_flipped(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    turn_around(around.ij, complex.target(around.il));
    turn_around(around.ji, complex.target(around.jk));
  }
  // Around a vertex on an input edge, there are two directions only.
  void turn_around(Halfedge_index h, Vertex_index source);

  bool is_prepared_ = false, knows_input_ = false;
  Flip_journal journal_;
  Delta_complex input_;
  Normal_coordinates coordinates_;
  Kept_crossings crossings_;
  std::vector<Surface_point> locations_;  // of the vertices that follow those of the input
  std::optional<Rotation_system> around_; // of the input, for long walks
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CORRESPONDENCE_H

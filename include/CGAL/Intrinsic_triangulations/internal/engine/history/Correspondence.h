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
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
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

class Flip_log;

// Relates a triangulation to the input triangulation from which flips have produced it.
//
// How a flip changes the integers depends only on the halfedges around the edge. So they are computed from the log of
// flips when they are needed, and the input connectivity is recovered from it.
class Correspondence
{
public:
  Correspondence() = default;
  // Constructs a correspondence with known integers.
  // \param coordinates the integers of the current triangulation
  // \param locations the locations of the vertices after those of the input
  Correspondence(Delta_complex input, Normal_coordinates coordinates, std::vector<Surface_point> locations)
    : knows_input_(true), input_(std::move(input)), coordinates_(std::move(coordinates)),
      locations_(std::move(locations))
  {}

  // Whether the input was recovered, so that `input()`, `coordinates()` and what follows are available.
  bool knows_input() const { return knows_input_; }

  // Reads the rest of the log: computes the integers, and at first recovers the input. O(size + number of flips) if
  // there are flips, and O(1) otherwise. The integers and the input do not depend on each other, so that two threads
  // can compute them.
  // \param complex the current connectivity
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`. Nothing is changed then
  void catch_up(const Delta_complex& complex, const Flip_log& log,
                const Block_runner& run = block_runner<Sequential_tag>());

  // Follows the flip of the edge that the halfedges surround; to be called before the connectivity is flipped. O(1). An
  // exception leaves everything as it was.
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  void flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (locations_.empty()) { // the crossings of the new edge are found quickly
      const Edge_index e = complex.edge(around.ij);
      crossings_.forget(e, coordinates_.number_of_crossings(e));
      if (coordinates_.flip(around) > longest_walk)
        turn_around_flipped(complex, around);
      return;
    }
    flip_with_crossings(complex, around);
    turn_around_flipped(complex, around);
  }
  // Undoes the last flip that was not undone yet, before the connectivity does. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Delta_complex& complex, Hinge_halfedges around)
  {
    crossings_.forget(complex.edge(around.ij), coordinates_.number_of_crossings(complex.edge(around.ij)));
    for (int i = 0; i < 3; ++i) { // as four flips are the identity
      around = {around.ij, around.ki, around.il, around.ji, around.lj, around.jk};
      coordinates_.flip(around);
      turn_around_flipped(complex, around);
    }
  }

  // ---------------- New vertices
  // An exception leaves everything as it was.

  // Follows the insertion of a vertex into a face; to be called before `split_face(piece.side)` of the
  // connectivity. O(1).
  // \param complex the current connectivity
  // \param piece the piece of the triangle that contains the vertex
  // \param location where the vertex lies: strictly inside a face of the input
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `knows_input()`
  void split_face(const Delta_complex& complex, const Triangle_piece& piece, const Surface_point& location);
  // Follows the insertion of a vertex on an edge that coincides with an input edge; to be called before `split_edge(h)`
  // of the connectivity. O(1).
  // \param complex the current connectivity
  // \param h the halfedge that is split
  // \param location where the vertex lies: on that input edge
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `knows_input()`
  void split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location);

  // Follows the join of two edges; to be called before `unsplit_edge(h)` of the connectivity. O(1).
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  // \pre `is_inserted()` of the target of `h`
  void unsplit_edge(const Delta_complex& complex, Halfedge_index h);
  // Follows the removal of an inserted vertex, after the connectivity has removed it. O(1). Never throws.
  void remove(const Removed_elements& removed);

  // Whether `v` is not a vertex of the input. \pre `knows_input()`
  bool is_inserted(Vertex_index v) const { return v.idx() >= input_.number_of_vertices(); }
  // The number of inserted vertices.
  std::size_t number_of_inserted_vertices() const { return locations_.size(); }
  void forget_crossings() { crossings_.clear(); }
  // The cached crossings of edges.
  const Kept_crossings& kept_crossings() const { return crossings_; }
  // The locations of all inserted vertices.
  const std::vector<Surface_point>& locations() const { return locations_; }
  // The location of an inserted vertex on the input. The coordinates are exact once they are divided by their sum.
  // \pre `is_inserted(v)`
  const Surface_point& location(Vertex_index v) const { return locations_[v.idx() - input_.number_of_vertices()]; }

  // The integers. \pre `knows_input()`
  const Normal_coordinates& coordinates() const { return coordinates_; }

  // The input connectivity: the same vertices, edges, halfedges and faces as at
  // the beginning; `halfedge(v)` and `halfedge(f)` may be different incident halfedges.
  // \pre `knows_input()`
  const Delta_complex& input() const { return input_; }

  // The roundabout of `h`: the first input halfedge at or after `h`, counterclockwise
  // around its source. O(1).
  //
  // For a halfedge that leaves a vertex inserted on an input edge it is one of the two halfedges of that edge, taken
  // from there on; for one that leaves a vertex inside an input face there is none.
  // \pre `knows_input()`
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
  // Longer walks are replaced. Around most vertices there are none.
  static constexpr std::uint64_t longest_walk = 16;

  // Walks that stay long, for lack of memory, are still right. Few are long, so one thread replaces all that the
  // threads have found, with a single table.
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

  bool knows_input_ = false;
  Delta_complex input_;
  Normal_coordinates coordinates_;
  Kept_crossings crossings_;
  std::vector<Surface_point> locations_;  // of the vertices that follow those of the input
  std::optional<Rotation_system> around_; // of the input, for long walks
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_CORRESPONDENCE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The input triangulation beside the current one.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Removed_elements.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Flip_journal.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Rotation_system.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Block_runner.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief relates a triangulation to the input triangulation from which flips have produced it.
///
/// How a flip changes the integers depends only on the halfedges around the edge. So flips are logged
/// in a journal. When the integers are needed, they are computed from it, and the input connectivity
/// is recovered. From then on each flip updates the integers at once.
class Correspondence
{
public:
  /// returns whether `input()` and `input_halfedge()` are available.
  bool is_prepared() const { return is_prepared_; }

  /// returns the number of flips that were made before `prepare()`.
  std::size_t number_of_journaled_flips() const { return journal_.size(); }

  /// returns the edges of these flips, in order.
  std::vector<Edge_index> journaled_flips(const Delta_complex& complex) const
  {
    std::vector<Edge_index> result;
    result.reserve(journal_.size());
    journal_.for_each([&](const Hinge_halfedges& around) { result.push_back(complex.edge(around.ij)); });
    return result;
  }

  /// \brief computes the integers and recovers the input. O(size + number of flips) the first time,
  /// and O(1) afterwards.
  /// \param complex the current connectivity
  /// \return the edges that were flipped before, in order; the journal is then cleared
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`. Nothing is changed then, but
  ///   the integers can no longer be computed, even if the flips are undone
  std::vector<Edge_index> prepare(const Delta_complex& complex)
  {
    return prepare(complex, internal::block_runner<Sequential_tag>());
  }
  /// \cond SKIP_IN_MANUAL
  // As above: the integers and the input do not depend on each other, so that two threads can compute them.
  std::vector<Edge_index> prepare(const Delta_complex& complex, const internal::Block_runner& run)
  {
    if (is_prepared_)
      return {};
    Normal_coordinates coordinates;
    Delta_complex input = complex.copied([&](std::size_t n, const auto& f) { run(n, internal::elements_of_block, f); });
    std::vector<Edge_index> flipped_edges;
    const std::function<void()> tasks[] = {
      [&] {
        coordinates = Normal_coordinates(complex); // as many elements as the input
        journal_.for_each([&](const Hinge_halfedges& around) { coordinates.flip(around); });
        flipped_edges = journaled_flips(complex);
      },
      [&] { journal_.for_each_backwards([&](const Hinge_halfedges& around) { input.flip_back(around); }); }};
    run(2, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        tasks[i]();
    });
    coordinates_ = std::move(coordinates);
    input_ = std::move(input);
    shorten_walks(flipped_edges, run);
    is_prepared_ = true;
    journal_ = {};
    return flipped_edges;
  }
  /// \endcond

  /// \brief records the flip of `e`; to be called before the connectivity is flipped. O(1).
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`, if `is_prepared()`
  void flip(const Delta_complex& complex, Edge_index e)
  {
    CGAL_precondition(complex.is_flippable(e));
    flip(complex, complex.hinge(e));
  }
  /// as above, for the halfedges around the edge.
  void flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (!is_prepared_) {
      journal_.push_back(around);
      return;
    }
    coordinates_.flip(around);
    if (locations_.empty()) {
      shorten_walks(around.ij);
      return;
    }
    turn_around(around.ij, complex.target(around.il));
    turn_around(around.ji, complex.target(around.jk));
  }
  /// \brief records flips from other journals, each given by the halfedges around the edge before it.
  /// \pre not `is_prepared()`
  void append(std::vector<Hinge_halfedges> flips)
  {
    CGAL_precondition(!is_prepared_);
    journal_.append(std::move(flips));
  }

  /// \name New vertices
  /// @{

  /// \brief follows the insertion of a vertex into a face; to be called before `split_face(piece.side)` of the
  /// connectivity. O(1).
  /// \param complex the current connectivity
  /// \param piece the piece of the triangle that contains the vertex
  /// \param location where the vertex lies: strictly inside a face of the input
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  /// \pre `is_prepared()`
  void split_face(const Delta_complex& complex, const Triangle_piece& piece, const Surface_point& location)
  {
    CGAL_precondition(is_prepared_ && location.dimension() == 2);
    coordinates_.split_face(complex, piece);
    locations_.push_back(location);
    Halfedge_index from_corner(2 * complex.number_of_edges() + 1);
    for (Halfedge_index side : {piece.side, complex.next(piece.side), complex.prev(piece.side)}) {
      turn_around(from_corner, complex.source(side));
      from_corner = Halfedge_index(from_corner.idx() + 2);
    }
  }
  /// \brief follows the insertion of a vertex on an edge that coincides with an input edge; to be called before `split_edge(h)`
  /// of the connectivity. O(1).
  /// \param complex the current connectivity
  /// \param h the halfedge that is split
  /// \param location where the vertex lies: on that input edge
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  /// \pre `is_prepared()`
  void split_edge(const Delta_complex& complex, Halfedge_index h, const Surface_point& location)
  {
    CGAL_precondition(is_prepared_ && location.dimension() == 1);
    coordinates_.split_edge(complex, h, input_halfedge(h));
    locations_.push_back(location);
    Halfedge_index from_corner(2 * complex.number_of_edges() + 1);
    turn_around(from_corner, complex.target(h));
    for (Halfedge_index side : {h, complex.opposite(h)}) {
      if (complex.is_border(side))
        continue;
      from_corner = Halfedge_index(from_corner.idx() + 2);
      turn_around(from_corner, complex.target(complex.next(side)));
    }
  }

  /// \brief follows the join of two edges; to be called before `unsplit_edge(h)` of the connectivity. O(1).
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  /// \pre `is_inserted()` of the target of `h`
  void unsplit_edge(const Delta_complex& complex, Halfedge_index h)
  {
    coordinates_.unsplit_edge(complex, h, location(complex.target(h)).dimension() == 1);
  }
  /// \brief follows the removal of an inserted vertex, after that of the connectivity. O(1).
  void remove(const Removed_elements& removed)
  {
    coordinates_.remove(removed);
    remove_entries(locations_, removed.vertices, input_.number_of_vertices());
  }

  /// returns whether `v` is no vertex of the input. \pre `is_prepared()`
  bool is_inserted(Vertex_index v) const { return v.idx() >= input_.number_of_vertices(); }
  /// returns the number of inserted vertices.
  std::size_t number_of_inserted_vertices() const { return locations_.size(); }
  /// \cond SKIP_IN_MANUAL
  // Those of all inserted vertices.
  const std::vector<Surface_point>& locations() const { return locations_; }
  /// \endcond
  /// returns where an inserted vertex lies on the input. The coordinates are exact once they are divided by their sum.
  /// \pre `is_inserted(v)`
  const Surface_point& location(Vertex_index v) const { return locations_[v.idx() - input_.number_of_vertices()]; }
  /// @}

  /// returns the integers. \pre `is_prepared()`
  const Normal_coordinates& coordinates() const { return coordinates_; }

  /// returns the input connectivity: the same vertices, edges, halfedges and faces as at
  /// the beginning; `halfedge(v)` and `halfedge(f)` may be different incident halfedges.
  /// \pre `is_prepared()`
  const Delta_complex& input() const { return input_; }

  /// returns the roundabout of `h`: the first input halfedge at or after `h`, counterclockwise
  /// around its source. O(1).
  ///
  /// For a halfedge that leaves a vertex inserted on an input edge it is one of the two halfedges of that edge, taken from there
  /// on; for one that leaves a vertex inside an input face there is none.
  /// \pre `is_prepared()`
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

  // Few are long, so that one thread replaces what all have found: there is one table for that.
  void shorten_walks(const std::vector<Edge_index>& edges, const internal::Block_runner& run)
  {
    std::vector<Halfedge_index> long_walks;
    std::mutex mutex;
    run(edges.size(), internal::elements_of_block, [&](std::size_t first, std::size_t last) {
      std::vector<Halfedge_index> found;
      for (std::size_t i = first; i < last; ++i)
        for (std::uint32_t side : {0u, 1u}) {
          const Halfedge_index h(2 * edges[i].idx() + side);
          if (coordinates_.roundabout(h).steps > longest_walk)
            found.push_back(h);
        }
      const std::lock_guard<std::mutex> lock(mutex);
      long_walks.insert(long_walks.end(), found.begin(), found.end());
    });
    for (Halfedge_index h : long_walks)
      shorten_walk(h);
  }
  BOOST_NOINLINE void shorten_walks(Halfedge_index h)
  {
    for (Halfedge_index side : {h, input_.opposite(h)})
      shorten_walk(side);
  }
  void shorten_walk(Halfedge_index h)
  {
    const Roundabout r = coordinates_.roundabout(h);
    if (r.steps <= longest_walk)
      return;
    if (!around_)
      around_.emplace(input_);
    coordinates_.set_roundabout(h, around_->advanced(input_, r.base, r.steps));
  }

  // Around a vertex on an input edge, there are two directions only.
  void turn_around(Halfedge_index h, Vertex_index source)
  {
    if (!is_inserted(source)) {
      shorten_walk(h);
      return;
    }
    const Roundabout r = coordinates_.roundabout(h);
    if (r.base.is_valid() && r.steps != 0)
      coordinates_.set_roundabout(h, r.steps % 2 == 0 ? r.base : input_.opposite(r.base));
  }

  bool is_prepared_ = false;
  internal::Flip_journal journal_;
  Delta_complex input_;
  Normal_coordinates coordinates_;
  std::vector<Surface_point> locations_;            // of the vertices that follow those of the input
  std::optional<internal::Rotation_system> around_; // of the input, for long walks
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

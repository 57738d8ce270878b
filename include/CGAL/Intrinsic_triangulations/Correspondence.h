// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The input triangulation beside the current one.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/Rotation_system.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief relates a triangulation to the input triangulation that it was flipped from.
///
/// The integers are updated with each flip, and need not know the input. What is kept of that
/// is a journal of the flips, from which its connectivity is recovered when it is asked for.
class Correspondence
{
public:
  /// returns whether `input()` and `input_halfedge()` are available.
  bool is_prepared() const { return is_prepared_; }

  /// returns the flips that were made before `prepare()`, in their order.
  const std::vector<Edge_index>& journal() const { return journal_; }

  /// \brief recovers the input. O(size + number of flips) the first time, and O(1) afterwards.
  /// \param complex the current connectivity
  /// \return the flips that were made before, which are forgotten
  std::vector<Edge_index> prepare(const Delta_complex& complex)
  {
    if (is_prepared_)
      return {};
    start(complex);
    input_ = complex;
    for (std::size_t i = journal_.size(); i-- > 0;)
      input_.flip_back(journal_[i]);
    is_prepared_ = true;
    for (Edge_index e : journal_)
      shorten_walks(complex.halfedge(e));
    return std::exchange(journal_, {});
  }

  /// \brief follows the flip of `e`, before the flip of the connectivity. O(1), once the
  /// first took O(edges).
  /// \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  void flip(const Delta_complex& complex, Edge_index e)
  {
    CGAL_precondition(complex.is_flippable(e));
    flip(complex, complex.hinge(e));
  }
  /// as above, for the halfedges around the edge.
  void flip(const Delta_complex& complex, const Hinge_halfedges& around)
  {
    if (!is_started_)
      start(complex);
    coordinates_.flip(around);
    if (is_prepared_)
      shorten_walks(around.ij);
    else
      journal_.push_back(complex.edge(around.ij));
  }

  /// \name Flips from several threads
  /// Between the two calls that enclose them, flips of edges whose hinges lie in different
  /// blocks may be followed at the same time.
  /// @{

  /// begins. \pre not `is_prepared()`
  /// \param complex the current connectivity
  /// \param block_exponent a block consists of `2^block_exponent` consecutive edges
  void begin_blocks(const Delta_complex& complex, int block_exponent)
  {
    CGAL_precondition(!is_prepared_);
    start(complex);
    coordinates_.begin_blocks(block_exponent);
  }
  /// follows the flip of an edge, and notes it in the journal of its block.
  void flip(const Delta_complex& complex, const Hinge_halfedges& around, std::vector<Edge_index>& journal)
  {
    coordinates_.flip(around);
    journal.push_back(complex.edge(around.ij));
  }
  /// ends, with the journals of the blocks: flips in different blocks commute, so that any
  /// order of the blocks will do.
  void end_blocks(const std::vector<std::vector<Edge_index>>& journals)
  {
    coordinates_.end_blocks();
    std::size_t size = journal_.size();
    for (const std::vector<Edge_index>& journal : journals)
      size += journal.size();
    journal_.reserve(size);
    for (const std::vector<Edge_index>& journal : journals)
      journal_.insert(journal_.end(), journal.begin(), journal.end());
  }
  /// @}

  /// returns the integers. \pre there was a flip, or `is_prepared()`
  const Normal_coordinates& coordinates() const { return coordinates_; }

  /// returns the input connectivity: the same vertices, edges, halfedges and faces as at
  /// the beginning; `halfedge(v)` and `halfedge(f)` may name another incident halfedge.
  /// \pre `is_prepared()`
  const Delta_complex& input() const { return input_; }

  /// returns the roundabout of `h`: the first input halfedge at or after `h`, counterclockwise
  /// around its source. O(1).
  /// \pre `is_prepared()`
  Halfedge_index input_halfedge(Halfedge_index h) const
  {
    const Roundabout r = coordinates_.roundabout(h);
    Halfedge_index result = r.base;
    for (std::uint64_t step = 0; step < r.steps; ++step) // at most longest_walk
      result = input_.next_around_source(result);
    return result;
  }

private:
  // More steps than this are replaced: around most vertices, there are never as many.
  static constexpr std::uint64_t longest_walk = 16;

  BOOST_NOINLINE void start(const Delta_complex& complex)
  {
    if (is_started_)
      return;
    coordinates_ = Normal_coordinates(complex);
    is_started_ = true;
  }

  BOOST_NOINLINE void shorten_walks(Halfedge_index h)
  {
    for (Halfedge_index side : {h, input_.opposite(h)}) {
      const Roundabout r = coordinates_.roundabout(side);
      if (r.steps <= longest_walk)
        continue;
      if (!around_)
        around_.emplace(input_);
      coordinates_.set_roundabout(side, around_->advanced(input_, r.base, r.steps));
    }
  }

  bool is_started_ = false;
  bool is_prepared_ = false;
  std::vector<Edge_index> journal_;
  Delta_complex input_;
  Normal_coordinates coordinates_;
  std::optional<internal::Rotation_system> around_; // of the input, for long walks
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

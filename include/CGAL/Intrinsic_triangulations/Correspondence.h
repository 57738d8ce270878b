// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The input triangulation beside the current one.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/Rotation_system.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief relates a triangulation to the input triangulation that it was flipped from.
///
/// What is kept at first is a journal of the flips. When something is asked for, or when
/// there are as many flips as edges, the input connectivity is recovered by undoing the
/// flips on a copy, and the integers by following them from there; from then on they are
/// updated with each flip. So where nothing is asked, a flip costs an entry in a list.
class Correspondence
{
public:
  /// returns whether `input()`, `coordinates()` and the other queries are available.
  bool is_prepared() const { return is_prepared_; }

  /// \brief makes the queries available. O(size + number of flips) the first time, and
  /// O(1) afterwards.
  /// \param complex the current connectivity
  /// \param before_flip is called with connectivity and edge before each flip that is followed
  /// \exception Integer_overflow_error as `Normal_coordinates::flip()`
  template <class BeforeFlip>
  void prepare(const Delta_complex& complex, const BeforeFlip& before_flip)
  {
    if (is_prepared_)
      return;
    Delta_complex copy = complex;
    for (std::size_t i = journal_.size(); i-- > 0;)
      for (int turn = 0; turn < 3; ++turn) // four flips are the identity
        copy.flip(journal_[i]);
    input_ = copy;
    around_ = internal::Rotation_system(input_);
    coordinates_ = Normal_coordinates(input_, around_);
    for (Edge_index e : journal_) {
      coordinates_.flip(copy, e);
      before_flip(copy, e);
      copy.flip(e);
    }
    std::vector<Edge_index>().swap(journal_);
    is_prepared_ = true;
  }

  /// notes the flip of `e`, before the flip of the connectivity.
  /// \param before_flip as for `prepare()`; it is also called once the queries are available
  /// \exception Integer_overflow_error as `Normal_coordinates::flip()`
  template <class BeforeFlip>
  void flip(const Delta_complex& complex, Edge_index e, const BeforeFlip& before_flip)
  {
    if (!is_prepared_ && journal_.size() >= complex.number_of_edges())
      prepare(complex, before_flip);
    if (is_prepared_) {
      coordinates_.flip(complex, e);
      before_flip(complex, e);
    } else {
      journal_.push_back(e);
    }
  }

  /// returns the integers. \pre `is_prepared()`
  const Normal_coordinates& coordinates() const { return coordinates_; }

  /// returns the input connectivity: the same vertices, edges, halfedges and faces as at
  /// the beginning; `halfedge(v)` and `halfedge(f)` may name another incident halfedge.
  /// \pre `is_prepared()`
  const Delta_complex& input() const { return input_; }

  /// returns the input halfedge out of `v` with the given index in counterclockwise order;
  /// the index is taken modulo the degree. O(1).
  /// \pre `is_prepared()`
  Halfedge_index input_halfedge(Vertex_index v, std::int64_t index) const
  {
    const std::int64_t degree = around_.degree(v);
    if (index < 0)
      index += degree;
    else if (index >= degree) // a division is slow, and rarely needed
      index %= degree;
    return around_.halfedge(v, std::uint32_t(index));
  }

private:
  bool is_prepared_ = false;
  std::vector<Edge_index> journal_;
  Delta_complex input_;
  Normal_coordinates coordinates_;
  internal::Rotation_system around_; // the input halfedges by their sources
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

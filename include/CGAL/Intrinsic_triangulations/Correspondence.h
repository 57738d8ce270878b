// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The input triangulation beside the current one.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief relates a triangulation to the input triangulation that it was flipped from.
///
/// It keeps the normal coordinates and enough to know the input connectivity: a journal
/// of the flips, which is undone on a copy when the input is first asked for or when the
/// journal would become larger than that copy. So an input in which little flips is not
/// stored twice.
class Correspondence
{
public:
  /// constructs the correspondence of `input` with itself.
  explicit Correspondence(const Delta_complex& input) : coordinates_(input) {}

  /// returns the integers.
  const Normal_coordinates& coordinates() const { return coordinates_; }

  /// updates the integers for the flip of `e`, before the flip of the connectivity.
  /// \exception Integer_overflow_error as `Normal_coordinates::flip()`
  void flip(const Delta_complex& complex, Edge_index e)
  {
    coordinates_.flip(complex, e);
    if (is_input_known_)
      return;
    if (journal_.size() >= complex.number_of_edges())
      recover_input(complex);
    else
      journal_.push_back(e);
  }

  /// \brief makes `input()` available. O(size) the first time, O(1) afterwards.
  /// \param complex the current connectivity
  void recover_input(const Delta_complex& complex)
  {
    if (is_input_known_)
      return;
    input_ = complex;
    for (std::size_t i = journal_.size(); i-- > 0;)
      for (int turn = 0; turn < 3; ++turn) // four flips are the identity
        input_.flip(journal_[i]);
    number_halfedges_around_vertices();
    std::vector<Edge_index>().swap(journal_);
    is_input_known_ = true;
  }

  /// returns the input connectivity: the same vertices, edges, halfedges and faces as at
  /// the beginning; `halfedge(v)` and `halfedge(f)` may name another incident halfedge.
  /// \pre `recover_input()` was called
  const Delta_complex& input() const { return input_; }

  /// returns the input halfedge out of `v` with the given index in counterclockwise order;
  /// the index is taken modulo the degree. O(1).
  /// \pre `recover_input()` was called
  Halfedge_index input_halfedge(Vertex_index v, std::int64_t index) const
  {
    const std::uint32_t begin = around_begin_[v.idx()];
    const std::int64_t degree = around_begin_[v.idx() + 1] - begin;
    const std::int64_t wrapped = index < 0 ? index + degree : index % degree;
    return around_[begin + wrapped];
  }

  /// returns the index of the first input halfedge at or counterclockwise after `h`.
  /// \pre `recover_input()` was called
  std::int64_t roundabout(const Delta_complex& complex, Halfedge_index h) const
  {
    return coordinates_.is_touched(complex.source(h)) ? coordinates_.roundabout(h)
                                                      : index_around_[h.idx()];
  }

private:
  void number_halfedges_around_vertices()
  {
    const Delta_complex& complex = input_;
    around_.reserve(complex.number_of_halfedges());
    around_begin_.reserve(std::size_t(complex.number_of_vertices()) + 1);
    index_around_.resize(complex.number_of_halfedges());
    for (Vertex_index v : complex.vertices()) {
      const std::uint32_t begin = std::uint32_t(around_.size());
      around_begin_.push_back(begin);
      if (!complex.halfedge(v).is_valid())
        continue;
      const Halfedge_index first = Normal_coordinates::first_around_source(complex, v);
      Halfedge_index h = first;
      do {
        index_around_[h.idx()] = std::uint32_t(around_.size()) - begin;
        around_.push_back(h);
        h = complex.next_around_source(h);
      } while (h != first);
    }
    around_begin_.push_back(std::uint32_t(around_.size()));
  }

  Normal_coordinates coordinates_;
  bool is_input_known_ = false;
  std::vector<Edge_index> journal_;
  Delta_complex input_;
  std::vector<std::uint32_t> around_begin_;
  std::vector<Halfedge_index> around_;
  std::vector<std::uint32_t> index_around_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_H

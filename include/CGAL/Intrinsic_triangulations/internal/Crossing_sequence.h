// SPDX-License-Identifier: LGPL-3.0-or-later
//
// In which order an edge crosses input edges: the turns of the strip of input triangles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_SEQUENCE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_SEQUENCE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>

#include <CGAL/assertions.h>

#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Two neighbouring crossings of an edge lie on two input edges of one input triangle, which
// share a corner on one side of the edge. On that side the two input segments run side by
// side until they end in that corner; on the other they part. Both sides are followed in
// turn, so the cost is that of the shorter.
class Crossing_sequence
{
public:
  Crossing_sequence(const Delta_complex& complex, const Normal_coordinates& coordinates,
                    Halfedge_index h)
    : complex_(complex), coordinates_(coordinates), halfedge_(h),
      number_(coordinates.number_of_crossings(complex.edge(h)))
  {
    CGAL_precondition(number_ > 0);
  }

  bool is_last() const { return position_ + 1 == number_; }
  void advance() { ++position_; }

  // Whether the current and the next crossed input edge share their end on the left.
  bool turns_left() const
  {
    Pair left{halfedge_, position_};
    Pair right{complex_.opposite(halfedge_), number_ - 2 - position_};
    for (;;) {
      switch (step(left)) {
      case Step::MEET: return true;
      case Step::PART: return false;
      case Step::GO_ON: break;
      }
      switch (step(right)) {
      case Step::MEET: return false;
      case Step::PART: return true;
      case Step::GO_ON: break;
      }
    }
  }

private:
  // Two neighbouring segments that cross `halfedge` into its face, at the positions
  // `lower` and `lower + 1` from its source.
  struct Pair
  {
    Halfedge_index halfedge;
    std::int64_t lower;
  };
  enum class Step { GO_ON, MEET, PART };

  Step step(Pair& pair) const
  {
    const Triangle_crossings t = coordinates_.triangle_crossings(complex_, pair.halfedge);
    const std::int64_t upper = pair.lower + 1;
    if (upper < t.c_i) {
      pair.halfedge = complex_.opposite(complex_.prev(pair.halfedge));
      return Step::GO_ON;
    }
    const std::int64_t from_j = t.c_i + t.e_k;
    if (pair.lower >= from_j) {
      // Segments that cut corner j off keep their distance from j.
      const std::int64_t n_ij = coordinates_.number_of_crossings(complex_.edge(pair.halfedge));
      const Halfedge_index jk = complex_.next(pair.halfedge);
      const std::int64_t n_jk = coordinates_.number_of_crossings(complex_.edge(jk));
      pair.lower += n_jk - n_ij;
      pair.halfedge = complex_.opposite(jk);
      return Step::GO_ON;
    }
    return pair.lower >= t.c_i && upper < from_j ? Step::MEET : Step::PART;
  }

  const Delta_complex& complex_;
  const Normal_coordinates& coordinates_;
  Halfedge_index halfedge_;
  std::int64_t number_;
  std::int64_t position_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CROSSING_SEQUENCE_H

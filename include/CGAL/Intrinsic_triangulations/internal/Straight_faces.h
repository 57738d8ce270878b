// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which faces of the current triangulation are triangles in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A face is known to be straight if it is the flat triangle in space between its corners:
// at first all are, and the two faces of a flip are if those before were and lie in one
// plane, one beyond the other. Then lengths and angles come from three points, however
// many input edges are crossed. In the flat parts of a model, where ties are, this is what
// keeps the exact stages cheap.
class Straight_faces
{
public:
  Straight_faces() = default;
  Straight_faces(std::size_t number_of_faces, std::size_t number_of_points)
    : is_straight_(number_of_faces, number_of_points != 0)
  {}

  bool operator()(Face_index f) const { return is_straight_[f.idx()] != 0; }

  // To be called before the flip of the connectivity.
  void flip(const Delta_complex& complex, const Points& points, Edge_index e)
  {
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    std::uint8_t &first = is_straight_[complex.face(h).idx()],
                 &second = is_straight_[complex.face(g).idx()];
    if (first && second && is_flat(complex, points, h))
      return;
    first = second = 0;
  }

private:
  Large_vector<std::uint8_t> is_straight_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Two faces around which edges can wind.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_TUBE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_TUBE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/assertions.h>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief two faces that share two edges, and whose other sides are loops: a tube.
///
/// The two shared edges run across the tube. Seen with `loop` at the bottom, from left to right, one is to the left of
/// the upper corner of the first face and one to its right: the face is (i, i, q), with the sides `loop`, `next(loop)`
/// and `prev(loop)`.
struct Tube
{
  Halfedge_index loop;  ///< one side, with the tube to its left
  Halfedge_index other; ///< the other side, with the tube to its left
  Edge_index right;     ///< the edge of `next(loop)`
  Edge_index left;      ///< the edge of `prev(loop)`
};

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns whether the face to the left of `loop` and another one form a `Tube` with `loop` as one of its sides.
/// O(1).
///
/// This is a question to the connectivity. `loop` and `other` may be the same edge: that of a torus.
inline bool is_tube(const Delta_complex& complex, Halfedge_index loop)
{
  if (complex.is_border(loop))
    return false;
  const Halfedge_index right = complex.opposite(complex.next(loop)), left = complex.opposite(complex.prev(loop));
  return !complex.is_border(right) && complex.face(right) != complex.face(loop) && complex.next(right) == left;
}

/// \ingroup PkgIntrinsicTriangulationsTwists
/// \brief returns the tube to the left of `loop`. O(1). \pre `is_tube(complex, loop)`
inline Tube tube(const Delta_complex& complex, Halfedge_index loop)
{
  CGAL_precondition(is_tube(complex, loop));
  const Halfedge_index right = complex.next(loop), left = complex.prev(loop);
  return {loop, complex.next(complex.opposite(left)), complex.edge(right), complex.edge(left)};
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_TUBE_H

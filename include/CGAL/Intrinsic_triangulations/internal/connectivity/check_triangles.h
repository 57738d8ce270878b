// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Refuses faces with more or fewer than three sides.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_CHECK_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_CHECK_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The halfedges of a face graph that was copied may have other faces.
inline bool is_triangle(const Delta_complex& complex, Halfedge_index h)
{
  const Halfedge_index last = complex.next(complex.next(h));
  return last == complex.prev(h) && last != h;
}

inline void check_triangles(const Delta_complex& complex)
{
  std::size_t first = 0, count = 0;
  for (Face_index f : complex.faces())
    if (!is_triangle(complex, complex.halfedge(f))) {
      first = count == 0 ? f.idx() : first;
      ++count;
    }
  if (count > 0)
    throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_A_TRIANGLE, first, count,
                                "face " + std::to_string(first) + " is not a triangle (" + std::to_string(count) +
                                  " such faces); triangulate the faces first");
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_CHECK_TRIANGLES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The halfedges around a vertex.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_FOR_EACH_HALFEDGE_AROUND_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_FOR_EACH_HALFEDGE_AROUND_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Calls function(h) for the halfedges that point to v, clockwise from halfedge(v).
template <class Function>
void for_each_halfedge_around(const Delta_complex& complex, Vertex_index v, const Function& function)
{
  const Halfedge_index first = complex.halfedge(v);
  if (!first.is_valid())
    return;
  Halfedge_index h = first;
  do {
    function(h);
    h = complex.next_around_target(h);
  } while (h != first);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_FOR_EACH_HALFEDGE_AROUND_H

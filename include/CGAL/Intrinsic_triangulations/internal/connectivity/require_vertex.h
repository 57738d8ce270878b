// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether a vertex that a user names exists.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REQUIRE_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REQUIRE_VERTEX_H

#include <CGAL/Intrinsic_triangulations/internal/Index.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Throws unless there is such a vertex among n.
inline void require_vertex(Vertex_index v, std::size_t n)
{
  if (!(v.idx() < n))
    throw Invalid_argument_error("there is no vertex " + std::to_string(v.idx()) + ": there are " + std::to_string(n) +
                                 " vertices, counted from 0");
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REQUIRE_VERTEX_H

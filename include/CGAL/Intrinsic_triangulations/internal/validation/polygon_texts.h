// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How the faces, edges and indices of a list of polygons are named in messages.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Polygon_sides.h>

#include <array>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// "5 (corners 1, 2, 3)", with eight corners at most.
std::string face_text(const Polygon_sides& polygons, const std::size_t face);

// "edge 3-17", for the edge of a side.
std::string edge_text(const Polygon_sides& polygons, const std::size_t side);

// The faces of the edge whose first side this is: "faces 5, 8, 9, ...", with eight at most.
std::string faces_text(const Polygon_sides& polygons, const std::size_t side);

// What was -1 before it was converted to std::size_t, or to 32 bits, is shown as -1.
std::string index_text(const std::size_t value);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/validation/polygon_texts_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_H

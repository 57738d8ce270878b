// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Faces of the triangulation without area. Once it is Delaunay, they are parts of such faces of the input and end at
// the border or at a constrained edge, as their longest side would be flipped elsewhere.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACES_WITHOUT_AREA_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACES_WITHOUT_AREA_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <CGAL/enum.h>

#include <optional>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class Traits>
bool has_area(const Intrinsic_triangulation<Traits>& triangulation, Face_index f)
{
  return triangulation.traits().has_positive_area_object()(triangulation.face_data(f)) ||
         engine(triangulation).sign_of_area(f) != ZERO;
}

// The halfedge of an edge in a face without area, if there is one.
template <class Traits>
std::optional<Halfedge_index> side_without_area(const Intrinsic_triangulation<Traits>& triangulation, Edge_index e)
{
  const Delta_complex& complex = triangulation.connectivity();
  for (Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
    if (!complex.is_border(h) && !has_area(triangulation, complex.face(h)))
      return h;
  return std::nullopt;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACES_WITHOUT_AREA_H

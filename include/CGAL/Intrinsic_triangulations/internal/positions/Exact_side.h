// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// On which side of an edge of the other triangulation a point lies, exactly.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <CGAL/enum.h>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// A chord is a segment of the overlay that crosses a face of one triangulation and is part of an
// edge of the other. Both are laid out over the input triangles that the intrinsic edge crosses. In a face of zero
// area there may be no side: if the edge runs along the face, all its points lie on one line.
class Exact_side
{
public:
  Exact_side(const Exact_engine& engine, const Overlay& overlay)
    : intrinsic_(engine.connectivity()), engine_(engine), overlay_(overlay)
  {}

  // The side of a point of the input with respect to a chord of an intrinsic edge.
  std::optional<Sign> of_intrinsic_chord(Overlay::Halfedge chord, const Surface_point& point) const;

  // The side of a point of the intrinsic triangulation with respect to a chord of an input
  // edge that begins on `side`, at a crossing.
  std::optional<Sign> of_input_chord(Overlay::Halfedge chord, Halfedge_index side, const Surface_point& point) const;

private:
  const Delta_complex& intrinsic_;
  const Exact_engine& engine_;
  const Overlay& overlay_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/positions/Exact_side_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_EXACT_SIDE_H

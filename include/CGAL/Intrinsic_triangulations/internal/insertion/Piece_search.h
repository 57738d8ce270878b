// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the piece of the current triangles that contains a point of the input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

namespace CGAL::Intrinsic_triangulations::internal {

// The piece that contains a point which lies strictly inside an input face; one of two if an edge runs through it.
//
// Intrinsic edges cut an input face into convex pieces by chords that do not cross. The search walks from piece to
// piece, each time across a chord that has the point on its other side. Around inserted vertices such a walk may come
// back, if the triangulation is not Delaunay. So after some steps no piece is entered twice: if no chord is left,
// another chord of an earlier piece is taken. All pieces on a straight line to the point can be reached, so the search
// ends there.
// \param start a piece of the same input face
Triangle_piece piece_of_point(const Exact_engine& engine, const Triangle_piece& start, const Surface_point& point);

// The piece at the source of an input halfedge, to the left of that. O(number of edges around the source).
Triangle_piece piece_at_source(const Delta_complex& complex, const Correspondence& correspondence,
                               Halfedge_index input_halfedge);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_PIECE_SEARCH_H

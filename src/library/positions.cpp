// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of positions: those of crossings, and sides of points.

#include <CGAL/Intrinsic_triangulations/internal/positions/Exact_side_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Overlay_positions_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of geodesics: sums of angles, the points that an edge passes, and traced lines.

#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Linked_paths_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/geodesic_points_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/trace_geodesic_impl.h>

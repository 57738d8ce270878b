// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of geodesics.

#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/trace_geodesic_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Connectivity, and what relates it to that of the input.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_checks_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_splits_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates_impl.h>

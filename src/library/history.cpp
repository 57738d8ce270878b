// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the integers that say where the input lies.

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates_impl.h>

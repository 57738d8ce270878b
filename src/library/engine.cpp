// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the exact engine.

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_signs_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Saved_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Saved_triangulation_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum_impl.h>

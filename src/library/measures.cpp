// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of exact questions to points, and what they are refused for.

#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the lengths of the input.

#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Input_metric_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Rational_points.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Rational_points_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the examination of surfaces.

#include <CGAL/Intrinsic_triangulations/validate_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/validate_triangles_impl.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/surface_features_impl.h>

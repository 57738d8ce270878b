// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the validation.

#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/remove_flat_vertices_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/sharp_edges_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/validate_triangles_impl.h>

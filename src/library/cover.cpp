// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of covers.

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/internal/cover/Cover_builder_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the connectivity and of its text format.

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_impl.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_io_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of reading files.

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_io_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/polygon_soup_impl.h>

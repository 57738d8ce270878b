// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the files that hold triangulations.

#include <CGAL/Intrinsic_triangulations/internal/saving/Saved_file.h>
#include <CGAL/Intrinsic_triangulations/internal/saving/Saved_file_impl.h>

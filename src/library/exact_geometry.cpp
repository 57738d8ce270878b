// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of the exact geometry.

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine_impl.h>

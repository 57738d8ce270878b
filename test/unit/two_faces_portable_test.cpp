// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// As on a processor that has nothing for two numbers at once. Header-only, as the library was compiled for another one.

#undef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/FPU.h>
#undef CGAL_HAS_SSE2

#include "two_faces_tests.h"

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Construction and flips with the default traits.

#define CGAL_INTRINSIC_TRIANGULATIONS_EXTERN
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>

using Number_type = CGAL::Intrinsic_triangulations::Mpfr_float;

// In force from before the first test to after the last.
inline const CGAL::Intrinsic_triangulations::Mpfr_precision number_type_precision(128);

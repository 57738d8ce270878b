// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

using Number_type = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

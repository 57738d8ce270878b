// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Interval_nt.h>

using Number_type = CGAL::Interval_nt<true>;

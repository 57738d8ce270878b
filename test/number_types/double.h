// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/number_type_basic.h>

using Number_type = double;

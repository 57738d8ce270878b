// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The headers that both translation units of the consumer include.

#if __has_include(<CGAL/Intrinsic_triangulations.h>)
#include <CGAL/Intrinsic_triangulations.h>
#endif
#include <CGAL/Intrinsic_triangulations/errors.h>

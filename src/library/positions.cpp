// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of positions on an overlay.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/Overlay_positions_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers_impl.h>

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay of input and result, compiled once for all number types.

#ifndef IDT_KERNELS_FIND_OVERLAY_H
#define IDT_KERNELS_FIND_OVERLAY_H

#include "kernels/Kernel.h"

namespace idt {

// Nothing in it depends on the number type: it is made from integers and the exact geometry.
// Where the result is no triangulation of the surface, or `progress` cancels, `outcome.failure`
// says so.
void find_overlay(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                  const CGAL::Intrinsic_triangulations::Exact_geometry& geometry,
                  const CGAL::Intrinsic_triangulations::Progress_function& progress,
                  Outcome& outcome);

} // namespace idt

#endif // IDT_KERNELS_FIND_OVERLAY_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay of input and result, compiled once for all number types.

#ifndef IDT_KERNELS_FIND_OVERLAY_H
#define IDT_KERNELS_FIND_OVERLAY_H

#include "kernels/Kernel.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <functional>

namespace idt {

// Nothing in it depends on the number type: it is made from integers and the exact geometry.
// Where the result is no triangulation of the surface, or `progress` cancels, `outcome.failure`
// says so.
// \param subdivide makes a common subdivision, and is given a function that is told of the progress
void find_overlay(const std::function<CGAL::Intrinsic_triangulations::Common_subdivision(
                    const CGAL::Intrinsic_triangulations::Progress_function&)>& subdivide,
                  const CGAL::Intrinsic_triangulations::Progress_function& progress,
                  Outcome& outcome);

} // namespace idt

#endif // IDT_KERNELS_FIND_OVERLAY_H

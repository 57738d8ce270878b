// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_FINITE_WEIGHTS_H
#define IDT_FINITE_WEIGHTS_H

#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>

namespace idt {

// Element_numbers has infinite weights beside faces of zero area, which a matrix cannot use.
// \param complex the triangulation of the numbers: the surface's, flipped or not
// \exception Invalid_surface_error if a weight is not finite; the message begins with the path of the surface, and
//   names the face of the input to remove
void require_finite_weights(const Surface& surface, const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                            const CGAL::Intrinsic_triangulations::Element_numbers& numbers);

} // namespace idt

#endif // IDT_FINITE_WEIGHTS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_FINITE_WEIGHTS_H
#define IDT_FINITE_WEIGHTS_H

#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>

namespace idt {

// What Element_numbers says of a weight beside a face of zero area, infinity, is none for a matrix.
// \param complex the triangulation of the numbers: that of the surface, flipped or not
// \exception Invalid_surface_error if a weight is not finite; the message begins with the path of the surface, and
//   names the face of the input that has to be removed
void require_finite_weights(const Surface& surface, const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                            const CGAL::Intrinsic_triangulations::Element_numbers& numbers);

} // namespace idt

#endif // IDT_FINITE_WEIGHTS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_FINITE_WEIGHTS_H
#define IDT_FINITE_WEIGHTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <string>
#include <vector>

namespace idt {

// What a kernel says of a weight beside a face of zero area, infinity, is none for a matrix.
// \exception Invalid_surface_error if a weight is not finite; the message begins with `path`
void require_finite_weights(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
                            const std::vector<double>& weights, const std::string& path);

} // namespace idt

#endif // IDT_FINITE_WEIGHTS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>

namespace idt {

Outcome run_float(const Job& job) { return run_kernel<IT::Edge_length_traits<float>>(job); }
Outcome run_double(const Job& job) { return run_kernel<IT::Edge_length_traits<double>>(job); }
Outcome run_long_double(const Job& job) { return run_kernel<IT::Edge_length_traits<long double>>(job); }
Outcome run_half_angle_double(const Job& job) { return run_kernel<IT::Half_angle_traits<double>>(job); }

} // namespace idt

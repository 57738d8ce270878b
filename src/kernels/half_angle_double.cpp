// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>

namespace idt {

Outcome run_half_angle_double(const Job& job)
{
  return run_kernel<IT::Half_angle_traits<double>>(job);
}

} // namespace idt

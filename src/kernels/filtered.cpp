// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>

namespace idt {

Outcome run_filtered(const Job& job)
{
  return run_kernel<IT::Filtered_edge_length_traits>(job);
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/Core_diagnostics.h"
#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

namespace idt {

Outcome run_half_angle_core(const Job& job)
{
  using FT = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;
  const Discarded_core_diagnostics discarded;
  return run_kernel<IT::Half_angle_traits<FT>>(job);
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/Core_diagnostics.h"
#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

namespace idt {

using Core_number = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

Outcome run_core(const Job& job)
{
  const Discarded_core_diagnostics discarded;
  return run_kernel<IT::Edge_length_traits<Core_number>>(job);
}

Outcome run_half_angle_core(const Job& job)
{
  const Discarded_core_diagnostics discarded;
  return run_kernel<IT::Half_angle_traits<Core_number>>(job);
}

} // namespace idt

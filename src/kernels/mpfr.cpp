// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>

namespace idt {

Outcome run_mpfr(const Job& job)
{
  // Numbers take the precision that is in force when they are made, so it must outlive them.
  const IT::Mpfr_precision precision(job.options.precision);
  return run_kernel<IT::Edge_length_traits<IT::Mpfr_float>>(job);
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/run_kernel.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>

#ifndef __SIZEOF_FLOAT128__
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

namespace idt {

Outcome run_float128(const Job& job)
{
#ifdef __SIZEOF_FLOAT128__
  using FT = __float128;
#else
  using FT = boost::multiprecision::cpp_bin_float_quad; // the same numbers, slower
#endif
  return run_kernel<IT::Edge_length_traits<FT>>(job);
}

} // namespace idt

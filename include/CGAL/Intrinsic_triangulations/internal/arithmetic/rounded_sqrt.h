// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Square roots that are rounded once, even if the C library rounds them twice.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_ROUNDED_SQRT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_ROUNDED_SQRT_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <CGAL/FPU.h>
#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {

template <bool>
class Interval_nt;

namespace Intrinsic_triangulations::internal {

// By the processor, in its rounding mode. The function of MinGW-w64, which unoptimized code calls, takes the root in
// the x87 unit: it rounds twice and ignores the mode that CGAL sets for intervals.
inline double rounded_sqrt(double x)
{
#if defined(__SSE2__) || defined(_M_X64)
  const __m128d v = _mm_set_sd(x);
  return _mm_cvtsd_f64(_mm_sqrt_sd(v, v));
#else
  return std::sqrt(x);
#endif
}

template <class FT>
FT rounded_sqrt(const FT& x)
{
  return CGAL::sqrt(x);
}

// Like CGAL's, except for the root of each end.
template <bool is_protected>
Interval_nt<is_protected> rounded_sqrt(const Interval_nt<is_protected>& x)
{
#ifdef CGAL_ALWAYS_ROUND_TO_NEAREST
  return CGAL::sqrt(x);
#else
  typename Interval_nt<is_protected>::Internal_protector protector;
  FPU_set_cw(CGAL_FE_DOWNWARD);
  const double low = x.inf() > 0 ? IA_force_to_double(rounded_sqrt(IA_opacify(x.inf()))) : 0;
  FPU_set_cw(CGAL_FE_UPWARD);
  return {low, IA_up(rounded_sqrt(IA_opacify(x.sup())))};
#endif
}

} // namespace Intrinsic_triangulations::internal
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_ROUNDED_SQRT_H

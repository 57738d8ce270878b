// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The exact sign of a number that is a function of the input's metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIGN_IN_STAGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIGN_IN_STAGES_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/Multiquadratic.h>
#include <CGAL/Intrinsic_triangulations/internal/metric_images.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Whether `evaluate` is proven to be zero; `false` proves nothing.
template <class Evaluate>
bool is_proven_zero(Input_surface& surface, const Evaluate& evaluate,
                    std::size_t maximum_number_of_roots)
{
  try {
    Square_root_basis basis(maximum_number_of_roots);
    Multiquadratic_metric field(surface, {basis});
    return evaluate(field).is_zero();
  } catch (const Too_many_roots&) {
    return false;
  }
}

// The sign of `evaluate(metric)`, by the stages of a Delaunay test (see Late_stages): in
// double-doubles; a proof of zero while there are few roots; multiple precision; a proof of zero
// with any number of roots; more precision. `what` begins the message if even that is not enough.
template <class Evaluate>
Sign sign_in_stages(Input_surface& surface, const Evaluate& evaluate, const std::string& what)
{
  constexpr long largest_precision = 1l << 15;
  constexpr std::size_t few_roots = 4;
  Double_double_metric double_double(surface);
  Uncertain<Sign> sign = evaluate(double_double).sign();
  if (!is_certain(sign) && is_proven_zero(surface, evaluate, few_roots))
    return ZERO;
  for (long precision = 128; !is_certain(sign) && precision <= largest_precision; precision *= 4) {
    Mpfr_metric metric(surface, {precision});
    sign = evaluate(metric).sign();
    if (!is_certain(sign) && precision == 2048 &&
        is_proven_zero(surface, evaluate, Root_mask().size()))
      return ZERO;
  }
  if (!is_certain(sign))
    throw Undecided_error(what + ": it differs from zero by less than 2^-" +
                          std::to_string(largest_precision) +
                          " and cannot be proven to be zero: too many independent square roots");
  return get_certain(sign);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIGN_IN_STAGES_H

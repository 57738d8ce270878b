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

#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The sign of `evaluate(metric)`, by the stages of Exact_geometry: double-doubles, multiple
// precision, a proof of zero in the multiquadratic field, and more precision where that is too
// large. `what` begins the message if even that is not enough.
template <class Evaluate>
Sign sign_in_stages(Input_surface& surface, const Evaluate& evaluate, const std::string& what)
{
  constexpr long largest_precision = 1l << 16;
  Double_double_metric double_double(surface);
  Uncertain<Sign> sign = evaluate(double_double).sign();
  for (long precision = 256; !is_certain(sign) && precision <= largest_precision; precision *= 4) {
    Mpfr_metric metric(surface, {precision});
    sign = evaluate(metric).sign();
    if (is_certain(sign) || precision > 256)
      continue;
    try {
      Square_root_basis basis;
      Multiquadratic_metric field(surface, {basis});
      if (evaluate(field).is_zero())
        return ZERO;
    } catch (const Too_many_roots&) {
    }
  }
  if (!is_certain(sign))
    throw Undecided_error(what + ": it differs from zero by less than 2^-" +
                          std::to_string(largest_precision / 2) +
                          " and cannot be proven to be zero: too many independent square roots");
  return get_certain(sign);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SIGN_IN_STAGES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A number that is a function of the input's metric, in exact numbers, residues and as many bits as it takes.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_NUMBER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_NUMBER_H

#include "../../arithmetic/Multiquadratic.h"
#include "../../arithmetic/Residues.h"
#include "../layout/metric_images.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// Exact facts about a number, however long they take. Ladder.h determines the order of the questions.
class Exact_number
{
public:
  // \param evaluate evaluate(metric) gives the number in any image of the metric; it must outlive this
  // \param may_be_rational whether to try that all roots are rational
  template <class Evaluate>
  Exact_number(
    Input_surface& surface, const Evaluate& evaluate, std::function<bool()> may_be_rational = [] { return true; })
    : surface_(surface), by_intervals_(std::cref(evaluate)), by_expansion_(std::cref(evaluate)),
      by_residues_(std::cref(evaluate)), may_be_rational_(std::move(may_be_rational))
  {}

  // Whether an error below 2^-128 is accepted.
  bool accepts_probable_ties() const { return surface_.accepts_probable_ties(); }

  // The sign, computed in the rationals, if all roots are rational.
  std::optional<Sign> rational_sign() const
  {
    if (!may_be_rational_())
      return std::nullopt;
    try {
      Multiquadratic_field rationals(surface_.interruption(), Multiquadratic_metric::unlimited, 0);
      Multiquadratic_metric metric(surface_, {rationals}, largest_count());
      return static_cast<Sign>(by_expansion_(metric).rational().sign());
    } catch (const Too_costly&) {
      return std::nullopt;
    }
  }

  // A proof either way, if one is found within milliseconds, or within about ten seconds if only proofs are accepted.
  std::optional<bool> is_zero_by_expansion() const
  {
    const std::size_t work = accepts_probable_ties() ? small_work : large_work;
    try {
      Multiquadratic_field field(surface_.interruption(), work);
      Multiquadratic_metric metric(surface_, {field}, largest_count());
      return by_expansion_(metric).is_zero();
    } catch (const Too_costly&) {
      return std::nullopt;
    }
  }

  // `false` is a proof that it is not zero; `true` has an error below 2^-128.
  bool is_zero_in_finite_fields() const
  {
    double certainty = 0;
    for (std::size_t i = 0; certainty < 128; ++i) {
      Residue_rings rings(surface_.prime_fields(i), surface_.interruption());
      Residue_metric metric(surface_, {rings});
      const bool is_zero = by_residues_(metric).is_zero();
      if (!rings.is_defined())
        continue;
      if (!is_zero)
        return false;
      certainty += Residue_rings::certainty(double(metric.number_of_quantities()), metric.largest_size());
    }
    return true;
  }

  Uncertain<Sign> sign_with_bits(long precision) const
  {
    Mpfr_metric& metric = surface_.mpfr_metric(precision);
    return by_intervals_(metric).sign();
  }

  // The sign, with as many bits as it takes. \pre it is not zero
  Sign sign_of_nonzero() const
  {
    for (long precision = 256;; precision = doubled(precision))
      if (const auto sign = sign_with_bits(precision); is_certain(sign))
        return get_certain(sign);
  }

private:
  // Limits on the number of computed terms.
  static constexpr std::size_t small_work = std::size_t(1) << 12, large_work = std::size_t(1) << 22;
  // Exact numbers grow with the number of quantities in them.
  static constexpr std::size_t few_quantities = 1024;

  std::size_t largest_count() const
  {
    return accepts_probable_ties() ? few_quantities : Multiquadratic_metric::unlimited;
  }

  Input_surface& surface_;
  std::function<Mpfr_interval(Mpfr_metric&)> by_intervals_;
  std::function<Multiquadratic(Multiquadratic_metric&)> by_expansion_;
  std::function<Residues(Residue_metric&)> by_residues_;
  std::function<bool()> may_be_rational_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_NUMBER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The exact sign of a number that is a function of the input's metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_SIGN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_SIGN_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include "../../arithmetic/Multiquadratic.h"
#include "../../arithmetic/Residues.h"
#include "../layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

struct Exact_decision
{
  Sign sign;
  Stage stage;
  bool is_rational = false; // all roots in the number are
};

// The stages that follow on double-doubles. A value that double-doubles leave open is more likely zero than not, and
// where no root is irrational that is seen at once; then the proof that takes least is tried. What 128 bits do not tell
// from zero, finite fields do: for other numbers multiple precision comes to an end, however small they are. Of what is
// zero there, an expansion is tried.
class Exact_sign
{
public:
  // \param evaluate evaluate(metric) gives the number in any image of the metric; it has to live as long as this
  // \param may_be_rational whether it is worth a trial that all roots are rational
  template <class Evaluate>
  Exact_sign(Input_surface& surface, const Evaluate& evaluate, bool may_be_rational = true)
    : surface_(surface), by_intervals_(std::cref(evaluate)), by_expansion_(std::cref(evaluate)),
      by_residues_(std::cref(evaluate)), may_be_rational_(may_be_rational)
  {}

  // \param proves_zero tries a proof of zero that is particular to the number
  // \param what gives the beginning of the message where a proof is demanded and there is none
  Exact_decision operator()(const std::function<bool()>& proves_zero, const std::function<std::string()>& what) const
  {
    if (const std::optional<Sign> sign = rational_sign())
      return {*sign, Stage::ALGEBRAIC, true};
    if (proves_zero())
      return {ZERO, Stage::CONGRUENCE};
    if (const auto sign = approximate_sign(128); is_certain(sign))
      return {get_certain(sign), Stage::MULTIPRECISION};
    if (!is_zero_in_finite_fields())
      return {sign_of_nonzero(), Stage::MULTIPRECISION};
    const bool is_proof_demanded = !surface_.accepts_probable_ties();
    if (const auto is_zero = is_zero_by_expansion(is_proof_demanded ? large_work : small_work))
      return *is_zero ? Exact_decision{ZERO, Stage::ALGEBRAIC}
                      : Exact_decision{sign_of_nonzero(), Stage::MULTIPRECISION};
    if (is_proof_demanded)
      throw Undecided_error(what() + " cannot be proven: too many independent square roots. Without the demand for "
                                     "a proof, zero is accepted with an error below 2^-128");
    return {ZERO, Stage::MODULAR};
  }

private:
  // In terms that are computed: milliseconds, and some ten seconds.
  static constexpr std::size_t small_work = std::size_t(1) << 12, large_work = std::size_t(1) << 22;
  // Exact numbers grow with the number of quantities that they are made from.
  static constexpr std::size_t few_quantities = 1024;

  std::size_t largest_count() const
  {
    return surface_.accepts_probable_ties() ? few_quantities : Multiquadratic_metric::unlimited;
  }

  // If all roots are rational: in a field that has no others.
  std::optional<Sign> rational_sign() const
  {
    if (!may_be_rational_)
      return std::nullopt;
    try {
      Multiquadratic_field rationals(surface_.interruption(), Multiquadratic_metric::unlimited, 0);
      Multiquadratic_metric metric(surface_, {rationals}, largest_count());
      return static_cast<Sign>(by_expansion_(metric).rational().sign());
    } catch (const Too_costly&) {
      return std::nullopt;
    }
  }

  // A proof either way, if there is one for so much work.
  std::optional<bool> is_zero_by_expansion(std::size_t work) const
  {
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

  Uncertain<Sign> approximate_sign(long precision) const
  {
    Mpfr_metric metric(surface_, {precision});
    return by_intervals_(metric).sign();
  }

  Sign sign_of_nonzero() const
  {
    for (long precision = 256;; precision = doubled(precision))
      if (const auto sign = approximate_sign(precision); is_certain(sign))
        return get_certain(sign);
  }

  Input_surface& surface_;
  std::function<Mpfr_interval(Mpfr_metric&)> by_intervals_;
  std::function<Multiquadratic(Multiquadratic_metric&)> by_expansion_;
  std::function<Residues(Residue_metric&)> by_residues_;
  bool may_be_rational_;
};

inline bool has_no_other_proof() { return false; }

// The sign, from the first stage on: double-doubles.
// \param evaluate as above. The number has to be a polynomial of degree at most 8 in each quantity that is asked of
//   the metric, as the bound of 2^-128 on the error of finite fields assumes (see Residue_rings::certainty): squared
//   lengths and the numbers of corners have degree 2, so sums of products of up to four of them are.
// \param proves_zero as above
template <class Evaluate, class Describe, class ProvesZero = bool (*)()>
Sign exact_sign(Input_surface& surface, const Evaluate& evaluate, const Describe& what,
                const ProvesZero& proves_zero = has_no_other_proof)
{
  Double_double_metric metric(surface);
  const Uncertain<Sign> sign = evaluate(metric).sign();
  return is_certain(sign) ? get_certain(sign) : Exact_sign(surface, evaluate)(proves_zero, what).sign;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_EXACT_SIGN_H

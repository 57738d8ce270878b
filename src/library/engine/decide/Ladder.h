// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The stages of a decision, in order.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_LADDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_LADDER_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Decisions.h>
#include "../layout/metric_images.h"
#include "Exact_number.h"

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <functional>
#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The sign of the sum of the cotangents at two corners: each stage decides what it can, and passes on the rest. The
// filter comes before the first one here: the traits compare the stored numbers with their error bounds
// (Filtered_edge_length_traits).
// \tparam Corners determines which knowledge may be used and whether results are stored: flips store them, queries only
//   read, and verification uses the input and the integers alone. A stage for which it has no means gives no answer
// \return nothing if `Corners` does not continue
template <class Corners>
std::optional<Exact_decision> sign_by_stages(Corners&& corners)
{
  // Four points of one plane: Coplanar_hinge.
  if (const std::optional<Sign> sign = corners.sign_in_plane())
    return Exact_decision{*sign, Stage::COPLANAR};
  // Corners laid out with error bounds, from points in space or from strips of input triangles: Unfolding. What flips
  // have carried along comes first, with half of the digits, which suffices for most.
  if (!corners.may_be_laid_out())
    return std::nullopt;
  if (const std::optional<Sign> sign = corners.sign_in_doubles())
    return Exact_decision{*sign, Stage::UNFOLDING};
  if (const std::optional<Sign> sign = corners.sign_in_double_doubles())
    return Exact_decision{*sign, Stage::UNFOLDING};
  // A tie by images in finite fields, if flips have carried those along, too.
  if (const std::optional<Sign> sign = corners.sign_of_carried_images())
    return Exact_decision{*sign, Stage::MODULAR};
  // Layouts that were carried along are less accurate.
  if (const std::optional<Sign> sign = corners.sign_laid_out_anew())
    return Exact_decision{*sign, Stage::UNFOLDING};
  // The remaining cases are nearly always ties: the stages below decide them.
  return corners.sign_by_exact_stages();
}

// Proofs that a particular number is zero. They need not succeed.
struct Zero_proofs
{
  std::function<bool()> quick, thorough; // or none
};

// The stages that follow on double-doubles, for any number. A number that they leave open is probably zero. If all
// roots are rational, this is found at once; otherwise the cheapest proof is tried. If 128 bits do not distinguish the
// number from zero, finite fields do: then multiple precision comes to an end, however small the number is. If it is
// zero there, too, an exact expansion may prove it.
// \param what gives the beginning of the message if a demanded proof fails
inline Exact_decision sign_by_exact_stages(const Exact_number& x, const Zero_proofs& proofs,
                                           const std::function<std::string()>& what)
{
  if (proofs.quick && proofs.quick())
    return {ZERO, Stage::CONGRUENCE};
  if (const std::optional<Sign> sign = x.rational_sign())
    return {*sign, Stage::ALGEBRAIC, true};
  if (proofs.thorough && proofs.thorough())
    return {ZERO, Stage::CONGRUENCE};
  if (const Uncertain<Sign> sign = x.sign_with_bits(128); is_certain(sign))
    return {get_certain(sign), Stage::MULTIPRECISION};
  if (!x.is_zero_in_finite_fields())
    return {x.sign_of_nonzero(), Stage::MULTIPRECISION};
  if (const std::optional<bool> is_zero = x.is_zero_by_expansion())
    return *is_zero ? Exact_decision{ZERO, Stage::ALGEBRAIC}
                    : Exact_decision{x.sign_of_nonzero(), Stage::MULTIPRECISION};
  if (!x.accepts_probable_ties())
    throw Undecided_error(what() + " cannot be proven: too many independent square roots. Without the demand for "
                                   "a proof, zero is accepted with an error below 2^-128");
  return {ZERO, Stage::MODULAR};
}

// The sign of any number, from double-doubles on.
// \param evaluate evaluate(metric) gives the number in any image of the metric. It has to be a polynomial of degree at
//   most 8 in each quantity of the metric, as the bound of 2^-128 on the error of finite fields assumes (see
//   Residue_rings::certainty): squared lengths and the numbers of corners have degree 2, so sums of products of up to
//   four of them are.
// \param what as above
// \param proves_zero a thorough proof, or none
template <class Evaluate, class Describe, class ProvesZero = std::function<bool()>>
Sign exact_sign(Input_surface& surface, const Evaluate& evaluate, const Describe& what,
                const ProvesZero& proves_zero = {})
{
  Double_double_metric metric(surface);
  const Uncertain<Sign> sign = evaluate(metric).sign();
  return is_certain(sign) ? get_certain(sign)
                          : sign_by_exact_stages(Exact_number(surface, evaluate), {{}, proves_zero}, what).sign;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_LADDER_H

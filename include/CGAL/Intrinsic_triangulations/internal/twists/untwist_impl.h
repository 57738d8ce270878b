// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definition of untwist().

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWIST_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWIST_IMPL_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/twists/Tube_straightener.h>

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Untwisting untwist(Delta_complex& complex, std::vector<Rational>& squared_lengths,
                   const std::function<bool(Edge_index)>& is_constrained,
                   const std::function<bool(std::uint64_t, std::uint64_t)>& go_further)
{
  if (squared_lengths.size() != complex.number_of_edges())
    throw Invalid_surface_error(Invalid_surface_error::Defect::OUT_OF_RANGE, squared_lengths.size(), 1,
                                "there are " + std::to_string(squared_lengths.size()) + " squared lengths for " +
                                  std::to_string(complex.number_of_edges()) + " edges");
  // Of copies, so that an exception leaves everything as it was.
  Delta_complex result_complex = complex;
  std::vector<Rational> result_lengths = squared_lengths;
  Untwisting result = Tube_straightener(result_complex, result_lengths, is_constrained, go_further).run();
  complex = std::move(result_complex);
  squared_lengths = std::move(result_lengths);
  return result;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<Rational> squared_lengths(const std::vector<double>& lengths)
{
  std::vector<Rational> result;
  result.reserve(lengths.size());
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!(lengths[e] > 0 && lengths[e] <= (std::numeric_limits<double>::max)()))
      throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_FINITE, e, 1,
                                  "the length of edge " + std::to_string(e) + " is not a positive finite number");
    const Rational l(lengths[e]);
    result.push_back(l * l);
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_TWISTS_UNTWIST_IMPL_H

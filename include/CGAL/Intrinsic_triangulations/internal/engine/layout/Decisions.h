// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Settings and statistics of exact decisions.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DECISIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DECISIONS_H

#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/enum.h>

namespace CGAL::Intrinsic_triangulations::internal {

struct Exact_decision
{
  Sign sign;
  Stage stage;              // that decided
  bool is_rational = false; // whether all roots in the number are
};

struct Decisions
{
  // A function that is called from time to time during a single long decision, by the deciding threads, possibly
  // several at once. Copies of an engine do not inherit it.
  Interruption interruption;
  Tie_proof tie_proof = Tie_proof::PROBABLE_IF_COSTLY; // the required proof of a tie
  Stage_counts counts;                                 // how tests were decided
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_DECISIONS_H

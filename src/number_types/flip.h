// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The flips of a run, and the counts made on the way.

#ifndef IDT_NUMBER_TYPES_FLIP_H
#define IDT_NUMBER_TYPES_FLIP_H

#include "number_types/refine.h"
#include "number_types/run.h"
#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Uncertain.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// Asks the caller whether to go on, and remembers the number of flips in case an exception ends them.
template <class Traits>
class Asking_visitor
{
public:
  // Crossings are counted if `crossings` is given for this triangulation.
  Asking_visitor(const IT::Intrinsic_triangulation<Traits>& triangulation, const Continue_function& go_further,
                 std::optional<IT::Crossing_counts>& crossings)
    : triangulation_(triangulation), go_further_(go_further), crossings_(crossings)
  {}

  bool go_further(const IT::Progress& progress)
  {
    const std::uint64_t tests = progress.tests, flips = progress.flips;
    const bool is_within_test = tests == tests_ && flips == asked_flips_;
    tests_ = tests;
    asked_flips_ = flips;
    return !go_further_ || (tests % stride != 0 && !is_within_test) || go_further_(tests, flips);
  }
  void after_flip(IT::Edge_index e)
  {
    ++flips_;
    if (crossings_)
      crossings_->after_flip(triangulation_.connectivity(), e);
  }

  std::uint64_t tests() const { return tests_; }
  std::uint64_t flips() const { return flips_; }

protected:
  const IT::Intrinsic_triangulation<Traits>& triangulation_;

private:
  // With built-in numbers a test is faster than asking.
  static constexpr std::uint64_t stride = std::is_floating_point<typename Traits::FT>::value ? 64 : 1;

  const Continue_function& go_further_;
  std::optional<IT::Crossing_counts>& crossings_;
  std::uint64_t tests_ = 0, flips_ = 0, asked_flips_ = 0;
};

// Checks each test against the exact geometry of the same edge. An undecided test is not wrong, and only tests that are
// proven wrong are counted.
template <class Traits>
class Decision_counter : public Asking_visitor<Traits>
{
public:
  using Asking_visitor<Traits>::Asking_visitor;

  void after_test(IT::Edge_index e, typename Traits::Boolean is_Delaunay)
  {
    if (!CGAL::is_certain(is_Delaunay))
      return;
    try {
      number_of_wrong_ +=
        CGAL::certainly(is_Delaunay) == (this->triangulation_.sign_of_cotangent_weight(e) == CGAL::NEGATIVE);
    } catch (const IT::Undecided_error&) {
    }
  }

  std::uint64_t number_of_wrong() const { return number_of_wrong_; }

private:
  std::uint64_t number_of_wrong_ = 0;
};

template <class Traits, class Visitor>
IT::Flip_report flip_with(IT::Intrinsic_triangulation<Traits>& triangulation, const Job& job, Visitor& visitor)
{
  const std::uint64_t budget = job.options.maximum_number_of_flips.value_or(
    Traits::Has_exact_decisions::value
      ? (std::numeric_limits<std::uint64_t>::max)()
      : IT::default_maximum_number_of_flips(triangulation.connectivity().number_of_edges()));
  const auto parameters = CGAL::parameters::visitor(std::ref(visitor)).maximum_number(budget);
  if constexpr (Traits::Uses_exact_geometry::value)
    if (job.options.refinement) {
      if (chooses_edges(*job.options.refinement))
        return {}; // it determines which edges are flipped before it, too
      const std::vector<bool> is_constrained =
        first_constraints(triangulation, job, job.options.refinement->is_constrained);
      return IT::flip_to_Delaunay(triangulation, parameters.edge_is_constrained_map(edge_flags(is_constrained)));
    }
  return IT::flip_to_Delaunay(triangulation, parameters);
}

template <class Traits, class Visitor>
void flip(IT::Intrinsic_triangulation<Traits>& triangulation, const Job& job, Visitor& visitor, Outcome& outcome)
{
  const Stopwatch stopwatch;
  try {
    outcome.report = flip_with(triangulation, job, visitor);
  } catch (const IT::Invalid_surface_error&) {
    throw;
  } catch (const IT::Cancelled_error&) {
    outcome.are_flips_cancelled = true;
    outcome.report.status = IT::Flip_status::BUDGET_EXHAUSTED;
    outcome.report.tests = visitor.tests();
    outcome.report.flips = visitor.flips();
  } catch (const IT::Error& error) {
    // The triangulation is as it was before the decision that failed.
    outcome.failure = error.what();
    outcome.report.status = IT::Flip_status::UNDECIDED;
    outcome.report.tests = visitor.tests() + 1;
    outcome.report.flips = visitor.flips();
  }
  outcome.flip_seconds = stopwatch.seconds();
}

template <class Traits>
void flip(IT::Intrinsic_triangulation<Traits>& triangulation, const Job& job, Outcome& outcome)
{
  if (job.options.wanted.wrong_decisions) {
    Decision_counter<Traits> counter(triangulation, job.go_further, outcome.original_crossings);
    flip(triangulation, job, counter, outcome);
    outcome.wrong_decisions = counter.number_of_wrong();
  } else {
    Asking_visitor<Traits> visitor(triangulation, job.go_further, outcome.original_crossings);
    flip(triangulation, job, visitor, outcome);
  }
}

} // namespace idt

#endif // IDT_NUMBER_TYPES_FLIP_H

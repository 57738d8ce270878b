// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every kernel does, for any traits; each source beside this file instantiates it
// once.

#ifndef IDT_KERNELS_RUN_KERNEL_H
#define IDT_KERNELS_RUN_KERNEL_H

#include "kernels/Decision_counter.h"
#include "kernels/Kernel.h"
#include "kernels/Number_collector.h"
#include "kernels/make_triangulation.h"
#include "kernels/find_overlay.h"
#include "kernels/refine.h"
#include "kernels/summarize_shapes.h"

#include "system/Stopwatch.h"
#include "system/for_each_block.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/rational_metric.h>

#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// The metric that the file says, before any rounding to a number type.
inline IT::Input_metric input_metric(const Surface& surface)
{
  if (!surface.squared_lengths.empty()) {
    IT::Input_metric metric = IT::metric_from_squared_lengths(surface.squared_lengths);
    metric.check(surface.connectivity);
    return metric;
  }
  if (!surface.has_points())
    return IT::Input_metric::from_lengths(surface.lengths);
  return IT::Input_metric::from_points(
    surface.connectivity, IT::Input_metric::Point_vector(surface.points.begin(), surface.points.end()));
}

// The squared edge lengths and areas handle a face of zero area; half-angle tangents do
// not, and what they make of it is no answer. The factors are those that
// tan_half_angle() forms, in its order of operations.
template <class Traits>
void require_usable_faces(const IT::Intrinsic_triangulation<Traits>&)
{}
template <class FT>
void require_usable_faces(const IT::Intrinsic_triangulation<IT::Half_angle_traits<FT>>& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const auto length = [&](IT::Halfedge_index h) -> const FT& {
    return triangulation.edge_data(complex.edge(h));
  };
  IT::internal::Defect_tally offenders;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    const FT &a = length(h), &b = length(complex.next(h)), &c = length(complex.prev(h));
    const auto is_usable = [](const FT& x, const FT& y, const FT& z) {
      return CGAL::certainly(x - y + z > FT(0)) && CGAL::certainly(x + y - z > FT(0)) &&
             CGAL::certainly(y + z - x > FT(0));
    };
    if (!is_usable(a, b, c) || !is_usable(b, c, a) || !is_usable(c, a, b))
      offenders.add(f.idx());
  }
  if (offenders.count > 0)
    throw IT::Invalid_surface_error(
      IT::Invalid_surface_error::Defect::DEGENERATE_FACE, offenders.first, offenders.count,
      "face " + std::to_string(offenders.first) + " has zero area" + offenders.and_more() +
        ", which half-angle tangents cannot handle; try --number-type filtered");
}

// Asks the caller whether to go on, and remembers how far the flips are in case that an
// exception ends them.
class Asking_visitor
{
public:
  // The caller is asked before every `stride`-th test, a power of two. Crossings are counted if there are `crossings` of that complex.
  Asking_visitor(const Continue_function& go_further, std::uint64_t stride, const IT::Delta_complex& complex,
                 std::optional<IT::Crossing_counts>& crossings)
    : go_further_(go_further), mask_(go_further ? stride - 1 : ~std::uint64_t(0)), complex_(complex), crossings_(crossings)
  {}

  bool go_further(std::uint64_t tests, std::uint64_t flips)
  {
    tests_ = tests;
    return (tests & mask_) != 0 || !go_further_ || go_further_(tests, flips);
  }
  void after_flip(IT::Edge_index e)
  {
    ++flips_;
    if (crossings_)
      crossings_->after_flip(complex_, e);
  }

  std::uint64_t tests() const { return tests_; }
  std::uint64_t flips() const { return flips_; }

private:
  const Continue_function& go_further_;
  std::uint64_t mask_;
  const IT::Delta_complex& complex_;
  std::optional<IT::Crossing_counts>& crossings_;
  std::uint64_t tests_ = 0;
  std::uint64_t flips_ = 0;
};

// By a Whole_triangulation, or a Decision_counter.
template <class Flippable, class ConstraintMap = CGAL::Static_boolean_property_map<IT::Edge_index, false>>
void flip(const Flippable& flippable, const Job& job, Outcome& outcome, const ConstraintMap& is_constrained = {})
{
  using Traits = typename Flippable::Traits;
  auto& triangulation = flippable.triangulation();
  const std::size_t number_of_edges = triangulation.connectivity().number_of_edges();
  const std::uint64_t budget = job.options.maximum_number_of_flips.value_or(
    Traits::Has_exact_decisions::value ? (std::numeric_limits<std::uint64_t>::max)()
                                       : IT::default_maximum_number_of_flips(number_of_edges));
  // With built-in numbers a test is faster than the question.
  Asking_visitor visitor(job.go_further,
                         std::is_floating_point<typename Traits::FT>::value ? 64 : 1, triangulation.connectivity(),
                         outcome.original_crossings);
  // A single decision can take long, and the visitor does not pass each question on.
  std::function<bool()> afterwards;
  if constexpr (Traits::Uses_exact_geometry::value)
    if (job.go_further)
      afterwards = triangulation.set_interruption(
        [&] { return job.go_further(visitor.tests(), visitor.flips()); });
  const Stopwatch stopwatch;
  try {
    outcome.report = IT::internal::flip_all<CGAL::Sequential_tag>(flippable, is_constrained, visitor, budget);
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
  if constexpr (Traits::Uses_exact_geometry::value)
    if (job.go_further)
      triangulation.set_interruption(std::move(afterwards));
}

template <class Traits>
void flip_and_refine(IT::Intrinsic_triangulation<Traits>& triangulation, const Job& job, Outcome& outcome)
{
  const IT::internal::Whole_triangulation<Traits> whole(triangulation);
  if constexpr (Traits::Uses_exact_geometry::value)
    if (job.options.refinement) {
      flip(whole, job, outcome, Edge_flags{&job.options.refinement->is_constrained});
      refine(triangulation, job, outcome);
      return;
    }
  flip(whole, job, outcome);
}

template <class Triangulation>
void find_crossings(const Triangulation& triangulation, Outcome& outcome)
{
  Crossing_summary summary;
  outcome.crossings.reserve(triangulation.connectivity().number_of_edges());
  for (IT::Edge_index e : triangulation.connectivity().edges()) {
    const bool is_input_edge = triangulation.is_input_edge(e);
    const std::uint64_t n = static_cast<std::uint64_t>(triangulation.number_of_crossings(e));
    outcome.crossings.push_back(is_input_edge ? -1 : triangulation.number_of_crossings(e));
    summary.simple += n == 1;
    summary.longest = (std::max)(summary.longest, n + 1);
    summary.changed += !is_input_edge;
    if (n > (std::numeric_limits<std::uint64_t>::max)() - summary.crossings)
      throw IT::Integer_overflow_error("all edges together cross more than 2^64 input edges");
    summary.crossings += n;
  }
  outcome.crossing_summary = summary;
}

template <class Triangulation>
void find_ties(const Triangulation& triangulation, Outcome& outcome)
{
  const IT::Delaunay_tessellation tessellation(triangulation);
  Tessellation_summary summary;
  summary.cells = tessellation.number_of_cells();
  outcome.is_tie.reserve(triangulation.connectivity().number_of_edges());
  for (IT::Edge_index e : triangulation.connectivity().edges()) {
    outcome.is_tie.push_back(tessellation.is_tie(e));
    summary.ties += tessellation.is_tie(e);
  }
  outcome.tessellation = summary;
}

// The tests that reached the exact geometry are counted there; the rest is the filter's.
inline void find_stages(const IT::internal::Exact_engine& geometry, Outcome& outcome)
{
  IT::Stage_counts counts = geometry.stage_counts();
  std::uint64_t& filter = counts.decided[static_cast<std::size_t>(IT::Stage::FILTER)];
  filter = outcome.report.tests;
  for (std::size_t stage = 0; stage < IT::number_of_stages; ++stage)
    if (stage != static_cast<std::size_t>(IT::Stage::FILTER))
      filter -= counts.decided[stage];
  outcome.stages = counts;
}

// On all processors.
template <class Triangulation, class ConstraintMap>
IT::Delaunay_verification verify(const Triangulation& triangulation, const ConstraintMap& is_constrained)
{
  return IT::internal::Delaunay_verifier(IT::internal::engine(triangulation), is_constrained)
    .verify([](std::size_t n, const auto& f) { for_each_block(n, 1, f); });
}
template <class Triangulation>
IT::Delaunay_verification verify(const Triangulation& triangulation, const Job& job)
{
  if constexpr (Triangulation::uses_exact_geometry)
    if (job.options.refinement) {
      const std::vector<bool> is_constrained = constrained_parts(triangulation, job.options.refinement->is_constrained);
      return verify(triangulation, Edge_flags{&is_constrained});
    }
  return verify(triangulation, CGAL::Static_boolean_property_map<IT::Edge_index, false>());
}

// What the input and the integers tell about the result.
template <class Triangulation>
void relate_to_input(const Triangulation& triangulation, const Job& job, Outcome& outcome)
{
  const Requested_results& wanted = job.options.wanted;
  const IT::Delta_complex& complex = triangulation.connectivity();
  Stopwatch stopwatch;
  try {
    if constexpr (Triangulation::uses_exact_geometry)
      if (!job.options.refinement) // which does not count its tests
        find_stages(IT::internal::engine(triangulation), outcome);
    if (wanted.crossings) {
      find_crossings(triangulation, outcome);
      outcome.crossing_summary->seconds = stopwatch.restart();
    }
    if (wanted.verification)
      outcome.verification = verify(triangulation, job);
    const bool is_Delaunay =
      outcome.verification ? outcome.verification->is_Delaunay()
                           : Triangulation::Traits::Has_exact_decisions::value &&
                               outcome.report.status == IT::Flip_status::DELAUNAY;
    if (wanted.tessellation && is_Delaunay)
      find_ties(triangulation, outcome);
    if (wanted.shapes) {
      using Faces = std::vector<IT::Unrefined_face>;
      outcome.shapes = summarize_shapes(triangulation, outcome.refinement ? outcome.refinement->report.unrefined : Faces());
    }
    if (wanted.exact_lengths) {
      outcome.exact_lengths.reserve(complex.number_of_edges());
      for (IT::Edge_index e : complex.edges())
        outcome.exact_lengths.push_back(IT::internal::engine(triangulation).length(e));
    }
  } catch (const IT::Invalid_surface_error&) {
    throw;
  } catch (const IT::Error& error) {
    outcome.is_interrupted = outcome.is_interrupted || dynamic_cast<const IT::Cancelled_error*>(&error) != nullptr;
    if (outcome.failure.empty())
      outcome.failure = error.what();
  }
  outcome.check_seconds = stopwatch.seconds();
}

template <class Traits>
Outcome run_kernel(const Job& job, const Traits& traits = Traits())
{
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  const Requested_results& wanted = job.options.wanted;
  Outcome outcome;
  if (job.surface.untwisting)
    outcome.original_crossings = job.surface.untwisting->crossings;
  Stopwatch stopwatch;
  Triangulation triangulation = make_triangulation(job.surface, traits);
  require_usable_faces(triangulation);
  outcome.build_seconds = stopwatch.restart();

  if (wanted.needs_input() && !triangulation.keeps_input())
    triangulation.keep_input(input_metric(job.surface));
  if (triangulation.keeps_input())
    triangulation.set_interruption(job.go_on_deciding);
  if (wanted.weights)
    outcome.weights_before = summarize_weights(triangulation, [&]([[maybe_unused]] IT::Edge_index e) {
      if constexpr (Triangulation::uses_exact_geometry)
        return input_weight(triangulation.connectivity(), IT::internal::engine(triangulation).metric(), e);
      return std::numeric_limits<double>::quiet_NaN();
    });
  if (wanted.input_numbers)
    collect_numbers(triangulation, true, true, outcome.input_numbers);

  outcome.summary_seconds = stopwatch.restart();

  if (triangulation.keeps_input())
    triangulation.set_tie_proof(job.options.tie_proof);
  if (wanted.wrong_decisions) {
    std::uint64_t wrong_decisions = 0;
    flip(Decision_counter<Traits>(triangulation, wrong_decisions), job, outcome);
    outcome.wrong_decisions = wrong_decisions;
  } else {
    flip_and_refine(triangulation, job, outcome);
  }
  if (outcome.refinement && outcome.refinement->is_given_up)
    return outcome;
  if (wanted.overlay && job.overlay_progress)
    job.overlay_progress(0);

  if (wanted.needs_input())
    relate_to_input(triangulation, job, outcome);
  // Proofs were demanded of decisions: to find a weight, a tie is not proven once more.
  if (triangulation.keeps_input())
    triangulation.set_tie_proof(IT::Tie_proof::PROBABLE_IF_COSTLY);
  stopwatch.restart();
  if (wanted.weights)
    outcome.weights_after =
      summarize_weights(triangulation, [](IT::Edge_index) { return std::numeric_limits<double>::quiet_NaN(); });
  outcome.summary_seconds += stopwatch.restart();
  if (wanted.lengths || wanted.numbers)
    collect_numbers(triangulation, wanted.lengths, wanted.numbers, outcome.numbers);
  outcome.number_seconds = stopwatch.restart();
  outcome.connectivity = triangulation.connectivity();
  if (wanted.overlay && outcome.crossing_summary) // last, as it takes the most memory
    find_overlay([&](const IT::Progress_function& progress) { return IT::Common_subdivision(std::move(triangulation), CGAL::parameters::visitor(progress)); },
                 job.overlay_progress, outcome);
  return outcome;
}

} // namespace idt

#endif // IDT_KERNELS_RUN_KERNEL_H

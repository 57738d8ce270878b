// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/run.h"

#include "number_types/Core_diagnostics.h"
#include "number_types/flip.h"
#include "number_types/make_triangulation.h"
#include "number_types/refine.h"
#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>
#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#ifndef __SIZEOF_FLOAT128__
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

// One thread makes the flips, so that ties are broken in the same way everywhere; numbers do not depend on threads.
using Concurrency_tag = CGAL::Parallel_if_available_tag;

// The metric of the file, before any rounding to a number type.
IT::Input_metric input_metric(const Surface& surface)
{
  if (!surface.squared_lengths.empty()) {
    IT::Input_metric metric = IT::metric_from_squared_lengths(surface.squared_lengths);
    metric.check(surface.connectivity);
    return metric;
  }
  if (!surface.has_points())
    return IT::Input_metric::from_lengths(surface.lengths);
  return IT::Input_metric::from_points(surface.connectivity,
                                       IT::Input_metric::Point_vector(surface.points.begin(), surface.points.end()));
}

// Squared lengths and areas can handle a face of zero area; half-angle tangents cannot. The factors are those of
// tan_half_angle(), in its order of operations.
template <class Traits>
void require_usable_faces(const IT::Intrinsic_triangulation<Traits>&)
{}
template <class FT>
void require_usable_faces(const IT::Intrinsic_triangulation<IT::Half_angle_traits<FT>>& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const auto length = [&](IT::Halfedge_index h) -> const FT& { return triangulation.edge_data(complex.edge(h)); };
  std::size_t first = 0, count = 0;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    const FT &a = length(h), &b = length(complex.next(h)), &c = length(complex.prev(h));
    const auto is_usable = [](const FT& x, const FT& y, const FT& z) {
      return CGAL::certainly(x - y + z > FT(0)) && CGAL::certainly(x + y - z > FT(0)) &&
             CGAL::certainly(y + z - x > FT(0));
    };
    if ((!is_usable(a, b, c) || !is_usable(b, c, a) || !is_usable(c, a, b)) && count++ == 0)
      first = f.idx();
  }
  if (count > 0)
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::DEGENERATE_FACE, first, count,
                                    "face " + std::to_string(first) + " has zero area" +
                                      (count > 1 ? " (and " + std::to_string(count - 1) + " more)" : std::string()) +
                                      ", which half-angle tangents cannot handle; try --number-type filtered");
}

// The numbers that the flips have left, in case there is no time for better ones.
template <class Traits>
IT::Element_numbers stored_numbers(const IT::Intrinsic_triangulation<Traits>& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const auto evaluate = [&](const auto& functor, IT::Halfedge_index h) {
    return CGAL::to_double(functor(triangulation.face_data(complex.face(h)), triangulation.edge_data(complex.edge(h)),
                                   triangulation.edge_data(complex.edge(complex.next(h))),
                                   triangulation.edge_data(complex.edge(complex.prev(h)))));
  };
  IT::Element_numbers result;
  for (IT::Edge_index e : complex.edges()) {
    result.lengths.push_back(std::sqrt(CGAL::to_double(triangulation.squared_length(e))));
    double weight = 0;
    for (IT::Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))})
      weight += complex.is_border(h) ? 0 : evaluate(triangulation.traits().compute_cotangent_object(), h);
    result.cotangent_weights.push_back(std::isnan(weight) ? 0 : weight);
  }
  for (IT::Face_index f : complex.faces())
    result.areas.push_back(std::ldexp(evaluate(triangulation.traits().compute_area_object(), complex.halfedge(f)),
                                      2 * triangulation.unit_exponent()));
  return result;
}

template <class Triangulation>
IT::Element_numbers find_numbers(const Triangulation& triangulation)
{
  try {
    return IT::element_numbers<Concurrency_tag>(triangulation);
  } catch (const IT::Cancelled_error&) {
    return stored_numbers(triangulation);
  }
}

template <class Triangulation>
std::vector<double> find_lengths(const Triangulation& triangulation)
{
  try {
    return IT::edge_lengths<Concurrency_tag>(triangulation);
  } catch (const IT::Cancelled_error&) {
    return stored_numbers(triangulation).lengths;
  }
}

template <class Triangulation>
IT::Weight_summary summarize_weights(const Triangulation& triangulation)
{
  try {
    return IT::summarize_cotangent_weights(triangulation);
  } catch (const IT::Cancelled_error&) {
    IT::Weight_summary result;
    const std::vector<double> weights = stored_numbers(triangulation).cotangent_weights;
    for (IT::Edge_index e : triangulation.connectivity().edges()) {
      const double weight = weights[e.idx()];
      result.infinite += std::isinf(weight);
      if (triangulation.connectivity().is_border(e))
        continue;
      result.negative += weight < 0;
      if (std::isfinite(weight))
        result.smallest = (std::min)(weight, result.smallest.value_or(weight));
    }
    return result;
  }
}

template <class Triangulation>
void find_crossings(const Triangulation& triangulation, Outcome& outcome)
{
  Crossing_summary summary;
  outcome.crossings.reserve(triangulation.connectivity().number_of_edges());
  for (IT::Edge_index e : triangulation.connectivity().edges()) {
    const bool is_input_edge = triangulation.is_input_edge(e);
    const std::int64_t number = triangulation.number_of_crossings(e);
    const std::uint64_t n = static_cast<std::uint64_t>(number);
    outcome.crossings.push_back(is_input_edge ? -1 : number);
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

// The smallest angle and the largest circumradius. Lists the faces that a cancelled refinement did not reach.
// \return nothing for a triangulation without faces
template <class Triangulation>
std::optional<Shape_summary> summarize_shapes(const Triangulation& triangulation,
                                              const std::optional<Refinement_options>& options,
                                              std::optional<Refinement_summary>& refinement)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  if (complex.number_of_faces() == 0)
    return std::nullopt;
  std::vector<bool> is_listed(complex.number_of_faces());
  if (refinement)
    for (const IT::Unrefined_face& f : refinement->report.unrefined)
      is_listed[f.face.idx()] = true;
  // More digits than needed.
  const std::vector<double> angles =
    IT::opposite_angles<Concurrency_tag>(triangulation, CGAL::parameters::relative_error(0x1p-24));
  Shape_summary summary;
  summary.minimum_angle = 180;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    IT::Halfedge_index opposite = h;
    for (IT::Halfedge_index side : {complex.next(h), complex.prev(h)})
      if (angles[side.idx()] < angles[opposite.idx()])
        opposite = side;
    const double smallest = angles[opposite.idx()], degrees = smallest * (180 / CGAL_PI);
    summary.minimum_angle = (std::min)(summary.minimum_angle, degrees);
    // The smallest angle is at most 60 degrees, where the sine is accurate.
    const double shortest = CGAL::to_double(triangulation.length(complex.edge(opposite))),
                 radius =
                   smallest > 0 ? shortest / (2 * std::sin(smallest)) : (std::numeric_limits<double>::infinity)();
    summary.maximum_circumradius = (std::max)(summary.maximum_circumradius, radius);
    if (refinement && refinement->is_cancelled) {
      const auto& criteria = options->criteria;
      double longest = 0;
      for (IT::Halfedge_index side : {h, complex.next(h), complex.prev(h)})
        longest = (std::max)(longest, CGAL::to_double(triangulation.length(complex.edge(side))));
      is_listed[f.idx()] = degrees < criteria.minimum_angle || radius > criteria.maximum_circumradius ||
                           longest > criteria.maximum_edge_length;
      if (is_listed[f.idx()])
        refinement->report.unrefined.push_back({f, shortest < criteria.minimum_size.value_or(0)
                                                     ? IT::Refinement_obstacle::TOO_SMALL
                                                     : IT::Refinement_obstacle::BUDGET});
    }
    if (!is_listed[f.idx()])
      summary.minimum_refined_angle = (std::min)(summary.minimum_refined_angle.value_or(degrees), degrees);
  }
  return summary;
}

// Of all edges but those that are kept; with a maximum deviation, these are parts of any edges of the input.
template <class Triangulation>
IT::Delaunay_verification verify(const Triangulation& triangulation, const Job& job, const Outcome& outcome)
{
  if constexpr (Triangulation::uses_exact_geometry)
    if (outcome.refinement) {
      const bool keeps_folds = std::isfinite(job.options.refinement->criteria.maximum_deviation);
      const std::vector<bool> is_constrained =
        constrained_parts(triangulation, keeps_folds ? std::vector<bool>(triangulation.input().number_of_edges(), true)
                                                     : outcome.refinement->is_constrained);
      return IT::verify_Delaunay<Concurrency_tag>(
        triangulation, CGAL::parameters::edge_is_constrained_map(edge_flags(is_constrained)));
    }
  return IT::verify_Delaunay<Concurrency_tag>(triangulation);
}

// The first sides of the faces of the input, as they were read.
std::vector<IT::Halfedge_index> first_sides(const Surface& surface)
{
  std::vector<IT::Halfedge_index> result;
  for (IT::Face_index f : surface.connectivity.faces())
    result.push_back(surface.connectivity.halfedge(f));
  return result;
}

// With the edges that refinement had to keep.
template <class Triangulation>
void save(const Triangulation& triangulation, const Job& job, Outcome& outcome)
{
  if constexpr (Triangulation::uses_exact_geometry) {
    std::ostringstream os;
    const auto parameters = CGAL::parameters::visitor(
      IT::Progress_function([&job](double) { return !job.go_on_deciding || job.go_on_deciding(); }));
    if (outcome.refinement && !outcome.refinement->is_constrained.empty()) {
      const std::vector<bool> is_constrained = constrained_parts(triangulation, outcome.refinement->is_constrained);
      IT::write_triangulation(os, triangulation, first_sides(job.surface),
                              parameters.edge_is_constrained_map(edge_flags(is_constrained)));
    } else {
      IT::write_triangulation(os, triangulation, first_sides(job.surface), parameters);
    }
    outcome.saved = std::move(os).str();
  }
}

// Notes the reason why a result could not be determined.
void note_failure(const IT::Error& error, const std::string& text, Outcome& outcome)
{
  outcome.is_interrupted = outcome.is_interrupted || dynamic_cast<const IT::Cancelled_error*>(&error) != nullptr;
  if (outcome.failure.empty())
    outcome.failure = text + error.what();
}

// Results that follow from the input and the integers.
template <class Triangulation>
void relate_to_input(const Triangulation& triangulation, const Job& job, Outcome& outcome)
{
  const Requested_results& wanted = job.options.wanted;
  Stopwatch stopwatch;
  try {
    if (wanted.crossings) {
      find_crossings(triangulation, outcome);
      outcome.crossing_summary->seconds = stopwatch.restart();
    }
    if (wanted.verification)
      outcome.verification = verify(triangulation, job, outcome);
    const bool is_Delaunay = outcome.verification ? outcome.verification->is_Delaunay()
                                                  : Triangulation::Traits::Has_exact_decisions::value &&
                                                      outcome.report.status == IT::Flip_status::DELAUNAY;
    if (wanted.tessellation && is_Delaunay)
      find_ties(triangulation, outcome);
    if (wanted.shapes)
      outcome.shapes = summarize_shapes(triangulation, job.options.refinement, outcome.refinement);
    if (wanted.exact_lengths)
      outcome.exact_lengths = IT::exact_edge_lengths(triangulation);
    if (wanted.saved)
      save(triangulation, job, outcome);
  } catch (const IT::Invalid_surface_error&) {
    throw;
  } catch (const IT::Error& error) {
    note_failure(error, "", outcome);
  }
  outcome.check_seconds = stopwatch.seconds();
}

// Empty if the result is not a triangulation of the surface, or if the caller cancels.
template <class Triangulation>
void find_overlay(Triangulation&& triangulation, const IT::Progress_function& progress, Outcome& outcome)
{
  const Stopwatch stopwatch;
  double graph_seconds = 0;
  const IT::Progress_function note_time = [&](double fraction) {
    if (fraction <= IT::Common_subdivision::part_of_graph)
      graph_seconds = stopwatch.seconds();
    return !progress || progress(fraction);
  };
  try {
    outcome.subdivision.emplace(IT::Common_subdivision(std::move(triangulation), CGAL::parameters::visitor(note_time)));
    outcome.crossing_summary->position_seconds = stopwatch.seconds() - graph_seconds;
    outcome.crossing_summary->seconds += graph_seconds;
  } catch (const IT::Error& error) {
    note_failure(error, "there is no overlay: ", outcome);
    outcome.crossing_summary->seconds += stopwatch.seconds();
  }
}

// Before the flips.
template <class Triangulation>
void find_input_numbers(const Triangulation& triangulation, const Requested_results& wanted, Outcome& outcome)
{
  const Stopwatch stopwatch;
  if (wanted.weights)
    outcome.weights_before = summarize_weights(triangulation);
  if (wanted.input_numbers)
    outcome.input_numbers = find_numbers(triangulation);
  outcome.summary_seconds = stopwatch.seconds();
}

// Of the result.
template <class Triangulation>
void find_result_numbers(const Triangulation& triangulation, const Requested_results& wanted, Outcome& outcome)
{
  Stopwatch stopwatch;
  if (wanted.weights)
    outcome.weights_after = summarize_weights(triangulation);
  outcome.summary_seconds += stopwatch.restart();
  if (wanted.numbers)
    outcome.numbers = find_numbers(triangulation);
  else if (wanted.lengths)
    outcome.numbers.lengths = find_lengths(triangulation);
  outcome.number_seconds = stopwatch.seconds();
}

template <class Traits>
Outcome run_with(const Job& job)
{
  const Requested_results& wanted = job.options.wanted;
  Outcome outcome;
  if (job.surface.untwisting)
    outcome.original_crossings = job.surface.untwisting->crossings;
  const Stopwatch stopwatch;
  auto triangulation = first_triangulation<Traits>(job.surface);
  require_usable_faces(triangulation);
  outcome.build_seconds = stopwatch.seconds();

  if (wanted.needs_input() && !triangulation.keeps_input())
    triangulation.keep_input(input_metric(job.surface));
  if (triangulation.keeps_input())
    triangulation.set_interruption(job.go_on_deciding);
  if (job.surface.saved && (wanted.weights || wanted.input_numbers))
    find_input_numbers(make_triangulation<Traits>(job.surface), wanted, outcome);
  else
    find_input_numbers(triangulation, wanted, outcome);
  if (triangulation.keeps_input())
    triangulation.set_tie_proof(job.options.tie_proof);

  if (!(job.options.keeps_saved && job.surface.saved))
    flip(triangulation, job, outcome);
  if constexpr (Traits::Uses_exact_geometry::value) {
    if (job.options.refinement)
      refine(triangulation, job, outcome);
    else if (wanted.needs_input())
      outcome.stages = triangulation.stage_counts();
  }
  if (wanted.overlay && job.overlay_progress)
    job.overlay_progress(0);

  if (wanted.needs_input())
    relate_to_input(triangulation, job, outcome);
  // Proofs were demanded for decisions; for weights, ties are not proven again.
  if (triangulation.keeps_input())
    triangulation.set_tie_proof(IT::Tie_proof::PROBABLE_IF_COSTLY);
  find_result_numbers(triangulation, wanted, outcome);
  outcome.connectivity = triangulation.connectivity();
  if (wanted.overlay && outcome.crossing_summary) // last, because it takes the most memory
    find_overlay(std::move(triangulation), job.overlay_progress, outcome);
  return outcome;
}

#ifdef __SIZEOF_FLOAT128__
using Float128 = __float128;
#else
using Float128 = boost::multiprecision::cpp_bin_float_quad; // the same numbers, but slower
#endif
using Core_number = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

template <class Traits>
Outcome run_with_core(const Job& job)
{
  const Discarded_core_diagnostics discarded;
  return run_with<Traits>(job);
}

Outcome run_with_mpfr(const Job& job)
{
  // Numbers take the precision in force when they are made, so this must outlive them.
  const IT::Mpfr_precision precision(job.options.precision);
  return run_with<IT::Edge_length_traits<IT::Mpfr_float>>(job);
}

Outcome dispatch(const Job& job)
{
  switch (job.options.number_type) {
  case Number_type::FILTERED:
    return run_with<IT::Filtered_edge_length_traits>(job);
  case Number_type::DOUBLE:
    return run_with<IT::Edge_length_traits<double>>(job);
  case Number_type::FLOAT:
    return run_with<IT::Edge_length_traits<float>>(job);
  case Number_type::LONG_DOUBLE:
    return run_with<IT::Edge_length_traits<long double>>(job);
  case Number_type::FLOAT128:
    return run_with<IT::Edge_length_traits<Float128>>(job);
  case Number_type::INTERVAL:
    return run_with<IT::Edge_length_traits<CGAL::Interval_nt<>>>(job);
  case Number_type::MPFR:
    return run_with_mpfr(job);
  case Number_type::CORE:
    return run_with_core<IT::Edge_length_traits<Core_number>>(job);
  case Number_type::HALF_ANGLE_DOUBLE:
    return run_with<IT::Half_angle_traits<double>>(job);
  case Number_type::HALF_ANGLE_CORE:
    return run_with_core<IT::Half_angle_traits<Core_number>>(job);
  }
  throw std::logic_error("there is no such number type");
}

// The faces of the input that leave no room for triangles, and the remedy.
std::string flat_faces_around(const Surface& surface, std::size_t vertex)
{
  if (!surface.has_points())
    return {};
  const IT::Delta_complex& complex = surface.connectivity;
  std::string faces;
  std::size_t n = 0;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    const std::array<std::size_t, 3> v = {complex.source(h).idx(), complex.target(h).idx(),
                                          complex.target(complex.next(h)).idx()};
    if (std::find(v.begin(), v.end(), vertex) == v.end() ||
        !IT::internal::are_collinear(surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]) || n++ >= 10)
      continue;
    faces +=
      (faces.empty() ? "" : ", ") + std::to_string(surface.repair ? surface.repair->input_faces[f.idx()] : f.idx());
  }
  if (faces.empty())
    return {};
  return "; of the faces of the file, these have zero area there: " + faces +
         (surface.repair ? "; remove them from the mesh" : "; use --repair to fix what can be fixed");
}

} // namespace

Outcome run(const Job& job)
{
  // The number type may be to blame (a float has less precision than a file), so the message names both.
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  const std::string where = job.surface.path + ": as " + name(job.options.number_type) + ": ";
  try {
    return dispatch(job);
  } catch (const Invalid_surface_error& error) {
    const bool is_mollifiable = error.defect() == Invalid_surface_error::Defect::TRIANGLE_INEQUALITY;
    throw Invalid_surface_error(
      error.defect(), error.element(), error.count(),
      where + error.what() +
        (is_mollifiable ? "; the option --mollify of triangulate lengthens edges until it holds" : "") +
        (error.defect() == Invalid_surface_error::Defect::ZERO_LENGTH_EDGE
           ? flat_faces_around(job.surface, error.element())
           : std::string()));
  } catch (const CGAL::Intrinsic_triangulations::Undecided_error& error) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(where + error.what());
  } catch (const CGAL::Uncertain_conversion_exception&) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(where +
                                                          "a comparison that the construction needs cannot be decided");
  }
}

} // namespace idt

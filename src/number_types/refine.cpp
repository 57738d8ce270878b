// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/refine.h"

#include "system/Stopwatch.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

std::vector<IT::Surface_point> inserted_points(const Filtered_triangulation& triangulation)
{
  std::vector<IT::Surface_point> result;
  for (auto v = triangulation.input().number_of_vertices(); v < triangulation.connectivity().number_of_vertices(); ++v)
    result.push_back(triangulation.location(IT::Vertex_index(v)));
  return result;
}

IT::Edge_index shortest_edge(const Filtered_triangulation& triangulation, IT::Face_index f)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::Halfedge_index h = complex.halfedge(f);
  IT::Edge_index result = complex.edge(h);
  for (IT::Halfedge_index side : {complex.next(h), complex.prev(h)})
    if (triangulation.length(complex.edge(side)) < triangulation.length(result))
      result = complex.edge(side);
  return result;
}

Short_side short_side(const Filtered_triangulation& triangulation, const Surface& surface, IT::Face_index f)
{
  const IT::Edge_index e = shortest_edge(triangulation, f);
  Short_side result{triangulation.length(e), std::nullopt};
  if (!surface.has_points())
    return result;
  const IT::Vertex_index v = triangulation.connectivity().source(triangulation.connectivity().halfedge(e));
  result.place = triangulation.is_inserted(v)
                   ? IT::point_in_space(surface.connectivity, surface.points, triangulation.location(v))
                   : surface.points[v.idx()];
  return result;
}

std::optional<Short_side> smallest_left_face(const Filtered_triangulation& triangulation, const Surface& surface,
                                             const IT::Refinement_report& report)
{
  std::optional<std::pair<double, IT::Face_index>> smallest;
  for (const IT::Unrefined_face& left : report.unrefined)
    if (left.reason == IT::Refinement_obstacle::TOO_SMALL || left.reason == IT::Refinement_obstacle::BUDGET) {
      const std::pair<double, IT::Face_index> candidate{triangulation.length(shortest_edge(triangulation, left.face)),
                                                        left.face};
      smallest = smallest ? (std::min)(*smallest, candidate) : candidate;
    }
  return smallest ? std::optional<Short_side>(short_side(triangulation, surface, smallest->second)) : std::nullopt;
}

// A thin face with a short side takes at most as many vertices as squares on that side are needed to cover it.
double sufficient_size(const Filtered_triangulation& triangulation, const Refinement_options& options,
                       const IT::Refinement_report& report)
{
  std::vector<std::pair<double, double>> needs; // by side
  for (const IT::Unrefined_face& left : report.unrefined)
    if (left.reason == IT::Refinement_obstacle::BUDGET) {
      const double side = triangulation.length(shortest_edge(triangulation, left.face));
      needs.emplace_back(side, triangulation.area(left.face) / (side * side));
    }
  std::sort(needs.rbegin(), needs.rend());
  const double most = double(report.insertions + report.segment_splits) / 10;
  double sum = 0;
  for (const auto& [side, need] : needs)
    if ((sum += need) > most)
      return side < (std::min)(options.criteria.maximum_edge_length, options.criteria.maximum_circumradius) / 4
               ? 1.1 * side
               : 0;
  return 0;
}

// Asks the caller, and remembers the progress of the refinement in case an exception ends it.
class Asking_refinement_visitor
{
public:
  Asking_refinement_visitor(const Filtered_triangulation& triangulation, const Job& job)
    : job_(job), where_([this, &triangulation] { return short_side(triangulation, job_.surface, progress_.face); })
  {}

  bool go_further(const IT::Progress& progress)
  {
    progress_.points = progress.insertions;
    flips_ = progress.flips;
    is_flipping_ = is_flipping_ || progress.tests > 0;
    return goes_on();
  }
  void before_step(const IT::Refinement_progress& progress)
  {
    progress_ = progress;
    is_flipping_ = false;
    if (const auto& look = job_.options.refinement->look)
      look(progress, where_);
  }
  bool goes_on() const { return !job_.refine_further || job_.refine_further(progress_); }
  double minimum_size() const { return progress_.minimum_size; }
  bool is_flipping() const { return is_flipping_; } // before the refinement, or before it begins anew
  std::uint64_t flips() const { return flips_; }

private:
  const Job& job_;
  const std::function<Short_side()> where_;
  IT::Refinement_progress progress_;
  std::uint64_t flips_ = 0;
  bool is_flipping_ = true;
};

void add_sharp_edges(const Surface& surface, double degrees, double size, std::vector<bool>& is_constrained)
{
  const std::vector<bool> is_sharp = IT::sharp_edges(surface.connectivity, surface.points, degrees, size);
  is_constrained.resize(is_sharp.size());
  std::transform(is_sharp.begin(), is_sharp.end(), is_constrained.begin(), is_constrained.begin(), std::logical_or<>());
}

} // namespace

void refine(Filtered_triangulation& triangulation, const Job& job, Outcome& outcome)
{
  if (outcome.report.status != IT::Flip_status::DELAUNAY) {
    if (outcome.are_flips_cancelled)
      outcome.refinement.emplace().is_cancelled = true;
    return;
  }
  const Refinement_options& options = *job.options.refinement;
  Asking_refinement_visitor visitor(triangulation, job);
  // A single decision can take long.
  std::function<bool()> afterwards = triangulation.set_interruption([&] { return visitor.goes_on(); });
  const Stopwatch stopwatch;
  outcome.refinement.emplace();
  Refinement_summary& summary = *outcome.refinement;
  const std::vector<bool> is_constrained = first_constraints(triangulation, job, options.is_constrained);
  const std::vector<bool> is_whole = first_constraints(triangulation, job, options.is_whole);
  const auto sizes = boost::make_function_property_map<IT::Vertex_index, double>([&](IT::Vertex_index v) {
    return options.sizes.empty() ? std::numeric_limits<double>::infinity() : options.sizes[v.idx()];
  });
  const auto parameters = CGAL::parameters::minimum_angle(options.criteria.minimum_angle)
                            .maximum_circumradius(options.criteria.maximum_circumradius)
                            .maximum_edge_length(options.criteria.maximum_edge_length)
                            .maximum_deviation(options.criteria.maximum_deviation)
                            .minimum_size(options.criteria.minimum_size)
                            .sharp_edge_angle(options.criteria.sharp_edge_angle)
                            .maximum_normal_angle(options.criteria.normal_angle)
                            .size_gradation(options.criteria.gradation)
                            .edge_is_constrained_map(edge_flags(is_constrained))
                            .whole_edges_map(edge_flags(is_whole))
                            .maximum_number(options.maximum_number_of_points)
                            .size_map(sizes)
                            .visitor(std::ref(visitor));
  try {
    summary.report = IT::refine_Delaunay(triangulation, parameters);
  } catch (const IT::Invalid_surface_error&) {
    throw;
  } catch (const IT::Too_many_vertices_error& error) {
    throw IT::Error("edges of these lengths need about " + with_separators(error.number()) +
                    " new vertices: allow longer ones, or set --maximum-points N");
  } catch (const IT::Invalid_argument_error& error) {
    throw IT::Invalid_argument_error(job.surface.path + ": " + error.what());
  } catch (const IT::Cancelled_error&) {
    summary.is_cancelled = true;
    summary.report.flips = visitor.flips();
    if (chooses_edges(options) && visitor.is_flipping()) {
      outcome.are_flips_cancelled = true;
      outcome.report.status = IT::Flip_status::BUDGET_EXHAUSTED;
    }
  } catch (const IT::Error& error) {
    // Vertices inserted before remain.
    outcome.failure = error.what();
    summary.is_cancelled = true;
    summary.report.flips = visitor.flips();
  }
  triangulation.set_interruption(std::move(afterwards));
  summary.is_constrained = options.is_constrained;
  if (options.criteria.sharp_edge_angle)
    add_sharp_edges(job.surface, *options.criteria.sharp_edge_angle,
                    summary.is_cancelled ? visitor.minimum_size() : summary.report.minimum_size,
                    summary.is_constrained);
  summary.smallest_left = smallest_left_face(triangulation, job.surface, summary.report);
  if (summary.report.status == IT::Refinement_status::BUDGET_EXHAUSTED)
    summary.sufficient_size = sufficient_size(triangulation, options, summary.report);
  summary.points = inserted_points(triangulation);
  const auto is_on_edge = [](const IT::Surface_point& point) { return point.dimension() == 1; };
  summary.report.segment_splits =
    std::uint64_t(std::count_if(summary.points.begin(), summary.points.end(), is_on_edge));
  summary.report.insertions = summary.points.size() - summary.report.segment_splits;
  summary.seconds = stopwatch.seconds();
}

std::vector<bool> constrained_parts(const Filtered_triangulation& triangulation,
                                    const std::vector<bool>& is_constrained)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> result(complex.number_of_edges());
  if (is_constrained.empty())
    return result;
  for (IT::Edge_index e : complex.edges())
    if (triangulation.is_input_edge(e))
      result[e.idx()] =
        is_constrained[triangulation.input().edge(triangulation.input_halfedge(complex.halfedge(e))).idx()];
  return result;
}

std::vector<bool> first_constraints(const Filtered_triangulation& triangulation, const Job& job,
                                    const std::vector<bool>& is_constrained)
{
  if (!job.surface.saved || is_constrained.empty())
    return is_constrained;
  const IT::Delta_complex &input = triangulation.input(), &complex = triangulation.connectivity();
  const std::vector<bool> result = constrained_parts(triangulation, is_constrained);
  std::vector<std::int64_t> missing_parts(is_constrained.begin(), is_constrained.end());
  for (const IT::Surface_point& point : inserted_points(triangulation))
    if (point.dimension() == 1) {
      const IT::Edge_index e = input.edge(IT::internal::side_of(input, point));
      missing_parts[e.idx()] += is_constrained[e.idx()];
    }
  for (IT::Edge_index e : complex.edges())
    if (result[e.idx()])
      --missing_parts[input.edge(triangulation.input_halfedge(complex.halfedge(e))).idx()];
  const auto missing = std::find_if(missing_parts.begin(), missing_parts.end(), [](std::int64_t n) { return n != 0; });
  if (missing != missing_parts.end())
    throw IT::Invalid_surface_error(
      IT::Invalid_surface_error::Defect::UNREADABLE, std::size_t(missing - missing_parts.begin()), 1,
      job.surface.path + ": edge " + std::to_string(missing - missing_parts.begin()) +
        " of the input is to be kept, but was flipped before the triangulation was saved: refine the input instead");
  return result;
}

} // namespace idt

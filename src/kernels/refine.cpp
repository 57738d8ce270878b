// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/refine.h"

#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <functional>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// Asks the caller, and remembers how far the refinement is in case that an exception ends it.
class Asking_refinement_visitor : public IT::Default_refinement_visitor
{
public:
  explicit Asking_refinement_visitor(const Continue_refining_function& refine_further) : refine_further_(refine_further) {}

  bool go_further(std::uint64_t points, std::uint64_t flips)
  {
    points_ = points;
    flips_ = flips;
    return goes_on();
  }
  bool goes_on() const { return !refine_further_ || refine_further_(points_, flips_); }
  std::uint64_t points() const { return points_; }
  std::uint64_t flips() const { return flips_; }

private:
  const Continue_refining_function& refine_further_;
  std::uint64_t points_ = 0, flips_ = 0;
};

void count_inserted_vertices(const IT::Correspondence& correspondence, IT::Refinement_report& report)
{
  report.insertions = report.segment_splits = 0;
  const std::size_t first = correspondence.input().number_of_vertices();
  for (std::size_t i = 0; i < correspondence.number_of_inserted_vertices(); ++i)
    ++(correspondence.location(IT::Vertex_index(first + i)).dimension() == 1 ? report.segment_splits : report.insertions);
}

} // namespace

void refine(Filtered_triangulation& triangulation, const Job& job, Outcome& outcome)
{
  if (outcome.report.status != IT::Flip_status::DELAUNAY)
    return;
  const Refinement_options& options = *job.options.refinement;
  Asking_refinement_visitor visitor(job.refine_further);
  // A single decision can take long.
  std::function<bool()> afterwards = triangulation.set_interruption([&] { return visitor.goes_on(); });
  const Stopwatch stopwatch;
  outcome.refinement.emplace();
  Refinement_summary& summary = *outcome.refinement;
  const auto with_visitor = CGAL::parameters::edge_is_constrained_map(Edge_flags{&options.is_constrained}).visitor(std::ref(visitor));
  try {
    summary.report = options.maximum_number_of_points
                       ? IT::refine_Delaunay(triangulation, options.criteria, with_visitor.maximum_number(*options.maximum_number_of_points))
                       : IT::refine_Delaunay(triangulation, options.criteria, with_visitor);
  } catch (const IT::Invalid_surface_error&) {
    throw;
  } catch (const IT::Error& error) {
    // The vertices that were inserted before are there.
    outcome.failure = error.what();
    outcome.is_interrupted = dynamic_cast<const IT::Cancelled_error*>(&error) != nullptr;
    summary.report.status = IT::Refinement_status::CANCELLED;
    summary.report.flips = visitor.flips();
  }
  triangulation.set_interruption(std::move(afterwards));
  const IT::Correspondence& correspondence = triangulation.exact_geometry().correspondence();
  count_inserted_vertices(correspondence, summary.report);
  for (std::size_t i = 0; i < correspondence.number_of_inserted_vertices(); ++i)
    summary.points.push_back(correspondence.location(IT::Vertex_index(correspondence.input().number_of_vertices() + i)));
  summary.seconds = stopwatch.seconds();
}

std::vector<bool> constrained_parts(const Filtered_triangulation& triangulation, const std::vector<bool>& is_constrained)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const IT::Correspondence& correspondence = triangulation.exact_geometry().correspondence();
  std::vector<bool> result(complex.number_of_edges());
  if (is_constrained.empty())
    return result;
  for (IT::Edge_index e : complex.edges())
    if (correspondence.coordinates().is_original(e)) {
      const IT::Halfedge_index along = correspondence.input_halfedge(complex.halfedge(e));
      result[e.idx()] = is_constrained[correspondence.input().edge(along).idx()];
    }
  return result;
}

} // namespace idt

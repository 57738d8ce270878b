// SPDX-License-Identifier: GPL-3.0-or-later

#include "Triangulation_result.h"

#include "text.h"

#include <algorithm>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// "edge 17 (joins vertices 3 and 5) and 2 more"
std::string first_of(const std::vector<IT::Edge_index>& edges, const IT::Delta_complex& complex)
{
  const IT::Edge_index e = *std::min_element(edges.begin(), edges.end());
  const IT::Halfedge_index h = complex.halfedge(e);
  std::string text = "edge " + std::to_string(e.idx()) + " (joins vertices " +
                     std::to_string(complex.source(h).idx()) + " and " +
                     std::to_string(complex.target(h).idx()) + ")";
  if (edges.size() > 1)
    text += " and " + with_separators(edges.size() - 1) + " more";
  return text;
}

} // namespace

std::size_t number_of_changed_edges(const Outcome& outcome)
{
  return static_cast<std::size_t>(
    std::count(outcome.is_original.begin(), outcome.is_original.end(), 0));
}

Exit_status exit_status(const IT::Flip_report& report)
{
  return report.status == IT::Flip_status::DELAUNAY ? Exit_status::DONE
                                                    : Exit_status::NOT_FINISHED;
}

std::string describe_status(const Triangulation_result& result)
{
  const IT::Flip_report& report = result.outcome.report;
  switch (report.status) {
  case IT::Flip_status::DELAUNAY:
    // With rounded decisions both diagonals of a near tie can fail the test.
    if (result.outcome.weights_after.negative > 0)
      return "Delaunay up to rounding: " +
             counted(result.outcome.weights_after.negative, "edge fails", "edges fail") +
             " the test again after the flip";
    return "Delaunay";
  case IT::Flip_status::NOT_FLIPPABLE:
    return "not Delaunay: rounding leaves " +
           first_of(report.not_flippable, result.outcome.connectivity) +
           " that should be flipped and cannot";
  case IT::Flip_status::UNDECIDED:
    return std::string("undecided: ") + name(result.options.number_type) + " cannot tell for " +
           first_of(report.undecided, result.outcome.connectivity);
  case IT::Flip_status::BUDGET_EXHAUSTED:
    return "not finished: the budget of " + with_separators(report.flips) + " flips is spent";
  case IT::Flip_status::CANCELLED:
    return "not finished: cancelled";
  }
  return std::string();
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/text.h"

#include <algorithm>
#include <cmath>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// "edge 17 (joins vertices 3 and 5) and 2 more"
std::string first_of(const std::vector<IT::Edge_index>& edges, const IT::Delta_complex& complex)
{
  const IT::Edge_index e = *std::min_element(edges.begin(), edges.end());
  const IT::Halfedge_index h = complex.halfedge(e);
  std::string text = "edge " + std::to_string(e.idx()) + " (joins vertices " + std::to_string(complex.source(h).idx()) +
                     " and " + std::to_string(complex.target(h).idx()) + ")";
  if (edges.size() > 1)
    text += " and " + with_separators(edges.size() - 1) + " more";
  return text;
}

// Whether the straight triangles are a surface, and are as good as was requested.
bool are_straight_triangles_good(const Triangulation_result& result)
{
  if (!result.straight)
    return true;
  const double maximum = result.options.refinement->criteria.maximum_deviation;
  return result.straight->is_surface() && result.straight->deviation <= maximum &&
         (std::isinf(maximum) || result.straight->is_good());
}

// The text before "Delaunay", which holds at every moment of a refinement.
std::string describe_refinement(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  if (!outcome.refinement)
    return {};
  const IT::Refinement_report& report = outcome.refinement->report;
  if (outcome.refinement->is_cancelled)
    return "not refined: cancelled; ";
  switch (report.status) {
  case IT::Refinement_status::REFINED:
    if (!are_straight_triangles_good(result))
      return {}; // whatever the intrinsic faces are
    return report.unrefined.empty() ? "refined, "
                                    : "refined but for " + counted(report.unrefined.size(), "face", "faces") + ", ";
  case IT::Refinement_status::BUDGET_EXHAUSTED:
    return "not refined: the budget of " +
           counted(report.insertions + report.segment_splits, "new vertex", "new vertices") + " is spent, " +
           counted(unrefined_faces(outcome)["budget"], "face is", "faces are") + " left for that, with sides down to " +
           text(*outcome.refinement->smallest_left) + " (try a larger --maximum-points" +
           (outcome.refinement->sufficient_size > 0
              ? ", or --minimum-size " + in_short(outcome.refinement->sufficient_size)
              : "") +
           "); ";
  }
  return {};
}

std::string describe_straight_triangles(const Triangulation_result& result)
{
  if (are_straight_triangles_good(result))
    return {};
  const IT::Straight_mesh& mesh = *result.straight;
  const double maximum = result.options.refinement->criteria.maximum_deviation;
  std::string text = "the straight triangles ";
  if (!mesh.is_surface())
    text += "are no surface: " + message(mesh);
  else if (!(mesh.deviation <= maximum))
    text += "are up to " + in_short(mesh.deviation) + " away from the surface, at " + in_short(mesh.deviation_place);
  else if (!mesh.has_good_angles())
    text += "have angles below 10 degrees in " +
            counted(mesh.thin_triangles.size() - mesh.number_of_sharp_corners, "triangle", "triangles") +
            " that are not at corners of kept edges, the first at " +
            in_short(mesh.points[mesh.triangles[mesh.thin_triangles.front()][0]]);
  else if (!mesh.folded_edges.empty())
    text += "lie on each other at " + counted(mesh.folded_edges.size(), "edge", "edges") + ", the first at " +
            in_short(mesh.points[mesh.folded_edges.front()[0]]);
  else
    text += "cross where the surface does not, the first at " +
            in_short(mesh.points[mesh.triangles[mesh.crossing_triangles.front()[0]][0]]);
  return text + "; " +
         (std::isinf(maximum) ? "try --maximum-deviation 0.1%"
          : mesh.sufficient_deviation > 0
            ? "--maximum-deviation " + in_short(mesh.sufficient_deviation) + " suffices, as was tried"
          : unrefined_faces(result.outcome)["whole edge"] > 0 ? "fewer --keep-whole edges leave more room"
          : mesh.folded_edges.empty() ? "try a smaller --maximum-deviation, or a larger --minimum-size"
                                      : "--maximum-deviation has to be smaller than they are apart") +
         "; only the intrinsic triangulation is ";
}

} // namespace

const char* name(IT::Refinement_obstacle reason)
{
  switch (reason) {
  case IT::Refinement_obstacle::CONE:
    return "cone";
  case IT::Refinement_obstacle::SMALL_INPUT_ANGLE:
    return "small input angle";
  case IT::Refinement_obstacle::BESIDE_SMALL_INPUT_ANGLE:
    return "beside small input angle";
  case IT::Refinement_obstacle::UNREPRESENTABLE:
    return "unrepresentable";
  case IT::Refinement_obstacle::TOO_SMALL:
    return "too small";
  case IT::Refinement_obstacle::WHOLE_EDGE:
    return "whole edge";
  case IT::Refinement_obstacle::BUDGET:
    return "budget";
  }
  return "";
}

std::map<std::string, std::size_t> unrefined_faces(const Outcome& outcome)
{
  std::map<std::string, std::size_t> result;
  if (outcome.refinement) {
    const auto numbers = outcome.refinement->report.numbers_by_reason();
    for (std::size_t reason = 0; reason < numbers.size(); ++reason)
      if (numbers[reason] > 0)
        result[name(IT::Refinement_obstacle(reason))] = numbers[reason];
  }
  return result;
}

std::string text(const Short_side& side)
{
  return in_short(side.length) + (side.place ? " at " + in_short(*side.place) : std::string());
}

Exit_status exit_status(const Outcome& outcome)
{
  const bool is_done = outcome.report.status == IT::Flip_status::DELAUNAY &&
                       (!outcome.refinement || (!outcome.refinement->is_cancelled &&
                                                outcome.refinement->report.status == IT::Refinement_status::REFINED)) &&
                       outcome.failure.empty() && (!outcome.verification || outcome.verification->is_Delaunay());
  return is_done ? Exit_status::DONE : Exit_status::NOT_FINISHED;
}

Exit_status exit_status(const Triangulation_result& result)
{
  return are_straight_triangles_good(result) ? exit_status(result.outcome) : Exit_status::NOT_FINISHED;
}

const char* status_word(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  if (outcome.is_interrupted || outcome.are_flips_cancelled)
    return "interrupted";
  switch (outcome.report.status) {
  case IT::Flip_status::DELAUNAY:
    if (outcome.refinement && outcome.refinement->report.status == IT::Refinement_status::BUDGET_EXHAUSTED)
      return "point budget";
    if (outcome.refinement && outcome.refinement->is_cancelled && outcome.failure.empty())
      return "interrupted";
    if (!outcome.failure.empty())
      return "incomplete";
    if (outcome.verification && !outcome.verification->is_Delaunay())
      return "not Delaunay";
    return are_straight_triangles_good(result) ? "done"
           : result.straight->is_surface()     ? "bad triangles"
                                               : "no surface";
  case IT::Flip_status::INCONSISTENT:
    return "inconsistent";
  case IT::Flip_status::NOT_FLIPPABLE:
    return "not flippable";
  case IT::Flip_status::UNDECIDED:
    return "undecided";
  case IT::Flip_status::BUDGET_EXHAUSTED:
    return "flip budget";
  }
  return "";
}

std::string describe_verification(const Outcome& outcome)
{
  const IT::Delaunay_verification& verification = *outcome.verification;
  if (verification.is_Delaunay())
    return "each of " + counted(verification.tests, "edge", "edges") + " is Delaunay, " +
           counted(verification.ties, "tie", "ties");
  std::string text;
  if (!verification.not_Delaunay.empty())
    text =
      "by the exact check, " + first_of(verification.not_Delaunay, outcome.connectivity) + " should have been flipped";
  if (!verification.inverted.empty()) {
    const auto first = std::min_element(verification.inverted.begin(), verification.inverted.end());
    if (!text.empty())
      text += "; ";
    text += counted(verification.inverted.size(), "face is", "faces are") + " inside out, the first is face " +
            std::to_string(first->idx());
  }
  return text;
}

std::string describe_status(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  const IT::Flip_report& report = outcome.report;
  if (!outcome.failure.empty())
    return (report.status == IT::Flip_status::DELAUNAY ? "not known in full: " : "not finished: ") + outcome.failure;
  if (outcome.are_flips_cancelled)
    return "not finished: cancelled";
  // An unfinished result need not be Delaunay.
  if (report.status != IT::Flip_status::BUDGET_EXHAUSTED && outcome.verification &&
      !outcome.verification->is_Delaunay())
    return "not Delaunay: " + describe_verification(outcome);
  switch (report.status) {
  case IT::Flip_status::DELAUNAY:
    return describe_refinement(result) + describe_straight_triangles(result) +
           (!outcome.verification ? "Delaunay"
            : result.options.refinement && std::isfinite(result.options.refinement->criteria.maximum_deviation)
              ? "Delaunay but for folds that are kept, verified"
              : "Delaunay, verified");
  case IT::Flip_status::INCONSISTENT:
    // Either diagonal of a tie is right, whatever rounding does.
    return std::string(outcome.verification ? "verified Delaunay, but only by chance: " : "not Delaunay: ") +
           "near a tie the rounded decisions contradict each other: " +
           first_of(report.inconsistent, outcome.connectivity) +
           " failed the test again after the flip; try --number-type " + name(Number_type::FILTERED);
  case IT::Flip_status::NOT_FLIPPABLE:
    // This happens to exact numbers beside faces of zero area, and to CORE if roots are below 2^-1075.
    if (result.options.number_type == Number_type::CORE || result.options.number_type == Number_type::HALF_ANGLE_CORE)
      return "not Delaunay: beside a face whose area is zero, or too small for CORE, " +
             first_of(report.not_flippable, outcome.connectivity) +
             " should be flipped and cannot; try --number-type " + name(Number_type::FILTERED) +
             ", which passes such faces";
    return "not Delaunay: rounding leaves " + first_of(report.not_flippable, outcome.connectivity) +
           " that should be flipped and cannot; try --number-type " + name(Number_type::FILTERED);
  case IT::Flip_status::UNDECIDED:
    return std::string("undecided: ") + name(result.options.number_type) + " cannot tell for " +
           first_of(report.undecided, outcome.connectivity) + "; try --number-type " + name(Number_type::FILTERED);
  case IT::Flip_status::BUDGET_EXHAUSTED:
    return "not finished: the budget of " + counted(report.flips, "flip", "flips") +
           " is spent; try a larger --maximum-flips";
  }
  return std::string();
}

} // namespace idt

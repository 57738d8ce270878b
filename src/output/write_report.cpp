// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/system_calls.h"
#include "system/text.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace idt {
namespace {

void line(std::ostream& os, const char* label, const std::string& text)
{
  os << "  " << std::left << std::setw(16) << label << text << '\n';
}

std::string stages_text(const CGAL::Intrinsic_triangulations::Stage_counts& counts)
{
  using CGAL::Intrinsic_triangulations::Stage;
  return with_separators(counts[Stage::FILTER]) + " by the filter, " + with_separators(counts[Stage::COPLANAR]) +
         " in a plane, " + with_separators(counts[Stage::UNFOLDING]) + " by unfolding, " +
         with_separators(counts[Stage::MULTIPRECISION]) + " in multiple precision, " +
         with_separators(counts[Stage::ALGEBRAIC]) + " algebraic, " + with_separators(counts[Stage::CONGRUENCE]) +
         " by symmetry, " + with_separators(counts[Stage::MODULAR]) + " in finite fields";
}

std::string weights_text(const CGAL::Intrinsic_triangulations::Weight_summary& summary)
{
  std::string text = summary.smallest ? "smallest " + in_short(*summary.smallest) + ", " +
                                          with_separators(summary.negative) + " negative"
                     : summary.infinite == 0 ? "no interior edge"
                                             : "none of an interior edge is finite";
  if (summary.infinite > 0)
    text += ", " + counted(summary.infinite, "edge has", "edges have") + " no weight, beside faces of zero area";
  return text;
}

void write_refinement(std::ostream& os, const Triangulation_result& result)
{
  const Refinement_summary& summary = *result.outcome.refinement;
  const std::vector<bool>& is_constrained = result.options.refinement->is_constrained;
  if (!is_constrained.empty())
    line(os, "kept edges",
         with_separators(std::uint64_t(std::count(is_constrained.begin(), is_constrained.end(), true))));
  const std::uint64_t on_edges = summary.report.segment_splits;
  line(os, "new vertices",
       with_separators(summary.report.insertions + on_edges) + ", " + with_separators(on_edges) +
         " of them on edges that are not flipped");
  line(os, "later flips", with_separators(summary.report.flips));
  line(os, "smallest size", result.smallest_size);
}

std::string shapes_text(const Outcome& outcome)
{
  const Shape_summary& shapes = *outcome.shapes;
  std::string text = "smallest angle " + in_short(shapes.minimum_angle) + " degrees";
  if (shapes.minimum_refined_angle && !unrefined_faces(outcome).empty())
    text += " (" + in_short(*shapes.minimum_refined_angle) + " without the faces left)";
  return text + ", largest circumradius " + in_short(shapes.maximum_circumradius);
}

std::string number_type_text(const Run_options& options)
{
  std::string text = name(options.number_type);
  if (options.number_type == Number_type::MPFR)
    text += ", " + std::to_string(options.precision) + " bits";
  return text;
}

// How edges were decided, and where the input lies in the result.
void write_details(std::ostream& os, const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  if (outcome.stages)
    line(os, "decided", stages_text(*outcome.stages));
  if (outcome.tessellation)
    line(os, "ties",
         with_separators(outcome.tessellation->ties) + ", which leaves " +
           counted(outcome.tessellation->cells, "cell", "cells"));
  if (outcome.crossing_summary) {
    line(os, "changed edges", with_separators(outcome.crossing_summary->changed));
    line(os, "crossings", with_separators(outcome.crossing_summary->crossings));
    line(os, "simple edges", with_separators(outcome.crossing_summary->simple));
    line(os, "longest edge", counted(outcome.crossing_summary->longest, "segment", "segments"));
  }
  line(os, "loops", with_separators(result.counts.loops));
  line(os, "multiple edges", with_separators(result.counts.multiple_edges));
}

std::string times_text(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  std::string times = "read " + seconds_text(result.surface.read_seconds) + ", build " +
                      seconds_text(result.surface.build_seconds + outcome.build_seconds) + ", flip " +
                      seconds_text(outcome.flip_seconds);
  if (outcome.refinement)
    times += ", refine " + seconds_text(outcome.refinement->seconds);
  if (outcome.crossing_summary)
    times += ", crossings " + seconds_text(outcome.crossing_summary->seconds);
  if (outcome.subdivision)
    times += ", positions " + seconds_text(outcome.crossing_summary->position_seconds);
  if (result.options.wanted.numbers)
    times += ", numbers " + seconds_text(outcome.number_seconds);
  for (const auto& [option, seconds] : result.file_seconds)
    times += std::string(", write ") + option + ' ' + seconds_text(seconds);
  return times;
}

// The input, and its preparation before the flips.
void write_surface(std::ostream& os, const Triangulation_result& result, bool is_verbose)
{
  const Surface_counts& counts = result.counts;
  const Surface& surface = result.surface;
  line(os, "surface",
       counted(counts.vertices, "vertex", "vertices") + ", " + counted(counts.edges, "edge", "edges") + ", " +
         counted(counts.faces, "face", "faces"));
  line(os, "topology",
       counted(counts.components, "component", "components") + ", " +
         counted(counts.boundary_edges, "boundary edge", "boundary edges") + ", Euler characteristic " +
         std::to_string(counts.euler_characteristic));
  for (const std::string& note : surface.notes)
    line(os, "note", note);
  if (surface.mollification)
    line(os, "mollified",
         counted(surface.mollification->number_of_changed_edges, "edge", "edges") + " longer by at most " +
           in_short(surface.mollification->epsilon) + " (" +
           in_short(100 * surface.mollification->largest_relative_change) + " %)");
  if (surface.input_vertices)
    line(os, "flat sides",
         counted(surface.number_of_removed_vertices, "vertex", "vertices") + " removed" +
           (result.flat_tolerance ? "; the surface has moved by at most " + in_short(result.flat_deviation) + ", of " +
                                      in_short(*result.flat_tolerance) + " allowed"
                                  : std::string()));
  if (is_verbose || result.options.number_type != default_number_type)
    line(os, "number type", number_type_text(result.options));
  if (surface.untwisting)
    line(os, "fast forward",
         surface.untwisting->number_of_flips.str() +
           (surface.untwisting->number_of_flips == 1 ? " flip in " : " flips in ") +
           counted(surface.untwisting->twists.size(), "twist", "twists"));
}

std::string straight_text(const CGAL::Intrinsic_triangulations::Straight_mesh& mesh)
{
  std::string text = "another surface, of " +
                     counted(mesh.triangles.size(), "straight triangle", "straight triangles") + ", up to " +
                     in_short(mesh.deviation) + " away, smallest angle " + in_short(mesh.minimum_angle) + " degrees";
  if (!mesh.merged_vertices.empty())
    text += ", " + counted(mesh.merged_vertices.size(), "vertex", "vertices") + " merged, the first at " +
            in_short(mesh.points[mesh.points_of_vertices[mesh.merged_vertices.front().idx()]]);
  if (mesh.number_of_removed_pieces > 0)
    text += ", " + counted(mesh.number_of_removed_pieces, "piece", "pieces") + " along others left out";
  if (mesh.number_of_rods > 0)
    text += ", " + counted(mesh.number_of_rods, "wire or point", "wires or points") + " without thickness made rods";
  if (mesh.area_of_films > 0)
    text += ", films of area " + in_short(mesh.area_of_films) + " left out, the first at " + in_short(mesh.film_place);
  if (mesh.number_of_new_components > 0)
    text += ", " + counted(mesh.number_of_new_components, "component", "components") +
            " more than the surface has, as thin parts between them vanished";
  if (!mesh.thin_triangles.empty())
    text += ", below 10 in " + counted(mesh.thin_triangles.size(), "triangle", "triangles") + ", " +
            with_separators(mesh.number_of_sharp_corners) + " of them at corners of kept edges";
  return text;
}

// Whether programs that fill volumes take the triangles.
std::string volume_text(const CGAL::Intrinsic_triangulations::Straight_mesh& mesh)
{
  const std::size_t crossings = mesh.crossing_triangles.size(), old = crossings - mesh.number_of_new_crossings;
  if (mesh.can_be_filled())
    return "can be filled with tetrahedra" +
           (mesh.surface.number_of_components > 1
              ? ": " + counted(mesh.surface.number_of_components, "component", "components") +
                  ", each is the border of a volume, or of a cavity"
              : "");
  return "cannot be filled: " +
         (!mesh.is_surface()  ? "no surface"
          : !mesh.is_closed() ? counted(mesh.surface.number_of_border_edges, "edge", "edges") + " on the border"
          : crossings > 0
            ? counted(crossings, "pair", "pairs") + " of triangles cross, " + with_separators(old) +
                " of them where the surface does" +
                (old > 0 ? " (unite its parts before)" : " (try another --maximum-deviation)") + ", the first at " +
                in_short(mesh.points[mesh.triangles[mesh.crossing_triangles.front()[0]][0]])
            : "triangles lie on each other at " + counted(mesh.folded_edges.size(), "edge", "edges") +
                ", the first at " + in_short(mesh.points[mesh.folded_edges.front()[0]]));
}

// Flips and new vertices.
void write_changes(std::ostream& os, const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  // With `--constrain-angle`, the refinement makes all flips.
  if (outcome.report.tests > 0 || !outcome.refinement)
    line(os, "flips",
         with_separators(outcome.report.flips) + " in " + with_separators(outcome.report.tests) + " tests");
  if (outcome.refinement)
    write_refinement(os, result);
  if (outcome.shapes)
    line(os, "shapes", shapes_text(outcome));
  for (const auto& [reason, faces] : unrefined_faces(outcome))
    line(os, "left", counted(faces, "face", "faces") + ": " + reason);
  if (outcome.refinement && outcome.refinement->smallest_left)
    line(os, "shortest left", "a side of " + text(*outcome.refinement->smallest_left));
  if (result.straight) {
    line(os, "flattened", straight_text(*result.straight));
    if (!std::isinf(result.options.refinement->criteria.maximum_deviation))
      line(os, "volume", volume_text(*result.straight));
    line(os, "regions",
         with_separators(result.straight->number_of_regions) + ", " +
           counted(result.straight->number_of_lines, "line", "lines") + " around and between them");
  }
}

} // namespace

void write_report(std::ostream& os, const Triangulation_result& result, bool is_verbose)
{
  const Outcome& outcome = result.outcome;
  os << result.surface.path << '\n';
  write_surface(os, result, is_verbose);
  write_changes(os, result);
  if (is_verbose)
    write_details(os, result);
  if (outcome.weights_before)
    line(os, "weights before", weights_text(*outcome.weights_before));
  if (outcome.weights_after)
    line(os, "weights after",
         weights_text(*outcome.weights_after) +
           (outcome.refinement && outcome.report.status == CGAL::Intrinsic_triangulations::Flip_status::DELAUNAY &&
                outcome.weights_after->negative > 0
              ? ", at kept edges, which are not flipped"
              : ""));
  if (outcome.verification)
    line(os, "verification", describe_verification(outcome));

  line(os, "time",
       (is_verbose ? times_text(result) + "; " : "") + seconds_text(result.surface.stopwatch.seconds()) +
         (is_verbose ? " in all" : ""));
  if (is_verbose)
    line(os, "peak memory", in_short(double(peak_memory_bytes()) / (1 << 20)) + " MiB");
  line(os, "status", describe_status(result));
}

} // namespace idt

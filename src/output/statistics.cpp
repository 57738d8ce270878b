// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "system/system_calls.h"
#include "input/repair.h"
#include "output/write_json.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

Json mollification(const Surface& surface)
{
  if (!surface.mollification)
    return 0;
  return {{"delta", surface.mollification->delta},
          {"epsilon", surface.mollification->epsilon},
          {"changed_edges", surface.mollification->number_of_changed_edges},
          {"largest_relative_change", surface.mollification->largest_relative_change}};
}

Json stages(const Outcome& outcome)
{
  using IT::Stage;
  if (!outcome.stages)
    return nullptr;
  const IT::Stage_counts& counts = *outcome.stages;
  return {{"filter", counts[Stage::FILTER]},       {"coplanar", counts[Stage::COPLANAR]},
          {"unfolding", counts[Stage::UNFOLDING]}, {"multiprecision", counts[Stage::MULTIPRECISION]},
          {"algebraic", counts[Stage::ALGEBRAIC]}, {"congruence", counts[Stage::CONGRUENCE]},
          {"modular", counts[Stage::MODULAR]}};
}

// Integers of any size are stored as text.
Json fast_forward(const Triangulation_result& result)
{
  const IT::Untwisting& untwisting = *result.surface.untwisting;
  IT::Integer crossings = 0;
  for (IT::Edge_index e : result.outcome.connectivity.edges())
    crossings += result.outcome.original_crossings->number_of_crossings(e);
  return {{"twists", untwisting.twists.size()},
          {"flips", untwisting.number_of_flips.str()},
          {"steps", untwisting.number_of_steps},
          {"crossings", crossings.str()},
          {"seconds", result.surface.untwist_seconds}};
}

Json ties(const Outcome& outcome)
{
  if (outcome.tessellation)
    return outcome.tessellation->ties;
  return outcome.verification ? Json(outcome.verification->ties) : Json(nullptr);
}

Json verification(const Outcome& outcome)
{
  if (!outcome.verification)
    return nullptr;
  return {{"tests", outcome.verification->tests},
          {"not_delaunay", outcome.verification->not_Delaunay.size()},
          {"inverted_faces", outcome.verification->inverted.size()},
          {"ties", outcome.verification->ties}};
}

// A member of a summary that may be missing.
template <class Summary, class Member>
Json member(const std::optional<Summary>& summary, Member Summary::*member)
{
  return summary ? Json((*summary).*member) : Json(nullptr);
}

Json seconds(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  Json json = {{"read", result.surface.read_seconds},
               {"build", result.surface.build_seconds + outcome.build_seconds},
               {"flip", outcome.flip_seconds}};
  if (result.surface.untwisting)
    json["fast_forward"] = result.surface.untwist_seconds;
  if (result.options.refinement)
    json["refine"] = member(outcome.refinement, &Refinement_summary::seconds);
  json["overlay"] = member(outcome.crossing_summary, &Crossing_summary::seconds);
  json["positions"] = outcome.subdivision ? Json(outcome.crossing_summary->position_seconds) : Json(nullptr);
  json["check"] = outcome.check_seconds;
  json["numbers"] = outcome.number_seconds;
  json["summary"] = outcome.summary_seconds + result.count_seconds;
  json["write"] = result.write_seconds();
  const double total = result.surface.stopwatch.seconds();
  double rest = total;
  for (const auto& stage : json)
    if (stage.is_number())
      rest -= stage.get<double>();
  json["rest"] = rest;
  json["total"] = total;
  json["files"] = Json::object();
  for (const auto& [option, seconds] : result.file_seconds)
    json["files"][option] = seconds;
  return json;
}

Json shortest_left(const Refinement_summary& refinement)
{
  if (!refinement.smallest_left)
    return nullptr;
  const Short_side& side = *refinement.smallest_left;
  return {{"length", side.length}, {"place", side.place}};
}

std::vector<std::string> warnings(const Triangulation_result& result)
{
  std::vector<std::string> texts = result.surface.warnings;
  if (result.no_Laplacian)
    texts.push_back(result.no_Laplacian->what());
  return texts;
}

// Which region is where.
Json region_table(const IT::Straight_mesh& mesh)
{
  struct Region
  {
    std::size_t triangles = 0;
    double area = 0;
    CGAL::Bbox_3 box;
  };
  std::vector<Region> regions(mesh.number_of_regions);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    Region& region = regions[mesh.regions[t]];
    ++region.triangles;
    region.area += IT::internal::four_areas_3(p, q, r) / 4;
    for (const auto& x : {p, q, r})
      region.box += CGAL::Bbox_3(x[0], x[1], x[2], x[0], x[1], x[2]);
  }
  Json result = Json::array();
  for (std::size_t i = 0; i < regions.size(); ++i)
    result.push_back({{"name", "region_" + std::to_string(i)},
                      {"triangles", regions[i].triangles},
                      {"area", regions[i].area},
                      {"low", {regions[i].box.xmin(), regions[i].box.ymin(), regions[i].box.zmin()}},
                      {"high", {regions[i].box.xmax(), regions[i].box.ymax(), regions[i].box.zmax()}}});
  return result;
}

Json straight_statistics(const IT::Straight_mesh& mesh)
{
  std::size_t non_manifold_edges = 0;
  if (const IT::Finding* finding = mesh.surface.find(IT::Invalid_surface_error::Defect::NON_MANIFOLD_EDGE))
    non_manifold_edges = finding->count;
  return {{"is_surface", mesh.is_surface()},
          {"triangles", mesh.triangles.size()},
          {"regions", mesh.number_of_regions},
          {"region_table", region_table(mesh)},
          {"lines", mesh.number_of_lines},
          {"merged_vertices", mesh.merged_vertices.size()},
          {"removed_pieces", mesh.number_of_removed_pieces},
          {"rods", mesh.number_of_rods},
          {"area_of_films", mesh.area_of_films},
          {"new_components", mesh.number_of_new_components},
          {"can_be_filled", mesh.can_be_filled()},
          {"folded_edges", mesh.folded_edges.size()},
          {"minimum_dihedral_angle_degrees", mesh.triangles.empty() ? Json() : Json(mesh.minimum_dihedral_angle)},
          {"crossing_pairs", mesh.crossing_triangles.size()},
          {"new_crossing_pairs", mesh.number_of_new_crossings},
          {"deviation", mesh.deviation},
          {"deviation_place", mesh.deviation_place},
          {"minimum_angle_degrees", mesh.triangles.empty() ? Json() : Json(mesh.minimum_angle)},
          {"thin_triangles", mesh.thin_triangles.size()},
          {"sharp_corners", mesh.number_of_sharp_corners},
          {"sufficient_deviation", mesh.sufficient_deviation},
          {"new_border_edges", mesh.number_of_new_border_edges},
          {"loops", mesh.loops.size()},
          {"multiple_edges", mesh.multiple_edges.size()},
          {"non_manifold_edges", non_manifold_edges},
          {"defects", message(mesh)}};
}

Json refinement_statistics(const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  const IT::Refinement_report report = outcome.refinement ? outcome.refinement->report : IT::Refinement_report();
  Json json;
  json["vertices"] = result.counts.vertices;
  json["edges"] = result.counts.edges;
  json["faces"] = result.counts.faces;
  json["inserted"] = report.insertions + report.segment_splits;
  json["segment_splits"] = report.segment_splits;
  json["removed"] = result.surface.number_of_removed_vertices;
  json["flat_deviation"] = result.flat_deviation;
  json["flips"] = outcome.report.flips + report.flips;
  const std::vector<bool>& is_constrained = result.options.refinement->is_constrained;
  json["kept_edges"] = std::count(is_constrained.begin(), is_constrained.end(), true);
  json["minimum_size"] = report.minimum_size;
  json["shortest_left"] = outcome.refinement ? shortest_left(*outcome.refinement) : Json(nullptr);
  json["minimum_angle_degrees"] = member(outcome.shapes, &Shape_summary::minimum_angle);
  json["minimum_angle_degrees_of_refined_faces"] = member(outcome.shapes, &Shape_summary::minimum_refined_angle);
  json["maximum_circumradius"] = member(outcome.shapes, &Shape_summary::maximum_circumradius);
  json["unrefined"] = Json::object();
  for (const auto& [reason, faces] : unrefined_faces(outcome))
    json["unrefined"][reason] = faces;
  json["flattened"] = result.straight ? straight_statistics(*result.straight) : Json(nullptr);
  json["verification"] = verification(outcome);
  json["repair"] = to_json_value(repairs(result.surface));
  json["warnings"] = warnings(result);
  json["status"] = status_word(result);
  json["seconds"] = seconds(result);
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json;
}

} // namespace

nlohmann::ordered_json statistics(const Triangulation_result& result)
{
  if (result.options.refinement)
    return refinement_statistics(result);
  const Surface_counts& counts = result.counts;
  const Outcome& outcome = result.outcome;
  const std::optional<Crossing_summary>& crossings = outcome.crossing_summary;
  const std::optional<IT::Weight_summary>&before = outcome.weights_before, &after = outcome.weights_after;

  Json json;
  json["vertices"] = counts.vertices;
  json["edges"] = counts.edges;
  json["faces"] = counts.faces;
  json["boundary_edges"] = counts.boundary_edges;
  json["components"] = counts.components;
  json["euler_characteristic"] = counts.euler_characteristic;
  json["number_type"] = name(result.options.number_type);
  json["flips"] = outcome.report.flips;
  json["tests"] = outcome.report.tests;
  json["ties"] = ties(outcome);
  json["cells"] = member(outcome.tessellation, &Tessellation_summary::cells);
  json["stages"] = stages(outcome);
  json["edges_changed"] = member(crossings, &Crossing_summary::changed);
  json["simple"] = member(crossings, &Crossing_summary::simple);
  json["longest"] = member(crossings, &Crossing_summary::longest);
  json["crossings"] = member(crossings, &Crossing_summary::crossings);
  json["loops"] = counts.loops;
  json["multiple_edges"] = counts.multiple_edges;
  json["min_weight_before"] = member(before, &IT::Weight_summary::smallest);
  json["min_weight_after"] = member(after, &IT::Weight_summary::smallest);
  json["negative_weights_before"] = member(before, &IT::Weight_summary::negative);
  json["negative_weights_after"] = member(after, &IT::Weight_summary::negative);
  json["infinite_weights_before"] = member(before, &IT::Weight_summary::infinite);
  json["infinite_weights_after"] = member(after, &IT::Weight_summary::infinite);
  if (result.surface.untwisting)
    json["fast_forward"] = fast_forward(result);
  json["verification"] = verification(outcome);
  json["mollification"] = mollification(result.surface);
  json["repair"] = to_json_value(repairs(result.surface));
  json["warnings"] = warnings(result);
  json["status"] = status_word(result);
  json["seconds"] = seconds(result);
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json;
}

} // namespace idt

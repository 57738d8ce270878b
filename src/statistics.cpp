// SPDX-License-Identifier: GPL-3.0-or-later

#include "Triangulation_result.h"

#include "peak_memory.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }

Json number(const std::optional<double>& x) { return x ? number(*x) : Json(nullptr); }

Json mollification(const Surface& surface)
{
  if (!surface.mollification)
    return 0;
  return {{"delta", number(surface.mollification->delta)},
          {"epsilon", number(surface.mollification->epsilon)},
          {"changed_edges", surface.mollification->number_of_changed_edges},
          {"largest_relative_change", number(surface.mollification->largest_relative_change)}};
}

} // namespace

nlohmann::ordered_json statistics(const Triangulation_result& result)
{
  const Surface_counts& counts = result.counts;
  const Outcome& outcome = result.outcome;
  const std::optional<Overlay_counts>& overlay = result.overlay;

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
  json["ties"] = nullptr;
  json["stages"] = nullptr;
  json["edges_changed"] = number_of_changed_edges(outcome);
  json["simple"] = overlay ? Json(overlay->simple) : Json(nullptr);
  json["longest"] = overlay ? Json(overlay->longest) : Json(nullptr);
  json["crossings"] = overlay ? Json(overlay->crossings) : Json(nullptr);
  json["loops"] = counts.loops;
  json["multiple_edges"] = counts.multiple_edges;
  json["min_weight_before"] = number(outcome.weights_before.smallest);
  json["min_weight_after"] = number(outcome.weights_after.smallest);
  json["negative_weights_before"] = outcome.weights_before.negative;
  json["negative_weights_after"] = outcome.weights_after.negative;
  json["mollification"] = mollification(result.surface);
  json["seconds"] = {
    {"read", result.surface.read_seconds},
    {"build", result.surface.build_seconds + outcome.build_seconds},
    {"flip", outcome.flip_seconds},
    {"overlay", overlay ? Json(overlay->seconds) : Json(nullptr)},
    {"write", result.write_seconds}};
  json["peak_memory_bytes"] = peak_memory_bytes();
  return json;
}

} // namespace idt

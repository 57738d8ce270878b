// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/repair.h"

#include "system/Progress.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

Repair_report repair(Surface_input& input, const std::optional<double>& stitching_tolerance)
{
  IT::Repaired_polygons repaired;
  try {
    Progress progress(input.path, "repairing");
    repaired = IT::repair_polygons(
      input.points, input.polygons(),
      CGAL::parameters::stitching_tolerance(stitching_tolerance).visitor(IT::Progress_function(std::ref(progress))));
  } catch (const IT::Cancelled_error&) {
    throw IT::Cancelled_error(input.path + ": cancelled while it was repaired");
  } catch (const IT::Invalid_surface_error& error) {
    throw IT::Invalid_surface_error(error.defect(), error.element(), error.count(), input.path + ": " + error.what());
  }
  for (const IT::Repair& repair : repaired.repairs)
    std::cerr << "idt: " << input.path << ": repaired: " << IT::message(repair) << std::endl;
  input.points = std::move(repaired.points);
  input.first_corner.clear();
  input.corners.clear();
  input.triangles.clear();
  input.triangles.reserve(repaired.triangles.size());
  for (const auto& [a, b, c] : repaired.triangles)
    input.triangles.push_back(
      {{static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)}});
  return {std::make_shared<const std::vector<IT::Repair>>(std::move(repaired.repairs)),
          std::move(repaired.input_vertices), std::move(repaired.input_faces)};
}

std::string cuts_text(const Repairs& repairs)
{
  std::string cuts;
  const auto add = [&](IT::Repair_kind kind, const char* singular, const char* plural) {
    if (repairs)
      for (const IT::Repair& repair : *repairs)
        if (repair.kind == kind)
          cuts += (cuts.empty() ? "" : ", ") + counted(repair.count, singular, plural);
  };
  add(IT::Repair_kind::OPENED_EDGE, "new border edge", "new border edges");
  add(IT::Repair_kind::SPLIT_VERTEX, "split vertex", "split vertices");
  return cuts.empty() ? "" : ", on the repaired surface, which was cut (" + cuts + ')';
}

nlohmann::ordered_json to_json_value(const Repairs& repairs)
{
  if (!repairs)
    return nullptr;
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const IT::Repair& repair : *repairs)
    json.push_back({{"kind", IT::name(repair.kind)}, {"count", repair.count}, {"first", repair.elements}});
  return json;
}

void write_repair_map(std::ostream& os, const Surface& surface)
{
  const auto write = [&os](const char* element, const std::vector<std::size_t>& inputs) {
    for (std::size_t i = 0; i < inputs.size(); ++i)
      os << element << ',' << i << ',' << inputs[i] << '\n';
  };
  os << "element,index,input\n";
  write("vertex", surface.repair->input_vertices);
  write("face", surface.repair->input_faces);
}

} // namespace idt

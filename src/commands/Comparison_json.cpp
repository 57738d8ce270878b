// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Comparison.h"

#include "input/repair.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace idt {
namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json value(const std::optional<T>& x)
{
  return x ? Json(*x) : Json(nullptr);
}

// JSON has no infinity.
Json value(const std::optional<double>& x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

} // namespace

Json to_json_value(const Comparison_row& row)
{
  return {{"number_type", name(row.type.number_type)},
          {"precision", value(row.type.precision)},
          {"status", row.status},
          {"ended", row.has_ended()},
          {"flips", value(row.flips)},
          {"tests", value(row.tests)},
          {"wrong_decisions", value(row.wrong_decisions)},
          {"not_delaunay", value(row.not_Delaunay)},
          {"inverted_faces", value(row.inverted_faces)},
          {"missing_edges", value(row.missing_edges)},
          {"length_error", value(row.length_error)},
          {"seconds", value(row.seconds)},
          {"ratio_to_double", value(row.ratio_to_double)}};
}

Json to_json_value(const Surface_comparison& comparison)
{
  Json rows = Json::array();
  for (const Comparison_row& row : comparison.rows)
    rows.push_back(to_json_value(row));
  return {{"surface", comparison.path},       {"vertices", comparison.counts.vertices},
          {"edges", comparison.counts.edges}, {"faces", comparison.counts.faces},
          {"ties", comparison.ties},          {"repair", to_json_value(comparison.repairs)},
          {"warnings", comparison.warnings},  {"number_types", std::move(rows)}};
}

Json to_json_value(const Comparison_total& total)
{
  return {{"number_type", name(total.type.number_type)},
          {"precision", value(total.type.precision)},
          {"surfaces", total.surfaces},
          {"refused", total.refused},
          {"not_ended", total.not_ended},
          {"wrong", total.wrong},
          {"unnoticed", total.unnoticed},
          {"wrong_decisions", total.wrong_decisions},
          {"not_delaunay", total.not_Delaunay},
          {"inverted_faces", total.inverted_faces},
          {"missing_edges", total.missing_edges},
          {"length_error", value(total.length_error)},
          {"ratio_to_double", value(total.ratio_to_double)}};
}

} // namespace idt

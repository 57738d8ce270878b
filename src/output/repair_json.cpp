// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `--repair` did, as the subcommands write it to their JSON files.

#include "input/repair.h"

#include <nlohmann/json.hpp>

namespace idt {
namespace IT = CGAL::Intrinsic_triangulations;

nlohmann::ordered_json to_json_value(const std::optional<std::vector<IT::Repair>>& repairs)
{
  using Json = nlohmann::ordered_json;
  if (!repairs)
    return nullptr;
  Json json = Json::array();
  for (const IT::Repair& repair : *repairs)
    json.push_back({{"kind", IT::name(repair.kind)}, {"count", repair.count}, {"first", repair.elements}});
  return json;
}

} // namespace idt

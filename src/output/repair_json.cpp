// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `--repair` did, as the subcommands write it to their JSON files.

#include "input/repair.h"

#include <nlohmann/json.hpp>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

const char* name(IT::Repair_kind kind)
{
  switch (kind) {
  case IT::Repair_kind::MERGED_VERTEX:
    return "merged vertices";
  case IT::Repair_kind::COLLAPSED_FACE:
    return "collapsed faces";
  case IT::Repair_kind::DUPLICATE_FACE:
    return "duplicate faces";
  case IT::Repair_kind::DUPLICATE_PART:
    return "duplicate parts of faces";
  case IT::Repair_kind::TRIANGULATED_FACE:
    return "triangulated faces";
  case IT::Repair_kind::REVERSED_FACE:
    return "reversed faces";
  case IT::Repair_kind::SPLIT_VERTEX:
    return "split vertices";
  case IT::Repair_kind::DROPPED_VERTEX:
    return "dropped vertices";
  }
  return "";
}

} // namespace

nlohmann::ordered_json to_json_value(const std::optional<std::vector<IT::Repair>>& repairs)
{
  using Json = nlohmann::ordered_json;
  if (!repairs)
    return nullptr;
  Json json = Json::array();
  for (const IT::Repair& repair : *repairs)
    json.push_back({{"kind", name(repair.kind)}, {"count", repair.count}, {"first", repair.elements}});
  return json;
}

} // namespace idt

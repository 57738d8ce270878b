// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON files.

#ifndef IDT_WRITE_JSON_H
#define IDT_WRITE_JSON_H

#include "output/Output_file.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <ostream>
#include <string>

// Unknown values are null. (So are infinite numbers, once they are written.)
template <class T>
struct nlohmann::adl_serializer<std::optional<T>>
{
  static void to_json(nlohmann::ordered_json& json, const std::optional<T>& value)
  {
    json = value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
  }
  static void from_json(const nlohmann::ordered_json& json, std::optional<T>& value)
  {
    value = json.is_null() ? std::nullopt : std::optional<T>(json.get<T>());
  }
};

namespace idt {

// Writes nothing if `path` is empty.
// \exception Output_error as Output_file
inline void write_json(const std::string& path, const nlohmann::ordered_json& json)
{
  write_file(path, [&](std::ostream& os) {
    // A file name need not be valid UTF-8.
    os << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  });
}

} // namespace idt

#endif // IDT_WRITE_JSON_H

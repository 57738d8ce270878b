// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A JSON file.

#ifndef IDT_WRITE_JSON_H
#define IDT_WRITE_JSON_H

#include "output/Output_file.h"

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

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

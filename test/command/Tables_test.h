// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs the command, and reads the statistics and the tables that it writes.

#ifndef IDT_TEST_COMMAND_TABLES_TEST_H
#define IDT_TEST_COMMAND_TABLES_TEST_H

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

using Json = nlohmann::ordered_json;

class Tables_test : public Command_test
{
protected:
  // Of `--stats s.json`.
  Json stats() const { return Json::parse(content(folder_ / "s.json")); }

  // The rows of a CSV file as numbers, without the header; an empty field is NaN.
  std::vector<std::vector<double>> rows(const std::string& name) const
  {
    std::vector<std::vector<double>> result;
    std::vector<std::string> text = lines(content(folder_ / name));
    for (std::size_t i = 1; i < text.size(); ++i) {
      std::vector<double> row;
      std::istringstream in(text[i] + ',');
      for (std::string field; std::getline(in, field, ',');)
        row.push_back(field.empty() ? std::nan("") : std::stod(field));
      result.push_back(row);
    }
    return result;
  }
};

#endif // IDT_TEST_COMMAND_TABLES_TEST_H

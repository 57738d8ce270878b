// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The number types that a user can choose, and their names.

#ifndef IDT_NUMBER_TYPES_NUMBER_TYPE_H
#define IDT_NUMBER_TYPES_NUMBER_TYPE_H

#include <optional>
#include <string>
#include <vector>

namespace idt {

enum class Number_type {
  FILTERED,
  DOUBLE,
  FLOAT,
  LONG_DOUBLE,
  FLOAT128,
  INTERVAL,
  MPFR,
  CORE,
  HALF_ANGLE_DOUBLE,
  HALF_ANGLE_CORE
};

constexpr Number_type default_number_type = Number_type::FILTERED;

struct Named_number_type
{
  Number_type number_type;
  const char* name;        // its name on the command line and in reports
  const char* description; // a line
};

// All number types, in the order of the enumeration.
const std::vector<Named_number_type>& number_types();

const char* name(Number_type number_type);

// The number type of that name, if there is one.
std::optional<Number_type> find_number_type(const std::string& name);

std::vector<std::string> number_type_names();

} // namespace idt

#endif // IDT_NUMBER_TYPES_NUMBER_TYPE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/Number_type.h"

#include <cstddef>
#include <iterator>

namespace idt {
namespace {

struct Entry
{
  const char* name;
  const char* description;
};

// In the order of the enumeration.
const Entry entries[] = {
  {"filtered", "double with error bounds, and exact if these do not suffice"},
  {"double", "machine numbers: fast; ties and near ties are decided by rounding"},
  {"float", "the same in single precision"},
  {"long-double", "the same in extended precision"},
  {"float128", "the same in quadruple precision, by software"},
  {"interval", "intervals of doubles: an edge is decided correctly or not at all"},
  {"mpfr", "floating point with --precision bits"},
  {"core", "exact real numbers: slow, and very slow near ties"},
  {"half-angle-double", "lengths and half-angle tangents in double, as in the paper"},
  {"half-angle-core", "the same in exact real numbers: for small surfaces"},
};

} // namespace

const char* name(Number_type number_type) { return entries[static_cast<int>(number_type)].name; }

const char* description(Number_type number_type) { return entries[static_cast<int>(number_type)].description; }

const std::vector<Number_type>& number_types()
{
  static const std::vector<Number_type> all = [] {
    std::vector<Number_type> result;
    for (std::size_t i = 0; i < std::size(entries); ++i)
      result.push_back(static_cast<Number_type>(i));
    return result;
  }();
  return all;
}

std::vector<std::string> number_type_names()
{
  std::vector<std::string> names;
  for (Number_type number_type : number_types())
    names.push_back(name(number_type));
  return names;
}

std::optional<Number_type> find_number_type(const std::string& wanted)
{
  for (Number_type number_type : number_types())
    if (wanted == name(number_type))
      return number_type;
  return std::nullopt;
}

} // namespace idt

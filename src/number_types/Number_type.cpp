// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/Number_type.h"

#include <cstddef>

namespace idt {

const std::vector<Named_number_type>& number_types()
{
  static const std::vector<Named_number_type> entries = {
    {Number_type::FILTERED, "filtered", "double with error bounds, and exact if these do not suffice"},
    {Number_type::DOUBLE, "double", "machine numbers: fast; ties and near ties are decided by rounding"},
    {Number_type::FLOAT, "float", "the same in single precision"},
    {Number_type::LONG_DOUBLE, "long-double", "the same in extended precision"},
    {Number_type::FLOAT128, "float128", "the same in quadruple precision, by software"},
    {Number_type::INTERVAL, "interval", "intervals of doubles: an edge is decided correctly or not at all"},
    {Number_type::MPFR, "mpfr", "floating point with --precision bits"},
    {Number_type::CORE, "core", "exact real numbers: slow, and very slow near ties"},
    {Number_type::HALF_ANGLE_DOUBLE, "half-angle-double", "lengths and half-angle tangents in double, as in the paper"},
    {Number_type::HALF_ANGLE_CORE, "half-angle-core", "the same in exact real numbers: for small surfaces"},
  };
  return entries;
}

const char* name(Number_type number_type) { return number_types()[static_cast<std::size_t>(number_type)].name; }

std::vector<std::string> number_type_names()
{
  std::vector<std::string> names;
  for (const Named_number_type& entry : number_types())
    names.push_back(entry.name);
  return names;
}

std::optional<Number_type> find_number_type(const std::string& name)
{
  for (const Named_number_type& entry : number_types())
    if (name == entry.name)
      return entry.number_type;
  return std::nullopt;
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/ply_values.h"

#include "input/standard_input.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace idt {
namespace {

struct Vertex_property
{
  std::string name;
  std::size_t size; // in bytes
  bool is_value;    // or is skipped
};

struct Vertex_rows
{
  std::string format;
  std::size_t count = 0;
  std::vector<Vertex_property> properties;
};

// Reads the header. There are no properties if rows of vertices do not follow at once, each of the same size.
Vertex_rows read_header(std::istream& in)
{
  static const std::map<std::string, std::size_t> sizes = {
    {"char", 1},   {"int8", 1},    {"uchar", 1}, {"uint8", 1},  {"short", 2},  {"int16", 2},
    {"ushort", 2}, {"uint16", 2},  {"int", 4},   {"int32", 4},  {"uint", 4},   {"uint32", 4},
    {"float", 4},  {"float32", 4}, {"int64", 8}, {"uint64", 8}, {"double", 8}, {"float64", 8}};
  static const std::set<std::string> skipped = {"x", "y", "z",         "nx",        "ny",  "nz",    "s",    "t",
                                                "u", "v", "texture_u", "texture_v", "red", "green", "blue", "alpha"};
  Vertex_rows rows;
  std::string line;
  std::getline(in, line);
  if (line.compare(0, 3, "ply") != 0)
    return {};
  std::size_t elements = 0;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string keyword, type, name;
    words >> keyword >> type >> name;
    if (keyword == "end_header")
      return rows;
    if (keyword == "format")
      rows.format = type;
    else if (keyword == "element" && ++elements == 1) {
      if (type != "vertex")
        return {};
      rows.count = std::strtoull(name.c_str(), nullptr, 10);
    } else if (keyword == "property" && elements == 1) {
      const auto size = sizes.find(type);
      if (size == sizes.end())
        return {};
      const bool is_real = type[0] == 'f' || type[0] == 'd';
      rows.properties.push_back({name, size->second, is_real && skipped.count(name) == 0});
    }
  }
  return {};
}

double real(std::string bytes, bool is_big)
{
  const bool is_reversed = is_big != (boost::endian::order::native == boost::endian::order::big);
  if (is_reversed)
    std::reverse(bytes.begin(), bytes.end());
  const auto as = [&bytes](auto number) {
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(&number));
    return double(number);
  };
  return bytes.size() == 4 ? as(0.0f) : as(0.0);
}

} // namespace

std::vector<Named_values> read_ply_values(const std::string& path)
{
  std::ifstream in(readable_file(path), std::ios::binary);
  const Vertex_rows rows = read_header(in);
  std::vector<Named_values> result;
  for (const Vertex_property& property : rows.properties)
    if (property.is_value)
      result.push_back({property.name, {}});
  if (result.empty())
    return {};
  std::string word;
  for (std::size_t v = 0; v < rows.count && in; ++v) {
    auto next = result.begin();
    for (const Vertex_property& property : rows.properties) {
      if (rows.format == "ascii")
        in >> word;
      else {
        word.resize(property.size);
        in.read(word.data(), std::streamsize(word.size()));
      }
      if (property.is_value)
        next++->values.push_back(rows.format == "ascii" ? std::strtod(word.c_str(), nullptr)
                                                        : real(word, rows.format == "binary_big_endian"));
    }
  }
  return in ? result : std::vector<Named_values>();
}

} // namespace idt

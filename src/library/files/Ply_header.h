// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What the header of a PLY file announces, and the parts that each property has in a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H

#include "Text_lines.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The type of a number; of size 0 if it is unknown.
struct Ply_type
{
  const char* name = "";
  std::size_t size = 0; // in bytes
  bool is_real = false;
  // Of the integers; of reals and long integers, of those that a list may have, as in files of some programs.
  long long least = 0, greatest = 0;

  bool is_signed() const { return least < 0; }
};

template <class Number>
constexpr Ply_type ply_type_as(const char* name)
{
  using Limits = std::numeric_limits<Number>;
  if constexpr (Limits::is_integer && sizeof(Number) < 8)
    return {name, sizeof(Number), false, (Limits::min)(), (Limits::max)()};
  else
    return {name, sizeof(Number), !Limits::is_integer,
            Limits::is_signed ? (std::numeric_limits<std::int32_t>::min)() : 0,
            (std::numeric_limits<std::uint32_t>::max)()};
}

inline Ply_type ply_type(const std::string& name)
{
  static constexpr Ply_type types[] = {
    ply_type_as<std::int8_t>("char"),     ply_type_as<std::int8_t>("int8"),     ply_type_as<std::uint8_t>("uchar"),
    ply_type_as<std::uint8_t>("uint8"),   ply_type_as<std::int16_t>("short"),   ply_type_as<std::int16_t>("int16"),
    ply_type_as<std::uint16_t>("ushort"), ply_type_as<std::uint16_t>("uint16"), ply_type_as<std::int32_t>("int"),
    ply_type_as<std::int32_t>("int32"),   ply_type_as<std::uint32_t>("uint"),   ply_type_as<std::uint32_t>("uint32"),
    ply_type_as<std::int64_t>("int64"),   ply_type_as<std::uint64_t>("uint64"), ply_type_as<float>("float"),
    ply_type_as<float>("float32"),        ply_type_as<double>("double"),        ply_type_as<double>("float64")};
  const auto found =
    std::find_if(std::begin(types), std::end(types), [&name](const Ply_type& type) { return type.name == name; });
  return found == std::end(types) ? Ply_type() : *found;
}

struct Ply_property
{
  enum Role : std::size_t {
    X,
    Y,
    Z,
    CORNERS,
    STRIPS, // corners, too
    NONE
  };

  std::string name;
  Ply_type type, size_type; // the latter only for lists: the type of the number of entries
  Role role = NONE;

  bool is_list() const { return size_type.size != 0; }
  bool has_corners() const { return role == CORNERS || role == STRIPS; }
};

struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
  bool is_strips() const { return name == "tristrips"; }
  // The property of that name, null if there is none.
  Ply_property* find(const std::string& property_name)
  {
    for (Ply_property& property : properties)
      if (property.name == property_name)
        return &property;
    return nullptr;
  }
};

struct Ply_header
{
  std::string format;
  std::vector<Ply_element> elements;
  std::size_t bytes = 0, lines = 0;
};

inline Ply_header read_ply_header(const std::string& path, const Text_encoding& encoding)
{
  std::ifstream in(path, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(encoding.begin));
  Ply_header header;
  std::string line, &format = header.format;
  std::vector<Ply_element>& elements = header.elements;
  bool is_ended = false;
  for (std::size_t& number = header.lines = 1; !is_ended && std::getline(in, line, encoding.line_end); ++number) {
    const std::string where = "line " + std::to_string(number) + " of the header: ";
    const auto refuse_unless = [&](const bool is_good, const char* const text) {
      if (!is_good)
        refuse_file(path, where + quote(line) + text);
    };
    std::istringstream words(line.substr(0, 1000));
    // Keywords and names in small letters.
    const auto word = [&words] {
      std::string result;
      words >> result;
      return in_small_letters(result);
    };
    // A name may have blanks.
    const auto name = [&words] {
      std::string result;
      std::getline(words >> std::ws, result);
      while (!result.empty() && is_white(result.back()))
        result.pop_back();
      return in_small_letters(result);
    };
    const std::string keyword = word();
    if (number == 1) {
      if (keyword != "ply")
        refuse_file(path, "the file begins with " + quote(line) + " where ply is expected");
    } else if (keyword == "comment" || keyword == "obj_info" || keyword.empty())
      continue;
    else if (keyword == "format" || format.empty()) {
      const bool is_first = format.empty();
      format = word();
      refuse_unless(is_first && keyword == "format" &&
                      (format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian"),
                    " is not a format (ascii, binary_little_endian or binary_big_endian)");
      word(); // the version, of which there is one
    } else if (keyword == "element") {
      Ply_element element;
      const std::string rest = name();
      const std::size_t blank = (std::min)(rest.find_last_of(" \t"), rest.size());
      element.name = rest.substr(0, rest.find_last_not_of(" \t", blank) + 1);
      long long value = 0;
      refuse_unless(blank < rest.size() && read_integer(rest.substr(blank + 1), value) && value >= 0,
                    " has no number of elements");
      element.count = static_cast<std::size_t>(value);
      for (const Ply_element& other : elements)
        refuse_unless(other.name != element.name, " names an element for the second time");
      elements.push_back(element);
    } else if (keyword == "property") {
      Ply_property property;
      std::string type = word();
      const bool is_list = type == "list";
      if (is_list) {
        property.size_type = ply_type(word());
        type = word();
      }
      property.type = ply_type(type);
      property.name = name();
      if (elements.empty())
        refuse_file(path, where + "a property comes before any element");
      refuse_unless(!property.name.empty() && property.type.size != 0 && property.is_list() == is_list,
                    " has a type that is not known");
      refuse_unless(elements.back().find(property.name) == nullptr, " names a property for the second time");
      elements.back().properties.push_back(property);
    } else {
      refuse_unless(keyword == "end_header", " is not understood");
      is_ended = true;
    }
    refuse_unless(word().empty(), " has a word too many");
  }
  if (!is_ended)
    refuse_file(path, "the header has no end (no line end_header)");
  const std::streamoff told = in.tellg(); // -1 if nothing follows
  header.bytes = static_cast<std::size_t>(told < 0 ? std::streamoff(std::filesystem::file_size(path)) : told);
  return header;
}

// Finds the coordinates and the corners, which must exist and have suitable types.
inline void find_roles(const std::string& path, std::vector<Ply_element>& elements, Polygon_soup& soup)
{
  bool has_vertices = false, has_faces = false;
  for (Ply_element& element : elements) {
    const bool has_corners = element.is_face() || element.is_strips();
    has_vertices = has_vertices || element.is_vertex();
    has_faces = has_faces || has_corners;
    Ply_property* corners = element.find("vertex_indices");
    if (corners == nullptr)
      corners = element.find("vertex_index");
    if (!has_corners && corners != nullptr && corners->is_list() && element.count > 0)
      soup.warnings.push_back("the header announces " + counted(element.count, "element", "elements") + " " +
                              quote(element.name) + " with lists of vertices: left out, as these are not called face");
    if (element.is_vertex())
      for (const Ply_property::Role role : {Ply_property::X, Ply_property::Y, Ply_property::Z}) {
        const std::string name(1, "xyz"[role]);
        Ply_property* const property = element.find(name);
        if (property == nullptr || property->is_list())
          refuse_file(path, "by the header the vertices have no coordinate " + name);
        property->role = role;
      }
    if (has_corners) {
      if (corners == nullptr || !corners->is_list())
        refuse_file(path,
                    "by the header the elements " + element.name + " have no list vertex_indices or vertex_index");
      corners->role = element.is_face() ? Ply_property::CORNERS : Ply_property::STRIPS;
      if (const Ply_property* const other = element.find("vertex_index"); other != nullptr && other != corners)
        soup.warnings.push_back("by the header the elements " + element.name +
                                " have corners twice: vertex_indices are read, and vertex_index left out");
    }
  }
  if (!has_vertices || !has_faces)
    refuse_file(path, std::string("the file has no element ") + (has_vertices ? "face" : "vertex"), Defect::EMPTY);
}

// Checks that the file is large enough for a value of each property of each element.
inline void check_counts(const std::string& path, const Ply_header& header, const std::uintmax_t file_size)
{
  const bool is_text = header.format == "ascii";
  // The last number of a text needs nothing after it.
  const std::uintmax_t room = file_size - (std::min<std::uintmax_t>)(header.bytes, file_size) + is_text;
  for (const Ply_element& element : header.elements) {
    std::uintmax_t least = 0; // the bytes of one element whose lists are empty
    for (const Ply_property& property : element.properties)
      least += is_text ? 2 : (property.is_list() ? property.size_type : property.type).size;
    const std::string announced =
      "the header announces " + counted(element.count, "element", "elements") + " " + quote(element.name);
    if (element.count > 0 && least == 0)
      refuse_file(path, announced + ", which have no property: remove them from the header");
    if (element.count > 0 && element.count > room / least)
      refuse_file(path, announced + ", more than fit into the " + counted(file_size, "byte", "bytes") + " of the file");
  }
}

// A file of this size has no more triangles, text or binary.
inline void reserve_ply(const Ply_element& element, const std::uintmax_t bytes, Polygon_soup& soup)
{
  if (element.is_vertex())
    reserve(soup.points, element.count);
  if (element.is_face())
    reserve(soup.triangles, (std::min<std::uintmax_t>)(element.count, bytes / 8 + 1));
}

// Appends the triangles of strips, which end at -1. Every second triangle is turned. Two equal corners make none: they
// turn the next.
inline void add_strips(const std::string& path, const std::string& where, const std::vector<std::uint32_t>& corners,
                       Polygon_soup& soup)
{
  std::size_t turns = 0, length = 0;
  for (std::size_t i = 0; i <= corners.size(); ++i) {
    if (i == corners.size() || corners[i] == (std::numeric_limits<std::uint32_t>::max)()) {
      if (length == 1 || length == 2)
        refuse_file(path, where + ": a strip of triangles ends after " + counted(length, "vertex", "vertices") +
                            ", before entry " + std::to_string(i) + " of the list");
      length = 0;
      continue;
    }
    if (++length < 3)
      continue;
    const std::array<std::uint32_t, 3> triangle = {corners[i - 2 + (length + 1) % 2], corners[i - 2 + length % 2],
                                                   corners[i]};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      ++turns;
    else
      soup.add_face(triangle.data(), triangle.data() + 3);
  }
  if (turns > 0)
    soup.warnings.push_back(where + ": the strips of triangles turn " + counted(turns, "time", "times") +
                            " at a repeated vertex, which is not a triangle");
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The header of a PLY file: which elements there are, of which properties, and how many.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H

#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

struct Ply_property
{
  std::string name, type, size_type;
}; // size_type: lists only
struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
  bool is_strips() const { return name == "tristrips"; }
  // The first property of that name, null if there is none.
  const Ply_property* find(const std::string& property_name) const
  {
    for (const Ply_property& property : properties)
      if (property.name == property_name)
        return &property;
    return nullptr;
  }
  // The corners of a face, or of strips.
  const Ply_property* find_corners() const
  {
    const Ply_property* const property = find("vertex_indices");
    return property != nullptr ? property : find("vertex_index");
  }
};

// The number of bytes of a type, 0 if there is no such type.
inline std::size_t ply_type_size(const std::string& type)
{
  // clang-format off
  static const struct
  {
    const char* name;
    std::size_t size;
  } table[] = {
    {"char", 1}, {"int8", 1}, {"uchar", 1}, {"uint8", 1},
    {"short", 2}, {"int16", 2}, {"ushort", 2}, {"uint16", 2},
    {"int", 4}, {"int32", 4}, {"uint", 4}, {"uint32", 4},
    {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  // clang-format on
  for (const auto& row : table)
    if (type == row.name)
      return row.size;
  return 0;
}
inline bool is_real(const std::string& type) { return type.compare(0, 5, "float") == 0 || type == "double"; }

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
    // Keywords and names in small letters, whatever they are in.
    const auto word = [&words] {
      std::string result;
      words >> result;
      for (char& c : result)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      return result;
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
      refuse_unless(is_first && keyword == "format" && (format == "ascii" || format == "binary_little_endian" || format == "binary_big_endian"),
                    " is not a format (ascii, binary_little_endian or binary_big_endian)");
      word(); // the version, of which there is one
    } else if (keyword == "element") {
      Ply_element element;
      element.name = word();
      long long value = 0;
      refuse_unless(read_integer(word(), value) && value >= 0, " has no number of elements");
      element.count = static_cast<std::size_t>(value);
      for (const Ply_element& other : elements)
        refuse_unless(other.name != element.name, " names an element for the second time");
      elements.push_back(element);
    } else if (keyword == "property") {
      Ply_property property;
      property.type = word();
      if (property.type == "list") {
        property.size_type = word();
        property.type = word();
      }
      property.name = word();
      if (elements.empty())
        refuse_file(path, where + "a property comes before any element");
      refuse_unless(!property.name.empty() && ply_type_size(property.type) != 0 &&
                      (property.size_type.empty() || (ply_type_size(property.size_type) != 0 && !is_real(property.size_type))),
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

// That properties have types that are known, and that there are x, y and z.
inline void check_types(const std::string& path, const std::vector<Ply_element>& elements)
{
  bool has_vertices = false, has_faces = false;
  for (const Ply_element& element : elements) {
    has_vertices = has_vertices || element.is_vertex();
    has_faces = has_faces || element.is_face() || element.is_strips();
    if (element.is_vertex())
      for (const char* const name : {"x", "y", "z"}) {
        const Ply_property* const property = element.find(name);
        if (property == nullptr || !property->size_type.empty())
          refuse_file(path, std::string("by the header the vertices have no coordinate ") + name);
      }
    if (element.is_face() || element.is_strips()) {
      const Ply_property* const property = element.find_corners();
      if (property == nullptr || property->size_type.empty())
        refuse_file(path, "by the header the elements " + element.name + " have no list vertex_indices or vertex_index");
      if (is_real(property->type))
        refuse_file(path, "by the header the list " + property->name + " of the elements " + element.name + " has the type " + property->type +
                            ", which is none of integers");
    }
  }
  if (!has_vertices || !has_faces)
    refuse_file(path, std::string("the file has no element ") + (has_vertices ? "face" : "vertex"), Defect::EMPTY);
}

// That there may be a value for each property of each element.
inline void check_counts(const std::string& path, const Ply_header& header, const std::uintmax_t file_size)
{
  const bool is_text = header.format == "ascii";
  // The last number of a text needs nothing behind it.
  const std::uintmax_t room = file_size - (std::min<std::uintmax_t>)(header.bytes, file_size) + is_text;
  for (const Ply_element& element : header.elements) {
    std::uintmax_t least = 0; // the bytes of one element whose lists are empty
    for (const Ply_property& property : element.properties)
      least += is_text ? 2 : ply_type_size(property.size_type.empty() ? property.type : property.size_type);
    const std::string announced =
      "the header announces " + counted(element.count, "element", "elements") + " " + quote(element.name);
    if (element.count > 0 && least == 0)
      refuse_file(path, announced + ", which have no property: remove them from the header");
    if (element.count > 0 && element.count > room / least)
      refuse_file(path, announced + ", more than fit into the " + counted(file_size, "byte", "bytes") + " of the file");
  }
}

inline bool is_signed(const std::string& type) { return type[0] == 'i' || type == "char" || type == "short"; }

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_HEADER_H

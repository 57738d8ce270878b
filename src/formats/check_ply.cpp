// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include "text_file.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <vector>

namespace idt {
namespace {

struct Ply_property
{
  std::string name, type, size_type;
}; // size_type: lists only
struct Ply_element
{
  std::string name;
  std::size_t count;
  std::vector<Ply_property> properties;
};

// The number of bytes of a type, 0 if there is no such type.
std::size_t ply_type_size(const std::string& type)
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
bool is_real(const std::string& type) { return type.compare(0, 5, "float") == 0 || type == "double"; }

} // namespace

// What CGAL's reader would trust: that properties have types it knows, that
// x, y and z are real numbers, and that lists are as long as they say.
void check_ply(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::string line, format;
  std::vector<Ply_element> elements;
  bool is_ended = false;
  for (std::size_t number = 1; !is_ended && std::getline(in, line); ++number) {
    const std::string where = "line " + std::to_string(number) + " of the header: ";
    std::istringstream words(line.substr(0, 1000));
    std::string keyword;
    words >> keyword;
    if (number == 1) {
      if (keyword != "ply")
        refuse(path, "the file begins with " + quote(line) + " where ply is expected");
    } else if (number == 2) {
      words >> format;
      if (keyword != "format" || (format != "ascii" && format != "binary_little_endian" &&
                                  format != "binary_big_endian"))
        refuse(path, where + quote(line) + " is not a format (ascii, binary_little_endian or binary_big_endian)");
    } else if (keyword == "element") {
      Ply_element element;
      std::string count;
      words >> element.name >> count;
      long long value = 0;
      if (!read_integer(count, value) || value < 0)
        refuse(path, where + quote(line) + " has no number of elements");
      element.count = static_cast<std::size_t>(value);
      elements.push_back(element);
    } else if (keyword == "property") {
      Ply_property property;
      words >> property.type;
      if (property.type == "list")
        words >> property.size_type >> property.type;
      words >> property.name;
      if (elements.empty())
        refuse(path, where + "a property comes before any element");
      if (property.name.empty() || ply_type_size(property.type) == 0 ||
          (!property.size_type.empty() &&
           (ply_type_size(property.size_type) == 0 || is_real(property.size_type))))
        refuse(path, where + quote(line) + " has a type that is not known");
      elements.back().properties.push_back(property);
    } else if (keyword == "end_header")
      is_ended = true;
    else if (keyword != "comment" && keyword != "obj_info")
      refuse(path, where + quote(line) + " is not understood");
  }
  if (!is_ended)
    refuse(path, "the header has no end (no line end_header)");

  const auto find = [](const Ply_element& element, const std::string& name) -> const Ply_property* {
    for (const Ply_property& property : element.properties)
      if (property.name == name)
        return &property;
    return nullptr;
  };
  bool has_vertices = false, has_faces = false, has_long_lists = false;
  for (const Ply_element& element : elements) {
    const bool is_vertex = element.name == "vertex" || element.name == "vertices";
    const bool is_face = element.name == "face" || element.name == "faces";
    has_vertices = has_vertices || is_vertex;
    has_faces = has_faces || is_face;
    if (is_vertex)
      for (const char* const name : {"x", "y", "z"}) {
        const Ply_property* const property = find(element, name);
        if (property == nullptr || !property->size_type.empty() || !is_real(property->type))
          refuse(path, std::string("the vertices have no coordinate ") + name + " of type float or double");
      }
    if (is_face) {
      const Ply_property* property = find(element, "vertex_indices");
      if (property == nullptr)
        property = find(element, "vertex_index");
      if (property == nullptr || property->size_type.empty())
        refuse(path, "the faces have no list vertex_indices or vertex_index");
      if (ply_type_size(property->type) != 4 || is_real(property->type))
        refuse(path, "the list " + property->name + " of the faces has the type " + property->type +
                       ", only int and uint are read");
    }
    // The reader takes the type of a color from the first channel that it finds.
    if (is_vertex || is_face)
      for (const char* const name : {"red", "green", "blue", "r", "g", "b"}) {
        const Ply_property* const property = find(element, name);
        const Ply_property* const red = find(element, name[1] == '\0' ? "r" : "red");
        if (property != nullptr && red != nullptr &&
            (property->type != red->type || property->size_type != red->size_type))
          refuse(path, "the color channels of element " + element.name + " have different types");
      }
    if (element.name == "halfedge")
      for (const char* const name : {"source", "target"}) {
        const Ply_property* const property = find(element, name);
        if (property != nullptr && (property->type != "uint" && property->type != "uint32"))
          refuse(path, std::string("the property ") + name + " of element halfedge is not of type uint");
      }
    for (const Ply_property& property : element.properties)
      has_long_lists = has_long_lists || ply_type_size(property.size_type) == 4;
  }
  if (!has_vertices || !has_faces)
    refuse(path, std::string("the file has no element ") + (has_vertices ? "face" : "vertex"), Defect::EMPTY);
  if (!has_long_lists)
    return;

  // A list whose size is a 32-bit number may claim gigabytes: go through the
  // data once, and only then let the reader allocate.
  const std::size_t data = static_cast<std::size_t>(in.tellg());
  const std::string text = load(path);
  const std::string body = format == "ascii" ? text.substr((std::min)(data, text.size())) : std::string();
  Scanner scanner(body);
  std::size_t position = data;
  for (const Ply_element& element : elements)
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Ply_property& property : element.properties) {
        const std::string where = "element " + element.name + " " + std::to_string(i);
        std::size_t size = 1;
        if (!property.size_type.empty()) {
          const std::size_t bytes = ply_type_size(property.size_type);
          long long value = 0;
          if (format == "ascii") {
            if (!read_integer(scanner.word(), value))
              return; // the reader will stop here too
          } else {
            if (text.size() < position + bytes)
              return;
            unsigned long long bits = 0;
            for (std::size_t b = 0; b < bytes; ++b)
              bits |= static_cast<unsigned long long>(static_cast<unsigned char>(text[position + b]))
                      << 8 * (format == "binary_big_endian" ? bytes - 1 - b : b);
            position += bytes;
            value = static_cast<long long>(bits);
            if (property.size_type[0] != 'u' && (bits >> (8 * bytes - 1)) != 0)
              value = -1;
          }
          const std::size_t left = format == "ascii" ? scanner.remaining() : text.size() - position;
          if (value < 0 || static_cast<unsigned long long>(value) > left)
            refuse(path, where + ": the list " + property.name + " claims more entries than the file has");
          size = static_cast<std::size_t>(value);
        }
        if (format != "ascii") {
          position += size * ply_type_size(property.type);
          if (position > text.size())
            return;
        } else
          for (std::size_t k = 0; k < size; ++k)
            if (scanner.word().empty())
              return;
      }
}

} // namespace idt

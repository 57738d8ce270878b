// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Text_check.h"
#include "input/formats/text_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
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

struct Ply_header
{
  std::string format;
  std::vector<Ply_element> elements;
  std::size_t bytes = 0, lines = 0;
};

Ply_header read_ply_header(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  Ply_header header;
  std::string line, &format = header.format;
  std::vector<Ply_element>& elements = header.elements;
  bool is_ended = false;
  for (std::size_t& number = header.lines = 1; !is_ended && std::getline(in, line); ++number) {
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
  const std::streamoff told = in.tellg();
  header.bytes = told < 0 ? load(path).size() : static_cast<std::size_t>(told); // nothing follows the header
  return header;
}

// What CGAL's reader would trust: that properties have types it knows, and that
// x, y and z are real numbers.
void check_types(const std::string& path, const std::vector<Ply_element>& elements)
{
  const auto find = [](const Ply_element& element, const std::string& name) -> const Ply_property* {
    for (const Ply_property& property : element.properties)
      if (property.name == name)
        return &property;
    return nullptr;
  };
  bool has_vertices = false, has_faces = false;
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
  }
  if (!has_vertices || !has_faces)
    refuse(path, std::string("the file has no element ") + (has_vertices ? "face" : "vertex"), Defect::EMPTY);
}

// What CGAL's reader would trust: that there is a value for each property of each element. It makes
// as many rounds as the header says, whatever the file has.
void check_counts(const std::string& path, const Ply_header& header, const std::uintmax_t file_size)
{
  const bool is_text = header.format == "ascii";
  // The last number of a text needs nothing behind it.
  const std::uintmax_t room = file_size - (std::min<std::uintmax_t>)(header.bytes, file_size) + is_text;
  for (const Ply_element& element : header.elements) {
    std::uintmax_t least = 0; // the bytes of one element whose lists are empty
    for (const Ply_property& property : element.properties)
      least += is_text ? 2 : ply_type_size(property.size_type.empty() ? property.type : property.size_type);
    const std::string announced =
      "the header announces " + std::to_string(element.count) + " elements " + quote(element.name);
    if (element.count > 0 && least == 0)
      refuse(path, announced + ", which have no property: remove them from the header");
    if (element.count > 0 && element.count > room / least)
      refuse(path, announced + ", more than fit into the " + std::to_string(file_size) + " bytes of the file");
  }
}

bool is_signed(const std::string& type) { return type[0] == 'i' || type == "char" || type == "short"; }

// A list whose size is a 32-bit number may claim gigabytes, and one whose size has a sign less than
// nothing; beyond the end of the file, the reader takes whatever is in memory for a size. Goes through the data
// once, and only then lets the reader allocate.
void check_binary_lists(const std::string& path, const Ply_header& header)
{
  bool has_lists = false;
  for (const Ply_element& element : header.elements)
    for (const Ply_property& property : element.properties)
      has_lists = has_lists || ply_type_size(property.size_type) == 4 ||
                  (!property.size_type.empty() && is_signed(property.size_type));
  if (!has_lists)
    return;
  const std::string text = load(path);
  std::size_t position = header.bytes;
  for (const Ply_element& element : header.elements)
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Ply_property& property : element.properties) {
        const auto where = [&] { return "element " + element.name + " " + std::to_string(i) + ": "; };
        const auto require = [&](std::size_t bytes) {
          if (bytes > text.size() - position)
            refuse(path, where() + "the file ends within " + property.name);
        };
        std::size_t size = 1;
        if (!property.size_type.empty()) {
          const std::size_t bytes = ply_type_size(property.size_type);
          require(bytes);
          unsigned long long bits = 0;
          for (std::size_t b = 0; b < bytes; ++b)
            bits |= static_cast<unsigned long long>(static_cast<unsigned char>(text[position + b]))
                    << 8 * (header.format == "binary_big_endian" ? bytes - 1 - b : b);
          position += bytes;
          if (is_signed(property.size_type) && (bits >> (8 * bytes - 1)) != 0)
            refuse(path, where() + "the list " + property.name + " claims a negative number of entries");
          if (bits > text.size() - position)
            refuse(path, where() + "the list " + property.name + " claims more entries than the file has");
          size = static_cast<std::size_t>(bits);
        }
        require(size * ply_type_size(property.type));
        position += size * ply_type_size(property.type);
      }
}

// CGAL's reader takes of each word what looks like a number, cuts the sizes of lists to their type, and
// where it stops is not where the mistake is.
class Ply_text_check : public Word_check
{
public:
  Ply_text_check(const std::string& path, Ply_header header, const std::uintmax_t file_size)
    : path_(path), header_(std::move(header)), file_size_(file_size)
  {
    restart();
  }

  void take(const char* first, const char* const last) override
  {
    const std::size_t skipped = (std::min)(to_skip_, static_cast<std::size_t>(last - first));
    to_skip_ -= skipped;
    Word_check::take(first + skipped, last);
  }
  void restart() override
  {
    Word_check::restart();
    set_number(header_.lines);
    to_skip_ = header_.bytes;
    element_ = index_ = property_ = left_in_list_ = 0;
    go_to_next_property();
  }

private:
  // Passes over what there is nothing of.
  void go_to_next_property()
  {
    while (element_ < header_.elements.size() &&
           (index_ == header_.elements[element_].count || property_ == header_.elements[element_].properties.size()))
      if (index_ == header_.elements[element_].count) {
        ++element_;
        index_ = property_ = 0;
      } else {
        ++index_;
        property_ = 0;
      }
  }

  void word(const char* const first, const char* const last) override
  {
    if (element_ == header_.elements.size())
      return;
    const Ply_property& property = header_.elements[element_].properties[property_];
    if (property.size_type.empty() || left_in_list_ > 0)
      check_value(first, last, property);
    else {
      const long long size = check_integer(first, last, property.size_type, "the size of the list " + property.name);
      if (size < 0)
        refuse(path_, where() + ": the list " + property.name + " claims a negative number of entries");
      // Each entry takes two bytes.
      if (static_cast<std::uintmax_t>(size) > (file_size_ - (std::min<std::uintmax_t>)(header_.bytes, file_size_)) / 2 + 1)
        refuse(path_, where() + ": the list " + property.name + " claims more entries than the file has");
      left_in_list_ = static_cast<std::size_t>(size) + 1;
    }
    if (left_in_list_ > 0 && --left_in_list_ > 0)
      return;
    ++property_;
    go_to_next_property();
  }

  void check_value(const char* const first, const char* const last, const Ply_property& property) const
  {
    if (!is_real(property.type)) {
      check_integer(first, last, property.type, property.name);
      return;
    }
    const bool is_float = ply_type_size(property.type) == 4;
    // Forty digits may be more than a float can hold.
    if (skip_plain_number(first, last) == last &&
        !(is_float && (last - first > 30 || std::find_if(first, last, [](char c) { return c == 'e' || c == 'E'; }) != last)))
      return;
    const std::string word(first, last);
    const double number = check_coordinate(path_, word, where(), index_);
    if (is_float && std::abs(number) > (std::numeric_limits<float>::max)())
      refuse(path_, where() + ": " + property.name + " is of type float, for which " + quote(word) + " is too large",
             Defect::OUT_OF_RANGE, index_);
  }

  long long check_integer(const char* const first, const char* const last, const std::string& type,
                          const std::string& name) const
  {
    long long number = 0;
    const std::from_chars_result result = std::from_chars(first, last, number);
    const std::size_t bits = 8 * ply_type_size(type);
    const bool has_sign = is_signed(type);
    const long long greatest = (1LL << (has_sign ? bits - 1 : bits)) - 1, least = has_sign ? -greatest - 1 : 0;
    if (result.ec == std::errc() && result.ptr == last && number >= least && number <= greatest)
      return number;
    const std::string word(first, last);
    if (!read_integer(word, number) && !is_beyond_integers(word))
      refuse(path_, where() + ": " + quote(word) + " is not an integer, which is needed for " + name);
    if (!is_beyond_integers(word) && number >= least && number <= greatest)
      return number; // with a sign that from_chars() does not take
    refuse(path_, where() + ": " + quote(word) + " is out of range for " + name + ", which is of type " + type);
  }

  std::string where() const
  {
    return "line " + std::to_string(number()) + ", element " + header_.elements[element_].name + " " +
           std::to_string(index_);
  }

  std::string path_;
  Ply_header header_;
  std::uintmax_t file_size_;
  std::size_t to_skip_ = 0;
  // The next value: of which element, which one of them, and how many entries of a list and its size are left.
  std::size_t element_ = 0, index_ = 0, property_ = 0, left_in_list_ = 0;
};

} // namespace

Prepared_text check_ply(const std::string& path, const std::uintmax_t file_size)
{
  Ply_header header = read_ply_header(path);
  check_types(path, header.elements);
  check_counts(path, header, file_size);
  if (header.format == "ascii")
    return {std::make_unique<Ply_text_check>(path, std::move(header), file_size), std::nullopt};
  check_binary_lists(path, header);
  return {};
}

} // namespace idt

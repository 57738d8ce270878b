// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// PLY, text or binary: elements with properties; coordinates and corners are read, others skipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H

#include "Text_lines.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
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

template <boost::endian::order order>
class Ply_binary_reader
{
public:
  Ply_binary_reader(const std::string& path, const Ply_header& header, Polygon_soup& soup, File_blocks& file)
    : path_(path), header_(header), soup_(soup), file_(file)
  {}

  void read()
  {
    for (const Ply_element& element : header_.elements) {
      reserve_ply(element, file_.left(), soup_);
      const std::vector<Ply_property>& properties = element.properties;
      const bool has_lists =
        std::any_of(properties.begin(), properties.end(), [](const Ply_property& p) { return p.is_list(); });
      std::size_t done = 0;
      if (element.is_vertex() && !has_lists)
        done = take_vertices(element);
      for (; done < element.count; ++done) {
        if (properties.size() == 1 && properties[0].size_type.size == 1 && properties[0].type.size == 4 &&
            !properties[0].type.is_real && element.is_face())
          done += take_triangles(element.count - done);
        if (done < element.count)
          take_element(element, done);
      }
    }
    check_end();
    check_empty_face();
  }

private:
  template <class T>
  static T load(const char* const p)
  {
    return boost::endian::endian_load<T, sizeof(T), order>(reinterpret_cast<const unsigned char*>(p));
  }
  static double load_number(const char* const p, const Ply_type& type)
  {
    if (type.is_real)
      return type.size == 8 ? load<double>(p) : static_cast<double>(load<float>(p));
    if (type.size == 8)
      return type.is_signed() ? static_cast<double>(load<std::int64_t>(p))
                              : static_cast<double>(load<std::uint64_t>(p));
    const std::uint32_t bits = load_integer(p, type);
    return type.is_signed() ? static_cast<double>(static_cast<std::int32_t>(bits)) : static_cast<double>(bits);
  }

  // An integer of up to four bytes, modulo 2^32 if it is negative.
  static std::uint32_t load_integer(const char* const p, const Ply_type& type)
  {
    const bool is_signed = type.is_signed();
    return type.size == 1   ? (is_signed ? static_cast<std::uint32_t>(load<std::int8_t>(p)) : load<std::uint8_t>(p))
           : type.size == 2 ? (is_signed ? static_cast<std::uint32_t>(load<std::int16_t>(p)) : load<std::uint16_t>(p))
                            : load<std::uint32_t>(p);
  }

  // Bytes after the elements are faces or vertices missing in the header, unless they are empty.
  void check_end()
  {
    const std::uintmax_t begin = file_.offset();
    std::uintmax_t count = 0;
    bool is_empty = true;
    while (file_.require(1)) {
      is_empty = is_empty && std::all_of(file_.first, file_.last, [](char c) { return c == 0 || is_white(c); });
      count += file_.available();
      file_.first = file_.last;
    }
    if (count == 0)
      return;
    const std::string text = "from byte " + std::to_string(begin) + " on there " + are_counted(count, "byte", "bytes") +
                             " behind the elements that the header announces (" + announced() + ")";
    if (!is_empty)
      refuse_file(path_, text + ": correct these numbers, or cut off what is behind" + hint());
    soup_.warnings.push_back(text + ", which are zeros or blanks");
  }

  // If the header has one vertex too many, the first face is taken for it, except for zero bytes that look like an
  // empty face, and everything else fits. A face that names the last vertex shows that the count is right.
  void check_empty_face() const
  {
    if (byte_of_empty_face_ == 0)
      return;
    const auto has_elements = [](const Ply_element& element) { return element.count > 0; };
    const auto first = std::find_if(header_.elements.begin(), header_.elements.end(), has_elements);
    const auto second = std::find_if(first + 1, header_.elements.end(), has_elements);
    if (first->is_face())
      return;
    const std::uint32_t last = static_cast<std::uint32_t>(soup_.points.size() - 1);
    bool is_named = false;
    for (std::size_t f = 0; f < soup_.number_of_faces() && !is_named; ++f)
      is_named = std::count(soup_.polygon(f).begin(), soup_.polygon(f).end(), last) > 0;
    if (!is_named || !first->is_vertex() || !second->is_face())
      refuse_file(path_, "element face 0: the list of its vertices is empty" +
                           (is_named ? "" : ", and no face names the last vertex, " + std::to_string(last)) +
                           ": remove the face, or correct the header if it announces an element too many before the "
                           "faces (the face begins at byte " +
                           std::to_string(byte_of_empty_face_) + "; the header announces " + announced() + ")");
  }

  std::string announced() const
  {
    std::string result;
    for (const Ply_element& element : header_.elements)
      result += (result.empty() ? "" : ", ") + std::to_string(element.count) + " " + element.name;
    return result;
  }

  // Where to look for the mistake: after a byte too few or too many, faces name vertices that do not exist.
  std::string hint() const
  {
    if (byte_of_empty_face_ != 0)
      return "; the first face, at byte " + std::to_string(byte_of_empty_face_) +
             ", is empty: the file may be damaged before it";
    std::size_t vertices = 0;
    for (const Ply_element& element : header_.elements)
      vertices += element.is_vertex() ? element.count : 0;
    for (std::size_t f = 0; f < soup_.number_of_faces(); ++f)
      for (const std::uint32_t v : soup_.polygon(f))
        if (v >= vertices)
          return "; the first face that names a vertex that is not there is face " + std::to_string(f) +
                 ": the file may be damaged before it";
    return std::string();
  }

  // Reads vertices of equal size with coordinates of one real type, and none otherwise. Returns how many there are
  // before the end of the file.
  std::size_t take_vertices(const Ply_element& element)
  {
    std::size_t stride = 0;
    std::array<std::size_t, 3> offset{};
    std::array<const Ply_type*, 3> type{};
    for (const Ply_property& property : element.properties) {
      if (property.role < 3) {
        offset[property.role] = stride;
        type[property.role] = &property.type;
      }
      stride += property.type.size;
    }
    const auto are_reals_of = [&type](const std::size_t size) {
      return std::all_of(type.begin(), type.end(), [size](const Ply_type* t) { return t->is_real && t->size == size; });
    };
    const auto take = [&](auto real) {
      using Real = decltype(real);
      std::size_t done = 0;
      while (done < element.count && file_.require(stride)) {
        const std::size_t n = (std::min)(element.count - done, file_.available() / stride);
        const char* p = file_.first;
        double sum = 0; // which is not finite if a coordinate is not
        for (std::size_t i = 0; i < n; ++i, p += stride) {
          const std::array<double, 3> point{load<Real>(p + offset[0]), load<Real>(p + offset[1]),
                                            load<Real>(p + offset[2])};
          sum += point[0] + point[1] + point[2];
          soup_.points.push_back(point);
        }
        for (std::size_t i = 0; i < n && !std::isfinite(sum); ++i)
          require_finite(element, done + i, file_.offset() + i * stride);
        file_.first = p;
        done += n;
      }
      return done;
    };
    return are_reals_of(8) ? take(double()) : are_reals_of(4) ? take(float()) : 0;
  }

  void require_finite(const Ply_element& element, const std::size_t vertex, const std::uintmax_t begin) const
  {
    for (const double coordinate : soup_.points[vertex])
      if (!std::isfinite(coordinate))
        refuse_file(path_,
                    "element " + element.name + " " + std::to_string(vertex) +
                      ": a coordinate is not finite (the element begins at byte " + std::to_string(begin) + ")",
                    Defect::NOT_FINITE, vertex);
  }

  // Reads consecutive faces that consist of a byte and three indices. Returns their number.
  std::size_t take_triangles(const std::size_t at_most)
  {
    using Index = std::uint32_t;
    constexpr std::size_t stride = 1 + 3 * sizeof(Index);
    std::size_t done = 0;
    while (done < at_most && soup_.is_triangulated() && file_.require(stride)) {
      const std::size_t n = (std::min)(at_most - done, file_.available() / stride);
      const char* p = file_.first;
      std::size_t i = 0;
      for (; i < n && *p == 3; ++i, p += stride)
        soup_.triangles.push_back(
          {load<Index>(p + 1), load<Index>(p + 1 + sizeof(Index)), load<Index>(p + 1 + 2 * sizeof(Index))});
      file_.first = p;
      done += i;
      if (i < n)
        break;
    }
    return done;
  }

  // The general case. Skipped data is never in memory as a whole.
  void take_element(const Ply_element& element, const std::size_t index)
  {
    std::array<double, 3> point{};
    const std::uintmax_t begin = file_.offset();
    for (const Ply_property& property : element.properties) {
      const auto refuse = [&](const std::string& text) {
        refuse_file(path_, "element " + element.name + " " + std::to_string(index) + ": " + text +
                             " (the element begins at byte " + std::to_string(begin) + "; the header announces " +
                             announced() + ")" + hint());
      };
      const auto integer = [&](const char* const p, const Ply_type& type) {
        if (!type.is_real && type.size < 8)
          return load_integer(p, type);
        const double number = load_number(p, type);
        if (!(number >= double(type.least) && number <= double(type.greatest) && number == std::trunc(number)))
          refuse("the list " + property.name + " has " + std::to_string(number) + " where an integer is needed");
        return static_cast<std::uint32_t>(static_cast<long long>(number));
      };
      std::uintmax_t count = 1;
      if (property.is_list()) {
        const Ply_type& type = property.size_type;
        if (!file_.require(type.size))
          refuse("the file ends within " + property.name);
        const std::uint32_t bits = integer(file_.first, type);
        file_.first += type.size;
        if (type.is_signed() && static_cast<std::int32_t>(bits) < 0)
          refuse("the list " + property.name + " claims a negative number of entries");
        if (bits > file_.left())
          refuse("the list " + property.name + " claims more entries than the file has");
        if (bits == 0 && property.role == Ply_property::CORNERS && index == 0)
          byte_of_empty_face_ = begin;
        count = bits;
      }
      const std::uintmax_t bytes = count * property.type.size;
      if (property.role == Ply_property::NONE ? !file_.skip(bytes)
                                              : bytes > file_.left() || !file_.require(static_cast<std::size_t>(bytes)))
        refuse("the file ends within " + property.name);
      if (property.role == Ply_property::NONE)
        continue;
      if (property.has_corners()) {
        corners_.clear();
        for (std::size_t i = 0; i < count; ++i)
          corners_.push_back(integer(file_.first + property.type.size * i, property.type));
        if (property.role == Ply_property::CORNERS)
          soup_.add_face(corners_.data(), corners_.data() + corners_.size());
        else
          add_strips(path_, "element " + element.name + " " + std::to_string(index), corners_, soup_);
      } else
        point[property.role] = load_number(file_.first, property.type);
      file_.first += bytes;
    }
    if (!element.is_vertex())
      return;
    soup_.points.push_back(point);
    require_finite(element, index, begin);
  }

  std::string path_;
  const Ply_header& header_;
  Polygon_soup& soup_;
  File_blocks& file_;
  std::uintmax_t byte_of_empty_face_ = 0; // if the first one is empty
  std::vector<std::uint32_t> corners_;    // of a face
};

// Words in the order of the elements and their properties. An element is a line, or goes on over several; or everything
// is in one line.
class Ply_text_reader
{
public:
  Ply_text_reader(const std::string& path, const Ply_header& header, Polygon_soup& soup, const std::uintmax_t size,
                  const Progress_function& progress, const char line_end)
    : path_(path), header_(header), soup_(soup),
      lines_(path, size, progress, {header.bytes, line_end}, header.lines - 1, no_comment),
      size_(size - (std::min<std::uintmax_t>)(size, header.bytes))
  {}

  void read()
  {
    std::size_t end = 0; // the line on which the element before ends
    for (const Ply_element& element : header_.elements) {
      element_ = &element;
      reserve_ply(element, size_, soup_);
      const bool is_vertex = element.is_vertex();
      for (index_ = 0; index_ < element.count; ++index_) {
        if (!find_word())
          refuse_end();
        if (begin_ == 0)
          first_ = lines_.number();
        if (lines_.number() == end && surplus_.empty()) {
          is_row_short_ = begin_ != lines_.number();
          surplus_ = line_of_two();
          last_line_ = end;
        }
        if (lines_.number() == end && end != first_)
          refuse_surplus();
        begin_ = lines_.number();
        take_element(is_vertex);
        end = lines_.number();
      }
    }
    if (!find_word())
      return;
    if (!surplus_.empty() && lines_.number() != end)
      refuse_surplus();
    refuse_file(path_, "line " + std::to_string(lines_.number()) + ": " + quote(lines_.take_word()) +
                         " is behind the " + so_far() +
                         " that the header announces: correct these numbers, or remove what is left over");
  }

private:
  // The defect if the line ends within the elements that begin on it: a row of too many or too few numbers.
  std::string line_of_two()
  {
    const bool is_first = index_ == 0;
    const Ply_element& before = is_first ? *(element_ - 1) : *element_;
    std::string names;
    for (const Ply_property& property : before.properties)
      names += (names.empty() ? "" : ", ") + property.name;
    return "line " + std::to_string(begin_) + ", element " + before.name + " " +
           std::to_string(is_first ? before.count - 1 : index_ - 1) +
           (!is_row_short_ ? std::string() : ", which goes on over line " + std::to_string(lines_.number())) + ": " +
           quote(std::string(lines_.p, skip_word(lines_.p, lines_.last))) +
           " is behind the numbers that the header names (" + names + "); " +
           (!is_row_short_ ? "name it there" : "add what is missing before it");
  }

  [[noreturn]] void refuse_surplus()
  {
    std::size_t elements = 0;
    for (const Ply_element& element : header_.elements)
      elements += element.count;
    while (lines_.next_line()) {
    }
    // There are enough lines: each element has one.
    const bool are_alone = lines_.number() >= header_.lines - 1 + elements;
    refuse_file(path_,
                surplus_ + (!are_alone      ? ", or begin each element on a line of its own"
                            : is_row_short_ ? ""
                                            : ", or remove it"),
                Defect::UNREADABLE, index_);
  }

  void take_element(const bool is_vertex)
  {
    std::array<double, 3> point{};
    for (const Ply_property& property : element_->properties) {
      if (!property.is_list()) {
        if (property.role < 3)
          point[property.role] = take_value(property);
        else
          skip_value(property);
        continue;
      }
      const long long count = take_integer(property.size_type, [&] { return "the size of the list " + property.name; });
      if (count < 0)
        refuse_file(path_, where() + ": the list " + property.name + " claims a negative number of entries");
      // Each entry takes two bytes.
      if (static_cast<std::uintmax_t>(count) > size_ / 2 + 1)
        refuse_file(path_, where() + ": the list " + property.name + " claims more entries than the file has");
      corners_.clear();
      for (long long i = 0; i < count; ++i)
        if (property.has_corners())
          corners_.push_back(static_cast<std::uint32_t>(take_integer(property.type, [&] { return property.name; })));
        else
          skip_value(property);
      if (!property.has_corners())
        continue;
      if (property.role == Ply_property::CORNERS)
        soup_.add_face(corners_.data(), corners_.data() + corners_.size());
      else
        add_strips(path_, where(), corners_, soup_);
    }
    if (is_vertex)
      soup_.points.push_back(point);
  }

  // Goes to the next word; false at the end of the file.
  bool find_word()
  {
    const bool is_there = lines_.find_word();
    if (is_there && lines_.number() > last_line_)
      refuse_surplus();
    return is_there;
  }
  void require_word()
  {
    if (!find_word())
      refuse_end();
  }
  [[noreturn]] void refuse_end()
  {
    if (!surplus_.empty())
      refuse_surplus();
    refuse_file(path_, "the file ends too early, after " + so_far());
  }
  std::string so_far() const { return vertices_and_faces(soup_.points.size(), soup_.number_of_faces()); }
  template <class Real>
  bool take_real(Real& number)
  {
    return internal::take_real(lines_.p, lines_.last, number);
  }

  double take_value(const Ply_property& property)
  {
    if (!property.type.is_real)
      return static_cast<double>(take_integer(property.type, [&] { return property.name; }));
    const bool is_double = property.type.size == 8;
    require_word();
    double number = 0;
    float rounded = 0;
    if (is_double ? take_real(number) : take_real(rounded))
      return is_double ? number : rounded;
    const std::string_view word = lines_.take_word();
    number = check_coordinate(path_, word, where(), index_);
    if (is_double)
      return number;
    if (std::abs(number) > (std::numeric_limits<float>::max)())
      refuse_file(path_,
                  where() + ": " + property.name + " is of type float, for which " + quote(word) + " is too large",
                  Defect::OUT_OF_RANGE, index_);
    return static_cast<float>(number);
  }

  // Skips unneeded data, which may be any number: not finite, or out of the range of its type.
  void skip_value(const Ply_property& property)
  {
    require_word();
    if (double ignored = 0; take_real(ignored))
      return;
    if (const std::string_view word = lines_.take_word(); !is_number(word))
      refuse_file(path_, where() + ": " + quote(word) + " is not a number, which is needed for " + property.name,
                  Defect::UNREADABLE, index_);
  }

  // \param what describes it
  template <class What>
  long long take_integer(const Ply_type& type, const What& what)
  {
    require_word();
    const char* p = lines_.p;
    if (std::uint32_t count = 0; take_count(p, lines_.last, count) && count <= type.greatest) {
      lines_.p = p;
      return count;
    }
    long long number = 0;
    const std::string_view word = lines_.take_word();
    Integer_state state = integer_state(word, number);
    if (double real = 0; state == Integer_state::NOT_AN_INTEGER && type.is_real &&
                         read_number(word, real) == Number_state::GOOD && real == std::trunc(real)) {
      const bool is_small = real >= double(type.least) && real <= double(type.greatest);
      state = is_small ? Integer_state::GOOD : Integer_state::TOO_LARGE;
      number = is_small ? static_cast<long long>(real) : 0;
    }
    if (state == Integer_state::NOT_AN_INTEGER)
      refuse_file(path_, where() + ": " + quote(word) + " is not an integer, which is needed for " + what());
    if (state == Integer_state::TOO_LARGE || number < type.least || number > type.greatest)
      refuse_file(path_,
                  where() + ": " + quote(word) + " is out of range for " + what() + ", which is of type " + type.name);
    return number;
  }

  std::string where() const
  {
    return "line " + std::to_string(lines_.number()) + ", element " + element_->name + " " + std::to_string(index_);
  }

  std::string path_;
  const Ply_header& header_;
  Polygon_soup& soup_;
  static constexpr char no_comment = '\n'; // no word begins with it
  Text_lines lines_;
  const std::uintmax_t size_;         // of the data after the header
  std::size_t first_ = 0, begin_ = 0; // the lines on which the first element begins, and this one
  std::string surplus_;               // the defect of the line if another one follows it
  bool is_row_short_ = false;         // whether the defect is that the previous row has too few numbers
  std::size_t last_line_ = (std::numeric_limits<std::size_t>::max)(); // there must be no other then
  const Ply_element* element_ = nullptr;
  std::size_t index_ = 0;              // of the element among the elements of its kind
  std::vector<std::uint32_t> corners_; // of a face
};

// The first line tells how the lines of the header end: the data after it may not be text.
inline Text_encoding find_ply_encoding(const std::string& path)
{
  Text_encoding result = find_encoding(path);
  const std::string head = load_file(path, 1000);
  const std::size_t end = head.find_first_of("\r\n");
  result.line_end = end != std::string::npos && head[end] == '\r' && head.compare(end, 2, "\r\n") != 0 ? '\r' : '\n';
  return result;
}

inline void read_ply(const std::string& path, const std::uintmax_t size, const Progress_function& progress,
                     Polygon_soup& soup)
{
  const Text_encoding encoding = find_ply_encoding(path);
  Ply_header header = read_ply_header(path, encoding);
  find_roles(path, header.elements, soup);
  check_counts(path, header, size);
  if (header.format == "ascii")
    return Ply_text_reader(path, header, soup, size, progress, encoding.line_end).read();
  File_blocks file(path, size, header.bytes, progress);
  if (header.format == "binary_little_endian")
    Ply_binary_reader<boost::endian::order::little>(path, header, soup, file).read();
  else
    Ply_binary_reader<boost::endian::order::big>(path, header, soup, file).read();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H

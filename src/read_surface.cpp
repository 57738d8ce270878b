// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_surface.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace idt {
namespace {

using CGAL::Intrinsic_triangulations::Invalid_surface_error;
typedef Invalid_surface_error::Defect Defect;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;

// The corners of a polygon while it is read: no allocation for triangles and
// quadrangles, and no attempt to hold a number of corners that only a broken
// file announces.
class Corners : public boost::container::small_vector<std::uint32_t, 4>
{
  typedef boost::container::small_vector<std::uint32_t, 4> Base;

public:
  void resize(const std::size_t size)
  {
    if (size > (std::size_t(1) << 24))
      throw std::length_error("a face claims to have " + std::to_string(size) + " corners");
    Base::resize(size);
  }
};
typedef std::vector<Point> Points;
typedef std::vector<Corners> Polygons;

[[noreturn]] void refuse(const std::string& path, const std::string& text,
                         const Defect defect = Defect::UNREADABLE, const std::size_t element = 0,
                         const std::size_t count = 1)
{
  throw Invalid_surface_error(defect, element, count, path + ": " + text);
}

std::string load(const std::string& path, const std::size_t at_most = (std::numeric_limits<std::size_t>::max)())
{
  std::ifstream in(path, std::ios::binary);
  std::error_code ignored;
  std::string text((std::min<std::uintmax_t>)(std::filesystem::file_size(path, ignored), at_most), '\0');
  in.read(&text[0], static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

std::string lower_case(std::string text)
{
  for (char& c : text)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return text;
}

// A piece of a file as it can stand in a message.
std::string quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char c : text.substr(0, 40))
    quoted += c >= ' ' && c <= '~' ? c : '?';
  return quoted + (text.size() > 40 ? "...\"" : "\"");
}

// The words of a text, and the line on which each is.
class Scanner
{
public:
  explicit Scanner(const std::string& text) : text_(text) {}

  std::size_t line() const { return line_; }
  std::size_t remaining() const { return text_.size() - position_; }

  // Goes to the next word behind comments and line ends; false at the end.
  bool skip_to_word()
  {
    for (; position_ < text_.size(); ++position_) {
      if (text_[position_] == '#')
        while (position_ + 1 < text_.size() && text_[position_ + 1] != '\n')
          ++position_;
      else if (text_[position_] == '\n')
        ++line_;
      else if (!is_space(text_[position_]))
        return true;
    }
    return false;
  }
  // The next word anywhere, empty at the end of the text.
  std::string word() { return skip_to_word() ? take() : std::string(); }
  // The next word on this line, empty at its end or at a comment.
  std::string word_on_line()
  {
    while (position_ < text_.size() && text_[position_] != '\n' && is_space(text_[position_]))
      ++position_;
    if (position_ == text_.size() || text_[position_] == '\n' || text_[position_] == '#')
      return std::string();
    return take();
  }
  void skip_line()
  {
    while (position_ < text_.size() && text_[position_] != '\n')
      ++position_;
  }

private:
  static bool is_space(const char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  std::string take()
  {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_space(text_[position_]))
      ++position_;
    return text_.substr(begin, position_ - begin);
  }

  const std::string& text_;
  std::size_t position_ = 0;
  std::size_t line_ = 1;
};

enum class Number_state {
  GOOD,
  NOT_FINITE,
  TOO_LARGE,
  NOT_A_NUMBER
};

Number_state read_number(const std::string& word, double& number)
{
  const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  const std::from_chars_result result = std::from_chars(begin, word.data() + word.size(), number);
  if (result.ptr != word.data() + word.size() || result.ec == std::errc::invalid_argument)
    return Number_state::NOT_A_NUMBER;
  if (result.ec == std::errc::result_out_of_range) {
    // Too large or too small: the exponent tells.
    const std::size_t e = word.find_first_of("eE");
    return e != std::string::npos && word[e + 1] == '-' ? Number_state::GOOD : Number_state::TOO_LARGE;
  }
  return std::isfinite(number) ? Number_state::GOOD : Number_state::NOT_FINITE;
}

bool read_integer(const std::string& word, long long& number)
{
  const std::from_chars_result result = std::from_chars(word.data(), word.data() + word.size(), number);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

// "line 7 (vertex 3)"
std::string place(const Scanner& scanner, const char* const kind, const std::size_t element)
{
  return "line " + std::to_string(scanner.line()) + " (" + kind + " " + std::to_string(element) + ")";
}

// The coordinate that a word is; refuses the word if it is none.
double check_coordinate(const std::string& path, const std::string& word, const std::string& where,
                        const std::size_t vertex)
{
  double number = 0;
  switch (read_number(word, number)) {
  case Number_state::GOOD:
    return number;
  case Number_state::NOT_FINITE:
    refuse(path, where + ": the coordinate " + quote(word) + " is not finite", Defect::NOT_FINITE, vertex);
  case Number_state::TOO_LARGE:
    refuse(path, where + ": the coordinate " + quote(word) + " is too large for a double",
           Defect::OUT_OF_RANGE, vertex);
  case Number_state::NOT_A_NUMBER:
    break;
  }
  refuse(path, where + ": " + quote(word) + " is not a number", Defect::UNREADABLE, vertex);
}

// ---- OFF -------------------------------------------------------------------

struct Off_header
{
  bool is_plain;       // no normals, colors, textures or fourth coordinate
  bool is_homogeneous; // a fourth coordinate, by which the three are divided
  std::size_t numbers_per_vertex;
  std::size_t vertices;
  std::size_t faces;
};

// Reads the header as CGAL does, and compares it with the size of the file.
Off_header read_off_header(const std::string& path, Scanner& scanner, const std::uintmax_t file_size)
{
  const std::string first = scanner.word();
  if (first.empty())
    refuse(path, "there is nothing but white space and comments in the file");
  std::string keyword = first;
  std::size_t numbers = 3;
  std::size_t homogeneous = 0, pairs = 0, normals = 0;
  if (keyword.compare(0, 2, "ST") == 0) {
    keyword.erase(0, 2);
    pairs = 1;
  }
  if (keyword.compare(0, 1, "C") == 0)
    keyword.erase(0, 1);
  if (keyword.compare(0, 1, "N") == 0) {
    keyword.erase(0, 1);
    normals = 1;
  }
  if (keyword.compare(0, 1, "4") == 0) {
    keyword.erase(0, 1);
    homogeneous = 1;
  }
  if (keyword != "OFF")
    refuse(path, "line " + std::to_string(scanner.line()) + ": the file begins with " + quote(first) +
                   " where OFF is expected");
  numbers += homogeneous + normals * (3 + homogeneous) + pairs * (2 + homogeneous);

  long long sizes[3]; // vertices, faces, edges
  static const char* const names[3] = {"vertices", "faces", "edges"};
  for (int i = 0; i < 3; ++i) {
    const std::string word = scanner.word();
    if (i == 0 && word == "BINARY")
      refuse(path, "binary OFF is not read: write the file as text, or as PLY");
    if (word.empty())
      refuse(path, std::string("the file ends before the number of ") + names[i]);
    if (!read_integer(word, sizes[i]) || sizes[i] < 0)
      refuse(path, "line " + std::to_string(scanner.line()) + ": " + quote(word) + " is not a number of " +
                     names[i] + " (the header is OFF, then the numbers of vertices, faces and edges)");
  }
  // A vertex takes at least "0 0 0" and a line end, a face at least "0" and one.
  const std::uintmax_t vertices = static_cast<std::uintmax_t>(sizes[0]);
  const std::uintmax_t faces = static_cast<std::uintmax_t>(sizes[1]);
  if (vertices > file_size / 6 + 1 || faces > file_size / 2 + 1)
    refuse(path, "the header announces " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                   " faces, more than fit into the " + std::to_string(file_size) + " bytes of the file");
  return Off_header{first == "OFF", homogeneous == 1, numbers, static_cast<std::size_t>(vertices),
                    static_cast<std::size_t>(faces)};
}

// Goes through a text line by line and refuses the first line that is not as
// it should be; returns if there is none.
void diagnose_off(const std::string& path, const std::string& text)
{
  Scanner scanner(text);
  const Off_header header = read_off_header(path, scanner, text.size());
  scanner.skip_line();
  if (header.faces == 0)
    refuse(path, "there is no face (" + std::to_string(header.vertices) + " vertices)", Defect::EMPTY);
  for (std::size_t v = 0; v < header.vertices; ++v) {
    if (!scanner.skip_to_word())
      refuse(path,
             "the file ends after " + std::to_string(v) + " of " + std::to_string(header.vertices) +
               " vertices",
             Defect::UNREADABLE, v);
    for (std::size_t i = 0; i < header.numbers_per_vertex; ++i) {
      const std::string word = scanner.word_on_line();
      if (word.empty())
        refuse(path,
               place(scanner, "vertex", v) + ": there are " + std::to_string(i) + " numbers where " +
                 std::to_string(header.numbers_per_vertex) + " are needed",
               Defect::UNREADABLE, v);
      const double number = check_coordinate(path, word, place(scanner, "vertex", v), v);
      if (i == 3 && header.is_homogeneous && number == 0)
        refuse(path, place(scanner, "vertex", v) + ": the fourth coordinate is zero", Defect::NOT_FINITE, v);
    }
    scanner.skip_line();
  }
  // Bad indices are counted to the end of the file, anything else ends the count.
  std::string first_bad_index;
  std::size_t first_bad_face = 0, bad_faces = 0;
  for (std::size_t f = 0; f < header.faces; ++f) {
    std::string trouble;
    long long size = 0;
    if (!scanner.skip_to_word())
      trouble = "the file ends after " + std::to_string(f) + " of " + std::to_string(header.faces) + " faces";
    else {
      const std::string word = scanner.word_on_line();
      if (!read_integer(word, size) || size < 0)
        trouble = place(scanner, "face", f) + ": " + quote(word) + " is not a number of corners";
    }
    bool is_bad = false;
    for (long long i = 0; i < size && trouble.empty(); ++i) {
      const std::string word = scanner.word_on_line();
      long long index = 0;
      if (word.empty())
        trouble = place(scanner, "face", f) + ": there are " + std::to_string(i) + " vertices where " +
                  std::to_string(size) + " are announced";
      else if (!read_integer(word, index))
        trouble = place(scanner, "face", f) + ": " + quote(word) + " is not the index of a vertex";
      else if (index < 0 || index >= static_cast<long long>(header.vertices)) {
        is_bad = true;
        if (first_bad_index.empty()) {
          first_bad_face = f;
          first_bad_index = place(scanner, "face", f) + ": the face names vertex " + word + ", but there are " +
                            std::to_string(header.vertices) + " vertices (counted from 0)";
        }
      }
    }
    bad_faces += is_bad;
    if (!trouble.empty() && bad_faces == 0)
      refuse(path, trouble, Defect::UNREADABLE, f);
    if (!trouble.empty())
      break;
    scanner.skip_line();
  }
  if (bad_faces > 1)
    first_bad_index += ", and " + std::to_string(bad_faces - 1) +
                       (bad_faces == 2 ? " more face like it" : " more faces like it");
  if (bad_faces != 0)
    refuse(path, first_bad_index, Defect::BAD_INDEX, first_bad_face, bad_faces);
}

// The same surface with nothing but coordinates and indices. CGAL 5.5 reads colors and textures
// beyond the end of a line that has fewer numbers than it expects, and colors by an index beyond
// the end of its table. \pre diagnose_off() has found nothing
std::string without_attributes(const std::string& path, const std::string& text)
{
  Scanner scanner(text);
  const Off_header header = read_off_header(path, scanner, text.size());
  scanner.skip_line();
  std::string result = (header.is_homogeneous ? "4OFF\n" : "OFF\n") + std::to_string(header.vertices) + ' ' +
                       std::to_string(header.faces) + " 0\n";
  const auto copy_words = [&](const std::size_t number) {
    for (std::size_t i = 0; i < number; ++i)
      result += scanner.word_on_line() + ' ';
    scanner.skip_line();
    result += '\n';
  };
  for (std::size_t v = 0; v < header.vertices; ++v) {
    scanner.skip_to_word();
    copy_words(header.is_homogeneous ? 4 : 3);
  }
  for (std::size_t f = 0; f < header.faces; ++f) {
    scanner.skip_to_word();
    const std::string word = scanner.word_on_line();
    long long size = 0;
    read_integer(word, size);
    result += word + ' ';
    copy_words(static_cast<std::size_t>(size));
  }
  return result;
}

// What CGAL's reader would trust: the announced sizes, and the number of
// entries of a vertex with normals, colors or textures.
// \return what is to be read in place of a file that has such attributes
std::optional<std::string> check_off(const std::string& path, const std::uintmax_t file_size)
{
  const std::string head = load(path, 1 << 16);
  Scanner probe(head);
  std::string whole;
  // A header longer than the first part of the file is one of long comments.
  int words = 0;
  while (words < 5 && !probe.word().empty())
    ++words;
  const bool is_complete = words == 5 || head.size() == file_size;
  if (!is_complete)
    whole = load(path);
  const std::string& text = is_complete ? head : whole;
  Scanner scanner(text);
  if (read_off_header(path, scanner, file_size).is_plain)
    return std::nullopt;
  if (is_complete)
    whole = load(path);
  diagnose_off(path, whole);
  return without_attributes(path, whole);
}

// ---- PLY -------------------------------------------------------------------

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

// ---- STL -------------------------------------------------------------------

bool is_text_stl(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\n\v\f\r");
  return begin != std::string::npos && text.compare(begin, 5, "solid") == 0 && begin + 5 < text.size() &&
         (text[begin + 5] == ' ' || text[begin + 5] == '\n' || text[begin + 5] == '\r');
}

// Goes through a text word by word and refuses the first facet that is not as
// it should be; returns if there is none, or if the file is not text.
void diagnose_stl(const std::string& path, const std::string& text)
{
  if (!is_text_stl(text))
    return;
  Scanner scanner(text);
  std::size_t facet = 0, corners = 0;
  bool is_in_facet = false, is_ended = false;
  for (std::string word = scanner.word(); !word.empty(); word = scanner.word()) {
    is_ended = is_ended || word == "endsolid";
    if (word == "facet") {
      is_in_facet = true;
      corners = 0;
    } else if (word == "endfacet" || (word == "vertex" && corners == 3)) {
      if (word == "vertex" || corners != 3)
        refuse(path, place(scanner, "facet", facet) + ": the facet does not have three vertices",
               Defect::NOT_A_TRIANGLE, facet);
      is_in_facet = false;
      ++facet;
    } else if (word == "vertex" && is_in_facet) {
      ++corners;
      for (int i = 0; i < 3; ++i) {
        const std::string coordinate = scanner.word_on_line();
        if (coordinate.empty())
          refuse(path,
                 place(scanner, "facet", facet) + ": a vertex has " + std::to_string(i) +
                   " numbers where 3 are needed",
                 Defect::UNREADABLE, facet);
        check_coordinate(path, coordinate, place(scanner, "facet", facet), facet);
      }
    }
  }
  if (is_in_facet || !is_ended)
    refuse(path,
           "the file ends " + std::string(is_in_facet ? "within" : "after") + " facet " +
             std::to_string(facet - (is_in_facet || facet == 0 ? 0 : 1)) + ", without a line endsolid",
           Defect::UNREADABLE, facet);
}

// What CGAL's reader would trust: that the first word tells text from binary,
// that the number of facets is right, and that the coordinates can be compared.
void check_stl(const std::string& path, const std::uintmax_t file_size)
{
  const std::string head = load(path, 4096);
  std::uint32_t facets = 0;
  if (head.size() >= 84)
    std::memcpy(&facets, &head[80], 4);
  const bool may_be_text = is_text_stl(head);
  if (head.size() < 84 || file_size < 84 + std::uintmax_t(50) * facets) {
    if (may_be_text) {
      // The reader takes any file as empty that is shorter than a binary header.
      if (head.size() < 84)
        diagnose_stl(path, head);
      return;
    }
    refuse(path, "neither text STL (the first word is not solid) nor binary STL (" +
                   (head.size() < 84
                      ? std::string("shorter than the header of 84 bytes")
                      : "the header announces " + std::to_string(facets) + " facets, the file has room for " +
                          std::to_string((file_size - 84) / 50)) +
                   ")");
  }
  const std::string text = load(path);
  for (std::size_t f = 0; f < facets; ++f) {
    float corner[9];
    std::memcpy(corner, &text[84 + 50 * f + 12], sizeof(corner));
    for (const float c : corner)
      if (!std::isfinite(c))
        refuse(path, "facet " + std::to_string(f) + ": a coordinate is not finite", Defect::NOT_FINITE, f);
  }
}

// ---- OBJ, PLY and TS ---------------------------------------------------------

bool has_tab(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  std::vector<char> buffer(1 << 16);
  do {
    in.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    if (std::memchr(buffer.data(), '\t', static_cast<std::size_t>(in.gcount())) != nullptr)
      return true;
  } while (in);
  return false;
}

// The text of a file as the library's reader needs it: its OBJ reader loses
// the corners of a face that stand behind a tab.
std::string load_for_reader(const std::string& path, const std::string& extension)
{
  std::string text = load(path);
  if (extension == "obj")
    std::replace(text.begin(), text.end(), '\t', ' ');
  return text;
}

// Lets the library's reader try once more, on a stream that tells where it stopped.
void diagnose_by_position(const std::string& path, const std::string& extension)
{
  const std::string text = load_for_reader(path, extension);
  std::istringstream in(text);
  CGAL::IO::set_mode(in, extension == "ply" ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  Points points;
  Polygons polygons;
  const auto quiet = CGAL::parameters::verbose(false);
  if (extension == "obj")
    CGAL::IO::read_OBJ(in, points, polygons, quiet);
  else if (extension == "ply")
    CGAL::IO::read_PLY(in, points, polygons, quiet);
  else
    CGAL::IO::read_GOCAD(in, points, polygons, quiet);
  in.clear();
  const std::streamoff told = in.tellg();
  const std::size_t position = told < 0 ? text.size() : static_cast<std::size_t>(told);
  const bool is_at_end = text.find_first_not_of(" \t\n\v\f\r", position) == std::string::npos;
  const std::string so_far =
    std::to_string(points.size()) + " vertices and " + std::to_string(polygons.size()) + " faces";

  if (extension == "ply") {
    // Numbers follow each other: the reader is at the one that it did not like.
    if (is_at_end)
      refuse(path, "the file ends too early, after " + so_far);
    const bool is_text = text.find("\nformat ascii") < position;
    std::istringstream rest(text.substr(position, 200));
    std::string word;
    rest >> word;
    if (!is_text)
      refuse(path, "the binary data cannot be read after " + so_far);
    // The line of that word: it may be behind white space.
    const std::size_t begin = text.find_first_not_of(" \t\n\v\f\r", position);
    const std::string where =
      "line " +
      std::to_string(1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    check_coordinate(path, word, where + " (after " + so_far + ")", points.size());
    refuse(path, where + ": " + quote(word) + " cannot be read (after " + so_far + ")");
  }

  // These are read line by line: the reader is behind the one that it did not
  // like, or at the end with something missing.
  const std::size_t end_of_line = position > 0 && text[position - 1] == '\n' ? position - 1 : position;
  const std::size_t line_begin = end_of_line == 0 ? 0 : text.rfind('\n', end_of_line - 1) + 1;
  std::string line = text.substr(line_begin, end_of_line - line_begin);
  while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
    line.pop_back();
  const std::string where =
    "line " + std::to_string(
                1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  if (!is_at_end || line.compare(0, 2, "v ") == 0 || line.compare(0, 4, "VRTX") == 0) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    const bool is_vertex = word == "v" || word.find("VRTX") != std::string::npos;
    if (word.find("VRTX") != std::string::npos)
      words >> word;
    const std::string vertex = where + " (vertex " + std::to_string(points.size()) + ")";
    for (int i = 0; is_vertex && i < 3; ++i) {
      if (!(words >> word)) {
        if (!is_at_end)
          refuse(path, vertex + ": there are " + std::to_string(i) + " numbers where 3 are needed",
                 Defect::UNREADABLE, points.size());
        break;
      }
      check_coordinate(path, word, vertex, points.size());
    }
    if (!is_at_end)
      refuse(path, where + ": " + quote(line) + " is not understood (after " + so_far + ")");
  }
  if (polygons.empty() || points.empty())
    refuse(path,
           "there is " + std::string(points.empty() ? "no vertex" : "no face") + " in the file (" + so_far +
             ")",
           Defect::EMPTY);
  std::size_t first = 0, count = 0;
  std::uint32_t index = 0;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (const std::uint32_t corner : polygons[f])
      if (corner >= points.size()) {
        if (count++ == 0) {
          first = f;
          index = corner;
        }
        break;
      }
  if (count != 0)
    refuse(path,
           "face " + std::to_string(first) + " names vertex " +
             (index > 0x7fffffffu ? "-" + std::to_string(0x100000000ull - index) : std::to_string(index)) +
             " (counted from 0), but there are " + std::to_string(points.size()) + " vertices" +
             (count == 1 ? ""
                         : ", and " + std::to_string(count - 1) +
                             (count == 2 ? " more face like it" : " more faces like it")),
           Defect::BAD_INDEX, first, count);
  if (extension == "ts")
    refuse(path, "the file has no line END, or not as many as it has parts");
}

// ---- all of them -------------------------------------------------------------

bool read_soup(const std::string& path, const std::string& extension, const std::optional<std::string>& plain_off,
               Points& points, Polygons& polygons)
{
  if (plain_off) {
    std::istringstream in(*plain_off);
    return CGAL::IO::read_OFF(in, points, polygons, CGAL::parameters::verbose(false));
  }
#ifdef CGAL_USE_VTK
  // read_polygon_soup() of CGAL 5.5 does not know the extension.
  if (extension == "vtp")
    return CGAL::IO::read_VTP(path, points, polygons);
#endif
  if (extension == "obj" && has_tab(path)) {
    std::istringstream in(load_for_reader(path, extension));
    return CGAL::IO::read_OBJ(in, points, polygons, CGAL::parameters::verbose(false));
  }
  return CGAL::IO::read_polygon_soup(path, points, polygons, CGAL::parameters::verbose(false));
}

// The extension in lower case, once it is clear that the file can be opened.
std::string check_file(const std::string& path, std::uintmax_t& size)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    refuse(path, "there is no such file");
  if (fs::is_directory(status))
    refuse(path, "this is a directory, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse(path, "this is not a regular file");
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
    refuse(path, std::string("the file cannot be opened") +
                   (errno == 0 ? "" : std::string(" (") + std::strerror(errno) + ")"));
  size = fs::file_size(path, error);
  if (error)
    refuse(path, "the file cannot be read (" + error.message() + ")");

  static const std::string known = "known are .off, .obj, .ply, .stl, .ts"
#ifdef CGAL_USE_VTK
                                   ", .vtp"
#endif
    ;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos)
    refuse(path, "the name has no extension that tells the format (" + known + ")");
  const std::string extension = lower_case(name.substr(dot + 1));
#ifndef CGAL_USE_VTK
  if (extension == "vtp")
    refuse(path, "VTP files can be read only if the command is built with VTK (" + known + ")");
#else
  if (extension != "vtp")
#endif
  if (extension != "off" && extension != "obj" && extension != "ply" && extension != "stl" && extension != "ts")
    refuse(path, "the extension " + quote("." + extension) + " is not known (" + known + ")");
  if (size == 0)
    refuse(path, "the file is empty");
  return extension;
}

} // namespace

Surface_input read_surface(const std::string& path)
{
  std::uintmax_t size = 0;
  const std::string extension = check_file(path, size);
  Points points;
  Polygons polygons;
  try {
    std::optional<std::string> plain_off;
    if (extension == "off")
      plain_off = check_off(path, size);
    else if (extension == "ply")
      check_ply(path);
    else if (extension == "stl")
      check_stl(path, size);

    bool is_read = false;
    std::string reason;
    try {
      is_read = read_soup(path, extension, plain_off, points, polygons);
    } catch (const std::length_error& error) {
      reason = std::string(": ") + error.what();
    }
    if (!is_read) {
      const std::size_t vertices = points.size(), faces = polygons.size();
      Points().swap(points);
      Polygons().swap(polygons);
      if (extension == "off")
        diagnose_off(path, load(path));
      else if (extension == "stl")
        diagnose_stl(path, load(path));
      else if (extension != "vtp" && reason.empty())
        diagnose_by_position(path, extension);
      refuse(path, "the file cannot be read" + reason +
                     (extension == "off" ? std::string()
                                         : " (stopped after " + std::to_string(vertices) + " vertices and " +
                                             std::to_string(faces) + " faces)"));
    }
  } catch (const Invalid_surface_error&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse(path, "there is not enough memory for this file");
  } catch (const std::exception& error) {
    refuse(path, std::string("the file cannot be read: ") + error.what());
  }

  Surface_input input;
  input.path = path;
  input.points.reserve(points.size());
  for (const Point& p : points)
    input.points.push_back({{p.x(), p.y(), p.z()}});
  const bool is_triangulated = std::all_of(polygons.begin(), polygons.end(),
                                           [](const Corners& c) { return c.size() == 3; });
  if (is_triangulated) {
    input.triangles.reserve(polygons.size());
    for (const Corners& c : polygons)
      input.triangles.push_back({{c[0], c[1], c[2]}});
    return input;
  }
  input.first_corner.reserve(polygons.size() + 1);
  input.first_corner.push_back(0);
  for (const Corners& c : polygons) {
    input.corners.insert(input.corners.end(), c.begin(), c.end());
    input.first_corner.push_back(input.corners.size());
  }
  return input;
}

CGAL::Intrinsic_triangulations::Surface_report examine(const Surface_input& input)
{
  if (input.is_triangulated())
    return CGAL::Intrinsic_triangulations::examine_polygons(input.points, input.triangles);
  std::vector<Surface_input::Polygon> polygons;
  polygons.reserve(input.number_of_faces());
  for (std::size_t f = 0; f < input.number_of_faces(); ++f)
    polygons.push_back(input.polygon(f));
  return CGAL::Intrinsic_triangulations::examine_polygons(input.points, polygons);
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The faces in a file, by the simplest reading of each format, without the package's readers. Files not in the format
// are recognized by rows that do not fit, and by left-over text.

#ifndef IDT_TEST_FACES_OF_FILE_H
#define IDT_TEST_FACES_OF_FILE_H

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace faces_of_file {

using Point = std::array<double, 3>;
using Faces = std::vector<std::vector<Point>>; // the places of their corners
using Row = std::vector<std::string>;

// The file violates its format.
struct Damage : std::runtime_error
{
  using std::runtime_error::runtime_error;
};
inline void expect(bool condition, const char* what)
{
  if (!condition)
    throw Damage(what);
}

inline std::string lower(std::string text)
{
  for (char& c : text)
    c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return text;
}
inline double real(const std::string& word)
{
  char* end = nullptr;
  const double x = std::strtod(word.c_str(), &end);
  expect(!word.empty() && *end == 0, "a number is none");
  return x;
}
inline long long integer(const std::string& word)
{
  const double x = real(word);
  expect(x == std::floor(x) && std::abs(x) < 1e15, "an integer is none");
  return (long long)(x);
}
inline Point point(const Row& row, std::size_t first)
{
  expect(row.size() >= first + 3, "a vertex has too few numbers");
  return {real(row[first]), real(row[first + 1]), real(row[first + 2])};
}

// Lines that have words; comments begin with a mark.
inline std::vector<Row> rows(std::string text, char comment)
{
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0)
    text.erase(0, 3);
  if (text.find('\n') == std::string::npos)
    std::replace(text.begin(), text.end(), '\r', '\n');
  std::vector<Row> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (comment != 0) {
      const std::size_t begin = (std::min)(line.find(comment), line.size());
      for (std::size_t end = begin; (end = line.find('\r', end)) != std::string::npos; ++end) {
        std::istringstream rest(line.substr(end, line.find('\r', end + 1) - end));
        const Row row{std::istream_iterator<std::string>(rest), {}};
        const auto is_number = [](const std::string& word) { return word.find_first_of("0123456789-") == 0; };
        for (const char* const element : {"v", "f", "trgl", "vrtx", "pvrtx"})
          expect(row.size() < 2 || lower(row[0]) != element || !is_number(row[1]), "a comment has two ends");
        expect(row.empty() || !std::all_of(row.begin(), row.end(), is_number), "a comment has two ends");
      }
      line.resize(begin);
    }
    std::istringstream words(line);
    Row row;
    for (std::string word; words >> word;)
      row.push_back(word);
    if (!row.empty())
      result.push_back(row);
  }
  return result;
}

// Points that are not there are infinite.
class Collector
{
public:
  void add_point(const Point& p) { points_.push_back(p); }
  std::size_t number_of_points() const { return points_.size(); }
  void add_face(const std::vector<long long>& corners) { faces_.push_back(corners); }
  Faces faces() const
  {
    Faces result;
    for (const auto& face : faces_) {
      result.emplace_back();
      for (const long long v : face)
        result.back().push_back(v >= 0 && v < (long long)(points_.size()) ? points_[std::size_t(v)]
                                                                          : Point{HUGE_VAL, HUGE_VAL, HUGE_VAL});
    }
    return result;
  }

private:
  std::vector<Point> points_;
  std::vector<std::vector<long long>> faces_;
};

inline Faces of_soup(const CGAL::Intrinsic_triangulations::Polygon_soup& soup)
{
  Collector result;
  for (const Point& p : soup.points)
    result.add_point(p);
  for (std::size_t f = 0; f < soup.number_of_faces(); ++f) {
    const auto polygon = soup.polygon(f);
    result.add_face(std::vector<long long>(polygon.begin(), polygon.end()));
  }
  return result.faces();
}

// All rows after the vertices are faces, whatever number is announced.
inline Faces of_off(const std::string& text)
{
  std::vector<Row> all = rows(text, '#');
  expect(!all.empty(), "nothing there");
  std::string keyword = all[0][0];
  const std::size_t at = lower(keyword).find("off");
  expect(at != std::string::npos, "no OFF");
  const std::string prefix = keyword.substr(0, at);
  all[0][0] = keyword.substr(at + 3);
  std::vector<std::string> header;
  std::size_t r = 0;
  const std::size_t needed = prefix.find('n') != std::string::npos && keyword.substr(at, 3) == "OFF" ? 4 : 3;
  for (; header.size() < needed; ++r) {
    expect(r < all.size(), "no counts");
    while (!all[r].empty() && header.size() < needed) {
      if (!all[r][0].empty())
        header.push_back(all[r][0]);
      all[r].erase(all[r].begin());
    }
    if (!all[r].empty())
      break;
  }
  const std::size_t vertices = std::size_t(integer(header[needed - 3]));
  Collector result;
  for (; result.number_of_points() < vertices; ++r) {
    expect(r < all.size(), "too few rows");
    Point p = point(all[r], 0);
    if (prefix.find('4') != std::string::npos) {
      expect(all[r].size() > 3, "no fourth coordinate");
      for (double& x : p)
        x /= real(all[r][3]);
    }
    result.add_point(p);
  }
  for (; r < all.size(); ++r) {
    Row row = all[r];
    const std::size_t size = std::size_t(integer(row[0]));
    while (row.size() < size + 1 && ++r < all.size())
      row.insert(row.end(), all[r].begin(), all[r].end());
    expect(row.size() >= size + 1, "a face has too few corners");
    std::vector<long long> face;
    for (std::size_t i = 0; i < size; ++i)
      face.push_back(integer(row[i + 1]));
    result.add_face(face);
  }
  return result.faces();
}

inline Faces of_obj(std::string text)
{
  // Lines that go on.
  for (std::size_t at = 0; (at = text.find('\\', at)) != std::string::npos; ++at) {
    const std::size_t end = text.find_first_not_of(" \t\r", at + 1);
    if (end == std::string::npos || text[end] == '\n')
      text.replace(at, end == std::string::npos ? end : end - at + 1, " ");
  }
  Collector result;
  for (const Row& row : rows(text, '#')) {
    // Named elements, or numbers of other things.
    const std::set<std::string> others = {"parm",   "bmat",   "g",      "o",          "usemtl",
                                          "mtllib", "usemap", "maplib", "shadow_obj", "trace_obj"};
    for (std::size_t i = 1; i + 3 < row.size() && others.count(lower(row[0])) == 0; ++i)
      expect((lower(row[i]) != "f" && lower(row[i]) != "v") ||
               !std::all_of(row.begin() + std::ptrdiff_t(i) + 1, row.begin() + std::ptrdiff_t(i) + 4,
                            [](const auto& word) { return word.find_first_of("0123456789-") == 0; }),
             "a vertex or face is within another element");
    if (lower(row[0]) == "v")
      result.add_point(point(row, 1));
    else if (lower(row[0]) == "f") {
      std::vector<long long> face;
      for (std::size_t i = 1; i < row.size(); ++i) {
        const long long v = integer(row[i].substr(0, row[i].find('/')));
        face.push_back(v < 0 ? v + (long long)(result.number_of_points()) : v - 1);
      }
      result.add_face(face);
    }
  }
  return result.faces();
}

inline Faces of_ts(const std::string& text)
{
  Collector result;
  std::map<std::string, long long> names; // of the vertices of a part
  std::vector<Row> triangles;
  bool is_other = false; // the part is not a surface
  const auto end_part = [&] {
    for (const Row& row : triangles) {
      std::vector<long long> face;
      for (std::size_t i = 1; i < 4; ++i) {
        const auto it = names.find(std::to_string(integer(i < row.size() ? row[i] : "")));
        expect(it != names.end(), "no such vertex");
        face.push_back(it->second);
      }
      result.add_face(face);
    }
    triangles.clear();
    names.clear();
  };
  for (const Row& row : rows(text, '#')) {
    const std::string word = lower(row[0]);
    for (std::size_t i = 1; i + 3 < row.size(); ++i)
      expect(lower(row[i]) != "trgl" ||
               !std::all_of(row.begin() + std::ptrdiff_t(i) + 1, row.begin() + std::ptrdiff_t(i) + 4,
                            [](const auto& x) { return x.find_first_of("0123456789") == 0; }),
             "a triangle begins no line");
    const auto name = [&](std::size_t i) { return std::to_string(integer(i < row.size() ? row[i] : "")); };
    if (word == "gocad" || word == "end") {
      end_part();
      is_other = word == "gocad" && row.size() > 1 && lower(row[1]) != "tsurf";
    } else if (is_other)
      expect(word != "trgl", "a triangle in another part");
    else if (word == "vrtx" || word == "pvrtx") {
      names[name(1)] = (long long)(result.number_of_points());
      result.add_point(point(row, 2));
    } else if (word == "atom" || word == "patom")
      names[name(1)] = names.at(name(2));
    else if (word == "trgl")
      triangles.push_back(row);
  }
  end_part();
  return result.faces();
}

template <class T>
T raw(const std::string& bytes, std::size_t at, bool is_big_endian = false)
{
  expect(at + sizeof(T) <= bytes.size(), "the file is too short");
  std::string piece = bytes.substr(at, sizeof(T));
  if (is_big_endian)
    std::reverse(piece.begin(), piece.end());
  T value;
  std::memcpy(&value, piece.data(), sizeof(T));
  return value;
}

// Every 50 bytes after the header of a binary file are a facet; in a text, every word `vertex` is a corner.
inline Faces of_stl(const std::string& bytes)
{
  Faces result;
  std::string first;
  std::istringstream(bytes.substr(bytes.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0, 4096)) >> first;
  if (lower(first) != "solid" || bytes.substr(0, 4096).find('\0') != std::string::npos) {
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
      result.emplace_back();
      for (std::size_t i = 0; i < 3; ++i)
        result.back().push_back({raw<float>(bytes, at + 12 + 12 * i), raw<float>(bytes, at + 16 + 12 * i),
                                 raw<float>(bytes, at + 20 + 12 * i)});
    }
    return result;
  }
  Row words;
  for (const Row& row : rows(bytes, '#'))
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string word = lower(row[i]);
      words.push_back(word);
      // A name, unless a facet follows.
      if (word == "solid" || word == "endsolid") {
        std::size_t facet = i + 1;
        while (facet + 2 < row.size() &&
               !(lower(row[facet]) == "facet" && lower(row[facet + 1]) == "normal" &&
                 std::strtod(row[facet + 2].c_str(), nullptr) == std::strtod(row[facet + 2].c_str(), nullptr) &&
                 std::string("0123456789+-.").find(row[facet + 2][0]) != std::string::npos))
          expect(lower(row[facet++]) != "endfacet", "a facet has become a name");
        if (facet + 2 >= row.size())
          break;
        i = facet - 1;
      }
    }
  std::size_t facets = 0, ends = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] == "endfacet" || (words[i] == "facet" && i > 0 && words[i - 1] == "end"))
      ++ends;
    else if (words[i] == "facet") {
      ++facets;
      result.emplace_back();
    } else if (words[i] == "vertex") {
      expect(!result.empty(), "a vertex without a facet");
      result.back().push_back(point(words, i + 1));
    }
  }
  expect(facets == ends, "a facet does not end");
  for (const auto& face : result)
    expect(face.size() == 3, "a facet is no triangle");
  return result;
}

struct Ply_property
{
  std::string type, size_type, name;
};
struct Ply_element
{
  std::string name;
  long long count;
  std::vector<Ply_property> properties;
};

inline double ply_number(const std::string& bytes, std::size_t& at, const std::string& type, bool is_big)
{
  const auto take = [&](auto sample) {
    const auto value = raw<decltype(sample)>(bytes, at, is_big);
    at += sizeof(value);
    return double(value);
  };
  static const std::map<std::string, int> types = {
    {"char", 0},   {"int8", 0},    {"uchar", 1},  {"uint8", 1},   {"short", 2}, {"int16", 2},
    {"ushort", 3}, {"uint16", 3},  {"int", 4},    {"int32", 4},   {"uint", 5},  {"uint32", 5},
    {"float", 6},  {"float32", 6}, {"double", 7}, {"float64", 7}, {"int64", 8}, {"uint64", 9}};
  expect(types.count(type) == 1, "no such type");
  switch (types.at(type)) {
  case 0:
    return take(std::int8_t());
  case 1:
    return take(std::uint8_t());
  case 2:
    return take(std::int16_t());
  case 3:
    return take(std::uint16_t());
  case 4:
    return take(std::int32_t());
  case 5:
    return take(std::uint32_t());
  case 6:
    return take(float());
  case 7:
    return take(double());
  case 8:
    return take(std::int64_t());
  default:
    return take(std::uint64_t());
  }
}

// \param next gives the next number, of a type
template <class Next>
void take_ply_element(const Ply_element& element, Collector& result, const Next& next)
{
  Point p{};
  for (const Ply_property& property : element.properties) {
    if (property.size_type.empty()) {
      const double x = next(property.type);
      for (std::size_t i = 0; i < 3; ++i)
        if (property.name == std::string(1, "xyz"[i]))
          p[i] = property.type.compare(0, 5, "float") == 0 && property.type != "float64" ? double(float(x)) : x;
      continue;
    }
    const double size = next(property.size_type);
    expect(size >= 0 && size < 1e7, "a list has a size that is none");
    std::vector<long long> list;
    for (int i = 0; i < int(size); ++i)
      list.push_back((long long)(next(property.type)));
    const bool has_other = std::any_of(element.properties.begin(), element.properties.end(),
                                       [](const Ply_property& other) { return other.name == "vertex_indices"; });
    if (property.name != (has_other ? "vertex_indices" : "vertex_index"))
      continue;
    if (element.name == "face" || element.name == "faces")
      result.add_face(list);
    else if (element.name == "tristrips") {
      std::vector<long long> strip;
      for (const long long v : list)
        if (v == -1)
          strip.clear();
        else {
          strip.push_back(v);
          const std::size_t n = strip.size();
          if (n < 3 || strip[n - 1] == strip[n - 2] || strip[n - 2] == strip[n - 3] || strip[n - 1] == strip[n - 3])
            continue;
          if (n % 2 == 1)
            result.add_face({strip[n - 3], strip[n - 2], strip[n - 1]});
          else
            result.add_face({strip[n - 2], strip[n - 3], strip[n - 1]});
        }
    }
  }
  if (element.name == "vertex" || element.name == "vertices")
    result.add_point(p);
}

// A row of a text is an element, or a part of one; or there is a single row.
inline Faces of_ply(std::string bytes)
{
  if (bytes.compare(0, 3, "\xef\xbb\xbf") == 0)
    bytes.erase(0, 3);
  const std::size_t first_end = bytes.find_first_of("\r\n");
  const char line_end =
    first_end != std::string::npos && bytes[first_end] == '\r' && bytes.substr(first_end, 2) != "\r\n" ? '\r' : '\n';
  std::vector<Ply_element> elements;
  std::string format;
  std::size_t at = 0;
  for (bool is_ended = false; !is_ended;) {
    const std::size_t end = bytes.find(line_end, at);
    std::istringstream line(lower(bytes.substr(at, end == std::string::npos ? end : end - at)));
    at = end == std::string::npos ? bytes.size() : end + 1;
    std::string word;
    line >> word;
    if (word == "format")
      line >> format;
    else if (word == "element") {
      elements.push_back({});
      line >> elements.back().name >> elements.back().count;
    } else if (word == "property") {
      Ply_property property;
      line >> property.type;
      if (property.type == "list")
        line >> property.size_type >> property.type;
      line >> property.name;
      expect(!elements.empty(), "a property of nothing");
      elements.back().properties.push_back(property);
    }
    is_ended = word == "end_header";
    expect(is_ended || at < bytes.size(), "the header does not end");
  }
  Collector result;
  if (format != "ascii") {
    for (const Ply_element& element : elements)
      for (long long i = 0; i < element.count; ++i)
        take_ply_element(element, result, [&](const std::string& type) {
          return ply_number(bytes, at, type, format == "binary_big_endian");
        });
    expect(bytes.find_first_not_of(std::string(" \t\r\n\0\v\f", 7), at) == std::string::npos, "bytes are left over");
    return result.faces();
  }
  std::string body = bytes.substr(at);
  std::replace(body.begin(), body.end(), line_end, '\n');
  const std::vector<Row> all = rows(body, 0);
  std::size_t r = 0, i = 0;
  for (const Ply_element& element : elements)
    for (long long e = 0; e < element.count; ++e) {
      expect(i == 0 || all.size() == 1, "a row is longer than its element");
      take_ply_element(element, result, [&](const std::string&) {
        expect(r < all.size(), "rows are missing");
        const double x = real(all[r][i]);
        if (++i == all[r].size()) {
          ++r;
          i = 0;
        }
        return x;
      });
    }
  expect(r == all.size(), "rows are left over");
  return result.faces();
}

// \exception Damage if the file has no recognizable faces
inline Faces of(const std::string& extension, const std::string& bytes)
{
  return extension == "off"   ? of_off(bytes)
         : extension == "obj" ? of_obj(bytes)
         : extension == "ply" ? of_ply(bytes)
         : extension == "stl" ? of_stl(bytes)
                              : of_ts(bytes);
}

// The defect of the contents, or empty.
inline std::string difference(const std::string& extension, const std::string& bytes,
                              const CGAL::Intrinsic_triangulations::Polygon_soup& soup)
{
  Faces expected;
  try {
    expected = of(extension, bytes);
  } catch (const std::exception& damage) {
    return std::string("a damaged file was read: ") + damage.what();
  }
  const Faces found = of_soup(soup);
  if (found.size() != expected.size())
    return std::to_string(found.size()) + " faces were read where there are " + std::to_string(expected.size());
  for (std::size_t f = 0; f < found.size(); ++f) {
    if (found[f].size() != expected[f].size())
      return "face " + std::to_string(f) + " has another number of corners";
    for (std::size_t i = 0; i < found[f].size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        if (found[f][i][k] != expected[f][i][k] && !(std::isnan(found[f][i][k]) && std::isnan(expected[f][i][k])))
          return "corner " + std::to_string(i) + " of face " + std::to_string(f) + " is another one";
  }
  return std::string();
}

} // namespace faces_of_file

#endif // IDT_TEST_FACES_OF_FILE_H

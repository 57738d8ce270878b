// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// PLY, text or binary: elements with properties, of which coordinates and corners are read and the others skipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/File_blocks.h>
#include <CGAL/Intrinsic_triangulations/internal/files/Ply_header.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/reserve.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A property as the loops want it.
struct Ply_layout
{
  enum Role : std::size_t {
    X,
    Y,
    Z,
    CORNERS,
    NONE
  };

  // The smallest and the largest integer of a type.
  struct Range
  {
    explicit Range(const std::string& type)
      : least(is_signed(type) ? -(1LL << (8 * ply_type_size(type) - 1)) : 0),
        greatest((1LL << (8 * ply_type_size(type) - is_signed(type))) - 1)
    {
    }
    long long least, greatest;
  };

  Ply_layout(const Ply_element& element, const Ply_property& property)
    : size(ply_type_size(property.type)), size_of_count(ply_type_size(property.size_type)),
      is_real(internal::is_real(property.type)),
      range(is_real ? "char" : property.type), range_of_count(is_list() ? property.size_type : "char"), role(NONE)
  {
    static constexpr const char* names[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < 3; ++i)
      if (element.is_vertex() && element.find(names[i]) == &property)
        role = static_cast<Role>(i);
    if (element.is_face() && element.find_corners() == &property)
      role = CORNERS;
  }

  static std::vector<Ply_layout> of(const Ply_element& element)
  {
    std::vector<Ply_layout> result;
    for (const Ply_property& property : element.properties)
      result.emplace_back(element, property);
    return result;
  }

  bool is_list() const { return size_of_count != 0; }

  std::size_t size;          // of a number in bytes
  std::size_t size_of_count; // of the number of entries, 0 if it is no list
  bool is_real;
  Range range, range_of_count; // of an integer
  Role role;
};

// A file of that many bytes has no more triangles, in text or not.
inline void reserve_ply(const Ply_element& element, const std::uintmax_t bytes, Polygon_soup& soup)
{
  if (element.is_vertex())
    reserve(soup.points, element.count);
  if (element.is_face())
    reserve(soup.triangles, (std::min<std::uintmax_t>)(element.count, bytes / 8 + 1));
}

template <bool is_big_endian>
class Ply_binary_reader
{
public:
  Ply_binary_reader(const std::string& path, const Ply_header& header, Polygon_soup& soup, File_blocks& file)
    : path_(path), header_(header), soup_(soup), file_(file)
  {
  }

  void read()
  {
    for (const Ply_element& element : header_.elements) {
      reserve_ply(element, file_.left(), soup_);
      const std::vector<Ply_layout> layout = Ply_layout::of(element);
      const bool has_lists = std::any_of(layout.begin(), layout.end(), [](const Ply_layout& l) { return l.is_list(); });
      std::size_t done = 0;
      if (element.is_vertex() && !has_lists)
        done = take_vertices(element, layout);
      for (; done < element.count; ++done) {
        if (layout.size() == 1 && layout[0].size_of_count == 1 && layout[0].role == Ply_layout::CORNERS)
          done += take_triangles(element.count - done);
        if (done < element.count)
          take_element(element, layout, done);
      }
    }
  }

private:
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
  static constexpr bool is_host_big_endian = true;
#else
  static constexpr bool is_host_big_endian = false;
#endif

  template <class T>
  static T load(const char* const p)
  {
    char bytes[sizeof(T)];
    std::memcpy(bytes, p, sizeof(T));
    if constexpr (is_big_endian != is_host_big_endian)
      std::reverse(bytes, bytes + sizeof(T));
    T result;
    std::memcpy(&result, bytes, sizeof(T));
    return result;
  }
  static double load_real(const char* const p, const std::size_t size)
  {
    return size == 8 ? load<double>(p) : static_cast<double>(load<float>(p));
  }

  // Each has the same number of bytes. Returns how many there are before the end of the file.
  std::size_t take_vertices(const Ply_element& element, const std::vector<Ply_layout>& layout)
  {
    std::size_t stride = 0;
    std::array<std::size_t, 3> offset{}, size{};
    for (const Ply_layout& l : layout) {
      if (l.role < 3) {
        offset[l.role] = stride;
        size[l.role] = l.size;
      }
      stride += l.size;
    }
    const auto take = [&](const std::size_t n, auto real) {
      using Real = decltype(real);
      const char* p = file_.first;
      for (std::size_t i = 0; i < n; ++i, p += stride)
        soup_.points.push_back({load<Real>(p + offset[0]), load<Real>(p + offset[1]), load<Real>(p + offset[2])});
      file_.first = p;
    };
    std::size_t done = 0;
    while (done < element.count && file_.require(stride)) {
      const std::size_t n = (std::min)(element.count - done, file_.available() / stride);
      if (size[0] == 8 && size[1] == 8 && size[2] == 8)
        take(n, double());
      else if (size[0] == 4 && size[1] == 4 && size[2] == 4)
        take(n, float());
      else
        for (std::size_t i = 0; i < n; ++i, file_.first += stride)
          soup_.points.push_back({load_real(file_.first + offset[0], size[0]), load_real(file_.first + offset[1], size[1]),
                                  load_real(file_.first + offset[2], size[2])});
      done += n;
    }
    return done;
  }

  // Faces of nothing but a byte and three indices, as many as come one after the other. Returns their number.
  std::size_t take_triangles(const std::size_t at_most)
  {
    constexpr std::size_t stride = 13;
    std::size_t done = 0;
    while (done < at_most && soup_.is_triangulated() && file_.require(stride)) {
      const std::size_t n = (std::min)(at_most - done, file_.available() / stride);
      const char* p = file_.first;
      std::size_t i = 0;
      for (; i < n && *p == 3; ++i, p += stride)
        soup_.triangles.push_back({load<std::uint32_t>(p + 1), load<std::uint32_t>(p + 5), load<std::uint32_t>(p + 9)});
      file_.first = p;
      done += i;
      if (i < n)
        break;
    }
    return done;
  }

  // The general case. What nobody wants is never in memory as a whole.
  void take_element(const Ply_element& element, const std::vector<Ply_layout>& layout, const std::size_t index)
  {
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < layout.size(); ++k) {
      const Ply_layout& l = layout[k];
      const auto refuse = [&](const std::string& text) {
        refuse_file(path_, "element " + element.name + " " + std::to_string(index) + ": " + text);
      };
      const std::string& name = element.properties[k].name;
      std::uintmax_t count = 1;
      if (l.is_list()) {
        if (!file_.require(l.size_of_count))
          refuse("the file ends within " + name);
        std::uint32_t bits = 0;
        for (std::size_t b = 0; b < l.size_of_count; ++b)
          bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(file_.first[b]))
                  << 8 * (is_big_endian ? l.size_of_count - 1 - b : b);
        file_.first += l.size_of_count;
        if (l.range_of_count.least < 0 && (bits >> (8 * l.size_of_count - 1)) != 0)
          refuse("the list " + name + " claims a negative number of entries");
        if (bits > file_.left())
          refuse("the list " + name + " claims more entries than the file has");
        count = bits;
      }
      const std::uintmax_t bytes = count * l.size;
      if (l.role == Ply_layout::NONE ? !file_.skip(bytes) : bytes > file_.left() || !file_.require(static_cast<std::size_t>(bytes)))
        refuse("the file ends within " + name);
      if (l.role == Ply_layout::NONE)
        continue;
      if (l.role == Ply_layout::CORNERS) {
        corners_.clear();
        for (std::size_t i = 0; i < count; ++i)
          corners_.push_back(load<std::uint32_t>(file_.first + 4 * i));
        soup_.add_face(corners_.data(), corners_.data() + corners_.size());
      } else
        point[l.role] = load_real(file_.first, l.size);
      file_.first += bytes;
    }
    if (element.is_vertex())
      soup_.points.push_back(point);
  }

  std::string path_;
  const Ply_header& header_;
  Polygon_soup& soup_;
  File_blocks& file_;
  std::vector<std::uint32_t> corners_; // of a face
};

// Words in the order of the elements and their properties; lines do not count.
class Ply_text_reader
{
public:
  Ply_text_reader(const std::string& path, const Ply_header& header, Polygon_soup& soup, File_blocks& file)
    : path_(path), header_(header), soup_(soup), file_(file), number_(header.lines), most_entries_(file.left() / 2 + 1)
  {
  }

  void read()
  {
    for (const Ply_element& element : header_.elements) {
      element_ = &element;
      reserve_ply(element, file_.left(), soup_);
      const std::vector<Ply_layout> layout = Ply_layout::of(element);
      for (index_ = 0; index_ < element.count; ++index_)
        take_element(layout);
    }
  }

private:
  void take_element(const std::vector<Ply_layout>& layout)
  {
    std::array<double, 3> point{};
    for (std::size_t k = 0; k < layout.size(); ++k) {
      const Ply_layout& l = layout[k];
      const Ply_property& property = element_->properties[k];
      if (!l.is_list()) {
        const double value = take_value(l, property);
        if (l.role < 3)
          point[l.role] = value;
        continue;
      }
      const long long count = take_integer(l.range_of_count, property.size_type, [&] { return "the size of the list " + property.name; });
      if (count < 0)
        refuse_file(path_, where() + ": the list " + property.name + " claims a negative number of entries");
      // Each entry takes two bytes.
      if (static_cast<std::uintmax_t>(count) > most_entries_)
        refuse_file(path_, where() + ": the list " + property.name + " claims more entries than the file has");
      corners_.clear();
      for (long long i = 0; i < count; ++i)
        if (l.role == Ply_layout::CORNERS)
          corners_.push_back(static_cast<std::uint32_t>(take_integer(l.range, property.type, [&] { return property.name; })));
        else
          take_value(l, property);
      if (l.role == Ply_layout::CORNERS)
        soup_.add_face(corners_.data(), corners_.data() + corners_.size());
    }
    if (element_->is_vertex())
      soup_.points.push_back(point);
  }

  // Goes to the next word.
  void find_word()
  {
    for (;;) {
      for (; file_.first != file_.last && is_white(*file_.first); ++file_.first)
        number_ += *file_.first == '\n';
      if (file_.first != file_.last)
        return;
      if (!file_.take_words())
        refuse_file(path_, "the file ends too early, after " + std::to_string(soup_.points.size()) + " vertices and " +
                             std::to_string(soup_.number_of_faces()) + " faces");
    }
  }
  // Goes over that word.
  std::string take_word()
  {
    const char* const begin = file_.first;
    file_.first = skip_word(begin, file_.last);
    return std::string(begin, file_.first);
  }

  double take_value(const Ply_layout& l, const Ply_property& property)
  {
    if (!l.is_real)
      return static_cast<double>(take_integer(l.range, property.type, [&] { return property.name; }));
    find_word();
    const char* p = file_.first;
    double number = 0;
    if (l.size == 8) {
      if (take_real(p, file_.last, number) && (p == file_.last || *p != '#')) {
        file_.first = p;
        return number;
      }
    } else if (float value = 0; take_real(p, file_.last, value) && (p == file_.last || *p != '#')) {
      file_.first = p;
      return value;
    }
    const std::string word = take_word();
    number = check_coordinate(path_, word, where(), index_);
    if (l.size == 8)
      return number;
    if (std::abs(number) > (std::numeric_limits<float>::max)())
      refuse_file(path_, where() + ": " + property.name + " is of type float, for which " + quote(word) + " is too large",
                  Defect::OUT_OF_RANGE, index_);
    return static_cast<float>(number);
  }

  // \param what says what it is
  template <class What>
  long long take_integer(const Ply_layout::Range& range, const std::string& type, const What& what)
  {
    find_word();
    const char* p = file_.first;
    long long number = 0;
    const std::from_chars_result result = std::from_chars(p, file_.last, number);
    if (result.ec == std::errc() && (result.ptr == file_.last || is_white(*result.ptr)) && number >= range.least &&
        number <= range.greatest) {
      file_.first = result.ptr;
      return number;
    }
    const std::string word = take_word();
    if (!read_integer(word, number) && !is_beyond_integers(word))
      refuse_file(path_, where() + ": " + quote(word) + " is not an integer, which is needed for " + what());
    if (is_beyond_integers(word) || number < range.least || number > range.greatest)
      refuse_file(path_, where() + ": " + quote(word) + " is out of range for " + what() + ", which is of type " + type);
    return number; // with a sign that from_chars() does not take
  }

  std::string where() const
  {
    return "line " + std::to_string(number_) + ", element " + element_->name + " " + std::to_string(index_);
  }

  std::string path_;
  const Ply_header& header_;
  Polygon_soup& soup_;
  File_blocks& file_;
  std::size_t number_; // of the line, counted from 1
  std::uintmax_t most_entries_;
  const Ply_element* element_ = nullptr;
  std::size_t index_ = 0;              // of the element among those of its kind
  std::vector<std::uint32_t> corners_; // of a face
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void read_ply(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  const Ply_header header = read_ply_header(path);
  check_types(path, header.elements);
  check_counts(path, header, size);
  File_blocks file(path, size, header.bytes, progress);
  if (header.format == "ascii")
    Ply_text_reader(path, header, soup, file).read();
  else if (header.format == "binary_little_endian")
    Ply_binary_reader<false>(path, header, soup, file).read();
  else
    Ply_binary_reader<true>(path, header, soup, file).read();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_IMPL_H

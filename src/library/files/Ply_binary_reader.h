// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Reads the elements of a binary PLY file.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_BINARY_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_BINARY_READER_H

#include "File_blocks.h"
#include "Ply_header.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_PLY_BINARY_READER_H

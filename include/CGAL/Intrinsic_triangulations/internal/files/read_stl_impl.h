// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// STL, text or binary: facets whose corners do not know each other.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_IMPL_H

#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/files/File_blocks.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/reserve.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <string_view>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

inline bool is_text_stl(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\n\v\f\r");
  return begin != std::string::npos && text.compare(begin, 5, "solid") == 0 && begin + 5 < text.size() &&
         (text[begin + 5] == ' ' || text[begin + 5] == '\n' || text[begin + 5] == '\r');
}

// Goes through a text word by word and refuses the first facet that is not as
// it should be; returns if there is none, or if the file is not text.
inline void diagnose_stl(const std::string& path, const std::string& text)
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
        refuse_file(path, place(scanner, "facet", facet) + ": the facet does not have three vertices",
                    Defect::NOT_A_TRIANGLE, facet);
      is_in_facet = false;
      ++facet;
    } else if (word == "vertex" && is_in_facet) {
      ++corners;
      for (int i = 0; i < 3; ++i) {
        const std::string coordinate = scanner.word_on_line();
        if (coordinate.empty())
          refuse_file(path,
                      place(scanner, "facet", facet) + ": a vertex has " + std::to_string(i) +
                        " numbers where 3 are needed",
                      Defect::UNREADABLE, facet);
        check_coordinate(path, coordinate, place(scanner, "facet", facet), facet);
      }
    }
  }
  if (is_in_facet || !is_ended)
    refuse_file(path,
                "the file ends " + std::string(is_in_facet ? "within" : "after") + " facet " +
                  std::to_string(facet - (is_in_facet || facet == 0 ? 0 : 1)) + ", without a line endsolid",
                Defect::UNREADABLE, facet);
}

// Binary files may begin with the word of a text.
inline bool is_binary_stl(const std::string& head, const std::uint32_t facets, const std::uintmax_t file_size)
{
  const std::uintmax_t size = 84 + std::uintmax_t(50) * facets;
  if (head.size() < 84 || file_size < size)
    return false;
  return !is_text_stl(head) || file_size == size ||
         std::any_of(head.begin() + 80, head.begin() + 84, [](char c) { return (c < ' ' && !is_white(c)) || c > '~'; });
}

[[noreturn]] inline void refuse_neither(const std::string& path, const std::string& head, const std::uint32_t facets,
                                        const std::uintmax_t file_size)
{
  std::string begin = head.substr((std::min)(head.find_first_not_of(" \t\n\v\f\r"), head.size()), 6);
  std::transform(begin.begin(), begin.end(), begin.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (begin.compare(0, 3, "\xef\xbb\xbf") == 0)
    refuse_file(path, "the file begins with a byte order mark: save it as UTF-8 without one");
  if (begin.compare(0, 5, "solid") == 0)
    refuse_file(path, "the file begins with " + quote(head.substr(head.find_first_not_of(" \t\n\v\f\r"), 6)) +
                        ": text STL begins with solid, in small letters and with a blank or the end of the line behind it");
  refuse_file(path, "neither text STL (the first word is not solid) nor binary STL (" +
                      (head.size() < 84 ? std::string("shorter than the header of 84 bytes")
                                        : "the header announces " + std::to_string(facets) + " facets, the file has room for " +
                                            std::to_string((file_size - 84) / 50)) +
                      ")");
}

// Corners at the same position are one vertex: positions in a hash table.
class Stl_corners
{
public:
  explicit Stl_corners(Polygon_soup& soup) : soup_(soup), table_(1 << 10, none) {}

  // The vertex at p, a new one if there is none.
  std::uint32_t vertex(const std::array<double, 3>& p)
  {
    for (std::size_t i = hash(p);; ++i) {
      std::uint32_t& entry = table_[i & (table_.size() - 1)];
      if (entry == none) {
        const std::uint32_t v = static_cast<std::uint32_t>(soup_.points.size());
        if (v == none)
          throw std::bad_alloc();
        entry = v;
        soup_.points.push_back(p);
        if (2 * soup_.points.size() > table_.size())
          grow();
        return v;
      }
      if (soup_.points[entry] == p)
        return entry;
    }
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  static std::size_t hash(const std::array<double, 3>& p)
  {
    std::uint64_t h = 0;
    for (const double coordinate : p) {
      const double c = coordinate + 0.; // there is one zero
      std::uint64_t bits;
      std::memcpy(&bits, &c, sizeof(bits));
      h = (h ^ bits) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }

  void grow()
  {
    Large_vector<std::uint32_t>(4 * table_.size(), none).swap(table_);
    for (std::uint32_t v = 0; v < soup_.points.size(); ++v) {
      std::size_t i = hash(soup_.points[v]);
      while (table_[i & (table_.size() - 1)] != none)
        ++i;
      table_[i & (table_.size() - 1)] = v;
    }
  }

  Polygon_soup& soup_;
  Large_vector<std::uint32_t> table_; // its size is a power of two
};

class Stl_text_reader
{
public:
  Stl_text_reader(const std::string& path, Polygon_soup& soup) : path_(path), soup_(soup), corners_(soup) {}

  void read(const std::uintmax_t size, const Progress_function& progress)
  {
    File_blocks file(path_, size, 0, progress);
    reserve(soup_, size / 256, size / 128); // a guess: the usual file has fewer
    // The word that makes it a text is of no other use.
    bool is_first = true;
    while (file.take_words())
      for (file.first = skip_white(file.first, file.last); file.first != file.last;
           file.first = skip_white(file.first, file.last)) {
        const char* p = file.first;
        if (left_coordinates_ > 0)
          take_coordinate(p, file.last);
        else {
          p = skip_word(p, file.last);
          if (!is_first)
            take_word(std::string_view(file.first, static_cast<std::size_t>(p - file.first)));
          is_first = false;
        }
        file.first = p;
      }
    if (is_in_facet_ || is_in_solid_ || !is_ended_)
      refuse();
  }

private:
  void take_word(const std::string_view word)
  {
    if (is_in_facet_) {
      if (word == "vertex" && number_of_corners_ < 3)
        left_coordinates_ = 3;
      else if (word == "endfacet" && number_of_corners_ == 3) {
        soup_.triangles.push_back(triangle_);
        is_in_facet_ = false;
      } else if (word == "vertex" || word == "endfacet")
        refuse();
    } else if (word == "facet") {
      is_in_facet_ = true;
      number_of_corners_ = 0;
    } else if (word == "solid") {
      if (is_in_solid_)
        refuse();
      is_in_solid_ = true;
    } else if (word == "endsolid") {
      is_in_solid_ = false;
      is_ended_ = true;
    }
  }

  void take_coordinate(const char*& p, const char* const last)
  {
    const char* const begin = p;
    double& coordinate = point_[3 - left_coordinates_];
    if (!take_real(p, last, coordinate) || (p != last && *p == '#')) {
      p = skip_word(begin, last);
      const std::string word(begin, p);
      if (!read_coordinate(word, coordinate)) {
        diagnose_stl(path_, load_file(path_));
        check_coordinate(path_, word, "facet " + std::to_string(soup_.triangles.size()), soup_.triangles.size());
      }
    }
    if (--left_coordinates_ == 0)
      triangle_[number_of_corners_++] = corners_.vertex(point_);
  }

  [[noreturn]] void refuse() const
  {
    diagnose_stl(path_, load_file(path_));
    refuse_file(path_, "the file cannot be read (stopped after " + std::to_string(soup_.points.size()) +
                         " vertices and " + std::to_string(soup_.triangles.size()) + " faces)");
  }

  std::string path_;
  Polygon_soup& soup_;
  Stl_corners corners_;
  bool is_in_facet_ = false;
  bool is_in_solid_ = false; // since a second `solid`
  bool is_ended_ = false;    // there was an `endsolid`
  std::size_t number_of_corners_ = 0, left_coordinates_ = 0;
  std::array<double, 3> point_{};
  std::array<std::uint32_t, 3> triangle_{};
};

inline void read_binary_stl(const std::string& path, const std::uint32_t facets, const std::uintmax_t size,
                            const Progress_function& progress, Polygon_soup& soup)
{
  File_blocks file(path, size, 84, progress);
  Stl_corners corners(soup);
  reserve(soup, facets / 2, facets); // as many vertices as a closed surface has
  for (std::uint32_t f = 0; f < facets; ++f, file.first += 50) {
    if (!file.require(50))
      refuse_file(path, "facet " + std::to_string(f) + ": the file ends within the facet", Defect::UNREADABLE, f);
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> point;
      for (std::size_t j = 0; j < 3; ++j) {
        float coordinate;
        std::memcpy(&coordinate, file.first + 12 + 12 * i + 4 * j, 4);
        if (!std::isfinite(coordinate))
          refuse_file(path, "facet " + std::to_string(f) + ": a coordinate is not finite", Defect::NOT_FINITE, f);
        point[j] = coordinate;
      }
      triangle[i] = corners.vertex(point);
    }
    soup.triangles.push_back(triangle);
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void read_stl(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  const std::string head = load_file(path, 4096);
  std::uint32_t facets = 0;
  if (head.size() >= 84)
    std::memcpy(&facets, &head[80], 4);
  if (is_binary_stl(head, facets, size))
    read_binary_stl(path, facets, size, progress, soup);
  else if (is_text_stl(head))
    Stl_text_reader(path, soup).read(size, progress);
  else
    refuse_neither(path, head, facets, size);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_IMPL_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// STL, text or binary: facets without shared corners.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_H

#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include "File_blocks.h"
#include "text_file.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <boost/config.hpp>

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

namespace CGAL::Intrinsic_triangulations::internal {

// Text begins with the word solid, and has no bytes that only binary files have: their headers may begin with any word.
inline bool is_text_stl(const std::string& head)
{
  const std::size_t mark = head.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0;
  const char *const end = head.data() + head.size(), *const word = skip_white(head.data() + mark, end);
  return is_keyword(std::string_view(word, static_cast<std::size_t>(skip_word(word, end) - word)), "solid") &&
         std::all_of(word, end, [](unsigned char c) { return is_white(static_cast<char>(c)) || c >= ' '; });
}

[[noreturn]] inline void refuse_neither(const std::string& path, const std::string& head, const std::string& trouble)
{
  find_encoding(path); // of a text
  const char *const end = head.data() + head.size(), *const word = skip_white(head.data(), end);
  const std::string first(word, skip_word(word, end));
  refuse_file(
    path,
    is_keyword(first, "solid")
      ? "the file begins as text STL does, but has bytes that are in no text; nor is it binary STL (" + trouble + ")"
      : "neither text STL (the first word is " + quote(first) + " and not solid) nor binary STL (" + trouble + ")");
}

// Corners at the same position are one vertex: positions in a hash table.
class Stl_corners
{
public:
  explicit Stl_corners(Polygon_soup& soup) : soup_(soup), table_(1 << 10, none) {}

  // The vertex at p; creates it at need.
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

// solid [name] { facet [normal x y z] [outer loop] 3 vertex x y z [endloop] endfacet } endsolid [name]
//
// Line ends matter only after solid and endsolid, whose names end there, and after #. Some programs add color and its
// numbers anywhere.
class Stl_text_reader
{
public:
  Stl_text_reader(const std::string& path, Polygon_soup& soup) : path_(path), soup_(soup), corners_(soup) {}

  void read(const std::uintmax_t size, const Progress_function& progress)
  {
    const Text_encoding encoding = find_encoding(path_);
    line_end_ = encoding.line_end;
    File_blocks file(path_, size, encoding.begin, progress);
    reserve(soup_, size / 256, size / 128); // a guess: the usual file has fewer
    while (file.take_words()) {
      const char *p = file.first, *const last = file.last;
      for (;;) {
        for (; p != last && is_white(*p); ++p) {
          number_ += *p == line_end_;
          has_other_end_ = has_other_end_ || *p == (line_end_ == '\n' ? '\r' : '\n');
        }
        if (p == last)
          break;
        if (coordinates_ < 3)
          take_coordinate(p, last);
        else if (state_ != SOLID || !prefix_.empty() || number_ == line_of_rest_ || !take_usual_facet(p, last)) {
          const char* const begin = p;
          p = skip_word(begin, last);
          take_word(std::string_view(begin, static_cast<std::size_t>(p - begin)));
        }
        line_of_word_ = number_;
      }
      file.first = last;
    }
    if (state_ != SOLID && state_ != OUTSIDE)
      refuse_file(path_, "the file ends within facet " + std::to_string(facet()) + ", without a line endsolid",
                  Defect::UNREADABLE, facet());
    if (soup_.triangles.empty())
      refuse_file(path_, "there is no facet in the file", Defect::EMPTY);
    if (state_ == SOLID)
      soup_.warnings.push_back("the file ends without a line endsolid, behind facet " + std::to_string(facet() - 1) +
                               ": it may have been cut off");
  }

private:
  enum State {
    OUTSIDE, // of all solids
    SOLID,   // before a facet
    FACET,   // after that word, or its normal
    CORNERS,
    LOOP // before the end of a facet
  };

  BOOST_FORCEINLINE void skip_white_and_count(const char*& p, const char* const last, std::size_t& lines) const
  {
    for (; p != last && is_white(*p); ++p)
      lines += *p == line_end_;
  }

  // Reads a facet in the usual form; does not move at any other.
  bool take_usual_facet(const char*& begin, const char* const last)
  {
    const char* p = begin;
    std::size_t lines = 0;
    const auto take = [&](const auto& word) {
      constexpr std::size_t size = sizeof word - 1; // without the zero
      skip_white_and_count(p, last, lines);
      if (static_cast<std::size_t>(last - p) <= size || std::memcmp(p, word, size) != 0 || !is_white(p[size]))
        return false;
      p += size;
      return true;
    };
    if (!take("facet") || !take("normal"))
      return false;
    for (std::size_t i = 0; i < 3; ++i) {
      skip_white_and_count(p, last, lines);
      if (p == last || !(is_digit(*p) || *p == '-'))
        return false;
      p = skip_word(p, last);
    }
    if (!take("outer") || !take("loop"))
      return false;
    std::array<std::array<double, 3>, 3> points;
    for (std::array<double, 3>& point : points) {
      if (!take("vertex"))
        return false;
      for (double& coordinate : point) {
        skip_white_and_count(p, last, lines);
        if (!take_real(p, last, coordinate) || p == last)
          return false;
      }
    }
    if (!take("endloop") || !take("endfacet"))
      return false;
    for (std::size_t i = 0; i < 3; ++i)
      triangle_[i] = corners_.vertex(points[i]);
    soup_.triangles.push_back(triangle_);
    number_ += lines;
    line_of_color_ = 0;
    begin = p;
    return true;
  }

  void take_word(const std::string_view word)
  {
    if (number_ == line_of_rest_)
      return take_rest(word);
    if (number_ == line_of_color_ && !is_word_of_stl(word))
      return;
    line_of_color_ = 0;
    if (prefix_.empty() && word[0] == '#')
      return begin_rest(false);
    std::string joined;
    std::string_view whole = word;
    if (!prefix_.empty())
      whole = joined = std::string(prefix_) + std::string(word);
    prefix_ = {};
    if (!take_keyword(whole))
      refuse_word(std::string(whole));
  }

  // Returns whether it may be there.
  bool take_keyword(const std::string_view word)
  {
    const auto is = [word](const std::string_view keyword) { return is_keyword(word, keyword); };
    if (state_ == FACET && is("outer")) {
      normal_ = 0; // of which words may be missing
      prefix_ = "outer ";
    } else if (state_ == FACET && (is("outer loop") || is("vertex"))) {
      state_ = CORNERS;
      has_loop_ = !is("vertex");
      return has_loop_ || take_keyword(word);
    } else if (state_ == FACET && normal_ > 0)
      --normal_; // of any words, NaN for example
    else if (state_ == FACET && is("normal") && !has_normal_) {
      has_normal_ = true;
      normal_ = 3;
    } else if (state_ == CORNERS && is("vertex")) {
      if (number_of_corners_ == 3)
        refuse_corners();
      coordinates_ = 0;
      line_of_vertex_ = number_;
    } else if (state_ == CORNERS && is("endloop") && has_loop_)
      state_ = LOOP;
    else if (is("endfacet") && (state_ == LOOP || (state_ == CORNERS && !has_loop_)))
      end_facet();
    else if (state_ == SOLID && is("facet"))
      begin_facet();
    else if (is("end"))
      prefix_ = "end";
    else if (is("solid") && (state_ == SOLID || state_ == OUTSIDE)) {
      if (state_ == SOLID)
        soup_.warnings.push_back("line " + std::to_string(number_) +
                                 ": a solid begins, but the previous one has no line endsolid");
      state_ = SOLID;
      begin_rest(true);
    } else if (is("endsolid") && state_ == SOLID) {
      state_ = OUTSIDE;
      begin_rest(true);
    } else if (state_ != OUTSIDE && (is("color") || is("colour")))
      line_of_color_ = number_;
    else
      return false;
    return true;
  }

  static bool is_word_of_stl(const std::string_view word)
  {
    return word[0] == '#' || is_one_of(word, {"facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet",
                                              "end", "solid", "endsolid", "color"});
  }

  void end_facet()
  {
    if (number_of_corners_ != 3)
      refuse_corners();
    soup_.triangles.push_back(triangle_);
    state_ = SOLID;
  }

  void begin_facet()
  {
    state_ = FACET;
    has_loop_ = has_normal_ = false;
    number_of_corners_ = normal_ = 0;
  }

  // A comment to the end of the line, or a name, which ends at a facet, too: some files are one line.
  void begin_rest(const bool is_name)
  {
    const bool is_whole_line = number_ != line_of_word_; // which may comment a facet out
    facet_words_ = is_name ? 1 : is_whole_line ? 0 : in_comment;
    is_second_ = has_other_end_ = is_solid_begun_ = is_behind_vertex_ = false;
    swallowed_.clear();
    line_of_rest_ = number_;
  }
  void take_rest(const std::string_view word)
  {
    if (facet_words_ < 1 && has_other_end_) {
      if (is_word_of_stl(word) && word[0] != '#')
        refuse_line_end(path_, number_, line_end_);
      has_other_end_ = false;
    }
    if (facet_words_ == 0)
      return;
    const bool is_end = is_keyword(word, "endfacet") || is_keyword(word, "endloop") ||
                        (is_second_ && (is_keyword(word, "facet") || is_keyword(word, "loop")));
    is_second_ = is_keyword(word, "outer") || is_keyword(word, "end");
    if (is_end && swallowed_.empty())
      swallowed_ = std::string(word);
    // A name or a comment may contain any words, but hardly a facet up to the numbers of a vertex.
    const bool is_facet = !swallowed_.empty() && is_behind_vertex_ && is_number(word);
    is_behind_vertex_ = is_keyword(word, "vertex");
    if (is_facet && facet_words_ == in_comment)
      refuse(quote(swallowed_) + " is in the comment that begins with # on this line: end the line before the facet");
    if (is_facet)
      refuse_word(swallowed_); // of a facet whose first words are misspelt, in a file of one line
    if (facet_words_ == in_comment)
      return;
    is_solid_begun_ = is_solid_begun_ || is_keyword(word, "solid");
    facet_words_ = is_keyword(word, "facet")                           ? 2
                   : facet_words_ == 2 && is_keyword(word, "normal")   ? 3
                   : facet_words_ == 3 && is_number(std::string(word)) ? 4
                                                                       : 1;
    if (facet_words_ < 4)
      return;
    if (state_ == OUTSIDE && !is_solid_begun_)
      refuse_word("facet normal");
    line_of_rest_ = facet_words_ = 0;
    begin_facet();
    has_normal_ = true;
    normal_ = 2;
  }

  void take_coordinate(const char*& p, const char* const last)
  {
    double& coordinate = point_[coordinates_];
    if (!take_real(p, last, coordinate)) {
      const char* const begin = p;
      p = skip_word(begin, last);
      const std::string word(begin, p);
      if (number_ != line_of_vertex_)
        refuse_file(path_,
                    place(line_of_vertex_, "facet", facet()) + ": a vertex has " +
                      counted(coordinates_, "number", "numbers") + " where 3 are needed",
                    Defect::UNREADABLE, facet());
      coordinate = check_coordinate(path_, word, place(number_, "facet", facet()), facet());
    }
    if (++coordinates_ == 3)
      triangle_[number_of_corners_++] = corners_.vertex(point_);
  }

  std::size_t facet() const { return soup_.triangles.size(); }

  [[noreturn]] void refuse(const std::string& text, const Defect defect = Defect::UNREADABLE) const
  {
    refuse_file(path_, place(number_, "facet", facet()) + ": " + text, defect, facet());
  }
  [[noreturn]] void refuse_corners() const { refuse("the facet does not have three vertices", Defect::NOT_A_TRIANGLE); }
  [[noreturn]] void refuse_word(const std::string& word) const
  {
    const bool is_within_facet = is_one_of(word, {"outer", "loop", "vertex", "normal", "endloop", "endfacet"});
    refuse(quote(word) + " where " +
           (state_ == OUTSIDE                               ? "solid"
            : state_ == SOLID                               ? "facet or endsolid"
            : state_ == FACET                               ? (has_normal_ ? "outer loop" : "normal or outer loop")
            : state_ == CORNERS && (number_of_corners_ < 3) ? "vertex"
            : state_ == CORNERS && has_loop_                ? "endloop"
                                                            : "endfacet") +
           " is expected" + (state_ == SOLID && is_within_facet ? ": the line facet normal is missing before it" : ""));
  }

  std::string path_;
  Polygon_soup& soup_;
  Stl_corners corners_;
  char line_end_ = '\n';
  std::size_t number_ = 1; // of the line
  State state_ = OUTSIDE;
  bool has_loop_ = false, has_normal_ = false;          // of the facet
  int normal_ = 0;                                      // how many of its words are to come
  std::size_t number_of_corners_ = 0, coordinates_ = 3; // coordinates of the corner
  std::string_view prefix_;                             // the first half of a keyword of two words
  std::size_t line_of_rest_ = 0, line_of_vertex_ = 0;   // the rest of that line is a name or a comment
  std::size_t line_of_word_ = 0;                        // of the word before
  static constexpr int in_comment = -1;                 // after other words
  int facet_words_ = 0;                                 // in a name, one more than there are words of a facet
  bool is_second_ = false;                              // the word before is the first half of a keyword
  bool is_solid_begun_ = false;                         // perhaps: the name of another has that word
  bool has_other_end_ = false;                          // the rest has a CR or LF that ends no line
  std::size_t line_of_color_ = 0;                       // whatever else is on that line belongs to the color
  std::string swallowed_;                               // in a name or comment, the end of a part of a facet
  bool is_behind_vertex_ = false;                       // the word before is vertex
  std::array<double, 3> point_{};
  std::array<std::uint32_t, 3> triangle_{};
};

// A header of 80 bytes, the number of facets, and 50 bytes for each.
inline void read_binary_stl(const std::string& path, const std::string& head, const std::uintmax_t size,
                            const Progress_function& progress, Polygon_soup& soup)
{
  if (head.size() < 84)
    refuse_neither(path, head, "shorter than the header of 84 bytes");
  constexpr std::uint32_t unknown_number = (std::numeric_limits<std::uint32_t>::max)();
  std::uint32_t announced = 0;
  std::memcpy(&announced, &head[80], 4);
  const std::uintmax_t stored = (size - 84) / 50, surplus = (size - 84) % 50;
  const std::string both = "the header announces " + counted(announced, "facet", "facets") +
                           ", the file has room for " + std::to_string(stored);
  // Programs that write facets as they come may not know their number in time. A damaged text may have these bytes, but
  // no zero.
  const bool is_unknown = (announced == 0 || (announced == unknown_number && head.find('\0') != std::string::npos)) &&
                          stored > 0 && surplus == 0;
  const std::uintmax_t facets = is_unknown ? stored : announced;
  if (facets > stored || (announced == 0 && stored > 0 && surplus > 0))
    refuse_neither(path, head,
                   both + ": it ends within facet " + std::to_string(stored) + ", which begins at byte " +
                     std::to_string(84 + 50 * stored) +
                     "; it was cut off, or the number, of four bytes at byte 80, is wrong");
  if (is_unknown) {
    soup.warnings.push_back("the header announces " + counted(announced, "facet", "facets") + "; all " +
                            std::to_string(stored) + " that are in the file were read");
  } else if (facets < stored)
    refuse_file(
      path, both + ": facet " + std::to_string(facets) + ", at byte " + std::to_string(84 + 50 * facets) +
              ", is the first behind them; correct the number, of four bytes at byte 80, or cut off what is behind");
  else if (surplus > 0)
    soup.warnings.push_back("there " + are_counted(surplus, "byte", "bytes") + " behind the " +
                            counted(facets, "facet", "facets") + ", too few for a facet");

  File_blocks file(path, size, 84, progress);
  Stl_corners corners(soup);
  reserve(soup, facets / 2, facets); // as many vertices as a closed surface has
  for (std::size_t f = 0; f < facets; ++f, file.first += 50) {
    if (!file.require(50))
      refuse_file(path, "facet " + std::to_string(f) + ": the file ends within the facet", Defect::UNREADABLE, f);
    std::array<std::uint32_t, 3> triangle;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> point;
      for (std::size_t j = 0; j < 3; ++j) {
        float coordinate;
        std::memcpy(&coordinate, file.first + 12 + 12 * i + 4 * j, 4);
        if (!std::isfinite(coordinate))
          refuse_file(path,
                      "facet " + std::to_string(f) + ": a coordinate is not finite (the facet begins at byte " +
                        std::to_string(84 + 50 * f) + ")",
                      Defect::NOT_FINITE, f);
        point[j] = coordinate;
      }
      triangle[i] = corners.vertex(point);
    }
    soup.triangles.push_back(triangle);
  }
}

inline void read_stl(const std::string& path, const std::uintmax_t size, const Progress_function& progress,
                     Polygon_soup& soup)
{
  const std::string head = load_file(path, 4096);
  if (is_text_stl(head))
    Stl_text_reader(path, soup).read(size, progress);
  else
    read_binary_stl(path, head, size, progress, soup);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_STL_H

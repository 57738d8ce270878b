// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// OFF: a header, then lines of vertices and lines of faces.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/File_blocks.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/reserve.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

struct Off_header
{
  bool is_plain;       // no normals, colors, textures or fourth coordinate
  bool is_homogeneous; // a fourth coordinate, by which the three are divided
  std::size_t numbers_per_vertex;
  std::size_t vertices;
  std::size_t faces;
};

// Reads the header, and compares it with the size of the file.
inline Off_header read_off_header(const std::string& path, Scanner& scanner, const std::uintmax_t file_size)
{
  const std::string first = scanner.word();
  if (first.empty())
    refuse_file(path, "there is nothing but white space and comments in the file");
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
    refuse_file(path, "line " + std::to_string(scanner.line()) + ": the file begins with " + quote(first) +
                        " where OFF is expected");
  numbers += homogeneous + normals * (3 + homogeneous) + pairs * (2 + homogeneous);

  long long sizes[3]; // vertices, faces, edges
  static const char* const names[3] = {"vertices", "faces", "edges"};
  for (int i = 0; i < 3; ++i) {
    const std::string word = scanner.word();
    if (i == 0 && word == "BINARY")
      refuse_file(path, "binary OFF is not read: write the file as text, or as PLY");
    if (word.empty())
      refuse_file(path, std::string("the file ends before the number of ") + names[i]);
    if (!read_integer(word, sizes[i]) || sizes[i] < 0)
      refuse_file(path, "line " + std::to_string(scanner.line()) + ": " + quote(word) + " is not a number of " +
                          names[i] + " (the header is OFF, then the numbers of vertices, faces and edges)");
  }
  // A vertex takes at least "0 0 0" and a line end, a face at least "0" and one.
  const std::uintmax_t vertices = static_cast<std::uintmax_t>(sizes[0]);
  const std::uintmax_t faces = static_cast<std::uintmax_t>(sizes[1]);
  if (vertices > file_size / 6 + 1 || faces > file_size / 2 + 1)
    refuse_file(path, "the header announces " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                        " faces, more than fit into the " + std::to_string(file_size) + " bytes of the file");
  return Off_header{first == "OFF", homogeneous == 1, numbers, static_cast<std::size_t>(vertices),
                    static_cast<std::size_t>(faces)};
}

// Goes through a text line by line and refuses the first line that is not as it should be; returns if there is none.
// To say what is wrong takes longer than to see it.
inline void diagnose_off(const std::string& path, const std::string& text)
{
  Scanner scanner(text);
  const Off_header header = read_off_header(path, scanner, text.size());
  // As in CGAL, vertices may begin on the line of the header, unless they have more than coordinates.
  if (!header.is_plain)
    scanner.skip_line();
  if (header.faces == 0)
    refuse_file(path, "there is no face (" + std::to_string(header.vertices) + " vertices)", Defect::EMPTY);
  for (std::size_t v = 0; v < header.vertices; ++v) {
    if (!scanner.skip_to_word())
      refuse_file(path,
                  "the file ends after " + std::to_string(v) + " of " + std::to_string(header.vertices) +
                    " vertices",
                  Defect::UNREADABLE, v);
    for (std::size_t i = 0; i < header.numbers_per_vertex; ++i) {
      const std::string word = scanner.word_on_line();
      if (word.empty())
        refuse_file(path,
                    place(scanner, "vertex", v) + ": there are " + std::to_string(i) + " numbers where " +
                      std::to_string(header.numbers_per_vertex) + " are needed",
                    Defect::UNREADABLE, v);
      const double number = check_coordinate(path, word, place(scanner, "vertex", v), v);
      if (i == 3 && header.is_homogeneous && number == 0)
        refuse_file(path, place(scanner, "vertex", v) + ": the fourth coordinate is zero", Defect::NOT_FINITE, v);
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
      if (is_beyond_integers(word))
        trouble = place(scanner, "face", f) + ": no face has " + quote(word) + " corners";
      else if (!read_integer(word, size) || size < 0)
        trouble = place(scanner, "face", f) + ": " + quote(word) + " is not a number of corners";
    }
    bool is_bad = false;
    for (long long i = 0; i < size && trouble.empty(); ++i) {
      const std::string word = scanner.word_on_line();
      long long index = 0;
      if (word.empty())
        trouble = place(scanner, "face", f) + ": there are " + std::to_string(i) + " vertices where " +
                  std::to_string(size) + " are announced";
      else if (const bool is_beyond = is_beyond_integers(word); !is_beyond && !read_integer(word, index))
        trouble = place(scanner, "face", f) + ": " + quote(word) + " is not the index of a vertex";
      else if (is_beyond || index < 0 || index >= static_cast<long long>(header.vertices)) {
        is_bad = true;
        if (first_bad_index.empty()) {
          first_bad_face = f;
          first_bad_index = place(scanner, "face", f) + ": the face names vertex " +
                            (word.size() > 30 ? quote(word) : word) + ", but there are " +
                            std::to_string(header.vertices) + " vertices (counted from 0)";
        }
      }
    }
    bad_faces += is_bad;
    if (!trouble.empty() && bad_faces == 0)
      refuse_file(path, trouble, Defect::UNREADABLE, f);
    if (!trouble.empty())
      break;
    scanner.skip_line();
  }
  if (bad_faces > 1)
    first_bad_index += ", and " + std::to_string(bad_faces - 1) +
                       (bad_faces == 2 ? " more face like it" : " more faces like it");
  if (bad_faces != 0)
    refuse_file(path, first_bad_index, Defect::BAD_INDEX, first_bad_face, bad_faces);
}

// Vertices and faces are a line each; what follows the numbers that count, a color for example, is skipped.
class Off_reader
{
public:
  Off_reader(const std::string& path, const Off_header& header, Polygon_soup& soup)
    : header_(header), soup_(soup), path_(path)
  {
  }

  // \param number the line on which the header ends
  // \param most_triangles that the file has room for
  void read(File_blocks& file, std::size_t number, const std::uintmax_t most_triangles)
  {
    reserve(soup_, header_.vertices, (std::min<std::uintmax_t>)(header_.faces, most_triangles));
    bool is_skipped = !header_.is_plain;
    for (const char *p = nullptr, *last = nullptr; !is_complete() && file.take_line(p, last); ++number) {
      p = skip_white(p, last);
      if (!is_skipped && p != last && *p != '#' &&
          !(soup_.points.size() < header_.vertices ? take_vertex(p, last) : take_face(p, last)))
        refuse_line(number);
      is_skipped = false;
    }
    if (!is_complete())
      refuse_line(number);
  }

private:
  bool is_complete() const
  {
    return soup_.points.size() == header_.vertices && soup_.number_of_faces() == header_.faces;
  }

  [[noreturn]] void refuse_line(const std::size_t number) const
  {
    diagnose_off(path_, load_file(path_));
    refuse_file(path_, "line " + std::to_string(number) + " cannot be read");
  }

  static bool take_number(const char*& p, const char* const last, double& number)
  {
    p = skip_white(p, last);
    if (take_real(p, last, number))
      return true;
    const char* const end = std::find(p, skip_word(p, last), '#');
    if (!read_coordinate(std::string(p, end), number))
      return false;
    p = end;
    return true;
  }

  bool take_vertex(const char* p, const char* const last)
  {
    std::array<double, 3> point;
    for (double& coordinate : point)
      if (!take_number(p, last, coordinate))
        return false;
    if (!header_.is_plain) {
      double number = 0;
      for (std::size_t i = 3; i < header_.numbers_per_vertex; ++i) {
        if (!take_number(p, last, number))
          return false;
        if (i > 3 || !header_.is_homogeneous)
          continue;
        if (number == 0)
          return false;
        for (double& coordinate : point)
          coordinate /= number;
      }
    }
    soup_.points.push_back(point);
    return true;
  }

  bool take_face(const char* p, const char* const last)
  {
    std::uint32_t size = 0;
    if (!take_index(p, last, size) || size > static_cast<std::size_t>(last - p))
      return false;
    corners_.clear();
    for (std::uint32_t index = 0; size > 0; --size) {
      p = skip_white(p, last);
      if (!take_index(p, last, index) || index >= header_.vertices)
        return false;
      corners_.push_back(index);
    }
    soup_.add_face(corners_.data(), corners_.data() + corners_.size());
    return true;
  }

  static bool take_index(const char*& p, const char* const last, std::uint32_t& number)
  {
    if (!take_count(p, last, number)) {
      const char* const end = std::find(p, skip_word(p, last), '#');
      long long value = 0;
      if (!read_integer(std::string(p, end), value) || value < 0 || value > (std::numeric_limits<std::uint32_t>::max)())
        return false;
      number = static_cast<std::uint32_t>(value);
      p = end;
    }
    return p == last || is_white(*p) || *p == '#';
  }

  Off_header header_;
  Polygon_soup& soup_;
  std::string path_;
  std::vector<std::uint32_t> corners_; // of a face
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
void read_off(const std::string& path, const std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  std::string head = load_file(path, 1 << 16);
  int words = 0;
  for (Scanner probe(head); words < 5 && !probe.word().empty();)
    ++words;
  // A header longer than the first part of the file is one of long comments.
  if (words < 5 && head.size() < size)
    head = load_file(path);
  Scanner scanner(head);
  const Off_header header = read_off_header(path, scanner, size);
  File_blocks file(path, size, head.size() - scanner.remaining(), progress);
  Off_reader(path, header, soup).read(file, scanner.line(), size / 8 + 1);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_OFF_IMPL_H

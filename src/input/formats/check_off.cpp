// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Text_check.h"
#include "input/formats/text_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace idt {
namespace {

struct Off_header
{
  bool is_plain;       // CGAL's reader is safe: no normals, colors, textures or fourth coordinate
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
  // CGAL doubles the number of edges, which it has no use for, as an int.
  const bool is_safe = sizes[2] <= (std::numeric_limits<int>::max)() / 2;
  return Off_header{first == "OFF" && is_safe, homogeneous == 1, numbers, static_cast<std::size_t>(vertices),
                    static_cast<std::size_t>(faces)};
}

} // namespace

// Goes through a text line by line and refuses the first line that is not as
// it should be; returns if there is none.
void diagnose_off(const std::string& path, const std::string& text)
{
  Scanner scanner(text);
  const Off_header header = read_off_header(path, scanner, text.size());
  // CGAL's reader begins behind the numbers of the header, not at the next line.
  if (!header.is_plain)
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

namespace {

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

// CGAL's reader takes of each word what looks like a number, and rounds indices: "3 0 2.7 1" and
// "0 0 1,5" are something else then.
class Off_check : public Line_check
{
public:
  // \param header_size the bytes up to the last number of the header
  // \param header_lines the lines that end within them
  Off_check(const std::string& path, const Off_header& header, std::size_t header_size, std::size_t header_lines)
    : path_(path), header_(header), header_size_(header_size), header_lines_(header_lines), to_skip_(header_size)
  {
  }

  void take(const char* first, const char* const last) override
  {
    const std::size_t skipped = (std::min)(to_skip_, static_cast<std::size_t>(last - first));
    to_skip_ -= skipped;
    Line_check::take(first + skipped, last);
  }
  void restart() override
  {
    Line_check::restart();
    to_skip_ = header_size_;
    vertices_ = faces_ = 0;
  }

private:
  void line(const char* p, const char* const last) override
  {
    p = skip_white(p, last);
    if (p == last || *p == '#' || faces_ == header_.faces)
      return;
    if (vertices_ < header_.vertices ? !is_vertex(p, last) : !is_face(p, last)) {
      // To say what is wrong takes longer than to see it.
      diagnose_off(path_, load(path_));
      refuse(path_, "line " + std::to_string(header_lines_ + number()) + " cannot be read");
    }
    ++(vertices_ < header_.vertices ? vertices_ : faces_);
  }

  static bool is_vertex(const char* p, const char* const last)
  {
    for (int i = 0; i < 3; ++i) {
      p = skip_white(p, last);
      const char* end = skip_plain_number(p, last);
      if (end == nullptr) {
        end = std::find(p, skip_word(p, last), '#');
        if (!is_coordinate(std::string(p, end)))
          return false;
      }
      p = end;
    }
    return true;
  }

  bool is_face(const char* p, const char* const last) const
  {
    std::size_t size = 0;
    if (!read_count(p, last, size) || size > static_cast<std::size_t>(last - p))
      return false;
    for (std::size_t index = 0; size > 0; --size) {
      p = skip_white(p, last);
      if (!read_count(p, last, index) || index >= header_.vertices)
        return false;
    }
    return true;
  }

  // Goes behind a number without a sign and a point, of ten digits at most.
  static bool read_count(const char*& p, const char* const last, std::size_t& number)
  {
    const char* const begin = p += p != last && *p == '+';
    for (number = 0; p != last && *p >= '0' && *p <= '9' && p - begin < 10; ++p)
      number = 10 * number + static_cast<std::size_t>(*p - '0');
    return p != begin && (p == last || is_white(*p) || *p == '#');
  }

  std::string path_;
  Off_header header_;
  std::size_t header_size_, header_lines_, to_skip_;
  std::size_t vertices_ = 0, faces_ = 0;
};

} // namespace

// What CGAL's reader would trust: the announced sizes, and the number of
// entries of a vertex with normals, colors or textures.
Prepared_text check_off(const std::string& path, const std::uintmax_t file_size)
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
  const Off_header header = read_off_header(path, scanner, file_size);
  if (header.is_plain)
    return {std::make_unique<Off_check>(path, header, text.size() - scanner.remaining(), scanner.line() - 1),
            std::nullopt};
  if (is_complete)
    whole = load(path);
  diagnose_off(path, whole);
  return {nullptr, without_attributes(path, whole)};
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/checks.h"

#include "input/formats/Obj_filter.h"
#include "input/formats/polygon_soup.h"
#include "input/formats/text_file.h"

#include <CGAL/IO/polygon_soup_io.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <sstream>

namespace idt {

// Lets the library's reader try once more, on a stream that tells where it stopped.
void diagnose_by_position(const std::string& path, const std::string& extension)
{
  std::string text = load(path);
  // As for the first attempt.
  if (extension == "obj")
    Obj_filter()(text.data(), text.data() + text.size());
  std::istringstream in(text);
  CGAL::IO::set_mode(in, extension == "ply" ? CGAL::IO::BINARY : CGAL::IO::ASCII);
  Points points;
  Polygons polygons;
  const auto quiet = CGAL::parameters::verbose(false);
  if (extension == "obj")
    CGAL::IO::read_OBJ(in, points, polygons, quiet);
  else
    CGAL::IO::read_PLY(in, points, polygons, quiet);
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

  // OBJ is read line by line: the reader is behind the one that it did not
  // like, or at the end with something missing.
  const std::size_t end_of_line = position > 0 && text[position - 1] == '\n' ? position - 1 : position;
  const std::size_t line_begin = end_of_line == 0 ? 0 : text.rfind('\n', end_of_line - 1) + 1;
  std::string line = text.substr(line_begin, end_of_line - line_begin);
  while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
    line.pop_back();
  const std::string where =
    "line " + std::to_string(
                1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line_begin), '\n'));
  const std::string not_understood = where + ": " + quote(line) + " is not understood (after " + so_far + ")";
  if (!is_at_end)
    refuse(path, not_understood);
  if (polygons.empty() || points.empty())
    refuse(path,
           "there is " + std::string(points.empty() ? "no vertex" : "no face") + " in the file (" + so_far +
             ")",
           Defect::EMPTY);
  // Numbers and corners were looked at before: it was the last line.
  refuse(path, not_understood);
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A text line by line, and each line word by word, up to a comment.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H

#include <CGAL/Intrinsic_triangulations/internal/files/File_blocks.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

class Text_lines
{
public:
  Text_lines(const std::string& path, const std::uintmax_t size, const Progress_function& progress)
    : Text_lines(path, size, progress, find_encoding(path))
  {
  }

  // What is left of the line: the caller moves `p` on. Pointers hold until the next line.
  const char* p = nullptr;
  const char* last = nullptr;

  // The number of the line, counted from 1; 0 before the first.
  std::size_t number() const { return number_; }

  // Goes to the next line; false if there is none.
  bool next_line()
  {
    if (!file_.take_line(p, last)) {
      p = last = nullptr;
      return false;
    }
    ++number_;
    return true;
  }
  // Goes to the next word of the line; false at its end or at a comment.
  bool find_word_on_line()
  {
    p = skip_white(p, last);
    if (p != last && *p == '#')
      p = last;
    return p != last;
  }
  // Goes to the next word anywhere; false at the end of the file.
  bool find_word()
  {
    while (!find_word_on_line())
      if (!next_line())
        return false;
    return true;
  }
  // Goes over the word at p.
  std::string_view take_word()
  {
    const char* const begin = p;
    p = std::find(begin, skip_word(begin, last), '#');
    return std::string_view(begin, static_cast<std::size_t>(p - begin));
  }
  // The rest of the line, as it can be quoted.
  std::string rest() const
  {
    const char* end = last;
    while (end != p && is_white(end[-1]))
      --end;
    std::string text(p, end);
    std::replace(text.begin(), text.end(), '\t', ' ');
    return text;
  }

private:
  Text_lines(const std::string& path, const std::uintmax_t size, const Progress_function& progress, const Text_encoding& encoding)
    : file_(path, size, encoding.begin, progress, encoding.line_end)
  {
  }

  File_blocks file_;
  std::size_t number_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_TEXT_LINES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What CGAL's reader does not understand of an OBJ file though it is valid there.

#ifndef IDT_FORMATS_OBJ_FILTER_H
#define IDT_FORMATS_OBJ_FILTER_H

#include "input/formats/Text_check.h"

#include <algorithm>

namespace idt {

// Makes comments of polylines (`l 1 2`) and of lines that carry on what is no vertex and no face, behind a backslash; turns tabs into spaces, as
// CGAL's reader loses the corners of a face behind a tab. The text comes in pieces.
class Obj_filter
{
public:
  void operator()(char* const first, char* const last)
  {
    std::replace(first, last, '\t', ' ');
    for (char* p = first; p != last;) {
      if (is_at_start_ && (p = std::find_if(p, last, [](char c) { return c != ' ' && c != '\r'; })) != last && *p != '\n')
        begin_line(p, last);
      char* const end = std::find(p, last, '\n');
      for (const char* q = end; q != p;)
        if (*--q != '\r') {
          last_character_ = *q;
          break;
        }
      if (end == last)
        return;
      is_continued_ = !is_at_start_ && is_other_ && last_character_ == '\\';
      is_at_start_ = true;
      p = end + 1;
    }
  }

private:
  void begin_line(char* const p, const char* const last)
  {
    is_at_start_ = false;
    is_other_ = is_continued_ || (*p != 'v' && *p != 'f' && *p != '#');
    if (is_continued_ || (*p == 'l' && (p + 1 == last || is_white(p[1]))))
      *p = '#';
  }

  bool is_at_start_ = true;   // only blanks have come since the last line ended
  bool is_other_ = false;     // the line is no vertex, face or comment
  bool is_continued_ = false; // the last line was of that kind, and goes on
  char last_character_ = 0;   // that has come, carriage returns aside
};

} // namespace idt

#endif // IDT_FORMATS_OBJ_FILTER_H

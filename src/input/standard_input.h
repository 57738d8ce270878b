// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The standard input, named "-", as a file: readers go through a file more than once, and its name tells the format.

#ifndef IDT_STANDARD_INPUT_H
#define IDT_STANDARD_INPUT_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <string>

namespace idt {

// The file to read for a name on the command line: that file, or for "-" a temporary one with the contents of the
// standard input, whose extension tells their format.
// \exception Invalid_surface_error if the format is not recognized, or the file cannot be created
// \exception Cancelled_error if the command is interrupted
std::string readable_file(const std::string& path);

// A message with "-" in place of the name of that temporary file.
std::string with_shown_names(std::string message);

// \exception Invalid_surface_error that says why a file cannot be read
[[noreturn]] inline void refuse_file(const std::string& path, const std::string& text)
{
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, 0, 1, path + ": " + text);
}

} // namespace idt

#endif // IDT_STANDARD_INPUT_H

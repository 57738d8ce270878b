// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a broken file could do to the readers of CGAL is found before they see it; why a file
// could not be read is found afterwards.

#ifndef IDT_FORMATS_CHECKS_H
#define IDT_FORMATS_CHECKS_H

#include "input/formats/Text_check.h"

#include <cstdint>
#include <string>

namespace idt {

// The size of a regular file that can be opened. A device or a pipe may have no end, or no beginning.
// \exception Invalid_surface_error if it is none
std::uintmax_t check_file(const std::string& path);

// Refuses what the lines of no text format can begin with.
// \exception Invalid_surface_error as all others
void check_encoding(const std::string& path);

// Each compares what a header announces, and what CGAL's reader would trust, with the file, and says how
// the rest is to be read: with a look at each line, or in another form in place of the file. OFF loses its
// colors and textures, TS the numbers of its vertices: these are not for CGAL's reader.
// \exception Invalid_surface_error if the two do not agree
Prepared_text check_off(const std::string& path, std::uintmax_t file_size);
Prepared_text check_obj(const std::string& path);
Prepared_text check_ply(const std::string& path, std::uintmax_t file_size);
Prepared_text check_stl(const std::string& path, std::uintmax_t file_size);
Prepared_text check_ts(const std::string& path);

// Each goes through a text and refuses the first element that is not as it should be; returns
// if there is none.
void diagnose_off(const std::string& path, const std::string& text);
void diagnose_stl(const std::string& path, const std::string& text);

// OBJ and PLY: lets CGAL's reader try once more, on a stream that tells where it stopped.
void diagnose_by_position(const std::string& path, const std::string& extension);

} // namespace idt

#endif // IDT_FORMATS_CHECKS_H

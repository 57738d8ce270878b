// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a broken file could do to the readers of CGAL is found before they see it; why a file
// could not be read is found afterwards.

#ifndef IDT_FORMATS_CHECKS_H
#define IDT_FORMATS_CHECKS_H

#include <cstdint>
#include <optional>
#include <string>

namespace idt {

// Returns the same surface without colors and textures if the file has any: these are not for CGAL's
// reader.
// \exception Invalid_surface_error as the others
std::optional<std::string> check_off(const std::string& path, std::uintmax_t file_size);

// Each compares what a header announces, and what CGAL's reader would trust, with the file.
// \exception Invalid_surface_error if the two do not agree
void check_ply(const std::string& path);
void check_stl(const std::string& path, std::uintmax_t file_size);

// Each goes through a text and refuses the first element that is not as it should be; returns
// if there is none.
void diagnose_off(const std::string& path, const std::string& text);
void diagnose_stl(const std::string& path, const std::string& text);

// OBJ, PLY and TS: lets CGAL's reader try once more, on a stream that tells where it stopped.
void diagnose_by_position(const std::string& path, const std::string& extension);

} // namespace idt

#endif // IDT_FORMATS_CHECKS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A reader for each format: one pass that checks and reads.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FORMATS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FORMATS_H

#include <CGAL/Intrinsic_triangulations/Progress_function.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <cstdint>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Each appends what a file holds to an empty soup.
// \param size the size of the file in bytes
// \exception Invalid_surface_error at the first line or element that is not as it should be
// \exception Cancelled_error if `progress` returns false
void read_off(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup);
void read_obj(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup);
void read_ply(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup);
void read_stl(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup);
void read_ts(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup);

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_FORMATS_H

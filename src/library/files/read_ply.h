// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// PLY, text or binary: elements with properties; coordinates and corners are read, others skipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H

#include "Ply_binary_reader.h"
#include "Ply_text_reader.h"
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <boost/endian/conversion.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

// The first line tells how the lines of the header end: the data after it may not be text.
inline Text_encoding find_ply_encoding(const std::string& path)
{
  Text_encoding result = find_encoding(path);
  const std::string head = load_file(path, 1000);
  const std::size_t end = head.find_first_of("\r\n");
  result.line_end = end != std::string::npos && head[end] == '\r' && head.compare(end, 2, "\r\n") != 0 ? '\r' : '\n';
  return result;
}

inline void read_ply(const std::string& path, const std::uintmax_t size, const Progress_function& progress,
                     Polygon_soup& soup)
{
  const Text_encoding encoding = find_ply_encoding(path);
  Ply_header header = read_ply_header(path, encoding);
  find_roles(path, header.elements, soup);
  check_counts(path, header, size);
  if (header.format == "ascii")
    return Ply_text_reader(path, header, soup, size, progress, encoding.line_end).read();
  File_blocks file(path, size, header.bytes, progress);
  if (header.format == "binary_little_endian")
    Ply_binary_reader<boost::endian::order::little>(path, header, soup, file).read();
  else
    Ply_binary_reader<boost::endian::order::big>(path, header, soup, file).read();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_READ_PLY_H

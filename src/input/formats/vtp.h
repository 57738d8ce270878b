// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// VTP, the polygons of VTK and ParaView in XML. Reading text, base64, raw bytes and compression takes VTK, if the
// command is built with it; writing one of these forms takes no library.

#ifndef IDT_FORMATS_VTP_H
#define IDT_FORMATS_VTP_H

#include "input/mesh_file.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace idt {

// \exception Invalid_surface_error if VTK cannot read the file, or if it holds cells other than polygons
CGAL::Intrinsic_triangulations::Polygon_soup read_vtp(const std::string& path);

// Polygon or polyline i has the corners from ends[i - 1] up to, but not including, ends[i].
struct Flat_polygons
{
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> ends;

  template <class Range>
  void add(const Range& polygon)
  {
    corners.insert(corners.end(), polygon.begin(), polygon.end());
    ends.push_back(corners.size());
  }
};

// Writes text, coordinates as Float64, all numbers with all their digits. VTK's reader knows no infinite values in
// text: the largest finite one stands for them.
// \param at_cells values of the lines, followed by values of the polygons
void write_vtp(std::ostream& os, const std::vector<std::array<double, 3>>& points, const Flat_polygons& polygons,
               const std::vector<Named_values>& at_points = {}, const Flat_polygons& lines = {},
               const std::vector<Named_values>& at_cells = {});

} // namespace idt

#endif // IDT_FORMATS_VTP_H

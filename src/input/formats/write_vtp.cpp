// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/vtp.h"

#include "system/Long_text.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

namespace idt {
namespace {

void write_array(std::ostream& os, const Named_values& array)
{
  os << "<DataArray type=\"" << array.type << "\" Name=\"" << array.name << '"';
  if (array.components > 1)
    os << " NumberOfComponents=\"" << array.components << '"';
  os << " format=\"ascii\">\n";
  write_elements(os, array.values.size(), [&array](Long_text& text, std::size_t i) {
    text << (std::min)(array.values[i], (std::numeric_limits<double>::max)())
         << ((i + 1) % array.components == 0 ? '\n' : ' ');
  });
  os << "</DataArray>\n";
}

// Programs show the first array by default.
void write_data(std::ostream& os, const std::string& element, const std::vector<Named_values>& arrays)
{
  if (arrays.empty())
    return;
  os << '<' << element << " Scalars=\"" << arrays.front().name << "\">\n";
  for (const Named_values& array : arrays)
    write_array(os, array);
  os << "</" << element << ">\n";
}

void write_cells(std::ostream& os, const std::string& element, const Flat_polygons& cells)
{
  os << '<' << element << ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  write_elements(os, cells.ends.size(), [&cells](Long_text& text, std::size_t i) {
    for (std::size_t c = i == 0 ? 0 : cells.ends[i - 1]; c < cells.ends[i]; ++c)
      text << cells.corners[c] << (c + 1 == cells.ends[i] ? '\n' : ' ');
  });
  os << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  write_elements(os, cells.ends.size(), [&cells](Long_text& text, std::size_t i) { text << cells.ends[i] << '\n'; });
  os << "</DataArray>\n</" << element << ">\n";
}

} // namespace

// CGAL's writer is for triangles only: it announces three corners for each face, however many there are.
void write_vtp(std::ostream& os, const std::vector<std::array<double, 3>>& points, const Flat_polygons& polygons,
               const std::vector<Named_values>& at_points, const Flat_polygons& lines,
               const std::vector<Named_values>& at_cells)
{
  os << "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<PolyData>\n<Piece NumberOfPoints=\""
     << points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"" << lines.ends.size()
     << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << polygons.ends.size() << "\">\n";
  write_data(os, "PointData", at_points);
  write_data(os, "CellData", at_cells);
  os << "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  write_elements(os, points.size(), [&points](Long_text& text, std::size_t i) {
    text << points[i][0] << ' ' << points[i][1] << ' ' << points[i][2] << '\n';
  });
  os << "</DataArray>\n</Points>\n";
  if (!lines.ends.empty())
    write_cells(os, "Lines", lines);
  write_cells(os, "Polys", polygons);
  os << "</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/vtp.h"

#include "system/Long_text.h"

#include <cstddef>

namespace idt {

// CGAL's writer is for triangles alone: it announces three corners for each face, whatever there are.
void write_vtp(std::ostream& os, const std::vector<std::array<double, 3>>& points, const Flat_polygons& polygons,
               const std::vector<Point_values>& at_points)
{
  os << "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
        "<PolyData>\n<Piece NumberOfPoints=\""
     << points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
     << polygons.ends.size()
     << "\">\n";
  if (!at_points.empty()) {
    os << "<PointData Scalars=\"" << at_points.front().name << "\">\n";
    for (const Point_values& at : at_points) {
      os << "<DataArray type=\"Float64\" Name=\"" << at.name << '"';
      if (at.components > 1)
        os << " NumberOfComponents=\"" << at.components << '"';
      os << " format=\"ascii\">\n";
      write_elements(os, at.values.size(), [&at](Long_text& text, std::size_t i) {
        text << at.values[i] << ((i + 1) % at.components == 0 ? '\n' : ' ');
      });
      os << "</DataArray>\n";
    }
    os << "</PointData>\n";
  }
  os << "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  write_elements(os, points.size(), [&points](Long_text& text, std::size_t i) {
    text << points[i][0] << ' ' << points[i][1] << ' ' << points[i][2] << '\n';
  });
  os << "</DataArray>\n</Points>\n<Polys>\n"
        "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  write_elements(os, polygons.ends.size(), [&polygons](Long_text& text, std::size_t f) {
    for (std::size_t c = f == 0 ? 0 : polygons.ends[f - 1]; c < polygons.ends[f]; ++c)
      text << polygons.corners[c] << (c + 1 == polygons.ends[f] ? '\n' : ' ');
  });
  os << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  write_elements(os, polygons.ends.size(), [&polygons](Long_text& text, std::size_t f) { text << polygons.ends[f] << '\n'; });
  os << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace idt

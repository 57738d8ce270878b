// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/formats/vtp.h"

#include "system/text.h"

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
      for (std::size_t i = 0; i < at.values.size(); ++i)
        os << in_full(at.values[i]) << ((i + 1) % at.components == 0 ? '\n' : ' ');
      os << "</DataArray>\n";
    }
    os << "</PointData>\n";
  }
  os << "<Points>\n<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const auto& [x, y, z] : points)
    os << in_full(x) << ' ' << in_full(y) << ' ' << in_full(z) << '\n';
  os << "</DataArray>\n</Points>\n<Polys>\n"
        "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::size_t c = 0;
  for (std::size_t end : polygons.ends)
    for (; c < end; ++c)
      os << polygons.corners[c] << (c + 1 == end ? '\n' : ' ');
  os << "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  for (std::size_t end : polygons.ends)
    os << end << '\n';
  os << "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace idt

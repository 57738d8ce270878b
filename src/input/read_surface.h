// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A polygon file becomes points and polygons, or a message that says what is
// wrong with the file and where.

#ifndef IDT_READ_SURFACE_H
#define IDT_READ_SURFACE_H

#include <CGAL/Intrinsic_triangulations/Progress_function.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idt {

// What a file holds, as it stands there: nothing is merged, turned or left out
// (but STL, which has no vertices, only corners: those at the same position
// are one vertex). The corners of all polygons are in one array.
struct Surface_input
{
  // The corners of one polygon, as a range.
  struct Polygon
  {
    const std::uint32_t* first;
    const std::uint32_t* last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  std::string path;
  std::vector<std::array<double, 3>> points;
  // All faces if all are triangles; empty otherwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  // All faces if not all are triangles; empty otherwise. Polygon i has the
  // corners from first_corner[i] to before first_corner[i + 1].
  std::vector<std::uint32_t> corners;
  std::vector<std::size_t> first_corner;

  bool is_triangulated() const { return first_corner.empty(); }
  std::size_t number_of_faces() const
  {
    return is_triangulated() ? triangles.size() : first_corner.size() - 1;
  }
  // The faces, whatever they are.
  std::vector<Polygon> polygons() const;
  // The corners of a face. \pre face < number_of_faces()
  Polygon polygon(std::size_t face) const
  {
    if (is_triangulated())
      return Polygon{triangles[face].data(), triangles[face].data() + 3};
    return Polygon{corners.data() + first_corner[face], corners.data() + first_corner[face + 1]};
  }
};

// Reads a file with CGAL::IO::read_polygon_soup(): OFF, OBJ, PLY, STL or TS by
// the extension of its name, and VTP if the command was built with VTK.
//
// Coordinates written with 17 digits come back bit for bit, unless the file
// itself says that they are floats (PLY `float`, binary STL).
//
// \param path the name of the file
// \return the points and polygons; whether they are a surface is another
//         question, see examine()
// \exception CGAL::Intrinsic_triangulations::Invalid_surface_error if the file
//            cannot be read; the message begins with `path` and names the line
//            or the element at fault as far as it is known. Broken files lead
//            nowhere else: sizes that a header announces are compared with the
//            size of the file before anything is allocated for them.
// \exception CGAL::Intrinsic_triangulations::Cancelled_error if `progress` returns false
// Complexity: linear in the size of the file (STL: a search for each corner).
Surface_input read_surface(const std::string& path,
                           const CGAL::Intrinsic_triangulations::Progress_function& progress = {});

// Examines what was read.
// \return the report of CGAL::Intrinsic_triangulations::examine_polygons()
// Complexity: linear
CGAL::Intrinsic_triangulations::Surface_report examine(const Surface_input& input);

} // namespace idt

#endif // IDT_READ_SURFACE_H

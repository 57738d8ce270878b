// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a polygon file as points and polygons, or says what is wrong with it and where.

#ifndef IDT_READ_SURFACE_H
#define IDT_READ_SURFACE_H

#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <string>

namespace idt {

// The contents of a file.
struct Surface_input : CGAL::Intrinsic_triangulations::Polygon_soup
{
  std::string path;
};

// Reads a file with CGAL::Intrinsic_triangulations::read_polygon_soup(), and throws as that does; reads VTP if the
// command was built with VTK.
//
// \param path the name of the file
// \return the points and polygons; examine() tells whether they are a surface
Surface_input read_surface(const std::string& path,
                           const CGAL::Intrinsic_triangulations::Progress_function& progress = {});

// The same with progress on the terminal; warnings about the file go to the standard error.
// \exception Cancelled_error if an interruption ends the reading
Surface_input read_and_warn(const std::string& path);

// Examines the polygons.
// \return the report of CGAL::Intrinsic_triangulations::examine_polygons()
// Complexity: linear
CGAL::Intrinsic_triangulations::Surface_report examine(const Surface_input& input);

} // namespace idt

#endif // IDT_READ_SURFACE_H

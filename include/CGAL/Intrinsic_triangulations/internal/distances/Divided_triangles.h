// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Triangles with vertices at some of their points.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DIVIDED_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DIVIDED_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// All triangles at an edge are divided at a point of it, however many there are. New vertices are rounded.
class Divided_triangles
{
public:
  // \pre the vertices of all triangles exist
  Divided_triangles(Points points, std::vector<Index_triangle> triangles);

  // \return the vertex at a point of the given triangles
  // \exception Invalid_point_error if it is not a point of one of them
  std::uint32_t vertex_at(const Point_in_triangle& p);

  const Points& points() const { return points_; }
  const std::vector<Index_triangle>& triangles() const { return triangles_; }
  // A point of a divided triangle in the given one.
  Point_in_triangle in_given_triangle(const Point_in_triangle& p) const;

private:
  struct Part
  {
    std::size_t triangle;                         // the given one
    std::array<std::array<double, 3>, 3> corners; // in barycentric coordinates of that
  };

  std::uint32_t add_vertex(std::size_t i, const std::array<double, 3>& coordinates);

  Points points_;
  std::vector<Index_triangle> triangles_; // those that were given, or a part of each, come first
  std::vector<Part> parts_;
  std::size_t number_of_given_;
};

// \exception Invalid_point_error if the triangle does not exist, or its coordinates are no point of it
// \return the point; within rounding of an edge, on it
Point_in_triangle checked_point(const Point_in_triangle& p, std::size_t number_of_triangles);

// A point of the input of a cover in the triangle below it.
// \param points of the triangles; may be empty for a cover by lengths, which has no cuts
Point_in_triangle point_below_cover(const Tufted_cover& cover, const Points& points,
                                    const std::vector<Index_triangle>& triangles, const Surface_point& p);

// A vertex of a cover in a triangle that has it on its border, and that may have no area.
Point_in_triangle vertex_below_cover(const Tufted_cover& cover, const Points& points,
                                     const std::vector<Index_triangle>& triangles, std::size_t triangle,
                                     Vertex_index v);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_DIVIDED_TRIANGLES_H

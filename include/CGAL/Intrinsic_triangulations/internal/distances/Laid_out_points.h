// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points of a surface, relative to the sides of the faces that they lie in.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_POINTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>

#include <CGAL/Iterator_range.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Laid_out_points
{
public:
  static constexpr std::uint32_t none = Laid_out_faces::none;

  // A point relative to each side of its face, from where the side begins.
  struct Point
  {
    std::array<std::array<double, 2>, 3> at;
    std::uint32_t number, face;
    std::uint32_t row; // of the vertex that the point is, or none
  };

  // \param points of `complex`, which the faces belong to; those without a halfedge are nowhere
  Laid_out_points(const Laid_out_faces& faces, const Delta_complex& complex, const std::vector<Surface_point>& points);

  std::size_t size() const { return place_of_.size(); }
  // Nothing for a point that is nowhere.
  const Point* find(std::uint32_t number) const
  {
    return place_of_[number] == none ? nullptr : &points_[place_of_[number]];
  }
  Iterator_range<const Point*> in_face(std::uint32_t face) const
  {
    return {points_.data() + first_[face], points_.data() + first_[face + 1]};
  }

private:
  std::vector<Point> points_;                   // by face
  std::vector<std::uint32_t> first_, place_of_; // of a face, and of a number
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LAID_OUT_POINTS_H

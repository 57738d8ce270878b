// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points of a surface as arrays: the number of a face, and three coordinates for its corners in order.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H

#include "python/arrays.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace idt_python {

// The points of a result.
class Point_table
{
public:
  // \param first_side the side of the face that begins at its first corner
  void append(const CGAL::Intrinsic_triangulations::Delta_complex& complex,
              const CGAL::Intrinsic_triangulations::Surface_point& point,
              CGAL::Intrinsic_triangulations::Halfedge_index first_side)
  {
    faces_.push_back(complex.face(first_side).idx());
    for (double x : CGAL::Intrinsic_triangulations::coordinates_from(complex, point, first_side))
      coordinates_.push_back(x);
  }

  py::tuple to_arrays() { return py::make_tuple(to_array(std::move(faces_)), to_array(std::move(coordinates_), 3)); }

private:
  std::vector<std::int64_t> faces_;
  std::vector<double> coordinates_;
};

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SURFACE_POINTS_H

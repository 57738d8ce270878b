// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest angle and the largest circumradius.

#ifndef IDT_KERNELS_SUMMARIZE_SHAPES_H
#define IDT_KERNELS_SUMMARIZE_SHAPES_H

#include "kernels/Kernel.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/angles.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace idt {

// \param unrefined faces that are left out of the minimum of the others
// \return nothing for a triangulation without faces
template <class Triangulation>
std::optional<Shape_summary> summarize_shapes(const Triangulation& triangulation,
                                              const std::vector<CGAL::Intrinsic_triangulations::Unrefined_face>& unrefined)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const IT::Delta_complex& complex = triangulation.connectivity();
  if (complex.number_of_faces() == 0)
    return std::nullopt;
  std::vector<bool> is_listed(complex.number_of_faces());
  for (const IT::Unrefined_face& f : unrefined)
    is_listed[f.face.idx()] = true;
  const std::vector<double> angles = IT::opposite_angles(triangulation, 0x1p-24); // more digits than are looked at
  Shape_summary summary;
  summary.minimum_angle = 180;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    IT::Halfedge_index opposite = h;
    double smallest = angles[h.idx()];
    for (IT::Halfedge_index side : {complex.next(h), complex.prev(h)}) {
      const double angle = angles[side.idx()];
      if (angle < smallest) {
        smallest = angle;
        opposite = side;
      }
    }
    const double degrees = smallest * (180 / CGAL_PI);
    summary.minimum_angle = (std::min)(summary.minimum_angle, degrees);
    if (!is_listed[f.idx()])
      summary.minimum_refined_angle = (std::min)(summary.minimum_refined_angle.value_or(degrees), degrees);
    // The smallest angle is at most 60 degrees, where a sine is accurate.
    const double radius = smallest > 0 ? CGAL::to_double(triangulation.length(complex.edge(opposite))) / (2 * std::sin(smallest))
                                       : (std::numeric_limits<double>::infinity)();
    summary.maximum_circumradius = (std::max)(summary.maximum_circumradius, radius);
  }
  return summary;
}

} // namespace idt

#endif // IDT_KERNELS_SUMMARIZE_SHAPES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Points of a surface, relative to the sides of the faces that they lie in.

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_points.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations::internal {

Laid_out_points::Laid_out_points(const Laid_out_faces& faces, const Delta_complex& complex,
                                 const std::vector<Surface_point>& points)
  : first_(complex.number_of_faces() + 1), place_of_(points.size(), none)
{
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Halfedge_index h = points[i].halfedge;
    if (!h.is_valid())
      continue;
    Point p{{}, std::uint32_t(i), complex.face(h).idx(), none};
    const std::uint32_t base = 3 * p.face;
    const std::array<double, 3> b = coordinates_from(complex, points[i], faces.halfedge(base));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Laid_out_faces::Side& side = faces.side(base + k);
      const double next = b[(k + 1) % 3], prev = b[(k + 2) % 3];
      p.at[k] = {next * side.length + prev * side.apex_x, prev * side.apex_y};
      if (next == 0 && prev == 0)
        p.row = side.row;
    }
    points_.push_back(p);
  }
  std::stable_sort(points_.begin(), points_.end(), [](const Point& p, const Point& q) { return p.face < q.face; });
  for (std::size_t i = 0; i < points_.size(); ++i) {
    place_of_[points_[i].number] = std::uint32_t(i);
    ++first_[points_[i].face + 1];
  }
  for (std::size_t f = 0; f + 1 < first_.size(); ++f)
    first_[f + 1] += first_[f];
}

} // namespace CGAL::Intrinsic_triangulations::internal

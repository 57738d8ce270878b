// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths of edges as doubles, in the unit of the input, and the shapes of faces.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MEASURED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MEASURED_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <class Traits>
class Measured_faces
{
public:
  explicit Measured_faces(Intrinsic_triangulation<Traits>& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity())
  {}

  void measure_all()
  {
    lengths_.resize(complex_.number_of_edges());
    for (Edge_index e : complex_.edges())
      measure(e);
  }
  // Must be called again for changed faces.
  void measure(Edge_index e)
  {
    lengths_[e.idx()] = has_good_length(e) ? std::ldexp(std::sqrt(squared_length(e)), triangulation_.unit_exponent())
                                           : CGAL::to_double(triangulation_.length(e));
  }
  // All edges at v, which may be new; its faces are measured anew first if flips have left inaccurate numbers.
  void measure_star(Vertex_index v)
  {
    lengths_.resize(complex_.number_of_edges());
    bool are_good = true;
    for (Halfedge_index h : Halfedges_around(complex_, v))
      are_good = are_good && has_good_length(complex_.edge(h));
    if (!are_good)
      Whole_triangulation<Traits>(triangulation_).recompute(v);
    for (Halfedge_index h : Halfedges_around(complex_, v))
      measure(complex_.edge(h));
  }
  double length(Edge_index e) const { return lengths_[e.idx()]; }
  double length(Halfedge_index h) const { return length(complex_.edge(h)); }
  Plane_point apex(Halfedge_index h) const
  {
    return third_corner(length(h), length(complex_.next(h)), length(complex_.prev(h)));
  }
  Halfedge_index longest_side(Face_index f) const
  {
    return side_with_largest(complex_, f, [&](Halfedge_index h) { return length(h); });
  }
  Halfedge_index shortest_side(Face_index f) const
  {
    return side_with_largest(complex_, f, [&](Halfedge_index h) { return -length(h); });
  }
  double circumradius(Face_index f) const
  {
    const Halfedge_index h = longest_side(f);
    const double jk = length(complex_.next(h)), ki = length(complex_.prev(h)), height = apex(h).imag();
    return height > 0 ? jk / length(h) * ki / height / 2 : (std::numeric_limits<double>::infinity)();
  }
  double smallest_height(Face_index f) const
  {
    const Halfedge_index h = longest_side(f);
    return apex(h).imag() * length(h);
  }
  // The angle at the source of h, in its face.
  double angle(Halfedge_index h) const
  {
    const Halfedge_index longest = longest_side(complex_.face(h));
    const Plane_point z = apex(longest);
    if (h == longest)
      return std::atan2(z.imag(), z.real());
    if (h == complex_.next(longest))
      return std::atan2(z.imag(), 1 - z.real());
    return CGAL_PI - std::atan2(z.imag(), z.real()) - std::atan2(z.imag(), 1 - z.real());
  }

private:
  double squared_length(Edge_index e) const
  {
    return triangulation_.traits().compute_squared_length_object()(triangulation_.edge_data(e));
  }
  // Whether the numbers kept by flips are accurate to 30 bits.
  bool has_good_length(Edge_index e) const
  {
    double error = (std::numeric_limits<double>::infinity)();
    for (Halfedge_index side : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(side))
        error = (std::min)(error, triangulation_.face_data(complex_.face(side)).error);
    return error <= 0x1p-30 * squared_length(e);
  }

  Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  std::vector<double> lengths_; // of the edges
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_MEASURED_FACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A flat surface cut open and laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Conformal_layout
{
public:
  using Point = std::array<double, 2>;

  // \param lengths in a unit of 2^unit units of the input, as the corners are
  // \param is_inside for each halfedge, whether a part of the surface lies to its left
  // \param is_end for each vertex, whether a cut has to end there: at cones, and on the border
  Conformal_layout(const Delta_complex& complex, const std::vector<double>& lengths, int unit,
                   const std::vector<bool>& is_inside, const std::vector<bool>& is_end);

  // The source of a halfedge, in its face.
  const Point& corner(Halfedge_index h) const { return corners_[h.idx()]; }
  // The point next to p that scaling to the unit of the input does not round.
  Point rounded(const Point& p) const;
  // Whether the surface continues on the other side of an edge, but is cut there.
  bool is_cut(Halfedge_index h) const { return is_inner(complex_.edge(h)) && is_cut_[complex_.edge(h).idx()]; }
  // Whether both images of a cut edge agree to 10^-12 of the size, as those of a slit into a flat surface do.
  bool is_closed_slit(Halfedge_index h) const;
  // Whether all triangles keep their orientation, exactly, and go around each vertex off the cuts once.
  bool is_certified() const;
  // The largest difference between the lengths of the images of a cut edge, or from its length.
  double seam() const;

private:
  bool is_inner(Edge_index e) const
  {
    return is_inside_[complex_.halfedge(e).idx()] && is_inside_[complex_.opposite(complex_.halfedge(e)).idx()];
  }
  bool is_inside(Face_index f) const;
  double length(Halfedge_index h) const { return lengths_[complex_.edge(h).idx()]; }

  void cut(const std::vector<bool>& is_end);
  std::vector<double> distances(const std::vector<bool>& is_end, std::vector<bool>& is_in_tree) const;
  void prune(const std::vector<bool>& is_end);
  void lay_out();
  void lay_out_from(Face_index f, std::vector<bool>& is_placed, std::vector<Face_index>& placed);
  void place_third(Halfedge_index h);
  void merge_corners();

  const Delta_complex& complex_;
  const std::vector<double>& lengths_;
  int unit_;
  const std::vector<bool>& is_inside_;
  std::vector<bool> is_cut_;
  std::vector<Point> corners_;
  double size_ = 0; // the largest coordinate
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_LAYOUT_H

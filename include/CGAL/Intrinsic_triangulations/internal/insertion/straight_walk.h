// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A straight line over the triangles of a surface, in doubles.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_WALK_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace CGAL::Intrinsic_triangulations::internal {

using Plane_point = std::complex<double>;

// The third corner of a triangle with sides of these lengths, where the first side leads from 0 to 1.
inline Plane_point third_corner(double ij, double jk, double ki)
{
  const double b = jk / ij, c = ki / ij, q = squared_four_areas_from_lengths(1., b, c);
  return {(1 + (c - b) * (c + b)) / 2, q > 0 ? std::sqrt(q) / 2 : 0};
}

inline double cross_product(Plane_point a, Plane_point b) { return a.real() * b.imag() - a.imag() * b.real(); }

// The end of a straight line: in the face of a halfedge, with nonnegative weights of its source, its target and the
// third corner, which sum to 1 up to rounding.
struct Walk_end
{
  Halfedge_index halfedge;
  std::array<double, 3> weights;
  Halfedge_index barrier; // if it is valid, the line ends before this halfedge, which belongs to that face
  std::size_t number_of_crossed_edges;
};

// Walks from a point in the face of h to another one, both given in the frame of h: its source is 0, its target 1.
// A triangle without area is crossed from its longest side to another one, or the other way.
// \param leaves_corner whether the walk starts at the source of h, into the triangle
// \param apex gives the third corner of the face of a halfedge, in the frame of that
// \param is_barrier whether an edge that is met must not be crossed
// \param most_edges after this many crossed edges and one more the walk stops, in the middle of the line's part in that
//   triangle: around a needle it could go on for very long, and forever if rounding has made it lose its way
template <class Apex, class Is_barrier>
Walk_end walk_straight(const Delta_complex& complex, Halfedge_index h, Plane_point start, Plane_point end,
                       bool leaves_corner, const Apex& apex, const Is_barrier& is_barrier, std::size_t most_edges)
{
  const auto weights = [](Plane_point z, Plane_point p) {
    const double c = z.imag() != 0 ? p.imag() / z.imag() : 0, b = p.real() - c * z.real();
    return std::array<double, 3>{1 - b - c, b, c};
  };
  const auto inside = [](std::array<double, 3> w) {
    double sum = 0;
    for (double& x : w)
      sum += x = x > 0 ? x : 0;
    for (double& x : w)
      x /= sum;
    return w;
  };
  for (std::size_t crossed = 0;; ++crossed) {
    const Plane_point z = apex(h);
    const std::array<double, 3> w = weights(z, end);
    const bool has_area = z.imag() > 0;
    // Corner i is opposite to the side through which the line leaves, if it does.
    std::size_t i = 0;
    if (crossed > 0) // it came through h
      i = cross_product(end - start, z - start) > 0 ? 0 : 1;
    else if (!leaves_corner && has_area) {
      const std::array<double, 3> from = weights(z, start);
      double first = 2;
      for (std::size_t k = 0; k < 3; ++k)
        if (w[k] < 0) {
          const double x = from[k] > 0 ? from[k] : 0, t = x / (x - w[k]);
          if (t < first) {
            first = t;
            i = k;
          }
        }
    }
    if (has_area ? !(w[i] < 0) : crossed == 0 && !(leaves_corner && z.real() < 0))
      return Walk_end{h, inside(w), {}, crossed};
    const Halfedge_index side = i == 0 ? complex.next(h) : i == 1 ? complex.prev(h) : h;
    if (is_barrier(complex.edge(side)))
      return Walk_end{h, inside(w), side, crossed};
    const Plane_point corners[3] = {0, 1, z}, left = corners[(i + 2) % 3], right = corners[(i + 1) % 3];
    if (crossed > most_edges) {
      const Plane_point to_end = end - start, entry = start - start.imag() / to_end.imag() * to_end;
      const double t = cross_product(left - entry, right - left) / cross_product(to_end, right - left);
      return Walk_end{h, inside(weights(z, entry + t / 2 * to_end)), {}, crossed};
    }
    start = (start - left) / (right - left);
    end = (end - left) / (right - left);
    h = complex.opposite(side);
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STRAIGHT_WALK_H

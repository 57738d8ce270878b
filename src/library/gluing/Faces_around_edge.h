// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The order of faces around an edge in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H

#include "../measures/Flat_geometry.h"
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The faces at the edge from u to v in space, in the order in which a half-plane that turns counterclockwise about u→v
// meets them. The cyclic order is decided exactly. It does not depend on numbering, on the orientation of faces, or on
// rotations in space, as far as possible:
//
// - Faces in one half-plane are ordered by where along the edge their third vertices lie, from u to v; at the same
//   place, by the distance of the third vertex from the edge, the nearer first if the place is beyond the middle.
//   Exchanging u and v reverses all of this, so the cyclic order is the same for both directions.
// - Faces with the same corners lie on top of each other like sheets of paper, in the order of their numbers.
// - A face without area lies in the half-plane of the face whose third vertex is farthest from the edge.
// - Numbers break the remaining ties: isosceles triangles over the same edge in one half-plane, third vertices at the
//   same place, and several farthest faces. There a rotation in space exchanges the ends of the edge.
class Faces_around_edge
{
public:
  // The position of a half-plane relative to the first one: in front means counterclockwise, by less than π.
  enum Sector {
    SAME,
    IN_FRONT,
    OPPOSITE,
    BEHIND
  };

  struct Face
  {
    std::uint32_t third_vertex;
    std::uint32_t side;   // the caller's number; orders the sheets
    Sector sector = SAME; // found by sort()
  };

  // \pre u < v are at different places, and the third vertices at places different from these
  Faces_around_edge(const Points& points, std::uint32_t u, std::uint32_t v) : points_(points), u_(u), v_(v) {}

  void sort(std::vector<Face>& faces)
  {
    const std::uint32_t reference = find_reference(faces);
    for (Face& f : faces)
      f.sector = sector(reference, f.third_vertex);
    std::sort(faces.begin(), faces.end(), [this](const Face& a, const Face& b) { return precedes(a, b); });
  }

  // Whether both faces are in the same half-plane. A face without area is in every half-plane.
  bool are_in_one_half_plane(const Face& a, const Face& b) const
  {
    return sector(a.third_vertex, b.third_vertex) == SAME;
  }
  bool is_on_edge_line(const Face& a) const { return is_on_edge_line(a.third_vertex); }

private:
  // The first of the vertices farthest from the line through the edge, if one vertex is on that line; otherwise any.
  std::uint32_t find_reference(const std::vector<Face>& faces) const
  {
    std::uint32_t reference = faces[0].third_vertex;
    const bool has_area =
      std::none_of(faces.begin(), faces.end(), [this](const Face& f) { return is_on_edge_line(f.third_vertex); });
    if (has_area)
      return reference;
    for (const Face& f : faces) {
      const Sign sign = compare_distances(f.third_vertex, reference);
      if (sign == POSITIVE || (sign == ZERO && f.third_vertex < reference))
        reference = f.third_vertex;
    }
    return reference;
  }

  Sector sector(std::uint32_t reference, std::uint32_t w) const
  {
    if (w == reference)
      return SAME;
    const Sign sign = orientation(reference, w);
    if (sign != ZERO)
      return sign == POSITIVE ? IN_FRONT : BEHIND;
    const Vertex_index u(u_), v(v_), r(reference), x(w);
    return sign_of_normals(points_, {u, v}, {u, r}, {u, v}, {u, x}) == NEGATIVE ? OPPOSITE : SAME;
  }

  bool precedes(const Face& a, const Face& b) const
  {
    if (a.sector != b.sector)
      return a.sector < b.sector;
    if (a.sector == IN_FRONT || a.sector == BEHIND) {
      const Sign sign = a.third_vertex == b.third_vertex ? ZERO : orientation(a.third_vertex, b.third_vertex);
      if (sign != ZERO)
        return sign == POSITIVE;
    }
    return precedes_in_half_plane(a, b);
  }

  bool precedes_in_half_plane(const Face& a, const Face& b) const
  {
    const std::uint32_t w = a.third_vertex, x = b.third_vertex;
    if (w == x) {
      // A sheet with a larger number is further out, seen from the side on which smallest, middle and largest vertex
      // are counterclockwise. This is forward about u→v unless w is the middle one.
      const bool is_backward = u_ < w && w < v_;
      return is_backward ? b.side < a.side : a.side < b.side;
    }
    const auto vector = [this](std::uint32_t i, std::uint32_t j) {
      return difference<Exact_ring>(points_, Vertex_index(i), Vertex_index(j));
    };
    const auto edge = vector(u_, v_), from_u = vector(u_, w), from_v = vector(v_, w);
    const Sign along = CGAL::sign(scalar_product(edge, vector(x, w)));
    if (along != ZERO)
      return along == NEGATIVE;
    // Positive beyond the middle. With equal feet, distances from u compare like those from the edge.
    const Sign beyond = CGAL::sign(scalar_product(edge, from_u) + scalar_product(edge, from_v));
    const auto other = vector(u_, x);
    const Sign farther = CGAL::sign(scalar_product(from_u, from_u) - scalar_product(other, other));
    if (beyond != ZERO && farther != ZERO)
      return beyond != farther;
    return farther != ZERO ? farther == NEGATIVE : w < x;
  }

  // Positive if x is in front of the half-plane of w.
  Sign orientation(std::uint32_t w, std::uint32_t x) const
  {
    const auto a = from_u<double>(v_), b = from_u<double>(w), c = from_u<double>(x);
    const double volume = scalar_product(cross_product(a, b), c);
    const double size = sum_of_absolute_values(a) * sum_of_absolute_values(b) * sum_of_absolute_values(c);
    // It errs by less than 2^-48 of `size`. If two coordinates underflow, this is multiplied by the third.
    if (std::abs(volume) > 0x1p-48 * size + 1e-290 && sum_of_absolute_values(c) < 1e30)
      return volume > 0 ? POSITIVE : NEGATIVE;
    return CGAL::sign(scalar_product(normal(w), from_u<Exact_ring>(x)));
  }

  // Compares the distances from the line through the edge.
  Sign compare_distances(std::uint32_t w, std::uint32_t x) const
  {
    const auto m = normal(w), n = normal(x);
    return CGAL::sign(scalar_product(m, m) - scalar_product(n, n));
  }

  template <class Number>
  Vector_3<Number> from_u(std::uint32_t w) const
  {
    return difference<Number>(points_, Vertex_index(u_), Vertex_index(w));
  }
  Vector_3<Exact_ring> normal(std::uint32_t w) const
  {
    return cross_product(from_u<Exact_ring>(v_), from_u<Exact_ring>(w));
  }

  bool is_on_edge_line(std::uint32_t w) const { return are_collinear(points_[u_], points_[v_], points_[w]); }

  const Points& points_;
  const std::uint32_t u_, v_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H

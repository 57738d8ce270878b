// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The directions of faces in space, where slivers have none of their own.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FACE_DIRECTIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FACE_DIRECTIONS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The direction of each face; that of a thin face is taken from beyond its longest side.
class Face_directions
{
public:
  using Points = std::vector<std::array<double, 3>>;
  using Vector = std::array<double, 3>;

  Face_directions(const Delta_complex& complex, const Points& points, double thickness)
    : complex_(complex), points_(points), groups_(complex.number_of_faces()), directions_(complex.number_of_faces())
  {
    std::vector<bool> is_thin(complex.number_of_faces());
    for (Face_index f : complex.faces()) {
      is_thin[f.idx()] = !(height(f) >= thickness);
      if (!is_thin[f.idx()])
        directions_[f.idx()] = normal(f);
    }
    join_thin_faces(is_thin);
  }

  // A zero vector if no face with a direction is connected to f.
  const Vector& operator()(Face_index f) { return directions_[groups_.find(f.idx())]; }

  // Half the vector along h, which is finite.
  Vector half_side(Halfedge_index h) const
  {
    const Vector &p = points_[complex_.source(h).idx()], &q = points_[complex_.target(h).idx()];
    return {q[0] / 2 - p[0] / 2, q[1] / 2 - p[1] / 2, q[2] / 2 - p[2] / 2};
  }
  double length(Halfedge_index h) const
  {
    const Vector v = half_side(h);
    return 2 * std::hypot(v[0], v[1], v[2]);
  }

  // Of length 1, lest squares overflow or vanish; zero stays zero.
  static Vector normalized(Vector v)
  {
    const double largest = (std::max)({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    if (!(largest > 0))
      return {};
    for (double& x : v)
      x /= largest;
    const double norm = std::hypot(v[0], v[1], v[2]);
    for (double& x : v)
      x /= norm;
    return v;
  }

  // The height of the face of h over it.
  double height_over(Halfedge_index h) const
  {
    const Vector across = cross_product(normalized(half_side(h)), normalized(half_side(complex_.next(h))));
    return std::hypot(across[0], across[1], across[2]) * length(complex_.next(h));
  }

private:
  // The smallest height.
  double height(Face_index f) const
  {
    const Halfedge_index h = side_with_largest(complex_, f, [&](Halfedge_index side) { return length(side); });
    const Vector across = cross_product(normalized(half_side(h)), normalized(half_side(complex_.next(h))));
    return std::hypot(across[0], across[1], across[2]) * length(complex_.next(h));
  }
  Vector normal(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    return normalized(cross_product(normalized(half_side(h)), normalized(half_side(complex_.next(h)))));
  }

  // Across the longest edges first; a group has at most one face with a direction of its own.
  void join_thin_faces(const std::vector<bool>& is_thin)
  {
    struct Crossing
    {
      double length;
      Edge_index edge;
    };
    std::vector<Crossing> crossings;
    const auto face = [this](Halfedge_index h) { return complex_.face(h).idx(); };
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e), opposite = complex_.opposite(h);
      if (!complex_.is_border(e) && (is_thin[face(h)] || is_thin[face(opposite)]))
        crossings.push_back({length(h), e});
    }
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.length > b.length; });
    std::vector<bool> has_direction(is_thin);
    has_direction.flip();
    for (const Crossing& crossing : crossings) {
      const Halfedge_index h = complex_.halfedge(crossing.edge);
      const std::uint32_t a = groups_.find(face(h)), b = groups_.find(face(complex_.opposite(h)));
      if (a == b || (has_direction[a] && has_direction[b]))
        continue;
      groups_.unite(a, b);
      const std::uint32_t root = groups_.find(a);
      directions_[root] = directions_[has_direction[a] ? a : b];
      has_direction[root] = has_direction[a] || has_direction[b];
    }
  }

  const Delta_complex& complex_;
  const Points& points_;
  Disjoint_sets groups_; // of faces
  std::vector<Vector> directions_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_FACE_DIRECTIONS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of surface_features.h: sharp edges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SHARP_EDGES_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SHARP_EDGES_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

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

private:
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

inline void drop_short_chains(const Delta_complex& complex, const Face_directions& directions, double minimum_length,
                              std::vector<bool>& is_sharp)
{
  Disjoint_sets chains(complex.number_of_vertices());
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()])
      chains.unite(complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx());
  std::vector<double> lengths(complex.number_of_vertices());
  const auto chain = [&](Edge_index e) { return chains.find(complex.source(complex.halfedge(e)).idx()); };
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()])
      lengths[chain(e)] += directions.length(complex.halfedge(e));
  for (Edge_index e : complex.edges())
    if (is_sharp[e.idx()] && lengths[chain(e)] < minimum_length)
      is_sharp[e.idx()] = false;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
double coordinate_spacing(const std::vector<std::array<double, 3>>& points)
{
  double largest = 0;
  bool are_floats = true;
  for (const auto& p : points)
    for (double x : p) {
      largest = (std::max)(largest, std::abs(x));
      are_floats = are_floats && std::abs(x) <= double((std::numeric_limits<float>::max)()) && double(float(x)) == x;
    }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return largest > 0 ? std::ldexp(1., exponent - (are_floats ? 24 : 53)) : 0;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<bool> sharp_edges(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                              double degrees, double minimum_size)
{
  const internal::Standard_arithmetic arithmetic;
  internal::Face_directions directions(complex, points, (std::max)(minimum_size, 4 * coordinate_spacing(points)));
  std::vector<bool> result(complex.number_of_edges());
  for (Edge_index e : complex.edges()) {
    if (complex.is_border(e))
      continue;
    const Halfedge_index h = complex.halfedge(e);
    const auto &m = directions(complex.face(h)), &n = directions(complex.face(complex.opposite(h)));
    const auto across = internal::cross_product(m, n);
    result[e.idx()] = std::atan2(std::hypot(across[0], across[1], across[2]), internal::scalar_product(m, n)) >
                      degrees * (CGAL_PI / 180);
  }
  internal::drop_short_chains(complex, directions, minimum_size, result);
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_SHARP_EDGES_IMPL_H

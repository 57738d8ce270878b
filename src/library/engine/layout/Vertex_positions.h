// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The positions of vertices in space, including inserted ones.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_VERTEX_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_VERTEX_POSITIONS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include "../../measures/Flat_geometry.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

template <class FT>
Vector_3<FT> minus(const Vector_3<FT>& p, const Vector_3<FT>& q)
{
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}

// Vertices of the input lie at their points, inserted ones at the weighted means of the corners of an input face, with
// their barycentric coordinates as weights: exact rational numbers. They are kept in double-doubles with error bounds,
// and computed anew in exact numbers.
class Vertex_positions
{
public:
  // The cached positions of the inserted vertices, in their order.
  using Inserted = std::vector<Vector_3<Bounded_double_double>>;

  // \param input the input, and its points
  // \param locations where the inserted vertices lie on it
  // \param inserted the double-doubles of the inserted vertices
  Vertex_positions(const Delta_complex& input, const Points& points, const std::vector<Surface_point>& locations,
                   const Inserted& inserted)
    : input_(input), points_(points), locations_(locations), inserted_(inserted)
  {}

  const Delta_complex& input() const { return input_; }
  const Points& points() const { return points_; }
  bool is_inserted(Vertex_index v) const { return v.idx() >= points_.size(); }
  // Whether a corner of the face of h was inserted.
  bool has_inserted_corner(const Delta_complex& complex, Halfedge_index h) const
  {
    return !inserted_.empty() && (is_inserted(complex.source(h)) || is_inserted(complex.target(h)) ||
                                  is_inserted(complex.target(complex.next(h))));
  }

  // A positive multiple of the vector from one vertex to another: the vector itself unless FT is exact and has no
  // division.
  template <class FT>
  Vector_3<FT> direction(Vertex_index from, Vertex_index to) const
  {
    if (!is_inserted(from) && !is_inserted(to))
      return difference<FT>(points_, from, to);
    if constexpr (std::is_same<FT, Bounded_double_double>::value) {
      const auto kept = [&](Vertex_index v) {
        return is_inserted(v) ? inserted_[v.idx() - points_.size()]
                              : Vector_3<FT>{points_[v.idx()][0], points_[v.idx()][1], points_[v.idx()][2]};
      };
      return minus(kept(to), kept(from));
    } else {
      const auto homogeneous = [&](Vertex_index v) {
        const auto convert = [](double x) { return FT(x); };
        if (is_inserted(v))
          return weighted_sum<FT>(locations_[v.idx() - points_.size()], convert);
        const auto& p = points_[v.idx()];
        return Weighted_sum<FT>{FT(1), {FT(p[0]), FT(p[1]), FT(p[2])}};
      };
      const Weighted_sum<FT> a = homogeneous(from), b = homogeneous(to);
      if (a.weight == b.weight)
        return minus(b.sum, a.sum);
      return {a.weight * b.sum[0] - b.weight * a.sum[0], a.weight * b.sum[1] - b.weight * a.sum[1],
              a.weight * b.sum[2] - b.weight * a.sum[2]};
    }
  }

  // The position in a number type with division, to which `convert` converts doubles.
  template <class Convert>
  auto position(Vertex_index v, const Convert& convert) const
  {
    using FT = decltype(convert(0.));
    using Vector = Vector_3<FT>;
    if (!is_inserted(v)) {
      const auto& p = points_[v.idx()];
      return Vector{convert(p[0]), convert(p[1]), convert(p[2])};
    }
    return position(locations_[v.idx() - points_.size()], convert);
  }
  // The same for a point on the input.
  template <class Convert>
  auto position(const Surface_point& location, const Convert& convert) const
  {
    using FT = decltype(convert(0.));
    const auto [weight, sum] = weighted_sum<FT>(location, convert);
    return Vector_3<FT>{FT(sum[0] / weight), FT(sum[1] / weight), FT(sum[2] / weight)};
  }

  // The position to cache for a new vertex.
  Vector_3<Bounded_double_double> rounded(const Surface_point& location) const
  {
    const auto [weight, sum] =
      weighted_sum<Bounded_double_double>(location, [](double x) { return Bounded_double_double(x); });
    if (weight.hi() == 1 && weight.lo() == 0 && weight.error() == 0)
      return sum;
    return {sum[0] / weight, sum[1] / weight, sum[2] / weight};
  }

private:
  template <class FT>
  struct Weighted_sum
  {
    FT weight;
    Vector_3<FT> sum;
  };

  template <class FT, class Convert>
  Weighted_sum<FT> weighted_sum(const Surface_point& location, const Convert& convert) const
  {
    const FT zero = convert(0);
    Weighted_sum<FT> result{zero, {zero, zero, zero}};
    Halfedge_index h = location.halfedge;
    for (double x : location.coordinates) {
      if (x != 0) {
        const FT weight = convert(x);
        result.weight = result.weight + weight;
        const auto& p = points_[input_.source(h).idx()];
        for (std::size_t c = 0; c < 3; ++c)
          result.sum[c] = result.sum[c] + weight * convert(p[c]);
      }
      h = input_.next(h);
    }
    return result;
  }

  const Delta_complex& input_;
  const Points& points_;
  const std::vector<Surface_point>& locations_;
  const Inserted& inserted_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_VERTEX_POSITIONS_H

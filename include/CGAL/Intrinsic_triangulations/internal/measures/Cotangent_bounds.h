// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lower bounds in float for the cotangents of the corners, by which most edges are known to be
// Delaunay without a look at their hinges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_COTANGENT_BOUNDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_COTANGENT_BOUNDS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Two_doubles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// Lower bounds for the cotangents of a face's corners: opposite to ij, to jk, and to ki.
//
// Let S = s_ij + s_jk + s_ki. The cotangent opposite to ij is c = (S - 2 s_ij) / a, and |c| <= S / a. The bound is c -
// 2^-22 S / a. Rounding to float takes at most 2^-24 S / a of the difference, and the operations in double a few 2^-53
// S / a. So it bounds every number that differs from c by at most 2^-23 S / a. An area of zero gives NaNs, whose sums
// are not greater than zero.
//
// N is `double` or `Two_doubles`. The caller rounds the bounds.
template <class N>
std::array<N, 3> cotangent_bounds(const N& s_ij, const N& s_jk, const N& s_ki, const N& a)
{
  const N r = N(1) / a, largest = (s_ij + s_jk + s_ki) * N(1 - 0x1p-22) * r, twice = r + r;
  return {largest - s_ij * twice, largest - s_jk * twice, largest - s_ki * twice};
}

inline std::array<float, 3> rounded(const std::array<double, 3>& bounds)
{
  return {float(bounds[0]), float(bounds[1]), float(bounds[2])};
}

// Whether traits bound cotangents; `void` means that they do not.
template <class Traits, class = void>
struct Has_cotangent_bounds : std::false_type
{};
template <class Traits>
struct Has_cotangent_bounds<Traits, std::void_t<typename Traits::Compute_cotangent_bounds>>
  : std::bool_constant<!std::is_void<typename Traits::Compute_cotangent_bounds>::value>
{};

// The bounds of all corners, each at the halfedge opposite to it. Border halfedges have minus infinity, so their edges
// are never known to be Delaunay.
class Cotangent_bounds
{
public:
  Cotangent_bounds() = default;
  explicit Cotangent_bounds(const Delta_complex& complex) : bounds_(complex.number_of_halfedges(), default_init)
  {
    if (3 * std::size_t(complex.number_of_faces()) != complex.number_of_halfedges())
      std::fill(bounds_.begin(), bounds_.end(), -std::numeric_limits<float>::infinity());
  }

  void make_room(std::size_t number_of_edges) { internal::make_room(bounds_, 2 * number_of_edges); }
  // Appends the halfedges of the given number of edges, without knowledge of their corners.
  void append(std::size_t number_of_edges)
  {
    bounds_.resize(bounds_.size() + 2 * number_of_edges, -std::numeric_limits<float>::infinity());
  }

  // Follows the removal of edges, like `remove_entries()`.
  template <class Edges>
  void remove(const Edges& edges)
  {
    for (Edge_index hole : edges) {
      const std::size_t last = bounds_.size() - 2;
      for (std::size_t i : {0, 1})
        bounds_[2 * std::size_t(hole.idx()) + i] = bounds_[last + i];
      bounds_.pop_back();
      bounds_.pop_back();
    }
  }

  void set(Halfedge_index h, float bound) { bounds_[h.idx()] = bound; }
  // of corners of two faces
  void set(Halfedge_index h, Halfedge_index g, const Two_doubles& bounds)
  {
    const std::array<float, 2> floats = bounds.floats();
    bounds_[h.idx()] = floats[0];
    bounds_[g.idx()] = floats[1];
  }

  // The sign of a sum of two floats is right, whatever its rounding.
  bool imply_Delaunay(Edge_index e) const
  {
    return bounds_[2 * std::size_t(e.idx())] + bounds_[2 * std::size_t(e.idx()) + 1] > 0;
  }
  // The same for four consecutive edges: bit i is set if it holds for the i-th.
  unsigned imply_Delaunay_of_four(Edge_index e) const
  {
#ifdef __SSE2__
    const float* const bound = bounds_.data() + 2 * std::size_t(e.idx());
    const __m128 a = _mm_loadu_ps(bound), b = _mm_loadu_ps(bound + 4);
    const __m128 sum =
      _mm_add_ps(_mm_shuffle_ps(a, b, _MM_SHUFFLE(2, 0, 2, 0)), _mm_shuffle_ps(a, b, _MM_SHUFFLE(3, 1, 3, 1)));
    return unsigned(_mm_movemask_ps(_mm_cmpgt_ps(sum, _mm_setzero_ps())));
#else
    const auto bit = [&](unsigned i) { return unsigned(imply_Delaunay(Edge_index(e.idx() + i))) << i; };
    return bit(0) | bit(1) | bit(2) | bit(3);
#endif
  }

private:
  Large_vector<float> bounds_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_COTANGENT_BOUNDS_H

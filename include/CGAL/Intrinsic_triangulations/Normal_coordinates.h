// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where the input triangulation lies in the current one, by integers alone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/Rotation_system.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief how the input edges run through one triangle (i, j, k) of the current triangulation.
///
/// At most one of `e_i`, `e_j`, `e_k` is positive.
struct Triangle_crossings
{
  std::int64_t e_i, e_j, e_k; ///< number of segments from a corner to the opposite edge
  std::int64_t c_i, c_j, c_k; ///< number of segments that cut a corner off

  /// computes the numbers from how often the edges are crossed.
  Triangle_crossings(std::int64_t n_ij, std::int64_t n_jk, std::int64_t n_ki)
    : e_i((std::max)(std::int64_t(0), n_jk - n_ij - n_ki)),
      e_j((std::max)(std::int64_t(0), n_ki - n_ij - n_jk)),
      e_k((std::max)(std::int64_t(0), n_ij - n_jk - n_ki)),
      c_i(((std::max)(std::int64_t(0), n_ij + n_ki - n_jk) - e_j - e_k) / 2),
      c_j(((std::max)(std::int64_t(0), n_ij + n_jk - n_ki) - e_i - e_k) / 2),
      c_k(((std::max)(std::int64_t(0), n_jk + n_ki - n_ij) - e_i - e_j) / 2)
  {}
};

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief normal coordinates and roundabouts: integers that say, up to nothing, how the
/// edges of the input triangulation run through the current one.
///
/// The normal coordinate of an edge is the number of times that input edges cross it, or
/// −1 if it coincides with an input edge. The roundabout of a halfedge is the index,
/// counterclockwise around its source, of the first input halfedge at or after it; the
/// input halfedges out of a vertex are counted from the one that has the border to its right, or
/// from the one of smallest index. A flip updates both in O(1), whatever the edge crosses and
/// whatever the degrees are; no rounding can reach them.
///
/// Memory: 16 bytes an edge and 4 a vertex.
///
/// Source: the idea is that of M. Gillespie, N. Sharp, K. Crane, "Integer coordinates
/// for intrinsic geometry processing" (2021).
class Normal_coordinates
{
public:
  /// constructs the coordinates in an empty triangulation.
  Normal_coordinates() = default;
  /// constructs the coordinates of an input triangulation in itself.
  explicit Normal_coordinates(const Delta_complex& input)
    : Normal_coordinates(input, internal::Rotation_system(input))
  {}
  /// \cond SKIP_IN_MANUAL
  Normal_coordinates(const Delta_complex& input, const internal::Rotation_system& around)
    : crossings_(input.number_of_edges(), -1),
      roundabouts_(input.number_of_halfedges(), internal::default_init),
      degrees_(input.number_of_vertices(), internal::default_init)
  {
    for (Vertex_index v : input.vertices()) {
      degrees_[v.idx()] = around.degree(v);
      for (std::uint32_t i = 0; i < around.degree(v); ++i)
        roundabouts_[around.halfedge(v, i).idx()] = i;
    }
  }
  /// \endcond

  /// returns how often input edges cross `e`, or −1 if `e` coincides with one.
  std::int64_t crossings(Edge_index e) const { return crossings_[e.idx()]; }
  /// returns whether `e` coincides with an input edge.
  bool is_original(Edge_index e) const { return crossings_[e.idx()] < 0; }
  /// returns how often input edges cross `e`.
  std::int64_t number_of_crossings(Edge_index e) const
  {
    return (std::max)(std::int64_t(0), crossings_[e.idx()]);
  }

  /// returns the roundabout of `h`.
  std::uint32_t roundabout(Halfedge_index h) const { return roundabouts_[h.idx()]; }
  /// returns the number of input halfedges out of `v`.
  std::uint32_t degree(Vertex_index v) const { return degrees_[v.idx()]; }

  /// returns how the input edges run through the triangle to the left of `h`, with i and
  /// j the source and target of `h`.
  Triangle_crossings triangle_crossings(const Delta_complex& complex, Halfedge_index h) const
  {
    return Triangle_crossings(number_of_crossings(complex.edge(h)),
                              number_of_crossings(complex.edge(complex.next(h))),
                              number_of_crossings(complex.edge(complex.prev(h))));
  }

  /// \brief updates the integers for the flip of `e`; to be called before the flip of the
  /// connectivity. O(1).
  ///
  /// \exception Integer_overflow_error if the count would leave the range of 64 bits;
  ///   nothing is changed then
  void flip(const Delta_complex& complex, Edge_index e)
  {
    CGAL_precondition(complex.is_flippable(e));
    const Halfedge_index ij = complex.halfedge(e), ji = complex.opposite(ij);
    const Halfedge_index ki = complex.prev(ij), lj = complex.prev(ji);
    const Vertex_index k = complex.source(ki), l = complex.source(lj);

    const Triangle_crossings above = triangle_crossings(complex, ij); // (i, j, k)
    const Triangle_crossings below = triangle_crossings(complex, ji); // (j, i, l)
    const std::int64_t c_i1 = above.c_i, c_j1 = above.c_j, e_k1 = above.e_k;
    const std::int64_t c_i2 = below.c_j, c_j2 = below.c_i, e_l2 = below.e_k;

    // Counted from i, the segments that end in k cross ij at the positions after c_i1,
    // those that end in l at the positions after c_i2: one that does both joins k and l.
    const bool joins_k_and_l =
      (std::max)(c_i1, c_i2) < (std::min)(c_i1 + e_k1, c_i2 + e_l2);
    std::int64_t n_kl = -1;
    if (!joins_k_and_l) {
      n_kl = above.c_k + below.c_k + above.e_i + above.e_j + below.e_i + below.e_j +
             (std::max)(std::int64_t(0), c_i1 - c_i2 - e_l2) +
             (std::max)(std::int64_t(0), c_i2 - c_i1 - e_k1) + (is_original(e) ? 1 : 0);
      if (n_kl > largest_count)
        throw Integer_overflow_error("an edge crosses more than 2^60 input edges");
    }
    const std::uint32_t r_kl =
      advanced(k, ki, (std::min)((std::max)(std::int64_t(0), c_i2 - c_i1), e_k1), complex);
    const std::uint32_t r_lk =
      advanced(l, lj, (std::min)((std::max)(std::int64_t(0), c_j1 - c_j2), e_l2), complex);

    crossings_[e.idx()] = n_kl;
    // After the flip the halfedge ij leads from l to k (see Delta_complex::flip()).
    roundabouts_[ij.idx()] = r_lk;
    roundabouts_[ji.idx()] = r_kl;
  }

private:
  // Five counts up to this add up without overflow.
  static constexpr std::int64_t largest_count = std::int64_t(1) << 60;

  std::uint32_t advanced(Vertex_index v, Halfedge_index h, std::int64_t by,
                         const Delta_complex& complex) const
  {
    const std::uint64_t r = std::uint64_t(roundabout(h)) +
                            (is_original(complex.edge(h)) ? 1 : 0) + std::uint64_t(by);
    const std::uint32_t d = degree(v);
    return std::uint32_t(r < d ? r : r - d);
  }

  internal::Large_vector<std::int64_t> crossings_;
  internal::Large_vector<std::uint32_t> roundabouts_;
  internal::Large_vector<std::uint32_t> degrees_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_NORMAL_COORDINATES_H

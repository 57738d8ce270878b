// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An edge of the current triangulation, laid out over the input triangles that it crosses.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Planar_vector.h>
#include <CGAL/Intrinsic_triangulations/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Crossing_sequence.h>

#include <CGAL/assertions.h>

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// At an input halfedge ij with the third corner k to its left, both relative to ij: the
// vector from i to k, and the vector from k to j.
template <class Vector>
struct Corner_ratios
{
  Vector at_source;
  Vector at_target;
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
///
/// \brief lengths, angles and areas of the current triangulation, computed from the input alone.
///
/// The input triangles that an edge crosses are laid out one after the other in the
/// plane. Positions are products and sums of corner ratios of input triangles,
/// `z = (x + i √q) / (2 s)` with `x = s_ij + s_ki − s_jk` at the corner i from ij to ki:
/// numbers of the multiquadratic field over the rationals that the square roots √q of
/// the input faces generate, divided only by input quantities. So the results depend on
/// the input and on where the edge runs, not on earlier flips, and the same
/// code yields intervals, multiple-precision numbers or exact ones.
///
/// \tparam Metric gives the images in some ring of the squared length of an input edge and
///   of √q of an input face (four times its area): a type `Real`, members
///   `squared_length(Edge_index)` and `four_areas(Face_index)`, `constant(double)`; a type
///   `Vector` of complex numbers over it; `remembered(Halfedge_index, compute)`, which
///   returns what the last call with that halfedge did, or `compute()`;
///   `is_flat(Halfedge_index)`, whether the two faces of an input edge are known to lie in
///   one plane in space, and if so, `ratio_in_plane(Halfedge_index, Vertex_index,
///   Vertex_index)`, the ratio of the vector between two vertices in the plane of the face
///   of a halfedge, to the halfedge; `interruption()`, which can end a long computation.
///
/// Lengths are in the unit of the metric. Cost: proportional to the number of crossings,
/// plus that of finding their order.
template <class Metric>
class Unfolding
{
public:
  /// the ring
  using Real = typename Metric::Real;
  /// a vector in the plane of a layout
  using Vector = typename Metric::Vector;

  /// \brief an edge as a vector in the frame of an input halfedge: 1 is that halfedge.
  struct Edge_vector
  {
    Vector vector;            ///< the edge, from source to target
    Halfedge_index reference; ///< that input halfedge
  };

  /// a triangle as one of its corners sees it
  using Corner = Triangle_corner<Real>;

  /// \pre `correspondence.is_prepared()`
  Unfolding(const Delta_complex& complex, const Correspondence& correspondence, Metric& metric)
    : complex_(complex), correspondence_(correspondence), input_(correspondence.input()),
      metric_(metric)
  {}

  /// \cond SKIP_IN_MANUAL
  // As above; the orders of crossings that are found are remembered.
  Unfolding(const Delta_complex& complex, const Correspondence& correspondence, Metric& metric,
            internal::Crossing_sequences& sequences)
    : Unfolding(complex, correspondence, metric)
  {
    sequences_ = &sequences;
  }
  /// \endcond

  /// returns `h` as a vector.
  Edge_vector edge_vector(Halfedge_index h) const
  {
    const Halfedge_index roundabout = correspondence_.input_halfedge(h);
    const Vector zero(metric_.constant(0), metric_.constant(0)),
      one(metric_.constant(1), metric_.constant(0));
    if (correspondence_.coordinates().is_original(complex_.edge(h)))
      return {one, roundabout};

    // h leaves its source between `reference` and `roundabout`.
    const Halfedge_index reference = input_.next(input_.opposite(roundabout));
    Run run{reference, zero, one, 1};
    Halfedge_index crossed = input_.opposite(input_.next(run.base)); // from left to right
    internal::Crossing_sequences own;
    const internal::Crossing_sequence& sequence = (sequences_ ? *sequences_ : own)(
      complex_, correspondence_.coordinates(), h, metric_.interruption());
    const std::int64_t n = correspondence_.coordinates().number_of_crossings(complex_.edge(h));
    bool turns_left = false;
    for (std::int64_t crossing = 0;; ++crossing) {
      if (crossing % 64 == 63)
        metric_.interruption().check();
      if (metric_.is_flat(crossed))
        ++run.length;
      else
        run = next_run(run, crossed, turns_left);
      if (crossing + 1 == n)
        return {run.source + run.vector * ratio_to(run, input_.target(input_.next(crossed))),
                reference};
      turns_left = sequence.turns_left(std::size_t(crossing));
      crossed = input_.opposite(turns_left ? input_.prev(crossed) : input_.next(crossed));
    }
  }

  /// returns the squared length of `e`.
  Real squared_length(Edge_index e) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    const Edge_vector u = edge_vector(h);
    return squared_norm(u.vector) * reference_length(u);
  }

  /// returns the corner opposite to `h` in its face.
  /// \pre `h` is not a border halfedge
  Corner opposite_corner(Halfedge_index h) const
  {
    CGAL_precondition(!complex_.is_border(h));
    if (is_input_face(h))
      return input_corner(h);
    const Halfedge_index ki = complex_.prev(h), kj = complex_.opposite(complex_.next(h));
    const Edge_vector u = edge_vector(ki), v = edge_vector(kj);
    // From the frame of u to the frame of v there is a fan of input triangles.
    Vector w = v.vector;
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    const std::int64_t fan = coordinates.triangle_crossings(complex_, h).e_k +
                             (coordinates.is_original(complex_.edge(kj)) ? 1 : 0);
    Halfedge_index from = u.reference;
    for (std::int64_t i = 0; i < fan;)
      w = w * fan_ratio(from, i, fan);
    const Real s = reference_length(u), two_s = s + s;
    const Vector z = times_conjugate(w, u.vector);
    return {two_s * z.x(), two_s * z.y(), s * squared_norm(u.vector), s * squared_norm(w),
            s * squared_norm(w - u.vector)};
  }

  /// \cond SKIP_IN_MANUAL
  using Corner_ratios = internal::Corner_ratios<Vector>;

  // The shape of the input face to the left of ij.
  Corner_ratios corner_ratios(Halfedge_index ij) const
  {
    return metric_.remembered(ij, [&] { return computed_corner_ratios(ij); });
  }
  /// \endcond

private:
  // A face whose three edges coincide with input edges is an input face.
  bool is_input_face(Halfedge_index h) const
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    return coordinates.is_original(complex_.edge(h)) &&
           coordinates.is_original(complex_.edge(complex_.next(h))) &&
           coordinates.is_original(complex_.edge(complex_.prev(h)));
  }

  Corner input_corner(Halfedge_index h) const
  {
    const Halfedge_index ij = correspondence_.input_halfedge(h);
    const Real s_ij = metric_.squared_length(input_.edge(ij));
    const Real s_jk = metric_.squared_length(input_.edge(input_.next(ij)));
    const Real s_ki = metric_.squared_length(input_.edge(input_.prev(ij)));
    return {s_jk + s_ki - s_ij, metric_.four_areas(input_.face(ij)), s_ki, s_jk, s_ij};
  }

  Real reference_length(const Edge_vector& v) const
  {
    return metric_.squared_length(input_.edge(v.reference));
  }

  // The input triangles of a strip since the last bent edge. They lie in one plane, so that
  // a corner can be found from the first edge of the run at once, by its point in space.
  //
  // Directions are products alone and positions sums of such products: so errors add up.
  struct Run
  {
    Halfedge_index base; // the first edge, with the first triangle to its left
    Vector source;       // where its source lies
    Vector vector;       // from there to its target
    std::int64_t length; // number of triangles
  };

  // The ratio to the base of the vector from its source to the last corner of the run.
  Vector ratio_to(const Run& run, Vertex_index apex) const
  {
    return run.length == 1 ? corner_ratios(run.base).at_source
                           : metric_.ratio_in_plane(run.base, input_.source(run.base), apex);
  }

  // The run that begins with `crossed`, to which the strip turned last.
  Run next_run(const Run& run, Halfedge_index crossed, bool turns_left) const
  {
    if (run.length == 1) {
      const Corner_ratios ratios = corner_ratios(run.base);
      if (turns_left) // from the source of the base to the apex
        return {crossed, run.source, run.vector * ratios.at_source, 1};
      return {crossed, run.source + run.vector * ratios.at_source, run.vector * ratios.at_target, 1};
    }
    const Vertex_index from = input_.source(run.base), left = input_.source(crossed),
                       right = input_.target(crossed);
    return {crossed,
            left == from ? run.source
                         : run.source + run.vector * metric_.ratio_in_plane(run.base, from, left),
            run.vector * metric_.ratio_in_plane(run.base, left, right), 1};
  }

  // The ratio from an input halfedge, number i of a fan, to the end of the fan's flat part, to
  // which it is advanced.
  Vector fan_ratio(Halfedge_index& from, std::int64_t& i, std::int64_t fan) const
  {
    const Halfedge_index base = from;
    std::int64_t length = 0;
    do {
      from = input_.next_around_source(from);
      ++length;
    } while (i + length < fan && metric_.is_flat(from));
    i += length;
    return length == 1 ? corner_ratios(base).at_source
                       : metric_.ratio_in_plane(base, input_.source(base), input_.target(from));
  }

  Corner_ratios computed_corner_ratios(Halfedge_index ij) const
  {
    const Real s_ij = metric_.squared_length(input_.edge(ij));
    const Real s_jk = metric_.squared_length(input_.edge(input_.next(ij)));
    const Real s_ki = metric_.squared_length(input_.edge(input_.prev(ij)));
    const Real two_s = s_ij + s_ij;
    const Real height = metric_.four_areas(input_.face(ij)) / two_s;
    return {Vector((s_ij + s_ki - s_jk) / two_s, height),
            Vector((s_ij + s_jk - s_ki) / two_s, -height)};
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Metric& metric_;
  internal::Crossing_sequences* sequences_ = nullptr;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_H

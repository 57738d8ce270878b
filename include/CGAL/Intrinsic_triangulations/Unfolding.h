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
#include <CGAL/Intrinsic_triangulations/internal/exact/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Strip.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {

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
    if (correspondence_.coordinates().is_original(complex_.edge(h)))
      return {Vector(metric_.constant(1), metric_.constant(0)), roundabout};
    internal::Crossing_sequences own;
    const Path path{input_, roundabout,
                    (sequences_ ? *sequences_ : own)(complex_, correspondence_.coordinates(), h, metric_.interruption()),
                    std::size_t(correspondence_.coordinates().number_of_crossings(complex_.edge(h)))};
    return {internal::Strip<Frame>(input_, Frame(input_, metric_)).end(path), Frame::reference(input_, path.front())};
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
    std::int64_t fan = coordinates.triangle_crossings(complex_, h).e_k +
                       (coordinates.is_original(complex_.edge(kj)) ? 1 : 0);
    const Frame frame(input_, metric_);
    Halfedge_index from = u.reference;
    while (fan > 0)
      w = w * frame.fan_ratio(from, fan);
    const Real s = reference_length(u), two_s = s + s;
    const Vector z = times_conjugate(w, u.vector);
    return {two_s * z.x(), two_s * z.y(), s * squared_norm(u.vector), s * squared_norm(w),
            s * squared_norm(w - u.vector)};
  }

private:
  using Frame = internal::Metric_frame<Metric>;

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

  // The input edges that a halfedge crosses which leaves its source to the right of `roundabout`.
  struct Path
  {
    const Delta_complex& input;
    Halfedge_index roundabout;
    const internal::Crossing_sequence& sequence;
    std::size_t number;

    std::size_t size() const { return number; }
    Halfedge_index front() const { return input.opposite(input.prev(input.opposite(roundabout))); }
    bool turns_left(std::size_t i) const { return sequence.turns_left(i - 1); }
    Halfedge_index behind(Halfedge_index h, std::size_t i) const
    {
      return input.opposite(turns_left(i) ? input.prev(h) : input.next(h));
    }
  };

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Metric& metric_;
  internal::Crossing_sequences* sequences_ = nullptr;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_UNFOLDING_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// An edge of the current triangulation, laid out over the input triangles that it crosses.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_UNFOLDING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_UNFOLDING_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../../arithmetic/Planar_vector.h"
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "Metric_frame.h"
#include "Strip.h"

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// Lengths, angles and areas of the current triangulation, computed from the input alone.
//
// The input triangles that an edge crosses are laid out one after the other in the
// plane. Positions are products and sums of corner ratios of input triangles,
// `z = (x + i √q) / (2 s)` with `x = s_ij + s_ki − s_jk` at the corner i from ij to ki:
// numbers of the multiquadratic field over the rationals that the square roots √q of
// the input faces generate, divided only by input quantities. So the results depend on
// the input and on where the edge runs, not on earlier flips, and the same
// code yields intervals, multiple-precision numbers or exact ones.
//
// \tparam Metric gives the images in some ring of the squared length of an input edge and of √q of an input face (four
//   times its area): a type `Real`, members `squared_length(Edge_index)` and `four_areas(Face_index)`,
//   `constant(double)`; a type `Vector` of complex numbers over it; `remembered(Halfedge_index, compute)`, which gives
//   what the last call with that halfedge gave, or that of `compute`; `is_flat(Halfedge_index)`, whether the two faces
//   of an input edge are known to lie in one plane in space, a `std::false_type` where that is never used, and if so,
//   `ratio_in_plane(Halfedge_index, Vertex_index, Vertex_index)`, the ratio of the vector between two vertices in the
//   plane of the face of a halfedge, to the halfedge; `keeps_fans()`, a `std::false_type`, or whether
//   there is `fan_ratio(from, to, is_counterclockwise)` (see Fan_positions.h); `interruption()`, which can end a long
//   computation.
//
// Lengths and areas of all edges and faces are in one unit, that of the metric, so that they can be compared and added;
// vectors are each in the frame of its own reference. Cost: proportional to the number of crossings, plus that of
// finding their order.
template <class Metric>
class Unfolding
{
public:
  // The ring
  using Real = typename Metric::Real;
  // A vector in the plane of a layout
  using Vector = typename Metric::Vector;

  // An edge as a vector in the frame of an input halfedge: 1 is that halfedge.
  struct Edge_vector
  {
    Vector vector;            // the edge, from source to target
    Halfedge_index reference; // that input halfedge
  };

  // A triangle relative to one of its corners
  using Corner = Triangle_corner<Real>;

  // \pre `correspondence.knows_input()`
  Unfolding(const Delta_complex& complex, const Correspondence& correspondence, Metric& metric)
    : complex_(complex), correspondence_(correspondence), input_(correspondence.input()), metric_(metric)
  {}

  // `h` as a vector.
  Edge_vector edge_vector(Halfedge_index h) const
  {
    const std::int64_t n = correspondence_.coordinates().crossings(complex_.edge(h));
    if (BOOST_UNLIKELY(n == 0 || is_inserted(complex_.source(h)) || is_inserted(complex_.target(h))))
      return vector_between_inserted(h, n);
    const Halfedge_index roundabout = correspondence_.input_halfedge(h);
    if (n < 0)
      return {Vector(metric_.constant(1), metric_.constant(0)), roundabout};
    return end_of_strip(crossed(h), std::size_t(n), nullptr);
  }
  // The start of h and its vector, in the frame of an input halfedge of the face into which h leaves its source.
  struct Edge_beginning
  {
    Vector source, vector;
    Halfedge_index reference;
  };
  Edge_beginning edge_beginning(Halfedge_index h) const
  {
    const Edge_vector u = edge_vector(h);
    const std::int64_t n = correspondence_.coordinates().crossings(complex_.edge(h));
    if (n >= 0)
      return {position_of_source(h, n, u.reference), u.vector, u.reference};
    const Frame frame(input_, metric_);
    if (!is_inserted(complex_.source(h)))
      return {frame.real(metric_.constant(0)), u.vector, u.reference};
    const auto [a, b] = coordinates_on_edge(input_, correspondence_.location(complex_.source(h)), u.reference);
    return {frame.real(frame.weights({a, b, 0})[1]), u.vector, u.reference};
  }

  // The vector from the source of h, which begins at u, to a point of the input. The point lies in the input triangle
  // that h runs through after the given number of crossings, or to the left of h if that coincides with an input edge.
  Vector vector_to(const Surface_point& point, Halfedge_index h, const Edge_beginning& u, std::int64_t position) const
  {
    if (position == 0)
      return position_in_face(u.reference, coordinates_from(input_, point, u.reference)) - u.source;
    const bool starts_inside = is_inserted(complex_.source(h));
    const Vector end = end_of_strip(crossed(h), std::size_t(position), &point).vector;
    return starts_inside ? end - u.source : end;
  }

  // Twice the area of the triangle of h and that point, in units of the squared length of an input edge: positive if
  // the point lies to the left of h.
  Real area_beside(Halfedge_index h, std::int64_t position, const Surface_point& point) const
  {
    const Edge_beginning u = edge_beginning(h);
    return area_between(u.vector, vector_to(point, h, u, position));
  }

  // Lays out the strip of an edge that crosses input edges.
  // \param crossed as `Crossed_edges`
  template <class Frame, class Crossed>
  void lay_out(Strip<Frame>& strip, Halfedge_index h, const Crossed& crossed) const
  {
    const Halfedge_index g = complex_.opposite(h);
    if (is_inserted(complex_.source(g))) {
      const Surface_point end = location_of_source(g);
      strip.lay_out(crossed, &end);
    } else {
      strip.lay_out(crossed);
    }
    if (is_inserted(complex_.source(h)))
      strip.move_source(position_of_source(h, std::int64_t(crossed.size()), Frame::reference(input_, crossed.front())));
  }

  // The squared length of `e`.
  Real squared_length(Edge_index e) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    const Edge_vector u = edge_vector(h);
    return squared_norm(u.vector) * reference_length(u);
  }

  // The corner opposite to `h` in its face.
  // \pre `h` is not a border halfedge
  Corner opposite_corner(Halfedge_index h) const
  {
    CGAL_precondition(!complex_.is_border(h));
    if (is_input_face(h))
      return input_corner(h);
    return corner_between(h, edge_vector(complex_.prev(h)), edge_vector(complex_.opposite(complex_.next(h))));
  }
  // Calls `visit(h, corner)` for each face that has the corner k, opposite to h, counterclockwise. Edges between them
  // are laid out once.
  template <class Visit>
  void for_each_corner_at(Vertex_index k, const Visit& visit) const
  {
    const Halfedge_index first = complex_.opposite(complex_.halfedge(k));
    const Edge_vector vector_of_first = edge_vector(first);
    Edge_vector u = vector_of_first;
    Halfedge_index ki = first;
    do {
      const Halfedge_index kj = complex_.next_around_source(ki), h = complex_.next(ki);
      const Edge_vector v = kj == first ? vector_of_first : edge_vector(kj);
      if (!complex_.is_border(ki))
        visit(h, corner_between(h, u, v));
      u = v;
      ki = kj;
    } while (ki != first);
  }

private:
  using Frame = Metric_frame<Metric>;

  // The corner opposite to h, from its sides ki and kj.
  Corner corner_between(Halfedge_index h, const Edge_vector& u, const Edge_vector& v) const
  {
    const Halfedge_index ki = complex_.prev(h), kj = complex_.opposite(complex_.next(h));
    Vector w = v.vector;
    if (BOOST_UNLIKELY(is_inserted(complex_.source(kj)))) {
      w = w * ratio_at_inserted(ki, u.reference, kj, v.reference);
    } else { // from the frame of u to the frame of v there is a fan of input triangles
      const Normal_coordinates& coordinates = correspondence_.coordinates();
      std::int64_t fan =
        coordinates.triangle_crossings(complex_, h).e_k + (coordinates.is_original(complex_.edge(kj)) ? 1 : 0);
      const Frame frame(input_, metric_);
      Halfedge_index from = u.reference;
      while (fan > 0)
        w = w * frame.fan_ratio(from, fan);
    }
    const Real s = reference_length(u), two_s = s + s;
    const Vector z = times_conjugate(w, u.vector);
    return {two_s * z.x(), two_s * z.y(), s * squared_norm(u.vector), s * squared_norm(w),
            s * squared_norm(w - u.vector)};
  }

  bool is_inserted(Vertex_index v) const { return correspondence_.is_inserted(v); }

  Crossed_halfedges crossed(Halfedge_index h) const { return {complex_, correspondence_, h, metric_.interruption()}; }

  // The vector from the corner opposite to the first crossed edge to the corner opposite to the n-th, or to a point
  // beyond that edge.
  Edge_vector end_of_strip(const Crossed_halfedges& crossed, std::size_t n, const Surface_point* point) const
  {
    return {Strip<Frame>(input_, Frame(input_, metric_)).end(crossed, n, point),
            Frame::reference(input_, crossed.front())};
  }

  // The location of the source of h, which was inserted, in the input face into which h leaves it. \pre h does not
  // coincide with an input edge
  Surface_point location_of_source(Halfedge_index h) const
  {
    const Surface_point& location = correspondence_.location(complex_.source(h));
    const Halfedge_index roundabout = correspondence_.input_halfedge(h);
    if (!roundabout.is_valid())
      return location;
    const Halfedge_index back = input_.opposite(roundabout);
    const auto [a, b] = coordinates_on_edge(input_, location, back);
    return {back, {a, b, 0}};
  }
  // A point of the face of `base`, relative to the source of `base`, with `base` as the unit.
  Vector position_in_face(Halfedge_index base, const std::array<double, 3>& coordinates) const
  {
    const Frame frame(input_, metric_);
    const auto weights = frame.weights(coordinates);
    return frame.real(weights[1]) + frame.real(weights[2]) * frame.ratios(base).at_source;
  }

  // The start of h, relative to the source of its vector's reference.
  Vector position_of_source(Halfedge_index h, std::int64_t n, Halfedge_index reference) const
  {
    if (!is_inserted(complex_.source(h)) &&
        (n > 0 || reference == input_.next(input_.opposite(correspondence_.input_halfedge(h)))))
      return Frame(input_, metric_).real(metric_.constant(0));
    return position_in_face(reference, coordinates_of_source(h, reference));
  }

  // The coordinates of the source of h relative to a halfedge of the input face into which h leaves it.
  std::array<double, 3> coordinates_of_source(Halfedge_index h, Halfedge_index reference) const
  {
    if (is_inserted(complex_.source(h)))
      return coordinates_from(input_, location_of_source(h), reference);
    const Halfedge_index side = input_.next(input_.opposite(correspondence_.input_halfedge(h)));
    return coordinates_from(input_, Surface_point{side, {1, 0, 0}}, reference);
  }

  // As edge_vector(), if an end is not a vertex of the input.
  Edge_vector vector_between_inserted(Halfedge_index h, std::int64_t n) const
  {
    const Frame frame(input_, metric_);
    const Halfedge_index g = complex_.opposite(h);
    if (n < 0) { // along an input edge
      const Halfedge_index along = correspondence_.input_halfedge(h);
      const auto position = [&](Vertex_index v, double at_vertex) {
        if (!is_inserted(v))
          return metric_.constant(at_vertex);
        const auto [a, b] = coordinates_on_edge(input_, correspondence_.location(v), along);
        return frame.weights({a, b, 0})[1];
      };
      return {frame.real(position(complex_.target(h), 1) - position(complex_.source(h), 0)), along};
    }
    if (n == 0) { // within an input face
      const Halfedge_index reference = is_inserted(complex_.source(h))
                                         ? location_of_source(h).halfedge
                                         : input_.next(input_.opposite(correspondence_.input_halfedge(h)));
      return {position_in_face(reference, coordinates_of_source(g, reference)) -
                position_in_face(reference, coordinates_of_source(h, reference)),
              reference};
    }
    const bool starts_inside = is_inserted(complex_.source(h)), ends_inside = is_inserted(complex_.target(h));
    const Surface_point end = ends_inside ? location_of_source(g) : Surface_point{};
    Edge_vector result = end_of_strip(crossed(h), std::size_t(n), ends_inside ? &end : nullptr);
    if (starts_inside)
      result.vector = result.vector - position_of_source(h, n, result.reference);
    return result;
  }

  // The ratio of two halfedges of one input face, as vectors.
  Vector ratio_in_face(Halfedge_index from, Halfedge_index to) const
  {
    const Frame frame(input_, metric_);
    if (to == from)
      return frame.real(metric_.constant(1));
    CGAL_assertion(to == input_.next(from) || to == input_.prev(from));
    const auto& ratios = frame.ratios(from);
    return reversed(to == input_.next(from) ? ratios.at_target : ratios.at_source);
  }
  Vector reversed(const Vector& v) const { return Frame(input_, metric_).real(metric_.constant(0)) - v; }

  // The ratio of `to`, the reference of kj, to `from`, the reference of ki, if k was inserted. The input edge on which
  // k lies may run between them.
  Vector ratio_at_inserted(Halfedge_index ki, Halfedge_index from, Halfedge_index kj, Halfedge_index to) const
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    if (coordinates.is_original(complex_.edge(kj))) // the face is to its right
      return reversed(ratio_in_face(from, input_.opposite(to)));
    if (coordinates.triangle_crossings(complex_, complex_.next(ki)).e_k == 0)
      return ratio_in_face(from, to);
    const Halfedge_index between = correspondence_.input_halfedge(ki);
    return reversed(ratio_in_face(from, input_.opposite(between)) * ratio_in_face(between, to));
  }

  // A face whose three edges coincide with input edges is an input face.
  bool is_input_face(Halfedge_index h) const
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    return coordinates.is_original(complex_.edge(h)) && coordinates.is_original(complex_.edge(complex_.next(h))) &&
           coordinates.is_original(complex_.edge(complex_.prev(h)));
  }

  Corner input_corner(Halfedge_index h) const
  {
    const Halfedge_index ij = correspondence_.input_halfedge(h);
    const Real s_ij = metric_.squared_length(input_.edge(ij));
    const Real s_jk = metric_.squared_length(input_.edge(input_.next(ij)));
    const Real s_ki = metric_.squared_length(input_.edge(input_.prev(ij)));
    const Real p = [&]() -> Real {
      if constexpr (Metric::has_accurate_ratios)
        return (s_ki + s_ki) * Frame(input_, metric_).ratios(input_.prev(ij)).at_source.x();
      else
        return s_jk + s_ki - s_ij;
    }();
    return {p, metric_.four_areas(input_.face(ij)), s_ki, s_jk, s_ij};
  }

  Real reference_length(const Edge_vector& v) const { return metric_.squared_length(input_.edge(v.reference)); }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Metric& metric_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_UNFOLDING_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces that a straight line runs through, of the input or of the current triangulation: their shapes, and where
// the line begins.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_FACES_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Unfolding.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>

#include <array>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A line in the frame of a first halfedge, whose source is 0.
template <class Vector>
struct Line_beginning
{
  Vector base;         // the target of that halfedge
  Vector start;        // where the line begins, times `sum`
  Vector sum;          // of the coordinates of the start: positive
  Vector direction;    // its displacement
  Halfedge_index unit; // the input halfedge that has length 1
};

// The third corner of a face as one of its halfedges sees it: the sides that leave and enter it are that halfedge times
// `from_source` and `to_target`, divided by `divisor`, which is positive.
template <class Vector>
struct Third_corner
{
  Vector from_source, to_target, divisor;
};

// \param corners those of the face of the start, in the order of its coordinates
template <class Metric>
Line_beginning<typename Metric::Vector>
line_between(const Surface_direction& start, Metric& metric, const typename Metric::Vector& base,
             const std::array<typename Metric::Vector, 3>& corners, Halfedge_index unit)
{
  using Vector = typename Metric::Vector;
  const auto real = [&metric](double x) { return Vector(metric.constant(x), metric.constant(0)); };
  const auto& b = start.point.coordinates;
  // Their sum is no input quantity, so positions are multiplied by it.
  return {base, real(b[0]) * corners[0] + real(b[1]) * corners[1] + real(b[2]) * corners[2],
          real(b[0]) + real(b[1]) + real(b[2]),
          real(start.displacement[0]) * (corners[1] - corners[0]) +
            real(start.displacement[1]) * (corners[2] - corners[0]),
          unit};
}

// The faces of the input.
class Input_faces
{
public:
  Input_faces(const Delta_complex& input, const Surface_direction& start) : complex(input), start_(start) {}

  // Whether third corners have divisors other than 1.
  static constexpr bool has_divisors = false;

  Halfedge_index first() const { return start_.point.halfedge; }

  template <class Metric>
  Line_beginning<typename Metric::Vector> begin(Metric& metric) const
  {
    const Metric_frame<Metric> frame(complex, metric);
    const auto zero = frame.real(metric.constant(0)), one = frame.real(metric.constant(1));
    return line_between(start_, metric, one, {zero, one, frame.ratios(first()).at_source}, first());
  }

  template <class Metric>
  Third_corner<typename Metric::Vector> third_corner(Metric& metric, Halfedge_index h) const
  {
    const Metric_frame<Metric> frame(complex, metric);
    const auto& ratios = frame.ratios(h);
    return {ratios.at_source, ratios.at_target, frame.real(metric.constant(1))};
  }

  // Whether it is determined how a line goes on behind a vertex.
  bool is_flat_at(Vertex_index) const { return false; }

  const Delta_complex& complex;

private:
  const Surface_direction& start_;
};

// The faces of the current triangulation. The first one contains the start.
class Current_faces
{
public:
  static constexpr bool has_divisors = true;

  Current_faces(const Exact_engine& engine, const Surface_direction& start)
    : complex(engine.connectivity()), correspondence_(engine.correspondence()), input_(correspondence_.input()),
      start_(start)
  {
    if (start.point.dimension() == 0)
      begin_at_vertex();
    else {
      const Triangle_piece piece =
        Piece_search(engine)(piece_at_source(complex, correspondence_, start.point.halfedge), start.point);
      first_ = piece.side;
      position_ = piece.gap;
    }
  }

  // A side of the first face; the start is its source if the line begins at a vertex of the input, and the face begins
  // to the right of the line.
  Halfedge_index first() const { return first_; }
  bool begins_at_input_vertex() const { return corner_.is_valid(); }

  template <class Metric>
  Line_beginning<typename Metric::Vector> begin(Metric& metric) const
  {
    using Vector = typename Metric::Vector;
    const Unfolding<Metric> unfolding(complex, correspondence_, metric);
    const auto u = unfolding.edge_beginning(first_);
    std::array<Vector, 3> corners{u.vector, u.vector, u.vector};
    if (begins_at_input_vertex()) {
      const Metric_frame<Metric> frame(input_, metric);
      Vector side = frame.real(metric.constant(1));
      for (Halfedge_index h = u.reference; h != corner_; h = input_.next_around_source(h))
        side = side * frame.ratios(h).at_source;
      std::size_t i = 0;
      for (Halfedge_index h = start_.point.halfedge; h != corner_; h = input_.next(h))
        ++i;
      corners[i] = frame.real(metric.constant(0));
      corners[(i + 1) % 3] = side;
      corners[(i + 2) % 3] = side * frame.ratios(corner_).at_source;
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        Surface_point corner{start_.point.halfedge, {0, 0, 0}};
        corner.coordinates[i] = 1;
        corners[i] = unfolding.vector_to(corner, first_, u, position_);
      }
    }
    return line_between(start_, metric, u.vector, corners, u.reference);
  }

  template <class Metric>
  Third_corner<typename Metric::Vector> third_corner(Metric& metric, Halfedge_index h) const
  {
    using Vector = typename Metric::Vector;
    const auto corner = Unfolding<Metric>(complex, correspondence_, metric).opposite_corner(complex.next(h));
    const Vector z(corner.p, corner.four_areas), s(corner.s_first + corner.s_first, metric.constant(0));
    return {z, s - z, s};
  }

  bool is_flat_at(Vertex_index v) const { return correspondence_.is_inserted(v); }

  const Delta_complex& complex;

private:
  // The first face is that where the first side of the start's face leaves the vertex, or the one to the left of that
  // side.
  void begin_at_vertex()
  {
    corner_ = start_.point.halfedge;
    for (std::size_t i = 0; start_.point.coordinates[i] == 0; ++i)
      corner_ = input_.next(corner_);
    const auto [side, position] = start_of_input_edge(complex, correspondence_, input_.source(corner_), corner_);
    first_ = position < 0 ? side : complex.prev(side);
  }

  const Correspondence& correspondence_;
  const Delta_complex& input_;
  const Surface_direction& start_;
  Halfedge_index first_;
  std::int64_t position_ = 0;
  Halfedge_index corner_; // the halfedge of the start's face that leaves the vertex where the line begins
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_FACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The point of the input at a point of a triangle of the current triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_POINT_ON_INPUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_POINT_ON_INPUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Coordinates that are positive multiples of 2^-52 and sum exactly to 1. So nothing has to be divided later, and the
// point is strictly inside the face.
std::array<double, 3> rounded_coordinates(const std::array<double, 3>& w);

// The rounded lengths of the input edges, and the shapes of its faces. They are computed on first use, by one thread:
// refinement sees few of them.
class Input_shapes
{
public:
  explicit Input_shapes(const Exact_engine& engine)
    : engine_(engine), input_(engine.correspondence().input()), squared_lengths_(input_.number_of_edges(), unknown),
      four_areas_(input_.number_of_faces(), unknown)
  {}

  // In the internal unit.
  double squared_length(Edge_index e);
  double length(Edge_index e) { return std::sqrt(squared_length(e)); }
  double four_areas(Face_index f);
  // The third corner of the face of h, in the frame of h.
  Plane_point apex(Halfedge_index h);

private:
  static constexpr double unknown = -1;

  const Exact_engine& engine_;
  const Delta_complex& input_;
  std::vector<double> squared_lengths_, four_areas_;
};

// The longest side of the box, or the longest edge of a surface without points; in the unit of the input.
double extent(const Exact_engine& engine);

// The input face that contains a piece.
Face_index input_face(const Exact_engine& engine, const Triangle_piece& piece);

// A point of the input, and the initial piece of the search for it.
struct Point_to_insert
{
  Surface_point point;
  Triangle_piece start;
};

// The point with given weights in the face of h, up to rounding: straight over the input from the corner with the
// largest weight.
// \param apex gives the third corner of the face of a halfedge of the current triangulation, in the frame of that
// \return nothing if doubles are too coarse to find it
template <class Apex>
std::optional<Point_to_insert> point_on_input(const Exact_engine& engine, Input_shapes& shapes, Halfedge_index h,
                                              std::array<double, 3> weights, const Apex& apex)
{
  const Delta_complex& complex = engine.connectivity();
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  while (weights[0] < weights[1] || weights[0] < weights[2]) {
    h = complex.next(h);
    std::rotate(weights.begin(), weights.begin() + 1, weights.end());
  }
  const auto [source, vector, reference] = Engine_numbers(engine).edge_beginning(h);
  Plane_point to_point = vector * (weights[1] + weights[2] * apex(h)); // seen from the source of h
  const auto input_apex = [&](Halfedge_index g) { return shapes.apex(g); };
  const bool leaves_corner = !correspondence.is_inserted(complex.source(h));
  Halfedge_index base = reference;
  if (leaves_corner) { // from face to face around the corner
    bool is_second_turn = false;
    for (Plane_point z = shapes.apex(base); cross_product(z, to_point) > 0; z = shapes.apex(base)) {
      const Halfedge_index next = input.next_around_source(base);
      if (input.is_border(next))
        break;
      // No corner of a triangle is larger, except by rounding if all input corners there are tiny.
      if (base == reference && std::exchange(is_second_turn, true))
        return std::nullopt;
      to_point /= z;
      base = next;
    }
  }
  // An input edge that the line crosses leaves the face by a side. The others go around a vertex that rounding has put
  // on the wrong side of the line.
  std::size_t most_edges = std::size_t(1) << 12;
  for (Halfedge_index side : {h, complex.next(h), complex.prev(h)})
    most_edges += std::size_t(correspondence.coordinates().number_of_crossings(complex.edge(side)));
  const Walk_end end = walk_straight(
    input, base, source, source + to_point, leaves_corner, input_apex, [&](Edge_index e) { return input.is_border(e); },
    most_edges);
  if (end.number_of_crossed_edges > most_edges)
    return std::nullopt;
  for (double w : end.weights)
    if (!std::isfinite(w))
      return std::nullopt;
  const Surface_point point{end.halfedge, rounded_coordinates(end.weights)};
  // Input edges that cut off the corner are crossed first, one after the other.
  const auto crossed = std::int64_t(end.number_of_crossed_edges);
  const Halfedge_index ki = complex.prev(h);
  const std::int64_t n_ki = correspondence.coordinates().number_of_crossings(complex.edge(ki));
  for (const Triangle_piece& piece : {Triangle_piece{h, crossed}, Triangle_piece{ki, n_ki - crossed}})
    if (piece.gap >= 0 && piece.gap <= correspondence.coordinates().number_of_crossings(complex.edge(piece.side)) &&
        input_face(engine, piece) == input.face(point.halfedge))
      return Point_to_insert{point, piece};
  return Point_to_insert{point, piece_at_source(complex, correspondence, point.halfedge)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_POINT_ON_INPUT_H

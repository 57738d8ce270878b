// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shapes of input faces, and which of them contains a piece.

#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

std::array<double, 3> rounded_coordinates(const std::array<double, 3>& w)
{
  constexpr std::int64_t one = std::int64_t(1) << 52;
  std::array<std::int64_t, 3> n{};
  std::size_t largest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    n[i] = (std::max)(std::int64_t(1), std::int64_t(std::llround(std::ldexp(w[i], 52))));
    if (n[i] > n[largest])
      largest = i;
  }
  n[largest] = one - n[(largest + 1) % 3] - n[(largest + 2) % 3];
  return {std::ldexp(double(n[0]), -52), std::ldexp(double(n[1]), -52), std::ldexp(double(n[2]), -52)};
}

double Input_shapes::squared_length(Edge_index e)
{
  double& s = squared_lengths_[e.idx()];
  if (s == unknown)
    s = engine_.metric().squared_length_double_double(input_, e).hi();
  return s;
}

double Input_shapes::four_areas(Face_index f)
{
  double& a = four_areas_[f.idx()];
  if (a == unknown)
    a = engine_.metric().has_area(input_, f) ? engine_.metric().four_areas_double_double(input_, f).hi() : 0;
  return a;
}

Plane_point Input_shapes::apex(Halfedge_index h)
{
  const double ij = squared_length(input_.edge(h)), jk = squared_length(input_.edge(input_.next(h))),
               ki = squared_length(input_.edge(input_.prev(h)));
  return {(ij + (ki - jk)) / (2 * ij), four_areas(input_.face(h)) / (2 * ij)};
}

double extent(const Exact_engine& engine)
{
  const Delta_complex& input = engine.correspondence().input();
  const Input_metric::Point_vector& points = engine.metric().points();
  double result = 0;
  if (points.empty()) {
    Input_shapes shapes(engine);
    for (Edge_index e : input.edges())
      result = (std::max)(result, shapes.length(e));
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = (std::numeric_limits<double>::infinity)(), high = -low;
      for (Vertex_index v : input.vertices())
        if (input.halfedge(v).is_valid()) {
          low = (std::min)(low, points[v.idx()][axis]);
          high = (std::max)(high, points[v.idx()][axis]);
        }
      result = (std::max)(result, high - low);
    }
  }
  return (std::min)(std::ldexp(result, engine.metric().unit_exponent()), (std::numeric_limits<double>::max)());
}

Face_index input_face(const Exact_engine& engine, const Triangle_piece& piece)
{
  const Delta_complex& complex = engine.connectivity();
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  const std::int64_t n = correspondence.coordinates().crossings(complex.edge(piece.side));
  if (n > 0) {
    const Halfedge_index crossed =
      Crossed_halfedges(complex, correspondence, piece.side,
                        engine.decisions().interruption)[std::size_t((std::max)(std::int64_t(0), piece.gap - 1))];
    return input.face(piece.gap > 0 ? crossed : input.opposite(crossed));
  }
  return uncrossed_input_face(complex, correspondence, piece.side);
}

} // namespace CGAL::Intrinsic_triangulations::internal

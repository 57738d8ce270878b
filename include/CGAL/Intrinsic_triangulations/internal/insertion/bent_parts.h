// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The folds of a surface that straight triangles have to follow.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_BENT_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_BENT_PARTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The part of an edge, from begin to end in the direction of its halfedge 2e; none if begin >= end.
struct Edge_part
{
  double begin = 0, end = 0;
};

// For each edge the part along which straight triangles have to run, or many would be needed to stay within a distance.
//
// A straight line between the corners opposite to an edge cuts it off by a distance that depends on how far the faces
// reach and on the angle between their directions. The edge is needed where that is more than half of the distance.
// Where two such edges form a small corner, one of them begins where the other one is so far away that a line to it
// would cut off too much.
//
// Directions are as in `sharp_edges()`. A face that is thinner than half of the distance, but long, is the edge of a
// face that reaches farther. Everything is rounded.
// \param is_fixed which edges are kept anyway
// \pre the metric has points
std::vector<Edge_part> bent_parts(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                                  const std::vector<bool>& is_fixed, double deviation);

// Makes these parts segments, as far as they are still edges of the triangulation: first inserts their ends.
// \param maximum_number of vertices; an edge for whose ends there is no room is kept whole
// \param is_segment for each edge; gets those that are added
template <class Traits>
void keep_bent_parts(Intrinsic_triangulation<Traits>& triangulation, double deviation, std::uint64_t maximum_number,
                     std::vector<bool>& is_segment)
{
  const Input_metric& metric = triangulation.input_metric();
  if (metric.points().empty())
    throw Invalid_argument_error("maximum_deviation needs a surface in space, but this one has only edge lengths");
  const Delta_complex &complex = triangulation.connectivity(), &input = triangulation.input();
  std::vector<std::array<double, 3>> points;
  for (const auto& p : metric.points())
    points.push_back({p[0], p[1], p[2]});
  std::vector<Halfedge_index> halfedges(
    input.number_of_edges()); // of the triangulation, along halfedges 2e of the input
  std::vector<bool> is_fixed(input.number_of_edges());
  for (Edge_index e : complex.edges())
    if (triangulation.is_input_edge(e) && !side_without_area(triangulation, e)) {
      const Halfedge_index h = complex.halfedge(e), along = triangulation.input_halfedge(h);
      if (triangulation.is_inserted(complex.source(h)) || triangulation.is_inserted(complex.target(h))) {
        is_fixed[input.edge(along).idx()] = true; // it was split before
        continue;
      }
      is_fixed[input.edge(along).idx()] = is_segment[e.idx()];
      halfedges[input.edge(along).idx()] = along == input.halfedge(input.edge(along)) ? h : complex.opposite(h);
    }
  const std::vector<Edge_part> parts =
    bent_parts(input, points, is_fixed, std::ldexp(deviation, -metric.unit_exponent()));
  const std::uint64_t number_before = complex.number_of_vertices();
  for (Edge_index e : input.edges()) {
    Edge_part part = parts[e.idx()];
    Halfedge_index h = halfedges[e.idx()];
    if (!h.is_valid() || is_fixed[e.idx()] || !(part.begin < part.end))
      continue;
    if ((part.begin > 0 || part.end < 1) && complex.is_self_glued(complex.edge(h)))
      continue; // an edge within one face cannot be split
    if (complex.number_of_vertices() - number_before + 2 > maximum_number)
      part = {0, 1};
    // \return the part beyond
    const auto split = [&](double t) {
      const Halfedge_index along = input.halfedge(e);
      t = std::ldexp(std::nearbyint(std::ldexp(t, 52)), -52);
      const Vertex_index v =
        Whole_triangulation<Traits>(triangulation).split_edge(h, Surface_point{along, {1 - t, t, 0}});
      is_segment.resize(complex.number_of_edges());
      Halfedge_index result;
      for (Halfedge_index to_v : Halfedges_around(complex, v)) {
        const Halfedge_index from_v = complex.opposite(to_v);
        if (!triangulation.is_input_edge(complex.edge(from_v)))
          continue;
        if (triangulation.input_halfedge(from_v) == along)
          result = from_v;
        else
          h = to_v; // the part before
      }
      return result;
    };
    if (part.end < 1)
      split(part.end);
    if (part.begin > 0)
      h = split(part.begin);
    is_segment[complex.edge(h).idx()] = true;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_BENT_PARTS_H

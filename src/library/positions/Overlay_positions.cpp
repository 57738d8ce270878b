// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Overlay_positions.

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include "Crossing_locator.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <algorithm>

namespace CGAL::Intrinsic_triangulations {

Overlay_positions::Overlay_positions(const internal::Exact_engine& engine, const Overlay& overlay,
                                     const Progress_function& progress, const internal::Block_runner& threads)
  : number_of_input_vertices_(overlay.number_of_input_vertices()),
    number_of_original_vertices_(overlay.number_of_original_vertices()),
    on_intrinsic_edge_(overlay.number_of_crossings(), internal::default_init),
    on_input_edge_(overlay.number_of_crossings(), internal::default_init)
{
  const internal::Standard_arithmetic arithmetic;
  static constexpr const char* what = "the search for the places of the crossings";
  const Delta_complex &intrinsic = engine.connectivity(), &input = engine.correspondence().input();
  for (size_type v = input.number_of_vertices(); v < intrinsic.number_of_vertices(); ++v)
    locations_.push_back(normalized(input, engine.correspondence().location(Vertex_index(v))));
  const std::size_t n = intrinsic.number_of_edges();
  const auto make_all_ascending = [&](std::size_t first, std::size_t last) {
    for (std::size_t e = first; e < last; ++e)
      make_ascending(overlay, Edge_index(size_type(e)));
  };
  if (threads) {
    internal::report_progress(progress, 0, what);
    threads(n, internal::elements_of_block, [&](std::size_t first, std::size_t last) {
      find_crossings(engine, overlay, first, last, internal::Loop_progress({}, what, 0, 1, n));
    });
    threads(input.number_of_edges(), internal::elements_of_block, make_all_ascending);
  } else {
    find_crossings(engine, overlay, 0, n, internal::Loop_progress(progress, what, 0, 1, n));
    make_all_ascending(0, input.number_of_edges());
  }
}

void Overlay_positions::find_crossings(const internal::Exact_engine& engine, const Overlay& overlay, std::size_t first,
                                       std::size_t last, const internal::Loop_progress& progress)
{
  const Delta_complex& intrinsic = engine.connectivity();
  const internal::Surface_lease surface = engine.input_surface();
  const Delta_complex& input = engine.correspondence().input();
  internal::Crossing_locator locate(intrinsic, engine.correspondence(), *surface);
  internal::Crossed_edges crossed;
  for (std::size_t i = first; i < last; ++i) {
    progress.at(i);
    const Edge_index e{size_type(i)};
    const Overlay::Range<Overlay::Vertex> crossings = overlay.intrinsic_crossings(e);
    if (crossings.empty())
      continue;
    internal::find_crossed_edges(overlay, input, crossings, crossed);
    double before = 0;
    auto x = crossings.begin();
    for (const internal::Position_on_edges& position : locate(e, crossed)) {
      on_intrinsic_edge_[index(*x)] = before = (std::max)(before, position.on_intrinsic_edge);
      on_input_edge_[index(*x)] = position.on_input_edge;
      ++x;
    }
  }
}

std::pair<double, double> Overlay_positions::ends_on_input_halfedge(const Overlay& overlay, Overlay::Halfedge h) const
{
  const Halfedge_index side = overlay.input_halfedge(h);
  const auto position = [&](Overlay::Vertex v, double at_vertex) {
    return v.idx() < number_of_input_vertices_ ? at_vertex : along(side, on_its_input_edge(v));
  };
  return {position(overlay.source(h), 0), position(overlay.target(h), 1)};
}

std::pair<double, double> Overlay_positions::ends_on_intrinsic_halfedge(const Overlay& overlay,
                                                                        Overlay::Halfedge h) const
{
  const Halfedge_index side = overlay.intrinsic_halfedge(h);
  const auto position = [&](Overlay::Vertex v, double at_vertex) {
    return overlay.is_crossing(v) ? along(side, on_intrinsic_edge(v)) : at_vertex;
  };
  return {position(overlay.source(h), 0), position(overlay.target(h), 1)};
}

double Overlay_positions::fraction(const Overlay& overlay, Overlay::Segment s) const
{
  const Overlay::Halfedge h = overlay.halfedge(s);
  const auto [begin, end] = overlay.label(s) == Segment_label::INPUT ? ends_on_input_halfedge(overlay, h)
                                                                     : ends_on_intrinsic_halfedge(overlay, h);
  return end - begin;
}

void Overlay_positions::make_ascending(const Overlay& overlay, Edge_index input_edge)
{
  const size_type n = overlay.number_of_input_segments(input_edge);
  if (n < 3)
    return;
  double last = 0;
  size_type first = 0; // the first crossing after the last inserted vertex
  for (size_type i = 0; i + 1 < n; ++i) {
    const Overlay::Vertex v = overlay.input_crossing(input_edge, i);
    if (overlay.is_crossing(v)) {
      double& position = on_input_edge_[index(v)];
      last = position = (std::max)(last, position);
      continue;
    }
    last = on_its_input_edge(v); // which is where it is
    for (; first < i; ++first) {
      double& position = on_input_edge_[index(overlay.input_crossing(input_edge, first))];
      position = (std::min)(last, position);
    }
    first = i + 1;
  }
}

double Overlay_positions::on_its_input_edge(Overlay::Vertex v) const
{
  if (v.idx() >= number_of_original_vertices_)
    return on_input_edge(v);
  const Surface_point& p = location(v); // in the direction of its halfedge
  return along(p.halfedge, p.coordinates[1]);
}

Surface_point Overlay_positions::normalized(const Delta_complex& input, const Surface_point& point)
{
  const Halfedge_index side = point.dimension() == 1 ? internal::side_of(input, point) : point.halfedge;
  return {side, internal::with_sum_one(coordinates_from(input, point, side))};
}

} // namespace CGAL::Intrinsic_triangulations

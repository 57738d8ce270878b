// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Triple_overlay.h.

#include "Triple_overlay.h"
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr double same_place = 0x1p-44; // on an edge of length 1

} // namespace

Triple_overlay::Triple_overlay(const Common_subdivision& subdivision, const Delta_complex& ideal,
                               const Overlay& ideal_overlay, const std::vector<double>& lengths,
                               const std::vector<double>& u, const Progress_function& progress)
  : subdivision_(subdivision), intrinsic_(subdivision.intrinsic()), ideal_(ideal), ideal_overlay_(ideal_overlay),
    lengths_(lengths), ideal_crossings_(ideal_overlay.number_of_crossings()), on_edges_(intrinsic_.number_of_edges())
{
  const Overlay& overlay = subdivision.overlay();
  const double middle =
    u.empty() ? 0 : (*std::max_element(u.begin(), u.end()) + *std::min_element(u.begin(), u.end())) / 2;
  for (double x : u)
    weights_.push_back(std::exp(middle - x));
  for (Overlay::Vertex v : overlay.vertices()) {
    const Delta_complex& input = subdivision.input();
    if (overlay.is_crossing(v)) {
      const double t = subdivision.positions().on_input_edge(v);
      nodes_.push_back({input.halfedge(overlay.input_edge(v)), {1 - t, t, 0}});
    } else if (overlay.is_inserted(v)) {
      nodes_.push_back(subdivision.positions().location(v));
    } else {
      const Halfedge_index h = input.halfedge(overlay.original_vertex(v));
      nodes_.push_back({h.is_valid() ? input.opposite(h) : h, {1, 0, 0}});
    }
  }
  first_ideal_node_ = std::uint32_t(nodes_.size());
  nodes_.resize(nodes_.size() + ideal_overlay.number_of_crossings());
  node_weights_.resize(nodes_.size());
  std::copy(weights_.begin(), weights_.end(), node_weights_.begin());
  for (Edge_index e : ideal.edges()) {
    if (e.idx() % 1024 == 0)
      report_progress(progress, 0, "the overlay of three triangulations");
    place_ideal_crossings(e);
  }
  for (Edge_index e : intrinsic_.edges())
    merge(e);
  divide_faces(progress);
}

// λ-lengths from both ends of an edge of C to the ends of the edges of B that it crosses: by Ptolemy's formula from each to
// the next, so nothing cancels. With s and t the ends, j to the left and i to the right,
//   λ_jt λ_js X_i + λ_it λ_is X_j  and  (λ_ij / λ_st) (λ_it λ_jt X_s + λ_is λ_js X_t)
// are the same point.
void Triple_overlay::place_ideal_crossings(Edge_index e)
{
  const auto crossings = ideal_overlay_.intrinsic_crossings(e);
  if (crossings.empty())
    return;
  const auto length = [this](Halfedge_index h) { return lengths_[intrinsic_.edge(h).idx()]; };
  struct Gate
  {
    Halfedge_index halfedge; // from right to left: the face before it is its own
    double left_s, right_s, left_t, right_t;
  };
  std::vector<Gate> gates;
  for (Overlay::Vertex x : crossings)
    gates.push_back({ideal_overlay_.crossing_input_halfedge(x), 0, 0, 0, 0});
  const Halfedge_index first = gates.front().halfedge, last = intrinsic_.opposite(gates.back().halfedge);
  gates.front().left_s = length(intrinsic_.next(first));
  gates.front().right_s = length(intrinsic_.prev(first));
  gates.back().right_t = length(intrinsic_.next(last));
  gates.back().left_t = length(intrinsic_.prev(last));
  const auto leaves_at_right = [&](std::size_t k) { // whether gate k and the next one share the right end
    return gates[k + 1].halfedge == intrinsic_.next(intrinsic_.opposite(gates[k].halfedge));
  };
  // Across the diagonal d, from the sides a and b beside the far end.
  const auto far = [&](double to_a, double a, double to_b, double b, double d) { return (to_a * b + to_b * a) / d; };
  for (std::size_t k = 0; k + 1 < gates.size(); ++k) {
    const Halfedge_index g = gates[k].halfedge, front = intrinsic_.opposite(g);
    const double apex =
      far(gates[k].left_s, length(intrinsic_.prev(front)), gates[k].right_s, length(intrinsic_.next(front)), length(g));
    const bool right = leaves_at_right(k);
    gates[k + 1].left_s = right ? apex : gates[k].left_s;
    gates[k + 1].right_s = right ? gates[k].right_s : apex;
  }
  for (std::size_t k = gates.size() - 1; k > 0; --k) {
    const Halfedge_index g = gates[k].halfedge; // its face is between the gates
    const double apex =
      far(gates[k].right_t, length(intrinsic_.prev(g)), gates[k].left_t, length(intrinsic_.next(g)), length(g));
    const bool right = leaves_at_right(k - 1);
    gates[k - 1].left_t = right ? apex : gates[k].left_t;
    gates[k - 1].right_t = right ? gates[k].right_t : apex;
  }
  const Halfedge_index front = intrinsic_.opposite(gates.back().halfedge);
  const double whole = far(gates.back().left_s, length(intrinsic_.prev(front)), gates.back().right_s,
                           length(intrinsic_.next(front)), length(front));
  const Halfedge_index along = ideal_.halfedge(e);
  const double weight_s = weights_[ideal_.source(along).idx()], weight_t = weights_[ideal_.target(along).idx()];
  std::size_t k = 0;
  for (Overlay::Vertex x : crossings) {
    const Gate& g = gates[k++];
    const double at_i = g.left_t * g.left_s, at_j = g.right_t * g.right_s;
    const double at_s = g.right_t * g.left_t * weight_s, at_t = g.right_s * g.left_s * weight_t;
    const double from_right = at_j / (at_i + at_j);
    Ideal_crossing& crossing = ideal_crossings_[x.idx() - ideal_overlay_.number_of_original_vertices()];
    crossing.position = (g.halfedge.idx() & 1) ? at_i / (at_i + at_j) : from_right;
    crossing.t = at_t / (at_s + at_t);
    double& weight = node_weights_[first_ideal_node_ + x.idx() - ideal_overlay_.number_of_original_vertices()];
    weight = length(g.halfedge) / whole * (at_s + at_t) / (at_i + at_j);
    if (!(crossing.position >= 0 && crossing.position <= 1 && crossing.t >= 0 && crossing.t <= 1 && weight > 0 &&
          std::isfinite(weight)))
      throw Numerical_error("lengths of the conformal map leave the range of double");
  }
}

// The crossings with edges of A, and those with edges of C, are each in order.
void Triple_overlay::merge(Edge_index e)
{
  std::vector<On_edge>& merged = on_edges_[e.idx()];
  std::vector<On_edge> ideal;
  const Overlay& overlay = subdivision_.overlay();
  for (Overlay::Vertex v : overlay.intrinsic_crossings(e))
    merged.push_back({subdivision_.positions().on_intrinsic_edge(v), v.idx(), false});
  for (std::uint32_t i = 0; i + 1 < ideal_overlay_.number_of_input_segments(e); ++i) {
    const std::uint32_t x = ideal_overlay_.input_crossing(e, i).idx() - ideal_overlay_.number_of_original_vertices();
    const double before = ideal.empty() ? 0 : ideal.back().position;
    ideal.push_back({(std::max)(ideal_crossings_[x].position, before), first_ideal_node_ + x, true});
  }
  // Where three circumcircles are one, edges of A and of C cross B at the same place, which only rounding tells apart.
  auto near = merged.begin();
  for (On_edge& x : ideal) {
    while (near != merged.end() && near->position < x.position - same_place)
      ++near;
    if (near != merged.end() && near->position <= x.position + same_place)
      x.position = near->position;
  }
  std::vector<On_edge> both(merged.size() + ideal.size());
  std::merge(merged.begin(), merged.end(), ideal.begin(), ideal.end(), both.begin(),
             [](const On_edge& x, const On_edge& y) { return x.position < y.position; });
  Part_of_input part{e, 0, 0, 1};
  std::vector<double> ends;
  for (const On_edge& x : merged)
    ends.push_back(x.position);
  ends.push_back(1);
  part.to = ends.front();
  for (const On_edge& x : both)
    if (x.is_ideal)
      nodes_[x.node] = place_on_input(part, x.position);
    else
      part = {e, part.number + 1, x.position, ends[part.number + 1]};
  merged = std::move(both);
}

// A part of the edge between two crossings with A lies in one face of A.
Surface_point Triple_overlay::place_on_input(const Part_of_input& part, double position) const
{
  const Input_layer layer(subdivision_);
  const Overlay::Halfedge h =
    layer.overlay.halfedge(layer.overlay.intrinsic_segments(part.edge).begin()[std::ptrdiff_t(part.number)]);
  const double t = fraction_of(position, part.from, part.to);
  if (const Halfedge_index along = layer.overlay.input_halfedge(h); along.is_valid()) {
    const auto [begin, end] = layer.positions.ends_on_input_halfedge(layer.overlay, h);
    const double x = begin + t * (end - begin);
    return {along, {1 - x, x, 0}};
  }
  const Halfedge_index side = layer.complex.halfedge(layer.overlay.input_face(layer.overlay.face(h)));
  const Coordinates p = corner_coordinates(layer, layer.overlay.opposite(h), side),
                    q = corner_coordinates(layer, h, side);
  Surface_point result{side, {}};
  for (std::size_t k = 0; k < 3; ++k)
    result.coordinates[k] = (1 - t) * p[k] + t * q[k];
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

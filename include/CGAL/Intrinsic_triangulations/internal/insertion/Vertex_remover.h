// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removal of a flat vertex from a triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_VERTEX_REMOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_VERTEX_REMOVER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/settle_around.h>

#include <CGAL/enum.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Flips the edges at a vertex until a split can be undone. doc/termination.md says why this ends.
template <class Traits, class ConstraintMap>
class Vertex_remover
{
public:
  Vertex_remover(Intrinsic_triangulation<Traits>& triangulation, Vertex_index v, const ConstraintMap& is_constrained)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), v_(v), is_constrained_(is_constrained)
  {}

  Removed_elements remove()
  {
    const std::vector<Halfedge_index> fixed = fixed_edges();
    for (Halfedge_index h : edges_at_vertex()) {
      changed_.push_back(complex_.edge(h));
      if (!complex_.is_border(h))
        changed_.push_back(complex_.edge(complex_.prev(h)));
    }
    std::optional<Removed_elements> removed;
    if (fixed.empty()) {
      while (edges_at_vertex().size() > 3 && flip_one())
        continue;
      removed = undo_split();
    } else {
      while (flip_one())
        continue;
      const std::size_t sides = complex_.is_border(complex_.edge(fixed[0])) ? 1 : 2;
      if (edges_at_vertex().size() == 2 + sides && is_simple_star())
        removed = Whole_triangulation<Traits>(triangulation_).unsplit_edge(fixed[0]);
    }
    if (!removed) {
      settle(triangulation_, is_constrained_, changed_, [](Edge_index) {});
      throw Invalid_removal_error(
        "vertex " + std::to_string(v_.idx()) +
        " cannot be removed: edges lead from it back to itself, and flips do not end that. Keep it");
    }
    settle_after(*removed);
    return *removed;
  }

private:
  static constexpr std::size_t most_turns = 200;

  void settle_after(const Removed_elements& removed)
  {
    std::vector<Edge_index> stack;
    for (Edge_index e : changed_)
      if (std::find(removed.edges.begin(), removed.edges.end(), e) == removed.edges.end())
        stack.push_back(removed.edge_after(e));
    const auto is_constrained = boost::make_function_property_map<Edge_index, bool>(
      [&](Edge_index e) { return get(is_constrained_, removed.edge_before(e)); });
    settle(triangulation_, is_constrained, stack, [](Edge_index) {});
  }

  // The halfedges that point to the vertex, clockwise.
  std::vector<Halfedge_index> edges_at_vertex() const
  {
    std::vector<Halfedge_index> result;
    for (Halfedge_index h : Halfedges_around(complex_, v_))
      result.push_back(h);
    return result;
  }

  bool is_fixed(Edge_index e) const { return complex_.is_border(e) || get(is_constrained_, e); }

  std::vector<Halfedge_index> fixed_edges() const
  {
    const Normal_coordinates& coordinates = engine(triangulation_).correspondence().coordinates();
    std::vector<Halfedge_index> result;
    bool are_halves = true;
    for (Halfedge_index h : edges_at_vertex())
      if (is_fixed(complex_.edge(h))) {
        result.push_back(h);
        are_halves = are_halves && coordinates.is_original(complex_.edge(h));
      }
    if (!result.empty() && !(result.size() == 2 && are_halves))
      throw Invalid_removal_error("vertex " + std::to_string(v_.idx()) +
                                  " is an end of constrained edges that are not the two "
                                  "halves of an input edge: remove the constraints first");
    return result;
  }

  // Flips an edge so that fewer edges end at the vertex, loops first. If loops prevent that, flips an edge that leaves
  // their number unchanged: the one flipped longest ago, so that bands between loops are turned in one direction, not
  // back and forth.
  bool flip_one()
  {
    for (int wanted : {2, 1})
      for (Halfedge_index h : edges_at_vertex())
        if (flip(complex_.edge(h), wanted))
          return true;
    if (turned_.size() == most_turns)
      return false;
    std::vector<Edge_index> edges;
    for (Halfedge_index h : edges_at_vertex())
      edges.push_back(complex_.edge(h));
    const auto last_turn = [this](Edge_index e) {
      return std::find(turned_.rbegin(), turned_.rend(), e) - turned_.rbegin();
    };
    std::stable_sort(edges.begin(), edges.end(),
                     [&](Edge_index e, Edge_index f) { return last_turn(e) > last_turn(f); });
    for (Edge_index e : edges)
      if (flip(e, 0)) {
        turned_.push_back(e);
        return true;
      }
    return false;
  }

  // Flips an edge if this many fewer edges end at the vertex afterwards.
  bool flip(Edge_index e, int fewer)
  {
    if (is_fixed(e) || !complex_.is_flippable(e))
      return false;
    const Hinge_halfedges around = complex_.hinge(e);
    const auto ends = [this](Halfedge_index a, Halfedge_index b) {
      return int(complex_.target(a) == v_) + int(complex_.target(b) == v_);
    };
    if (ends(around.ij, around.ji) - ends(around.jk, around.il) != fewer)
      return false;
    if (triangulation_.flip(e) != Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED)
      return false;
    for (Halfedge_index side : {around.ij, around.jk, around.ki, around.il, around.lj})
      changed_.push_back(complex_.edge(side));
    return true;
  }

  // Whether the faces around the vertex are different, and the edges lead elsewhere.
  bool is_simple_star() const
  {
    std::vector<Face_index> faces;
    for (Halfedge_index h : edges_at_vertex()) {
      if (complex_.source(h) == v_)
        return false;
      faces.push_back(complex_.face(h)); // at most one of them does not exist
    }
    std::sort(faces.begin(), faces.end());
    return std::adjacent_find(faces.begin(), faces.end()) == faces.end();
  }

  std::optional<Removed_elements> undo_split()
  {
    const std::vector<Halfedge_index> edges = edges_at_vertex();
    if (!is_simple_star())
      return std::nullopt;
    if (edges.size() == 3)
      return Whole_triangulation<Traits>(triangulation_).unsplit_face(v_);
    if (edges.size() == 4) // the vertex lies on a diagonal of the quadrilateral
      for (std::size_t i : {0, 1})
        if (is_straight(edges[i], edges[i + 1]))
          return Whole_triangulation<Traits>(triangulation_).unsplit_edge(edges[i]);
    return std::nullopt;
  }

  // Whether the angles at the vertex in the faces of these two halfedges sum to pi.
  bool is_straight(Halfedge_index h, Halfedge_index following) const
  {
    const Bounded_angle unknown{0, std::numeric_limits<double>::infinity()};
    return compare_angle_sum_with_pi(engine(triangulation_),
                                     {{complex_.prev(h), unknown}, {complex_.prev(following), unknown}}) == EQUAL;
  }

  Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  Vertex_index v_;
  const ConstraintMap& is_constrained_;
  std::vector<Edge_index> turned_;  // by flips that took no edge from the vertex
  std::vector<Edge_index> changed_; // that may not be Delaunay any more
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_VERTEX_REMOVER_H

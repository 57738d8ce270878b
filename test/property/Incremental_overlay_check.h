// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Requirements on an overlay graph that is updated by flips, and its comparison with an overlay built at the end.

#ifndef IDT_TEST_PROPERTY_INCREMENTAL_OVERLAY_CHECK_H
#define IDT_TEST_PROPERTY_INCREMENTAL_OVERLAY_CHECK_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

class Incremental_overlay_check
{
  using Vertex = Incremental_overlay::Vertex;
  using Halfedge = Incremental_overlay::Halfedge;

public:
  explicit Incremental_overlay_check(const Incremental_overlay& overlay)
    : graph_(overlay), input_(overlay.input()), intrinsic_(overlay.intrinsic())
  {}

  // The first defect, or nothing.
  std::string defect()
  {
    const bool is_valid = has_valid_links() && has_valid_crossings() &&
                          has_valid_edges(
                            intrinsic_, "intrinsic", [&](Halfedge_index h) { return graph_.first_part(h); },
                            [&](Halfedge h) { return graph_.intrinsic_halfedge(h); }) &&
                          has_valid_edges(
                            input_, "input", [&](Halfedge_index h) { return graph_.first_part_in_input(h); },
                            [&](Halfedge h) { return graph_.input_halfedge(h); }) &&
                          has_valid_faces();
    return is_valid ? std::string() : defect_;
  }

private:
  bool fails(const std::string& element, const char* what)
  {
    defect_ = element + ": " + what;
    return false;
  }
  static std::string name(Halfedge h) { return "part " + std::to_string(h.idx()); }

  template <class Function>
  bool for_all_parts(const Function& holds) const
  {
    for (std::uint32_t i = 0; i < graph_.halfedges_.size(); ++i)
      if (graph_.is_in_use(Halfedge(i)) && !holds(Halfedge(i)))
        return false;
    return true;
  }

  bool has_valid_links()
  {
    std::size_t number_in_use = 0;
    const bool are_linked = for_all_parts([&](Halfedge h) {
      ++number_in_use;
      for (Halfedge other : {graph_.next(h), graph_.prev(h)})
        if (other.idx() >= graph_.halfedges_.size() || !graph_.is_in_use(other))
          return fails(name(h), "next or prev is not in use");
      if (graph_.prev(graph_.next(h)) != h || graph_.next(graph_.prev(h)) != h)
        return fails(name(h), "next and prev are not inverse to each other");
      if (graph_.source(graph_.next(h)) != graph_.target(h))
        return fails(name(h), "the next one does not start at the target");
      return true;
    });
    return are_linked && (number_in_use == 2 * std::size_t(graph_.number_of_segments()) ||
                          fails("graph", "the number of segments is wrong"));
  }

  // Four segments meet at a crossing, and opposite ones belong to the same edge.
  bool has_valid_crossings()
  {
    std::vector<std::uint8_t> degree(graph_.end_of_crossings_, 0);
    const bool are_crossings = for_all_parts([&](Halfedge h) {
      const Vertex x = graph_.target(h);
      if (!graph_.is_crossing(x))
        return true;
      if (++degree[x.idx()] > 4)
        return fails(name(h), "ends in a crossing of more than four parts");
      Halfedge around = h;
      for (int i = 0; i < 4; ++i)
        around = graph_.opposite(graph_.next(around));
      const Halfedge left = graph_.next(h), ahead = graph_.straight_on(h);
      if (around != h || ahead == graph_.opposite(h))
        return fails(name(h), "does not end in a crossing of four parts");
      if (graph_.intrinsic_halfedge(ahead) != graph_.intrinsic_halfedge(h) ||
          graph_.input_halfedge(ahead) != graph_.input_halfedge(h))
        return fails(name(h), "does not go straight on at a crossing");
      if (graph_.intrinsic_halfedge(h).is_valid() == graph_.intrinsic_halfedge(left).is_valid() ||
          graph_.input_halfedge(h).is_valid() == graph_.input_halfedge(left).is_valid())
        return fails(name(h), "is not crossed by an edge of the other triangulation");
      return true;
    });
    if (!are_crossings)
      return false;
    std::size_t number_of_crossings = 0;
    for (std::uint8_t d : degree)
      number_of_crossings += d == 4;
    return number_of_crossings == graph_.number_of_crossings() || fails("graph", "the number of crossings is wrong");
  }

  // The parts of each halfedge follow each other from its source to its target, where the next
  // halfedge of its face is the first clockwise.
  template <class FirstPart, class HalfedgeOf>
  bool has_valid_edges(const Delta_complex& complex, const char* which, const FirstPart& first_part,
                       const HalfedgeOf& halfedge_of)
  {
    std::size_t number_of_parts = 0, expected_number = 0;
    for (Halfedge_index h : complex.halfedges()) {
      const auto halfedge_fails = [&](const char* what) {
        return fails(std::string(which) + " halfedge " + std::to_string(h.idx()), what);
      };
      Halfedge part = first_part(h);
      if (part.idx() >= graph_.halfedges_.size() || halfedge_of(part) != h ||
          graph_.source(part).idx() != complex.source(h).idx())
        return halfedge_fails("does not begin with its first part");
      for (++number_of_parts; graph_.is_crossing(graph_.target(part)); ++number_of_parts)
        part = graph_.straight_on(part);
      if (graph_.target(part).idx() != complex.target(h).idx() ||
          part != graph_.opposite(first_part(complex.opposite(h))))
        return halfedge_fails("does not end with its last part");
      Halfedge after = graph_.next(part);
      while (!halfedge_of(after).is_valid())
        after = graph_.next(graph_.opposite(after));
      if (after != first_part(complex.next(h)))
        return halfedge_fails("is not followed by the next one");
    }
    for_all_parts([&](Halfedge h) {
      expected_number += halfedge_of(h).is_valid();
      return true;
    });
    return number_of_parts == expected_number || fails(which, "some part belongs to no edge");
  }

  bool has_valid_faces()
  {
    std::int64_t faces = 0;
    std::vector<bool> is_visited(graph_.halfedges_.size(), false);
    const bool are_faces = for_all_parts([&](Halfedge first) {
      if (is_visited[first.idx()])
        return true;
      const bool is_border = is_border_part(first);
      int sides = 0;
      Face_index input_face, intrinsic_face;
      Halfedge h = first;
      do {
        is_visited[h.idx()] = true;
        ++sides;
        if (is_border_part(h) != is_border || !is_same_face(intrinsic_, graph_.intrinsic_halfedge(h), intrinsic_face) ||
            !is_same_face(input_, graph_.input_halfedge(h), input_face))
          return fails(name(h), "its face is not in one face of both triangulations");
        h = graph_.next(h);
      } while (h != first);
      if (is_border)
        return true;
      ++faces;
      return sides >= 3 || fails(name(h), "its face has fewer than three sides");
    });
    if (!are_faces)
      return false;
    // Without the vertices of the surface, which both sides of the equation have.
    const std::int64_t characteristic =
      std::int64_t(graph_.number_of_crossings()) - std::int64_t(graph_.number_of_segments()) + faces;
    return characteristic == std::int64_t(input_.number_of_faces()) - std::int64_t(input_.number_of_edges()) ||
           fails("graph", "the Euler characteristic is not that of the surface");
  }

  bool is_border_part(Halfedge h) const
  {
    return graph_.input_halfedge(h).is_valid() && input_.is_border(graph_.input_halfedge(h));
  }

  static bool is_same_face(const Delta_complex& complex, Halfedge_index h, Face_index& face)
  {
    if (!h.is_valid())
      return true;
    if (!face.is_valid())
      face = complex.face(h);
    return face == complex.face(h);
  }

  const Incremental_overlay& graph_;
  const Delta_complex& input_;
  const Delta_complex& intrinsic_;
  std::string defect_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

namespace overlay_check {

namespace IT = CGAL::Intrinsic_triangulations;

// The first defect goes to std::cerr.
inline bool is_sound(const std::string& what_is_wrong)
{
  if (!what_is_wrong.empty())
    std::cerr << what_is_wrong << std::endl;
  return what_is_wrong.empty();
}

// Whether the segments form the edges of both triangulations, alternate at crossings, leave each vertex in the right
// order, and bound faces that each lie in one input and one intrinsic face and have at least three sides, since
// straight lines meet once.
inline bool is_valid(const IT::Incremental_overlay& overlay)
{
  return is_sound(IT::internal::Incremental_overlay_check(overlay).defect());
}

// The difference between the two, or nothing. Crossings are numbered differently: the numbers of `incremental` are
// found along the intrinsic edges.
inline std::string difference_of_overlays(const IT::Overlay& overlay, const IT::Incremental_overlay& incremental)
{
  using Halfedge = IT::Overlay::Halfedge;
  using Vertex = IT::Overlay::Vertex;
  if (overlay.number_of_intrinsic_edges() != incremental.intrinsic().number_of_edges())
    return "they are of different surfaces";
  std::vector<Vertex> in_incremental(overlay.number_of_vertices());
  for (IT::Edge_index e : incremental.intrinsic().edges()) {
    const auto edge = [&](const char* what) { return "intrinsic edge " + std::to_string(e.idx()) + what; };
    Halfedge part = incremental.first_part(incremental.intrinsic().halfedge(e));
    if (overlay.input_halfedge(overlay.halfedge(*overlay.intrinsic_segments(e).begin())) !=
        incremental.input_halfedge(part))
      return edge(" does not coincide with the same input halfedge");
    for (Vertex x : overlay.intrinsic_crossings(e)) {
      if (!incremental.is_crossing(incremental.target(part)) ||
          overlay.crossing_input_halfedge(x) != incremental.input_halfedge(incremental.next(part)))
        return edge(" does not cross the same input halfedges");
      in_incremental[x.idx()] = incremental.target(part);
      part = incremental.straight_on(part);
    }
    if (incremental.is_crossing(incremental.target(part)))
      return edge(" does not cross the same number of input edges");
  }
  for (IT::Edge_index e : incremental.input().edges()) {
    const auto edge = [&](const char* what) { return "input edge " + std::to_string(e.idx()) + what; };
    Halfedge part = incremental.first_part_in_input(incremental.input().halfedge(e));
    for (std::uint32_t i = 0; i + 1 < overlay.number_of_input_segments(e); ++i) {
      if (in_incremental[overlay.input_crossing(e, i).idx()] != incremental.target(part))
        return edge(" does not have the same crossings");
      part = incremental.straight_on(part);
    }
    if (incremental.is_crossing(incremental.target(part)))
      return edge(" does not have the same number of crossings");
  }
  return std::string();
}

// Whether each edge of both triangulations has the same crossings in the same order, and the same edges coincide, in
// the same direction. The numbers of segments and crossings may differ.
inline bool are_same_overlay(const IT::Overlay& overlay, const IT::Incremental_overlay& incremental)
{
  return is_sound(difference_of_overlays(overlay, incremental));
}

} // namespace overlay_check

#endif // IDT_TEST_PROPERTY_INCREMENTAL_OVERLAY_CHECK_H

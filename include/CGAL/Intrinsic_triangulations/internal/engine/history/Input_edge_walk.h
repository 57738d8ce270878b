// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds the input edge that crosses an edge at some place.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_INPUT_EDGE_WALK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_INPUT_EDGE_WALK_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Rotation_system.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// The input halfedge that follows h counterclockwise around a vertex v. A vertex on an input edge has only two.
inline Halfedge_index next_input_halfedge(const Correspondence& correspondence, Vertex_index v, Halfedge_index h)
{
  const Delta_complex& input = correspondence.input();
  return correspondence.is_inserted(v) ? input.opposite(h) : input.next_around_source(h);
}

// Calls `visit` with the n input halfedges that leave the source of ki between ki and the next halfedge around it,
// counterclockwise. Those that leave a vertex within a triangle are consecutive around it.
template <class Visit>
void for_each_start(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index ki,
                    std::int64_t n, const Visit& visit)
{
  if (n == 0)
    return;
  const Vertex_index v = complex.source(ki);
  Halfedge_index start = correspondence.input_halfedge(ki);
  if (correspondence.coordinates().is_original(complex.edge(ki)))
    start = next_input_halfedge(correspondence, v, start);
  for (visit(start); n > 1; --n)
    visit(start = next_input_halfedge(correspondence, v, start));
}

// An input edge on its way through the triangles, each time it enters one.
class Input_edge_walk
{
public:
  // It crosses h to the left, this many crossings after the source of h.
  Input_edge_walk(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index h,
                  std::int64_t position)
    : complex_(complex), correspondence_(correspondence), halfedge_(h), position_(position)
  {}

  // Goes through a triangle. Returns whether the edge ends there.
  bool step()
  {
    const Triangle_crossings t = correspondence_.coordinates().triangle_crossings(complex_, halfedge_);
    const Halfedge_index jk = complex_.next(halfedge_), ki = complex_.prev(halfedge_);
    if (position_ < t.c_i) {
      halfedge_ = complex_.opposite(ki);
      return false;
    }
    if (position_ >= t.c_i + t.e_k) {
      position_ += number_of_crossings(jk) - number_of_crossings(halfedge_); // the distance from j stays
      halfedge_ = complex_.opposite(jk);
      return false;
    }
    end_ = correspondence_.input_halfedge(ki);
    const bool is_original = correspondence_.coordinates().is_original(complex_.edge(ki));
    steps_to_end_ = position_ - t.c_i + (is_original ? 1 : 0);
    end_vertex_ = complex_.source(ki);
    return true;
  }

  // The vertex where the edge ended, and the edge as the input halfedge that leaves it.
  Vertex_index end_vertex() const { return end_vertex_; }
  Halfedge_index end() const
  {
    Halfedge_index result = end_;
    for (std::int64_t i = steps_to_end_; i > 0; --i)
      result = next_input_halfedge(correspondence_, end_vertex_, result);
    return result;
  }
  // The same in O(1). \param around the rotation system of the input
  Halfedge_index end(const Rotation_system& around) const
  {
    return !correspondence_.is_inserted(end_vertex_)
             ? around.advanced(correspondence_.input(), end_, std::uint64_t(steps_to_end_))
             : end();
  }

private:
  std::int64_t number_of_crossings(Halfedge_index h) const
  {
    return correspondence_.coordinates().number_of_crossings(complex_.edge(h));
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  Halfedge_index halfedge_, end_; // the end, after this many more steps
  std::int64_t position_, steps_to_end_ = 0;
  Vertex_index end_vertex_;
};

// The way in which an input halfedge leaves a vertex of the current triangulation.
struct Input_edge_start
{
  Halfedge_index side;   // it coincides with this one, or goes through a triangle and crosses this side of it
  std::int64_t position; // the number of crossings after the source of the side; negative if it coincides
};

// O(number of edges around v).
// \pre the input halfedge leaves v, or v lies on it
Input_edge_start start_of_input_edge(const Delta_complex& complex, const Correspondence& correspondence, Vertex_index v,
                                     Halfedge_index input_halfedge);

// The input face in which a halfedge begins, or the one to its left if it begins on an input edge.
Face_index uncrossed_input_face(const Delta_complex& complex, const Correspondence& correspondence, Halfedge_index h);

// The input halfedge that crosses h from the left to the right, this many crossings after the source of h. The input
// edge is followed in both directions until one end is found. Time: twice the number of triangles to the nearer end.
Halfedge_index crossed_input_halfedge(const Delta_complex& complex, const Correspondence& correspondence,
                                      Halfedge_index h, std::int64_t position, const Interruption& interruption);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_INPUT_EDGE_WALK_H

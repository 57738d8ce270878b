// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From normal coordinates and roundabouts to the overlay graph, in linear time.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_BUILDER_H

#include <CGAL/Intrinsic_triangulations/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/Progress_function.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/Overlay_arrays.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The segments of intrinsic edges and all crossings are numbered by counting. Then each
// input edge is followed once through the intrinsic triangles; at every crossing it is known
// which four segments meet. What is left are the corners at the vertices, where input edges
// leave between intrinsic ones, and the faces.
//
// Most intrinsic triangles are input triangles; they are copied with few accesses to memory,
// which are what takes the time.
class Overlay_builder
{
  using size_type = Overlay_arrays::size_type;

public:
  Overlay_builder(const Delta_complex& intrinsic, const Correspondence& correspondence,
                  const Progress_function& progress)
    : intrinsic_(intrinsic), input_(correspondence.input()), correspondence_(correspondence),
      coordinates_(correspondence.coordinates()), progress_(progress)
  {
    CGAL_precondition(correspondence.is_prepared());
  }

  Overlay_arrays build()
  {
    number_intrinsic_segments();
    follow_input_edges();
    fill_faces();
    name_vertex_halfedges();
    return std::move(overlay_);
  }

private:
  void number_intrinsic_segments()
  {
    overlay_.number_of_original_vertices = intrinsic_.number_of_vertices();
    std::uint64_t crossings = 0, coinciding = 0;
    overlay_.first_segments.resize(intrinsic_.number_of_edges(), default_init);
    for (Edge_index e : intrinsic_.edges()) {
      overlay_.first_segments[e.idx()] = size_type(e.idx() + crossings);
      crossings += std::uint64_t(coordinates_.number_of_crossings(e));
      coinciding += coordinates_.is_original(e) ? 1 : 0;
      check_size(crossings); // each term is below 2^61: the sum cannot wrap before
    }
    // Each chord that an input edge cuts out of an intrinsic triangle adds a face.
    const std::uint64_t number_of_chords = crossings + input_.number_of_edges() - coinciding;
    const std::uint64_t number_of_segments = 2 * (intrinsic_.number_of_edges() + crossings) - coinciding;
    check_size(number_of_segments);
    overlay_.first_input_segment = size_type(intrinsic_.number_of_edges() + crossings);
    next_input_segment_ = overlay_.first_input_segment;

    overlay_.halfedges.resize(2 * number_of_segments, default_init);
    overlay_.parents.resize(number_of_segments, default_init);
    overlay_.vertex_halfedges.resize(intrinsic_.number_of_vertices() + crossings, default_init);
    overlay_.faces.resize(intrinsic_.number_of_faces() + number_of_chords, default_init);
    overlay_.coinciding_halfedges.resize(intrinsic_.number_of_edges(), default_init);
    overlay_.input_edges.resize(input_.number_of_edges(), default_init);

    const Loop_progress progress = part(0, 0.4, intrinsic_.number_of_edges());
    size_type segment = 0, crossing = intrinsic_.number_of_vertices();
    for (Edge_index e : intrinsic_.edges()) {
      progress.at(e.idx());
      const Halfedge_index h = intrinsic_.halfedge(e);
      size_type from = intrinsic_.source(h).idx();
      for (std::int64_t i = coordinates_.number_of_crossings(e); i > 0; --i) {
        overlay_.parents[segment] = e.idx();
        overlay_.vertex_halfedges[crossing] = 2 * segment;
        set_intrinsic_segment(segment++, from, crossing);
        from = crossing++;
      }
      overlay_.parents[segment] = e.idx();
      set_intrinsic_segment(segment, from, intrinsic_.target(h).idx());
      overlay_.coinciding_halfedges[e.idx()] = Overlay_arrays::null;
      if (coordinates_.is_original(e))
        note_coinciding(h, segment);
      for (Halfedge_index side : {h, intrinsic_.opposite(h)})
        if (intrinsic_.is_border(side)) // a border edge is one segment
          record(first_part(side)).next = first_part(intrinsic_.next(side));
      ++segment;
    }
  }

  static void check_size(std::uint64_t number_of_segments)
  {
    if (number_of_segments >= std::uint64_t(1) << 31)
      throw Integer_overflow_error(
        "the overlay has 2^31 segments or more: too many edges cross each other");
  }

  void note_coinciding(Halfedge_index h, size_type segment)
  {
    const Halfedge_index in_input = correspondence_.input_halfedge(h);
    overlay_.coinciding_halfedges[intrinsic_.edge(h).idx()] = in_input.idx();
    overlay_.input_edges[input_.edge(in_input).idx()] = {2 * segment + (in_input.idx() & 1), 1};
  }

  // The faces are not known yet; those of border halfedges never will be.
  void set_intrinsic_segment(size_type segment, size_type source, size_type target)
  {
    record(2 * segment) = {Overlay_arrays::null, target, Overlay_arrays::null};
    record(2 * segment + 1) = {Overlay_arrays::null, source, Overlay_arrays::null};
  }

  void set_ends(size_type segment, size_type source, size_type target)
  {
    record(2 * segment).target = target;
    record(2 * segment + 1).target = source;
  }

  // The n input halfedges that leave the corner opposite to ij. Those that leave a vertex within
  // an intrinsic triangle are consecutive around it.
  template <class Function>
  void for_each_start(Halfedge_index ij, std::int64_t n, const Function& function) const
  {
    if (n == 0)
      return;
    const Halfedge_index ki = intrinsic_.prev(ij);
    Halfedge_index start = correspondence_.input_halfedge(ki);
    if (coordinates_.is_original(intrinsic_.edge(ki)))
      start = input_.next_around_source(start);
    for (std::int64_t i = 0; i < n; ++i, start = input_.next_around_source(start))
      function(start, i);
  }

  // Where an input edge leaves a corner, the opposite side is crossed.
  void follow_input_edges()
  {
    const Loop_progress progress = part(0.4, 0.7, intrinsic_.number_of_edges());
    for (Edge_index e : intrinsic_.edges()) {
      progress.at(e.idx());
      if (coordinates_.crossings(e) <= 0)
        continue;
      for (Halfedge_index h : {intrinsic_.halfedge(e), intrinsic_.opposite(intrinsic_.halfedge(e))})
        for_each_start(h, coordinates_.triangle_crossings(intrinsic_, h).e_k,
                       [&](Halfedge_index input_halfedge, std::int64_t i) {
                         if (input_halfedge == input_.halfedge(input_.edge(input_halfedge)))
                           follow(input_halfedge, h, i);
                       });
    }
  }

  // Follows an input halfedge that leaves a corner as number `start` of those there and
  // crosses the opposite side ij.
  void follow(Halfedge_index input_halfedge, Halfedge_index ij, std::int64_t start)
  {
    const size_type edge = input_.edge(input_halfedge).idx();
    const size_type first = next_input_segment_;
    size_type from = input_.source(input_halfedge).idx();
    std::int64_t position = coordinates_.triangle_crossings(intrinsic_, ij).c_i + start;
    while (true) {
      // It leaves the triangle to the left of ij at `position`, counted from i.
      const size_type crossing = cross(ij, position);
      overlay_.parents[next_input_segment_] = edge;
      set_ends(next_input_segment_++, from, crossing);
      from = crossing;

      const std::int64_t n = coordinates_.number_of_crossings(intrinsic_.edge(ij));
      const Halfedge_index ji = intrinsic_.opposite(ij);
      position = n - 1 - position;
      const Triangle_crossings t = coordinates_.triangle_crossings(intrinsic_, ji);
      if (position < t.c_i) { // around the source of ji
        ij = intrinsic_.prev(ji);
        position = coordinates_.number_of_crossings(intrinsic_.edge(ij)) - 1 - position;
      } else if (position < t.c_i + t.e_k) {
        break;
      } else { // around its target
        ij = intrinsic_.next(ji);
        position = n - 1 - position;
      }
    }
    overlay_.parents[next_input_segment_] = edge;
    set_ends(next_input_segment_++, from, input_.target(input_halfedge).idx());
    overlay_.input_edges[edge] = {2 * first, next_input_segment_ - first};
  }

  // Links the four segments where the current input segment leaves the triangle to the left
  // of ij; returns the crossing.
  size_type cross(Halfedge_index ij, std::int64_t position)
  {
    const Edge_index e = intrinsic_.edge(ij);
    const bool is_from_left = ij == intrinsic_.halfedge(e);
    if (!is_from_left)
      position = coordinates_.number_of_crossings(e) - 1 - position;
    const size_type before = overlay_.first_segments[e.idx()] + size_type(position);
    // Out of the crossing, counterclockwise from the direction of halfedge 2e.
    const size_type ahead = 2 * (before + 1), back = 2 * before + 1;
    size_type left = 2 * next_input_segment_ + 1, right = 2 * (next_input_segment_ + 1);
    if (!is_from_left)
      std::swap(left, right);
    link(ahead, left);
    link(left, back);
    link(back, right);
    link(right, ahead);
    return overlay_.number_of_original_vertices + before - e.idx();
  }

  // Two consecutive halfedges out of a vertex, counterclockwise: the face between them.
  void link(size_type out, size_type next_out) { record(next_out ^ 1).next = out; }

  size_type first_part(Halfedge_index h) const
  {
    const size_type e = intrinsic_.edge(h).idx();
    if (h == intrinsic_.halfedge(Edge_index(e)))
      return 2 * overlay_.first_segments[e];
    return 2 * (overlay_.intrinsic_segments_end(e) - 1) + 1;
  }

  size_type first_part_in_input(Halfedge_index h) const
  {
    const Overlay_arrays::Input_edge& edge = overlay_.input_edges[input_.edge(h).idx()];
    return h == input_.halfedge(input_.edge(h)) ? edge.first_halfedge
                                                : (edge.first_halfedge + 2 * (edge.count - 1)) ^ 1;
  }

  void fill_faces()
  {
    const Loop_progress progress = part(0.7, 1, intrinsic_.number_of_faces());
    size_type face = 0;
    for (Face_index f : intrinsic_.faces()) {
      progress.at(f.idx());
      const Halfedge_index ij = intrinsic_.halfedge(f), jk = intrinsic_.next(ij),
                           ki = intrinsic_.prev(ij);
      if (is_one_segment(ij) && is_one_segment(jk) && is_one_segment(ki)) {
        copy_input_face(face++, f, first_part(ij), first_part(jk), first_part(ki));
        continue;
      }
      const Triangle_crossings crossings = coordinates_.triangle_crossings(intrinsic_, ij);
      link_corner(ij, crossings.e_k);
      link_corner(jk, crossings.e_i);
      link_corner(ki, crossings.e_j);
      for (Halfedge_index h : {ij, jk, ki})
        for_each_part(h, [&](size_type part) {
          if (record(part).face == Overlay_arrays::null)
            make_face(face++, part, f);
        });
    }
    CGAL_postcondition(face == overlay_.faces.size());
  }

  bool is_one_segment(Halfedge_index h) const
  {
    const size_type e = intrinsic_.edge(h).idx();
    return overlay_.intrinsic_segments_end(e) - overlay_.first_segments[e] == 1;
  }

  void copy_input_face(size_type face, Face_index f, size_type ij, size_type jk, size_type ki)
  {
    record(ij).next = jk;
    record(jk).next = ki;
    record(ki).next = ij;
    record(ij).face = record(jk).face = record(ki).face = face;
    overlay_.faces[face] = {ij, f.idx(), input_face(overlay_.input_halfedge(ij))};
  }

  // The corner opposite to ij, where n input halfedges leave.
  void link_corner(Halfedge_index ij, std::int64_t n)
  {
    size_type out = first_part(intrinsic_.prev(ij));
    for_each_start(ij, n, [&](Halfedge_index input_halfedge, std::int64_t) {
      const size_type next_out = first_part_in_input(input_halfedge);
      link(out, next_out);
      out = next_out;
    });
    link(out, first_part(intrinsic_.opposite(intrinsic_.next(ij))));
  }

  size_type input_face(size_type input_halfedge) const
  {
    return input_.face(Halfedge_index(input_halfedge)).idx();
  }

  template <class Function>
  void for_each_part(Halfedge_index h, const Function& function)
  {
    const size_type e = intrinsic_.edge(h).idx();
    const size_type direction = h == intrinsic_.halfedge(Edge_index(e)) ? 0 : 1;
    for (size_type s = overlay_.first_segments[e]; s < overlay_.intrinsic_segments_end(e); ++s)
      function(2 * s + direction);
  }

  // Each face has a side on an intrinsic edge, and one on an input edge. (A face bounded by
  // input edges alone would be an input triangle with its corners at those of an intrinsic
  // one: the same triangle, with sides of label oc.)
  void make_face(size_type face, size_type first, Face_index intrinsic_face)
  {
    size_type input_halfedge = Overlay_arrays::null, h = first;
    do {
      record(h).face = face;
      if (input_halfedge == Overlay_arrays::null)
        input_halfedge = overlay_.input_halfedge(h);
      h = record(h).next;
    } while (h != first);
    overlay_.faces[face] = {first, intrinsic_face.idx(), input_face(input_halfedge)};
  }

  void name_vertex_halfedges()
  {
    for (Vertex_index v : intrinsic_.vertices()) {
      const Halfedge_index h = intrinsic_.halfedge(v);
      overlay_.vertex_halfedges[v.idx()] =
        h.is_valid() ? first_part(intrinsic_.opposite(h)) ^ 1 : Overlay_arrays::null;
    }
  }

  Loop_progress part(double begin, double end, std::size_t number_of_elements) const
  {
    return Loop_progress(progress_, "the construction of the overlay", begin, end, number_of_elements);
  }

  Overlay_arrays::Halfedge& record(size_type h) { return overlay_.halfedges[h]; }

  const Delta_complex& intrinsic_;
  const Delta_complex& input_;
  const Correspondence& correspondence_;
  const Normal_coordinates& coordinates_;
  const Progress_function& progress_;
  Overlay_arrays overlay_;
  size_type next_input_segment_ = 0;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_BUILDER_H

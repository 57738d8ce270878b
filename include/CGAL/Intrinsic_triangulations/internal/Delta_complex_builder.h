// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From glued sides to halfedge arrays. Side 3f + i runs from corner i of face f to
// corner i + 1.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELTA_COMPLEX_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELTA_COMPLEX_BUILDER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

using Defect = Invalid_surface_error::Defect;

inline void check_size(std::size_t number_of_halfedges)
{
  if (number_of_halfedges >= (std::numeric_limits<std::uint32_t>::max)())
    throw Invalid_surface_error(Defect::OUT_OF_RANGE, 0, 1,
                                "the surface has too many edges for 32-bit indices");
}

// A border halfedge wins, as the complex wants it.
inline void set_vertex_halfedges(const Delta_complex::Halfedge_vector& records,
                                 Delta_complex::Descriptor_vector& vertex_halfedges)
{
  for (std::size_t h = 0; h < records.size(); ++h) {
    Halfedge_index& current = vertex_halfedges[records[h].target];
    if (!current.is_valid() || records[h].face == Face_index::null_index())
      current = Halfedge_index(std::uint32_t(h));
  }
}

class Delta_complex_builder
{
public:
  template <class TriangleRange>
  static Delta_complex from_triangles(std::size_t number_of_vertices, const TriangleRange& triangles)
  {
    Delta_complex_builder b;
    for (const auto& t : triangles)
      for (int i = 0; i < 3; ++i)
        b.corner_vertex_.push_back(checked_corner(t, i, b.corner_vertex_.size() / 3,
                                                  number_of_vertices));
    check_size(2 * b.corner_vertex_.size());
    b.number_of_vertices_ = number_of_vertices;
    b.glue_by_end_vertices();
    Delta_complex complex = b.assemble();
    check_fans(complex);
    return complex;
  }

  template <class SidePairRange>
  static Delta_complex from_gluing(std::size_t number_of_faces, const SidePairRange& glued_sides)
  {
    check_size(6 * number_of_faces);
    Delta_complex_builder b;
    b.glued_to_.assign(3 * number_of_faces, null);
    std::size_t pair = 0;
    for (const auto& sides : glued_sides) {
      const std::size_t s = std::size_t(sides[0]), t = std::size_t(sides[1]);
      const char* defect = nullptr;
      if (s >= b.glued_to_.size() || t >= b.glued_to_.size())
        defect = "names a side that does not exist";
      else if (s == t)
        defect = "glues a side to itself";
      else if (b.glued_to_[s] != null || b.glued_to_[t] != null)
        defect = "glues a side that is already glued";
      if (defect)
        throw Invalid_surface_error(Defect::INVALID_GLUING, pair, 1,
                                    "glued pair " + std::to_string(pair) + " (sides " +
                                      std::to_string(s) + " and " + std::to_string(t) + ") " +
                                      defect);
      b.glued_to_[s] = std::uint32_t(t);
      b.glued_to_[t] = std::uint32_t(s);
      ++pair;
    }
    b.name_vertices();
    return b.assemble();
  }

  // As the other two, with given names: `corner_vertex[s]` is the source of side s and
  // `halfedge_of[s]` its halfedge; halfedges that no side has are border halfedges. The
  // caller has checked that glued sides have the same ends.
  static Delta_complex from_numbered_sides(std::size_t number_of_vertices,
                                           std::vector<std::uint32_t> corner_vertex,
                                           const std::vector<std::uint32_t>& halfedge_of,
                                           std::size_t number_of_edges)
  {
    Delta_complex_builder b;
    std::vector<std::uint32_t> side_of(2 * number_of_edges, null);
    for (std::size_t s = 0; s < halfedge_of.size(); ++s)
      side_of[halfedge_of[s]] = std::uint32_t(s);
    b.glued_to_.resize(halfedge_of.size());
    for (std::size_t s = 0; s < halfedge_of.size(); ++s)
      b.glued_to_[s] = side_of[halfedge_of[s] ^ 1];
    b.number_of_vertices_ = number_of_vertices;
    b.corner_vertex_ = std::move(corner_vertex);
    Delta_complex complex = b.assemble(halfedge_of, number_of_edges);
    check_fans(complex);
    return complex;
  }

private:
  static constexpr std::uint32_t null = (std::numeric_limits<std::uint32_t>::max)();

  static std::uint32_t next_side(std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; }
  static std::uint32_t previous_side(std::uint32_t s) { return s % 3 == 0 ? s + 2 : s - 1; }

  template <class Triangle>
  static std::uint32_t checked_corner(const Triangle& t, int i, std::size_t face,
                                      std::size_t number_of_vertices)
  {
    const std::size_t v = std::size_t(t[i]);
    // What was -1 before it was converted is shown as -1.
    const bool was_negative = v > (std::numeric_limits<std::size_t>::max)() / 2;
    if (v >= number_of_vertices)
      throw Invalid_surface_error(Defect::BAD_INDEX, face, 1,
                                  "face " + std::to_string(face) + " names vertex " +
                                    (was_negative ? "-" + std::to_string(std::size_t(0) - v) : std::to_string(v)) + ", but there are only " +
                                    std::to_string(number_of_vertices) + " vertices");
    if (v == std::size_t(t[(i + 1) % 3]))
      throw Invalid_surface_error(Defect::REPEATED_CORNER, face, 1,
                                  "face " + std::to_string(face) + " has vertex " +
                                    std::to_string(v) + " as two of its corners");
    return std::uint32_t(v);
  }

  // Sides are gathered by their smaller end vertex (a counting sort); within such a
  // bucket, which is as large as a vertex degree, partners are found by their larger end
  // through a table over all vertices that is written and read bucket by bucket.
  void glue_by_end_vertices()
  {
    const std::size_t n = corner_vertex_.size();
    glued_to_.assign(n, null);
    std::vector<std::uint32_t> bucket_begin(number_of_vertices_ + 2, 0), bucket(n);
    for (std::uint32_t s = 0; s < n; ++s)
      ++bucket_begin[smaller_end(s) + 2];
    for (std::size_t v = 2; v < bucket_begin.size(); ++v)
      bucket_begin[v] += bucket_begin[v - 1];
    for (std::uint32_t s = 0; s < n; ++s)
      bucket[bucket_begin[smaller_end(s) + 1]++] = s;

    std::vector<std::uint32_t> waiting(number_of_vertices_, null);
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      for (std::uint32_t i = bucket_begin[v]; i < bucket_begin[v + 1]; ++i) {
        const std::uint32_t s = bucket[i];
        std::uint32_t& partner = waiting[larger_end(s)];
        if (partner == null || smaller_end(partner) != v) {
          partner = s;
          continue;
        }
        if (glued_to_[partner] != null)
          throw_at_edge(Defect::NON_MANIFOLD_EDGE, s, "has more than two faces");
        if (corner_vertex_[partner] == corner_vertex_[s])
          throw_at_edge(Defect::INCONSISTENT_ORIENTATION, s,
                        "is traversed twice in the same direction; orient the faces first");
        glued_to_[partner] = s;
        glued_to_[s] = partner;
      }
    }
  }

  std::uint32_t side_target(std::uint32_t s) const { return corner_vertex_[next_side(s)]; }
  std::uint32_t smaller_end(std::uint32_t s) const
  {
    return (std::min)(corner_vertex_[s], side_target(s));
  }
  std::uint32_t larger_end(std::uint32_t s) const
  {
    return (std::max)(corner_vertex_[s], side_target(s));
  }

  [[noreturn]] void throw_at_edge(Defect defect, std::uint32_t s, const char* what) const
  {
    throw Invalid_surface_error(defect, s / 3, 1,
                                "edge " + std::to_string(corner_vertex_[s]) + "-" +
                                  std::to_string(side_target(s)) + " of face " +
                                  std::to_string(s / 3) + " " + what);
  }

  // Vertices are the orbits of corners: around the source of a side, the next side is
  // the one after its partner, or, at the boundary, there is none.
  void name_vertices()
  {
    const std::uint32_t n = std::uint32_t(glued_to_.size());
    corner_vertex_.assign(n, null);
    std::uint32_t number = 0;
    for (std::uint32_t first = 0; first < n; ++first) {
      if (corner_vertex_[first] != null)
        continue;
      std::uint32_t s = first;
      do { // clockwise
        corner_vertex_[s] = number;
        s = glued_to_[s] == null ? null : next_side(glued_to_[s]);
      } while (s != null && s != first);
      if (s == null) // the rest of the fan, counterclockwise
        for (s = glued_to_[previous_side(first)]; s != null; s = glued_to_[previous_side(s)])
          corner_vertex_[s] = number;
      ++number;
    }
    number_of_vertices_ = number;
  }

  Delta_complex assemble() const
  {
    const std::uint32_t n = std::uint32_t(glued_to_.size());
    std::vector<std::uint32_t> halfedge_of(n);
    std::uint32_t number_of_edges = 0;
    for (std::uint32_t s = 0; s < n; ++s)
      halfedge_of[s] = glued_to_[s] < s ? halfedge_of[glued_to_[s]] + 1 : 2 * number_of_edges++;
    return assemble(halfedge_of, number_of_edges);
  }

  Delta_complex assemble(const std::vector<std::uint32_t>& halfedge_of,
                         std::size_t number_of_edges) const
  {
    const std::uint32_t n = std::uint32_t(glued_to_.size());
    Delta_complex::Halfedge_vector records(2 * number_of_edges, default_init);
    Delta_complex::Descriptor_vector face_halfedges(n / 3), vertex_halfedges(number_of_vertices_);
    for (std::uint32_t s = 0; s < n; ++s) {
      Delta_complex::Halfedge& r = records[halfedge_of[s]];
      r.next = halfedge_of[next_side(s)];
      r.prev = halfedge_of[previous_side(s)];
      r.target = corner_vertex_[next_side(s)];
      r.face = s / 3;
      if (s % 3 == 0)
        face_halfedges[s / 3] = Halfedge_index(halfedge_of[s]);
    }
    // The border halfedge opposite to side s is followed by the one opposite to the last
    // side of the fan that begins with s, turning around the source of s.
    for (std::uint32_t s = 0; s < n; ++s) {
      if (glued_to_[s] != null)
        continue;
      std::uint32_t t = previous_side(s);
      while (glued_to_[t] != null)
        t = previous_side(glued_to_[t]);
      Delta_complex::Halfedge& r = records[halfedge_of[s] ^ 1];
      r.next = halfedge_of[t] ^ 1;
      r.target = corner_vertex_[s];
      r.face = Face_index::null_index();
      records[halfedge_of[t] ^ 1].prev = halfedge_of[s] ^ 1;
    }
    set_vertex_halfedges(records, vertex_halfedges);
    return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
  }

  // Sides glued by their end vertices can leave two fans at one vertex.
  static void check_fans(const Delta_complex& complex)
  {
    std::vector<bool> is_visited(complex.number_of_halfedges(), false);
    for (Vertex_index v : complex.vertices()) {
      const Halfedge_index first = complex.halfedge(v);
      if (!first.is_valid())
        continue;
      Halfedge_index h = first;
      do {
        is_visited[h.idx()] = true;
        h = complex.next_around_target(h);
      } while (h != first);
    }
    for (Halfedge_index h : complex.halfedges())
      if (!is_visited[h.idx()]) {
        const std::size_t v = complex.target(h).idx();
        throw Invalid_surface_error(Defect::NON_MANIFOLD_VERTEX, v, 1,
                                    "the faces at vertex " + std::to_string(v) +
                                      " form more than one fan; duplicate the vertex first");
      }
  }

  std::size_t number_of_vertices_ = 0;
  std::vector<std::uint32_t> corner_vertex_; // of each side, its source
  std::vector<std::uint32_t> glued_to_;      // of each side, its partner
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELTA_COMPLEX_BUILDER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Delta_complex_builder.

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void check_size(std::size_t number_of_halfedges)
{
  if (number_of_halfedges >= (std::numeric_limits<std::uint32_t>::max)())
    throw Invalid_surface_error(Defect::OUT_OF_RANGE, 0, 1, "the surface has too many edges for 32-bit indices");
}

inline bool is_triangle(const Delta_complex& complex, Halfedge_index h)
{
  const Halfedge_index last = complex.next(complex.next(h));
  return last == complex.prev(h) && last != h;
}

void check_triangles(const Delta_complex& complex)
{
  std::size_t first = 0, count = 0;
  for (Face_index f : complex.faces())
    if (!is_triangle(complex, complex.halfedge(f))) {
      first = count == 0 ? f.idx() : first;
      ++count;
    }
  if (count > 0)
    throw Invalid_surface_error(Defect::NOT_A_TRIANGLE, first, count,
                                "face " + std::to_string(first) + " is not a triangle (" + std::to_string(count) +
                                  " such faces); triangulate the faces first");
}

Delta_complex Delta_complex_builder::from_glued_sides(std::size_t number_of_vertices,
                                                      Large_vector<std::uint32_t> corner_vertex,
                                                      Large_vector<std::uint32_t> glued_to, std::uint32_t first_side)
{
  Delta_complex_builder b;
  b.number_of_vertices_ = number_of_vertices;
  b.corner_vertex_ = std::move(corner_vertex);
  b.glued_to_ = std::move(glued_to);
  const auto n = std::count(b.glued_to_.begin(), b.glued_to_.end(), null);
  b.number_of_glued_pairs_ = (b.glued_to_.size() - std::size_t(n)) / 2;
  b.first_side_ = first_side;
  return b.assemble();
}

// The halfedge of a side, and whether the opposite halfedge is on the border.
struct Delta_complex_builder::Numbered_side
{
  std::uint32_t halfedge;
  bool is_at_border;
};

Delta_complex Delta_complex_builder::from_numbered_sides(std::size_t number_of_vertices,
                                                         const std::vector<std::uint32_t>& corner_vertex,
                                                         const std::vector<std::uint32_t>& halfedge_of,
                                                         std::size_t number_of_edges)
{
  Delta_complex_builder b;
  std::vector<std::uint32_t> side_of(2 * number_of_edges, null);
  for (std::size_t s = 0; s < halfedge_of.size(); ++s)
    side_of[halfedge_of[s]] = std::uint32_t(s);
  b.number_of_vertices_ = number_of_vertices;
  b.corner_vertex_.assign(corner_vertex.begin(), corner_vertex.end());
  const auto given_halfedge = [&](std::uint32_t s) {
    return Numbered_side{halfedge_of[s], side_of[halfedge_of[s] ^ 1] == null};
  };
  Delta_complex complex = b.assemble(number_of_edges, given_halfedge);
  check_fans(complex);
  return complex;
}

void Delta_complex_builder::throw_bad_corner(const std::array<std::size_t, 3>& corners, std::size_t face) const
{
  const std::string name = "face " + std::to_string(face);
  for (int i = 0; i < 3; ++i) {
    const std::size_t v = corners[i];
    if (v >= number_of_vertices_)
      throw Invalid_surface_error(Defect::BAD_INDEX, face, 1,
                                  name + " names vertex " + index_text(v) + ", but there are only " +
                                    std::to_string(number_of_vertices_) + " vertices");
    if (v == corners[(i + 1) % 3])
      throw Invalid_surface_error(Defect::REPEATED_CORNER, face, 1,
                                  name + " has vertex " + std::to_string(v) + " as two of its corners");
  }
}

// Sides are gathered by their smaller end vertex (a counting sort). Within such a bucket, which is about as large as a
// vertex degree, a table over all vertices finds partners by their larger end: an entry counts if it points into the
// bucket.
void Delta_complex_builder::glue_by_end_vertices()
{
  glued_to_ = Side_vector(corner_vertex_.size(), null);
  Side_vector bucket_begin = std::move(bucket_begin_);
  for (std::size_t v = 2; v < bucket_begin.size(); ++v)
    bucket_begin[v] += bucket_begin[v - 1];
  Large_vector<Side_at_edge> sides(corner_vertex_.size(), default_init);
  const auto gather = [&](std::uint32_t s, std::uint32_t i, std::uint32_t j) {
    sides[bucket_begin[(std::min)(i, j) + 1]++] = {(std::max)(i, j), 2 * s + (i > j ? 1 : 0)};
  };
  for (std::uint32_t s = 0; s < corner_vertex_.size(); s += 3) {
    const std::uint32_t i = corner_vertex_[s], j = corner_vertex_[s + 1], k = corner_vertex_[s + 2];
    gather(s, i, j);
    gather(s + 1, j, k);
    gather(s + 2, k, i);
  }

  Side_vector waiting(number_of_vertices_, null); // positions in sides
  for (std::size_t v = 0; v < number_of_vertices_; ++v) {
    const std::uint32_t begin = bucket_begin[v];
    for (std::uint32_t i = begin; i < bucket_begin[v + 1]; ++i) {
      const Side_at_edge side = sides[i];
      std::uint32_t& position = waiting[side.larger_end];
      if (position < begin || position >= i) {
        position = i;
        continue;
      }
      const std::uint32_t s = side.side(), partner = sides[position].side();
      if (glued_to_[partner] != null)
        throw_at_edge(Defect::NON_MANIFOLD_EDGE, s, "has more than two faces");
      if (side.runs_to_smaller_end() == sides[position].runs_to_smaller_end()) {
        // Two of three faces always agree, so turning one does not help.
        for (std::uint32_t other = i + 1; other < bucket_begin[v + 1]; ++other)
          if (sides[other].larger_end == side.larger_end)
            throw_at_edge(Defect::NON_MANIFOLD_EDGE, sides[other].side(), "has more than two faces");
        throw_at_edge(Defect::INCONSISTENT_ORIENTATION, s,
                      "is traversed twice in the same direction; orient the faces first");
      }
      glued_to_[partner] = s;
      glued_to_[s] = partner;
      ++number_of_glued_pairs_;
    }
  }
}

void Delta_complex_builder::throw_at_edge(Defect defect, std::uint32_t s, const char* what) const
{
  throw Invalid_surface_error(defect, s / 3, 1,
                              "edge " + std::to_string(corner_vertex_[s]) + "-" +
                                std::to_string(corner_vertex_[next_side(s)]) + " of face " + std::to_string(s / 3) +
                                " " + what);
}

// Each fan gets a vertex of its own.
void Delta_complex_builder::name_vertices()
{
  auto [vertices, corner_vertex] =
    separate_fans(glued_to_.empty() ? 0 : 1, Side_vector(glued_to_.size(), 0), glued_to_);
  number_of_vertices_ = vertices.size();
  corner_vertex_ = std::move(corner_vertex);
}

// Edges are numbered in the order of their first sides.
Delta_complex Delta_complex_builder::assemble()
{
  // The first side of an edge writes the edge's number to the second side, in place of its partner's. This bit marks
  // such a number: sides and edges both have numbers below it.
  constexpr std::uint32_t is_edge = std::uint32_t(1) << 31;
  std::uint32_t number_of_edges = 0;
  return assemble(glued_to_.size() - number_of_glued_pairs_, [&](std::uint32_t s) {
    const std::uint32_t partner = glued_to_[s];
    if (partner == null)
      return Numbered_side{2 * number_of_edges++, true};
    const bool is_first = (partner & is_edge) == 0;
    const std::uint32_t edge = is_first ? number_of_edges : partner & ~is_edge;
    number_of_edges += is_first;
    glued_to_[is_first ? partner : s] = edge | is_edge;
    return Numbered_side{2 * edge + !is_first, false};
  });
}

// number_of(s) is called once for each side, in order.
template <class NumberOf>
Delta_complex Delta_complex_builder::assemble(std::size_t number_of_edges, const NumberOf& number_of) const
{
  const std::uint32_t n = std::uint32_t(corner_vertex_.size());
  Delta_complex::Halfedge_vector records(2 * number_of_edges, default_init);
  Delta_complex::Descriptor_vector face_halfedges(n / 3, default_init), vertex_halfedges(number_of_vertices_);
  const auto point_to = [&vertex_halfedges](std::uint32_t v, std::uint32_t h) {
    if (h < vertex_halfedges[v].idx()) // the null descriptor is larger than all
      vertex_halfedges[v] = Halfedge_index(h);
  };
  std::vector<std::uint32_t> border;
  for (std::uint32_t s = 0; s < n; s += 3) {
    const std::uint32_t v[] = {corner_vertex_[s], corner_vertex_[s + 1], corner_vertex_[s + 2]};
    const Numbered_side side[] = {number_of(s), number_of(s + 1), number_of(s + 2)};
    const std::uint32_t h[] = {side[0].halfedge, side[1].halfedge, side[2].halfedge};
    records[h[0]] = {h[1], h[2], v[1], s / 3};
    records[h[1]] = {h[2], h[0], v[2], s / 3};
    records[h[2]] = {h[0], h[1], v[0], s / 3};
    face_halfedges[s / 3] = Halfedge_index(h[first_side_]);
    point_to(v[1], h[0]);
    point_to(v[2], h[1]);
    point_to(v[0], h[2]);
    if (side[0].is_at_border || side[1].is_at_border || side[2].is_at_border)
      for (int i = 0; i < 3; ++i)
        if (side[i].is_at_border) {
          records[h[i] ^ 1] = {0, 0, v[i], Face_index::null_index()};
          border.push_back(h[i] ^ 1);
        }
  }
  link_border(border, records, vertex_halfedges);
  return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
}

// A border halfedge is followed by the opposite of the last side of the fan around its target. It becomes the halfedge
// of its target, as the complex requires.
void Delta_complex_builder::link_border(const std::vector<std::uint32_t>& border,
                                        Delta_complex::Halfedge_vector& records,
                                        Delta_complex::Descriptor_vector& vertex_halfedges)
{
  for (std::uint32_t h : border) {
    std::uint32_t t = records[h ^ 1].prev;
    while (records[t ^ 1].face != Face_index::null_index())
      t = records[t ^ 1].prev;
    records[h].next = t ^ 1;
    records[t ^ 1].prev = h;
    vertex_halfedges[records[h].target] = Halfedge_index(h);
  }
}

// Gluing sides by their end vertices can leave two fans at one vertex; then this walk misses one of them.
void Delta_complex_builder::check_fans(const Delta_complex& complex)
{
  std::size_t number_of_met = 0;
  for (Vertex_index v : complex.vertices())
    for ([[maybe_unused]] Halfedge_index h : Halfedges_around(complex, v))
      ++number_of_met;
  if (number_of_met == complex.number_of_halfedges())
    return;
  std::vector<bool> is_met(complex.number_of_halfedges(), false);
  for (Vertex_index v : complex.vertices())
    for (Halfedge_index h : Halfedges_around(complex, v))
      is_met[h.idx()] = true;
  const std::size_t h = std::size_t(std::find(is_met.begin(), is_met.end(), false) - is_met.begin());
  const std::size_t v = complex.target(Halfedge_index(std::uint32_t(h))).idx();
  throw Invalid_surface_error(Defect::NON_MANIFOLD_VERTEX, v, 1,
                              "the faces at vertex " + std::to_string(v) +
                                " form more than one fan; duplicate the vertex first");
}

} // namespace CGAL::Intrinsic_triangulations::internal

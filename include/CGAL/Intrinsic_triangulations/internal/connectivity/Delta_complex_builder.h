// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From glued sides to halfedge arrays. Side 3f + i runs from corner i of face f to
// corner i + 1.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_BUILDER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Index_triangle = std::array<std::uint32_t, 3>;

using Defect = Invalid_surface_error::Defect;

// Throws if there are more elements than descriptors.
void check_size(std::size_t number_of_halfedges);
// Throws unless all faces are triangles: a copied face graph may have other faces.
void check_triangles(const Delta_complex& complex);

inline std::uint32_t next_side(std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; }
inline std::uint32_t previous_side(std::uint32_t s) { return s % 3 == 0 ? s + 2 : s - 1; }

// A side, with the larger end of its edge; the other end is known.
struct Side_at_edge
{
  std::uint32_t larger_end;
  std::uint32_t side_and_direction; // odd if it runs to the smaller end
  std::uint32_t side() const { return side_and_direction >> 1; }
  std::uint32_t face() const { return side() / 3; }
  bool runs_to_smaller_end() const { return (side_and_direction & 1) != 0; }
};

// The first fan at each vertex keeps the vertex's number; the others are numbered after all vertices.
// \param corners for each side 3f + i, which runs from corner i of face f to corner i + 1, the vertex where it begins
// \param glued_to for each side its partner, which runs the other way, or the largest index
// \return for each fan its original vertex, and for each corner its fan
inline std::pair<std::vector<std::uint32_t>, Large_vector<std::uint32_t>>
separate_fans(std::size_t number_of_vertices, const Large_vector<std::uint32_t>& corners,
              const Large_vector<std::uint32_t>& glued_to)
{
  using Index = std::uint32_t;
  constexpr Index none = (std::numeric_limits<Index>::max)();

  std::vector<Index> vertex_of;
  vertex_of.reserve(2 * number_of_vertices);
  for (Index v = 0; v < number_of_vertices; ++v)
    vertex_of.push_back(v);
  Large_vector<Index> fan_of_corner(corners.size(), none);
  std::vector<bool> is_named(number_of_vertices, false);
  for (Index first = 0; first < corners.size(); ++first) {
    if (fan_of_corner[first] != none)
      continue;
    Index fan = corners[first];
    if (is_named[fan]) {
      vertex_of.push_back(fan);
      fan = Index(vertex_of.size() - 1);
    } else {
      is_named[fan] = true;
    }
    Index s = first;
    do { // clockwise
      fan_of_corner[s] = fan;
      s = glued_to[s] == none ? none : next_side(glued_to[s]);
    } while (s != none && s != first);
    if (s == none) // the rest, counterclockwise
      for (s = glued_to[previous_side(first)]; s != none; s = glued_to[previous_side(s)])
        fan_of_corner[s] = fan;
  }
  return {std::move(vertex_of), std::move(fan_of_corner)};
}

class Delta_complex_builder
{
public:
  template <class TriangleRange>
  static Delta_complex from_triangles(std::size_t number_of_vertices, const TriangleRange& triangles)
  {
    Delta_complex_builder b;
    b.number_of_vertices_ = number_of_vertices;
    b.read(triangles);
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
                                    "glued pair " + std::to_string(pair) + " (sides " + std::to_string(s) + " and " +
                                      std::to_string(t) + ") " + defect);
      b.glued_to_[s] = std::uint32_t(t);
      b.glued_to_[t] = std::uint32_t(s);
      ++pair;
    }
    b.number_of_glued_pairs_ = pair;
    b.name_vertices();
    return b.assemble();
  }

  // With given names: `corner_vertex[s]` is the source of side s, and `glued_to[s]` the side that it is glued to, or
  // null.
  // \param first_side the side that becomes the halfedge of its face: 0, 1 or 2
  // \pre the corners of a vertex form one fan, and glued sides have the same ends
  static Delta_complex from_glued_sides(std::size_t number_of_vertices, Large_vector<std::uint32_t> corner_vertex,
                                        Large_vector<std::uint32_t> glued_to, std::uint32_t first_side = 0);

  // As from_triangles() and from_gluing(), with given names: `corner_vertex[s]` is the source of side s and
  // `halfedge_of[s]` its halfedge; halfedges that no side has are border halfedges. The
  // caller has checked that glued sides have the same ends.
  static Delta_complex from_numbered_sides(std::size_t number_of_vertices,
                                           const std::vector<std::uint32_t>& corner_vertex,
                                           const std::vector<std::uint32_t>& halfedge_of, std::size_t number_of_edges);

private:
  static constexpr std::uint32_t null = (std::numeric_limits<std::uint32_t>::max)();

  // Copies the corners, and counts the sides of each bucket.
  template <class TriangleRange>
  void read(const TriangleRange& triangles)
  {
    const std::size_t n = std::size_t(std::distance(std::begin(triangles), std::end(triangles)));
    check_size(6 * n);
    corner_vertex_ = Side_vector(3 * n, default_init);
    bucket_begin_ = Side_vector(number_of_vertices_ + 2, 0);
    const auto count = [this](std::size_t i, std::size_t j) { ++bucket_begin_[(std::min)(i, j) + 2]; };
    std::uint32_t* corner = corner_vertex_.data();
    for (const auto& t : triangles) {
      const std::size_t i = std::size_t(t[0]), j = std::size_t(t[1]), k = std::size_t(t[2]);
      if ((std::max)({i, j, k}) >= number_of_vertices_ || i == j || j == k || k == i)
        throw_bad_corner({i, j, k}, std::size_t(corner - corner_vertex_.data()) / 3);
      *corner++ = std::uint32_t(i);
      *corner++ = std::uint32_t(j);
      *corner++ = std::uint32_t(k);
      count(i, j);
      count(j, k);
      count(k, i);
    }
  }

  void throw_bad_corner(const std::array<std::size_t, 3>& corners, std::size_t face) const;

  struct Numbered_side;
  void glue_by_end_vertices();
  [[noreturn]] void throw_at_edge(Defect defect, std::uint32_t s, const char* what) const;
  void name_vertices();
  Delta_complex assemble();
  template <class NumberOf>
  Delta_complex assemble(std::size_t number_of_edges, const NumberOf& number_of) const;
  static void link_border(const std::vector<std::uint32_t>& border, Delta_complex::Halfedge_vector& records,
                          Delta_complex::Descriptor_vector& vertex_halfedges);
  static void check_fans(const Delta_complex& complex);

  using Side_vector = Large_vector<std::uint32_t>;

  std::size_t number_of_vertices_ = 0;
  Side_vector corner_vertex_; // the source of each side
  Side_vector bucket_begin_;  // for each vertex, the number of sides of which it is the smaller end
  Side_vector glued_to_;      // the partner of each side
  std::size_t number_of_glued_pairs_ = 0;
  std::uint32_t first_side_ = 0; // the side that becomes the halfedge of its face
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_BUILDER_H

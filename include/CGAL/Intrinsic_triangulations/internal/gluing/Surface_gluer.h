// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From triangles in space to an oriented surface that is cut as little as possible.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Sides_by_edge.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Triangle_pieces.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Disjoint_sets.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Decides which triangles are turned over, which sides become one edge, and which vertices have to be copied for that.
//
// - The two sides of an edge with two faces become one, unless a one-sided surface has to be cut there.
// - At other edges, the faces are taken in their order around the edge. Counterclockwise about the edge, material lies between a face
//   that runs backward and the next one that runs forward, as in a solid whose faces point outward. Such faces are glued, and
//   what they enclose is left out; then the next ones, until none is left. So each pair bounds a set where the winding number
//   has some least value, and a solid that touches itself comes apart along the edge. Of several that could be
//   glued where solids overlap, faces of the same piece are.
// - If the solid is inside out, which its volume tells, material is on the other sides.
// - Pieces that hang on others by one edge alone, as a fin does, are glued after all others. If their number at an edge is odd, as of three sheets,
//   only faces are that belong to the same piece, or to pieces that were glued elsewhere: else they would be left as a slit in the surface.
// - If so many faces run forward at an edge as backward, nothing is turned there. If not, pieces are turned so that directions alternate
//   around each edge with an even number of faces, as they do around each solid.
// - Where faces lie in one half-plane, their order tells nothing about directions: no piece is turned because of that.
// - Triangles are given by their corners, so two edges must not have the same ends. Where two pairs at an edge would, the faces that have nothing
//   between them are glued instead: then the solid is one along the edge. If that fails as well, all are cut.
class Surface_gluer
{
  using Index = std::uint32_t;

public:
  static constexpr Index none = (std::numeric_limits<Index>::max)();

  // \pre no triangle names a vertex twice
  Surface_gluer(const Points& points, const std::vector<Index_triangle>& triangles);

  // Whether a triangle is turned over: its corners 0 and 2 are exchanged. The first of each part that edges join is not.
  bool is_turned(std::size_t face) const { return is_turned_[face]; }
  // The vertices of the surface: first those that were given, then copies; for each which one it was.
  const std::vector<Index>& vertices() const { return fans_.first; }
  // The vertex of the surface at a corner of a triangle, after it was turned.
  Index vertex(std::size_t corner) const { return fans_.second[corner]; }
  // Whether the side from a corner to the next lies on the border, after the triangle was turned.
  bool is_border(std::size_t corner) const { return glued_to_[corner] == none; }

private:
  // A side at an edge with more than two faces.
  struct Entry
  {
    Index side, piece;
    bool runs_backward, is_glued; // seen from the smaller end of the edge, before its piece is turned
  };
  enum Rule {
    MATERIAL,
    VOID,
    CUT
  };
  // The entries of an edge, in order around it.
  struct Crowded_edge
  {
    std::vector<Entry> entries;
    bool has_faces_in_one_half_plane = false, is_inside_out = false;
    Rule rule = MATERIAL;
  };
  using Entries = std::vector<Entry*>;

  void glue_simple_edges();
  void find_crowded_edges();
  void find_hanging_pieces();
  Entries entries_left(Crowded_edge& edge, bool are_hanging);
  void turn_pieces(bool are_hanging);
  void glue(Crowded_edge& edge, bool are_hanging);
  void turn_triangles();
  void separate_edges();
  bool is_double(const Crowded_edge& edge) const;
  std::vector<bool> find_inside_out(Disjoint_sets& networks);

  void glue_sides(Index s, Index t)
  {
    glued_to_[s] = t;
    glued_to_[t] = s;
  }
  bool turns(Index piece) { return (turns_.find(2 * piece) & 1) != 0; }
  bool runs_backward(const Entry& e) { return e.runs_backward != turns(e.piece); }
  void tie(Index piece, Index other, bool is_one_turned);
  std::pair<Index, Index> ends(Index side) const
  {
    const Index v = fans_.second[side], w = fans_.second[side % 3 == 2 ? side - 2 : side + 1];
    return fans_.first[v] < fans_.first[w] ? std::make_pair(v, w) : std::make_pair(w, v);
  }

  const Points& points_;
  const std::vector<Index_triangle>& triangles_;
  const Sides_by_edge sides_;
  Triangle_pieces pieces_;
  std::vector<bool> is_turned_; // of each triangle; at first, within its piece
  Large_vector<Index> glued_to_;
  std::vector<Crowded_edge> crowded_edges_;
  std::vector<bool> is_hanging_; // of each piece
  // Piece p is 2p as its first face is given and 2p + 1 turned over. The smallest number of a set is even, and so what is with it is not turned.
  Disjoint_sets turns_;
  Disjoint_sets joined_;        // pieces that were glued
  Large_vector<Index> corners_; // of the turned triangles
  std::pair<std::vector<Index>, Large_vector<Index>> fans_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/gluing/Surface_gluer_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_SURFACE_GLUER_H

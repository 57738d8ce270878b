// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Triangles that edges with two faces join, oriented alike.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_TRIANGLE_PIECES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_TRIANGLE_PIECES_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Sides_by_edge.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A piece is what edges with two faces join. The faces of each are turned so that they agree with its first, as far as
// possible: the search is breadth-first, so that faces which disagree lie far from the first and the line between them
// is short.
class Triangle_pieces
{
  using Index = std::uint32_t;
  static constexpr Index none = (std::numeric_limits<Index>::max)();

public:
  struct Piece
  {
    bool is_closed = true; // each of its edges has two faces
    Index conflict = none; // a side at which two of its faces disagree

    bool is_orientable() const { return conflict == none; }
  };
  std::vector<Piece> pieces; // in the order of their first faces
  Large_vector<Index> piece_of;
  std::vector<bool> is_turned; // of each face

  Triangle_pieces(const Sides_by_edge& sides, std::size_t number_of_faces)
    : piece_of(number_of_faces, none), is_turned(number_of_faces, false)
  {
    // Of each side twice the other one of its edge, plus 1 if both run in the same direction.
    Large_vector<Index> neighbor(3 * number_of_faces, none);
    sides.for_each_edge([&](Index, const Sides_by_edge::Side* begin, const Sides_by_edge::Side* end) {
      if (end - begin != 2)
        return;
      const Index disagree = begin[0].runs_to_smaller_end() == begin[1].runs_to_smaller_end();
      neighbor[begin[0].side()] = 2 * begin[1].side() + disagree;
      neighbor[begin[1].side()] = 2 * begin[0].side() + disagree;
    });
    std::vector<Index> faces;
    for (Index first = 0; first < number_of_faces; ++first) {
      if (piece_of[first] != none)
        continue;
      Piece piece;
      piece_of[first] = Index(pieces.size());
      faces.assign(1, first);
      for (std::size_t i = 0; i < faces.size(); ++i)
        for (Index s = 3 * faces[i]; s < 3 * faces[i] + 3; ++s) {
          if (neighbor[s] == none) {
            piece.is_closed = false;
            continue;
          }
          const Index g = neighbor[s] / 6;
          const bool wanted = is_turned[faces[i]] != ((neighbor[s] & 1) != 0);
          if (piece_of[g] == none) {
            piece_of[g] = Index(pieces.size());
            is_turned[g] = wanted;
            faces.push_back(g);
          } else if (is_turned[g] != wanted) {
            piece.conflict = s;
          }
        }
      pieces.push_back(piece);
    }
  }
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_TRIANGLE_PIECES_H

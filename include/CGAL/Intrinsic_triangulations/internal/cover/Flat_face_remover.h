// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removes faces without area from a glued surface, without changing its metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H

#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

using Vertex_number_pair = std::pair<std::uint32_t, std::uint32_t>;

// Triangles in space with glued sides. Side 3f + i runs from corner i of face f to corner i + 1.
struct Glued_faces
{
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<std::uint32_t> face_of; // for each face what it is a copy, or a part of a copy, of
  std::vector<bool> is_back;
  Large_vector<std::uint32_t> corners;  // for each side the vertex where it begins
  Large_vector<std::uint32_t> glued_to; // for each side its partner, or none

  std::size_t size() const { return face_of.size(); }
  static std::uint32_t next(std::uint32_t s) { return s % 3 == 2 ? s - 2 : s + 1; }
  static std::uint32_t previous(std::uint32_t s) { return s % 3 == 0 ? s + 2 : s - 1; }

  void glue(std::uint32_t s, std::uint32_t t)
  {
    glued_to[s] = t;
    glued_to[t] = s;
  }
  // Leaves out faces.
  void keep(const std::vector<bool>& is_kept);
};

// The longest side of a face without area leads past its third corner. Flipping it cuts the face on its other side
// there, in two triangles that lie in space as that did. Where both faces have no area, this can make an edge between
// two corners at the same place. Such an edge is shrunk to a point: its faces vanish, and their other sides are united
// in pairs. In a part that is closed and has an area, no face without area remains: from each one, longest sides lead
// over longer and longer ones to a face that has an area, or to one with the same longest side. All these flips are of
// edges that are not Delaunay.
class Flat_face_remover
{
public:
  Flat_face_remover(const Points& points, Glued_faces& faces)
    : points_(points), faces_(faces), is_kept_(faces.size(), true)
  {}

  // \param flat the faces without area
  // \return the pairs of different vertices that were found to be one point
  std::vector<Vertex_number_pair> run(std::vector<std::uint32_t> flat);

private:
  std::uint32_t longest_side(std::uint32_t face) const;
  bool is_flat(std::uint32_t face) const;
  bool find_flippable_side(std::uint32_t face, std::uint32_t& side) const;
  void flip(std::uint32_t side);
  void shrink(std::uint32_t face, std::uint32_t first, std::uint32_t second);

  const Points& points_;
  Glued_faces& faces_;
  std::vector<bool> is_kept_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/cover/Flat_face_remover_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The order of faces around an edge in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Points.h>

#include <CGAL/enum.h>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The faces at the edge from u to v in space, in the order in which a half-plane that turns counterclockwise about u→v
// meets them. The cyclic order is decided exactly. It does not depend on numbers, on how the faces are
// turned or on how everything lies in space, if that is possible:
//
// - Faces in one half-plane are ordered by where along the edge their third vertices lie, from u to v. If
//   that is the same place, then by the distance of the third vertex from the edge, the nearer first if the place is
//   beyond the middle. Exchanging u and v reverses all of this, so the cyclic order is the same for both directions.
// - Faces with the same corners lie on top of each other like sheets of paper, in the order of their numbers.
// - A face without area lies in the half-plane of the face whose third vertex is farthest from the edge.
// - Numbers decide in what remains: isosceles triangles over the same edge in one half-plane, third vertices at the same place,
//   and several farthest faces. There a rotation in space exchanges the ends of the edge.
class Faces_around_edge
{
public:
  struct Face
  {
    std::uint32_t third_vertex;
    std::uint32_t side; // what the caller knows it by; orders the sheets
  };

  // \pre u < v are at different places, and the third vertices at places different from these
  Faces_around_edge(const Points& points, std::uint32_t u, std::uint32_t v) : points_(points), u_(u), v_(v) {}

  void sort(std::vector<Face>& faces);

  // Whether no turn leads from one face to the other. A face without area is in every half-plane.
  bool are_in_one_half_plane(const Face& a, const Face& b) const { return sector(a.third_vertex, b.third_vertex) == SAME; }

private:
  // Where a half-plane is, seen from the first: in front means counterclockwise, by less than π.
  enum Sector {
    SAME,
    IN_FRONT,
    OPPOSITE,
    BEHIND
  };

  struct Placed_face
  {
    Face face;
    Sector sector;
  };

  std::uint32_t find_reference(const std::vector<Face>& faces) const;
  Sector sector(std::uint32_t reference, std::uint32_t w) const;
  bool precedes(const Placed_face& a, const Placed_face& b) const;
  bool precedes_in_half_plane(const Face& a, const Face& b) const;
  Sign orientation(std::uint32_t w, std::uint32_t x) const;
  Sign compare_distances(std::uint32_t w, std::uint32_t x) const;
  bool is_on_edge_line(std::uint32_t w) const;

  const Points& points_;
  const std::uint32_t u_, v_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/gluing/Faces_around_edge_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GLUING_FACES_AROUND_EDGE_H

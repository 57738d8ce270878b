// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A complex from the halfedges of its faces and vertices, which are not believed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPLEX_FROM_HALFEDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPLEX_FROM_HALFEDGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// What a triangulation in a file says that cannot be true.
[[noreturn]] inline void throw_not_a_triangulation(const char* kind, std::size_t element, const std::string& what)
{
  throw Invalid_surface_error(Invalid_surface_error::Defect::UNREADABLE, element, 1,
                              std::string(kind) + " " + std::to_string(element) + " " + what);
}

// The complex has the numbers of the halfedges that are given: a halfedge that no face has is on the border.
// \param faces the halfedges of each face in their order, first the one that the face names
// \param vertices for each vertex a halfedge that points to it, a border halfedge if there is one; null if it has no face
// \exception Invalid_surface_error if they are not those of an oriented surface
// O(size)
inline Delta_complex complex_from_halfedges(std::size_t number_of_edges,
                                            const Large_vector<std::array<std::uint32_t, 3>>& faces,
                                            const Large_vector<std::uint32_t>& vertices)
{
  constexpr std::uint32_t none = Halfedge_index::null_index();
  Delta_complex::Halfedge_vector records(2 * number_of_edges, Delta_complex::Halfedge{none, none, none, none});
  Delta_complex::Descriptor_vector face_halfedges, vertex_halfedges;
  face_halfedges.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t h = faces[f][i];
      if (h >= records.size() || records[h].face != none)
        throw_not_a_triangulation("face", f,
                                  "names halfedge " + std::to_string(h) +
                                    (h < records.size() ? ", which another one has" : ", which does not exist"));
      records[h] = {faces[f][(i + 1) % 3], faces[f][(i + 2) % 3], none, f};
    }
    face_halfedges.push_back(Halfedge_index(faces[f][0]));
  }
  const auto is_border = [&](std::uint32_t h) { return records[h].face == none; };
  for (std::size_t h = 0; h < records.size(); h += 2)
    if (is_border(std::uint32_t(h)) && is_border(std::uint32_t(h + 1)))
      throw_not_a_triangulation("edge", h / 2, "has no face");

  // Around each vertex counterclockwise, and in the end along the border.
  vertex_halfedges.reserve(vertices.size());
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const std::uint32_t first = vertices[v];
    vertex_halfedges.push_back(first == none ? Halfedge_index() : Halfedge_index(first));
    if (first == none)
      continue;
    if (first >= records.size())
      throw_not_a_triangulation("vertex", v, "names halfedge " + std::to_string(first) + ", which does not exist");
    std::uint32_t h = first;
    do {
      if (records[h].target != none)
        throw_not_a_triangulation(
          "vertex", v, "and vertex " + std::to_string(records[h].target) + " share halfedge " + std::to_string(h));
      records[h].target = v;
      const std::uint32_t from_v = h ^ 1;
      if (is_border(from_v)) {
        if (!is_border(first))
          throw_not_a_triangulation("vertex", v, "is on the border, and its halfedge is not");
        records[first].next = from_v;
        records[from_v].prev = first;
        break;
      }
      h = records[from_v].prev;
    } while (h != first);
  }
  for (std::size_t h = 0; h < records.size(); ++h)
    if (records[h].target == none || records[h].next == none || records[h].prev == none)
      throw_not_a_triangulation("halfedge", h, "points to no vertex");
  return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COMPLEX_FROM_HALFEDGES_H

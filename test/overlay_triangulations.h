// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the two triangulations back from their overlay.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TEST_OVERLAY_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TEST_OVERLAY_TRIANGULATIONS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>

#include <cstdint>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {

namespace internal {

// HalfedgeOf names the halfedge of the triangulation that a part belongs to, or none, and
// FaceOf the face of the triangulation that contains a face of the overlay.
template <class HalfedgeOf, class FaceOf>
Delta_complex read_triangulation(const Overlay& overlay, std::uint32_t number_of_vertices,
                                 std::uint32_t number_of_edges, const HalfedgeOf& halfedge_of, const FaceOf& face_of)
{
  using Part = Overlay::Halfedge;
  std::uint32_t number_of_faces = 0;
  for (Overlay::Face f : overlay.faces())
    if (face_of(f).idx() >= number_of_faces)
      number_of_faces = face_of(f).idx() + 1;
  Delta_complex::Halfedge_vector records(2 * std::size_t(number_of_edges));
  Delta_complex::Descriptor_vector vertex_halfedges(number_of_vertices), face_halfedges(number_of_faces);
  for (Part first : overlay.halfedges()) {
    const Halfedge_index h = halfedge_of(first);
    if (!h.is_valid() || overlay.source(first).idx() >= number_of_vertices)
      continue;
    // The edge goes on at each crossing, and an input edge at an inserted vertex.
    Part last = first;
    while (overlay.target(last).idx() >= number_of_vertices) {
      last = overlay.next(last);
      while (halfedge_of(last) != h)
        last = overlay.next(overlay.opposite(last));
    }
    // The halfedge after it is the first clockwise around its target.
    Part after = overlay.next(last);
    while (!halfedge_of(after).is_valid())
      after = overlay.next(overlay.opposite(after));
    const Vertex_index target = overlay.original_vertex(overlay.target(last));
    const Face_index face = overlay.is_border(first) ? Face_index() : face_of(overlay.face(first));
    records[h.idx()].next = halfedge_of(after).idx();
    records[halfedge_of(after).idx()].prev = h.idx();
    records[h.idx()].target = target.idx();
    records[h.idx()].face = face.idx();
    if (face.is_valid())
      face_halfedges[face.idx()] = h;
    Halfedge_index& of_vertex = vertex_halfedges[target.idx()];
    if (!of_vertex.is_valid() || !face.is_valid())
      of_vertex = h;
  }
  return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
}

} // namespace internal

// reconstructs the intrinsic triangulation from the halfedges and labels of an overlay.
//
// It has the descriptors of the triangulation from which the overlay was built; `halfedge(v)`
// and `halfedge(f)` may be different incident halfedges. O(size of the overlay).
inline Delta_complex intrinsic_triangulation_of(const Overlay& overlay)
{
  return internal::read_triangulation(
    overlay, overlay.number_of_original_vertices(), overlay.number_of_intrinsic_edges(),
    [&](Overlay::Halfedge h) { return overlay.intrinsic_halfedge(h); },
    [&](Overlay::Face f) { return overlay.intrinsic_face(f); });
}

// reconstructs the input triangulation from an overlay; as `intrinsic_triangulation_of()`.
inline Delta_complex input_triangulation_of(const Overlay& overlay)
{
  return internal::read_triangulation(
    overlay, overlay.number_of_input_vertices(), overlay.number_of_input_edges(),
    [&](Overlay::Halfedge h) { return overlay.input_halfedge(h); },
    [&](Overlay::Face f) { return overlay.input_face(f); });
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TEST_OVERLAY_TRIANGULATIONS_H

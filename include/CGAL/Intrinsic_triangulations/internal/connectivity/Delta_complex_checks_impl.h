// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether connectivity is what it should be: definitions of Delta_complex.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_CHECKS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_CHECKS_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>

#include <cstddef>
#include <iostream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Returns false, as its callers do.
template <class Descriptor>
bool report_defect(std::string& defect, Descriptor element, const char* what)
{
  defect = std::string(1, "vhef"[std::is_same<Descriptor, Halfedge_index>::value ? 1
                                 : std::is_same<Descriptor, Face_index>::value   ? 3
                                                                                 : 0]) +
           std::to_string(element.idx()) + ": " + what;
  return false;
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Delta_complex::is_valid(bool verbose) const
{
  std::string defect;
  if (has_valid_cycles(defect) && has_valid_vertices(defect))
    return true;
  if (verbose)
    std::cerr << "Delta_complex: " << defect << std::endl;
  return false;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Delta_complex::has_valid_cycles(std::string& defect) const
{
  if (halfedges_.size() % 2 != 0)
    return internal::report_defect(defect, Halfedge_index(number_of_halfedges()), "has no opposite");
  for (Halfedge_index h : halfedges()) {
    const Halfedge& r = record(h);
    if (r.next >= number_of_halfedges() || r.prev >= number_of_halfedges())
      return internal::report_defect(defect, h, "next or prev is out of range");
    if (r.target >= number_of_vertices())
      return internal::report_defect(defect, h, "target is out of range");
    if (!is_border(h) && r.face >= number_of_faces())
      return internal::report_defect(defect, h, "face is out of range");
  }
  std::size_t number_of_face_halfedges = 0;
  for (Halfedge_index h : halfedges()) {
    if (prev(next(h)) != h || next(prev(h)) != h)
      return internal::report_defect(defect, h, "next and prev are not inverse to each other");
    if (source(next(h)) != target(h))
      return internal::report_defect(defect, h, "the next halfedge does not start at the target");
    if (face(next(h)) != face(h))
      return internal::report_defect(defect, h, "the next halfedge has another face");
    if (is_border(h)) {
      if (is_border(opposite(h)))
        return internal::report_defect(defect, h, "has no face on either side");
      continue;
    }
    ++number_of_face_halfedges;
    if (next(next(next(h))) != h)
      return internal::report_defect(defect, h, "its face is not a triangle");
  }
  if (number_of_face_halfedges != 3 * std::size_t(number_of_faces()))
    return internal::report_defect(defect, Face_index(0), "faces do not have three halfedges each");
  for (Face_index f : faces())
    if (halfedge(f).idx() >= number_of_halfedges() || face(halfedge(f)) != f)
      return internal::report_defect(defect, f, "its halfedge belongs to another face");
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Delta_complex::has_valid_vertices(std::string& defect) const
{
  std::size_t number_of_visited = 0;
  for (Vertex_index v : vertices()) {
    const Halfedge_index first = halfedge(v);
    if (!first.is_valid())
      continue;
    if (first.idx() >= number_of_halfedges() || target(first) != v)
      return internal::report_defect(defect, v, "its halfedge does not point to it");
    bool meets_border = false;
    for (Halfedge_index h : internal::Halfedges_around(*this, v)) {
      meets_border = meets_border || is_border(h);
      ++number_of_visited;
    }
    if (meets_border && !is_border(first))
      return internal::report_defect(defect, v, "is on the border and its halfedge is not");
  }
  // Each halfedge points to one vertex and lies in one fan: all are visited exactly
  // if no vertex has two fans.
  if (number_of_visited != number_of_halfedges())
    return internal::report_defect(defect, Vertex_index(0), "some vertex has more than one fan of faces");
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool is_simplicial(const Delta_complex& complex)
{
  std::vector<Vertex_index> last_met_from(complex.number_of_vertices());
  for (Vertex_index v : complex.vertices())
    for (Halfedge_index h : internal::Halfedges_around(complex, v)) {
      Vertex_index& met_from = last_met_from[complex.source(h).idx()];
      if (met_from == v) // by another edge, or by the other halfedge of a loop
        return false;
      met_from = v;
    }
  // Where no two edges have the same ends, faces with the same corners share all edges.
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const Face_index g = complex.face(complex.opposite(h));
    if (g.is_valid() && complex.face(complex.opposite(complex.next(h))) == g &&
        complex.face(complex.opposite(complex.prev(h))) == g)
      return false;
  }
  return true;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_DELTA_COMPLEX_CHECKS_IMPL_H

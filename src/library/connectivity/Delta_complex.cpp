// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Delta_complex: validity, and how vertices come and go.

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

// Returns false, as its callers do.
template <class Tag>
bool report_defect(std::string& defect, Index<Tag> element, const char* what)
{
  defect = Tag::letter + std::to_string(element.idx()) + ": " + what;
  return false;
}

} // namespace internal

bool Delta_complex::is_valid(bool verbose) const
{
  std::string defect;
  if (has_valid_cycles(defect) && has_valid_vertices(defect))
    return true;
  if (verbose)
    std::cerr << "Delta_complex: " << defect << std::endl;
  return false;
}

bool Delta_complex::has_valid_cycles(std::string& defect) const
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

bool Delta_complex::has_valid_vertices(std::string& defect) const
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

bool is_simplicial(const Delta_complex& complex)
{
  std::vector<Vertex_index> last_met_from(complex.number_of_vertices());
  for (Vertex_index v : complex.vertices())
    for (Halfedge_index h : internal::Halfedges_around(complex, v)) {
      Vertex_index& met_from = last_met_from[complex.source(h).idx()];
      if (met_from == v) // by another edge, or by the other halfedge of a loop
        return false;
      met_from = v;
    }
  // If no two edges have the same ends, faces with the same corners share all edges.
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const Face_index g = complex.face(complex.opposite(h));
    if (g.is_valid() && complex.face(complex.opposite(complex.next(h))) == g &&
        complex.face(complex.opposite(complex.prev(h))) == g)
      return false;
  }
  return true;
}

// ---------------------------------------------------------------- vertices that come and go

Vertex_index Delta_complex::split_face(Halfedge_index h)
{
  CGAL_precondition(!is_border(h));
  make_room_for_vertex();
  const Halfedge_index sides[] = {h, next(h), prev(h)};
  const Vertex_index corners[] = {source(h), target(h), source(prev(h))};
  const Halfedge_index spokes = append_edges(3); // from the new vertex to i, j, k
  const Face_index f = face(h), jkv = append_faces(2), faces[] = {f, jkv, Face_index(jkv.idx() + 1)};
  const Vertex_index v(number_of_vertices());
  const auto spoke = [spokes](int i) { return Halfedge_index(spokes.idx() + 2 * i); };
  for (int i = 0; i < 3; ++i) {
    record(spoke(i)).target = corners[i].idx();
    record(opposite(spoke(i))).target = v.idx();
  }
  for (int i = 0; i < 3; ++i)
    set_face_cycle(faces[i], sides[i], opposite(spoke((i + 1) % 3)), spoke(i));
  vertex_halfedges_.push_back(opposite(spoke(0)));
  return v;
}

Vertex_index Delta_complex::split_edge(Halfedge_index h)
{
  CGAL_precondition(!is_self_glued(edge(h)));
  make_room_for_vertex();
  const Halfedge_index g = opposite(h);
  const bool has_left = !is_border(h), has_right = !is_border(g);
  const Halfedge_index jk = next(h), ki = prev(h), il = next(g), lj = prev(g);
  const Vertex_index j = target(h), k = target(jk), l = target(il), v(number_of_vertices());
  const Halfedge_index vj = append_edges(1 + (has_left ? 1 : 0) + (has_right ? 1 : 0)), jv = opposite(vj);
  const Halfedge_index vk(vj.idx() + 2), vl(vj.idx() + (has_left ? 4 : 2));
  Face_index appended = append_faces((has_left ? 1 : 0) + (has_right ? 1 : 0));
  record(h).target = v.idx();
  record(vj).target = j.idx();
  record(jv).target = v.idx();
  if (has_left) {
    record(vk).target = k.idx();
    record(opposite(vk)).target = v.idx();
    const Face_index f = face(h);
    set_face_cycle(f, h, vk, ki);
    set_face_cycle(appended, vj, jk, opposite(vk));
    appended = Face_index(appended.idx() + 1);
  } else {
    record(vj).face = Face_index().idx();
    join(h, vj);
    join(vj, jk);
  }
  if (has_right) {
    record(vl).target = l.idx();
    record(opposite(vl)).target = v.idx();
    const Face_index f = face(g);
    set_face_cycle(f, g, il, opposite(vl));
    set_face_cycle(appended, jv, vl, lj);
  } else {
    record(jv).face = Face_index().idx();
    join(lj, jv);
    join(jv, g);
  }
  vertex_halfedges_.push_back(!has_left ? h : jv);
  if (halfedge(j) == h)
    vertex_halfedges_[j.idx()] = vj;
  return v;
}

Removed_elements Delta_complex::unsplit_face(Vertex_index v)
{
  const Halfedge_index a = halfedge(v), b = next_around_target(a), c = next_around_target(b);
  CGAL_precondition(next_around_target(c) == a);
  const Halfedge_index sides[] = {prev(a), prev(c), prev(b)};
  const Face_index f = (std::min)((std::min)(face(a), face(b)), face(c)); // stays
  Removed_elements removed{{v}, {edge(a), edge(b), edge(c)}, {}};
  for (Halfedge_index h : {a, b, c})
    if (face(h) != f)
      removed.faces.push_back(face(h));
  complete(removed);
  for (Halfedge_index h : {a, b, c})
    replace_vertex_halfedge(source(h), opposite(h), prev(h));
  set_face_cycle(f, sides[0], sides[1], sides[2]);
  erase(removed);
  return removed;
}

Removed_elements Delta_complex::unsplit_edge(Halfedge_index h)
{
  const Halfedge_index g = opposite(h), vj = continuation(h), jv = opposite(vj);
  const Vertex_index v = target(h), j = target(vj);
  const Halfedge_index jk = next(vj), ki = prev(h), il = next(g), lj = prev(jv);
  Removed_elements removed{{v}, {edge(vj)}, {}};
  if (!is_border(h)) {
    removed.edges.push_back(edge(next(h)));
    removed.faces.push_back(face(vj));
    replace_vertex_halfedge(target(next(h)), next(h), jk);
  }
  if (!is_border(g)) {
    removed.edges.push_back(edge(prev(g)));
    removed.faces.push_back(face(jv));
    replace_vertex_halfedge(source(prev(g)), opposite(prev(g)), il);
  }
  complete(removed);
  replace_vertex_halfedge(j, vj, h);
  record(h).target = j.idx();
  if (!is_border(h))
    set_face_cycle(face(h), h, jk, ki);
  else
    join(h, jk);
  if (!is_border(g))
    set_face_cycle(face(g), g, il, lj);
  else
    join(lj, g);
  erase(removed);
  return removed;
}

void Delta_complex::make_room_for_vertex()
{
  constexpr std::size_t most_halfedges = 6;
  if (halfedges_.size() + most_halfedges >= Halfedge_index::null_index())
    throw Integer_overflow_error("a triangulation has 2^31 edges or more");
  internal::make_room(halfedges_, most_halfedges);
  internal::make_room(face_halfedges_, 2);
  internal::make_room(vertex_halfedges_, 1);
}

Halfedge_index Delta_complex::append_edges(int n)
{
  const Halfedge_index first(number_of_halfedges());
  halfedges_.resize(halfedges_.size() + 2 * std::size_t(n));
  return first;
}

Face_index Delta_complex::append_faces(int n)
{
  const Face_index first(number_of_faces());
  face_halfedges_.resize(face_halfedges_.size() + std::size_t(n));
  return first;
}

void Delta_complex::complete(Removed_elements& removed) const
{
  std::sort(removed.edges.rbegin(), removed.edges.rend());
  std::sort(removed.faces.rbegin(), removed.faces.rend());
  removed.number_of_edges = number_of_edges();
}

void Delta_complex::erase(const Removed_elements& removed)
{
  for (Edge_index hole : removed.edges) {
    const Edge_index last(number_of_edges() - 1);
    if (hole != last)
      move_edge(last, hole);
    halfedges_.pop_back();
    halfedges_.pop_back();
  }
  for (Face_index hole : removed.faces) {
    const Face_index last(number_of_faces() - 1);
    if (hole != last) {
      const Halfedge_index h = halfedge(last);
      set_face_cycle(hole, h, next(h), prev(h));
    }
    face_halfedges_.pop_back();
  }
  for (Vertex_index hole : removed.vertices) {
    const Vertex_index last(number_of_vertices() - 1);
    if (hole != last)
      move_vertex(last, hole);
    vertex_halfedges_.pop_back();
  }
}

void Delta_complex::move_edge(Edge_index from, Edge_index to)
{
  const auto moved = [=](std::uint32_t h) { return h >> 1 == from.idx() ? 2 * to.idx() + (h & 1) : h; };
  for (std::uint32_t side : {0u, 1u}) {
    const Halfedge_index old(2 * from.idx() + side), h(2 * to.idx() + side);
    Halfedge& r = record(h);
    r = record(old);
    r.next = moved(r.next);
    r.prev = moved(r.prev);
  }
  for (std::uint32_t side : {0u, 1u}) {
    const Halfedge_index old(2 * from.idx() + side), h(2 * to.idx() + side);
    record(next(h)).prev = h.idx();
    record(prev(h)).next = h.idx();
    replace_vertex_halfedge(target(h), old, h);
    if (!is_border(h) && halfedge(face(h)) == old)
      face_halfedges_[face(h).idx()] = h;
  }
}

void Delta_complex::move_vertex(Vertex_index from, Vertex_index to)
{
  vertex_halfedges_[to.idx()] = halfedge(from);
  for (Halfedge_index h : internal::Halfedges_around(*this, from))
    record(h).target = to.idx();
}

} // namespace CGAL::Intrinsic_triangulations

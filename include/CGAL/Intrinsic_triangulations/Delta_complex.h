// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The connectivity of a triangulated surface that need not be a simplicial
// complex: the paper's triangulations (Fisher, Springborn, Schroeder, Bobenko
// 2006, section 2) may have loops, several edges between the same vertices and
// faces that meet themselves.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Removed_elements.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/prefetch.h>
#include <CGAL/Intrinsic_triangulations/internal/system/relaxed_atomic.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/iterator/iterator_facade.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief a random access iterator over the descriptors of consecutive elements of one kind.
template <class Descriptor>
class Descriptor_iterator
  : public boost::iterator_facade<Descriptor_iterator<Descriptor>, Descriptor,
                                  std::random_access_iterator_tag, Descriptor>
{
public:
  /// constructs the iterator at the first element.
  Descriptor_iterator() = default;
  /// constructs the iterator at the element with this index.
  explicit Descriptor_iterator(std::uint32_t index) : index_(index) {}

private:
  /// \cond SKIP_IN_MANUAL
  friend class boost::iterator_core_access;
  /// \endcond
  Descriptor dereference() const { return Descriptor(index_); }
  bool equal(const Descriptor_iterator& other) const { return index_ == other.index_; }
  void increment() { ++index_; }
  void decrement() { --index_; }
  void advance(std::ptrdiff_t n) { index_ = static_cast<std::uint32_t>(index_ + n); }
  std::ptrdiff_t distance_to(const Descriptor_iterator& other) const
  {
    return std::ptrdiff_t(other.index_) - std::ptrdiff_t(index_);
  }

  std::uint32_t index_ = 0;
};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the halfedges of the two faces beside an edge ij: of (i, j, k) to its left and of (j, i, l)
/// to its right. They keep their descriptors when the edge is flipped.
struct Hinge_halfedges
{
  Halfedge_index ij; ///< halfedge `2e` of the edge
  Halfedge_index jk; ///< the next one, to the corner k on its left
  Halfedge_index ki; ///< the one before
  Halfedge_index ji; ///< halfedge `2e + 1`
  Halfedge_index il; ///< the next one, to the corner l on the right
  Halfedge_index lj; ///< the one before
};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
///
/// \brief a triangulated oriented surface, with or without boundary, as halfedge arrays.
///
/// Faces are triangles; any gluing of their sides that gives an oriented surface is
/// allowed: loops, several edges between the same two vertices, a face glued to itself,
/// a surface with one vertex. So nothing is ever looked up by its end vertices.
/// Isolated vertices are allowed, too.
///
/// Descriptors of vertices, halfedges, edges and faces are integers counted from zero, and
/// a flip changes none of them. Halfedges `2e` and `2e + 1` belong to edge `e`.
/// A halfedge without a face is a border halfedge; `next()` and `prev()` of a border
/// halfedge run along the border.
///
/// Memory: 32 bytes an edge, 4 a vertex and 4 a face.
///
/// \cgalModels `FaceListGraph`, `HalfedgeListGraph`, `BidirectionalGraph` (by
///   `CGAL/Intrinsic_triangulations/graph_traits_Delta_complex.h`)
class Delta_complex
{
public:
  /// the type of indices and counts
  using size_type = std::uint32_t;

  /// the record of a halfedge: the positions of other elements. (Descriptors would
  /// initialize themselves, which costs a pass over memory for each new array.)
  struct Halfedge
  {
    size_type next;   ///< the next halfedge around the face, or along the border
    size_type prev;   ///< the previous halfedge
    size_type target; ///< the vertex that the halfedge points to
    size_type face;   ///< `Face_index::null_index()` for a border halfedge
  };

  /// the records of all halfedges, in a vector that need not be initialized before it is filled
  using Halfedge_vector = Large_vector<Halfedge>;
  /// a halfedge for each vertex or for each face
  using Descriptor_vector = Large_vector<Halfedge_index>;
  /// \name Iterators
  /// @{

  /// a random access iterator over descriptors
  using Vertex_iterator = Descriptor_iterator<Vertex_index>;
  using Halfedge_iterator = Descriptor_iterator<Halfedge_index>;
  using Edge_iterator = Descriptor_iterator<Edge_index>;
  using Face_iterator = Descriptor_iterator<Face_index>;
  /// @}

  /// constructs the empty complex.
  Delta_complex() = default;

  /// constructs a complex from its arrays.
  ///
  /// \param halfedges two consecutive records for each edge
  /// \param vertex_halfedges for each vertex a halfedge that points to it, a border
  ///   halfedge if there is one, the null descriptor for an isolated vertex
  /// \param face_halfedges for each face one of its halfedges
  /// \pre the result `is_valid()`. This is checked only if `CGAL_CHECK_EXPENSIVE` is defined.
  Delta_complex(Halfedge_vector halfedges, Descriptor_vector vertex_halfedges,
                Descriptor_vector face_halfedges)
    : halfedges_(std::move(halfedges)), vertex_halfedges_(std::move(vertex_halfedges)),
      face_halfedges_(std::move(face_halfedges))
  {
    CGAL_expensive_precondition(is_valid());
  }

  /// \name Size
  /// @{

  /// returns the number of elements.
  size_type number_of_vertices() const { return size_type(vertex_halfedges_.size()); }
  size_type number_of_halfedges() const { return size_type(halfedges_.size()); }
  size_type number_of_edges() const { return size_type(halfedges_.size() / 2); }
  size_type number_of_faces() const { return size_type(face_halfedges_.size()); }
  /// @}

  /// \name Ranges
  /// @{

  /// returns the descriptors of all elements, in order.
  Iterator_range<Vertex_iterator> vertices() const { return range<Vertex_index>(number_of_vertices()); }
  Iterator_range<Halfedge_iterator> halfedges() const { return range<Halfedge_index>(number_of_halfedges()); }
  Iterator_range<Edge_iterator> edges() const { return range<Edge_index>(number_of_edges()); }
  Iterator_range<Face_iterator> faces() const { return range<Face_index>(number_of_faces()); }
  /// @}

  /// \name Navigation
  /// @{
  /// returns the halfedge after `h` around its face, or along the border.
  Halfedge_index next(Halfedge_index h) const { return Halfedge_index(record(h).next); }
  /// returns the halfedge before `h`.
  Halfedge_index prev(Halfedge_index h) const { return Halfedge_index(record(h).prev); }
  /// returns the other halfedge of the edge of `h`.
  Halfedge_index opposite(Halfedge_index h) const { return Halfedge_index(h.idx() ^ 1); }
  /// returns the vertex that `h` points to.
  Vertex_index target(Halfedge_index h) const { return Vertex_index(record(h).target); }
  /// returns the vertex that `h` comes from.
  Vertex_index source(Halfedge_index h) const { return Vertex_index(record(opposite(h)).target); }
  /// returns the face to the left of `h`, or the null descriptor.
  Face_index face(Halfedge_index h) const { return Face_index(record(h).face); }
  /// returns the edge of `h`.
  Edge_index edge(Halfedge_index h) const { return Edge_index(h.idx() >> 1); }
  /// returns halfedge `2e`.
  Halfedge_index halfedge(Edge_index e) const { return Halfedge_index(e.idx() << 1); }
  /// returns a halfedge that points to `v`, a border halfedge if there is one, the null
  /// descriptor if `v` is isolated.
  Halfedge_index halfedge(Vertex_index v) const { return vertex_halfedges_[v.idx()]; }
  /// returns a halfedge of `f`.
  Halfedge_index halfedge(Face_index f) const { return face_halfedges_[f.idx()]; }
  /// returns the halfedge that points to the same vertex as `h` and follows it clockwise.
  Halfedge_index next_around_target(Halfedge_index h) const { return opposite(next(h)); }
  /// returns the halfedge with the same source as `h` that follows it counterclockwise.
  Halfedge_index next_around_source(Halfedge_index h) const { return opposite(prev(h)); }
  /// returns whether `h` has no face.
  bool is_border(Halfedge_index h) const { return !face(h).is_valid(); }
  /// returns whether one of the two halfedges of `e` has no face.
  bool is_border(Edge_index e) const
  {
    return is_border(halfedge(e)) || is_border(opposite(halfedge(e)));
  }
  /// returns whether the same face is on both sides of `e`.
  bool is_self_glued(Edge_index e) const
  {
    return face(halfedge(e)) == face(opposite(halfedge(e)));
  }
  /// returns whether `e` joins a vertex to itself.
  bool is_loop(Edge_index e) const { return target(halfedge(e)) == source(halfedge(e)); }
  /// returns whether `e` lies between two different faces, so that the connectivity can be
  /// flipped. Whether the flipped edge is a straight line depends on the metric.
  bool is_flippable(Edge_index e) const { return !is_border(e) && !is_self_glued(e); }
  /// returns the halfedges around `e`. \pre `e` is not on the border
  Hinge_halfedges hinge(Edge_index e) const
  {
    const Halfedge_index h = halfedge(e), g = opposite(h);
    return {h, next(h), prev(h), g, next(g), prev(g)};
  }
  /// @}

  /// \brief replaces edge `e` by the other diagonal of the quadrilateral formed by its two faces.
  ///
  /// With `h = halfedge(e)` from i to j, k the third corner to its left and l to its
  /// right, `h` runs from l to k afterwards: it turns counterclockwise. The face of
  /// `h` becomes (i, l, k), that of its opposite (j, k, l). All descriptors remain
  /// valid. Four flips of the same edge are the identity, except for
  /// the choice of `halfedge(v)` and `halfedge(f)`. O(1).
  ///
  /// \pre `is_flippable(e)`
  void flip(Edge_index e)
  {
    CGAL_precondition(is_flippable(e));
    flip(hinge(e));
  }
  /// \brief as above.
  /// \pre `around` is `hinge(e)` of a flippable edge
  void flip(const Hinge_halfedges& around)
  {
    const auto [ij, jk, ki, ji, il, lj] = around;
    const Vertex_index i = target(ji), j = target(ij), k = target(jk), l = target(il);
    const Face_index ilk = face(ij), jkl = face(ji);

    set_face_cycle(ilk, ij, ki, il);
    set_face_cycle(jkl, ji, lj, jk);
    record(ij).target = k.idx();
    record(ji).target = l.idx();
    replace_vertex_halfedge(j, ij, lj);
    replace_vertex_halfedge(i, ji, ki);
  }

  /// \cond SKIP_IN_MANUAL
  // A copy, most of which the threads of a loop make: run(n, f) calls f(first, last) for ranges that make up [0, n).
  template <class Run>
  Delta_complex copied(const Run& run) const
  {
    Delta_complex result;
    result.halfedges_.resize(halfedges_.size(), internal::default_init);
    run(halfedges_.size(), [&](std::size_t first, std::size_t last) {
      std::copy(halfedges_.data() + first, halfedges_.data() + last, result.halfedges_.data() + first);
    });
    result.vertex_halfedges_ = vertex_halfedges_;
    result.face_halfedges_ = face_halfedges_;
    return result;
  }
  // Has what `flip(around)` changes fetched to the cache.
  void prefetch(const Hinge_halfedges& around) const
  {
    for (Halfedge_index h : {around.jk, around.ki, around.il, around.lj})
      internal::prefetch(halfedges_.data() + h.idx());
  }
  /// \endcond

  /// \brief undoes `flip(e)`, except for the choice of `halfedge(v)` and `halfedge(f)`. O(1).
  /// \pre `is_flippable(e)`
  void flip_back(Edge_index e)
  {
    CGAL_precondition(is_flippable(e));
    const Halfedge_index h = halfedge(e), g = opposite(h);
    flip_back({h, prev(g), next(h), g, prev(h), next(g)});
  }
  /// \brief as above.
  /// \pre `around` is what `hinge(e)` was before the flip
  void flip_back(const Hinge_halfedges& around)
  {
    const auto [ij, jk, ki, ji, il, lj] = around;
    const Vertex_index l = target(ji), k = target(ij), i = target(ki), j = target(lj);
    const Face_index ijk = face(ij), jil = face(ji);

    set_face_cycle(ijk, ij, jk, ki);
    set_face_cycle(jil, ji, il, lj);
    record(ij).target = j.idx();
    record(ji).target = i.idx();
    replace_vertex_halfedge(k, ij, jk);
    replace_vertex_halfedge(l, ji, il);
  }

  /// \brief splits the face of `h` into three by a new vertex inside of it.
  ///
  /// With i, j, k the corners of the face and `h` from i to j, the face of `h` becomes (i, j, v), and the faces
  /// (j, k, v) and (k, i, v) are appended in this order. The edges vi, vj, vk are appended in this order; `halfedge(e)`
  /// of each leaves v. No descriptor changes. O(1) amortized.
  ///
  /// \return the new vertex
  /// \exception Integer_overflow_error if there would be 2^31 edges; then nothing is changed
  /// \pre `h` is not a border halfedge
  Vertex_index split_face(Halfedge_index h)
  {
    CGAL_precondition(!is_border(h));
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

  /// \brief splits the edge of `h` and the one or two faces beside it by a new vertex on the edge.
  ///
  /// With `h` from i to j, k the third corner to its left and l to its right, `h` leads from i to the new vertex v
  /// afterwards. The edge vj is appended, then vk if `h` has a face, and then vl if its opposite has one;
  /// `halfedge(e)` of each leaves v. The face of `h` becomes (i, v, k), that of its opposite (v, i, l); the faces (v, j, k)
  /// and (j, v, l), as far as they exist, are appended in this order. No descriptor changes. O(1) amortized.
  ///
  /// \return the new vertex
  /// \exception Integer_overflow_error as `split_face()`
  /// \pre the edge of `h` lies on the border or between two different faces
  Vertex_index split_edge(Halfedge_index h)
  {
    CGAL_precondition(!is_self_glued(edge(h)));
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

  /// \brief undoes a split of a face: removes a vertex in the middle of three faces, which become one.
  ///
  /// The last elements take the descriptors of those that are removed. O(degree of the last vertex).
  /// \pre `v` has three different faces, of three edges to other vertices
  Removed_elements unsplit_face(Vertex_index v)
  {
    const Halfedge_index a = halfedge(v), b = next_around_target(a), c = next_around_target(b);
    CGAL_precondition(next_around_target(c) == a);
    const Halfedge_index sides[] = {prev(a), prev(c), prev(b)};
    const Face_index f = (std::min)((std::min)(face(a), face(b)), face(c));
    Removed_elements removed = removed_elements(v, {edge(a), edge(b), edge(c)}, {face(a), face(b), face(c)});
    removed.faces.pop_back(); // the least one stays
    for (Halfedge_index h : {a, b, c})
      replace_vertex_halfedge(source(h), opposite(h), prev(h));
    set_face_cycle(f, sides[0], sides[1], sides[2]);
    erase(removed);
    return removed;
  }

  /// \brief undoes a split of an edge: removes the vertex that `h` points to, and joins `h` with the edge that continues
  /// it, and the faces on either side.
  ///
  /// Descriptors move as in `unsplit_face()`; those of `h` and of the faces beside it are not removed.
  /// \pre the vertex has one edge on each side of `h` that has a face; its edges lead to other vertices, its faces are different
  Removed_elements unsplit_edge(Halfedge_index h)
  {
    const Halfedge_index g = opposite(h), vj = continuation(h), jv = opposite(vj);
    const Vertex_index v = target(h), j = target(vj);
    const Halfedge_index jk = next(vj), ki = prev(h), il = next(g), lj = prev(jv);
    std::vector<Edge_index> edges{edge(vj)};
    std::vector<Face_index> faces;
    if (!is_border(h)) {
      edges.push_back(edge(next(h)));
      faces.push_back(face(vj));
      replace_vertex_halfedge(target(next(h)), next(h), jk);
    }
    if (!is_border(g)) {
      edges.push_back(edge(prev(g)));
      faces.push_back(face(jv));
      replace_vertex_halfedge(source(prev(g)), opposite(prev(g)), il);
    }
    Removed_elements removed = removed_elements(v, std::move(edges), std::move(faces));
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

  /// \brief returns the halfedge that continues `h` beyond its target, with one edge between them on each side that has a face.
  /// \pre as `unsplit_edge()`
  Halfedge_index continuation(Halfedge_index h) const { return is_border(h) ? next(h) : next(opposite(next(h))); }

  /// \brief returns whether the arrays describe a triangulated oriented surface.
  ///
  /// Every halfedge belongs to one cycle of three in a face or to one cycle along the
  /// border, sources and targets agree, each vertex has one fan of faces, and the
  /// halfedges of vertices and faces are incident to them. O(size).
  /// \param verbose whether the first defect is described on `std::cerr`
  bool is_valid(bool verbose = false) const
  {
    std::string defect;
    if (has_valid_cycles(defect) && has_valid_vertices(defect))
      return true;
    if (verbose)
      std::cerr << "Delta_complex: " << defect << std::endl;
    return false;
  }

  /// \brief returns whether both complexes have the same elements, glued in the same way.
  ///
  /// Descriptors, orientation and `halfedge(Face_index)` are compared. `halfedge(Vertex_index)` is
  /// not: for an interior vertex it may be any halfedge that points to it, depending on
  /// earlier flips. O(size).
  friend bool operator==(const Delta_complex& a, const Delta_complex& b)
  {
    return a.number_of_vertices() == b.number_of_vertices() &&
           a.face_halfedges_ == b.face_halfedges_ && has_equal_halfedges(a, b);
  }
  /// returns `!(a == b)`.
  friend bool operator!=(const Delta_complex& a, const Delta_complex& b) { return !(a == b); }

private:
  template <class Descriptor>
  static Iterator_range<Descriptor_iterator<Descriptor>> range(size_type n)
  {
    using Iterator = Descriptor_iterator<Descriptor>;
    return make_range(Iterator(0), Iterator(n));
  }

  const Halfedge& record(Halfedge_index h) const
  {
    CGAL_precondition(h.idx() < halfedges_.size());
    return halfedges_[h.idx()];
  }
  Halfedge& record(Halfedge_index h) { return halfedges_[h.idx()]; }

  // Appends n edges and returns the first halfedge.
  Halfedge_index append_edges(int n)
  {
    const Halfedge_index first(number_of_halfedges());
    if (halfedges_.size() + 2 * std::size_t(n) >= Halfedge_index::null_index())
      throw Integer_overflow_error("a triangulation has 2^31 edges or more");
    halfedges_.resize(halfedges_.size() + 2 * std::size_t(n));
    return first;
  }
  // Appends n faces and returns the first.
  Face_index append_faces(int n)
  {
    const Face_index first(number_of_faces());
    face_halfedges_.resize(face_halfedges_.size() + std::size_t(n));
    return first;
  }

  void join(Halfedge_index a, Halfedge_index b)
  {
    record(a).next = b.idx();
    record(b).prev = a.idx();
  }

  Removed_elements removed_elements(Vertex_index v, std::vector<Edge_index> edges, std::vector<Face_index> faces) const
  {
    std::sort(edges.rbegin(), edges.rend());
    std::sort(faces.rbegin(), faces.rend());
    return {{v}, std::move(edges), std::move(faces), number_of_edges()};
  }

  // Nothing that stays refers to what is removed. The last elements move into the holes.
  void erase(const Removed_elements& removed)
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

  void move_edge(Edge_index from, Edge_index to)
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

  void move_vertex(Vertex_index from, Vertex_index to)
  {
    const Halfedge_index first = halfedge(from);
    vertex_halfedges_[to.idx()] = first;
    if (!first.is_valid())
      return;
    Halfedge_index h = first;
    do {
      record(h).target = to.idx();
      h = next_around_target(h);
    } while (h != first);
  }

  void set_face_cycle(Face_index f, Halfedge_index a, Halfedge_index b, Halfedge_index c)
  {
    Halfedge &ra = record(a), &rb = record(b), &rc = record(c);
    ra.next = rc.prev = b.idx();
    rb.next = ra.prev = c.idx();
    rc.next = rb.prev = a.idx();
    ra.face = rb.face = rc.face = f.idx();
    face_halfedges_[f.idx()] = a;
  }

  // Flips of hinges without a common edge may run at the same time. They can meet at a vertex:
  // but its halfedge is replaced only by the one flip that moves it, which at most one of
  // them does.
  void replace_vertex_halfedge(Vertex_index v, Halfedge_index old, Halfedge_index replacement)
  {
    if (internal::relaxed_load(vertex_halfedges_[v.idx()]) == old)
      internal::relaxed_store(vertex_halfedges_[v.idx()], replacement);
  }

  static bool has_equal_halfedges(const Delta_complex& a, const Delta_complex& b)
  {
    if (a.halfedges_.size() != b.halfedges_.size())
      return false;
    for (std::size_t h = 0; h < a.halfedges_.size(); ++h) {
      const Halfedge &ra = a.halfedges_[h], &rb = b.halfedges_[h];
      if (ra.next != rb.next || ra.prev != rb.prev || ra.target != rb.target || ra.face != rb.face)
        return false;
    }
    return true;
  }

  template <class Descriptor>
  static bool fails(std::string& defect, Descriptor element, const char* what)
  {
    defect = std::string(1, "vhef"[std::is_same<Descriptor, Halfedge_index>::value ? 1
                                   : std::is_same<Descriptor, Face_index>::value   ? 3
                                                                                   : 0]) +
             std::to_string(element.idx()) + ": " + what;
    return false;
  }

  bool has_valid_cycles(std::string& defect) const
  {
    if (halfedges_.size() % 2 != 0)
      return fails(defect, Halfedge_index(number_of_halfedges()), "has no opposite");
    for (Halfedge_index h : halfedges()) {
      const Halfedge& r = record(h);
      if (r.next >= number_of_halfedges() || r.prev >= number_of_halfedges())
        return fails(defect, h, "next or prev is out of range");
      if (r.target >= number_of_vertices())
        return fails(defect, h, "target is out of range");
      if (!is_border(h) && r.face >= number_of_faces())
        return fails(defect, h, "face is out of range");
    }
    std::size_t number_of_face_halfedges = 0;
    for (Halfedge_index h : halfedges()) {
      if (prev(next(h)) != h || next(prev(h)) != h)
        return fails(defect, h, "next and prev are not inverse to each other");
      if (source(next(h)) != target(h))
        return fails(defect, h, "the next halfedge does not start at the target");
      if (face(next(h)) != face(h))
        return fails(defect, h, "the next halfedge has another face");
      if (is_border(h)) {
        if (is_border(opposite(h)))
          return fails(defect, h, "has no face on either side");
        continue;
      }
      ++number_of_face_halfedges;
      if (next(next(next(h))) != h)
        return fails(defect, h, "its face is not a triangle");
    }
    if (number_of_face_halfedges != 3 * std::size_t(number_of_faces()))
      return fails(defect, Face_index(0), "faces do not have three halfedges each");
    for (Face_index f : faces())
      if (halfedge(f).idx() >= number_of_halfedges() || face(halfedge(f)) != f)
        return fails(defect, f, "its halfedge belongs to another face");
    return true;
  }

  bool has_valid_vertices(std::string& defect) const
  {
    std::size_t number_of_visited = 0;
    for (Vertex_index v : vertices()) {
      const Halfedge_index first = halfedge(v);
      if (!first.is_valid())
        continue;
      if (first.idx() >= number_of_halfedges() || target(first) != v)
        return fails(defect, v, "its halfedge does not point to it");
      bool meets_border = false;
      Halfedge_index h = first;
      do {
        meets_border = meets_border || is_border(h);
        ++number_of_visited;
        h = next_around_target(h);
      } while (h != first);
      if (meets_border && !is_border(first))
        return fails(defect, v, "is on the border and its halfedge is not");
    }
    // Each halfedge points to one vertex and lies in one fan: all are visited exactly
    // if no vertex has two fans.
    if (number_of_visited != number_of_halfedges())
      return fails(defect, Vertex_index(0), "some vertex has more than one fan of faces");
    return true;
  }

  Halfedge_vector halfedges_;
  Descriptor_vector vertex_halfedges_;
  Descriptor_vector face_halfedges_;
};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief returns whether the complex is simplicial: whether its vertices identify each edge
/// and each face.
///
/// This means that there is no loop, no two edges have the same end vertices, and no two faces have
/// the same corners. Only then is it safe to look an element up by its vertices, as generic mesh
/// algorithms and most file formats do. O(size).
inline bool is_simplicial(const Delta_complex& complex)
{
  std::vector<Vertex_index> last_met_from(complex.number_of_vertices());
  for (Vertex_index v : complex.vertices()) {
    const Halfedge_index first = complex.halfedge(v);
    if (!first.is_valid())
      continue;
    Halfedge_index h = first;
    do {
      Vertex_index& met_from = last_met_from[complex.source(h).idx()];
      if (met_from == v) // by another edge, or by the other halfedge of a loop
        return false;
      met_from = v;
      h = complex.next_around_target(h);
    } while (h != first);
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H

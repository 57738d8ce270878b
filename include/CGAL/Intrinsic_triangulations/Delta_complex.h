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
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>

#include <boost/config.hpp>
#include <boost/container/static_vector.hpp>
#include <boost/iterator/iterator_facade.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
///
/// \brief the elements that the removal of a vertex took away, by their previous descriptors.
///
/// Descriptors have no holes: for each element of a list in turn, the last element takes its place. The lists are in
/// descending order, so that an element that is removed never moves. `remove_entries()` does the same with an array.
/// Halfedges move with their edges: `2e + i` becomes `2f + i`. The lists need no memory of their own, so copying them,
/// and removing entries, never throws.
struct Removed_elements
{
  boost::container::static_vector<Vertex_index, 1> vertices; ///< one vertex
  boost::container::static_vector<Edge_index, 3> edges;      ///< two or three edges
  boost::container::static_vector<Face_index, 2> faces;      ///< one or two faces
  std::uint32_t number_of_edges = 0;                         ///< the number of edges before the removal

  /// returns the descriptor after the removal of an edge that was not removed.
  Edge_index edge_after(Edge_index e) const
  {
    std::uint32_t last = number_of_edges;
    for (Edge_index hole : edges)
      if (e.idx() == --last)
        e = hole;
    return e;
  }
  /// returns the descriptor that an edge had before the removal.
  Edge_index edge_before(Edge_index e) const
  {
    for (std::size_t i = edges.size(); i-- > 0;)
      if (e == edges[i])
        e = Edge_index(std::uint32_t(number_of_edges - 1 - i));
    return e;
  }
};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief removes from an array with one entry for each element those of `holes`, a list of `Removed_elements`.
/// \param array the array
/// \param holes the removed elements, none before `first`
/// \param first the number of the element of the first entry
template <class Array, class Descriptors>
void remove_entries(Array& array, const Descriptors& holes, std::size_t first = 0)
{
  for (auto hole : holes) {
    const std::size_t n = hole.idx() - first;
    if (n + 1 != array.size())
      array[n] = array[array.size() - 1];
    array.pop_back();
  }
}

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief a random access iterator over the descriptors of consecutive elements of one kind.
template <class Descriptor>
class Descriptor_iterator : public boost::iterator_facade<Descriptor_iterator<Descriptor>, Descriptor,
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
  Halfedge_index ki; ///< the previous one
  Halfedge_index ji; ///< halfedge `2e + 1`
  Halfedge_index il; ///< the next one, to the corner l on the right
  Halfedge_index lj; ///< the previous one
};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
///
/// \brief a triangulated oriented surface, with or without boundary, as halfedge arrays.
///
/// Faces are triangles; any gluing of their sides that gives an oriented surface is
/// allowed: loops, several edges between the same two vertices, a face glued to itself,
/// a surface with one vertex. So elements are never looked up by their end vertices.
/// Isolated vertices are allowed, too.
///
/// Descriptors of vertices, halfedges, edges and faces are integers counted from zero, and
/// a flip changes none of them. Halfedges `2e` and `2e + 1` belong to edge `e`.
/// A halfedge without a face is a border halfedge; `next()` and `prev()` of a border
/// halfedge run along the border.
///
/// Memory: 32 bytes an edge, 4 a vertex and 4 a face.
///
/// `CGAL/Intrinsic_triangulations/graph_traits_Delta_complex.h` makes it a graph of CGAL and BGL.
///
/// \cgalModels{FaceListGraph,HalfedgeListGraph,BidirectionalGraph}
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

  /// the records of all halfedges, in a vector that can be filled without prior initialization
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
  Delta_complex(Halfedge_vector halfedges, Descriptor_vector vertex_halfedges, Descriptor_vector face_halfedges)
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
  bool is_border(Edge_index e) const { return is_border(halfedge(e)) || is_border(opposite(halfedge(e))); }
  /// returns whether the same face is on both sides of `e`.
  bool is_self_glued(Edge_index e) const { return face(halfedge(e)) == face(opposite(halfedge(e))); }
  /// returns whether `e` joins a vertex to itself.
  bool is_loop(Edge_index e) const { return target(halfedge(e)) == source(halfedge(e)); }
  /// returns whether `e` lies between two different faces, so that its flip exists combinatorially. Whether the flipped
  /// edge is a straight line depends on the metric.
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
  // A copy, made mostly by the threads of a loop: run(n, f) calls f(first, last) for ranges that make up [0, n).
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
  // Makes room for the elements of one split, which then does not throw.
  // \exception Integer_overflow_error as `split_face()`
  void make_room_for_vertex();
  // Chooses `halfedge(f)`. \pre `face(h) == f`
  void set_halfedge(Face_index f, Halfedge_index h) { face_halfedges_[f.idx()] = h; }
  // Chooses `halfedge(v)`. \pre `target(h) == v`, and `h` is on the border if `v` is
  void set_halfedge(Vertex_index v, Halfedge_index h) { vertex_halfedges_[v.idx()] = h; }
  // Prefetches the data that `flip(around)` changes.
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
  /// of each leaves v. No descriptor changes. O(1) amortized. An exception leaves everything as it was.
  ///
  /// \return the new vertex
  /// \exception Integer_overflow_error if there would be 2^31 edges
  /// \pre `h` is not a border halfedge
  Vertex_index split_face(Halfedge_index h);

  /// \brief splits the edge of `h` and the one or two faces beside it by a new vertex on the edge.
  ///
  /// With `h` from i to j, k the third corner to its left and l to its right, `h` leads from i to the new vertex v
  /// afterwards. The edge vj is appended, then vk if `h` has a face, and then vl if its opposite has one; `halfedge(e)`
  /// of each leaves v. The face of `h` becomes (i, v, k), that of its opposite (v, i, l); those of the faces (v, j, k)
  /// and (j, v, l) that exist are appended in this order. No descriptor changes. O(1) amortized.
  ///
  /// \return the new vertex
  /// \exception Integer_overflow_error as `split_face()`
  /// \pre the edge of `h` lies on the border or between two different faces
  Vertex_index split_edge(Halfedge_index h);

  /// \brief undoes a split of a face: removes a vertex in the middle of three faces, which become one.
  ///
  /// The last elements take the descriptors of those that are removed. O(degree of the last vertex). Never throws.
  /// \pre `v` has three different faces, of three edges to other vertices
  Removed_elements unsplit_face(Vertex_index v);

  /// \brief undoes a split of an edge: removes the vertex that `h` points to, and joins `h` with the edge that
  /// continues it, and the faces on either side.
  ///
  /// Descriptors move as in `unsplit_face()`; those of `h` and of the faces beside it are not removed. Never throws.
  /// \pre the vertex has one edge on each side of `h` that has a face; its edges lead to other vertices, its faces are
  ///   different
  Removed_elements unsplit_edge(Halfedge_index h);

  /// \brief returns the halfedge that continues `h` beyond its target, with one edge between them on each side that has
  /// a face.
  /// \pre as `unsplit_edge()`
  Halfedge_index continuation(Halfedge_index h) const { return is_border(h) ? next(h) : next(opposite(next(h))); }

  /// \brief returns whether the arrays describe a triangulated oriented surface.
  ///
  /// Every halfedge belongs to one cycle of three in a face or to one cycle along the
  /// border, sources and targets agree, each vertex has one fan of faces, and the
  /// halfedges of vertices and faces are incident to them. O(size).
  /// \param verbose whether the first defect is described on `std::cerr`
  bool is_valid(bool verbose = false) const;

  /// \brief returns whether both complexes have the same elements, glued in the same way.
  ///
  /// Descriptors, orientation and `halfedge(Face_index)` are compared. `halfedge(Vertex_index)` is
  /// not: for an interior vertex it may be any halfedge that points to it, depending on
  /// earlier flips. O(size).
  friend bool operator==(const Delta_complex& a, const Delta_complex& b)
  {
    return a.number_of_vertices() == b.number_of_vertices() && a.face_halfedges_ == b.face_halfedges_ &&
           has_equal_halfedges(a, b);
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
  Halfedge_index append_edges(int n);
  // Appends n faces and returns the first.
  Face_index append_faces(int n);

  void join(Halfedge_index a, Halfedge_index b)
  {
    record(a).next = b.idx();
    record(b).prev = a.idx();
  }

  // Sorts and counts.
  void complete(Removed_elements& removed) const;
  // No remaining element refers to a removed one. The last elements move into the holes.
  void erase(const Removed_elements& removed);

  void move_edge(Edge_index from, Edge_index to);
  void move_vertex(Vertex_index from, Vertex_index to);

  void set_face_cycle(Face_index f, Halfedge_index a, Halfedge_index b, Halfedge_index c)
  {
    Halfedge &ra = record(a), &rb = record(b), &rc = record(c);
    ra.next = rc.prev = b.idx();
    rb.next = ra.prev = c.idx();
    rc.next = rb.prev = a.idx();
    ra.face = rb.face = rc.face = f.idx();
    face_halfedges_[f.idx()] = a;
  }

  // Flips of hinges without a common edge may run at the same time. They can meet at a vertex, but only the flip that
  // moves the vertex's halfedge replaces it, and at most one of them does.
  void replace_vertex_halfedge(Vertex_index v, Halfedge_index old, Halfedge_index replacement)
  {
    if (internal::relaxed_load(vertex_halfedges_[v.idx()]) == old)
      internal::relaxed_store(vertex_halfedges_[v.idx()], replacement);
  }

  static bool has_equal_halfedges(const Delta_complex& a, const Delta_complex& b)
  {
    return std::equal(a.halfedges_.begin(), a.halfedges_.end(), b.halfedges_.begin(), b.halfedges_.end(),
                      [](const Halfedge& x, const Halfedge& y) {
                        return x.next == y.next && x.prev == y.prev && x.target == y.target && x.face == y.face;
                      });
  }

  bool has_valid_cycles(std::string& defect) const;
  bool has_valid_vertices(std::string& defect) const;

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
/// \param complex the complex
bool is_simplicial(const Delta_complex& complex);

namespace internal {

// The halfedges that point to v, clockwise from halfedge(v), for a range-based loop. Nothing is flipped meanwhile.
class Halfedges_around
{
public:
  Halfedges_around(const Delta_complex& complex, Vertex_index v) : complex_(complex), first_(complex.halfedge(v)) {}

  struct Iterator
  {
    Halfedge_index operator*() const { return h; }
    Iterator& operator++()
    {
      h = around->complex_.next_around_target(h);
      is_at_end = h == around->first_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return is_at_end != other.is_at_end; }
    const Halfedges_around* around;
    Halfedge_index h;
    bool is_at_end;
  };
  Iterator begin() const { return {this, first_, !first_.is_valid()}; }
  Iterator end() const { return {this, first_, true}; }

private:
  const Delta_complex& complex_;
  Halfedge_index first_;
};

// The side of a face with the largest value(h), the first one from halfedge(f) on if there are several. Inlined by
// force: refinement asks for the longest side all the time.
template <class Value>
BOOST_FORCEINLINE Halfedge_index side_with_largest(const Delta_complex& complex, Face_index f, const Value& value)
{
  Halfedge_index result = complex.halfedge(f);
  for (Halfedge_index h : {complex.next(result), complex.prev(result)})
    if (value(h) > value(result))
      result = h;
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DELTA_COMPLEX_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delta_complex as a graph of the Boost Graph Library and of CGAL.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_DELTA_COMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_DELTA_COMPLEX_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_adaptor.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <ostream>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the edge descriptor of `boost::graph_traits<Delta_complex>`: an undirected edge
/// that remembers from which end it was reached.
///
/// The Boost Graph Library requires that `source(e, g)` is `v` for each edge `e` of
/// `out_edges(v, g)`, which an `Edge_index` does not determine. Two descriptors are equal if they
/// describe the same edge, whatever their directions. An `Oriented_edge` converts implicitly to an
/// `Edge_index`. Constructed from an `Edge_index`, its direction is that of
/// `Delta_complex::halfedge(Edge_index)`.
class Oriented_edge
{
public:
  /// the type of positions
  using size_type = Edge_index::size_type;

  /// constructs the null descriptor.
  constexpr Oriented_edge() = default;
  /// constructs the edge of `h` in the direction of `h`.
  constexpr explicit Oriented_edge(Halfedge_index h) : halfedge_(h) {}
  /// constructs the edge `e` in the direction of its first halfedge.
  constexpr explicit Oriented_edge(Edge_index e)
    : halfedge_(e.is_valid() ? Halfedge_index(e.idx() << 1) : Halfedge_index())
  {}

  /// returns the halfedge that gives the direction.
  constexpr Halfedge_index halfedge() const { return halfedge_; }
  /// returns whether this is not the null descriptor.
  constexpr bool is_valid() const { return halfedge_.is_valid(); }
  /// returns the position of the edge.
  constexpr size_type idx() const { return Edge_index(*this).idx(); }
  /// returns the edge without a direction.
  constexpr operator Edge_index() const { return is_valid() ? Edge_index(halfedge_.idx() >> 1) : Edge_index(); }

  /// \name Comparison
  /// @{

  /// compares the edges and ignores their directions; the null descriptor comes last.
  friend constexpr bool operator==(Oriented_edge a, Oriented_edge b) { return a.idx() == b.idx(); }
  friend constexpr bool operator!=(Oriented_edge a, Oriented_edge b) { return !(a == b); }
  friend constexpr bool operator<(Oriented_edge a, Oriented_edge b) { return a.idx() < b.idx(); }
  friend constexpr bool operator>(Oriented_edge a, Oriented_edge b) { return b < a; }
  friend constexpr bool operator<=(Oriented_edge a, Oriented_edge b) { return !(b < a); }
  friend constexpr bool operator>=(Oriented_edge a, Oriented_edge b) { return !(a < b); }
  /// @}

  /// returns a hash value for `boost::hash`.
  friend std::size_t hash_value(Oriented_edge e) { return e.idx(); }
  /// writes the edge as `Edge_index` does.
  friend std::ostream& operator<<(std::ostream& os, Oriented_edge e) { return os << Edge_index(e); }

private:
  Halfedge_index halfedge_;
};

namespace internal {

class Oriented_edge_iterator
  : public boost::iterator_adaptor<Oriented_edge_iterator, Delta_complex::Edge_iterator, Oriented_edge,
                                   std::random_access_iterator_tag, Oriented_edge>
{
public:
  Oriented_edge_iterator() = default;
  explicit Oriented_edge_iterator(Delta_complex::Edge_iterator it) : Oriented_edge_iterator::iterator_adaptor_(it) {}

private:
  friend class boost::iterator_core_access;
  Oriented_edge dereference() const { return Oriented_edge(*this->base_reference()); }
};

// The position of a descriptor.
template <class Descriptor>
struct Position_map
{
  using category = boost::readable_property_map_tag;
  using key_type = Descriptor;
  using value_type = std::uint32_t;
  using reference = std::uint32_t;

  value_type operator[](key_type k) const { return k.idx(); }
  friend value_type get(const Position_map&, const key_type& k) { return k.idx(); }
};

template <class Descriptor, class T>
struct Dynamic_map
{
  using type = CGAL::internal::Dynamic_with_index<Descriptor, T>;
  using const_type = type;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

namespace boost {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief makes `CGAL::Intrinsic_triangulations::Delta_complex` a graph of the Boost Graph Library and CGAL.
///
/// Halfedges, vertices and faces have the descriptors of `Delta_complex`, edges have
/// `Oriented_edge`. Parallel edges and loops are allowed: a loop occurs twice among the
/// `out_edges()` and twice among the `in_edges()` of its vertex, and counts twice in its
/// `degree()`. The functions of the concepts are found by argument-dependent lookup.
/// Each takes O(1), except that `degree(v, g)`, `out_degree(v, g)` and `in_degree(v, g)` count,
/// and `edge(u, v, g)` and `halfedge(u, v, g)` search.
///
/// \warning `edge(u, v, g)` and `halfedge(u, v, g)` return *some* edge from `u` to `v`; there
/// may be several. Algorithms that look edges up by their end vertices are correct only on a complex
/// for which `CGAL::Intrinsic_triangulations::is_simplicial()` holds.
///
/// Property maps: `vertex_index`, `halfedge_index`, `edge_index` and `face_index` are
/// the positions of the descriptors, which a flip does not change. The dynamic
/// properties of CGAL are stored in arrays.
///
/// \cgalModels{FaceListGraph,HalfedgeListGraph,BidirectionalGraph,VertexListGraph,EdgeListGraph,AdjacencyGraph}
template <>
struct graph_traits<CGAL::Intrinsic_triangulations::Delta_complex>
{
private:
  using Graph = CGAL::Intrinsic_triangulations::Delta_complex;
  struct Traversal_category : virtual bidirectional_graph_tag,
                              virtual vertex_list_graph_tag,
                              virtual edge_list_graph_tag,
                              virtual adjacency_graph_tag
  {};

public:
  /// \name Requirements of the concepts of BGL
  /// @{

  /// as required by the concepts of the Boost Graph Library
  using vertex_descriptor = CGAL::Intrinsic_triangulations::Vertex_index;
  using halfedge_descriptor = CGAL::Intrinsic_triangulations::Halfedge_index;
  using edge_descriptor = CGAL::Intrinsic_triangulations::Oriented_edge;
  using face_descriptor = CGAL::Intrinsic_triangulations::Face_index;

  using directed_category = undirected_tag;
  using edge_parallel_category = allow_parallel_edge_tag;
  using traversal_category = Traversal_category;

  using vertex_iterator = Graph::Vertex_iterator;
  using halfedge_iterator = Graph::Halfedge_iterator;
  using edge_iterator = CGAL::Intrinsic_triangulations::internal::Oriented_edge_iterator;
  using face_iterator = Graph::Face_iterator;
  using out_edge_iterator = CGAL::Out_edge_iterator<Graph>;
  using in_edge_iterator = CGAL::In_edge_iterator<Graph>;
  using adjacency_iterator = CGAL::Vertex_around_target_iterator<Graph>;

  using vertices_size_type = Graph::size_type;
  using halfedges_size_type = Graph::size_type;
  using edges_size_type = Graph::size_type;
  using faces_size_type = Graph::size_type;
  using degree_size_type = Graph::size_type;

  static vertex_descriptor null_vertex() { return vertex_descriptor(); }
  static halfedge_descriptor null_halfedge() { return halfedge_descriptor(); }
  static face_descriptor null_face() { return face_descriptor(); }
  /// @}
};

/// \cond SKIP_IN_MANUAL
template <>
struct graph_traits<const CGAL::Intrinsic_triangulations::Delta_complex>
  : graph_traits<CGAL::Intrinsic_triangulations::Delta_complex>
{};
/// \endcond

} // namespace boost

/// \cond SKIP_IN_MANUAL
template <>
struct std::hash<CGAL::Intrinsic_triangulations::Oriented_edge>
{
  std::size_t operator()(CGAL::Intrinsic_triangulations::Oriented_edge e) const { return e.idx(); }
};

namespace CGAL::Intrinsic_triangulations {

// Graph, IncidenceGraph, BidirectionalGraph, VertexListGraph, EdgeListGraph, AdjacencyGraph

inline Delta_complex::size_type num_vertices(const Delta_complex& g) { return g.number_of_vertices(); }
inline Delta_complex::size_type num_halfedges(const Delta_complex& g) { return g.number_of_halfedges(); }
inline Delta_complex::size_type num_edges(const Delta_complex& g) { return g.number_of_edges(); }
inline Delta_complex::size_type num_faces(const Delta_complex& g) { return g.number_of_faces(); }

inline Iterator_range<Delta_complex::Vertex_iterator> vertices(const Delta_complex& g) { return g.vertices(); }
inline Iterator_range<Delta_complex::Halfedge_iterator> halfedges(const Delta_complex& g) { return g.halfedges(); }
inline Iterator_range<internal::Oriented_edge_iterator> edges(const Delta_complex& g)
{
  return make_range(internal::Oriented_edge_iterator(g.edges().begin()),
                    internal::Oriented_edge_iterator(g.edges().end()));
}
inline Iterator_range<Delta_complex::Face_iterator> faces(const Delta_complex& g) { return g.faces(); }

inline Vertex_index source(Halfedge_index h, const Delta_complex& g) { return g.source(h); }
inline Vertex_index target(Halfedge_index h, const Delta_complex& g) { return g.target(h); }
inline Vertex_index source(Oriented_edge e, const Delta_complex& g) { return g.source(e.halfedge()); }
inline Vertex_index target(Oriented_edge e, const Delta_complex& g) { return g.target(e.halfedge()); }

inline Delta_complex::size_type degree(Vertex_index v, const Delta_complex& g)
{
  Delta_complex::size_type n = 0;
  for ([[maybe_unused]] Halfedge_index h : internal::Halfedges_around(g, v))
    ++n;
  return n;
}
inline Delta_complex::size_type degree(Face_index, const Delta_complex&) { return 3; }
inline Delta_complex::size_type out_degree(Vertex_index v, const Delta_complex& g) { return degree(v, g); }
inline Delta_complex::size_type in_degree(Vertex_index v, const Delta_complex& g) { return degree(v, g); }

inline Iterator_range<Out_edge_iterator<Delta_complex>> out_edges(Vertex_index v, const Delta_complex& g)
{
  using Iterator = Out_edge_iterator<Delta_complex>;
  return make_range(Iterator(g.halfedge(v), g), Iterator(g.halfedge(v), g, 1));
}
inline Iterator_range<In_edge_iterator<Delta_complex>> in_edges(Vertex_index v, const Delta_complex& g)
{
  using Iterator = In_edge_iterator<Delta_complex>;
  return make_range(Iterator(g.halfedge(v), g), Iterator(g.halfedge(v), g, 1));
}
inline Iterator_range<Vertex_around_target_iterator<Delta_complex>> adjacent_vertices(Vertex_index v,
                                                                                      const Delta_complex& g)
{
  return CGAL::vertices_around_target(v, g);
}

// HalfedgeGraph, FaceGraph

inline Halfedge_index next(Halfedge_index h, const Delta_complex& g) { return g.next(h); }
inline Halfedge_index prev(Halfedge_index h, const Delta_complex& g) { return g.prev(h); }
inline Halfedge_index opposite(Halfedge_index h, const Delta_complex& g) { return g.opposite(h); }
inline Face_index face(Halfedge_index h, const Delta_complex& g) { return g.face(h); }
inline Oriented_edge edge(Halfedge_index h, const Delta_complex&) { return Oriented_edge(h); }
inline Halfedge_index halfedge(Oriented_edge e, const Delta_complex&) { return e.halfedge(); }
inline Halfedge_index halfedge(Vertex_index v, const Delta_complex& g) { return g.halfedge(v); }
inline Halfedge_index halfedge(Face_index f, const Delta_complex& g) { return g.halfedge(f); }

inline std::pair<Halfedge_index, bool> halfedge(Vertex_index u, Vertex_index v, const Delta_complex& g)
{
  for (Halfedge_index h : internal::Halfedges_around(g, v))
    if (g.source(h) == u)
      return {h, true};
  return {Halfedge_index(), false};
}
inline std::pair<Oriented_edge, bool> edge(Vertex_index u, Vertex_index v, const Delta_complex& g)
{
  const std::pair<Halfedge_index, bool> h = halfedge(u, v, g);
  return {Oriented_edge(h.first), h.second};
}

} // namespace CGAL::Intrinsic_triangulations

// PropertyGraph: the positions of one kind of elements, and dynamic properties.
#define CGAL_INTRINSIC_TRIANGULATIONS_MAPS(ELEMENT, DESCRIPTOR, NUMBER)                                                \
  namespace CGAL {                                                                                                     \
  namespace Intrinsic_triangulations {                                                                                 \
  inline internal::Position_map<DESCRIPTOR> get(boost::ELEMENT##_index_t, const Delta_complex&) { return {}; }         \
  inline std::uint32_t get(boost::ELEMENT##_index_t, const Delta_complex&, DESCRIPTOR x) { return x.idx(); }           \
  template <class T>                                                                                                   \
  typename internal::Dynamic_map<DESCRIPTOR, T>::type get(const dynamic_##ELEMENT##_property_t<T>&,                    \
                                                          const Delta_complex& g)                                      \
  {                                                                                                                    \
    return typename internal::Dynamic_map<DESCRIPTOR, T>::type(g.NUMBER());                                            \
  }                                                                                                                    \
  }                                                                                                                    \
  template <>                                                                                                          \
  struct graph_has_property<Intrinsic_triangulations::Delta_complex, boost::ELEMENT##_index_t> : Tag_true              \
  {};                                                                                                                  \
  }                                                                                                                    \
  namespace boost {                                                                                                    \
  template <>                                                                                                          \
  struct property_map<CGAL::Intrinsic_triangulations::Delta_complex, ELEMENT##_index_t>                                \
  {                                                                                                                    \
    using type = CGAL::Intrinsic_triangulations::internal::Position_map<CGAL::Intrinsic_triangulations::DESCRIPTOR>;   \
    using const_type = type;                                                                                           \
  };                                                                                                                   \
  template <class T>                                                                                                   \
  struct property_map<CGAL::Intrinsic_triangulations::Delta_complex, CGAL::dynamic_##ELEMENT##_property_t<T>>          \
    : CGAL::Intrinsic_triangulations::internal::Dynamic_map<CGAL::Intrinsic_triangulations::DESCRIPTOR, T>             \
  {};                                                                                                                  \
  }
CGAL_INTRINSIC_TRIANGULATIONS_MAPS(vertex, Vertex_index, number_of_vertices)
CGAL_INTRINSIC_TRIANGULATIONS_MAPS(halfedge, Halfedge_index, number_of_halfedges)
CGAL_INTRINSIC_TRIANGULATIONS_MAPS(edge, Oriented_edge, number_of_edges)
CGAL_INTRINSIC_TRIANGULATIONS_MAPS(face, Face_index, number_of_faces)
#undef CGAL_INTRINSIC_TRIANGULATIONS_MAPS
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_DELTA_COMPLEX_H

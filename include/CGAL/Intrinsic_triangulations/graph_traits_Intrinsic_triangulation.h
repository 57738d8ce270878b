// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Intrinsic_triangulation as a graph of the Boost Graph Library and of CGAL, with maps of its numbers.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/graph_traits_Delta_complex.h>

#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the type of `edge_cotangent_weight`.
struct Edge_cotangent_weight_tag
{};
/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the property tag for `Intrinsic_triangulation::cotangent_weight()`.
inline constexpr Edge_cotangent_weight_tag edge_cotangent_weight{};

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the type of `edge_normal_coordinate`.
struct Edge_normal_coordinate_tag
{};
/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief the property tag for `Intrinsic_triangulation::number_of_crossings()`.
inline constexpr Edge_normal_coordinate_tag edge_normal_coordinate{};

namespace internal {

template <class Traits>
typename Traits::FT number_of_edge(boost::edge_weight_t, const Intrinsic_triangulation<Traits>& g, Edge_index e)
{
  return g.length(e);
}
template <class Traits>
typename Traits::FT number_of_edge(Edge_cotangent_weight_tag, const Intrinsic_triangulation<Traits>& g, Edge_index e)
{
  return g.cotangent_weight(e);
}
template <class Traits>
std::int64_t number_of_edge(Edge_normal_coordinate_tag, const Intrinsic_triangulation<Traits>& g, Edge_index e)
{
  return crossings(engine(g).correspondence(), e);
}

// A number of each edge, computed on access.
template <class Tag, class Traits>
class Edge_number_map
{
  using Triangulation = Intrinsic_triangulation<Traits>;

public:
  using category = boost::readable_property_map_tag;
  using key_type = Edge_index;
  using value_type = decltype(number_of_edge(Tag(), std::declval<const Triangulation&>(), Edge_index()));
  using reference = value_type;

  Edge_number_map() = default;
  explicit Edge_number_map(const Triangulation& triangulation) : triangulation_(&triangulation) {}

  value_type operator[](key_type e) const { return number_of_edge(Tag(), *triangulation_, e); }
  friend value_type get(const Edge_number_map& map, key_type e) { return map[e]; }

private:
  const Triangulation* triangulation_ = nullptr;
};

// Positions are those in the connectivity.
template <class Traits, class Tag, bool is_position = graph_has_property<Delta_complex, Tag>::value>
struct Property_map_of : boost::property_map<Delta_complex, Tag>
{
  static auto of(const Intrinsic_triangulation<Traits>& g) { return get(Tag(), g.connectivity()); }
};
template <class Traits, class Tag>
struct Property_map_of<Traits, Tag, false>
{
  using type = Edge_number_map<Tag, Traits>;
  using const_type = type;

  static type of(const Intrinsic_triangulation<Traits>& g) { return type(g); }
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

namespace boost {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief makes an `Intrinsic_triangulation` a graph of the Boost Graph Library and CGAL: the graph of its
/// `connectivity()`.
///
/// Descriptors, iterators, costs and the warning are as for `graph_traits<Delta_complex>`. Flips do not invalidate
/// descriptors.
///
/// Property maps, in addition to the four index maps. Their keys are of type `Edge_index`, to which the edge descriptor
/// converts. They are models of `ReadablePropertyMap`: a number is computed on access, so it always belongs to the
/// current triangulation, which must outlive the map.
///
/// | tag | value type | value |
/// | --- | --- | --- |
/// | `boost::edge_weight` | `Traits::FT` | `length()`, as for the other graphs of CGAL |
/// | `edge_cotangent_weight` | `Traits::FT` | `cotangent_weight()` |
/// | `edge_normal_coordinate` | `std::int64_t` | `Normal_coordinates::crossings()`; \pre `keeps_input()` |
///
/// \tparam Traits a model of `IntrinsicTriangulationTraits`
///
/// \cgalModels{FaceListGraph,HalfedgeListGraph,BidirectionalGraph,VertexListGraph,EdgeListGraph,AdjacencyGraph}
template <class Traits>
struct graph_traits<CGAL::Intrinsic_triangulations::Intrinsic_triangulation<Traits>>
  : graph_traits<CGAL::Intrinsic_triangulations::Delta_complex>
{};

/// \cond SKIP_IN_MANUAL
template <class Traits>
struct graph_traits<const CGAL::Intrinsic_triangulations::Intrinsic_triangulation<Traits>>
  : graph_traits<CGAL::Intrinsic_triangulations::Delta_complex>
{};
/// \endcond

} // namespace boost

/// \cond SKIP_IN_MANUAL
namespace CGAL::Intrinsic_triangulations {

// A function of the graph, without and with a descriptor.
#define CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(FUNCTION)                                                                \
  template <class Traits>                                                                                              \
  auto FUNCTION(const Intrinsic_triangulation<Traits>& g)                                                              \
  {                                                                                                                    \
    return FUNCTION(g.connectivity());                                                                                 \
  }
#define CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(FUNCTION, DESCRIPTOR)                                                 \
  template <class Traits>                                                                                              \
  auto FUNCTION(DESCRIPTOR x, const Intrinsic_triangulation<Traits>& g)                                                \
  {                                                                                                                    \
    return FUNCTION(x, g.connectivity());                                                                              \
  }
#define CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_SEARCH(FUNCTION)                                                         \
  template <class Traits>                                                                                              \
  auto FUNCTION(Vertex_index u, Vertex_index v, const Intrinsic_triangulation<Traits>& g)                              \
  {                                                                                                                    \
    return FUNCTION(u, v, g.connectivity());                                                                           \
  }
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(num_vertices)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(num_halfedges)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(num_edges)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(num_faces)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(vertices)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(halfedges)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(edges)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD(faces)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(source, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(source, Oriented_edge)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(target, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(target, Oriented_edge)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(degree, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(degree, Face_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(out_degree, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(in_degree, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(out_edges, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(in_edges, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(adjacent_vertices, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(next, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(prev, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(opposite, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(face, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(edge, Halfedge_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(halfedge, Oriented_edge)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(halfedge, Vertex_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF(halfedge, Face_index)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_SEARCH(halfedge)
CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_SEARCH(edge)
#undef CGAL_INTRINSIC_TRIANGULATIONS_FORWARD
#undef CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_OF
#undef CGAL_INTRINSIC_TRIANGULATIONS_FORWARD_SEARCH

} // namespace CGAL::Intrinsic_triangulations

// The maps.
#define CGAL_INTRINSIC_TRIANGULATIONS_MAP(TAG)                                                                         \
  namespace CGAL {                                                                                                     \
  namespace Intrinsic_triangulations {                                                                                 \
  template <class Traits>                                                                                              \
  auto get(TAG, const Intrinsic_triangulation<Traits>& g)                                                              \
  {                                                                                                                    \
    return internal::Property_map_of<Traits, TAG>::of(g);                                                              \
  }                                                                                                                    \
  template <class Traits>                                                                                              \
  auto get(TAG tag, const Intrinsic_triangulation<Traits>& g,                                                          \
           typename internal::Property_map_of<Traits, TAG>::type::key_type key)                                        \
  {                                                                                                                    \
    return get(tag, g)[key];                                                                                           \
  }                                                                                                                    \
  }                                                                                                                    \
  template <class Traits>                                                                                              \
  struct graph_has_property<Intrinsic_triangulations::Intrinsic_triangulation<Traits>, TAG> : Tag_true                 \
  {};                                                                                                                  \
  }                                                                                                                    \
  namespace boost {                                                                                                    \
  template <class Traits>                                                                                              \
  struct property_map<CGAL::Intrinsic_triangulations::Intrinsic_triangulation<Traits>, TAG>                            \
    : CGAL::Intrinsic_triangulations::internal::Property_map_of<Traits, TAG>                                           \
  {};                                                                                                                  \
  }
CGAL_INTRINSIC_TRIANGULATIONS_MAP(boost::vertex_index_t)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(boost::halfedge_index_t)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(boost::edge_index_t)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(boost::face_index_t)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(boost::edge_weight_t)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(CGAL::Intrinsic_triangulations::Edge_cotangent_weight_tag)
CGAL_INTRINSIC_TRIANGULATIONS_MAP(CGAL::Intrinsic_triangulations::Edge_normal_coordinate_tag)
#undef CGAL_INTRINSIC_TRIANGULATIONS_MAP
/// \endcond

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GRAPH_TRAITS_INTRINSIC_TRIANGULATION_H

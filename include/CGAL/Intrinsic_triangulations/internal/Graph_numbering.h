// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Numbers the elements of a face graph in the order of its ranges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GRAPH_NUMBERING_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GRAPH_NUMBERING_H

#include <CGAL/Intrinsic_triangulations/internal/Delta_complex_builder.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Vertices, faces and halfedges (2e and 2e + 1 for edge e) get consecutive numbers. Where
// the graph's own indices are these numbers already, as in a Surface_mesh without
// garbage, no table is made.
template <class FaceGraph>
class Graph_numbering
{
  using Graph_traits = boost::graph_traits<FaceGraph>;

public:
  explicit Graph_numbering(const FaceGraph& graph)
    : graph_(graph), vertex_index_map_(get_initialized_vertex_index_map(graph)),
      halfedge_index_map_(get_initialized_halfedge_index_map(graph)),
      face_index_map_(get_initialized_face_index_map(graph))
  {
    check_size(2 * std::size_t(num_edges(graph)));
    if (is_identity())
      return;
    needs_tables_ = true;
    vertex_of_.resize(num_vertices(graph));
    halfedge_of_.resize(num_halfedges(graph));
    face_of_.resize(num_faces(graph));
    for_all([&](std::size_t index, std::uint32_t number) { vertex_of_[index] = number; return true; },
            [&](std::size_t index, std::uint32_t number) { halfedge_of_[index] = number; return true; },
            [&](std::size_t index, std::uint32_t number) { face_of_[index] = number; return true; });
  }

  std::uint32_t number_of_vertices() const { return number_of_vertices_; }
  std::uint32_t number_of_halfedges() const { return number_of_halfedges_; }
  std::uint32_t number_of_faces() const { return number_of_faces_; }

  // Calls f with three functions from descriptors to numbers.
  template <class F>
  void apply(const F& f) const
  {
    if (needs_tables_)
      f([&](auto v) { return vertex_of_[get(vertex_index_map_, v)]; },
        [&](auto h) { return halfedge_of_[get(halfedge_index_map_, h)]; },
        [&](auto t) { return face_of_[get(face_index_map_, t)]; });
    else
      f([&](auto v) { return std::uint32_t(get(vertex_index_map_, v)); },
        [&](auto h) { return std::uint32_t(get(halfedge_index_map_, h)); },
        [&](auto t) { return std::uint32_t(get(face_index_map_, t)); });
  }

private:
  bool is_identity()
  {
    const auto is_equal = [](std::size_t index, std::uint32_t number) { return index == number; };
    return for_all(is_equal, is_equal, is_equal);
  }

  template <class OnVertex, class OnHalfedge, class OnFace>
  bool for_all(const OnVertex& on_vertex, const OnHalfedge& on_halfedge, const OnFace& on_face)
  {
    bool result = true;
    number_of_vertices_ = number_of_halfedges_ = number_of_faces_ = 0;
    for (typename Graph_traits::vertex_descriptor v : vertices(graph_))
      result &= on_vertex(get(vertex_index_map_, v), number_of_vertices_++);
    for (typename Graph_traits::edge_descriptor e : edges(graph_)) {
      const auto h = halfedge(e, graph_);
      result &= on_halfedge(get(halfedge_index_map_, h), number_of_halfedges_++);
      result &= on_halfedge(get(halfedge_index_map_, opposite(h, graph_)), number_of_halfedges_++);
    }
    for (typename Graph_traits::face_descriptor f : faces(graph_))
      result &= on_face(get(face_index_map_, f), number_of_faces_++);
    return result;
  }

  using Vertex_index_map = decltype(get_initialized_vertex_index_map(std::declval<const FaceGraph&>()));
  using Halfedge_index_map = decltype(get_initialized_halfedge_index_map(std::declval<const FaceGraph&>()));
  using Face_index_map = decltype(get_initialized_face_index_map(std::declval<const FaceGraph&>()));

  const FaceGraph& graph_;
  Vertex_index_map vertex_index_map_;
  Halfedge_index_map halfedge_index_map_;
  Face_index_map face_index_map_;
  bool needs_tables_ = false;
  std::uint32_t number_of_vertices_ = 0, number_of_halfedges_ = 0, number_of_faces_ = 0;
  std::vector<std::uint32_t> vertex_of_, halfedge_of_, face_of_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GRAPH_NUMBERING_H

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Copies the connectivity of a face graph, numbering its elements in the order of its ranges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COPY_FACE_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COPY_FACE_GRAPH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/for_each_block.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

template <class FaceGraph>
class Face_graph_copier
{
  using Graph_traits = boost::graph_traits<FaceGraph>;

public:
  explicit Face_graph_copier(const FaceGraph& graph)
    : graph_(graph), vertex_index_map_(get_initialized_vertex_index_map(graph)),
      halfedge_index_map_(get_initialized_halfedge_index_map(graph)),
      face_index_map_(get_initialized_face_index_map(graph))
  {}

  template <class ConcurrencyTag>
  Delta_complex run()
  {
    // Where the graph's own indices are the numbers already, as in a Surface_mesh without
    // garbage, no table is needed. Whether they are is found out while copying.
    number_of_vertices_ = num_vertices(graph_);
    number_of_edges_ = num_edges(graph_);
    number_of_faces_ = num_faces(graph_);
    check_size(2 * number_of_edges_);
    const bool is_copied =
      copy<ConcurrencyTag>([&](auto v) { return std::uint32_t(get(vertex_index_map_, v)); },
                           [&](auto h) { return std::uint32_t(get(halfedge_index_map_, h)); },
                           [&](auto f) { return std::uint32_t(get(face_index_map_, f)); });
    if (!is_copied) {
      make_tables();
      copy<Sequential_tag>([&](auto v) { return vertex_number_[get(vertex_index_map_, v)]; },
                           [&](auto h) { return halfedge_number_[get(halfedge_index_map_, h)]; },
                           [&](auto f) { return face_number_[get(face_index_map_, f)]; });
    }
    return Delta_complex(std::move(records_), std::move(vertex_halfedges_),
                         std::move(face_halfedges_));
  }

private:
  // Returns false if the given positions are not 0, 1, 2, ... in the order of the ranges.
  template <class ConcurrencyTag, class VertexPosition, class HalfedgePosition, class FacePosition>
  bool copy(const VertexPosition& vertex_position, const HalfedgePosition& halfedge_position,
            const FacePosition& face_position)
  {
    records_ = Delta_complex::Halfedge_vector(2 * number_of_edges_, default_init);
    vertex_halfedges_ = Delta_complex::Descriptor_vector(number_of_vertices_, default_init);
    face_halfedges_ = Delta_complex::Descriptor_vector(number_of_faces_, default_init);
    std::vector<std::vector<std::uint32_t>> border(number_of_edges_ / elements_of_block + 1);

    const auto copy_edges = [&](std::size_t first, std::size_t last, auto e, auto end) {
      std::vector<std::uint32_t>& border_of_block = border[first / elements_of_block];
      Delta_complex::Halfedge* record = records_.data() + 2 * first;
      std::uint32_t position = std::uint32_t(2 * first);
      bool is_in_order = true;
      for (; e != end; ++e) {
        auto h = halfedge(*e, graph_);
        for (int side = 0; side < 2; ++side, ++position, ++record, h = opposite(h, graph_)) {
          const auto f = face(h, graph_);
          const bool is_border = f == Graph_traits::null_face();
          is_in_order &= halfedge_position(h) == position;
          *record = {halfedge_position(next(h, graph_)), halfedge_position(prev(h, graph_)),
                     vertex_position(target(h, graph_)),
                     is_border ? Face_index::null_index() : face_position(f)};
          if (is_border)
            border_of_block.push_back(position);
        }
      }
      return is_in_order && position == 2 * last;
    };
    const auto copy_faces = [&](std::size_t first, std::size_t last, auto f, auto end) {
      std::uint32_t position = std::uint32_t(first);
      bool is_in_order = true;
      for (; f != end; ++f) {
        is_in_order &= face_position(*f) == position;
        face_halfedges_[position++] = Halfedge_index(halfedge_position(halfedge(*f, graph_)));
      }
      return is_in_order && position == last;
    };
    const auto copy_vertices = [&](std::size_t first, std::size_t last, auto v, auto end) {
      std::uint32_t position = std::uint32_t(first);
      bool is_in_order = true;
      for (; v != end; ++v) {
        const auto h = halfedge(*v, graph_);
        is_in_order &= vertex_position(*v) == position;
        vertex_halfedges_[position++] = h == Graph_traits::null_halfedge()
                                          ? Halfedge_index()
                                          : Halfedge_index(halfedge_position(h));
      }
      return is_in_order && position == last;
    };
    if (!for_each_element<ConcurrencyTag>(edges(graph_), number_of_edges_, copy_edges) ||
        !for_each_element<ConcurrencyTag>(faces(graph_), number_of_faces_, copy_faces) ||
        !for_each_element<ConcurrencyTag>(vertices(graph_), number_of_vertices_, copy_vertices))
      return false;
    for (const std::vector<std::uint32_t>& of_block : border)
      for (std::uint32_t h : of_block)
        vertex_halfedges_[records_[h].target] = Halfedge_index(h);
    return true;
  }

  // The numbers of elements that a graph tells may be larger than those of its ranges.
  void make_tables()
  {
    number_of_vertices_ = number_of_edges_ = number_of_faces_ = 0;
    for (typename Graph_traits::vertex_descriptor v : vertices(graph_))
      set(vertex_number_, get(vertex_index_map_, v), number_of_vertices_++);
    for (typename Graph_traits::edge_descriptor e : edges(graph_)) {
      const auto h = halfedge(e, graph_);
      set(halfedge_number_, get(halfedge_index_map_, h), 2 * number_of_edges_);
      set(halfedge_number_, get(halfedge_index_map_, opposite(h, graph_)),
          2 * number_of_edges_ + 1);
      ++number_of_edges_;
    }
    for (typename Graph_traits::face_descriptor f : faces(graph_))
      set(face_number_, get(face_index_map_, f), number_of_faces_++);
  }

  static void set(std::vector<std::uint32_t>& table, std::size_t index, std::size_t number)
  {
    if (table.size() <= index)
      table.resize(index + 1);
    table[index] = std::uint32_t(number);
  }

  using Vertex_index_map = decltype(get_initialized_vertex_index_map(std::declval<const FaceGraph&>()));
  using Halfedge_index_map = decltype(get_initialized_halfedge_index_map(std::declval<const FaceGraph&>()));
  using Face_index_map = decltype(get_initialized_face_index_map(std::declval<const FaceGraph&>()));

  const FaceGraph& graph_;
  Vertex_index_map vertex_index_map_;
  Halfedge_index_map halfedge_index_map_;
  Face_index_map face_index_map_;
  std::size_t number_of_vertices_ = 0, number_of_edges_ = 0, number_of_faces_ = 0;
  std::vector<std::uint32_t> vertex_number_, halfedge_number_, face_number_;
  Delta_complex::Halfedge_vector records_;
  Delta_complex::Descriptor_vector vertex_halfedges_, face_halfedges_;
};

// Its faces are still to be checked for being triangles.
template <class ConcurrencyTag, class FaceGraph>
Delta_complex copy_face_graph(const FaceGraph& graph)
{
  return Face_graph_copier<FaceGraph>(graph).template run<ConcurrencyTag>();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COPY_FACE_GRAPH_H

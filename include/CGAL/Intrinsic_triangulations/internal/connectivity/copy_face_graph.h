// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Copies the connectivity of a face graph, numbering its elements in the order of its ranges.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COPY_FACE_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COPY_FACE_GRAPH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

/// \cond SKIP_IN_MANUAL
namespace CGAL {
template <typename Point>
class Surface_mesh;
} // namespace CGAL
/// \endcond

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a graph is known, without looking at its elements, to number them in the order of its ranges.
template <class FaceGraph>
bool has_no_garbage(const FaceGraph&)
{
  return false;
}
template <class Point>
bool has_no_garbage(const Surface_mesh<Point>& mesh)
{
  return !mesh.has_garbage();
}

// Works in three steps, so that faces can be measured while their records are still in the processor's cache:
// `copy_vertices()`, `copy_faces()` until all are copied, and `finish()`.
template <class FaceGraph>
class Face_graph_copier
{
  using Graph_traits = boost::graph_traits<FaceGraph>;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Halfedge = typename Graph_traits::halfedge_descriptor;
  using Edge = typename Graph_traits::edge_descriptor;
  using Face = typename Graph_traits::face_descriptor;

public:
  explicit Face_graph_copier(const FaceGraph& graph)
    : graph_(graph), vertex_index_map_(get_initialized_vertex_index_map(graph)),
      halfedge_index_map_(get_initialized_halfedge_index_map(graph)),
      face_index_map_(get_initialized_face_index_map(graph))
  {}

  // Returns the complex, whose halfedges and faces are filled in by the next steps.
  template <class ConcurrencyTag>
  Delta_complex copy_vertices()
  {
    number_of_vertices_ = num_vertices(graph_);
    number_of_edges_ = num_edges(graph_);
    number_of_faces_ = num_faces(graph_);
    // If the graph's own indices are these numbers, as in a Surface_mesh without garbage, no table is needed.
    const bool is_in_order = is_numbered_in_order<ConcurrencyTag>();
    if (!is_in_order)
      make_tables();
    copies_faces_ = is_in_order && has_random_access;
    check_size(2 * number_of_edges_);
    Delta_complex::Halfedge_vector records(2 * number_of_edges_, default_init);
    Delta_complex::Descriptor_vector vertex_halfedges(number_of_vertices_, default_init),
      face_halfedges(number_of_faces_, default_init);
    records_ = records.data(); // also of the complex's vectors
    vertex_halfedges_ = vertex_halfedges.data();
    face_halfedges_ = face_halfedges.data();
    if (copies_faces_) {
      border_.resize(number_of_faces_ / elements_of_block + 1);
      for_each_element<ConcurrencyTag>(
        vertices(graph_), number_of_vertices_, [&](std::size_t first, std::size_t, auto v, auto end) {
          for (Halfedge_index* to = vertex_halfedges_ + first; v != end; ++v, ++to) {
            const Halfedge h = halfedge(*v, graph_);
            *to = h == Graph_traits::null_halfedge() ? Halfedge_index() : Halfedge_index(own_number(h));
          }
          return true;
        });
    } else {
      copy_all();
    }
    return Delta_complex(std::move(records), std::move(vertex_halfedges), std::move(face_halfedges));
  }

  // Copies the faces from first to last, which lie in one block, and the border at their sides. Threads may copy
  // different blocks at once.
  void copy_faces(std::size_t first, std::size_t last)
  {
    if constexpr (has_random_access) {
      if (!copies_faces_)
        return;
      const bool has_border = 3 * number_of_faces_ != 2 * number_of_edges_;
      auto f = faces(graph_).begin() + std::ptrdiff_t(first);
      for (std::size_t number = first; number != last; ++number, ++f) {
        const Halfedge h = halfedge(*f, graph_);
        copy_face(h, std::uint32_t(number));
        if (has_border)
          copy_border_beside(h, border_[first / elements_of_block]);
      }
    }
  }

  void finish()
  {
    if (!copies_faces_)
      return;
    std::size_t number_of_copied = 3 * number_of_faces_;
    for (const std::vector<std::uint32_t>& of_block : border_)
      number_of_copied += of_block.size();
    if (number_of_copied != 2 * number_of_edges_) // an edge without faces, or faces that are not triangles
      copy_all();
    for (const std::vector<std::uint32_t>& of_block : border_)
      link_to_border(of_block);
  }

private:
  static constexpr bool has_random_access =
    std::is_convertible<typename std::iterator_traits<typename Graph_traits::face_iterator>::iterator_category,
                        std::random_access_iterator_tag>::value;

  std::uint32_t own_number_of_vertex(Vertex v) const { return std::uint32_t(get(vertex_index_map_, v)); }
  std::uint32_t own_number(Halfedge h) const { return std::uint32_t(get(halfedge_index_map_, h)); }

  // Whether the graph's own indices are 0, 1, 2, ... in the order of its ranges.
  template <class ConcurrencyTag>
  bool is_numbered_in_order() const
  {
    const auto are_in_order = [](const auto& range, std::size_t n, const auto& has_number) {
      return for_each_element<ConcurrencyTag>(range, n,
                                              [&](std::size_t first, std::size_t last, auto element, auto end) {
                                                bool result = true;
                                                for (; element != end; ++element, ++first)
                                                  result &= has_number(*element, std::uint32_t(first));
                                                return result && first == last;
                                              });
    };
    if (has_no_garbage(graph_))
      return true;
    return are_in_order(vertices(graph_), number_of_vertices_,
                        [&](Vertex v, std::uint32_t n) { return own_number_of_vertex(v) == n; }) &&
           are_in_order(edges(graph_), number_of_edges_,
                        [&](Edge e, std::uint32_t n) {
                          const Halfedge h = halfedge(e, graph_);
                          return own_number(h) == 2 * n && own_number(opposite(h, graph_)) == 2 * n + 1;
                        }) &&
           are_in_order(faces(graph_), number_of_faces_,
                        [&](Face f, std::uint32_t n) { return std::uint32_t(get(face_index_map_, f)) == n; });
  }

  void copy_face(Halfedge h, std::uint32_t number)
  {
    const Halfedge after = next(h, graph_), last = next(after, graph_);
    const std::uint32_t i = own_number(h), j = own_number(after), k = own_number(last);
    face_halfedges_[number] = Halfedge_index(i);
    records_[i] = {j, own_number(prev(h, graph_)), own_number_of_vertex(target(h, graph_)), number};
    records_[j] = {k, i, own_number_of_vertex(target(after, graph_)), number};
    records_[k] = {i, j, own_number_of_vertex(target(last, graph_)), number};
    if (last != prev(h, graph_)) // not a triangle, which others report
      for (Halfedge g = last; g != h; g = next(g, graph_))
        records_[own_number(g)] = own_record(g, number);
  }

  void copy_border_beside(Halfedge h, std::vector<std::uint32_t>& border)
  {
    for (int side = 0; side < 3; ++side, h = next(h, graph_)) {
      const Halfedge g = opposite(h, graph_);
      if (face(g, graph_) != Graph_traits::null_face())
        continue;
      records_[own_number(g)] = own_record(g, Face_index::null_index());
      border.push_back(own_number(g));
    }
  }

  Delta_complex::Halfedge own_record(Halfedge h, std::uint32_t face) const
  {
    return {own_number(next(h, graph_)), own_number(prev(h, graph_)), own_number_of_vertex(target(h, graph_)), face};
  }

  // Copies the whole graph at once.
  void copy_all()
  {
    const auto number_of = [](const std::vector<std::uint32_t>& table, std::size_t own_number) {
      return table.empty() ? std::uint32_t(own_number) : table[own_number];
    };
    const auto number = [&](Halfedge h) { return number_of(halfedge_number_, get(halfedge_index_map_, h)); };
    const auto copy_of = [&](Halfedge h) {
      return h == Graph_traits::null_halfedge() ? Halfedge_index() : Halfedge_index(number(h));
    };
    std::vector<std::uint32_t> border;
    std::uint32_t i = 0;
    for (Edge e : edges(graph_)) {
      Halfedge h = halfedge(e, graph_);
      for (int side = 0; side < 2; ++side, ++i, h = opposite(h, graph_)) {
        const Face f = face(h, graph_);
        const bool is_border = f == Graph_traits::null_face();
        records_[i] = {number(next(h, graph_)), number(prev(h, graph_)),
                       number_of(vertex_number_, get(vertex_index_map_, target(h, graph_))),
                       is_border ? Face_index::null_index() : number_of(face_number_, get(face_index_map_, f))};
        if (is_border)
          border.push_back(i);
      }
    }
    Halfedge_index* to = face_halfedges_;
    for (Face f : faces(graph_))
      *to++ = copy_of(halfedge(f, graph_));
    to = vertex_halfedges_;
    for (Vertex v : vertices(graph_))
      *to++ = copy_of(halfedge(v, graph_));
    link_to_border(border);
  }

  // A border vertex gets a border halfedge.
  void link_to_border(const std::vector<std::uint32_t>& border)
  {
    for (std::uint32_t h : border)
      vertex_halfedges_[records_[h].target] = Halfedge_index(h);
  }

  // A graph may report more elements than its ranges have.
  void make_tables()
  {
    number_of_vertices_ = number_of_edges_ = number_of_faces_ = 0;
    for (Vertex v : vertices(graph_))
      set(vertex_number_, get(vertex_index_map_, v), number_of_vertices_++);
    for (Edge e : edges(graph_)) {
      const Halfedge h = halfedge(e, graph_);
      set(halfedge_number_, get(halfedge_index_map_, h), 2 * number_of_edges_);
      set(halfedge_number_, get(halfedge_index_map_, opposite(h, graph_)), 2 * number_of_edges_ + 1);
      ++number_of_edges_;
    }
    for (Face f : faces(graph_))
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
  std::vector<std::uint32_t> vertex_number_, halfedge_number_,
    face_number_;                                  // if the graph's own indices are not in order
  bool copies_faces_ = false;                      // otherwise copy_vertices() copies all
  std::vector<std::vector<std::uint32_t>> border_; // of each block of faces
  Delta_complex::Halfedge* records_ = nullptr;
  Halfedge_index *vertex_halfedges_ = nullptr, *face_halfedges_ = nullptr;
};

// The faces have yet to be checked for being triangles.
template <class ConcurrencyTag, class FaceGraph>
Delta_complex copy_face_graph(const FaceGraph& graph)
{
  Face_graph_copier<FaceGraph> copier(graph);
  Delta_complex complex = copier.template copy_vertices<ConcurrencyTag>();
  for_each_block<ConcurrencyTag>(complex.number_of_faces(), elements_of_block,
                                 [&](std::size_t first, std::size_t last) { copier.copy_faces(first, last); });
  copier.finish();
  return complex;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_COPY_FACE_GRAPH_H

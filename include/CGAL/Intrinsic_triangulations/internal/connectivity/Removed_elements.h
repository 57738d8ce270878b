// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// What the removal of a vertex takes out of arrays, and what moves.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REMOVED_ELEMENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REMOVED_ELEMENTS_H

#include <CGAL/Intrinsic_triangulations/internal/Index.h>

#include <boost/container/static_vector.hpp>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsConnectivity
///
/// \brief the elements that the removal of a vertex took away, by their descriptors before it.
///
/// Descriptors have no holes: for each element of a list in turn, the last element takes its place. The lists
/// are in descending order, so that an element that is removed never moves. `remove_entries()` does the same with an
/// array. Halfedges move with their edges: `2e + i` becomes `2f + i`. The lists need no memory of their own, so that
/// to copy them, and to remove entries, never throws.
struct Removed_elements
{
  boost::container::static_vector<Vertex_index, 1> vertices; ///< one vertex
  boost::container::static_vector<Edge_index, 3> edges;      ///< two or three edges
  boost::container::static_vector<Face_index, 2> faces;      ///< one or two faces
  std::uint32_t number_of_edges = 0;                         ///< that of edges before the removal

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
/// \param holes what was removed, not before `first`
/// \param first the number of the element that the first entry belongs to
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

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_CONNECTIVITY_REMOVED_ELEMENTS_H

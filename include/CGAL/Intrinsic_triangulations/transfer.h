// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Transfers data at the vertices and corners of the two triangulations to their overlay.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/assertions.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

template <class Range>
using Value_of = std::decay_t<decltype(std::declval<const Range&>()[0])>;

// `edge_of` and `position_of` say where a crossing lies in `complex`; the vertices before, where those that are none of `complex` lie.
template <class VertexValues, class EdgeOf, class PositionOf>
auto interpolate_at_crossings(const Common_subdivision& subdivision, const Delta_complex& complex,
                              const VertexValues& values, const EdgeOf& edge_of,
                              const PositionOf& position_of)
{
  const Overlay& overlay = subdivision.overlay();
  CGAL_precondition(values.size() == complex.number_of_vertices());
  using Value = Value_of<VertexValues>;
  static_assert(!std::is_integral<Value>::value, "interpolation between integers would cut off");
  std::vector<Value> result;
  result.reserve(overlay.number_of_vertices());
  for (Vertex_index v : complex.vertices())
    result.push_back(values[v.idx()]);
  for (Overlay::size_type v = complex.number_of_vertices(); v < overlay.number_of_original_vertices(); ++v)
    result.push_back(interpolate(complex, values, subdivision.positions().location(Overlay::Vertex(v))));
  for (Overlay::Vertex x : overlay.crossings()) {
    const Halfedge_index h = complex.halfedge(edge_of(x));
    const double t = position_of(x);
    result.push_back(Value((1 - t) * values[complex.source(h).idx()] +
                           t * values[complex.target(h).idx()]));
  }
  return result;
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns at each vertex of the overlay the piecewise linear function with given values at
/// the vertices of the input.
///
/// The function is linear on each face of the overlay, so the values represent it everywhere. They
/// are interpolated along the input edge of each crossing; edges are never looked up by their end
/// vertices, so loops and multiple edges are handled correctly. O(size of the
/// overlay).
///
/// \tparam VertexValues a random access range with `size()`; values can be added and multiplied by
///   a `double` from the left, and are not integers
/// \param subdivision the common subdivision
/// \param values the value of each vertex
/// \return a vector with the value at each vertex of the overlay
template <class VertexValues>
auto interpolate_input_values(const Common_subdivision& subdivision, const VertexValues& values)
{
  return internal::interpolate_at_crossings(
    subdivision, subdivision.input(), values,
    [&](Overlay::Vertex x) { return subdivision.overlay().input_edge(x); },
    [&](Overlay::Vertex x) { return subdivision.positions().on_input_edge(x); });
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns at each vertex of the overlay the piecewise linear function with given values at
/// the vertices of the intrinsic triangulation; as `interpolate_input_values()`.
///
/// It transfers a solution computed on the intrinsic triangulation back to the surface.
/// \param subdivision the common subdivision
/// \param values the value of each vertex
template <class VertexValues>
auto interpolate_intrinsic_values(const Common_subdivision& subdivision, const VertexValues& values)
{
  return internal::interpolate_at_crossings(
    subdivision, subdivision.intrinsic(), values,
    [&](Overlay::Vertex x) { return subdivision.overlay().intrinsic_edge(x); },
    [&](Overlay::Vertex x) { return subdivision.positions().on_intrinsic_edge(x); });
}

/// \ingroup PkgIntrinsicTriangulationsTransfer
/// \brief returns at each corner of each face of the overlay the function that is linear on each
/// input face and has given values at its corners, such as texture coordinates.
///
/// If the values on the two sides of an input edge differ (a seam), they differ in the
/// same way along the segments of that edge, and nowhere else. O(size of the overlay).
///
/// \tparam CornerValues a random access range with `size()`; values can be added, multiplied by a
///   `double` from the left, and default-constructed
/// \param subdivision the common subdivision
/// \param values for each halfedge of the input, the value in the corner of its face at its target;
///   those of border halfedges are ignored
/// \return for each halfedge of the overlay, the value in the corner of its face at
///   its target; those of border halfedges are default-constructed
template <class CornerValues>
auto interpolate_input_corner_values(const Common_subdivision& subdivision, const CornerValues& values)
{
  const Overlay& overlay = subdivision.overlay();
  const Delta_complex& input = subdivision.input();
  CGAL_precondition(values.size() == input.number_of_halfedges());
  using Value = internal::Value_of<CornerValues>;
  static_assert(!std::is_integral<Value>::value, "interpolation between integers would cut off");
  std::vector<Value> result(overlay.number_of_halfedges());
  const internal::Input_layer layer{input, overlay, subdivision.positions()};
  for (Overlay::Halfedge h : overlay.halfedges()) {
    if (overlay.is_border(h))
      continue;
    if (layer.is_inside(overlay.target(h))) {
      const auto& [side, weights] = subdivision.positions().location(overlay.target(h));
      result[h.idx()] = Value(weights[0] * values[input.prev(side).idx()] + weights[1] * values[side.idx()] +
                              weights[2] * values[input.next(side).idx()]);
      continue;
    }
    const Halfedge_index side = layer.side(h);
    const double t = layer.on_side(h);
    result[h.idx()] =
      Value((1 - t) * values[input.prev(side).idx()] + t * values[side.idx()]);
  }
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Transfer of data at vertices and faces between the two surfaces, and the areas that faces share.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <CGAL/assertions.h>

#include <boost/type_traits/is_detected.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The fraction of a face covered by the triangle of three points, given in the face's coordinates.
inline double area_fraction(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  return determinant(b[1] - a[1], b[2] - a[2], c[1] - a[1], c[2] - a[2]);
}

// A face of the overlay, as a fan of triangles around its first corner.
struct Overlay_fan
{
  // The coordinates `from` belong to the input face, relative to the halfedge that they name, and `to` to the intrinsic
  // face.
  Corners_in_both corners;
  double input_area;
  double intrinsic_area;

  std::size_t size() const { return corners.size() - 2; }

  // The area of triangle i. Rounding errors are relative to the smaller of the two faces, so
  // that small areas in large faces keep their digits.
  double area(std::size_t i) const
  {
    const Corner_in_both &a = corners[0], &b = corners[i + 1], &c = corners[i + 2];
    return input_area < intrinsic_area ? input_area * area_fraction(a.from, b.from, c.from)
                                       : intrinsic_area * area_fraction(a.to, b.to, c.to);
  }
};

// The areas of the faces of both triangulations, in the unit of the input.
struct Areas_in_both
{
  explicit Areas_in_both(const Common_subdivision& subdivision)
  {
    const internal::Exact_engine& engine = internal::engine(subdivision);
    const Delta_complex& complex = subdivision.input();
    for (Face_index f : complex.faces())
      input.push_back(area_in_input_unit(engine.metric().four_areas_double_double(complex, f).hi() / 4,
                                         engine.metric().unit_exponent(), f));
    for (Face_index f : subdivision.intrinsic().faces())
      intrinsic.push_back(internal::Engine_numbers(engine).area(f));
  }

  std::vector<double> input, intrinsic;
};

// Calls `visit(f, fan)` for each face f of the overlay.
template <class Visit>
void for_each_overlay_fan(const Common_subdivision& subdivision, const Areas_in_both& areas, const Visit& visit)
{
  const Input_layer input(subdivision);
  const Intrinsic_layer intrinsic(subdivision);
  for (Overlay::Face f : subdivision.overlay().faces()) {
    const Face_index in_input = input.face(f), in_intrinsic = intrinsic.face(f);
    visit(f, Overlay_fan{corners_in_both(input, input.complex.halfedge(in_input), intrinsic,
                                         intrinsic.complex.halfedge(in_intrinsic), f),
                         areas.input[in_input.idx()], areas.intrinsic[in_intrinsic.idx()]});
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns the area of each face of the overlay, in the unit of the input.
///
/// It is the fraction of its input face or intrinsic face that the face covers, times the
/// area of that face, so no embedding is needed. The error is a few units in the last place of the
/// area of the smaller of the two.
/// \param subdivision the common subdivision. O(size of the overlay).
/// \exception Invalid_surface_error as `area()` of `Intrinsic_triangulation`
inline std::vector<double> face_areas(const Common_subdivision& subdivision)
{
  std::vector<double> areas(subdivision.overlay().number_of_faces());
  internal::for_each_overlay_fan(subdivision, internal::Areas_in_both(subdivision),
                                 [&](Overlay::Face f, const internal::Overlay_fan& fan) {
                                   double area = 0;
                                   for (std::size_t i = 0; i < fan.size(); ++i)
                                     area += fan.area(i);
                                   areas[f.idx()] = area;
                                 });
  return areas;
}

namespace internal {

template <class Value>
using Mean = decltype(Value(0.5 * std::declval<const Value&>() + 0.5 * std::declval<const Value&>()));

// The type of values that can be interpolated.
template <class Range>
struct Interpolated
{
  using Value = std::decay_t<decltype(std::declval<const Range&>()[0])>;
  static_assert(boost::is_detected<Mean, Value>::value,
                "values have to be added and, from the left, multiplied by a double");
  static_assert(!std::is_integral<Value>::value, "interpolation between integers would cut off");
};
template <class Range>
using Value_of = typename Interpolated<Range>::Value;

// The values at the vertices of the overlay, from those at the vertices of a layer.
template <class Layer, class VertexValues>
auto interpolate_in_layer(const Layer& layer, const VertexValues& values)
{
  const Overlay& overlay = layer.overlay;
  const Delta_complex& complex = layer.complex;
  CGAL_precondition(values.size() == complex.number_of_vertices());
  using Value = Value_of<VertexValues>;
  std::vector<Value> result;
  result.reserve(overlay.number_of_vertices());
  for (Vertex_index v : complex.vertices())
    result.push_back(values[v.idx()]);
  for (Overlay::size_type v = complex.number_of_vertices(); v < overlay.number_of_original_vertices(); ++v)
    result.push_back(interpolate(complex, values, layer.positions.location(Overlay::Vertex(v))));
  for (Overlay::Vertex x : overlay.crossings()) {
    const Halfedge_index h = complex.halfedge(layer.edge(x));
    const double t = layer.on_edge(x);
    result.push_back(Value((1 - t) * values[complex.source(h).idx()] + t * values[complex.target(h).idx()]));
  }
  return result;
}

} // namespace internal

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
  return internal::interpolate_in_layer(internal::Input_layer(subdivision), values);
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
  return internal::interpolate_in_layer(internal::Intrinsic_layer(subdivision), values);
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
  std::vector<Value> result(overlay.number_of_halfedges());
  const internal::Input_layer layer(subdivision);
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
    result[h.idx()] = Value((1 - t) * values[input.prev(side).idx()] + t * values[side.idx()]);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRANSFER_H

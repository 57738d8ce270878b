// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The two triangulations as layers of their overlay, seen in the same way.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_LAYERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_LAYERS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Overlay_positions.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

struct Input_layer
{
  const Delta_complex& complex;
  const Overlay& overlay;
  const Overlay_positions& positions;

  std::int64_t number_of_crossings(Edge_index e) const
  {
    return std::int64_t(overlay.number_of_input_segments(e)) - 1;
  }
  // The part of h at a position from its source, in the direction of h.
  Overlay::Halfedge part(Halfedge_index h, std::int64_t position) const
  {
    const Edge_index e = complex.edge(h);
    if (h == complex.halfedge(e))
      return overlay.input_part(e, Overlay::size_type(position));
    return overlay.opposite(
      overlay.input_part(e, Overlay::size_type(number_of_crossings(e) - position)));
  }
  Halfedge_index halfedge(Overlay::Halfedge h) const { return overlay.input_halfedge(h); }
  Face_index face(Overlay::Face f) const { return overlay.input_face(f); }
  Halfedge_index side(Overlay::Halfedge h) const { return overlay.input_side(h); }
  double on_side(Overlay::Halfedge h) const { return positions.on_input_side(overlay, h); }
};

struct Intrinsic_layer
{
  const Delta_complex& complex;
  const Overlay& overlay;
  const Overlay_positions& positions;

  std::int64_t number_of_crossings(Edge_index e) const
  {
    return std::int64_t(overlay.intrinsic_segments(e).size()) - 1;
  }
  Overlay::Halfedge part(Halfedge_index h, std::int64_t position) const
  {
    const Edge_index e = complex.edge(h);
    const auto segments = overlay.intrinsic_segments(e);
    if (h == complex.halfedge(e))
      return overlay.halfedge(segments.begin()[position]);
    return overlay.opposite(overlay.halfedge(segments.end()[-1 - position]));
  }
  Halfedge_index halfedge(Overlay::Halfedge h) const { return overlay.intrinsic_halfedge(h); }
  Face_index face(Overlay::Face f) const { return overlay.intrinsic_face(f); }
  Halfedge_index side(Overlay::Halfedge h) const { return overlay.intrinsic_side(h); }
  double on_side(Overlay::Halfedge h) const { return positions.on_intrinsic_side(overlay, h); }
};

using Coordinates = std::array<double, 3>;

// The number of h among the sides of its face from `first`.
inline std::size_t side_number(const Delta_complex& complex, Halfedge_index first, Halfedge_index h)
{
  return h == first ? 0 : h == complex.next(first) ? 1 : 2;
}

// The barycentric coordinates, relative to `first`, of the target of h in the face of the layer
// that contains the face of h.
template <class Layer>
Coordinates corner_coordinates(const Layer& layer, Overlay::Halfedge h, Halfedge_index first)
{
  const std::size_t i = side_number(layer.complex, first, layer.side(h));
  const double t = layer.on_side(h);
  Coordinates result{0, 0, 0};
  result[i] = 1 - t;
  result[(i + 1) % 3] = t;
  return result;
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_LAYERS_H

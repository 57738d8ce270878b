// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The two triangulations as layers of their overlay, with a common interface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_LAYERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_LAYERS_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>

#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// The side of a face that begins at a vertex; null if there are several.
Halfedge_index only_side_from(const Delta_complex& complex, Face_index f, Vertex_index v);

// Like `search()`, which walks around the target of h if that is a vertex of the surface: through all segments of the
// other layer there. Repeating this for each corner between them is needed only if the face of the layer has the vertex
// several times.
template <class Search>
Halfedge_index side_at_target(const Delta_complex& complex, const Overlay& overlay, Face_index f, Overlay::Halfedge h,
                              const Search& search)
{
  const Overlay::Vertex v = overlay.target(h);
  if (overlay.is_crossing(v))
    return search();
  const Halfedge_index side = only_side_from(complex, f, overlay.original_vertex(v));
  return side.is_valid() ? side : search();
}

// \pre the subdivision outlives it
struct Input_layer
{
  const Exact_engine& engine;
  const Delta_complex& complex;
  const Overlay& overlay;
  const Overlay_positions& positions;

  explicit Input_layer(const Common_subdivision& s)
    : engine(internal::engine(s)), complex(s.input()), overlay(s.overlay()), positions(s.positions())
  {}

  std::int64_t number_of_crossings(Edge_index e) const { return std::int64_t(overlay.number_of_input_segments(e)) - 1; }
  // The part of h at a position from its source, in the direction of h.
  Overlay::Halfedge part(Halfedge_index h, std::int64_t position) const
  {
    const Edge_index e = complex.edge(h);
    if (h == complex.halfedge(e))
      return overlay.input_part(e, Overlay::size_type(position));
    return overlay.opposite(overlay.input_part(e, Overlay::size_type(number_of_crossings(e) - position)));
  }
  Halfedge_index halfedge(Overlay::Halfedge h) const { return overlay.input_halfedge(h); }
  Face_index face(Overlay::Face f) const { return overlay.input_face(f); }
  Edge_index edge(Overlay::Vertex crossing) const { return overlay.input_edge(crossing); }
  double on_edge(Overlay::Vertex crossing) const { return positions.on_input_edge(crossing); }
  // The side of the face on which the target of h lies.
  Halfedge_index side(Overlay::Halfedge h) const
  {
    return side_at_target(complex, overlay, face(overlay.face(h)), h, [&] { return overlay.input_side(h); });
  }
  double on_side(Overlay::Halfedge h) const { return positions.on_input_side(overlay, h); }
  std::pair<double, double> ends(Overlay::Halfedge h) const { return positions.ends_on_input_halfedge(overlay, h); }
  bool is_inside(Overlay::Vertex v) const { return overlay.is_inserted(v) && positions.location(v).dimension() == 2; }

  // On which side of the chord after `before` a point of the face lies, exactly. A chord is a segment of the overlay
  // that crosses a face of the layer and is part of an edge of the other one. Both are laid out over the input
  // triangles that the intrinsic edge crosses. In a face of zero area there may be no side: if the edge runs along the
  // face, all its points lie on one line.
  std::optional<Sign> side_of_chord(Overlay::Halfedge before, const Surface_point& point) const;
};

struct Intrinsic_layer
{
  const Exact_engine& engine;
  const Delta_complex& complex;
  const Overlay& overlay;
  const Overlay_positions& positions;

  explicit Intrinsic_layer(const Common_subdivision& s)
    : engine(internal::engine(s)), complex(s.intrinsic()), overlay(s.overlay()), positions(s.positions())
  {}

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
  Edge_index edge(Overlay::Vertex crossing) const { return overlay.intrinsic_edge(crossing); }
  double on_edge(Overlay::Vertex crossing) const { return positions.on_intrinsic_edge(crossing); }
  Halfedge_index side(Overlay::Halfedge h) const
  {
    return side_at_target(complex, overlay, face(overlay.face(h)), h, [&] { return overlay.intrinsic_side(h); });
  }
  double on_side(Overlay::Halfedge h) const { return positions.on_intrinsic_side(overlay, h); }
  std::pair<double, double> ends(Overlay::Halfedge h) const { return positions.ends_on_intrinsic_halfedge(overlay, h); }
  bool is_inside(Overlay::Vertex) const { return false; }
  // \pre the chord begins at a crossing, on the side that `before` is part of
  std::optional<Sign> side_of_chord(Overlay::Halfedge before, const Surface_point& point) const;
};

using Coordinates = std::array<double, 3>;

// The target of h in the face of the layer that contains the face of h.
template <class Layer>
Surface_point corner(const Layer& layer, Overlay::Halfedge h)
{
  if (layer.is_inside(layer.overlay.target(h)))
    return layer.positions.location(layer.overlay.target(h));
  const double t = layer.on_side(h);
  return {layer.side(h), {1 - t, t, 0}};
}

// Its barycentric coordinates relative to `first`.
template <class Layer>
Coordinates corner_coordinates(const Layer& layer, Overlay::Halfedge h, Halfedge_index first)
{
  return coordinates_from(layer.complex, corner(layer, h), first);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POSITIONS_OVERLAY_LAYERS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay of the input triangulation and the intrinsic one: the graph of section 2.3
// of the paper.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Overlay_arrays.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

template <class Traits>
class Intrinsic_triangulation;

namespace internal {
class Exact_engine;
template <class ConcurrencyTag, class Triangulation>
const internal::Exact_engine& engine(const Triangulation& triangulation);
} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief which of the two triangulations a segment of the overlay is part of: the labels o,
/// c and oc of the paper. Output files contain the same values.
enum class Segment_label : std::uint8_t {
  INPUT = 0,     ///< part of an input edge (o)
  INTRINSIC = 1, ///< part of an intrinsic edge (c)
  BOTH = 2       ///< an edge of both triangulations (oc)
};

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the overlay of the input triangulation and the intrinsic triangulation.
///
/// Its vertices are the vertices of the input, then the inserted vertices, then the crossings of input and intrinsic
/// edges. Its edges are the segments into which crossings cut the edges. Each of its faces is the convex intersection
/// of one input face and one intrinsic face. At a crossing four segments meet, alternately of an input and of an
/// intrinsic edge. The overlay has neither coordinates nor lengths; see `Common_subdivision`. An inserted vertex
/// divides the input edge on which it lies into segments, as a crossing does, or lies inside an input face.
///
/// The overlay is built from the integers that say where the input lies; later flips do not change
/// it. It is a halfedge graph like `Delta_complex`, with faces of any degree:
/// halfedges `2s` and `2s + 1` belong to segment `s`. Halfedge `2s` runs in the direction of
/// halfedge `2e` of the intrinsic edge that contains `s`, or of the input edge if the
/// label is `INPUT`. The segments of an edge are numbered consecutively, and so are the
/// crossings along an intrinsic edge and the faces within an intrinsic face.
///
/// Memory: 28 bytes a segment, 4 a vertex, 12 a face, 8 an intrinsic and 8 an input edge.
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.3.
class Overlay
{
public:
  /// the type of indices and counts
  using size_type = std::uint32_t;
  /// a vertex of the surface or a crossing
  using Vertex = Index<internal::Element_tag<'v', Overlay>>;
  /// one of the two directions of a segment
  using Halfedge = Index<internal::Element_tag<'h', Overlay>>;
  /// a part of an edge between two crossings or vertices
  using Segment = Index<internal::Element_tag<'s', Overlay>>;
  /// a convex polygon
  using Face = Index<internal::Element_tag<'f', Overlay>>;
  /// a range of descriptors
  template <class Descriptor>
  using Range = Iterator_range<Descriptor_iterator<Descriptor>>;

  /// \brief builds the overlay of a triangulation and its input, as `make_overlay()` without threads.
  template <class Traits, class NamedParameters = parameters::Default_named_parameters>
  explicit Overlay(const Intrinsic_triangulation<Traits>& triangulation,
                   const NamedParameters& np = parameters::default_values())
    : Overlay(triangulation.connectivity(), internal::engine<Sequential_tag>(triangulation).correspondence(),
              internal::progress_function_of(np))
  {}

  /// \cond SKIP_IN_MANUAL
  // From the current connectivity and its correspondence, which knows the input.
  Overlay(const Delta_complex& intrinsic, const internal::Correspondence& correspondence,
          const Progress_function& progress = {}, const internal::Block_runner& threads = {})
    : arrays_(internal::build_overlay(intrinsic, correspondence, progress, threads))
  {}
  /// \endcond

  /// \name Size
  /// @{
  /// returns the number of vertices of the surface and crossings.
  size_type number_of_vertices() const { return size_type(arrays_.vertex_halfedges.size()); }
  /// returns the number of vertices of the surface, which come before the crossings.
  size_type number_of_original_vertices() const { return arrays_.number_of_original_vertices; }
  /// returns the number of vertices of the input, which come before the inserted ones.
  size_type number_of_input_vertices() const { return arrays_.number_of_input_vertices; }
  /// returns the number of crossings.
  size_type number_of_crossings() const { return number_of_vertices() - arrays_.number_of_original_vertices; }
  /// returns the number of segments.
  size_type number_of_segments() const { return size_type(arrays_.parents.size()); }
  /// returns the number of halfedges, two for each segment.
  size_type number_of_halfedges() const { return size_type(arrays_.halfedges.size()); }
  /// returns the number of faces.
  size_type number_of_faces() const { return size_type(arrays_.faces.size()); }
  /// returns the number of edges of the intrinsic triangulation.
  size_type number_of_intrinsic_edges() const { return size_type(arrays_.coinciding_halfedges.size()); }
  /// returns the number of edges of the input.
  size_type number_of_input_edges() const { return size_type(arrays_.input_edges.size()); }
  /// @}

  /// \name Ranges
  /// @{
  /// returns all vertices: those of the surface, then the crossings.
  Range<Vertex> vertices() const { return range<Vertex>(0, number_of_vertices()); }
  /// returns the vertices that are crossings.
  Range<Vertex> crossings() const { return range<Vertex>(arrays_.number_of_original_vertices, number_of_vertices()); }
  /// returns all halfedges.
  Range<Halfedge> halfedges() const { return range<Halfedge>(0, number_of_halfedges()); }
  /// returns all segments.
  Range<Segment> segments() const { return range<Segment>(0, number_of_segments()); }
  /// returns all faces.
  Range<Face> faces() const { return range<Face>(0, number_of_faces()); }
  /// @}

  /// \name Navigation
  /// @{
  /// returns the other halfedge of the segment of `h`.
  Halfedge opposite(Halfedge h) const { return Halfedge(h.idx() ^ 1); }
  /// returns the segment of `h`.
  Segment segment(Halfedge h) const { return Segment(h.idx() >> 1); }
  /// returns halfedge `2s`.
  Halfedge halfedge(Segment s) const { return Halfedge(s.idx() << 1); }
  /// returns the halfedge after `h` around its face, or along the border.
  Halfedge next(Halfedge h) const { return Halfedge(arrays_.halfedges[h.idx()].next); }
  /// returns the vertex that `h` points to.
  Vertex target(Halfedge h) const { return Vertex(arrays_.halfedges[h.idx()].target); }
  /// returns the vertex that `h` comes from.
  Vertex source(Halfedge h) const { return target(opposite(h)); }
  /// returns the face to the left of `h`, or the null descriptor.
  Face face(Halfedge h) const { return Face(arrays_.halfedges[h.idx()].face); }
  /// returns whether `h` has no face.
  bool is_border(Halfedge h) const { return !face(h).is_valid(); }
  /// returns a halfedge that points to `v`; the null descriptor if `v` is isolated. If `v` is
  /// a crossing, it is part of an intrinsic edge and runs in the direction of its halfedge `2e`.
  Halfedge halfedge(Vertex v) const { return Halfedge(arrays_.vertex_halfedges[v.idx()]); }
  /// returns a halfedge of `f`.
  Halfedge halfedge(Face f) const { return Halfedge(arrays_.faces[f.idx()].halfedge); }
  /// @}

  /// \name Where things come from
  /// @{
  /// returns whether `v` is a crossing, not a vertex of the surface.
  bool is_crossing(Vertex v) const { return v.idx() >= arrays_.number_of_original_vertices; }
  /// returns whether `v` is an inserted vertex.
  bool is_inserted(Vertex v) const { return !is_crossing(v) && v.idx() >= arrays_.number_of_input_vertices; }
  /// returns the vertex of the surface that `v` is. \pre `!is_crossing(v)`
  Vertex_index original_vertex(Vertex v) const
  {
    CGAL_precondition(!is_crossing(v));
    return Vertex_index(v.idx());
  }
  /// returns which of the two triangulations `s` is part of.
  Segment_label label(Segment s) const
  {
    if (s.idx() >= arrays_.first_input_segment)
      return Segment_label::INPUT;
    return arrays_.coinciding_halfedges[arrays_.parents[s.idx()]] == arrays_.null ? Segment_label::INTRINSIC
                                                                                  : Segment_label::BOTH;
  }
  /// returns the halfedge of the intrinsic triangulation that contains `h`, with the same
  /// direction; the null descriptor if the label is `INPUT`.
  Halfedge_index intrinsic_halfedge(Halfedge h) const
  {
    if (segment(h).idx() >= arrays_.first_input_segment)
      return Halfedge_index();
    return Halfedge_index((arrays_.parents[segment(h).idx()] << 1) | (h.idx() & 1));
  }
  /// returns the halfedge of the input that contains `h`, with the same direction; the
  /// null descriptor if the label is `INTRINSIC`.
  Halfedge_index input_halfedge(Halfedge h) const { return Halfedge_index(arrays_.input_halfedge(h.idx())); }
  /// \brief returns a side of the input face that contains `face(h)`, on which `target(h)` lies.
  ///
  /// If `target(h)` is a vertex of the surface, this is the side that begins there,
  /// in the corner to the left of `h`, or the part of a side; the null descriptor if the vertex was inserted inside the
  /// face. Finding it takes one step for each intrinsic edge in that corner; otherwise O(1). \pre `!is_border(h)`
  Halfedge_index input_side(Halfedge h) const
  {
    return side(h, [this](Halfedge g) { return input_halfedge(g); });
  }
  /// \brief returns a side of the intrinsic face that contains `face(h)`, on which `target(h)`
  /// lies; as `input_side()`.
  Halfedge_index intrinsic_side(Halfedge h) const
  {
    return side(h, [this](Halfedge g) { return intrinsic_halfedge(g); });
  }
  /// returns the input face that contains `f`.
  Face_index input_face(Face f) const { return Face_index(arrays_.faces[f.idx()].input); }
  /// returns the intrinsic face that contains `f`.
  Face_index intrinsic_face(Face f) const { return Face_index(arrays_.faces[f.idx()].intrinsic); }
  /// @}

  /// \name Along an edge
  /// The crossings of an edge, and the inserted vertices on an input edge, are numbered from zero in the direction of
  /// its halfedge `2e`.
  /// @{

  /// returns the segments of intrinsic edge `e`, in order.
  Range<Segment> intrinsic_segments(Edge_index e) const
  {
    const size_type first = arrays_.first_segments[e.idx()];
    return range<Segment>(first, arrays_.intrinsic_segments_end(e.idx()));
  }
  /// returns the crossings of intrinsic edge `e`, in order.
  Range<Vertex> intrinsic_crossings(Edge_index e) const
  {
    const Range<Segment> segments = intrinsic_segments(e);
    const size_type first = arrays_.number_of_original_vertices + (*segments.begin()).idx() - e.idx();
    return range<Vertex>(first, first + size_type(segments.size()) - 1);
  }
  /// returns the number of segments of input edge `e`.
  size_type number_of_input_segments(Edge_index e) const { return arrays_.input_edges[e.idx()].count; }
  /// returns the part of input edge `e` with the given position, in the direction of `2e`.
  Halfedge input_part(Edge_index e, size_type position) const
  {
    const internal::Overlay_arrays::Input_edge& edge = arrays_.input_edges[e.idx()];
    CGAL_precondition(position < edge.count);
    return Halfedge(arrays_.input_part(edge, position));
  }
  /// returns the crossing of input edge `e`, or the inserted vertex on it, with the given position.
  Vertex input_crossing(Edge_index e, size_type position) const
  {
    CGAL_precondition(position + 1 < number_of_input_segments(e));
    return target(input_part(e, position));
  }
  /// @}

  /// \name At a crossing
  /// \pre `is_crossing(x)`
  /// @{

  /// returns the intrinsic edge that crosses at `x`.
  Edge_index intrinsic_edge(Vertex x) const { return Edge_index(arrays_.parents[segment(halfedge(x)).idx()]); }
  /// returns the position of `x` among the crossings of `intrinsic_edge(x)`.
  size_type intrinsic_position(Vertex x) const
  {
    return segment(halfedge(x)).idx() - arrays_.first_segments[intrinsic_edge(x).idx()];
  }
  /// returns the input halfedge that crosses halfedge `2e` of the intrinsic edge at `x`, from
  /// right to left.
  Halfedge_index crossing_input_halfedge(Vertex x) const { return input_halfedge(next(halfedge(x))); }
  /// returns the input edge that crosses at `x`.
  Edge_index input_edge(Vertex x) const { return Edge_index(crossing_input_halfedge(x).idx() >> 1); }
  /// returns the position of `x` among the crossings of `input_edge(x)` and the inserted vertices on it. O(1), or
  /// O(number of segments of the input edge) if there are such vertices.
  size_type input_position(Vertex x) const
  {
    const Halfedge out = next(halfedge(x));
    const size_type s = segment(out).idx(); // begins at x, or ends there
    const internal::Overlay_arrays::Input_edge& edge = arrays_.input_edges[arrays_.parents[s]];
    const size_type before = (out.idx() & 1) ? 0 : 1;
    if (!edge.is_split)
      return s - (edge.first >> 1) - before;
    size_type position = 0;
    while ((arrays_.input_part(edge, position) >> 1) != s)
      ++position;
    return position - before;
  }
  /// @}

private:
  template <class HalfedgeOf>
  Halfedge_index side(Halfedge h, const HalfedgeOf& halfedge_of) const
  {
    if (is_crossing(target(h)))
      return halfedge_of(h).is_valid() ? halfedge_of(h) : halfedge_of(next(h));
    const Halfedge first = next(h);
    for (Halfedge out = first;;) { // clockwise
      const Halfedge_index side = halfedge_of(out);
      out = next(opposite(out));
      if (side.is_valid() || out == first)
        return side;
    }
  }

  template <class Descriptor>
  static Range<Descriptor> range(size_type begin, size_type end)
  {
    using Iterator = Descriptor_iterator<Descriptor>;
    return make_range(Iterator(begin), Iterator(end));
  }

  internal::Overlay_arrays arrays_;
};

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns the overlay of a triangulation and its input.
///
/// O(size of the overlay), that is, O(size of the surface + number of crossings).
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the overlay
///   is the same, and the visitor is asked only a few times
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \pre `triangulation.keeps_input()`
/// \exception Integer_overflow_error if there are 2^31 segments or more
/// \exception Cancelled_error if the visitor asks for it
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Overlay make_overlay(const Intrinsic_triangulation<Traits>& triangulation,
                     const NamedParameters& np = parameters::default_values())
{
  return Overlay(triangulation.connectivity(), internal::engine<ConcurrencyTag>(triangulation).correspondence(),
                 internal::progress_function_of(np), internal::threads<ConcurrencyTag>());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_H

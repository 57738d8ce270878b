// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Where on their edges the crossings of an overlay lie.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_POSITIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_POSITIONS_H

#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Progress_function.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/config.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the positions of the crossings of an overlay along both of their edges, and of inserted vertices in the input.
///
/// A position is the fraction of the edge that lies before the crossing, in the direction of
/// halfedge `2e`. It is computed from the unfolding over the input triangles, by edge and never by
/// end vertices. Its relative error is at most 2^-52 unless it is below 2^-400. Along each
/// edge positions never decrease. 0 and 1 occur beside faces of zero area, and 1 where a position
/// is rounded to it.
///
/// Memory: 16 bytes a crossing, 32 an inserted vertex.
class Overlay_positions
{
public:
  /// \brief computes all positions.
  ///
  /// `Common_subdivision` does it for a triangulation.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the positions
  ///   are the same, and `progress` is called only at the beginning
  /// \param intrinsic the current connectivity
  /// \param geometry the exact geometry of the input
  /// \param overlay their overlay
  /// \param progress is called during the computation
  /// \pre `geometry.prepare()` was called
  /// \exception Undecided_error if an edge is not a straight line over the input triangles: an
  ///   inexact number type has flipped a hinge that is not convex
  /// \exception Cancelled_error if `progress` returns `false`
  ///
  /// O(size of the overlay) arithmetic operations.
  template <class ConcurrencyTag = Sequential_tag>
  Overlay_positions(const Delta_complex& intrinsic, const Exact_geometry& geometry,
                    const Overlay& overlay, const Progress_function& progress = {},
                    ConcurrencyTag = ConcurrencyTag())
    : number_of_input_vertices_(overlay.number_of_input_vertices()),
      number_of_original_vertices_(overlay.number_of_original_vertices()),
      on_intrinsic_edge_(overlay.number_of_crossings(), internal::default_init),
      on_input_edge_(overlay.number_of_crossings(), internal::default_init)
  {
    const internal::Standard_arithmetic arithmetic;
    static constexpr const char* what = "the search for the places of the crossings";
    const Delta_complex& input = geometry.correspondence().input();
    for (size_type v = input.number_of_vertices(); v < intrinsic.number_of_vertices(); ++v)
      locations_.push_back(normalized(input, geometry.correspondence().location(Vertex_index(v))));
    const std::size_t n = intrinsic.number_of_edges();
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
      internal::report_progress(progress, 0, what);
      internal::for_each_block<ConcurrencyTag>(n, internal::elements_of_block, [&](std::size_t first, std::size_t last) {
        find_crossings(intrinsic, geometry, overlay, first, last, internal::Loop_progress({}, what, 0, 1, n));
      });
    } else {
      find_crossings(intrinsic, geometry, overlay, 0, n, internal::Loop_progress(progress, what, 0, 1, n));
    }
    internal::for_each_block<ConcurrencyTag>(
      input.number_of_edges(), internal::elements_of_block,
      [&](std::size_t first, std::size_t last) {
        for (std::size_t e = first; e < last; ++e)
          make_ascending(overlay, Edge_index(size_type(e)));
      });
  }

  /// returns the position of the crossing `x` on `overlay.intrinsic_edge(x)`, from 0 to 1.
  double on_intrinsic_edge(Overlay::Vertex x) const { return on_intrinsic_edge_[index(x)]; }
  /// returns the position of the crossing `x` on `overlay.input_edge(x)`, from 0 to 1.
  double on_input_edge(Overlay::Vertex x) const { return on_input_edge_[index(x)]; }

  /// returns where an inserted vertex lies in the input; the coordinates sum to 1, up to rounding.
  /// \pre `overlay.is_inserted(v)`
  const Surface_point& location(Overlay::Vertex v) const { return locations_[v.idx() - number_of_input_vertices_]; }

  /// returns the position of the target of `h` on the halfedge `overlay.intrinsic_side(h)`, from 0 to 1.
  double on_intrinsic_side(const Overlay& overlay, Overlay::Halfedge h) const
  {
    return overlay.is_crossing(overlay.target(h))
             ? along(overlay.intrinsic_side(h), on_intrinsic_edge(overlay.target(h)))
             : 0;
  }
  /// returns the position of the target of `h` on the halfedge `overlay.input_side(h)`, from 0 to 1.
  /// \pre there is such a halfedge: the target was not inserted inside the face
  double on_input_side(const Overlay& overlay, Overlay::Halfedge h) const
  {
    const Overlay::Vertex v = overlay.target(h);
    return v.idx() < number_of_input_vertices_ ? 0 : along(overlay.input_side(h), on_its_input_edge(v));
  }

  /// returns the positions of source and target of `h` on the halfedge `overlay.input_halfedge(h)`, from 0 to 1.
  /// \pre `h` is part of an input edge
  std::pair<double, double> ends_on_input_halfedge(const Overlay& overlay, Overlay::Halfedge h) const
  {
    const Halfedge_index side = overlay.input_halfedge(h);
    const auto position = [&](Overlay::Vertex v, double at_vertex) {
      return v.idx() < number_of_input_vertices_ ? at_vertex : along(side, on_its_input_edge(v));
    };
    return {position(overlay.source(h), 0), position(overlay.target(h), 1)};
  }
  /// returns the positions of source and target of `h` on the halfedge `overlay.intrinsic_halfedge(h)`, from 0 to 1.
  /// \pre `h` is part of an intrinsic edge
  std::pair<double, double> ends_on_intrinsic_halfedge(const Overlay& overlay, Overlay::Halfedge h) const
  {
    const Halfedge_index side = overlay.intrinsic_halfedge(h);
    const auto position = [&](Overlay::Vertex v, double at_vertex) {
      return overlay.is_crossing(v) ? along(side, on_intrinsic_edge(v)) : at_vertex;
    };
    return {position(overlay.source(h), 0), position(overlay.target(h), 1)};
  }

  /// \brief returns the fraction of its edge that a segment covers: of its intrinsic edge, or of
  /// its input edge if the label is `INPUT`.
  ///
  /// Multiplied by the length of the edge, it gives the length of the segment, with an error of a few
  /// units in the last place of the length of the edge.
  double fraction(const Overlay& overlay, Overlay::Segment s) const
  {
    const Overlay::Halfedge h = overlay.halfedge(s);
    const auto [begin, end] = overlay.label(s) == Segment_label::INPUT ? ends_on_input_halfedge(overlay, h)
                                                                       : ends_on_intrinsic_halfedge(overlay, h);
    return end - begin;
  }

private:
  using size_type = Overlay::size_type;

  // Of the intrinsic edges from `first` to `last`.
  void find_crossings(const Delta_complex& intrinsic, const Exact_geometry& geometry, const Overlay& overlay,
                      std::size_t first, std::size_t last, const internal::Loop_progress& progress);

  void make_ascending(const Overlay& overlay, Edge_index input_edge)
  {
    const size_type n = overlay.number_of_input_segments(input_edge);
    if (n < 3)
      return;
    double last = 0;
    size_type first = 0; // the first crossing after the last inserted vertex
    for (size_type i = 0; i + 1 < n; ++i) {
      const Overlay::Vertex v = overlay.input_crossing(input_edge, i);
      if (overlay.is_crossing(v)) {
        double& position = on_input_edge_[index(v)];
        last = position = (std::max)(last, position);
        continue;
      }
      last = on_its_input_edge(v); // which is where it is
      for (; first < i; ++first) {
        double& position = on_input_edge_[index(overlay.input_crossing(input_edge, first))];
        position = (std::min)(last, position);
      }
      first = i + 1;
    }
  }

  // Of a crossing, or of a vertex that was inserted on an edge.
  double on_its_input_edge(Overlay::Vertex v) const
  {
    if (v.idx() >= number_of_original_vertices_)
      return on_input_edge(v);
    const Surface_point& p = location(v); // in the direction of its halfedge
    return along(p.halfedge, p.coordinates[1]);
  }

  // Of points on an edge, the third coordinate is zero.
  static Surface_point normalized(const Delta_complex& input, const Surface_point& point)
  {
    const Halfedge_index side = point.dimension() == 1 ? internal::side_of(input, point) : point.halfedge;
    Surface_point result{side, coordinates_from(input, point, side)};
    const double sum = result.coordinates[0] + result.coordinates[1] + result.coordinates[2];
    for (double& x : result.coordinates)
      x /= sum;
    return result;
  }

  size_type index(Overlay::Vertex x) const
  {
    CGAL_precondition(x.idx() >= number_of_original_vertices_);
    return x.idx() - number_of_original_vertices_;
  }

  static double along(Halfedge_index side, double position)
  {
    return (side.idx() & 1) ? 1 - position : position;
  }

  size_type number_of_input_vertices_;
  size_type number_of_original_vertices_;
  std::vector<Surface_point> locations_; // of inserted vertices
  Large_vector<double> on_intrinsic_edge_;
  Large_vector<double> on_input_edge_;
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/internal/positions/Overlay_positions_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_POSITIONS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay with a position for each of its vertices, on either surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the positions of the crossings of an overlay along both of their edges, and of inserted vertices in the
/// input.
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
  /// \cond SKIP_IN_MANUAL
  // Computes all positions, in O(size of the overlay) arithmetic operations. With threads, only the beginning is
  // reported. Throws Undecided_error if an edge is not a straight line over the input triangles, as an inexact
  // number type has flipped a hinge that is not convex, and Cancelled_error if the function asks for it.
  Overlay_positions(const internal::Exact_engine& engine, const Overlay& overlay,
                    const Progress_function& progress = {}, const internal::Block_runner& threads = {});
  /// \endcond

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
  std::pair<double, double> ends_on_input_halfedge(const Overlay& overlay, Overlay::Halfedge h) const;
  /// returns the positions of source and target of `h` on the halfedge `overlay.intrinsic_halfedge(h)`, from 0 to 1.
  /// \pre `h` is part of an intrinsic edge
  std::pair<double, double> ends_on_intrinsic_halfedge(const Overlay& overlay, Overlay::Halfedge h) const;

  /// \brief returns the fraction of its edge that a segment covers: of its intrinsic edge, or of
  /// its input edge if the label is `INPUT`.
  ///
  /// Multiplied by the length of the edge, it gives the length of the segment, with an error of a few
  /// units in the last place of the length of the edge.
  double fraction(const Overlay& overlay, Overlay::Segment s) const;

private:
  using size_type = Overlay::size_type;

  // Locates the crossings of the intrinsic edges from `first` to `last`.
  void find_crossings(const internal::Exact_engine& engine, const Overlay& overlay, std::size_t first, std::size_t last,
                      const internal::Loop_progress& progress);

  void make_ascending(const Overlay& overlay, Edge_index input_edge);

  // The position of a crossing, or of a vertex inserted on an edge.
  double on_its_input_edge(Overlay::Vertex v) const;

  // The third coordinate of points on an edge is zero.
  static Surface_point normalized(const Delta_complex& input, const Surface_point& point);

  size_type index(Overlay::Vertex x) const
  {
    CGAL_precondition(x.idx() >= number_of_original_vertices_);
    return x.idx() - number_of_original_vertices_;
  }

  static double along(Halfedge_index side, double position) { return (side.idx() & 1) ? 1 - position : position; }

  size_type number_of_input_vertices_;
  size_type number_of_original_vertices_;
  std::vector<Surface_point> locations_; // of inserted vertices
  Large_vector<double> on_intrinsic_edge_;
  Large_vector<double> on_input_edge_;
};

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the common subdivision of the input and the intrinsic triangulation: their overlay, the positions of its
/// crossings, and both triangulations.
///
/// All functions that transfer data or points between the two triangulations take this object. It does not refer to the
/// triangulation from which it was built: later flips do not change it. For the combinatorics alone, build an
/// `Overlay`.
///
/// Several threads may call const member functions at once.
///
/// Memory: an `Overlay`, `Overlay_positions`, the two connectivities and the integers.
class Common_subdivision
{
public:
  /// \brief builds the common subdivision of a triangulation and its input, as `make_common_subdivision()` without
  /// threads.
  template <class Traits, class NamedParameters = parameters::Default_named_parameters>
  explicit Common_subdivision(const Intrinsic_triangulation<Traits>& triangulation,
                              const NamedParameters& np = parameters::default_values())
    : Common_subdivision(internal::Released_engine{internal::engine<Sequential_tag>(triangulation), {}},
                         internal::progress_function_of(np))
  {}

  /// \brief as above, moving from the triangulation.
  template <class Traits, class NamedParameters = parameters::Default_named_parameters>
  explicit Common_subdivision(Intrinsic_triangulation<Traits>&& triangulation,
                              const NamedParameters& np = parameters::default_values())
    : Common_subdivision(internal::Engine_access::give_up(triangulation), internal::progress_function_of(np))
  {}

  /// \cond SKIP_IN_MANUAL
  Common_subdivision(internal::Released_engine released, const Progress_function& progress,
                     const internal::Block_runner& threads = {});
  /// \endcond

  /// returns the overlay.
  const Overlay& overlay() const { return overlay_; }
  /// returns the positions of the crossings.
  const Overlay_positions& positions() const { return positions_; }
  /// returns the input triangulation of the `Intrinsic_triangulation`.
  const Delta_complex& input() const { return engine_.correspondence().input(); }
  /// returns the intrinsic triangulation.
  const Delta_complex& intrinsic() const { return engine_.connectivity(); }

  /// \brief returns the point in space of a vertex of the overlay, on an input edge or inside an input face.
  ///
  /// \param v a vertex of the overlay
  /// \param points a random access range with the points of the vertices of the input, each with three coordinates
  ///   `p[i]`
  /// \return the coordinates, each within a few units in the last place of the largest one at the corners of the face
  template <class PointRange>
  std::array<double, 3> point(Overlay::Vertex v, const PointRange& points) const
  {
    if (overlay_.is_inserted(v))
      return point(positions_.location(v), points);
    if (!overlay_.is_crossing(v)) {
      const auto& p = points[v.idx()];
      return {to_double(p[0]), to_double(p[1]), to_double(p[2])};
    }
    const Halfedge_index h = input().halfedge(overlay_.input_edge(v));
    const auto &p = points[input().source(h).idx()], &q = points[input().target(h).idx()];
    const double t = positions_.on_input_edge(v);
    std::array<double, 3> result{};
    for (int i = 0; i < 3; ++i)
      result[i] = (1 - t) * to_double(p[i]) + t * to_double(q[i]);
    return result;
  }

  /// \brief returns the point in space of a point of the input.
  /// \param point the point; its coordinates sum to 1
  /// \param points as above
  template <class PointRange>
  std::array<double, 3> point(const Surface_point& point, const PointRange& points) const
  {
    return point_in_space(input(), points, point);
  }

  /// \cond SKIP_IN_MANUAL
  // The share of the graph in the reported progress: the positions take longer.
  static constexpr double part_of_graph = 0.3;
  /// \endcond

private:
  /// \cond SKIP_IN_MANUAL
  friend struct internal::Engine_access;
  /// \endcond

  Overlay build_overlay(const std::function<bool()>& go_further, const Progress_function& progress,
                        const internal::Block_runner& threads);

  internal::Exact_engine engine_;
  Overlay overlay_;
  Overlay_positions positions_;
};

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns the common subdivision of a triangulation and its input.
///
/// O(size of the overlay) arithmetic operations.
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the result is
///   the same, and the visitor is asked only a few times
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{reports progress, and can cancel}
/// \cgalNamedParamsEnd
///
/// \pre `triangulation.keeps_input()`
/// \exception Integer_overflow_error if there are 2^31 segments or more
/// \exception Undecided_error if an edge is not a straight line over the input triangles, as an inexact number type has
///   flipped a hinge that is not convex
/// \exception Cancelled_error if the visitor asks for it
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Common_subdivision make_common_subdivision(const Intrinsic_triangulation<Traits>& triangulation,
                                           const NamedParameters& np = parameters::default_values())
{
  return Common_subdivision(internal::Released_engine{internal::engine<ConcurrencyTag>(triangulation), {}},
                            internal::progress_function_of(np), internal::threads<ConcurrencyTag>());
}

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief as above, moving from the triangulation: nothing is copied, and its stored numbers are freed before the
/// overlay is built.
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Common_subdivision make_common_subdivision(Intrinsic_triangulation<Traits>&& triangulation,
                                           const NamedParameters& np = parameters::default_values())
{
  return Common_subdivision(internal::Engine_access::give_up(triangulation), internal::progress_function_of(np),
                            internal::threads<ConcurrencyTag>());
}

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief triangulates a convex polygon, such as a face of the overlay, so that its smallest triangle is as large as
/// possible.
/// \param corners the polygon, counterclockwise; three at least
/// \return three indices of corners for each triangle, counterclockwise. O(n³)
std::vector<std::array<std::size_t, 3>> triangulate_convex_polygon(const std::vector<std::array<double, 3>>& corners);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay of the input and an intrinsic triangulation, with all that belongs to it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Overlay_positions.h>
#include <CGAL/Intrinsic_triangulations/Progress_function.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/convex_polygon_triangulation.h>

#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOverlay
///
/// \brief the common subdivision of the input and the intrinsic triangulation: their overlay, the positions of its
/// crossings, and both triangulations.
///
/// Whatever transfers data or points between the two triangulations takes this one object. It does not refer to the
/// triangulation from which it was built: later flips do not change it. To look at the combinatorics alone, build an
/// `Overlay`.
///
/// All const member functions may be called by several threads at once.
///
/// Memory: that of an `Overlay`, of `Overlay_positions`, of the two connectivities and of the integers.
class Common_subdivision
{
public:
  /// \brief builds the common subdivision of a triangulation and its input.
  ///
  /// O(size of the overlay) arithmetic operations.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the result is the same,
  ///   and `progress` is called only a few times
  /// \pre `triangulation.keeps_input()`
  /// \exception Integer_overflow_error if there are 2^31 segments or more
  /// \exception Undecided_error as the constructor of `Overlay_positions`
  /// \exception Cancelled_error if `progress` returns `false`
  template <class Traits, class ConcurrencyTag = Sequential_tag>
  explicit Common_subdivision(const Intrinsic_triangulation<Traits>& triangulation,
                              const Progress_function& progress = {}, ConcurrencyTag = ConcurrencyTag())
    : Common_subdivision(triangulation.connectivity(), triangulation.template exact_geometry<ConcurrencyTag>(), progress, ConcurrencyTag())
  {}

  /// \brief as above, from the current connectivity and the exact geometry of the input.
  /// \tparam ConcurrencyTag as above
  template <class ConcurrencyTag = Sequential_tag>
  Common_subdivision(const Delta_complex& intrinsic, const Exact_geometry& geometry,
                     const Progress_function& progress = {}, ConcurrencyTag = ConcurrencyTag())
    : intrinsic_(intrinsic), geometry_(prepared<ConcurrencyTag>(geometry, intrinsic)),
      overlay_(intrinsic, geometry.correspondence(), internal::part_of_progress(progress, 0, part_of_graph), ConcurrencyTag()),
      positions_(intrinsic, geometry, overlay_, internal::part_of_progress(progress, part_of_graph, 1), ConcurrencyTag())
  {}

  /// \brief as above, from a triangulation that is given up: nothing of it is copied, and its stored numbers are freed before the
  /// overlay is built.
  /// \tparam ConcurrencyTag as above
  template <class Traits, class ConcurrencyTag = Sequential_tag>
  explicit Common_subdivision(Intrinsic_triangulation<Traits>&& triangulation,
                              const Progress_function& progress = {}, ConcurrencyTag = ConcurrencyTag())
    : Common_subdivision(Parts(std::move(triangulation)), progress, ConcurrencyTag())
  {}

  /// returns the overlay.
  const Overlay& overlay() const { return overlay_; }
  /// returns the positions of the crossings.
  const Overlay_positions& positions() const { return positions_; }
  /// returns the input triangulation: `Correspondence::input()`.
  const Delta_complex& input() const { return geometry_.correspondence().input(); }
  /// returns the intrinsic triangulation.
  const Delta_complex& intrinsic() const { return intrinsic_; }

  /// returns the exact geometry of the input, for queries about `intrinsic()`.
  const Exact_geometry& exact_geometry() const { return geometry_; }

  /// \brief returns the point in space of a vertex of the overlay, on an input edge or inside an input face.
  ///
  /// \param v a vertex of the overlay
  /// \param points a random access range with the points of the vertices of the input, each with three coordinates `p[i]`
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
    std::array<double, 3> result{};
    Halfedge_index h = point.halfedge;
    for (double weight : point.coordinates) {
      const auto& p = points[input().source(h).idx()];
      for (int i = 0; i < 3; ++i)
        result[i] += weight * to_double(p[i]);
      h = input().next(h);
    }
    return result;
  }

  /// \cond SKIP_IN_MANUAL
  // Of the progress that is reported: the positions take longer than the graph.
  static constexpr double part_of_graph = 0.3;
  /// \endcond

private:
  // What is left of a triangulation that is given up.
  struct Parts
  {
    template <class Traits>
    explicit Parts(Intrinsic_triangulation<Traits>&& triangulation)
      : go_further(triangulation.set_interruption({})), released(std::move(triangulation).release())
    {}
    std::function<bool()> go_further;
    std::pair<Delta_complex, Exact_geometry> released;
  };

  template <class ConcurrencyTag>
  Common_subdivision(Parts parts, const Progress_function& progress, ConcurrencyTag)
    : intrinsic_(std::move(parts.released.first)), geometry_(std::move(parts.released.second)),
      overlay_(intrinsic_, prepared<ConcurrencyTag>(geometry_, intrinsic_, parts.go_further).correspondence(),
               internal::part_of_progress(progress, 0, part_of_graph), ConcurrencyTag()),
      positions_(intrinsic_, geometry_, overlay_, internal::part_of_progress(progress, part_of_graph, 1), ConcurrencyTag())
  {
    geometry_.set_interruption({});
  }

  template <class ConcurrencyTag>
  static const Exact_geometry& prepared(const Exact_geometry& geometry, const Delta_complex& intrinsic)
  {
    geometry.prepare<ConcurrencyTag>(intrinsic);
    return geometry;
  }
  template <class ConcurrencyTag>
  static const Exact_geometry& prepared(Exact_geometry& geometry, const Delta_complex& intrinsic, const std::function<bool()>& go_further)
  {
    geometry.set_interruption(go_further);
    return prepared<ConcurrencyTag>(geometry, intrinsic);
  }

  Delta_complex intrinsic_;
  Exact_geometry geometry_;
  Overlay overlay_;
  Overlay_positions positions_;
};

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns the triangles of a convex polygon, such as a face of the overlay, so that the smallest has the largest area.
/// \param corners the polygon, counterclockwise; three at least
/// \return three indices of corners for each triangle, counterclockwise. O(n³)
inline std::vector<std::array<std::size_t, 3>> triangulate_convex_polygon(const std::vector<std::array<double, 3>>& corners)
{
  std::vector<std::array<std::size_t, 3>> result;
  internal::Convex_polygon_triangulation(corners).for_each_triangle(
    [&](std::size_t a, std::size_t b, std::size_t c) { result.push_back({a, b, c}); });
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_COMMON_SUBDIVISION_H

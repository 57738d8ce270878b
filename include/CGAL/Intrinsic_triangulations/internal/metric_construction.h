// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From points or lengths to the traits' data of edges and faces, with the checks that
// an input needs to be a metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_METRIC_CONSTRUCTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_METRIC_CONSTRUCTION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/check_triangles.h>
#include <CGAL/Intrinsic_triangulations/internal/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/unit_of_length.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/atomic/atomic_ref.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Whether a vertex has a face.
struct Is_used_vertex
{
  const Delta_complex& complex;
  bool operator()(std::size_t v) const { return complex.halfedge(Vertex_index(std::uint32_t(v))).is_valid(); }
};

// For an edge that a flip has made.
[[noreturn]] inline void throw_no_length(const Delta_complex& complex, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e);
  const std::string source = std::to_string(complex.source(h).idx()),
                    target = std::to_string(complex.target(h).idx());
  throw Invalid_surface_error(Defect::ZERO_LENGTH_EDGE, complex.source(h).idx(), 1,
                              complex.is_loop(e) ? "a loop at vertex " + source +
                                                     " has length zero: the lengths leave no room there"
                                                 : "vertices " + source + " and " + target +
                                                     " coincide on the surface, though no edge joins them; "
                                                     "merge them first");
}

// Names the first edge whose squared length is zero.
template <class PointVector>
[[noreturn]] void throw_zero_length(const Delta_complex& complex, const PointVector& points,
                                    const Offenders& offenders)
{
  const Halfedge_index h = complex.halfedge(Edge_index(std::uint32_t(offenders.first)));
  const std::size_t v = complex.source(h).idx(), w = complex.target(h).idx();
  const bool is_coincident = certainly(points[v][0] == points[w][0]) &&
                             certainly(points[v][1] == points[w][1]) &&
                             certainly(points[v][2] == points[w][2]);
  throw Invalid_surface_error(
    is_coincident ? Defect::ZERO_LENGTH_EDGE : Defect::OUT_OF_RANGE, offenders.first,
    offenders.count,
    "edge " + std::to_string(offenders.first) + " joins vertices " + std::to_string(v) + " and " +
      std::to_string(w) +
      (is_coincident ? ", which coincide: merge them first"
                     : ", whose squared distance underflows beside the size of the surface") +
      offenders.and_more());
}

// Bounds the corners of the face of h, whose sides from h on are given.
template <class Traits>
void bound_corners(const Traits& traits, Halfedge_index h, Halfedge_index next, Halfedge_index prev,
                   const typename Traits::Face_data& face, const typename Traits::Edge_data& side,
                   const typename Traits::Edge_data& next_side,
                   const typename Traits::Edge_data& prev_side, Cotangent_bounds& bounds)
{
  if constexpr (Has_cotangent_bounds<Traits>::value) {
    const std::array<float, 3> bound =
      traits.compute_cotangent_bounds_object()(face, side, next_side, prev_side);
    bounds.set(h, bound[0]);
    bounds.set(next, bound[1]);
    bounds.set(prev, bound[2]);
  }
}

// Bounds the corners of the two faces that a flip has made.
template <class Traits>
void bound_corners_of_flipped(const Traits& traits, const Hinge_halfedges& around,
                              const typename Traits::Hinge_data& old,
                              const typename Traits::Flipped_hinge_data& flipped, Cotangent_bounds& bounds)
{
  const auto& [ij, jk, ki, ji, il, lj] = around;
  if constexpr (Takes_two_faces<Traits>::value) {
    const auto bound = traits.compute_cotangent_bounds_object().of_two(
      flipped.ilk, flipped.jkl, Two_doubles(flipped.kl), Two_doubles(old.ki, old.lj),
      Two_doubles(old.il, old.jk));
    bounds.set(ij, ji, bound[0]);
    bounds.set(ki, lj, bound[1]);
    bounds.set(il, jk, bound[2]);
  } else {
    bound_corners(traits, ij, ki, il, flipped.ilk, flipped.kl, old.ki, old.il, bounds);
    bound_corners(traits, ji, lj, jk, flipped.jkl, flipped.kl, old.lj, old.jk, bounds);
  }
}

// Two threads may store the same number for an edge, each for one of its faces.
template <class ConcurrencyTag, class T>
void store(T& to, const T& value)
{
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    boost::atomic_ref<T>(to).store(value, boost::memory_order_relaxed);
  else
    to = value;
}

// The halfedges of a face.
struct Sides
{
  Sides(const Delta_complex& complex, std::size_t f)
    : h(complex.halfedge(Face_index(std::uint32_t(f)))), next(complex.next(h)), prev(complex.prev(h))
  {}
  // Zero for a triangle, and for a face of one side, whose length is zero.
  std::uint32_t is_other_face(const Delta_complex& complex) const
  {
    return complex.next(next).idx() ^ prev.idx();
  }
  Halfedge_index h, next, prev;
};

// All that is computed from the corners of a face is computed while they are at hand: an
// edge twice, which takes less time than to fetch its ends once more. Where the traits can,
// two faces are computed at once.
template <class ConcurrencyTag, class Traits, class PointVector, class EdgeVector, class FaceVector>
void construct_metric_from_points(const Delta_complex& complex, const Traits& traits,
                                  const PointVector& points, EdgeVector& edges,
                                  FaceVector& faces, Cotangent_bounds& bounds)
{
  CGAL_precondition(points.size() == complex.number_of_vertices());
  using FT = typename Traits::FT;
  using Edge_data = typename Traits::Edge_data;
  using Point_data = typename Traits::Point_data;
  using Tag = std::conditional_t<is_for_threads<Edge_data>, ConcurrencyTag, Sequential_tag>;
  const auto construct_edge_data = traits.construct_edge_data_object();
  const auto construct_face_data = traits.construct_face_data_object();
  const auto compute_squared_length = traits.compute_squared_length_object();
  const auto is_zero = [&](const Edge_data& e) { // 0 or 1, to be combined without a branch
    return int(!possibly(compute_squared_length(e) > FT(0)));
  };
  std::atomic<bool> is_to_be_refused{false};

  for_each_block<Tag>(faces.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
    const Point_data* const point = points.data();
    auto* const edge = edges.data();
    // Coordinate by coordinate, so that they are kept in registers.
    const auto corner = [&](Halfedge_index h) -> Point_data {
      const Point_data& p = point[complex.target(h).idx()];
      return {p[0], p[1], p[2]};
    };
    int has_zero = 0;
    std::uint32_t has_other_faces = 0;
    auto* face = faces.data() + first;
    std::size_t f = first;
    if constexpr (Takes_two_faces<Traits>::value) {
      const auto two_corners = [&](Halfedge_index h, Halfedge_index g) -> Two_points {
        const Point_data &p = point[complex.target(h).idx()], &q = point[complex.target(g).idx()];
        return {Two_doubles(p[0], q[0]), Two_doubles(p[1], q[1]), Two_doubles(p[2], q[2])};
      };
      const auto store_two = [&](Halfedge_index h, Halfedge_index g, const Two_doubles& s) {
        store<Tag>(edge[complex.edge(h).idx()], s.first());
        store<Tag>(edge[complex.edge(g).idx()], s.second());
      };
      Two_doubles shortest = std::numeric_limits<double>::infinity();
      for (; f + 1 < last; f += 2, face += 2) {
        const Sides one(complex, f), two(complex, f + 1);
        has_other_faces |= one.is_other_face(complex) | two.is_other_face(complex);
        const Two_points p = two_corners(one.prev, two.prev), q = two_corners(one.h, two.h),
                         r = two_corners(one.next, two.next);
        const Two_doubles pq = construct_edge_data.of_two(p, q), qr = construct_edge_data.of_two(q, r),
                          pr = construct_edge_data.of_two(p, r);
        store_two(one.h, two.h, pq);
        store_two(one.next, two.next, qr);
        store_two(one.prev, two.prev, pr);
        shortest = min_of(min_of(pq, qr), min_of(pr, shortest));
        const auto areas = construct_face_data.of_two(p, q, r);
        face[0] = areas.first();
        face[1] = areas.second();
        const auto of_corners = traits.compute_cotangent_bounds_object().of_two(areas, pq, qr, pr);
        bounds.set(one.h, two.h, of_corners[0]);
        bounds.set(one.next, two.next, of_corners[1]);
        bounds.set(one.prev, two.prev, of_corners[2]);
      }
      has_zero = int(!(shortest.first() > 0 && shortest.second() > 0));
    }
    for (; f < last; ++f, ++face) {
      const Sides sides(complex, f);
      const auto [h, next, prev] = sides;
      has_other_faces |= sides.is_other_face(complex);
      const Point_data p = corner(prev), q = corner(h), r = corner(next);
      const Edge_data pq = construct_edge_data(p, q), qr = construct_edge_data(q, r),
                      pr = construct_edge_data(p, r);
      store<Tag>(edge[complex.edge(h).idx()], pq);
      store<Tag>(edge[complex.edge(next).idx()], qr);
      store<Tag>(edge[complex.edge(prev).idx()], pr);
      has_zero |= is_zero(pq) | is_zero(qr) | is_zero(pr);
      *face = construct_face_data(p, q, r);
      bound_corners(traits, h, next, prev, *face, pq, qr, pr, bounds);
    }
    if (has_zero != 0 || has_other_faces != 0)
      is_to_be_refused = true;
  });
  if (is_to_be_refused) {
    check_triangles(complex);
    Offenders offenders;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (is_zero(edges[e]) != 0)
        offenders.add(e);
    throw_zero_length(complex, points, offenders);
  }
}

template <class Traits, class EdgeVector, class FaceVector>
void construct_metric_from_lengths(const Delta_complex& complex, const Traits& traits,
                                   const std::vector<typename Traits::FT>& lengths,
                                   EdgeVector& edges, FaceVector& faces,
                                   Cotangent_bounds& bounds)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  using FT = typename Traits::FT;
  const auto construct_edge_data = traits.construct_edge_data_object();
  const auto construct_face_data = traits.construct_face_data_object();
  const auto compute_squared_length = traits.compute_squared_length_object();

  Offenders offenders;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    edges[e] = construct_edge_data.from_length(lengths[e]);
    if (!possibly(compute_squared_length(edges[e]) > FT(0)))
      offenders.add(e);
  }
  throw_if_underflow("the squared length of edge ", offenders);

  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f), next = complex.next(h), prev = complex.prev(h);
    const FT &ij = lengths[complex.edge(h).idx()], &jk = lengths[complex.edge(next).idx()],
             &ki = lengths[complex.edge(prev).idx()];
    if (violate_triangle_inequality(ij, jk, ki))
      offenders.add(f.idx());
    faces[f.idx()] = construct_face_data.from_lengths(ij, jk, ki);
    bound_corners(traits, h, next, prev, faces[f.idx()], edges[complex.edge(h).idx()],
                  edges[complex.edge(next).idx()], edges[complex.edge(prev).idx()], bounds);
  }
  if (offenders.count > 0)
    throw Invalid_surface_error(Defect::TRIANGLE_INEQUALITY, offenders.first, offenders.count,
                                "the lengths of face " + std::to_string(offenders.first) +
                                  " violate the triangle inequality" + offenders.and_more());
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_METRIC_CONSTRUCTION_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From points or lengths to the traits' data of edges and faces, with checks that the input is a metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_CONSTRUCTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_CONSTRUCTION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a vertex has a face.
struct Is_used_vertex
{
  const Delta_complex& complex;
  bool operator()(std::size_t v) const { return complex.halfedge(Vertex_index(std::uint32_t(v))).is_valid(); }
};

// Whether the traits' functors take two edges or faces at once.
template <class Traits, class = void>
struct Takes_two_faces : std::false_type
{};
template <class Traits>
struct Takes_two_faces<
  Traits,
  std::void_t<decltype(std::declval<Traits>().compute_cotangent_bounds_object()(
    std::declval<Traits>().construct_face_data_object()(Two_points(), Two_points(), Two_points()),
    std::declval<Traits>().construct_edge_data_object()(Two_points(), Two_points()), Two_doubles(), Two_doubles()))>>
  : std::true_type
{};

// Whether lengths have to obey the triangle inequality. They do, unless the traits say otherwise.
template <class Traits, class = void>
struct Has_Euclidean_faces : std::true_type
{};
template <class Traits>
struct Has_Euclidean_faces<Traits, std::void_t<typename Traits::Has_Euclidean_faces>>
  : std::bool_constant<Traits::Has_Euclidean_faces::value>
{};

// Bounds the corners of the face of h, given its sides from h on.
template <class Traits>
void bound_corners(const Traits& traits, Halfedge_index h, Halfedge_index next, Halfedge_index prev,
                   const typename Traits::Face_data& face, const typename Traits::Edge_data& side,
                   const typename Traits::Edge_data& next_side, const typename Traits::Edge_data& prev_side,
                   Cotangent_bounds& bounds)
{
  if constexpr (Has_cotangent_bounds<Traits>::value) {
    const std::array<float, 3> bound = traits.compute_cotangent_bounds_object()(face, side, next_side, prev_side);
    bounds.set(h, bound[0]);
    bounds.set(next, bound[1]);
    bounds.set(prev, bound[2]);
  }
}

// Bounds the corners of the two faces made by a flip.
template <class Traits>
void bound_corners_of_flipped(const Traits& traits, const Hinge_halfedges& around,
                              const typename Traits::Hinge_data& old,
                              const typename Traits::Flipped_hinge_data& flipped, Cotangent_bounds& bounds)
{
  const auto& [ij, jk, ki, ji, il, lj] = around;
  if constexpr (Takes_two_faces<Traits>::value) {
    const auto bound = traits.compute_cotangent_bounds_object()(
      two(flipped.ilk, flipped.jkl), Two_doubles(flipped.kl), Two_doubles(old.ki, old.lj), Two_doubles(old.il, old.jk));
    bounds.set(ij, ji, bound[0]);
    bounds.set(ki, lj, bound[1]);
    bounds.set(il, jk, bound[2]);
  } else {
    bound_corners(traits, ij, ki, il, flipped.ilk, flipped.kl, old.ki, old.il, bounds);
    bound_corners(traits, ji, lj, jk, flipped.jkl, flipped.kl, old.lj, old.jk, bounds);
  }
}

// A face and its halfedges.
struct Face_halfedges
{
  Face_halfedges(const Delta_complex& complex, Face_index f) : Face_halfedges(complex, f, complex.halfedge(f)) {}
  Face_halfedges(const Delta_complex& complex, Halfedge_index h) : Face_halfedges(complex, complex.face(h), h) {}
  Face_halfedges(const Delta_complex& complex, Face_index f, Halfedge_index h)
    : face(f), h(h), next(complex.next(h)), prev(complex.prev(h))
  {}
  // Zero for a triangle, and for a face of one side, whose length is zero.
  std::uint32_t is_other_face(const Delta_complex& complex) const { return complex.next(next).idx() ^ prev.idx(); }
  Face_index face;
  Halfedge_index h, next, prev;
};

// Computes the data of a face and its sides from its corners.
//
// Everything is computed while the corners are at hand. This measures each edge twice, which is faster than fetching
// its ends again.
template <class ConcurrencyTag, class Traits>
class Face_measurer
{
  using FT = typename Traits::FT;
  using Edge_data = typename Traits::Edge_data;
  using Face_data = typename Traits::Face_data;
  using Point_data = typename Traits::Point_data;

public:
  template <class PointVector, class EdgeVector, class FaceVector>
  Face_measurer(const Delta_complex& complex, const Traits& traits, const PointVector& points, EdgeVector& edges,
                FaceVector& faces, Cotangent_bounds& bounds)
    : complex_(complex), traits_(traits), points_(points.data()), edges_(edges.data()), faces_(faces.data()),
      bounds_(bounds)
  {}

  // Not zero if a side has length zero: numbers can be combined without a branch.
  int is_zero(const Edge_data& e) const { return int(!possibly(traits_.compute_squared_length_object()(e) > FT(0))); }

  // Findings about the measured faces.
  struct Findings
  {
    int has_zero = 0;                  // a side has length zero
    std::uint32_t has_other_faces = 0; // more or fewer than three sides
    Two_doubles shortest = std::numeric_limits<double>::infinity();

    bool are_fine() const
    {
      return has_zero == 0 && has_other_faces == 0 && shortest.first() > 0 && shortest.second() > 0;
    }
  };

  void measure(std::size_t first, std::size_t end, Findings& findings) const;

  // Returns whether a side has length zero, as is_zero() does.
  int measure(const Face_halfedges& sides) const
  {
    const auto edge = traits_.construct_edge_data_object();
    const Point_data p = corner(sides.prev), q = corner(sides.h), r = corner(sides.next);
    const Edge_data pq = edge(p, q), qr = edge(q, r), pr = edge(p, r);
    store(sides.h, pq);
    store(sides.next, qr);
    store(sides.prev, pr);
    const Face_data face = traits_.construct_face_data_object()(p, q, r);
    faces_[sides.face.idx()] = face;
    bound_corners(traits_, sides.h, sides.next, sides.prev, face, pq, qr, pr, bounds_);
    return is_zero(pq) | is_zero(qr) | is_zero(pr);
  }

  // Returns the smallest squared length of either face. Inlined by force: GCC would call it from the loop that is
  // compiled once.
  BOOST_FORCEINLINE Two_doubles measure(const Face_halfedges& one, const Face_halfedges& two) const
  {
    const auto edge = traits_.construct_edge_data_object();
    const Two_points p = corners(one.prev, two.prev), q = corners(one.h, two.h), r = corners(one.next, two.next);
    const Two_doubles pq = edge(p, q), qr = edge(q, r), pr = edge(p, r);
    store(one.h, two.h, pq);
    store(one.next, two.next, qr);
    store(one.prev, two.prev, pr);
    const auto areas = traits_.construct_face_data_object()(p, q, r);
    faces_[one.face.idx()] = areas.first();
    faces_[two.face.idx()] = areas.second();
    const auto bounds = traits_.compute_cotangent_bounds_object()(areas, pq, qr, pr);
    bounds_.set(one.h, two.h, bounds[0]);
    bounds_.set(one.next, two.next, bounds[1]);
    bounds_.set(one.prev, two.prev, bounds[2]);
    return min_of(min_of(pq, qr), pr);
  }

private:
  // Coordinate by coordinate, to keep them in registers.
  Point_data corner(Halfedge_index h) const
  {
    const Point_data& p = points_[complex_.target(h).idx()];
    return {p[0], p[1], p[2]};
  }
  Two_points corners(Halfedge_index h, Halfedge_index g) const
  {
    const Point_data &p = points_[complex_.target(h).idx()], &q = points_[complex_.target(g).idx()];
    return {Two_doubles(p[0], q[0]), Two_doubles(p[1], q[1]), Two_doubles(p[2], q[2])};
  }

  // Two threads may store the same number for an edge, each for one of its faces.
  void store(Halfedge_index h, const Edge_data& e) const
  {
    Edge_data& to = edges_[complex_.edge(h).idx()];
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
      relaxed_store(to, e);
    else
      to = e;
  }
  void store(Halfedge_index h, Halfedge_index g, const Two_doubles& two) const
  {
    store(h, two.first());
    store(g, two.second());
  }

  const Delta_complex& complex_;
  const Traits& traits_;
  const Point_data* points_;
  Edge_data* edges_;
  Face_data* faces_;
  Cotangent_bounds& bounds_;
};

// Not in the class, so that it can be compiled once for the default traits.
template <class ConcurrencyTag, class Traits>
void Face_measurer<ConcurrencyTag, Traits>::measure(std::size_t first, std::size_t end, Findings& findings) const
{
  const Face_measurer measurer = *this; // in registers
  Findings found = findings;
  const auto sides = [&](std::size_t f) { return Face_halfedges(measurer.complex_, Face_index(std::uint32_t(f))); };
  std::size_t f = first;
  if constexpr (Takes_two_faces<Traits>::value)
    for (; f + 1 < end; f += 2) {
      const Face_halfedges one = sides(f), two = sides(f + 1);
      found.has_other_faces |= one.is_other_face(measurer.complex_) | two.is_other_face(measurer.complex_);
      found.shortest = min_of(measurer.measure(one, two), found.shortest);
    }
  for (; f < end; ++f) {
    found.has_other_faces |= sides(f).is_other_face(measurer.complex_);
    found.has_zero |= measurer.measure(sides(f));
  }
  findings = found;
}

// Plays the role of a `Face_graph_copier` in construct_metric_from_points(), for a complex that is complete.
struct Null_copier
{
  void copy_faces(std::size_t, std::size_t) const {}
  void finish() const {}
};

// The copier supplies the faces, a few at a time.
template <class ConcurrencyTag, class Traits, class Copier, class PointVector, class EdgeVector, class FaceVector>
void construct_metric_from_points(const Delta_complex& complex, Copier& copier, const Traits& traits,
                                  const PointVector& points, EdgeVector& edges, FaceVector& faces,
                                  Cotangent_bounds& bounds)
{
  CGAL_precondition(points.size() == complex.number_of_vertices());
  constexpr std::size_t faces_at_a_time = 16;
  using Tag = std::conditional_t<is_for_threads<typename Traits::Edge_data>, ConcurrencyTag, Sequential_tag>;
  const Face_measurer<Tag, Traits> faces_and_sides(complex, traits, points, edges, faces, bounds);
  std::atomic<bool> is_to_be_refused{false};

  for_each_block<Tag>(faces.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
    typename Face_measurer<Tag, Traits>::Findings findings;
    for (std::size_t f = first; f < last; f += faces_at_a_time) {
      const std::size_t end = (std::min)(f + faces_at_a_time, last);
      copier.copy_faces(f, end);
      faces_and_sides.measure(f, end, findings);
    }
    if (!findings.are_fine())
      is_to_be_refused = true;
  });
  copier.finish();
  if (is_to_be_refused) {
    check_triangles(complex);
    Defect_tally offenders;
    for (std::size_t e = 0; e < edges.size(); ++e)
      if (faces_and_sides.is_zero(edges[e]) != 0)
        offenders.add(e);
    const Halfedge_index h = complex.halfedge(Edge_index(std::uint32_t(offenders.first)));
    const auto &p = points[complex.source(h).idx()], &q = points[complex.target(h).idx()];
    throw_zero_length(complex, offenders,
                      certainly(p[0] == q[0]) && certainly(p[1] == q[1]) && certainly(p[2] == q[2]));
  }
}

template <class Traits, class EdgeVector, class FaceVector>
void construct_metric_from_lengths(const Delta_complex& complex, const Traits& traits,
                                   const std::vector<typename Traits::FT>& lengths, EdgeVector& edges,
                                   FaceVector& faces)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  using FT = typename Traits::FT;
  const auto construct_edge_data = traits.construct_edge_data_object();
  const auto construct_face_data = traits.construct_face_data_object();
  const auto compute_squared_length = traits.compute_squared_length_object();

  Defect_tally offenders;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    edges[e] = construct_edge_data.from_length(lengths[e]);
    if (!possibly(compute_squared_length(edges[e]) > FT(0)))
      offenders.add(e);
  }
  offenders.refuse_underflow("the squared length of edge ");

  for (Face_index f : complex.faces()) {
    const Face_halfedges sides(complex, f);
    const FT &ij = lengths[complex.edge(sides.h).idx()], &jk = lengths[complex.edge(sides.next).idx()],
             &ki = lengths[complex.edge(sides.prev).idx()];
    if constexpr (Has_Euclidean_faces<Traits>::value)
      if (violate_triangle_inequality(ij, jk, ki))
        offenders.add(f.idx());
    faces[f.idx()] = construct_face_data.from_lengths(ij, jk, ki);
  }
  offenders.refuse(Defect::TRIANGLE_INEQUALITY, "the lengths of face ", " violate the triangle inequality");
}

// For traits with exact geometry, from the exact metric.
template <class Traits, class InputMetric, class EdgeVector, class FaceVector>
void construct_metric_from_input(const Delta_complex& complex, const Traits& traits, const InputMetric& metric,
                                 EdgeVector& edges, FaceVector& faces)
{
  const auto refined = traits.construct_refined_data_object();
  for (Edge_index e : complex.edges())
    edges[e.idx()] = refined(metric.squared_length_double_double(complex, e));
  const auto squared_length = [&](Halfedge_index h) {
    return metric.squared_length_double_double(complex, complex.edge(h));
  };
  for (Face_index f : complex.faces()) {
    const Face_halfedges sides(complex, f);
    faces[f.idx()] = refined(metric.four_areas_double_double(complex, f), squared_length(sides.h),
                             squared_length(sides.next), squared_length(sides.prev));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_CONSTRUCTION_H

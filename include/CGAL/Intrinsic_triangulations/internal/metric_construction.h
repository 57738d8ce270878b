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

using Defect = Invalid_surface_error::Defect;

// The number type whose exponent range FT has, or FT itself.
template <class FT>
struct Machine_type
{
  using type = FT;
};
template <bool b>
struct Machine_type<Interval_nt<b>>
{
  using type = double;
};

template <class FT>
constexpr bool has_small_exponent_range = std::is_floating_point<typename Machine_type<FT>::type>::value;

// Roots of numbers beyond 2^150 come out of CORE with few correct digits, and beyond 2^160 it ends
// the process with a division by zero. Small numbers do it no harm before 2^-1075, below which it
// takes them for zero where they become `double`.
template <class FT>
constexpr bool has_exact_roots =
  std::is_convertible<typename Algebraic_structure_traits<FT>::Is_exact, Tag_true>::value&&
    std::is_convertible<typename Algebraic_structure_traits<FT>::Algebraic_category, Field_with_sqrt_tag>::value;

// Products of two squared lengths occur, and differences of such products matter down to
// their rounding: lengths between 2^-(a tenth of the largest exponent) and 2^(the same) stay far
// from over- and underflow. Where the largest is not one of them it is made the largest of them,
// so that what is small beside it keeps all its bits if it can.
template <class FT>
int unit_exponent(double largest)
{
  if constexpr (has_small_exponent_range<FT>) {
    const int limit = std::numeric_limits<typename Machine_type<FT>::type>::max_exponent / 10;
    const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
    return exponent > limit || exponent < -limit ? exponent - limit : 0;
  } else if constexpr (has_exact_roots<FT>) {
    constexpr int limit = 16;
    const int exponent = largest > 0 ? std::ilogb(largest) + 1 : 0;
    return exponent > limit || exponent < -limit ? exponent : 0;
  } else {
    return 0;
  }
}

template <class FT>
FT times_power_of_two(const FT& x, int exponent)
{
  if constexpr (std::is_floating_point<FT>::value)
    return std::ldexp(x, exponent);
  else if constexpr (has_small_exponent_range<FT>)
    return FT(std::ldexp(x.inf(), exponent), std::ldexp(x.sup(), exponent));
  else if constexpr (has_exact_roots<FT>) {
    FT result = x;
    for (int rest = exponent; rest != 0;) {
      const int step = (std::max)(-1000, (std::min)(1000, rest));
      result = result * FT(std::ldexp(1., step));
      rest -= step;
    }
    return result;
  } else
    return x;
}

template <class FT>
double magnitude(const FT& x)
{
  if constexpr (std::is_floating_point<FT>::value)
    return std::abs(double(x));
  else {
    const std::pair<double, double> range = CGAL::to_interval(x);
    return (std::max)(std::abs(range.first), std::abs(range.second));
  }
}

// Counts the offending elements and keeps the first.
struct Offenders
{
  void add(std::size_t element)
  {
    first = count == 0 ? element : first;
    ++count;
  }
  std::string and_more() const
  {
    return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : std::string();
  }
  std::size_t first = 0;
  std::size_t count = 0;
};

// Multiplies by a power of two, and returns whether that was exact.
template <class FT>
bool scale(FT& x, int exponent)
{
  if constexpr (has_exact_roots<FT>) {
    // A `double` stays one if it can: what else an exact number is made of makes it slower.
    const double rounded = CGAL::to_double(x), scaled = std::ldexp(rounded, exponent);
    if (std::ldexp(scaled, -exponent) == rounded && FT(rounded) == x)
      x = FT(scaled);
    else
      x = times_power_of_two(x, exponent);
    return true;
  }
  const FT scaled = times_power_of_two(x, exponent);
  const FT back = times_power_of_two(scaled, -exponent);
  bool is_exact;
  if constexpr (std::is_floating_point<FT>::value || !has_small_exponent_range<FT>)
    is_exact = back == x;
  else
    is_exact = back.is_same(x);
  x = scaled;
  return is_exact;
}

inline void throw_if_underflow(const char* what, const Offenders& offenders)
{
  if (offenders.count > 0)
    throw Invalid_surface_error(Defect::OUT_OF_RANGE, offenders.first, offenders.count,
                                what + std::to_string(offenders.first) +
                                  " underflows beside the size of the surface: the range of the "
                                  "number type does not hold both" +
                                  offenders.and_more());
}

// Is zero for finite numbers and NaN otherwise, and needs no branch. An exact number may be
// finite and still beyond double, where scaling cannot help either.
inline double zero_if_finite(double x) { return x - x; }

template <class PointVector>
Offenders non_finite_points(const PointVector& points)
{
  Offenders offenders;
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!(zero_if_finite(CGAL::to_double(points[v][0])) +
            zero_if_finite(CGAL::to_double(points[v][1])) +
            zero_if_finite(CGAL::to_double(points[v][2])) ==
          0))
      offenders.add(v);
  return offenders;
}

// The smallest box around points.
struct Box
{
  void add(const Box& other)
  {
    for (int i = 0; i < 3; ++i) {
      low[i] = (std::min)(low[i], other.low[i]);
      high[i] = (std::max)(high[i], other.high[i]);
    }
    zero += other.zero;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  double zero = 0; // NaN if a coordinate is not finite
};

template <class ConcurrencyTag, class PointVector>
Box bounding_box(const PointVector& points)
{
  using FT = typename PointVector::value_type::value_type;
  std::vector<Box> boxes(points.size() / elements_of_block + 1);
  for_each_block<ConcurrencyTag>(points.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
    Box box;
    for (std::size_t v = first; v < last; ++v)
      for (int i = 0; i < 3; ++i) {
        const FT& coordinate = points[v][i];
        const double x = CGAL::to_double(coordinate);
        box.zero += zero_if_finite(x);
        box.low[i] = x < box.low[i] ? x : box.low[i];
        box.high[i] = x > box.high[i] ? x : box.high[i];
      }
    boxes[first / elements_of_block] = box;
  });
  Box result;
  for (const Box& box : boxes)
    result.add(box);
  return result;
}

template <class ConcurrencyTag = Sequential_tag, class PointVector>
int normalize_points(PointVector& points)
{
  using FT = typename PointVector::value_type::value_type;
  const auto [low, high, zero] = bounding_box<ConcurrencyTag>(points);
  if (!(zero == 0)) {
    const Offenders offenders = non_finite_points(points);
    throw Invalid_surface_error(Defect::NOT_FINITE, offenders.first, offenders.count,
                                "vertex " + std::to_string(offenders.first) +
                                  " has a coordinate that is not a finite number" +
                                  offenders.and_more());
  }
  double largest = 0;
  for (int i = 0; i < 3; ++i) // halves, so that the extent itself does not overflow
    if (high[i] > low[i])
      largest = (std::max)(largest, high[i] / 2 - low[i] / 2);
  const int exponent = unit_exponent<FT>(largest);
  if (exponent == 0)
    return 0;
  Offenders offenders;
  for (std::size_t v = 0; v < points.size(); ++v) {
    bool is_exact = true;
    for (FT& x : points[v])
      is_exact &= scale(x, -exponent);
    if (!is_exact)
      offenders.add(v);
  }
  throw_if_underflow("a coordinate of vertex ", offenders);
  return exponent;
}

template <class FT>
int normalize_lengths(std::vector<FT>& lengths)
{
  double largest = 0;
  Offenders offenders;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const double l = magnitude(lengths[e]);
    if (!(l < std::numeric_limits<double>::infinity()) || !certainly(lengths[e] > FT(0)))
      offenders.add(e);
    largest = l > largest ? l : largest;
  }
  if (offenders.count > 0)
    throw Invalid_surface_error(Defect::NOT_FINITE, offenders.first, offenders.count,
                                "the length of edge " + std::to_string(offenders.first) +
                                  " is not a positive finite number" + offenders.and_more());
  const int exponent = unit_exponent<FT>(largest);
  if (exponent == 0)
    return 0;
  for (std::size_t e = 0; e < lengths.size(); ++e)
    if (!scale(lengths[e], -exponent))
      offenders.add(e);
  throw_if_underflow("the length of edge ", offenders);
  return exponent;
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

// Two threads may store the same number for an edge, each for one of its faces.
template <class ConcurrencyTag, class T>
void store(T& to, const T& value)
{
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    boost::atomic_ref<T>(to).store(value, boost::memory_order_relaxed);
  else
    to = value;
}

// All that is computed from the corners of a face is computed while they are at hand: an
// edge twice, which takes less time than to fetch its ends once more.
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
  std::atomic<bool> has_zero{false}, has_other_faces{false};

  for_each_block<Tag>(faces.size(), elements_of_block, [&](std::size_t first, std::size_t last) {
    const Point_data* const point = points.data();
    auto* const edge = edges.data();
    // Coordinate by coordinate, so that they are kept in registers.
    const auto corner = [&](Halfedge_index h) -> Point_data {
      const Point_data& p = point[complex.target(h).idx()];
      return {p[0], p[1], p[2]};
    };
    int block_has_zero = 0, block_has_other_faces = 0;
    auto* face = faces.data() + first;
    for (std::size_t f = first; f < last; ++f, ++face) {
      const Halfedge_index h = complex.halfedge(Face_index(std::uint32_t(f)));
      const Halfedge_index next = complex.next(h), prev = complex.prev(h);
      block_has_other_faces |= int(!is_triangle(complex, h));
      const Point_data p = corner(prev), q = corner(h), r = corner(next);
      const Edge_data pq = construct_edge_data(p, q), qr = construct_edge_data(q, r),
                      pr = construct_edge_data(p, r);
      store<Tag>(edge[complex.edge(h).idx()], pq);
      store<Tag>(edge[complex.edge(next).idx()], qr);
      store<Tag>(edge[complex.edge(prev).idx()], pr);
      block_has_zero |= is_zero(pq) | is_zero(qr) | is_zero(pr);
      *face = construct_face_data(p, q, r);
      bound_corners(traits, h, next, prev, *face, pq, qr, pr, bounds);
    }
    if (block_has_zero != 0)
      has_zero = true;
    if (block_has_other_faces != 0)
      has_other_faces = true;
  });
  if (has_other_faces)
    check_triangles(complex);
  if (has_zero) {
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

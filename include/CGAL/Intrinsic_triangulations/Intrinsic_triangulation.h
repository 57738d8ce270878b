// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A triangulation of a piecewise-flat surface by geodesics between its vertices.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Measured_triangulation.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
struct Engine_access;
} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
///
/// \brief a triangulation of a piecewise-flat surface: a `Delta_complex`, with one datum
/// of the traits for each edge and each face.
///
/// The surface comes from points in space or from edge lengths; after that only lengths
/// count. Internally all lengths are multiplied by a power of two if the input is so
/// large or so small that products of squared lengths would over- or underflow; every
/// number that is returned is in the unit of the input.
///
/// \b Exceptions. Every function that changes the triangulation leaves it unchanged if it throws any exception: an
/// `Error`, `std::bad_alloc`, or one thrown by the function of `set_interruption()`. Only stored numbers may have been
/// replaced by better ones.
///
/// \tparam Traits_ a model of `IntrinsicTriangulationTraits`
template <class Traits_>
class Intrinsic_triangulation
{
public:
  /// the traits
  using Traits = Traits_;
  /// the number type of lengths, areas and weights
  using FT = typename Traits::FT;
  /// `bool` or `CGAL::Uncertain<bool>`
  using Boolean = typename Traits::Boolean;
  /// the data stored for an edge
  using Edge_data = typename Traits::Edge_data;
  /// the data stored for a face
  using Face_data = typename Traits::Face_data;
  /// a point in space
  using Point_data = typename Traits::Point_data;
  /// the data around an edge
  using Hinge_data = Hinge<Edge_data, Face_data>;
  /// whether decisions and numbers are computed from the input if the stored numbers do not suffice
  static constexpr bool uses_exact_geometry = Traits::Uses_exact_geometry::value;

  /// the points of the vertices, in a vector that can be filled without prior initialization
  using Point_vector = Large_vector<Point_data>;

  /// the outcome of `flip()`
  using Flip_outcome = Intrinsic_triangulations::Flip_outcome;

  /// \brief constructs the triangulation of a surface in space.
  ///
  /// \param connectivity the triangles
  /// \param points the position of each vertex, in the order of the vertices; three coordinates `p[i]` of any
  ///   number type, which are rounded to `FT` if it cannot hold them
  /// \param traits the traits
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`
  /// \exception Invalid_surface_error if a coordinate is not finite, an edge has length
  ///   zero, or squared lengths leave the range of the number type. O(size).
  template <class PointRange, class ConcurrencyTag = Sequential_tag>
  Intrinsic_triangulation(Delta_complex connectivity, const PointRange& points, const Traits& traits = Traits(),
                          ConcurrencyTag = ConcurrencyTag())
    : Intrinsic_triangulation(std::move(connectivity), converted(points), traits, ConcurrencyTag())
  {}

  /// \brief as above, but moves the points instead of copying them.
  template <class ConcurrencyTag = Sequential_tag>
  Intrinsic_triangulation(Delta_complex connectivity, Point_vector&& points, const Traits& traits = Traits(),
                          ConcurrencyTag = ConcurrencyTag())
    : Intrinsic_triangulation(std::move(connectivity), std::move(points), traits, ConcurrencyTag(),
                              internal::Null_copier())
  {}

  /// \cond SKIP_IN_MANUAL
  // As above, with the vertices only: the copier brings the faces.
  template <class ConcurrencyTag, class Copier>
  Intrinsic_triangulation(Delta_complex connectivity, Point_vector&& points, const Traits& traits, ConcurrencyTag,
                          Copier&& copier)
    : Intrinsic_triangulation(std::move(connectivity), traits)
  {
    const Arithmetic arithmetic;
    arithmetic.check();
    measured_.template measure_points<ConcurrencyTag>(std::move(points), copier);
  }
  /// \endcond

  /// \brief constructs the triangulation of a surface given by the lengths of its edges.
  ///
  /// \param connectivity the triangles
  /// \param lengths the length of each edge, in the order of the edges
  /// \param traits the traits
  /// \exception Invalid_surface_error if a length is not positive and finite, or three
  ///   lengths violate the triangle inequality; equality is accepted. O(size).
  static Intrinsic_triangulation from_lengths(Delta_complex connectivity, std::vector<FT> lengths,
                                              const Traits& traits = Traits())
  {
    const Arithmetic arithmetic;
    arithmetic.check();
    Intrinsic_triangulation t(std::move(connectivity), traits);
    t.measured_.measure_lengths(std::move(lengths));
    return t;
  }

  /// \brief as above, with lengths of any number type, which are rounded to `FT` if it cannot hold them.
  template <class LengthRange>
  static Intrinsic_triangulation from_lengths(Delta_complex connectivity, const LengthRange& lengths,
                                              const Traits& traits = Traits())
  {
    std::vector<FT> converted_lengths;
    converted_lengths.reserve(std::size_t(std::distance(lengths.begin(), lengths.end())));
    for (const auto& length : lengths)
      converted_lengths.push_back(internal::convert_number<FT>(length));
    return from_lengths(std::move(connectivity), std::move(converted_lengths), traits);
  }

  /// \brief constructs the triangulation of a surface from its exact metric, as `metric_from_squared_lengths()`
  /// returns it for rational coordinates.
  ///
  /// For traits with exact geometry only.
  /// \exception Invalid_surface_error if a squared length is not positive, or three
  ///   violate the triangle inequality; equality is accepted. O(size) rational operations.
  static Intrinsic_triangulation from_metric(Delta_complex connectivity, Input_metric metric,
                                             const Traits& traits = Traits())
  {
    static_assert(uses_exact_geometry, "needs traits that use exact geometry");
    const Arithmetic arithmetic;
    arithmetic.check();
    Intrinsic_triangulation t(std::move(connectivity), traits);
    t.measured_.measure_input(std::move(metric));
    return t;
  }

  /// \brief keeps the input with the triangulation from now on: its position on the triangulation, and its exact
  /// metric.
  ///
  /// Required by `verify_Delaunay()` and by everything that relates input and result. With
  /// `Filtered_edge_length_traits` the constructors do this.
  /// \param metric the exact metric of the current, as yet unflipped triangulation
  void keep_input(Input_metric metric) { measured_.engine().keep_input(std::move(metric)); }

  /// \brief sets what exact decisions accept as a tie from now on. \pre `keeps_input()`
  void set_tie_proof(Tie_proof tie_proof)
  {
    CGAL_precondition(keeps_input());
    measured_.engine().decisions().tie_proof = tie_proof;
  }
  /// \brief sets a function that is called from time to time during long exact decisions: if it returns `false`, the
  /// decision throws a `Cancelled_error`, and nothing changes.
  ///
  /// An empty function, the default, never ends a decision. Copies of the triangulation do not inherit it. It is called
  /// by the deciding threads, possibly by several at once.
  /// \return the previous function
  /// \pre `keeps_input()`
  std::function<bool()> set_interruption(std::function<bool()> go_further)
  {
    CGAL_precondition(keeps_input());
    return measured_.engine().decisions().interruption.exchange(std::move(go_further));
  }

  /// returns whether the input was kept.
  bool keeps_input() const { return measured_.engine().keeps_input(); }

  /// \name Where the input lies
  /// These functions refer to the triangulation as it was when its input was kept. The first query after flips costs
  /// O(size + number of flips).
  /// \pre `keeps_input()`
  /// \exception Integer_overflow_error if an edge crosses more than 2^60 input edges
  /// @{

  /// returns the exact metric of the input.
  const Input_metric& input_metric() const
  {
    CGAL_precondition(keeps_input());
    return measured_.engine().metric();
  }
  /// returns the connectivity of the input. It has the original vertices, edges, halfedges and faces; `halfedge(v)` and
  /// `halfedge(f)` may be other halfedges of the vertex and the face.
  const Delta_complex& input() const { return internal::input(correspondence()); }
  /// returns how many times input edges cross `e`; 0 if it coincides with one.
  std::int64_t number_of_crossings(Edge_index e) const
  {
    return (std::max)(std::int64_t(0), internal::crossings(correspondence(), e));
  }
  /// returns whether `e` coincides with an edge of the input, or with a part of one.
  bool is_input_edge(Edge_index e) const { return internal::crossings(correspondence(), e) < 0; }
  /// returns the halfedge of the input along `h`. \pre `is_input_edge(connectivity().edge(h))`
  Halfedge_index input_halfedge(Halfedge_index h) const { return internal::input_halfedge(correspondence(), h); }
  /// returns whether `v` was inserted, that is, whether it is not a vertex of the input.
  bool is_inserted(Vertex_index v) const { return internal::is_inserted(correspondence(), v); }
  /// returns where an inserted vertex lies on the input. The coordinates are exact once they are divided by their sum.
  /// \pre `is_inserted(v)`
  const Surface_point& location(Vertex_index v) const { return internal::location(correspondence(), v); }
  /// @}

  /// returns the triangles.
  const Delta_complex& connectivity() const { return measured_.engine().connectivity(); }
  /// returns the traits.
  const Traits& traits() const { return measured_.traits(); }

  /// \name Metric
  /// All values are as accurate as the traits' functors make them. Lengths are in the unit of the input; cotangents and
  /// weights have no unit.
  /// @{

  /// returns the length of `e`.
  FT length(Edge_index e) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(measured_.engine()).length(e);
    return in_input_unit(traits().compute_length_object()(edge_data(e)), 1);
  }
  /// returns the squared length of `e`.
  FT squared_length(Edge_index e) const
  {
    return in_input_unit(traits().compute_squared_length_object()(edge_data(e)), 2);
  }
  /// returns the area of `f`.
  FT area(Face_index f) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(measured_.engine()).area(f);
    const Halfedge_index h = connectivity().halfedge(f);
    return in_input_unit(traits().compute_area_object()(face_data(f), edge_data(edge(h)),
                                                        edge_data(edge(connectivity().next(h))),
                                                        edge_data(edge(connectivity().prev(h)))),
                         2);
  }
  /// returns the cotangent of the angle opposite to `h` in its face.
  /// \pre `h` is not a border halfedge, and its face has positive area
  FT cotangent(Halfedge_index h) const
  {
    CGAL_precondition(!connectivity().is_border(h));
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(measured_.engine()).cotangent(h);
    return traits().compute_cotangent_object()(face_data(connectivity().face(h)), edge_data(edge(h)),
                                               edge_data(edge(connectivity().next(h))),
                                               edge_data(edge(connectivity().prev(h))));
  }
  /// returns the sum of the cotangents of the one or two angles opposite to `e`, without
  /// a factor: a weight of the Laplace-Beltrami operator (section 3.1 of the paper).
  FT cotangent_weight(Edge_index e) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(measured_.engine()).cotangent_weight(e);
    const Halfedge_index h = connectivity().halfedge(e), g = connectivity().opposite(h);
    if (connectivity().is_border(h))
      return cotangent(g);
    if (connectivity().is_border(g))
      return cotangent(h);
    return cotangent(h) + cotangent(g);
  }
  /// @}

  /// \brief returns whether `e` is Delaunay: whether the opposite angles sum to at most π.
  ///
  /// Border edges and edges with the same face on both sides are Delaunay.
  /// \return an uncertain value if an interval number type cannot tell
  Boolean is_locally_Delaunay(Edge_index e) const
  {
    if (!connectivity().is_flippable(e))
      return true;
    const Arithmetic arithmetic;
    const Boolean answer = traits().is_locally_Delaunay_object()(measured_.hinge(e));
    if constexpr (uses_exact_geometry)
      if (!is_certain(answer))
        return measured_.engine().test(e)->sign != NEGATIVE;
    return answer;
  }

  /// \brief returns the exact sign of the cotangent weight of `e`: zero for a tie.
  ///
  /// Where both faces have zero area, it is negative if both opposite angles are π, and
  /// zero otherwise.
  /// \pre `keeps_input()` and `connectivity().is_flippable(e)`
  /// \exception Undecided_error if proofs of ties are demanded, and one takes too long
  /// \exception Cancelled_error as described at `set_interruption()`
  /// \exception Integer_overflow_error if an edge crosses more than 2^60 input edges
  Sign sign_of_cotangent_weight(Edge_index e) const
  {
    const Arithmetic arithmetic;
    if constexpr (uses_exact_geometry) {
      const Boolean answer = traits().is_locally_Delaunay_object()(measured_.hinge(e));
      if (is_certain(answer)) // the filter decides no tie
        return certainly(answer) ? POSITIVE : NEGATIVE;
    }
    return prepared_engine().test(e)->sign;
  }

  /// \brief returns how many tests of `flip_to_Delaunay()` each stage decided.
  ///
  /// With traits without exact geometry, all count as decided by the filter.
  Stage_counts stage_counts() const
  {
    Stage_counts counts = keeps_input() ? measured_.engine().decisions().counts : Stage_counts();
    counts.decided[std::size_t(Stage::FILTER)] = measured_.number_of_filter_decisions();
    return counts;
  }

  /// \brief flips `e` if its two faces form a strictly convex quadrilateral.
  ///
  /// No edge or face changes unless the outcome is `FLIPPED`. O(1). With traits that use exact geometry, whether
  /// the quadrilateral is convex is decided exactly: where the error bounds do not suffice, in time proportional to the
  /// number of input edges that its sides cross.
  /// \pre `connectivity().is_flippable(e)`
  /// \exception Invalid_surface_error if the new edge has length zero, so that two vertices of the input coincide
  /// \exception Undecided_error, Cancelled_error, Integer_overflow_error as `sign_of_cotangent_weight()`
  Flip_outcome flip(Edge_index e)
  {
    const Arithmetic arithmetic;
    if constexpr (uses_exact_geometry)
      if (!measured_.is_convex(e))
        return Flip_outcome::NOT_CONVEX;
    return measured_.flip_not_Delaunay(e);
  }

  /// returns the datum that the traits store for `e`, in the internal unit.
  const Edge_data& edge_data(Edge_index e) const { return measured_.edge_data(e); }
  /// returns the datum that the traits store for `f`, in the internal unit.
  const Face_data& face_data(Face_index f) const { return measured_.face_data(f); }
  /// returns k such that one internal unit of length is `2^k` units of the input.
  int unit_exponent() const { return measured_.unit_exponent(); }

private:
  /// \cond SKIP_IN_MANUAL
  friend struct internal::Engine_access;
  /// \endcond

  using Arithmetic = typename internal::Measured_triangulation<Traits>::Arithmetic;

  Intrinsic_triangulation(Delta_complex connectivity, const Traits& traits) : measured_(std::move(connectivity), traits)
  {}

  template <class PointRange>
  static Point_vector converted(const PointRange& points)
  {
    Point_vector result;
    result.reserve(std::size_t(std::distance(std::begin(points), std::end(points))));
    for (const auto& p : points)
      result.push_back(
        {internal::convert_number<FT>(p[0]), internal::convert_number<FT>(p[1]), internal::convert_number<FT>(p[2])});
    return result;
  }

  Edge_index edge(Halfedge_index h) const { return connectivity().edge(h); }

  const internal::Exact_engine& prepared_engine() const
  {
    CGAL_precondition(keeps_input());
    measured_.engine().prepare();
    return measured_.engine();
  }
  const internal::Correspondence& correspondence() const { return prepared_engine().correspondence(); }

  FT in_input_unit(FT x, int dimension) const
  {
    return unit_exponent() == 0 ? x : internal::times_power_of_two(x, dimension * unit_exponent());
  }

  internal::Measured_triangulation<Traits> measured_; // and changed by the algorithms of the package
};

namespace internal {

// The rest of a triangulation that was given up.
struct Released_engine
{
  Exact_engine engine;
  std::function<bool()> go_further; // the argument of `set_interruption()`
};

struct Engine_access
{
  template <class Traits>
  static Measured_triangulation<Traits>& measured(Intrinsic_triangulation<Traits>& triangulation)
  {
    return triangulation.measured_;
  }

  template <class Traits>
  static const Exact_engine& engine(const Intrinsic_triangulation<Traits>& triangulation)
  {
    return triangulation.measured_.engine();
  }
  // Of an object made from a triangulation.
  template <class Object>
  static const Exact_engine& engine(const Object& object)
  {
    return object.engine_;
  }

  // Afterwards the triangulation can only be destroyed or assigned to; its stored numbers are freed.
  template <class Traits>
  static Released_engine give_up(Intrinsic_triangulation<Traits>& triangulation)
  {
    Intrinsic_triangulation<Traits> given_up(std::move(triangulation));
    std::function<bool()> go_further = given_up.set_interruption({});
    return {std::move(given_up.measured_.engine()), std::move(go_further)};
  }
};

// The engine of a triangulation, or of an object made from one, ready for queries. Throws if the input was not kept,
// which is easily forgotten with a custom number type.
template <class ConcurrencyTag = Sequential_tag, class Triangulation>
const Exact_engine& engine(const Triangulation& triangulation)
{
  const Exact_engine& result = Engine_access::engine(triangulation);
  if (!result.keeps_input())
    throw Invalid_argument_error("the triangulation does not keep its input; call keep_input() before the first flip");
  result.template prepare<ConcurrencyTag>();
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

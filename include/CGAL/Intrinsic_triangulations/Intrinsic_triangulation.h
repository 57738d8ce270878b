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
#include <CGAL/Intrinsic_triangulations/internal/system/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
template <class Traits>
class Whole_triangulation;
template <class Traits>
class Triangulation_block;
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

  /// the outcome of `flip()`.
  enum class Flip_outcome {
    FLIPPED,    ///< the edge was flipped
    NOT_CONVEX, ///< the hinge has no other diagonal; nothing was changed
    UNDECIDED   ///< the number type cannot tell; nothing was changed
  };

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
    exponent_ = internal::normalize_points<ConcurrencyTag>(points, internal::Is_used_vertex{engine_.connectivity()});
    internal::construct_metric_from_points<ConcurrencyTag>(engine_.connectivity(), copier, traits_, points, edges_,
                                                           faces_, bounds_);
    if constexpr (uses_exact_geometry)
      keep_input(Input_metric::from_normalized_points(std::move(points), exponent_));
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
    t.exponent_ = internal::normalize_lengths(lengths);
    internal::construct_metric_from_lengths(t.connectivity(), t.traits_, lengths, t.edges_, t.faces_);
    t.bound_corners();
    if constexpr (uses_exact_geometry)
      t.keep_input(Input_metric::from_normalized_lengths(std::move(lengths), t.exponent_));
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
    metric.check(t.connectivity());
    t.exponent_ = metric.unit_exponent();
    internal::construct_metric_from_input(t.connectivity(), t.traits_, metric, t.edges_, t.faces_);
    t.bound_corners();
    t.keep_input(std::move(metric));
    return t;
  }

  /// \brief keeps the input with the triangulation from now on: its position on the triangulation, and its exact
  /// metric.
  ///
  /// Required by `verify_Delaunay()` and by everything that relates input and result. With
  /// `Filtered_edge_length_traits` the constructors do this.
  /// \param metric the exact metric of the current, as yet unflipped triangulation
  void keep_input(Input_metric metric) { engine_.keep_input(std::move(metric)); }

  /// \brief sets what exact decisions accept as a tie from now on. \pre `keeps_input()`
  void set_tie_proof(Tie_proof tie_proof)
  {
    CGAL_precondition(keeps_input());
    engine_.decisions().tie_proof = tie_proof;
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
    return engine_.decisions().interruption.exchange(std::move(go_further));
  }

  /// returns whether the input was kept.
  bool keeps_input() const { return engine_.keeps_input(); }

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
    return engine_.metric();
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
  const Delta_complex& connectivity() const { return engine_.connectivity(); }
  /// returns the traits.
  const Traits& traits() const { return traits_; }

  /// \name Metric
  /// All values are as accurate as the traits' functors make them. Lengths are in the unit of the input; cotangents and
  /// weights have no unit.
  /// @{

  /// returns the length of `e`.
  FT length(Edge_index e) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(engine_).length(e);
    return in_input_unit(traits_.compute_length_object()(edge_data(e)), 1);
  }
  /// returns the squared length of `e`.
  FT squared_length(Edge_index e) const
  {
    return in_input_unit(traits_.compute_squared_length_object()(edge_data(e)), 2);
  }
  /// returns the area of `f`.
  FT area(Face_index f) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(engine_).area(f);
    const Halfedge_index h = connectivity().halfedge(f);
    return in_input_unit(traits_.compute_area_object()(face_data(f), edge_data(edge(h)),
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
      return internal::Engine_numbers(engine_).cotangent(h);
    return traits_.compute_cotangent_object()(face_data(connectivity().face(h)), edge_data(edge(h)),
                                              edge_data(edge(connectivity().next(h))),
                                              edge_data(edge(connectivity().prev(h))));
  }
  /// returns the sum of the cotangents of the one or two angles opposite to `e`, without
  /// a factor: a weight of the Laplace-Beltrami operator (section 3.1 of the paper).
  FT cotangent_weight(Edge_index e) const
  {
    if constexpr (uses_exact_geometry)
      return internal::Engine_numbers(engine_).cotangent_weight(e);
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
    const Boolean answer = traits_.is_locally_Delaunay_object()(hinge(e));
    if constexpr (uses_exact_geometry)
      if (!is_certain(answer))
        return engine_.test(e)->sign != NEGATIVE;
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
      const Boolean answer = traits_.is_locally_Delaunay_object()(hinge(e));
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
    Stage_counts counts = keeps_input() ? engine_.decisions().counts : Stage_counts();
    counts.decided[std::size_t(Stage::FILTER)] = number_of_filter_decisions_;
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
      if (!is_convex(e))
        return Flip_outcome::NOT_CONVEX;
    return flip_not_Delaunay(e);
  }

  /// returns the datum that the traits store for `e`, in the internal unit.
  const Edge_data& edge_data(Edge_index e) const { return edges_[e.idx()]; }
  /// returns the datum that the traits store for `f`, in the internal unit.
  const Face_data& face_data(Face_index f) const { return faces_[f.idx()]; }
  /// returns k such that one internal unit of length is `2^k` units of the input.
  int unit_exponent() const { return exponent_; }

private:
  /// \cond SKIP_IN_MANUAL
  template <class>
  friend class internal::Whole_triangulation;
  template <class>
  friend class internal::Triangulation_block;
  friend struct internal::Engine_access;
  /// \endcond

  const internal::Exact_engine& prepared_engine() const
  {
    CGAL_precondition(keeps_input());
    engine_.prepare();
    return engine_;
  }
  const internal::Correspondence& correspondence() const { return prepared_engine().correspondence(); }

  // The arithmetic that error bounds assume; interval types set the rounding mode themselves.
  struct Any_arithmetic
  {
    Any_arithmetic() {}
    void check() const {}
  };
  using Arithmetic = std::conditional_t<uses_exact_geometry, internal::Standard_arithmetic, Any_arithmetic>;

  static constexpr bool keeps_bounds = internal::Has_cotangent_bounds<Traits>::value;

  Intrinsic_triangulation(Delta_complex connectivity, const Traits& traits)
    : engine_(std::move(connectivity)), traits_(traits),
      edges_(this->connectivity().number_of_edges(), internal::default_init),
      faces_(this->connectivity().number_of_faces(), internal::default_init)
  {
    if (keeps_bounds)
      bounds_ = internal::Cotangent_bounds(this->connectivity());
  }

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

  Hinge_data hinge(Edge_index e) const { return hinge(connectivity().hinge(e)); }
  Hinge_data hinge(const Hinge_halfedges& around) const
  {
    return {edge_data(edge(around.ij)),
            edge_data(edge(around.jk)),
            edge_data(edge(around.ki)),
            edge_data(edge(around.il)),
            edge_data(edge(around.lj)),
            face_data(connectivity().face(around.ij)),
            face_data(connectivity().face(around.ji))};
  }

  // Computes all numbers from the old hinge, and replaces them. `flip()` flips the connectivity, once it is certain
  // that the flip exists; if it throws, nothing changes.
  template <class Construct, class Flip>
  Flip_outcome flip_hinge(const Hinge_halfedges& around, const Hinge_data& old, const Construct& construct,
                          const Flip& flip)
  {
    typename Traits::Flipped_hinge_data flipped{};
    const Boolean is_convex = construct(old, flipped);
    if (!certainly(is_convex))
      return possibly(is_convex) ? Flip_outcome::UNDECIDED : Flip_outcome::NOT_CONVEX;
    flip();
    edges_[edge(around.ij).idx()] = flipped.kl;
    faces_[connectivity().face(around.ij).idx()] = flipped.ilk;
    faces_[connectivity().face(around.ji).idx()] = flipped.jkl;
    internal::bound_corners_of_flipped(traits_, around, old, flipped, bounds_);
    return Flip_outcome::FLIPPED;
  }

  // As `flip()`, for an edge that is not Delaunay.
  //
  // The quadrilateral around such an edge is always strictly convex. So traits with exact decisions need not check, and
  // the flip takes O(1) unless both old faces may have zero area.
  // \pre `connectivity().is_flippable(e)` and not `is_locally_Delaunay(e)`
  Flip_outcome flip_not_Delaunay(Edge_index e)
  {
    CGAL_precondition(connectivity().is_flippable(e));
    const Arithmetic arithmetic;
    return flip_not_Delaunay(connectivity().hinge(e));
  }
  // As above, for the halfedges around the edge.
  Flip_outcome flip_not_Delaunay(const Hinge_halfedges& around)
  {
    return flip_convex(around, traits_.construct_flipped_hinge_object());
  }
  // As above, for a strictly convex quadrilateral. \param construct computes the numbers, like the traits' functor
  template <class Construct>
  Flip_outcome flip_convex(const Hinge_halfedges& around, const Construct& construct)
  {
    const Hinge_data old = hinge(around);
    if (BOOST_LIKELY(is_new_edge_known_to_have_length(old)))
      return flip_convex(around, old, construct, [] {});
    const Replaced before = replaced(around);
    return flip_convex(around, old, construct, [&] { check_length(around, before); });
  }
  template <class Construct, class Check>
  Flip_outcome flip_convex(const Hinge_halfedges& around, const Hinge_data& old, const Construct& construct,
                           const Check& check)
  {
    bool is_straight = false;
    const Flip_outcome outcome = flip_hinge(around, old, construct, [&] { is_straight = engine_.flip(around); });
    if (outcome != Flip_outcome::FLIPPED)
      return outcome;
    if constexpr (uses_exact_geometry) {
      check();
      if (is_straight)
        measure_straight_faces(around);
    }
    return outcome;
  }

  // ---------------------------------------------------------------- new vertices: nothing is flipped

  // Splits a face into three by a new vertex.
  // \param piece the piece of the face that contains the vertex, between the input edges that cross it
  // \param location where the vertex lies: strictly inside a face of the input, and inside of the piece. The metric is
  //   not changed: its coordinates are taken as exact once they are divided by their sum
  // \return the new vertex, as `split_face(piece.side)` of `Delta_complex`
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  Vertex_index split_face(const internal::Triangle_piece& piece, const Surface_point& location)
  {
    const Arithmetic arithmetic;
    const Halfedge_index first = engine_.halfedge_of_face(piece);
    make_room_for_vertex();
    const Vertex_index v = engine_.split_face(piece, location);
    measure_star(v, [&] { remove(engine_.unsplit_face(v, {first})); });
    return v;
  }
  // Splits an edge that coincides with an input edge, and the faces beside it, by a new vertex.
  // \param h a halfedge of the edge, which lies on the border or between two different faces
  // \param location where the vertex lies: strictly between the ends of the edge, on the input edge
  // \return the new vertex, as `split_edge(h)` of `Delta_complex`
  // \exception Integer_overflow_error as above
  Vertex_index split_edge(Halfedge_index h, const Surface_point& location)
  {
    const Arithmetic arithmetic;
    const auto first_beside = [this](Halfedge_index side) {
      return connectivity().is_border(side) ? Halfedge_index() : connectivity().halfedge(connectivity().face(side));
    };
    const Halfedge_index first = first_beside(h), second = first_beside(connectivity().opposite(h));
    make_room_for_vertex();
    const Vertex_index v = engine_.split_edge(h, location);
    measure_star(v, [&] { remove(engine_.unsplit_edge(h, {first, second})); });
    return v;
  }
  // Replaces the triangulation, which is still its input, by the saved triangulation, once checked to derive from it.
  // \exception Invalid_surface_error if it has not; then this can only be destroyed
  template <class ConcurrencyTag, class Saved>
  void restore(Saved saved)
  {
    const Arithmetic arithmetic;
    const std::size_t number_of_input_faces = connectivity().number_of_faces();
    // Most faces are input faces, with the numbers just computed.
    const auto is_known = [&](Face_index f) {
      if (f.idx() >= number_of_input_faces || faces_[f.idx()].value != saved.areas[f.idx()][0] ||
          faces_[f.idx()].error != saved.areas[f.idx()][1])
        return false;
      const Halfedge_index h = connectivity().halfedge(f);
      for (Halfedge_index side : {h, connectivity().next(h), connectivity().prev(h)})
        if (side.idx() >= input().number_of_halfedges() || input().face(side) != f || !is_input_edge(edge(side)) ||
            input_halfedge(side) != side || edges_[edge(side).idx()] != saved.squared_lengths[edge(side).idx()])
          return false;
      return true;
    };
    saved.restore(engine_, internal::block_runner<ConcurrencyTag>(), is_known);
    edges_ = std::move(saved.squared_lengths);
    faces_.resize(connectivity().number_of_faces(), internal::default_init);
    bounds_ = internal::Cotangent_bounds(connectivity());
    for (Face_index f : connectivity().faces())
      faces_[f.idx()] = {saved.areas[f.idx()][0], saved.areas[f.idx()][1]};
    bound_corners();
  }

  // Removes an inserted vertex in the middle of three faces, which become one. See `remove_vertex()`.
  // \return the removed elements, as `unsplit_face(v)` of `Delta_complex`
  Removed_elements unsplit_face(Vertex_index v)
  {
    const Arithmetic arithmetic;
    const Corners parts = engine_.corners_at(v);
    CGAL_precondition(parts.size() == 3);
    const auto& [side, a] = parts[0];
    const internal::Exact_engine::Corner &b = parts[1].second, &c = parts[2].second;
    const auto whole = triangle(a.four_areas + b.four_areas + c.four_areas, c.s_opposite, b.s_opposite, a.s_opposite);
    const Removed_elements removed = engine_.unsplit_face(v);
    remove(removed);
    replace(after(removed, side), whole);
    return removed;
  }
  // Removes an inserted vertex on a straight line of two edges.
  // \param h a halfedge to the vertex, which its continuation leaves at an angle of π
  // \return the removed elements, as `unsplit_edge(h)` of `Delta_complex`
  // \exception Integer_overflow_error as above
  Removed_elements unsplit_edge(Halfedge_index h)
  {
    const Arithmetic arithmetic;
    const Halfedge_index g = connectivity().opposite(h), behind = connectivity().continuation(h);
    const Corners parts = engine_.corners_at(connectivity().target(h));
    const Corners whole = joined(parts, {{{h, h, behind}, {g, connectivity().opposite(behind), g}}});
    const Removed_elements removed = engine_.unsplit_edge(h);
    remove(removed);
    edges_[edge(after(removed, h)).idx()] = traits_.construct_refined_data_object()(whole.front().second.s_opposite);
    for (const auto& [side, corner] : whole)
      replace(after(removed, side), corner);
    return removed;
  }
  // Replaces the stored numbers of `f` by numbers computed from the input, if these are better.
  //
  // After many flips their error bounds are so wide that filters decide little. For traits with exact geometry. Costs
  // time proportional to the number of input edges that the sides cross.
  // \return whether they are better: then the squared lengths are as accurate as at first
  bool recompute(Face_index f)
  {
    const Arithmetic arithmetic;
    CGAL_precondition(keeps_input());
    engine_.prepare();
    const Halfedge_index h = internal::quickest_side(engine_, f);
    return recompute(h, engine_.kept_corner(h));
  }

  // Replaces the stored numbers of all faces around `v` by numbers computed from the input.
  //
  // As `recompute(Face_index)` for each of them, but each edge from `v` is laid out once. `v` lies inside the surface
  // or on its border.
  // \pre `v` has a face
  void recompute(Vertex_index v)
  {
    const Arithmetic arithmetic;
    CGAL_precondition(keeps_input());
    measure(engine_.kept_corners_at(v));
  }

  // If the numbers of both faces leave it open, they are replaced by better ones: more flips next to them may follow.
  bool is_convex(Edge_index e)
  {
    const auto by_filter = traits_.is_convex_object();
    if (const Boolean answer = by_filter(hinge(e)); is_certain(answer))
      return certainly(answer);
    recompute(connectivity().face(connectivity().halfedge(e)));
    recompute(connectivity().face(connectivity().opposite(connectivity().halfedge(e))));
    const Boolean answer = by_filter(hinge(e));
    return is_certain(answer) ? certainly(answer) : engine_.is_convex(e);
  }

  // Decides by the exact geometry, and replaces the stored numbers.
  BOOST_NOINLINE bool decide_and_recompute(Edge_index e)
  {
    std::optional<internal::Exact_engine::Opposite_corners> corners;
    const Sign sign = engine_.decide(e, corners);
    const Halfedge_index h = connectivity().halfedge(e), g = connectivity().opposite(h);
    if (corners) {
      recompute(h, corners->k);
      recompute(g, corners->l);
    } else {
      measure_straight_faces(connectivity().hinge(e));
    }
    return sign != NEGATIVE;
  }

  // Recomputed from their points, faces are as accurate as before the first flip.
  void measure_straight_faces(const Hinge_halfedges& around)
  {
    const internal::Face_measurer<Sequential_tag, Traits> measurer(connectivity(), traits_, engine_.metric().points(),
                                                                   edges_, faces_, bounds_);
    const internal::Face_halfedges one(connectivity(), around.ij), two(connectivity(), around.ji);
    const auto is_accurate = traits_.is_accurate_object();
    const auto measures = [&](const internal::Face_halfedges& face) {
      if (is_accurate(face_data(face.face)))
        return false;
      const auto is_given = [&](Halfedge_index side) {
        return connectivity().source(side).idx() < engine_.metric().points().size();
      };
      if (is_given(face.h) && is_given(face.next) && is_given(face.prev))
        return true;
      recompute(face.h, engine_.kept_corner(face.h)); // the points of inserted vertices are not doubles
      return false;
    };
    const bool measures_one = measures(one), measures_two = measures(two);
    if constexpr (internal::Takes_two_faces<Traits>::value)
      if (measures_one && measures_two)
        return void(measurer.measure(one, two));
    if (measures_one)
      measurer.measure(one);
    if (measures_two)
      measurer.measure(two);
  }

  bool recompute(Halfedge_index h, const internal::Exact_engine::Corner& c)
  {
    const Face_data face = traits_.construct_refined_data_object()(c.four_areas, c.s_first, c.s_second, c.s_opposite);
    if (!(face.error < std::numeric_limits<double>::infinity()))
      return false;
    replace(h, c);
    return true;
  }

  // Unreliable numbers are not stored for the sides, which other faces share.
  void replace(Halfedge_index h, const internal::Exact_engine::Corner& c)
  {
    const auto refined = traits_.construct_refined_data_object();
    const Face_data face = refined(c.four_areas, c.s_first, c.s_second, c.s_opposite);
    if (face.error < std::numeric_limits<double>::infinity()) {
      edges_[edge(connectivity().prev(h)).idx()] = refined(c.s_first);
      edges_[edge(connectivity().next(h)).idx()] = refined(c.s_second);
      edges_[edge(h).idx()] = refined(c.s_opposite);
    }
    faces_[connectivity().face(h).idx()] = face;
    bound_corners(h);
  }

  // Corners, each after its opposite side.
  using Corners = std::vector<std::pair<Halfedge_index, internal::Exact_engine::Corner>>;

  // Afterwards a split does not throw.
  void make_room_for_vertex()
  {
    internal::make_room(edges_, 3);
    internal::make_room(faces_, 2);
    if (keeps_bounds)
      bounds_.make_room(3);
  }

  // Computes the numbers of all faces around a vertex that was just inserted.
  // \param undo removes it again
  template <class Undo>
  void measure_star(Vertex_index v, const Undo& undo)
  {
    const std::size_t number_of_new_edges = connectivity().number_of_edges() - edges_.size();
    edges_.resize(connectivity().number_of_edges(), internal::default_init);
    faces_.resize(connectivity().number_of_faces(), internal::default_init);
    if (keeps_bounds)
      bounds_.append(number_of_new_edges);
    try {
      measure(engine_.kept_corners_at(v));
    } catch (...) {
      undo();
      throw;
    }
  }

  // Drops the data of removed elements. Never throws.
  void remove(const Removed_elements& removed)
  {
    remove_entries(edges_, removed.edges);
    remove_entries(faces_, removed.faces);
    if (keeps_bounds)
      bounds_.remove(removed.edges);
  }
  static Halfedge_index after(const Removed_elements& removed, Halfedge_index h)
  {
    return Halfedge_index(2 * removed.edge_after(Edge_index(h.idx() / 2)).idx() + (h.idx() & 1));
  }

  // The corner of a triangle with these sides.
  template <class Number>
  static internal::Exact_engine::Corner triangle(const Number& four_areas, const Number& s_first,
                                                 const Number& s_second, const Number& s_opposite)
  {
    return {s_first + s_second - s_opposite, four_areas, s_first, s_second, s_opposite};
  }

  // Two consecutive halfedges that become one, and the name of that one.
  struct Straight_line
  {
    Halfedge_index result, first, second;
  };
  // The triangles on both sides of a straight line, computed from the corners at the vertex in its middle, which lie
  // opposite the line.
  Corners joined(const Corners& parts, const std::array<Straight_line, 2>& sides) const
  {
    const auto at = [&](Halfedge_index side) -> const internal::Exact_engine::Corner& {
      return std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.first == side; })->second;
    };
    Corners result;
    for (const Straight_line& line : sides) {
      if (connectivity().is_border(line.first))
        continue;
      const internal::Exact_engine::Corner &a = at(connectivity().prev(line.first)),
                                           &b = at(connectivity().next(line.second));
      const auto length = sqrt(a.s_second) + sqrt(b.s_first);
      result.emplace_back(line.result,
                          triangle(a.four_areas + b.four_areas, a.s_opposite, b.s_opposite, length * length));
    }
    return result;
  }

  // Computes the numbers of faces, each given by a corner and the side opposite to it.
  void measure(const Corners& corners)
  {
    const auto refined = traits_.construct_refined_data_object();
    for (const auto& [side, c] : corners) {
      edges_[edge(connectivity().prev(side)).idx()] = refined(c.s_first);
      edges_[edge(connectivity().next(side)).idx()] = refined(c.s_second);
      replace(side, c);
    }
    for (const auto& corner : corners) // by sides that the next face may have replaced
      bound_corners(corner.first);
  }

  void bound_corners()
  {
    if (keeps_bounds)
      for (Face_index f : connectivity().faces())
        bound_corners(connectivity().halfedge(f));
  }
  void bound_corners(Halfedge_index h)
  {
    const Halfedge_index next = connectivity().next(h), prev = connectivity().prev(h);
    internal::bound_corners(traits_, h, next, prev, face_data(connectivity().face(h)), edge_data(edge(h)),
                            edge_data(edge(next)), edge_data(edge(prev)), bounds_);
  }

  // The new edge runs from one side of the old one to the other: its ends can only coincide if both lie on the old
  // edge.
  bool is_new_edge_known_to_have_length(const Hinge_data& old) const
  {
    if constexpr (uses_exact_geometry) {
      const auto has_positive_area = traits_.has_positive_area_object();
      return has_positive_area(old.ijk) || has_positive_area(old.jil);
    }
    return true;
  }

  // The numbers of a face and its sides.
  struct Face_numbers
  {
    Edge_data side, next, prev;
    Face_data face;
  };
  Face_numbers numbers_of_face(Halfedge_index h) const
  {
    return {edge_data(edge(h)), edge_data(edge(connectivity().next(h))), edge_data(edge(connectivity().prev(h))),
            face_data(connectivity().face(h))};
  }
  void put_back(Halfedge_index h, const Face_numbers& numbers)
  {
    edges_[edge(h).idx()] = numbers.side;
    edges_[edge(connectivity().next(h)).idx()] = numbers.next;
    edges_[edge(connectivity().prev(h)).idx()] = numbers.prev;
    faces_[connectivity().face(h).idx()] = numbers.face;
    bound_corners(h);
  }

  // The data that a flip replaces.
  struct Replaced
  {
    Face_numbers ijk, jil;
    internal::Exact_engine::Forgotten forgotten;
  };
  BOOST_NOINLINE Replaced replaced(const Hinge_halfedges& around) const
  {
    return {numbers_of_face(around.ij), numbers_of_face(around.ji), engine_.forgotten_by_flip(around)};
  }

  // Checks the edge that a flip has made. An exception undoes the flip.
  BOOST_NOINLINE void check_length(const Hinge_halfedges& around, const Replaced& before)
  {
    try {
      if (engine_.has_length_zero(edge(around.ij)))
        internal::throw_no_length(connectivity(), edge(around.ij));
    } catch (...) {
      flip_back(around, before);
      throw;
    }
  }

  // Undoes the last flip that was not undone yet; restores all stored numbers. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Hinge_halfedges& around, const Replaced& before)
  {
    engine_.flip_back(around, before.forgotten);
    put_back(around.ij, before.ijk);
    put_back(around.ji, before.jil);
  }

  FT in_input_unit(FT x, int dimension) const
  {
    return exponent_ == 0 ? x : internal::times_power_of_two(x, dimension * exponent_);
  }

  internal::Exact_engine engine_; // which has the connectivity
  Traits traits_;
  // Left uninitialized until they are filled: one more pass would be measurable.
  Large_vector<Edge_data> edges_;
  Large_vector<Face_data> faces_;
  internal::Cotangent_bounds bounds_; // empty if the traits have none
  int exponent_ = 0;
  std::uint64_t number_of_filter_decisions_ = 0;
};

namespace internal {

// The rest of a triangulation that was given up.
struct Released_engine
{
  internal::Exact_engine engine;
  std::function<bool()> go_further; // the argument of `set_interruption()`
};

struct Engine_access
{
  template <class Triangulation>
  static const internal::Exact_engine& engine(const Triangulation& triangulation)
  {
    return triangulation.engine_;
  }

  // Afterwards the triangulation can only be destroyed or assigned to; its stored numbers are freed.
  template <class Traits>
  static Released_engine give_up(Intrinsic_triangulation<Traits>& triangulation)
  {
    Intrinsic_triangulation<Traits> given_up(std::move(triangulation));
    std::function<bool()> go_further = given_up.set_interruption({});
    return {std::move(given_up.engine_), std::move(go_further)};
  }
};

// The engine of a triangulation, or of an object made from one, ready for queries. Throws if the input was not kept,
// which is easily forgotten with a custom number type.
template <class ConcurrencyTag = Sequential_tag, class Triangulation>
const internal::Exact_engine& engine(const Triangulation& triangulation)
{
  const internal::Exact_engine& result = Engine_access::engine(triangulation);
  if (!result.keeps_input())
    throw Invalid_argument_error("the triangulation does not keep its input; call keep_input() before the first flip");
  result.template prepare<ConcurrencyTag>();
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_TRIANGULATION_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A triangulation with its stored numbers, and how they change together.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_MEASURED_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_MEASURED_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/tags.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What an `Intrinsic_triangulation` consists of: the engine, which has the connectivity, and a number of the traits for
// each edge and face. All changes of the triangulation are here; each leaves everything unchanged if it throws. After
// the constructor, one of three functions computes the numbers: from points, lengths, or the exact metric.
template <class Traits_>
class Measured_triangulation
{
public:
  using Traits = Traits_;
  using FT = typename Traits::FT;
  using Boolean = typename Traits::Boolean;
  using Edge_data = typename Traits::Edge_data;
  using Face_data = typename Traits::Face_data;
  using Hinge_data = Hinge<Edge_data, Face_data>;
  using Point_vector = Large_vector<typename Traits::Point_data>;
  static constexpr bool uses_exact_geometry = Traits::Uses_exact_geometry::value;

  // The arithmetic that error bounds assume; interval types set the rounding mode themselves.
  struct Any_arithmetic
  {
    Any_arithmetic() {}
    void check() const {}
  };
  using Arithmetic = std::conditional_t<uses_exact_geometry, Standard_arithmetic, Any_arithmetic>;

  static constexpr bool keeps_bounds = Has_cotangent_bounds<Traits>::value;

  Measured_triangulation(Delta_complex connectivity, const Traits& traits)
    : engine_(std::move(connectivity)), traits_(traits), edges_(this->connectivity().number_of_edges(), default_init),
      faces_(this->connectivity().number_of_faces(), default_init)
  {
    if (keeps_bounds)
      bounds_ = Cotangent_bounds(this->connectivity());
  }

  // \param points of the vertices. The copier brings the faces
  template <class ConcurrencyTag, class Copier>
  void measure_points(Point_vector&& points, Copier& copier)
  {
    exponent_ = normalize_points<ConcurrencyTag>(points, Is_used_vertex{connectivity()});
    construct_metric_from_points<ConcurrencyTag>(connectivity(), copier, traits_, points, edges_, faces_, bounds_);
    if constexpr (uses_exact_geometry)
      engine_.keep_input(Input_metric::from_normalized_points(std::move(points), exponent_));
  }
  void measure_lengths(std::vector<FT>&& lengths)
  {
    exponent_ = normalize_lengths(lengths);
    construct_metric_from_lengths(connectivity(), traits_, lengths, edges_, faces_);
    bound_corners();
    if constexpr (uses_exact_geometry)
      engine_.keep_input(Input_metric::from_normalized_lengths(std::move(lengths), exponent_));
  }
  void measure_input(Input_metric&& metric)
  {
    metric.check(connectivity());
    exponent_ = metric.unit_exponent();
    construct_metric_from_input(connectivity(), traits_, metric, edges_, faces_);
    bound_corners();
    engine_.keep_input(std::move(metric));
  }

  Exact_engine& engine() { return engine_; }
  const Exact_engine& engine() const { return engine_; }
  const Delta_complex& connectivity() const { return engine_.connectivity(); }
  const Traits& traits() const { return traits_; }
  const Edge_data& edge_data(Edge_index e) const { return edges_[e.idx()]; }
  const Face_data& face_data(Face_index f) const { return faces_[f.idx()]; }
  const Cotangent_bounds& bounds() const { return bounds_; }
  int unit_exponent() const { return exponent_; }
  std::uint64_t number_of_filter_decisions() const { return number_of_filter_decisions_; }
  void count_filter_decisions(std::uint64_t number) { number_of_filter_decisions_ += number; }

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
    bound_corners_of_flipped(traits_, around, old, flipped, bounds_);
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
  // New vertices: nothing is flipped.

  // Splits a face into three by a new vertex.
  // \param piece the piece of the face that contains the vertex, between the input edges that cross it
  // \param location where the vertex lies: strictly inside a face of the input, and inside of the piece. The metric is
  //   not changed: its coordinates are taken as exact once they are divided by their sum
  // \return the new vertex, as `split_face(piece.side)` of `Delta_complex`
  // \exception Integer_overflow_error as `flip()` of `Normal_coordinates`
  Vertex_index split_face(const Triangle_piece& piece, const Surface_point& location)
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
      engine_.prepare();
      const Correspondence& correspondence = engine_.correspondence();
      const Delta_complex& input = internal::input(correspondence);
      const Halfedge_index h = connectivity().halfedge(f);
      for (Halfedge_index side : {h, connectivity().next(h), connectivity().prev(h)})
        if (side.idx() >= input.number_of_halfedges() || input.face(side) != f ||
            crossings(correspondence, edge(side)) >= 0 || input_halfedge(correspondence, side) != side ||
            edges_[edge(side).idx()] != saved.squared_lengths[edge(side).idx()])
          return false;
      return true;
    };
    saved.restore(engine_, block_runner<ConcurrencyTag>(), is_known);
    edges_ = std::move(saved.squared_lengths);
    faces_.resize(connectivity().number_of_faces(), default_init);
    bounds_ = Cotangent_bounds(connectivity());
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
    const Exact_engine::Corner &b = parts[1].second, &c = parts[2].second;
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
    CGAL_precondition(engine_.keeps_input());
    engine_.prepare();
    const Halfedge_index h = quickest_side(engine_, f);
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
    CGAL_precondition(engine_.keeps_input());
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
    std::optional<Exact_engine::Opposite_corners> corners;
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
    Exact_engine::Forgotten forgotten;
  };
  BOOST_NOINLINE Replaced replaced(const Hinge_halfedges& around) const
  {
    return {numbers_of_face(around.ij), numbers_of_face(around.ji), engine_.forgotten_by_flip(around)};
  }

  // Undoes the last flip that was not undone yet; restores all stored numbers. Never throws.
  // \param around the halfedges around the edge before the flip
  void flip_back(const Hinge_halfedges& around, const Replaced& before)
  {
    engine_.flip_back(around, before.forgotten);
    put_back(around.ij, before.ijk);
    put_back(around.ji, before.jil);
  }

private:
  Edge_index edge(Halfedge_index h) const { return connectivity().edge(h); }

  // Corners, each after its opposite side.
  using Corners = std::vector<std::pair<Halfedge_index, Exact_engine::Corner>>;

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

  // Recomputed from their points, faces are as accurate as before the first flip.
  void measure_straight_faces(const Hinge_halfedges& around)
  {
    const Face_measurer<Sequential_tag, Traits> measurer(connectivity(), traits_, engine_.metric().points(), edges_,
                                                         faces_, bounds_);
    const Face_halfedges one(connectivity(), around.ij), two(connectivity(), around.ji);
    const auto is_accurate = traits_.is_accurate_object();
    const auto measures = [&](const Face_halfedges& face) {
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
    if constexpr (Takes_two_faces<Traits>::value)
      if (measures_one && measures_two)
        return void(measurer.measure(one, two));
    if (measures_one)
      measurer.measure(one);
    if (measures_two)
      measurer.measure(two);
  }

  bool recompute(Halfedge_index h, const Exact_engine::Corner& c)
  {
    const Face_data face = refined_face(c);
    if (!is_reliable(face))
      return false;
    replace(h, c, face);
    return true;
  }

  Face_data refined_face(const Exact_engine::Corner& c) const
  {
    return traits_.construct_refined_data_object()(c.four_areas, c.s_first, c.s_second, c.s_opposite);
  }
  static bool is_reliable(const Face_data& face) { return face.error < std::numeric_limits<double>::infinity(); }

  void replace(Halfedge_index h, const Exact_engine::Corner& c) { replace(h, c, refined_face(c)); }
  // Unreliable numbers are not stored for the sides, which other faces share.
  void replace(Halfedge_index h, const Exact_engine::Corner& c, const Face_data& face)
  {
    if (is_reliable(face)) {
      const auto refined = traits_.construct_refined_data_object();
      edges_[edge(connectivity().prev(h)).idx()] = refined(c.s_first);
      edges_[edge(connectivity().next(h)).idx()] = refined(c.s_second);
      edges_[edge(h).idx()] = refined(c.s_opposite);
    }
    faces_[connectivity().face(h).idx()] = face;
    bound_corners(h);
  }

  // Afterwards a split does not throw.
  void make_room_for_vertex()
  {
    make_room(edges_, 3);
    make_room(faces_, 2);
    if (keeps_bounds)
      bounds_.make_room(3);
  }

  // Computes the numbers of all faces around a vertex that was just inserted.
  // \param undo removes it again
  template <class Undo>
  void measure_star(Vertex_index v, const Undo& undo)
  {
    const std::size_t number_of_new_edges = connectivity().number_of_edges() - edges_.size();
    edges_.resize(connectivity().number_of_edges(), default_init);
    faces_.resize(connectivity().number_of_faces(), default_init);
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
  static Exact_engine::Corner triangle(const Number& four_areas, const Number& s_first, const Number& s_second,
                                       const Number& s_opposite)
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
    const auto at = [&](Halfedge_index side) -> const Exact_engine::Corner& {
      return std::find_if(parts.begin(), parts.end(), [&](const auto& part) { return part.first == side; })->second;
    };
    Corners result;
    for (const Straight_line& line : sides) {
      if (connectivity().is_border(line.first))
        continue;
      const Exact_engine::Corner &a = at(connectivity().prev(line.first)), &b = at(connectivity().next(line.second));
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

  // Checks the edge that a flip has made. An exception undoes the flip.
  BOOST_NOINLINE void check_length(const Hinge_halfedges& around, const Replaced& before)
  {
    try {
      if (engine_.has_length_zero(edge(around.ij)))
        throw_no_length(connectivity(), edge(around.ij));
    } catch (...) {
      flip_back(around, before);
      throw;
    }
  }

  Exact_engine engine_; // which has the connectivity
  Traits traits_;
  // Left uninitialized until they are filled: one more pass would be measurable.
  Large_vector<Edge_data> edges_;
  Large_vector<Face_data> faces_;
  Cotangent_bounds bounds_; // empty if the traits have none
  int exponent_ = 0;
  std::uint64_t number_of_filter_decisions_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_MEASURED_TRIANGULATION_H

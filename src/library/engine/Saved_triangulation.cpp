// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definition of Saved_triangulation: a triangulation from a file, which is not trusted.

#include <CGAL/Intrinsic_triangulations/internal/engine/Saved_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include "Exact_engine_memory.h"
#include "Side_and_corner.h"
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "decide/Ladder.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "history/check_correspondence.h"
#include "layout/metric_images.h"
#include "layout/Metric_frame.h"
#include "layout/Strip.h"
#include "layout/Unfolding.h"
#include "../arithmetic/Mpfr_interval.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Checks the angles at an inserted vertex and its neighbors. Errors are full turns.
// \param input_angle, angles at the source of an input halfedge; opposite to the halfedges
template <class Input_angle>
void check_angle_sum(const Exact_engine& engine, Vertex_index v, const Input_angle& input_angle,
                     const Large_vector<double>& angles)
{
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex &complex = engine.connectivity(), &input = correspondence.input();
  bool is_concerned = correspondence.is_inserted(v), is_on_border = false;
  double sum = 0, expected = 0;
  for (Halfedge_index h : Halfedges_around(complex, v)) {
    is_concerned = is_concerned || correspondence.is_inserted(complex.source(h));
    if (complex.is_border(h))
      is_on_border = true;
    else
      sum += angles[complex.prev(h).idx()]; // between h and the next one
  }
  if (!is_concerned)
    return;
  if (correspondence.is_inserted(v))
    expected = is_on_border ? CGAL_PI : 2 * CGAL_PI;
  else
    for (Halfedge_index h : Halfedges_around(input, v))
      if (!input.is_border(input.opposite(h)))
        expected += input_angle(input.opposite(h));
  if (!(std::abs(sum - expected) < 1))
    throw_not_a_triangulation("vertex", v.idx(), "has angles that sum to more or less than those of the surface there");
}

// If a bound is infinite or too wide, no decision relies on the numbers, but queries return them. Numbers that are not
// close to the true ones, as after many flips of thin faces, are replaced.
constexpr double near_to_truth = 0x1p-10;

std::vector<bool> bounded_faces(const Delta_complex& complex, const std::function<double(Edge_index)>& squared_length,
                                const std::function<double(Face_index)>& error)
{
  std::vector<bool> result;
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    double sum = 0;
    for (Halfedge_index side : {h, complex.next(h), complex.prev(h)})
      sum += squared_length(complex.edge(side));
    const double bound = error(f);
    // Comparisons with NaN are false.
    result.push_back(bound <= near_to_truth * sum && bound < std::numeric_limits<double>::infinity());
  }
  return result;
}

// The center of a number's bounds, and their distance from it.
inline double middle_of(const Bounded_double_double& x) { return x.hi(); }
inline double middle_of(const Mpfr_interval& x) { return x.lower_double() + (x.upper_double() - x.lower_double()) / 2; }
inline double width_of(const Bounded_double_double& x) { return std::abs(x.lo()) + x.error(); }
inline double width_of(const Mpfr_interval& x) { return x.upper_double() - x.lower_double(); }

// The least and the largest possible distance of a stored number from the true one.
struct Deviation
{
  double least, most;
};
inline Deviation deviation(double stored, const Bounded_double_double& x)
{
  const double d = std::abs(stored - x.hi());
  return {(std::max)(0., d - width_of(x)), d + width_of(x)};
}
inline Deviation deviation(double stored, const Mpfr_interval& x)
{
  const Mpfr_interval d = x - Mpfr_interval(data(Rational(stored)), x.precision());
  const auto [least, most] = std::minmax({std::abs(d.lower_double()), std::abs(d.upper_double())});
  return {is_certain(d.sign()) ? least : 0, most};
}

// Calls settles(side, corner opposite to it) with the numbers of a face and more and more digits until it returns true.
template <class Settles>
void settle_precisely(const Exact_engine& engine, Face_index f, Input_surface& surface, const Settles& settles)
{
  const Halfedge_index h = quickest_side(engine, f);
  bool is_settled = false;
  for (long precision = 256; !is_settled; precision = doubled(precision)) {
    Mpfr_metric& metric = surface.mpfr_metric(precision);
    is_settled =
      settles(h, Unfolding<Mpfr_metric>(engine.connectivity(), engine.correspondence(), metric).opposite_corner(h));
  }
}

inline void mend_face(const Exact_engine& engine, Face_index f, Input_surface& surface,
                      const std::vector<bool>& are_bounded, Large_vector<double>& squared_lengths,
                      Large_vector<std::array<double, 2>>& areas)
{
  const Delta_complex& complex = engine.connectivity();
  const auto mend = [&](Halfedge_index side, const auto& corner) {
    const std::array<std::pair<Halfedge_index, decltype(&corner.p)>, 3> sides{
      {{side, &corner.s_opposite}, {complex.next(side), &corner.s_second}, {complex.prev(side), &corner.s_first}}};
    constexpr double narrow = 0x1p-32;
    double sum = 0;
    for (const auto& [h, s] : sides) {
      sum += middle_of(*s);
      if (!(width_of(*s) <= narrow * middle_of(*s)))
        return false;
    }
    if (!(width_of(corner.four_areas) <= narrow * sum))
      return false;
    for (const auto& [h, s] : sides) {
      const Halfedge_index g = complex.opposite(h);
      double& stored = squared_lengths[complex.edge(h).idx()];
      if ((complex.is_border(g) || !are_bounded[complex.face(g).idx()]) &&
          !(std::abs(stored - middle_of(*s)) <= near_to_truth * middle_of(*s)))
        stored = middle_of(*s);
    }
    if (double& area = areas[f.idx()][0]; !(std::abs(area - middle_of(corner.four_areas)) <= near_to_truth * sum))
      area = middle_of(corner.four_areas);
    return true;
  };
  Double_double_metric metric(surface);
  const Halfedge_index h = quickest_side(engine, f);
  if (!mend(h, Unfolding<Double_double_metric>(complex, engine.correspondence(), metric).opposite_corner(h)))
    settle_precisely(engine, f, surface, mend);
}

void mend_unbounded(const Exact_engine& engine, const std::vector<bool>& are_bounded,
                    Large_vector<double>& squared_lengths, Large_vector<std::array<double, 2>>& areas)
{
  const Standard_arithmetic arithmetic;
  const Surface_lease surface = engine.input_surface();
  for (Face_index f : engine.connectivity().faces())
    if (!are_bounded[f.idx()])
      mend_face(engine, f, *surface, are_bounded, squared_lengths, areas);
}

// See Saved_triangulation::restore().
class Engine_restorer
{
public:
  explicit Engine_restorer(Exact_engine& engine)
    : engine_(engine), complex_(engine.connectivity_), correspondence_(engine.memory_->correspondence),
      metric_(engine.metric()), numbers_(engine)
  {}

  void operator()(Saved_triangulation& saved, const Block_runner& run, const std::function<bool(Face_index)>& is_known);

private:
  using Side_and_corner = Engine_numbers::Side_and_corner<Bounded_double_double>;
  // Whether the ends of the edges that h crosses lie on its two sides, or partly on h, or neither.
  enum class Line_check {
    STRAIGHT,
    TOUCHING,
    BENT
  };

  void check_line(Edge_index e) const;
  Line_check check_sides(Halfedge_index h, const Crossed_halfedges& crossed) const;
  Face_index plane(Face_index f) const;
  void find_angles(Face_index f, const Side_and_corner& at, Input_surface& surface, Large_vector<double>& angles) const;
  bool are_sound(Face_index f, const Saved_triangulation& saved, const Side_and_corner& at,
                 Input_surface& surface) const;

  Exact_engine& engine_;
  Delta_complex& complex_;
  Correspondence& correspondence_;
  const Input_metric& metric_;
  const Engine_numbers numbers_;
};

void Saved_triangulation::restore(Exact_engine& engine, const Block_runner& run,
                                  const std::function<bool(Face_index)>& is_known)
{
  Engine_restorer{engine}(*this, run, is_known);
}

// The edges of the triangulation are lines through the input triangles that the integers name: then the faces between
// them are the triangles that are laid out, as they are up to isotopy (see Correspondence_check). Inserted vertices are
// no part of that isotopy: faces at them must not be inverted, and the angles at them and at their neighbors must sum
// to those of the surface, as faces could be wound around a vertex twice.
void Engine_restorer::operator()(Saved_triangulation& saved, const Block_runner& run,
                                 const std::function<bool(Face_index)>& is_known)
{
  const Standard_arithmetic arithmetic;
  engine_.prepare();
  Exact_engine::Memory& memory = *engine_.memory_;
  const std::size_t number_of_input_faces = complex_.number_of_faces(), number_of_points = metric_.points().size();
  Delta_complex input = correspondence_.input();
  correspondence_ = Correspondence(std::move(input), std::move(saved.coordinates), std::move(saved.locations));
  complex_ = std::move(saved.connectivity);
  memory.straight_faces =
    Straight_faces(number_of_input_faces, number_of_points, std::vector<Face_index>(complex_.number_of_faces()));
  for (Flip_log::Reader reader : {Flip_log::FACES, Flip_log::NUMBERS})
    memory.log.follow(reader);

  Correspondence_check check(complex_, correspondence_, engine_.decisions().interruption);
  check.check_locations();
  if (number_of_points != 0)
    for (const Surface_point& location : correspondence_.locations())
      memory.inserted_positions.push_back(engine_.positions().rounded(location));
  check(run);
  // In portions, so that cached crossings take no more memory than the bytes read.
  const auto for_each = [&](std::size_t n, const auto& number_of_crossings, const auto& f) {
    constexpr std::int64_t most_kept = std::int64_t(1) << 22;
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
      for (std::int64_t sum = 0; end < n && sum < most_kept; ++end)
        sum += number_of_crossings(std::uint32_t(end));
      run(end - begin, elements_of_block, [&](std::size_t first, std::size_t last) {
        const Surface_lease surface = engine_.input_surface();
        for (std::size_t i = begin + first; i < begin + last; ++i)
          f(std::uint32_t(i), *surface);
      });
      correspondence_.forget_crossings();
    }
  };
  const Normal_coordinates& coordinates = correspondence_.coordinates();
  const auto at_edge = [&](std::uint32_t e) { return coordinates.number_of_crossings(Edge_index(e)); };
  const auto at_face = [&](std::uint32_t f) {
    const Halfedge_index h = complex_.halfedge(Face_index(f));
    std::int64_t sum = 0;
    for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
      sum += coordinates.number_of_crossings(complex_.edge(side));
    return sum;
  };
  for_each(complex_.number_of_edges(), at_edge, [&](std::uint32_t e, Input_surface&) { check_line(Edge_index(e)); });

  const bool has_inserted = !correspondence_.locations().empty();
  const std::vector<bool> are_bounded = bounded_faces(
    complex_, [&](Edge_index e) { return saved.squared_lengths[e.idx()]; },
    [&](Face_index f) { return saved.areas[f.idx()][1]; });
  Large_vector<double> angles(has_inserted ? complex_.number_of_halfedges() : 0, default_init);
  std::vector<Face_index> planes(complex_.number_of_faces());
  const auto corner_of = [&](Face_index f, Input_surface& surface) {
    Double_double_metric metric(surface);
    return numbers_.quickest_corner(f, Unfolding<Double_double_metric>(complex_, correspondence_, metric));
  };
  const auto check_numbers = [&](Face_index f, const auto& corner, Input_surface& surface) {
    if (!are_sound(f, saved, corner, surface))
      throw_not_a_triangulation("face", f.idx(),
                                "has an area or sides that differ from the true ones by more than its bound");
  };
  for_each(complex_.number_of_faces(), at_face, [&](std::uint32_t i, Input_surface& surface) {
    const Face_index f(i);
    if (number_of_points != 0 && saved.is_straight[i])
      planes[i] = plane(f);
    const bool has_open_numbers = are_bounded[i] && !is_known(f);
    if (!has_inserted && !has_open_numbers)
      return;
    const auto corner = corner_of(f, surface);
    if (has_inserted)
      find_angles(f, corner, surface, angles);
    if (has_open_numbers)
      check_numbers(f, corner, surface);
  });
  memory.straight_faces = Straight_faces(number_of_input_faces, number_of_points, planes);
  const auto angle_in_input = [&](Halfedge_index h) {
    const auto in_space = rounded_ratios_in_space(correspondence_.input(), metric_.points(), h);
    return in_space ? std::atan2(in_space->at_source.y().hi(), in_space->at_source.x().hi()) : numbers_.input_angle(h);
  };
  if (has_inserted)
    run(complex_.number_of_vertices(), elements_of_block, [&](std::size_t first, std::size_t last) {
      engine_.decisions().interruption.check();
      for (std::size_t v = first; v < last; ++v)
        check_angle_sum(engine_, Vertex_index(std::uint32_t(v)), angle_in_input, angles);
    });
  mend_unbounded(engine_, are_bounded, saved.squared_lengths, saved.areas);
  const Surface_lease surface = engine_.input_surface();
  for (Face_index f : complex_.faces())
    if (!are_bounded[f.idx()] && saved.areas[f.idx()][1] != std::numeric_limits<double>::infinity()) // nor NaN
      check_numbers(f, corner_of(f, *surface), *surface);
}

// The angles opposite to the sides of a face, accurate enough to distinguish full turns. A face without area has angles
// of 0 and π.
void Engine_restorer::find_angles(Face_index f, const Side_and_corner& at, Input_surface& surface,
                                  Large_vector<double>& angles) const
{
  const Halfedge_index h = at.side, next = complex_.next(h), prev = complex_.prev(h);
  if (certainly(at.corner.four_areas.sign() == POSITIVE)) {
    const Bounded_double_double &four_areas = at.corner.four_areas, &p = at.corner.p, &s = at.corner.s_first,
                                &t = at.corner.s_second;
    const std::array<std::pair<Halfedge_index, Bounded_double_double>, 3> corners{
      {{h, p}, {next, s + (s - p)}, {prev, t + (t - p)}}};
    bool are_good = true;
    for (const auto& [side, q] : corners) {
      angles[side.idx()] = std::atan2(four_areas.hi(), q.hi());
      are_good = are_good && four_areas.error() + q.error() <= near_to_truth * (four_areas.hi() + std::abs(q.hi()));
    }
    if (are_good)
      return;
  } else if (engine_.sign_of_area(f, surface) == NEGATIVE)
    throw_not_a_triangulation("face", f.idx(), "is inverted");
  for (Halfedge_index side : {h, next, prev})
    angles[side.idx()] = numbers_.angle(side);
}

// The invariants of Filtered_edge_length_traits.
bool Engine_restorer::are_sound(Face_index f, const Saved_triangulation& saved, const Side_and_corner& at,
                                Input_surface& surface) const
{
  const double area = saved.areas[f.idx()][0], bound = saved.areas[f.idx()][1];
  const Halfedge_index h = complex_.halfedge(f);
  bool are_finite = std::isfinite(area) && bound >= 0;
  for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
    are_finite = are_finite && std::isfinite(saved.squared_lengths[complex_.edge(side).idx()]);
  if (!are_finite)
    return false;
  constexpr double u = 0x1p-53, rounded_up = 1 + 0x1p-40;
  bool result = false;
  const auto compare = [&](Halfedge_index side, const auto& corner) {
    Deviation of_sides{0, 0};
    double sum = 0;
    const auto add = [&](Halfedge_index g, const auto& s) {
      const double stored = saved.squared_lengths[complex_.edge(g).idx()];
      const Deviation d = deviation(stored, s);
      of_sides.least += (std::max)(d.least, 6 * u * stored);
      of_sides.most += (std::max)(d.most, 6 * u * stored);
      sum += stored;
    };
    add(side, corner.s_opposite);
    add(complex_.next(side), corner.s_second);
    add(complex_.prev(side), corner.s_first);
    const Deviation of_area = deviation(area, corner.four_areas);
    const auto is_bound = [&](double sides, double of_areas) {
      return bound >= rounded_up * 1.5 * sides && bound >= rounded_up * 1.5 * of_areas &&
             bound >= rounded_up * 12 * u * sum && sum >= 0;
    };
    result = is_bound(of_sides.most, of_area.most);
    return result || !is_bound(of_sides.least, of_area.least);
  };
  if (!compare(at.side, at.corner))
    settle_precisely(engine_, f, surface, compare);
  return result;
}

// Checks that an edge begins and ends in the input faces that the integers name, and that each input edge that it
// crosses has one end on either side.
void Engine_restorer::check_line(Edge_index e) const
{
  const std::int64_t n = correspondence_.coordinates().crossings(e);
  if (n < 0)
    return;
  const auto fail = [&](const std::string& what) { throw_not_a_triangulation("edge", e.idx(), what); };
  const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
  const Face_index first = uncrossed_input_face(complex_, correspondence_, h),
                   last = uncrossed_input_face(complex_, correspondence_, g);
  if (!first.is_valid() || !last.is_valid())
    fail("leaves the surface");
  bool has_length = false;
  if (n == 0) {
    if (first != last)
      fail("crosses no input edge, and its ends lie in different input faces");
    if (!correspondence_.is_inserted(complex_.source(h)) && !correspondence_.is_inserted(complex_.target(h)))
      fail("joins two corners of one input face, and is none of its sides");
  } else {
    const Crossed_halfedges crossed(complex_, correspondence_, h, engine_.decisions().interruption);
    const Delta_complex& input = correspondence_.input();
    if (input.face(input.opposite(crossed.front())) != first || input.face(crossed[crossed.size() - 1]) != last)
      fail("does not begin and end in the input faces that its ends lie in");
    const Line_check check = check_sides(h, crossed);
    if (check == Line_check::BENT)
      fail("is no straight line over the input triangles");
    has_length = check == Line_check::STRAIGHT;
  }
  if (!has_length) {
    Double_metric doubles(correspondence_.input(), metric_, engine_.decisions().interruption);
    has_length =
      certainly(Unfolding<Double_metric>(complex_, correspondence_, doubles).squared_length(e).sign() == POSITIVE);
  }
  if (!has_length && engine_.has_length_zero(e))
    fail("has length zero");
}

Engine_restorer::Line_check Engine_restorer::check_sides(Halfedge_index h, const Crossed_halfedges& crossed) const
{
  // Twice the area to an end of a crossed edge: positive if it lies on the right side. Calls visit(area) until that
  // returns `false`.
  const auto for_each_area = [&](auto& metric, const auto& visit) {
    using Metric = std::decay_t<decltype(metric)>;
    using Frame = Metric_frame<Metric>;
    Strip<Frame> strip(correspondence_.input(), Frame(correspondence_.input(), metric));
    Unfolding<Metric>(complex_, correspondence_, metric).lay_out(strip, h, crossed);
    strip.for_each_crossing(
      [&](const auto& areas, const auto&, const auto&) { return visit(areas.left) && visit(areas.right); });
  };
  std::vector<std::size_t> open; // by the number of areas
  const auto find_open = [&](auto& metric) {
    bool is_bent = false;
    std::size_t i = 0;
    open.clear();
    for_each_area(metric, [&](const auto& area) {
      const Uncertain<Sign> sign = area.sign();
      is_bent = certainly(sign == NEGATIVE);
      if (!certainly(sign == POSITIVE))
        open.push_back(i);
      ++i;
      return !is_bent;
    });
    return is_bent ? Line_check::BENT : Line_check::STRAIGHT;
  };
  Double_metric doubles(correspondence_.input(), metric_, engine_.decisions().interruption);
  Line_check result = find_open(doubles);
  if (result == Line_check::BENT || open.empty())
    return result;
  const Surface_lease surface = engine_.input_surface();
  Double_double_metric double_doubles(*surface);
  result = find_open(double_doubles);
  for (std::size_t i = 0; i < open.size() && result != Line_check::BENT; ++i) {
    const auto area = [&](auto& metric) {
      std::optional<typename std::decay_t<decltype(metric)>::Real> found;
      std::size_t number = 0;
      for_each_area(metric, [&](const auto& each) {
        if (number++ == open[i])
          found = each;
        return !found;
      });
      return *found;
    };
    const Sign sign = exact_sign(*surface, area, [&] {
      return "that edge " + std::to_string(complex_.edge(h).idx()) + " runs through a vertex of the input";
    });
    result = sign == POSITIVE ? result : sign == ZERO ? Line_check::TOUCHING : Line_check::BENT;
  }
  return result;
}

// An input face whose plane contains all input faces that share points with a face, or the null face. All of these meet
// its sides.
Face_index Engine_restorer::plane(Face_index f) const
{
  const Delta_complex& input = correspondence_.input();
  Face_index result;
  const auto lies_in_it = [&](Face_index g) {
    if (!result.is_valid())
      result = g;
    return result == g || have_one_plane(input, metric_.points(), result, g);
  };
  const Halfedge_index h = complex_.halfedge(f);
  for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)}) {
    if (!lies_in_it(uncrossed_input_face(complex_, correspondence_, side)))
      return {};
    if (correspondence_.coordinates().number_of_crossings(complex_.edge(side)) == 0)
      continue;
    const Crossed_halfedges crossed(complex_, correspondence_, side, engine_.decisions().interruption);
    for (std::size_t i = 0; i < crossed.size(); ++i)
      if (!lies_in_it(input.face(crossed[i])))
        return {};
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

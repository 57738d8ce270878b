// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of trace_geodesic.h.

#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include "../engine/decide/Ladder.h"
#include "../engine/layout/Metric_frame.h"
#include "../engine/layout/metric_images.h"
#include "Line_layout.h"
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "../engine/layout/Strip.h"
#include "../positions/Crossing_locator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Follows a line from face to face.
template <class Faces>
class Geodesic_tracer
{
public:
  Geodesic_tracer(const Faces& faces, const Exact_engine& engine, const Surface_direction& start, double length,
                  std::size_t maximum_number)
    : faces_(faces), complex_(faces.complex), engine_(engine), surface_(engine.input_surface()), metric_(*surface_),
      start_(start), layout_(faces, metric_), wanted_(length), maximum_number_(maximum_number)
  {}

  Traced_geodesic operator()()
  {
    using Real = Bounded_double_double;
    const Delta_complex& input = engine_.correspondence().input();
    const Real speed = sqrt(layout_.squared_speed() * metric_.squared_length(input.edge(layout_.unit())));
    speed_ = std::ldexp(speed.hi(), engine_.metric().unit_exponent());
    if (!(speed_ > 0))
      throw Invalid_point_error("a line needs a direction: the displacement is zero, or too small");
    begin();
    result_.points.push_back(before_);
    bool goes_on = leave_first_face();
    for (std::size_t i = 1; goes_on; ++i) {
      if (i % 64 == 0)
        engine_.decisions().interruption.check();
      if (i >= maximum_number_) {
        result_.status = Trace_status::BUDGET_EXHAUSTED;
        break;
      }
      goes_on = is_at_source_ ? leave_source() : cross_face();
    }
    return std::move(result_);
  }

private:
  // The sign of a number that a layout computes.
  template <class Compute>
  Sign sign(const Compute& compute)
  {
    const Uncertain<Sign> quick = compute(layout_).sign();
    if (is_certain(quick))
      return get_certain(quick);
    const auto evaluate = [&](auto& metric) {
      Line_layout<Faces, std::decay_t<decltype(metric)>> layout(faces_, metric);
      for (std::size_t i = 0; i < moves_.size(); ++i) {
        if (i % 64 == 63)
          metric.interruption().check();
        layout.move(moves_[i]);
      }
      return compute(layout);
    };
    return exact_sign(*surface_, evaluate, [&] {
      return "a line from a point of input face " +
             std::to_string(engine_.correspondence().input().face(start_.point.halfedge).idx()) +
             ": that it meets a vertex";
    });
  }
  Sign side_of_corner(int i)
  {
    return sign([i](auto& layout) { return layout.side_of_corner(i); });
  }
  Sign side_of_start(int i)
  {
    return sign([i](auto& layout) { return layout.side_of_start(i); });
  }
  Sign side_of_direction(int i)
  {
    return sign([i](auto& layout) { return layout.side_of_direction(i); });
  }

  void move(int side, bool is_crossed)
  {
    moves_.push_back({std::uint8_t(side), is_crossed});
    layout_.move(moves_.back());
  }
  // Makes a corner of the face the first one.
  void turn_to_corner(int i)
  {
    if (i > 0)
      move(i, false);
  }

  Halfedge_index side(int i) const
  {
    Halfedge_index h = layout_.entered();
    for (; i > 0; --i)
      h = complex_.next(h);
    return h;
  }
  bool is_border(int i) const { return complex_.is_border(complex_.opposite(side(i))); }

  // Goes to a face that contains the start and into which the direction points.
  void begin()
  {
    if constexpr (!Faces::has_divisors) {
      const auto& b = start_.point.coordinates;
      before_ = {start_.point.halfedge, with_sum_one(b)};
      for (int i = 0; i < 3; ++i)
        is_start_[i] = b[(i + 1) % 3] == 0 && b[(i + 2) % 3] == 0;
    } else if (faces_.begins_at_input_vertex()) {
      while (side_of_direction(2) == NEGATIVE) // counterclockwise around the vertex
        move(2, true);
      begin_at_source();
    } else {
      std::array<bool, 3> is_on_side{};
      for (int i = 0; i < 3; ++i)
        is_on_side[i] = side_of_start(i) == ZERO;
      for (int i = 0; i < 3; ++i)
        if (is_on_side[i] && is_on_side[(i + 2) % 3]) {
          turn_to_corner(i);
          if (!turn_to_direction())
            throw Invalid_point_error("the direction leaves the surface at once");
          return begin_at_source();
        }
      for (int i = 0; i < 3; ++i)
        if (is_on_side[i] && side_of_direction(i) == NEGATIVE) {
          move(i, true);
          is_on_side = {true, false, false};
          break;
        }
      std::array<double, 3> b = layout_.coordinates_of_start();
      double sum = 0;
      for (int i = 0; i < 3; ++i)
        sum += b[(i + 2) % 3] = is_on_side[i] ? 0 : (std::max)(b[(i + 2) % 3], smallest);
      before_ = {layout_.entered(), {b[0] / sum, b[1] / sum, b[2] / sum}};
    }
  }
  void begin_at_source()
  {
    is_start_[0] = true;
    before_ = {layout_.entered(), {1, 0, 0}};
  }

  // Returns whether the line goes on.
  bool leave_first_face()
  {
    std::array<Sign, 3> side{};
    for (int i = 0; i < 3; ++i)
      side[i] = is_start_[i] ? ZERO : side_of_corner(i);
    for (int i = 0; i < 3; ++i)
      if (side[i] == NEGATIVE && side[(i + 1) % 3] == POSITIVE)
        return leave(i);
    for (int i = 0; i < 3; ++i) {
      const Sign right = side[(i + 2) % 3], left = side[(i + 1) % 3];
      if (side[i] == ZERO && !is_start_[i] && right != POSITIVE && left != NEGATIVE && right != left)
        return reach_vertex(i);
    }
    throw Invalid_point_error("face " + std::to_string(complex_.face(layout_.entered()).idx()) +
                              " has zero area: a line cannot begin there");
  }

  // Goes through the face that was entered across its first side.
  bool cross_face()
  {
    const Sign side = side_of_corner(2);
    if (side == ZERO)
      return reach_vertex(2);
    return leave(side == NEGATIVE ? 2 : 1); // past the third corner, which is on the right or on the left
  }

  // Leaves the first corner of a face, through its inside or along one of the two sides.
  bool leave_source()
  {
    is_at_source_ = false;
    for (int i : {1, 2})
      if (side_of_corner(i) == ZERO)
        return reach_vertex(i);
    return leave(1);
  }

  // Turns around the first corner of the face, where the surface is flat, to the face into which the direction points.
  // Returns whether there is one.
  bool turn_to_direction()
  {
    const Halfedge_index begin = layout_.entered();
    while (!leads_into_face()) { // counterclockwise
      if (is_border(2))
        return (side_of_direction(0) == POSITIVE && side_of_direction(2) == ZERO) || // along the border
               turn_clockwise();
      move(2, true);
      if (layout_.entered() == begin) // all faces have zero area
        return false;
    }
    return true;
  }
  bool turn_clockwise()
  {
    while (!is_border(0)) {
      move(0, true);
      turn_to_corner(1);
      if (leads_into_face())
        return true;
    }
    return false;
  }
  // Whether the direction points between the first side, inclusive, and the last one.
  bool leads_into_face() { return side_of_direction(0) != NEGATIVE && side_of_direction(2) == POSITIVE; }

  // Ends the line before or on a side of its current face, or takes it across that side.
  bool leave(int i)
  {
    const Halfedge_index h = side(i);
    const bool is_at_border = is_border(i);
    move(i, true);
    // Both are positive, however near the line comes to a vertex.
    const double left = (std::max)(layout_.side_of_corner(0).hi(), smallest),
                 right = (std::max)(-layout_.side_of_corner(1).hi(), smallest);
    const double of_left = (std::max)(right / (left + right), smallest),
                 of_right = (std::max)(left / (left + right), smallest);
    const Surface_point exit{h, {of_right, of_left, 0}};
    const double at = (std::max)(result_.length, layout_.crossing().hi() * speed_);
    if (!(at < wanted_))
      return end_between(exit, at);
    result_.length = at;
    if (is_at_border)
      return end(Trace_status::AT_BORDER, exit);
    before_ = {layout_.entered(), {of_left, of_right, 0}};
    result_.points.push_back(before_);
    return true;
  }

  bool reach_vertex(int i)
  {
    Surface_point corner{layout_.entered(), {0, 0, 0}};
    corner.coordinates[std::size_t(i)] = 1;
    const double at = (std::max)(result_.length, layout_.along(i).hi() * speed_);
    if (wanted_ < at)
      return end_between(corner, at);
    result_.length = at;
    const Vertex_index v = complex_.source(side(i));
    if (!faces_.is_flat_at(v)) {
      result_.vertex = v;
      return end(Trace_status::AT_VERTEX, corner);
    }
    turn_to_corner(i);
    if (!turn_to_direction())
      return end(Trace_status::AT_BORDER, corner);
    is_at_source_ = true;
    before_ = {layout_.entered(), {1, 0, 0}};
    result_.points.push_back(before_);
    return true;
  }

  // Ends the line at the requested length, in the face between `before_` and a point of another side.
  bool end_between(const Surface_point& exit, double at)
  {
    const double t = at > result_.length ? (wanted_ - result_.length) / (at - result_.length) : 1;
    std::size_t shift = 0;
    for (Halfedge_index h = exit.halfedge; h != before_.halfedge; h = complex_.next(h))
      ++shift;
    Surface_point point = before_;
    for (std::size_t i = 0; i < 3; ++i)
      point.coordinates[i] = (1 - t) * before_.coordinates[i] + t * exit.coordinates[(i + shift) % 3];
    result_.length = wanted_;
    return end(Trace_status::AT_LENGTH, point);
  }

  bool end(Trace_status status, const Surface_point& point)
  {
    result_.status = status;
    result_.points.push_back(point);
    return false;
  }

  static constexpr double smallest = (std::numeric_limits<double>::min)();

  const Faces& faces_;
  const Delta_complex& complex_;
  const Exact_engine& engine_;
  Surface_lease surface_;
  Double_double_metric metric_;
  const Surface_direction& start_;
  Line_layout<Faces, Double_double_metric> layout_;
  double wanted_;
  std::size_t maximum_number_;
  double speed_ = 0;               // the length of the displacement, in the unit of the input
  Surface_point before_{};         // where the line entered the current face
  std::array<bool, 3> is_start_{}; // which corner of the first face
  bool is_at_source_ = false;      // whether it did so in the first corner
  std::vector<Line_move> moves_;   // from the first face to the current one
  Traced_geodesic result_;
};

inline void check_line(const Delta_complex& input, const Surface_direction& start, double length)
{
  const auto& b = start.point.coordinates;
  const Halfedge_index h = start.point.halfedge;
  if (!(h.idx() < input.number_of_halfedges()) || input.is_border(h))
    throw Invalid_point_error("the start of a line needs a halfedge of a face");
  const std::array<double, 3> d{-(start.displacement[0] + start.displacement[1]), start.displacement[0],
                                start.displacement[1]};
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(b[i]) || !std::isfinite(d[i]) || b[i] < 0)
      throw Invalid_point_error("the start of a line needs coordinates that are finite and not negative, and a finite "
                                "displacement");
    if (b[i] == 0 && d[i] < 0)
      throw Invalid_point_error("the direction leaves face " + std::to_string(input.face(h).idx()) +
                                " at once: give the start as a point of the face beyond");
  }
  if (!std::isfinite(b[0] + b[1] + b[2]) || !(b[0] + b[1] + b[2] > 0) || !(d[1] != 0 || d[2] != 0))
    throw Invalid_point_error("the start of a line needs a positive coordinate and a displacement other than zero");
  if (!std::isfinite(length) || length < 0)
    throw Invalid_argument_error("the length of a line has to be finite and not negative");
}

Traced_geodesic trace(const Exact_engine& engine, const Surface_direction& start, double length,
                      std::size_t maximum_number)
{
  const Standard_arithmetic arithmetic;
  const Delta_complex& input = engine.correspondence().input();
  check_line(input, start, length);
  const Input_faces faces(input, start);
  return Geodesic_tracer<Input_faces>(faces, engine, start, length, maximum_number)();
}

Traced_geodesic trace_in_triangulation(const Exact_engine& engine, const Surface_direction& start, double length,
                                       std::size_t maximum_number)
{
  const Standard_arithmetic arithmetic;
  check_line(engine.correspondence().input(), start, length);
  const Current_faces faces(engine, start);
  return Geodesic_tracer<Current_faces>(faces, engine, start, length, maximum_number)();
}

Surface_direction direction_at_vertex(const Exact_engine& engine, Halfedge_index h, double angle)
{
  const Delta_complex& input = engine.correspondence().input();
  if (!(h.idx() < input.number_of_halfedges()) || !std::isfinite(angle))
    throw Invalid_point_error("a direction at a vertex needs a halfedge and a finite angle");
  const Surface_lease surface = engine.input_surface();
  Double_double_metric metric(*surface);
  const Metric_frame<Double_double_metric> frame(input, metric);
  struct Fan_corner
  {
    Halfedge_index halfedge;
    double angle, ratio; // ratio of the sides' lengths
  };
  std::vector<Fan_corner> fan;
  double sum = 0;
  Halfedge_index g = h;
  do {
    if (input.is_border(g))
      break;
    const Double_double_disk z = frame.ratios(g).at_source;
    fan.push_back({g, std::atan2(z.y().hi(), z.x().hi()), std::hypot(z.x().hi(), z.y().hi())});
    sum += fan.back().angle;
    g = input.next_around_source(g);
  } while (g != h);
  const bool is_closed = g == h && !fan.empty();
  if (is_closed && (angle < 0 || angle >= sum)) {
    angle = std::fmod(angle, sum);
    if (angle < 0)
      angle += sum;
  }
  if (angle < 0 || fan.empty() || (!is_closed && angle > sum * (1 + 1e-15))) {
    const double most = std::floor(sum * 1e6) / 1e6; // a lower bound
    throw Invalid_point_error("at vertex " + std::to_string(input.source(h).idx()) +
                              ", the angle leads beyond the border: angles go from 0 to " + std::to_string(most));
  }
  std::size_t i = 0;
  while (i + 1 < fan.size() && angle > fan[i].angle)
    angle -= fan[i++].angle;
  // The direction with angle t is sin(α - t) : sin(t) in terms of unit vectors along the two sides.
  const double t = (std::min)(angle, fan[i].angle);
  return {{fan[i].halfedge, {1, 0, 0}}, {std::sin(fan[i].angle - t), std::sin(t) / fan[i].ratio}};
}

// A point on an edge, relative to a halfedge of that edge.
inline Surface_point point_on_side(const Delta_complex& input, const Surface_point& p, Halfedge_index side)
{
  const auto [at_source, at_target] = coordinates_on_edge(input, p, side);
  return {side, with_sum_one({at_source, at_target, 0})};
}

// The source of h in the input face into which h leaves it. \pre h runs along no input edge
inline Surface_point source_on_input(const Delta_complex& complex, const Correspondence& correspondence,
                                     Halfedge_index h)
{
  const Delta_complex& input = correspondence.input();
  const Vertex_index v = complex.source(h);
  const Halfedge_index roundabout = correspondence.input_halfedge(h);
  if (!correspondence.is_inserted(v))
    return {input.next(input.opposite(roundabout)), {1, 0, 0}};
  const Surface_point& p = correspondence.location(v);
  if (roundabout.is_valid()) // on an input edge
    return point_on_side(input, p, input.opposite(roundabout));
  return {p.halfedge, with_sum_one(p.coordinates)};
}

// An edge along an input edge, or a part of one.
inline void append_along_input_edge(const Delta_complex& complex, const Correspondence& correspondence,
                                    Halfedge_index h, std::vector<Surface_point>& points)
{
  const Delta_complex& input = correspondence.input();
  const Halfedge_index along = correspondence.input_halfedge(h);
  const bool is_turned = input.is_border(along);
  const Halfedge_index side = is_turned ? input.opposite(along) : along;
  const auto append = [&](Vertex_index v, double at_source) {
    points.push_back(correspondence.is_inserted(v) ? point_on_side(input, correspondence.location(v), side)
                                                   : Surface_point{side, {at_source, 1 - at_source, 0}});
  };
  append(complex.source(h), is_turned ? 0 : 1);
  append(complex.target(h), is_turned ? 1 : 0);
}

void append_input_points(const Exact_engine& engine, Halfedge_index h, std::vector<Surface_point>& points)
{
  const Delta_complex& complex = engine.connectivity();
  const Correspondence& correspondence = engine.correspondence();
  const Delta_complex& input = correspondence.input();
  if (correspondence.coordinates().is_original(complex.edge(h)))
    return append_along_input_edge(complex, correspondence, h, points);
  points.push_back(source_on_input(complex, correspondence, h));
  if (correspondence.coordinates().number_of_crossings(complex.edge(h)) > 0) {
    // Positions are those of the edge, in the direction of its own halfedge, which the overlay has as well.
    const bool is_backward = !is_in_own_direction(h);
    const Crossed_halfedges sequence(complex, correspondence, is_backward ? complex.opposite(h) : h,
                                     engine.decisions().interruption);
    const std::size_t n = sequence.size();
    Crossed_edges crossed;
    for (std::size_t i = 0; i < n; ++i)
      crossed.push_back(sequence[i]);
    const Surface_lease surface = engine.input_surface();
    Crossing_locator locator(complex, correspondence, *surface);
    const std::vector<Position_on_edges>& positions = locator(complex.edge(h), crossed);
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t j = is_backward ? n - 1 - i : i;
      // The halfedge that is crossed, with the entered face to its left.
      const Halfedge_index entered = is_backward ? input.opposite(crossed[j]) : crossed[j];
      const double t = positions[j].on_input_edge;
      const double from_source = is_in_own_direction(entered) ? t : 1 - t;
      points.push_back({entered, {1 - from_source, from_source, 0}});
    }
  }
  points.push_back(source_on_input(complex, correspondence, complex.opposite(h)));
}

} // namespace CGAL::Intrinsic_triangulations::internal

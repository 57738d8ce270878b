// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of trace_geodesic.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_TRACE_GEODESIC_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_TRACE_GEODESIC_IMPL_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Exact_sign.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/Metric_frame.h>
#include <CGAL/Intrinsic_triangulations/internal/exact/metric_images.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The corners of the input faces along a line, in the frame of the first: 0 and 1 are the ends of the start's halfedge. The sum of the
// start's coordinates is multiplied out where signs are asked for, since it is no input quantity. As in `Strip`,
// directions are products alone, and positions sums of them.
template <class Metric>
class Line_layout
{
public:
  using Vector = typename Metric::Vector;

  Line_layout(const Delta_complex& input, Metric& metric, const Surface_direction& start)
    : metric_(metric), frame_(input, metric), third_(frame_.ratios(start.point.halfedge).at_source),
      sum_(real(start.point.coordinates[0]) + real(start.point.coordinates[1]) + real(start.point.coordinates[2])),
      start_(real(start.point.coordinates[1]) + real(start.point.coordinates[2]) * third_),
      direction_(real(start.displacement[0]) + real(start.displacement[1]) * third_), left_(third_), base_(third_)
  {}

  // A corner of the first face, counted from the source of its halfedge.
  Vector corner(int i) const { return i == 2 ? third_ : real(i); }

  // Leaves the first face by its side number i, over the halfedge h behind it.
  void leave(int i, Halfedge_index h)
  {
    left_ = corner((i + 1) % 3);
    base_ = corner(i) - left_;
    entered_ = h;
  }
  // Goes on from the last face over h: to the left or to the right of its third corner.
  void turn(bool is_left, Halfedge_index h)
  {
    const Corner_ratios<Vector>& r = frame_.ratios(entered_);
    if (is_left) {
      base_ = base_ * r.at_source;
    } else {
      left_ = left_ + base_ * r.at_source;
      base_ = base_ * r.at_target;
    }
    entered_ = h;
  }

  // The ends of the halfedge that was crossed last, and the third corner of the face behind it.
  const Vector& left() const { return left_; }
  Vector right() const { return left_ + base_; }
  Vector apex() const { return left_ + base_ * frame_.ratios(entered_).at_source; }

  // Twice the area between the line and a corner: positive to its left; up to a positive factor.
  auto side(const Vector& x) const { return area(direction_, from_start(x)); }
  // How far along the line, in units of its displacement, it meets the last halfedge, or comes next to a corner.
  auto crossing() const { return area(from_start(left_), base_) / (area(direction_, base_) * sum_.x()); }
  auto along(const Vector& x) const
  {
    return times_conjugate(from_start(x), direction_).x() / (squared_norm(direction_) * sum_.x());
  }
  auto squared_speed() const { return squared_norm(direction_); }

private:
  Vector real(double x) const { return Vector(metric_.constant(x), metric_.constant(0)); }
  static auto area(const Vector& a, const Vector& b) { return times_conjugate(b, a).y(); }
  Vector from_start(const Vector& x) const { return x * sum_ - start_; }

  Metric& metric_;
  Metric_frame<Metric> frame_;
  Vector third_, sum_, start_, direction_, left_, base_;
  Halfedge_index entered_;
};

class Geodesic_tracer
{
public:
  Geodesic_tracer(const Exact_geometry& geometry, const Surface_direction& start, double length)
    : geometry_(geometry), input_(geometry.correspondence().input()), surface_(geometry.input_surface()), start_(start),
      metric_(*surface_), layout_(input_, metric_, start), wanted_(length)
  {}

  Traced_geodesic operator()()
  {
    using Real = Bounded_double_double;
    const auto& b = start_.point.coordinates;
    const double sum = b[0] + b[1] + b[2];
    before_ = {start_.point.halfedge, {b[0] / sum, b[1] / sum, b[2] / sum}};
    result_.points.push_back(before_);
    const Real s = metric_.squared_length(input_.edge(start_.point.halfedge));
    const Real speed = sqrt(layout_.squared_speed() * s);
    speed_ = std::ldexp(speed.hi(), geometry_.metric().unit_exponent());
    if (!(speed_ > 0))
      throw Invalid_point_error("a line needs a direction: the displacement is zero, or too small");
    if (leave_first_face())
      for (std::size_t i = 0; cross_face(); ++i)
        if (i % 64 == 63)
          geometry_.interruption().check();
    return std::move(result_);
  }

private:
  template <class Evaluate>
  Sign sign(const Evaluate& evaluate)
  {
    return exact_sign(*surface_, evaluate, [&] {
      return "a line from a point of face " + std::to_string(input_.face(start_.point.halfedge).idx()) +
             ": that it meets a vertex";
    });
  }

  Halfedge_index first_side(int i) const
  {
    Halfedge_index h = start_.point.halfedge;
    for (; i > 0; --i)
      h = input_.next(h);
    return h;
  }

  // Returns whether the line goes on.
  bool leave_first_face()
  {
    std::array<Sign, 3> side{};
    for (int i = 0; i < 3; ++i)
      side[i] = is_start(i) ? ZERO : sign([&](auto& metric) {
        const Line_layout<std::decay_t<decltype(metric)>> layout(input_, metric, start_);
        return layout.side(layout.corner(i));
      });
    for (int i = 0; i < 3; ++i)
      if (side[i] == NEGATIVE && side[(i + 1) % 3] == POSITIVE) {
        first_exit_ = i;
        const Halfedge_index h = first_side(i);
        layout_.leave(i, input_.opposite(h));
        return leave(h);
      }
    for (int i = 0; i < 3; ++i) {
      const Sign right = side[(i + 2) % 3], left = side[(i + 1) % 3];
      if (side[i] == ZERO && !is_start(i) && right != POSITIVE && left != NEGATIVE && right != left) {
        Surface_point corner{start_.point.halfedge, {0, 0, 0}};
        corner.coordinates[i] = 1;
        end_in_vertex(corner, layout_.along(layout_.corner(i)).hi(), input_.source(first_side(i)));
        return false;
      }
    }
    throw Invalid_point_error("face " + std::to_string(input_.face(start_.point.halfedge).idx()) +
                              " has zero area: a line cannot begin there");
  }

  bool is_start(int i) const
  {
    const auto& b = start_.point.coordinates;
    return b[(i + 1) % 3] == 0 && b[(i + 2) % 3] == 0;
  }

  // Goes through the face behind the last halfedge.
  bool cross_face()
  {
    Uncertain<Sign> quick = layout_.side(layout_.apex()).sign();
    const Sign side = is_certain(quick) ? get_certain(quick) : sign([&](auto& metric) {
      Line_layout<std::decay_t<decltype(metric)>> layout(input_, metric, start_);
      layout.leave(first_exit_, crossed_[0]);
      for (std::size_t i = 1; i < crossed_.size(); ++i) {
        if (i % 64 == 0)
          metric.interruption().check();
        layout.turn(turns_left_[i - 1], crossed_[i]);
      }
      return layout.side(layout.apex());
    });
    const Halfedge_index g = crossed_.back();
    if (side == ZERO) {
      end_in_vertex({g, {0, 0, 1}}, layout_.along(layout_.apex()).hi(), input_.target(input_.next(g)));
      return false;
    }
    const bool turns_left = side == NEGATIVE; // past the third corner, which is on the right
    const Halfedge_index h = turns_left ? input_.prev(g) : input_.next(g);
    layout_.turn(turns_left, input_.opposite(h));
    turns_left_.push_back(turns_left);
    return leave(h);
  }

  // Ends the line before or on the side h of the face where it is, or takes it over that side, where the layout is already.
  bool leave(Halfedge_index h)
  {
    const double left = layout_.side(layout_.left()).hi(), right = -layout_.side(layout_.right()).hi();
    const double from_left = (std::min)(1., (std::max)(0., left / (left + right)));
    const Surface_point exit{h, {from_left, 1 - from_left, 0}}; // h begins on the right
    const double at = (std::max)(length_, layout_.crossing().hi() * speed_);
    if (!(at < wanted_)) {
      end_between(exit, at);
      return false;
    }
    length_ = at;
    if (input_.is_border(input_.opposite(h))) {
      result_.status = Trace_status::AT_BORDER;
      result_.length = at;
      result_.points.push_back(exit);
      return false;
    }
    before_ = {input_.opposite(h), {1 - from_left, from_left, 0}};
    result_.points.push_back(before_);
    crossed_.push_back(before_.halfedge);
    return true;
  }

  void end_in_vertex(const Surface_point& corner, double along, Vertex_index v)
  {
    const double at = (std::max)(length_, along * speed_);
    if (wanted_ < at)
      return end_between(corner, at);
    result_.status = Trace_status::AT_VERTEX;
    result_.vertex = v;
    result_.length = at;
    result_.points.push_back(corner);
  }

  // Ends the line where it has the length that was asked for, in the face between `before_` and a point of another side.
  void end_between(const Surface_point& exit, double at)
  {
    const double t = at > length_ ? (wanted_ - length_) / (at - length_) : 1;
    std::size_t shift = 0;
    for (Halfedge_index h = exit.halfedge; h != before_.halfedge; h = input_.next(h))
      ++shift;
    Surface_point end = before_;
    for (std::size_t i = 0; i < 3; ++i)
      end.coordinates[i] = (1 - t) * before_.coordinates[i] + t * exit.coordinates[(i + shift) % 3];
    result_.status = Trace_status::AT_LENGTH;
    result_.length = wanted_;
    result_.points.push_back(end);
  }

  const Exact_geometry& geometry_;
  const Delta_complex& input_;
  Exact_geometry::Surface_lease surface_;
  const Surface_direction& start_;
  Double_double_metric metric_;
  Line_layout<Double_double_metric> layout_;
  double wanted_;
  double speed_ = 0; // the length of the displacement, in the unit of the input
  double length_ = 0;
  Surface_point before_{};
  int first_exit_ = 0;
  std::vector<Halfedge_index> crossed_; // each with the face that was entered to its left
  std::vector<bool> turns_left_;        // between them
  Traced_geodesic result_;
};

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Traced_geodesic trace(const Exact_geometry& geometry, const Surface_direction& start, double length)
{
  const Delta_complex& input = geometry.correspondence().input();
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
    throw Invalid_point_error("the length of a line has to be finite and not negative");
  return Geodesic_tracer(geometry, start, length)();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Surface_direction direction_at_vertex(const Exact_geometry& geometry, Halfedge_index h, double angle)
{
  const Delta_complex& input = geometry.correspondence().input();
  if (!(h.idx() < input.number_of_halfedges()) || !std::isfinite(angle))
    throw Invalid_point_error("a direction at a vertex needs a halfedge and a finite angle");
  const Exact_geometry::Surface_lease surface = geometry.input_surface();
  Double_double_metric metric(*surface);
  const Metric_frame<Double_double_metric> frame(input, metric);
  struct Fan_corner
  {
    Halfedge_index halfedge;
    double angle, ratio; // ratio of the sides' lengths
  };
  const auto corner = [&](Halfedge_index g) -> Fan_corner {
    const Double_double_disk z = frame.ratios(g).at_source;
    return {g, std::atan2(z.y().hi(), z.x().hi()), std::hypot(z.x().hi(), z.y().hi())};
  };
  std::vector<Fan_corner> fan;
  double sum = 0;
  Halfedge_index g = h;
  do {
    if (input.is_border(g))
      break;
    fan.push_back(corner(g));
    sum += fan.back().angle;
    g = input.next_around_source(g);
  } while (g != h);
  const bool is_closed = g == h && !fan.empty();
  if (is_closed && (angle < 0 || angle >= sum)) {
    angle = std::fmod(angle, sum);
    if (angle < 0)
      angle += sum;
  }
  if (angle < 0 || fan.empty() || (!is_closed && angle > sum * (1 + 1e-15)))
    throw Invalid_point_error("at vertex " + std::to_string(input.source(h).idx()) + ", the angle leads beyond the border");
  std::size_t i = 0;
  while (i + 1 < fan.size() && angle > fan[i].angle)
    angle -= fan[i++].angle;
  // The direction with angle t is sin(α - t) : sin(t) in terms of unit vectors along the two sides.
  const double t = (std::min)(angle, fan[i].angle);
  return {{fan[i].halfedge, {1, 0, 0}}, {std::sin(fan[i].angle - t), std::sin(t) / fan[i].ratio}};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_TRACE_GEODESIC_IMPL_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces along a straight line, laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Strip.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/metric_images.h>
#include <CGAL/Intrinsic_triangulations/internal/geodesics/Line_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <type_traits>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// One step through the faces along a line: over a side of the current face, counted from the halfedge that it was
// entered by, or only to that side as the one to count from.
struct Line_move
{
  std::uint8_t side;
  bool is_crossed;
};

// The current face, in a frame where the line begins at 0 and leads along the real axis: so the side of a corner is told
// by its ordinate. As in `Strip`, directions are products alone, and positions sums of them. Nothing is divided but by
// input quantities: positions are multiples of what they stand for, by a positive number, the scale.
template <class Faces, class Metric>
class Line_layout
{
public:
  using Vector = typename Metric::Vector;

  Line_layout(const Faces& faces, Metric& metric) : Line_layout(faces, metric, faces.begin(metric)) {}

  // The halfedge of the current face from which sides and corners are counted.
  Halfedge_index entered() const { return entered_; }
  // The input halfedge of which lengths are multiples.
  Halfedge_index unit() const { return unit_; }

  void move(Line_move m)
  {
    const Delta_complex& complex = faces_.complex;
    if (m.side == 0) {
      left_ = left_ + base_;
      base_ = negative(base_);
      entered_ = complex.opposite(entered_);
      return;
    }
    const Third_corner<Vector>& third = third_corner();
    if (m.side == 1) {
      left_ = m.is_crossed ? apex() : divisible(left_ + base_);
      base_ = base_ * third.to_target;
    } else {
      left_ = m.is_crossed ? divisible(left_) : apex();
      base_ = base_to_apex_;
    }
    if (!m.is_crossed)
      base_ = negative(base_);
    scale_ = divisible(scale_);
    const Halfedge_index side = m.side == 1 ? complex.next(entered_) : complex.prev(entered_);
    entered_ = m.is_crossed ? complex.opposite(side) : side;
    keep_in_range();
  }

  // Twice the area between the line and a corner: positive to its left; up to a positive factor.
  auto side_of_corner(int i) { return corner(i).y(); }
  // The same for the start beside a side of the face, and for the direction.
  auto side_of_start(int i) { return area_between(along_side(i), negative(corner(i == 2 ? 0 : i))); }
  auto side_of_direction(int i) { return negative(along_side(i)).y(); }

  // How far along the line, in units of its displacement, it meets the first side, or comes next to a corner.
  auto crossing() const
  {
    return (left_.x() * base_.y() - left_.y() * base_.x()) / (base_.y() * unit_of_line_.x() * scale_.x());
  }
  auto along(int i) { return corner(i).x() / (unit_of_line_.x() * (i == 2 ? divisible(scale_) : scale_).x()); }
  auto squared_speed() const { return squared_norm(direction_); }

  // The coordinates of the start in the face, rounded, times its area.
  std::array<double, 3> coordinates_of_start()
  {
    const auto twice_area = [this](int i) { return side_of_start(i).hi(); };
    const double s = third_corner().divisor.x().hi();
    return {twice_area(1), twice_area(2), twice_area(0) * s};
  }

private:
  Line_layout(const Faces& faces, Metric& metric, const Line_beginning<Vector>& line)
    : Line_layout(faces, metric, line, line.direction * power_for(line, metric))
  {}
  // \param along the direction, up to a positive factor
  Line_layout(const Faces& faces, Metric& metric, const Line_beginning<Vector>& line, const Vector& along)
    : faces_(faces), metric_(metric), direction_(line.direction),
      unit_of_line_(times_conjugate(line.direction * line.sum, along)),
      left_(negative(times_conjugate(line.start, along))), base_(times_conjugate(line.base * line.sum, along)),
      scale_(real(1)), base_to_apex_(base_), entered_(faces.first()), unit_(line.unit)
  {}

  Vector real(double x) const { return Vector(metric_.constant(x), metric_.constant(0)); }
  Vector negative(const Vector& x) const { return real(0) - x; }

  const Third_corner<Vector>& third_corner()
  {
    if (third_of_ != entered_) {
      third_ = faces_.third_corner(metric_, entered_);
      base_to_apex_ = base_ * third_->from_source;
      third_of_ = entered_;
    }
    return *third_;
  }
  // What remains to be divided by the divisor of the third corner.
  Vector divisible(const Vector& x)
  {
    if constexpr (Faces::has_divisors)
      return x * third_corner().divisor;
    else
      return x;
  }

  Vector apex()
  {
    third_corner();
    return divisible(left_) + base_to_apex_;
  }
  Vector corner(int i) { return i == 0 ? left_ : i == 1 ? left_ + base_ : apex(); }
  // Up to a positive factor.
  Vector along_side(int i)
  {
    if (i == 0)
      return base_;
    const Third_corner<Vector>& third = third_corner();
    return negative(i == 1 ? base_ * third.to_target : base_to_apex_);
  }

  // Double-doubles have the range of doubles.
  static Vector power_for(const Line_beginning<Vector>& line, Metric& metric)
  {
    int exponent = 0;
    if constexpr (std::is_same_v<Metric, Double_double_metric>)
      exponent = std::clamp(std::ilogb(line.direction.modulus()) + std::ilogb(line.sum.modulus()), -1000, 1000);
    return Vector(metric.constant(std::ldexp(1., -exponent)), metric.constant(0));
  }
  void keep_in_range()
  {
    if constexpr (Faces::has_divisors && std::is_same_v<Metric, Double_double_metric>) {
      const int exponent = std::ilogb(scale_.x().hi());
      if (std::abs(exponent) > 64) {
        const Vector power = real(std::ldexp(1., -exponent));
        left_ = left_ * power;
        base_ = base_ * power;
        scale_ = scale_ * power;
      }
    }
  }

  const Faces& faces_;
  Metric& metric_;
  Vector direction_, unit_of_line_, left_, base_, scale_, base_to_apex_;
  Halfedge_index entered_, unit_, third_of_;
  std::optional<Third_corner<Vector>> third_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H

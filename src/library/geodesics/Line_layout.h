// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces along a straight line, laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include "../engine/layout/Strip.h"
#include "../engine/layout/metric_images.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include "../engine/layout/Unfolding.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Input_edge_walk.h>
#include "../engine/layout/Metric_frame.h"
#include <CGAL/Intrinsic_triangulations/internal/insertion/Piece_search.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations::internal {

// A line in the frame of a first halfedge, whose source is 0.
template <class Vector>
struct Line_beginning
{
  Vector base;         // the target of that halfedge
  Vector start;        // where the line begins, times `sum`
  Vector sum;          // of the coordinates of the start: positive
  Vector direction;    // its displacement
  Halfedge_index unit; // the input halfedge that has length 1
};

// The third corner of a face, relative to one of its halfedges: the sides at that corner are the halfedge times
// `from_source` and `to_target`, divided by `divisor`, which is positive.
template <class Vector>
struct Third_corner
{
  Vector from_source, to_target, divisor;
};

// \param corners the corners of the start's face, in the order of its coordinates
template <class Metric>
Line_beginning<typename Metric::Vector>
line_between(const Surface_direction& start, Metric& metric, const typename Metric::Vector& base,
             const std::array<typename Metric::Vector, 3>& corners, Halfedge_index unit)
{
  using Vector = typename Metric::Vector;
  const auto real = [&metric](double x) { return Vector(metric.constant(x), metric.constant(0)); };
  const auto& b = start.point.coordinates;
  // Their sum is not an input quantity, so positions are multiplied by it.
  return {base, real(b[0]) * corners[0] + real(b[1]) * corners[1] + real(b[2]) * corners[2],
          real(b[0]) + real(b[1]) + real(b[2]),
          real(start.displacement[0]) * (corners[1] - corners[0]) +
            real(start.displacement[1]) * (corners[2] - corners[0]),
          unit};
}

// The faces of the input.
class Input_faces
{
public:
  Input_faces(const Delta_complex& input, const Surface_direction& start) : complex(input), start_(start) {}

  // Whether third corners have divisors other than 1.
  static constexpr bool has_divisors = false;

  Halfedge_index first() const { return start_.point.halfedge; }

  template <class Metric>
  Line_beginning<typename Metric::Vector> begin(Metric& metric) const
  {
    const Metric_frame<Metric> frame(complex, metric);
    const auto zero = frame.real(metric.constant(0)), one = frame.real(metric.constant(1));
    return line_between(start_, metric, one, {zero, one, frame.ratios(first()).at_source}, first());
  }

  template <class Metric>
  Third_corner<typename Metric::Vector> third_corner(Metric& metric, Halfedge_index h) const
  {
    const Metric_frame<Metric> frame(complex, metric);
    const auto& ratios = frame.ratios(h);
    return {ratios.at_source, ratios.at_target, frame.real(metric.constant(1))};
  }

  // Whether a line has a unique continuation beyond a vertex.
  bool is_flat_at(Vertex_index) const { return false; }

  const Delta_complex& complex;

private:
  const Surface_direction& start_;
};

// The faces of the current triangulation. The first one contains the start.
class Current_faces
{
public:
  static constexpr bool has_divisors = true;

  Current_faces(const Exact_engine& engine, const Surface_direction& start)
    : complex(engine.connectivity()), correspondence_(engine.correspondence()), input_(correspondence_.input()),
      start_(start)
  {
    if (start.point.dimension() == 0)
      begin_at_vertex();
    else {
      const Triangle_piece piece =
        piece_of_point(engine, piece_at_source(complex, correspondence_, start.point.halfedge), start.point);
      first_ = piece.side;
      position_ = piece.gap;
    }
  }

  // A side of the first face. If the line begins at a vertex of the input, the start is its source, and the side lies
  // to the right of the line.
  Halfedge_index first() const { return first_; }
  bool begins_at_input_vertex() const { return corner_.is_valid(); }

  template <class Metric>
  Line_beginning<typename Metric::Vector> begin(Metric& metric) const
  {
    using Vector = typename Metric::Vector;
    const Unfolding<Metric> unfolding(complex, correspondence_, metric);
    const auto u = unfolding.edge_beginning(first_);
    std::array<Vector, 3> corners{u.vector, u.vector, u.vector};
    if (begins_at_input_vertex()) {
      const Metric_frame<Metric> frame(input_, metric);
      Vector side = frame.real(metric.constant(1));
      for (Halfedge_index h = u.reference; h != corner_; h = input_.next_around_source(h))
        side = side * frame.ratios(h).at_source;
      std::size_t i = 0;
      for (Halfedge_index h = start_.point.halfedge; h != corner_; h = input_.next(h))
        ++i;
      corners[i] = frame.real(metric.constant(0));
      corners[(i + 1) % 3] = side;
      corners[(i + 2) % 3] = side * frame.ratios(corner_).at_source;
    } else {
      for (std::size_t i = 0; i < 3; ++i) {
        Surface_point corner{start_.point.halfedge, {0, 0, 0}};
        corner.coordinates[i] = 1;
        corners[i] = unfolding.vector_to(corner, first_, u, position_);
      }
    }
    return line_between(start_, metric, u.vector, corners, u.reference);
  }

  template <class Metric>
  Third_corner<typename Metric::Vector> third_corner(Metric& metric, Halfedge_index h) const
  {
    using Vector = typename Metric::Vector;
    const auto corner = Unfolding<Metric>(complex, correspondence_, metric).opposite_corner(complex.next(h));
    const Vector z(corner.p, corner.four_areas), s(corner.s_first + corner.s_first, metric.constant(0));
    return {z, s - z, s};
  }

  bool is_flat_at(Vertex_index v) const { return correspondence_.is_inserted(v); }

  const Delta_complex& complex;

private:
  // The first face is the one where the first side of the start's face leaves the vertex, or the one to the left of
  // that side.
  void begin_at_vertex()
  {
    corner_ = start_.point.halfedge;
    for (std::size_t i = 0; start_.point.coordinates[i] == 0; ++i)
      corner_ = input_.next(corner_);
    const auto [side, position] = start_of_input_edge(complex, correspondence_, input_.source(corner_), corner_);
    first_ = position < 0 ? side : complex.prev(side);
  }

  const Correspondence& correspondence_;
  const Delta_complex& input_;
  const Surface_direction& start_;
  Halfedge_index first_;
  std::int64_t position_ = 0;
  Halfedge_index corner_; // the halfedge of the start's face that leaves the vertex where the line begins
};

// One step through the faces along a line: across a side of the current face, counted from the halfedge by which it was
// entered, or just a change of the side that is counted from.
struct Line_move
{
  std::uint8_t side;
  bool is_crossed;
};

// The current face, in a frame where the line begins at 0 and runs along the real axis, so that the ordinate of a
// corner tells its side. As in `Strip`, directions are products, and positions are sums of them. Only input quantities
// are divisors: positions are multiplied by a positive number, the scale, instead.
template <class Faces, class Metric>
class Line_layout
{
public:
  using Vector = typename Metric::Vector;

  Line_layout(const Faces& faces, Metric& metric) : Line_layout(faces, metric, faces.begin(metric)) {}

  // The halfedge of the current face from which sides and corners are counted.
  Halfedge_index entered() const { return entered_; }
  // The input halfedge that is the unit of length.
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
  // The same for the start relative to a side of the face, and for the direction.
  auto side_of_start(int i) { return area_between(along_side(i), negative(corner(i == 2 ? 0 : i))); }
  auto side_of_direction(int i) { return negative(along_side(i)).y(); }

  // The position on the line, in units of its displacement, where it meets the first side or passes a corner.
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
  // The values still to be divided by the divisor of the third corner.
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
  // The vector along a side, up to a positive factor.
  Vector along_side(int i)
  {
    if (i == 0)
      return base_;
    const Third_corner<Vector>& third = third_corner();
    return negative(i == 1 ? base_ * third.to_target : base_to_apex_);
  }

  // Double-doubles have only the range of doubles.
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

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_GEODESICS_LINE_LAYOUT_H

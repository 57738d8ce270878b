// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The ways from a source inside a face to its corners and across its sides.

#include "First_ways.h"
#include "plane_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using plane::Vector;

// A part of a line.
struct Part_of_line
{
  double begin, end;

  // Keeps the part where at_zero + slope b is not negative.
  void clip(double at_zero, double slope)
  {
    if (slope > 0)
      begin = (std::max)(begin, -at_zero / slope);
    else if (slope < 0)
      end = (std::min)(end, -at_zero / slope);
    else if (at_zero < 0)
      end = begin;
  }
};

class First_ways_builder
{
public:
  First_ways_builder(const Laid_out_faces& faces, const Face_source& source) : faces_(faces), source_(source) {}

  First_ways build()
  {
    const Laid_out_faces::Side& base = faces_.side(source_.side);
    const std::array<Vector, 3> corners{Vector{0, 0}, Vector{base.length, 0}, Vector{base.apex_x, base.apex_y}};
    std::uint32_t side = source_.side;
    for (int i = 0; i < 3; ++i, side = Laid_out_faces::next(side)) {
      const Vector &p = corners[std::size_t(i)], &q = corners[std::size_t((i + 1) % 3)];
      add_way_to_corner(side, p, q);
      const Vector along{(p[0] - q[0]) / faces_.side(side).length, (p[1] - q[1]) / faces_.side(side).length};
      if (source_.is_point())
        add_ways_from_point(side, q, along, i == 0 && source_.is_on_side);
      else
        add_fronts(side, q, along);
    }
    return std::move(result_);
  }

private:
  // \param p, q where the side begins and ends
  void add_way_to_corner(std::uint32_t side, const Vector& p, const Vector& q)
  {
    const double at =
      (std::min)((std::max)(plane::dot(plane::difference(p, source_.from), source_.direction), 0.), source_.length);
    const Vector nearest{source_.from[0] + at * source_.direction[0], source_.from[1] + at * source_.direction[1]},
      way = plane::difference(nearest, p);
    const double angle =
      std::atan2(plane::cross(plane::difference(q, p), way), plane::dot(plane::difference(q, p), way));
    result_.to_corners.push_back(
      {side, (std::min)((std::max)(angle, 0.), faces_.side(side).angle), source_.offset + length_of(way[0], way[1])});
  }

  // \param end where the side ends, and the window begins
  // \param along the unit vector from there along the side
  void add_ways_from_point(std::uint32_t side, const Vector& end, const Vector& along, bool is_on_side)
  {
    const double length = faces_.side(side).length;
    const Vector from_end = plane::difference(source_.from, end);
    Window w{0, length, plane::dot(from_end, along), plane::cross(from_end, along), source_.offset, 0};
    w.source = source_.number;
    if (is_on_side) {
      // The window goes into the other faces in all directions. A joint of segments is also a source of the other face.
      if (!source_.limits.empty() && faces_.beside(side) == Laid_out_faces::none)
        return;
      w.y = 0;
    } else {
      Part_of_line interval{0, length};
      for (const Vector& limit : source_.limits)
        interval.clip(-plane::dot(from_end, limit), plane::dot(along, limit));
      w.b0 = interval.begin;
      w.b1 = interval.end;
    }
    if (w.b1 > w.b0)
      result_.windows.push_back({side, w});
  }

  // The fronts between the perpendiculars at the ends of the segment.
  void add_fronts(std::uint32_t side, const Vector& end, const Vector& along)
  {
    const double length = faces_.side(side).length;
    const Vector& unit = source_.direction;
    for (const Vector& direction : {Vector{-unit[1], unit[0]}, Vector{unit[1], -unit[0]}}) {
      const double x = plane::dot(direction, along), y = plane::cross(along, direction);
      if (!(y > least_rise))
        continue; // it runs along the side, or away from it
      const double distance = plane::dot(plane::difference(end, source_.from), direction),
                   position = plane::dot(plane::difference(end, source_.from), unit), slope = plane::dot(along, unit);
      Part_of_line interval{0, length};
      interval.clip(position, slope);
      interval.clip(source_.length - position, -slope);
      interval.clip(distance + 1e-12 * length, x); // the segment may lie on the side, up to rounding
      if (!(interval.end > interval.begin))
        continue;
      Window w{interval.begin, interval.end, x, y, source_.offset + distance, 0};
      w.source = source_.number;
      w.kind = Window::FRONT;
      result_.windows.push_back({side, w});
    }
  }

  static constexpr double least_rise = 1e-12;

  const Laid_out_faces& faces_;
  const Face_source& source_;
  First_ways result_;
};

} // namespace

First_ways first_ways(const Laid_out_faces& faces, const Face_source& source)
{
  return First_ways_builder(faces, source).build();
}

} // namespace CGAL::Intrinsic_triangulations::internal

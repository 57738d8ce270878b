// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest ways followed back over edges at which several sheets meet.

#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>

#include "plane_vectors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

using plane::Vector;

// Straight ways back from rows. At an edge of several sheets, the sheet that the way comes from is unknown: they are
// tried one after the other until the distance of a vertex fits.
class Ways_over_seams
{
public:
  Ways_over_seams(const Laid_out_faces& faces, const Window_distances& windows, std::vector<Straight_part>& parts)
    : faces_(faces), windows_(windows), parts_(parts)
  {}

  // \return the row where the way to this one comes from, or none if it was not found
  std::uint32_t follow(std::uint32_t row)
  {
    const auto [side, angle] = windows_.arrivals[row];
    length_ = windows_.distances[row];
    const Laid_out_faces::Side& s = faces_.side(side);
    // The row lies at the origin, and the way on the axis.
    std::vector<Beginning> beginnings{
      {side,
       {Vector{0, 0}, plane::turned({s.length, 0}, -angle), plane::turned({s.apex_x, s.apex_y}, -angle)},
       1,
       {side, 0},
       parts_.size()}};
    std::uint32_t result = Laid_out_faces::none;
    for (bool is_first = true; result == Laid_out_faces::none && !beginnings.empty(); is_first = false) {
      const Beginning beginning = beginnings.back();
      beginnings.pop_back();
      parts_.resize(beginning.number_of_parts); // before it, those of all others are the same
      result = follow(beginning, is_first, beginnings);
    }
    return result;
  }

private:
  // Where a way enters a face over its side.
  struct Beginning
  {
    std::uint32_t side;
    std::array<Vector, 3> corners; // from where the side begins
    int turn;                      // -1 if the face is turned over
    Straight_part::End from;       // the beginning of the part
    std::size_t number_of_parts;   // before it
  };

  std::uint32_t follow(Beginning way, bool is_first, std::vector<Beginning>& others)
  {
    for (;; is_first = false) {
      if (number_of_steps_++ > 100 * faces_.sides().size() + 100000)
        return Laid_out_faces::none;
      const std::array<std::uint32_t, 3> sides{way.side, Laid_out_faces::next(way.side),
                                               Laid_out_faces::prev(way.side)};
      for (std::size_t i = is_first ? 1 : 2; i < 3; ++i)
        if (comes_from(faces_.side(sides[i]).row, way.corners[i])) {
          parts_.push_back({way.from, {sides[i], 0}});
          return faces_.side(sides[i]).row;
        }
      const std::size_t begin = is_first || (way.corners[2][1] > 0) == (way.corners[0][1] > 0) ? 1 : 2;
      const std::uint32_t crossed = sides[begin];
      const Vector p = way.corners[begin], q = way.corners[(begin + 1) % 3];
      const double place = p[1] / (p[1] - q[1]), gone = p[0] + (q[0] - p[0]) * place;
      if (!(gone < length_) || !fits(crossed, p, gone) || !fits(Laid_out_faces::next(crossed), q, gone))
        return Laid_out_faces::none;
      const auto enter = [&](std::uint32_t side, bool is_turned) {
        const Laid_out_faces::Side& s = faces_.side(side);
        const Vector from = is_turned ? p : q, to = is_turned ? q : p;
        const double x = (to[0] - from[0]) / s.length, y = (to[1] - from[1]) / s.length;
        way.side = side;
        way.turn = is_turned ? -way.turn : way.turn;
        way.corners = {
          from, to,
          Vector{from[0] + s.apex_x * x - way.turn * s.apex_y * y, from[1] + s.apex_x * y + way.turn * s.apex_y * x}};
      };
      if (const std::uint32_t opposite = faces_.side(crossed).opposite; opposite != Laid_out_faces::none) {
        enter(opposite, false);
        continue;
      }
      const Beginning before = way;
      for (std::uint32_t side = faces_.beside(crossed); side != Laid_out_faces::none && side != crossed;
           side = faces_.beside(side)) {
        const bool is_turned = faces_.side(side).row == faces_.side(crossed).row;
        way = before;
        enter(side, is_turned);
        others.push_back({side, way.corners, way.turn, {side, is_turned ? place : 1 - place}, parts_.size() + 1});
      }
      parts_.push_back({before.from, {crossed, place}});
      return Laid_out_faces::none;
    }
  }

  bool comes_from(std::uint32_t row, const Vector& p) const
  {
    const double gone = std::hypot(p[0], p[1]);
    return p[0] > 0 && std::abs(p[1]) <= 1e-5 * gone &&
           std::abs(windows_.distances[row] + gone - length_) <= 1e-9 * length_;
  }

  // Whether the distance of the vertex at p, where a side begins, allows the rest of the way.
  bool fits(std::uint32_t side, const Vector& p, double gone) const
  {
    const double d = windows_.distances[faces_.side(side).row], between = std::hypot(p[0] - gone, p[1]),
                 rest = length_ - gone, rounding = 1e-9 * length_;
    // Distances larger than this one need not be known.
    return rest <= d + between + rounding && (d <= rest + between + rounding || rest + between >= length_);
  }

  const Laid_out_faces& faces_;
  const Window_distances& windows_;
  std::vector<Straight_part>& parts_;
  double length_ = 0;
  std::size_t number_of_steps_ = 0;
};

} // namespace

bool straight_parts(const Laid_out_faces& faces, const Window_distances& windows, std::uint32_t row,
                    std::vector<Straight_part>& parts)
{
  Ways_over_seams ways(faces, windows, parts);
  while (row != Laid_out_faces::none && windows.arrivals[row].side != Laid_out_faces::none) {
    const std::uint32_t side = windows.arrivals[row].side;
    if (faces.is_flat_edge(side)) {
      parts.push_back({{side, 0}, {faces.other_end(side), 0}});
      row = faces.side(faces.other_end(side)).row;
    } else {
      row = ways.follow(row);
    }
  }
  return row != Laid_out_faces::none;
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Finds T-junctions and close vertices in a list of polygons.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_GAP_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_GAP_SEARCH_H

#include "Hanging_vertices.h"
#include "Polygon_sides.h"
#include "Vertices_on_edges.h"
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Two vertices are close if their distance is at most this fraction of the edges there.
constexpr double closeness = 0x1p-30;
inline double close_distance(double length) { return std::isfinite(length) ? closeness * length : 0; }

// All points are finite, and the sides are sorted.
class Gap_search
{
  using Coordinates = std::array<double, 3>;
  using Index = Polygon_sides::Index;

public:
  // \param border the positions of sides without a partner
  Gap_search(const std::vector<Coordinates>& points, const Polygon_sides& polygons, const std::vector<Index>& border,
             Surface_report& report)
    : points_(points), polygons_(polygons), border_(border), report_(report)
  {}

  // Reports T-junctions and close vertices, and describes the first of each.
  void add_gaps(bool are_sheets_meeting)
  {
    std::vector<Narrow_place> junctions, close;
    if (report_.exponent_of_longest_edge - report_.exponent_of_shortest_edge >= 28)
      find_short_sides(close);
    if (!border_.empty() || are_sheets_meeting)
      find_junctions(junctions);
    if (!border_.empty())
      find_close_vertices(close);
    add_gaps(Gap_kind::T_JUNCTION, junctions, [](const Narrow_place& gap) {
      const std::string edge = "edge " + std::to_string(gap.edge[0]) + "-" + std::to_string(gap.edge[1]) + " of face " +
                               std::to_string(gap.face);
      const std::string vertex = "vertex " + std::to_string(gap.vertex);
      return gap.distance == 0
               ? vertex + " lies within " + edge + ", which does not end there"
               : vertex + " lies " + short_text(gap.distance) + " beside " + edge + ", which does not end there";
    });
    add_gaps(Gap_kind::CLOSE_VERTICES, close, [this](const Narrow_place& gap) {
      const Coordinates& p = point(gap.edge[0]);
      return "vertices " + std::to_string(gap.edge[0]) + " and " + std::to_string(gap.edge[1]) + " at (" +
             short_text(p[0]) + ", " + short_text(p[1]) + ", " + short_text(p[2]) + ") are only " +
             short_text(gap.distance) + " apart, beside an edge " + short_text(gap.length) + " long";
    });
    // Rounds up to one digit, which is enough.
    if (const double needed = report_.stitching_tolerance * (1 + 0x1p-40); needed > 0) {
      const double power = std::pow(10, std::floor(std::log10(needed)));
      for (const double digit : {1, 2, 5, 10})
        if (digit * power >= needed) {
          report_.stitching_tolerance = digit * power;
          break;
        }
    }
  }

private:
  // A vertex in an edge, or a pair of vertices with an edge or a gap between them.
  struct Narrow_place
  {
    std::array<std::size_t, 2> edge;
    std::size_t face, vertex;
    double distance, length; // of an edge there
  };

  const Coordinates& point(std::size_t vertex) const { return points_[vertex]; }
  static std::string short_text(const double x)
  {
    std::ostringstream text;
    text.precision(3);
    text << x;
    return text.str();
  }

  void add_close(std::size_t v, std::size_t w, std::size_t face, double length, std::vector<Narrow_place>& close) const
  {
    if (point(v) != point(w))
      close.push_back({{(std::min)(v, w), (std::max)(v, w)}, face, v, distance(v, w), length});
  }
  double distance(std::size_t v, std::size_t w) const
  {
    return Vertices_on_edges::norm(Vertices_on_edges::difference(point(v), point(w)));
  }

  void find_short_sides(std::vector<Narrow_place>& close) const
  {
    for (std::size_t f = 0; f < report_.number_of_faces; ++f) {
      const std::size_t begin = polygons_.begin_of_face(f);
      if (polygons_.degree(f) != 3 || polygons_.vertex(begin) == Polygon_sides::none)
        continue;
      const std::array<std::size_t, 3> v = {polygons_.vertex(begin), polygons_.vertex(begin + 1),
                                            polygons_.vertex(begin + 2)};
      if (const std::optional<std::size_t> side = shortest_side({{point(v[0]), point(v[1]), point(v[2])}}))
        add_close(v[*side], v[(*side + 1) % 3], f, distance(v[*side], v[(*side + 2) % 3]), close);
    }
  }

  void find_junctions(std::vector<Narrow_place>& junctions) const
  {
    Hanging_vertices hanging(points_, report_.number_of_faces, polygons_);
    hanging.find(
      0, closeness,
      [&](Index v, Index w, const std::vector<Index>& sides, Index vertex, double distance, double) {
        junctions.push_back({{v, w}, polygons_.face_of_side(sides.front()), vertex, distance, 0});
      },
      [] {});
  }

  void find_close_vertices(std::vector<Narrow_place>& close) const
  {
    std::vector<Index> vertices;
    for (const Index s : border_)
      for (const std::size_t v : polygons_.ends(s))
        vertices.push_back(Index(v));
    const Vertices_on_edges near(points_, std::move(vertices));
    for (const Index s : border_) {
      const std::array<std::size_t, 2> ends = polygons_.ends(s);
      const double length = distance(ends[0], ends[1]);
      for (const std::size_t v : ends)
        near.for_each_within(point(v), close_distance(length),
                             [&](Index w, double) { add_close(v, w, polygons_.face_of_side(s), length, close); });
    }
  }

  template <class Describe>
  void add_gaps(const Gap_kind kind, std::vector<Narrow_place>& gaps, const Describe& describe)
  {
    const auto key = [kind](const Narrow_place& gap) {
      return std::make_tuple(gap.edge[0], gap.edge[1], kind == Gap_kind::T_JUNCTION ? gap.vertex : 0);
    };
    std::sort(gaps.begin(), gaps.end(), [&](const Narrow_place& a, const Narrow_place& b) {
      return std::make_pair(key(a), -a.length) < std::make_pair(key(b), -b.length);
    });
    gaps.erase(std::unique(gaps.begin(), gaps.end(),
                           [&](const Narrow_place& a, const Narrow_place& b) { return key(a) == key(b); }),
               gaps.end());
    if (gaps.empty())
      return;
    Gap all{kind, {}, {}, gaps.size(), describe(gaps.front())};
    for (std::size_t i = 0; i < gaps.size() && i < 10; ++i) {
      all.edges.push_back(gaps[i].edge);
      all.faces.push_back(gaps[i].face);
    }
    report_.gaps.push_back(std::move(all));
    for (const Narrow_place& gap : gaps)
      report_.stitching_tolerance = (std::max)(report_.stitching_tolerance, gap.distance);
  }

  const std::vector<Coordinates>& points_;
  const Polygon_sides& polygons_;
  const std::vector<Index>& border_;
  Surface_report& report_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_GAP_SEARCH_H

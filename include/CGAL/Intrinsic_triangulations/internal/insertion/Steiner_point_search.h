// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The best place for the new vertex of a thin triangle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STEINER_POINT_SEARCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STEINER_POINT_SEARCH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Face_quality.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/straight_walk.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The center of the circle through three points.
inline Plane_point circumcenter(Plane_point a, Plane_point b, Plane_point c)
{
  const Plane_point z = (c - a) / (b - a);
  return a + (b - a) * Plane_point(0.5, (std::norm(z) - z.real()) / (2 * z.imag()));
}

// The points that see the shortest side of a triangle at a large enough angle form a disk, its petal. The search tries
// points of its border, and the circumcenter or off-center: it lays out the triangles that an insertion would replace,
// which are those with the point in their circumcircles. It takes the point that leaves the fewest bad triangles; of
// several, the one farthest from all vertices.
//
// Source: H. Erten, A. Ungor, "Quality triangulations with locally optimal Steiner points" (2009). They take the point
// that is farthest from all vertices; with the count, refinement needs about 30 percent fewer.
template <class Traits>
class Steiner_point_search
{
public:
  Steiner_point_search(const Delta_complex& complex, const Measured_faces<Traits>& faces,
                       const Segments<Traits>& segments, const Face_quality<Traits>& quality)
    : complex_(complex), faces_(faces), segments_(segments), quality_(quality),
      height_(slack / (2 * std::tan(quality.minimum_angle() / 2)))
  {}

  // \param h the shortest side of a triangle that has a small angle
  // \return the place of the new vertex, in the frame of h. Its distance from all vertices is at least the length of h
  Plane_point operator()(Halfedge_index h)
  {
    triangles_.clear();
    lay_out(h, 0, 1);
    Plane_point best(0.5, (std::min)(height_, triangles_[0].center.imag())); // which is the height for NaN
    std::optional<Outcome> best_outcome = try_point(best);
    const double y = (height_ - 0.25 / height_) / 2, radius = height_ - y;
    for (int i = 1; i < number_of_points && triangles_.size() < most_triangles; ++i) {
      const Plane_point p = Plane_point(0.5, y) + std::polar(radius, CGAL_PI * i / number_of_points);
      const std::optional<Outcome> outcome = try_point(p);
      if (outcome && outcome->squared_distance >= least_squared_distance &&
          (!best_outcome || *outcome < *best_outcome)) {
        best = p;
        best_outcome = outcome;
      }
    }
    return best;
  }

private:
  // The petal is lowered by this factor, so that new triangles meet the bound in spite of rounding.
  static constexpr double slack = 0.99;
  static constexpr int number_of_points = 12;
  static constexpr double least_squared_distance = 1.1; // from all vertices, in squares of the shortest side
  // No more are laid out: around a thin tube, the same ones would recur forever.
  static constexpr std::size_t most_triangles = 64;

  struct Triangle
  {
    Halfedge_index halfedge;
    std::array<Plane_point, 3> corners; // from the source of the halfedge
    Plane_point center;
    double squared_radius;
    bool is_bad;
    std::array<int, 3>
      neighbors; // beyond the sides from each corner to the next one; the search came through the first
  };
  static constexpr int unknown = -1, none = -2, segment = -3, whole_segment = -4;

  struct Outcome
  {
    int bad_triangles;       // how many more there would be
    double squared_distance; // to the nearest vertex
    bool operator<(const Outcome& other) const
    {
      if (bad_triangles != other.bad_triangles)
        return bad_triangles < other.bad_triangles;
      return squared_distance > other.squared_distance;
    }
  };

  int lay_out(Halfedge_index h, Plane_point a, Plane_point b)
  {
    const Plane_point apex = faces_.apex(h);
    if (!(apex.imag() > 0) || triangles_.size() == most_triangles)
      return none;
    const Plane_point c = a + (b - a) * apex, center = circumcenter(a, b, c);
    triangles_.push_back(
      {h, {a, b, c}, center, std::norm(center - a), quality_.is_bad(complex_.face(h)), {unknown, unknown, unknown}});
    return static_cast<int>(triangles_.size()) - 1;
  }
  int neighbor(int t, std::size_t side)
  {
    if (triangles_[t].neighbors[side] == unknown) {
      Halfedge_index h = triangles_[t].halfedge;
      for (std::size_t i = 0; i < side; ++i)
        h = complex_.next(h);
      const Plane_point a = triangles_[t].corners[side], b = triangles_[t].corners[(side + 1) % 3];
      const int n = !segments_.contains(h)                 ? lay_out(complex_.opposite(h), b, a)
                    : segments_.is_whole(complex_.edge(h)) ? whole_segment
                                                           : segment;
      triangles_[t].neighbors[side] = n;
    }
    return triangles_[t].neighbors[side];
  }

  // \return nothing if the point comes too close to a segment, or if its neighborhood is too large or has a triangle
  //   without area, behind which a vertex could be near
  std::optional<Outcome> try_point(Plane_point p)
  {
    const double unit = faces_.length(triangles_[0].halfedge);
    Outcome result{0, (std::numeric_limits<double>::infinity)()};
    stack_.assign(1, 0);
    while (!stack_.empty() && triangles_.size() < most_triangles) {
      const int t = stack_.back();
      stack_.pop_back();
      result.bad_triangles -= triangles_[t].is_bad;
      for (std::size_t side = t == 0 ? 0 : 1; side < 3; ++side) {
        const int n = neighbor(t, side);
        if (n == none)
          return std::nullopt;
        if (n >= 0 && std::norm(p - triangles_[n].center) < triangles_[n].squared_radius) {
          stack_.push_back(n);
          continue;
        }
        const Plane_point a = triangles_[t].corners[side] - p, b = triangles_[t].corners[(side + 1) % 3] - p;
        const double twice_area = cross_product(a, b);
        if (!(twice_area > 0) || (n == segment && std::real(a * std::conj(b)) < 0))
          return std::nullopt;
        const auto [shortest, longest] = std::minmax({std::abs(a), std::abs(b), std::abs(b - a)});
        result.bad_triangles += quality_.is_bad(unit * shortest, unit * longest,
                                                unit * std::abs(a) * std::abs(b) * std::abs(b - a) / (2 * twice_area));
        result.squared_distance = (std::min)(result.squared_distance, std::norm(a));
      }
    }
    if (triangles_.size() == most_triangles)
      return std::nullopt;
    return result;
  }

  const Delta_complex& complex_;
  const Measured_faces<Traits>& faces_;
  const Segments<Traits>& segments_;
  const Face_quality<Traits>& quality_;
  const double height_; // of the petal over a side of length 1
  std::vector<Triangle> triangles_;
  std::vector<int> stack_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_STEINER_POINT_SEARCH_H

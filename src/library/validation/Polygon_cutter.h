// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Cuts a face with any number of corners into triangles: in a plane if its sides do not cross there, in space
// otherwise.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_CUTTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_CUTTER_H

#include <CGAL/Intrinsic_triangulations/errors.h>
#include "Planar_ring.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Polygon_cutter
{
  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Vector = Kernel::Vector_3;
  using Triangle = std::array<std::size_t, 3>;

public:
  // \param polygon different neighbors, at least three
  Polygon_cutter(const std::vector<std::array<double, 3>>& points, const std::vector<std::size_t>& polygon,
                 std::size_t face)
    : points_(points), polygon_(polygon), face_(face)
  {
    // Moved and scaled to size 1, so that squares and products do not overflow; divided by four first, because the
    // difference of two coordinates can overflow as well.
    std::vector<std::array<double, 3>> places;
    double size = 0;
    for (const std::size_t v : polygon) {
      std::array<double, 3> p;
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = points[v][i] / 4 - points[polygon[0]][i] / 4;
        size = (std::max)(size, std::abs(p[i]));
      }
      places.push_back(p);
    }
    exponent_ = size > 0 ? std::ilogb(size) : 0;
    for (const auto& [x, y, z] : places)
      places_.emplace_back(std::ldexp(x, -exponent_), std::ldexp(y, -exponent_), std::ldexp(z, -exponent_));
  }

  // The corners of the triangles by their positions in the polygon.
  // \exception Invalid_surface_error if two sides cross, or the polygon winds twice around a part of itself
  std::vector<Triangle> cut()
  {
    const auto [area, widest] = normals();
    // The area determines the plane, unless it is small: then three distant corners do.
    const bool has_area = length(area) > 0.1 * length(widest);
    bool is_flat = true;
    for (const Vector& normal : {has_area ? area : widest, has_area ? widest : area})
      if (normal != Vector(0, 0, 0)) {
        const Planar_ring::Status status = cut_along(normal);
        if (status == Planar_ring::CUT)
          return std::move(triangles_);
        is_flat = is_flat && status == Planar_ring::FLAT;
        if (!crossing_.empty() && is_near_plane_)
          break;
      }
    if (!crossing_.empty())
      throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, face_, 1, crossing_);
    cut_in_space(is_flat);
    return std::move(triangles_);
  }

  // A warning about the triangles; empty if they are correct.
  const std::string& warning() const { return warning_; }

private:
  static double length(const Vector& v) { return std::hypot(v.x(), v.y(), v.z()); }

  // The normals of the polygon, as long as twice its area, and of three distant corners.
  std::pair<Vector, Vector> normals() const
  {
    Vector area(0, 0, 0), longest(0, 0, 0), widest(0, 0, 0);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      area = area + cross_product(places_[i], places_[i + 1 < places_.size() ? i + 1 : 0]);
      longest = (std::max)(longest, places_[i], [](const Vector& a, const Vector& b) { return a * a < b * b; });
    }
    for (const Vector& p : places_)
      widest =
        (std::max)(widest, cross_product(longest, p), [](const Vector& a, const Vector& b) { return a * a < b * b; });
    return {area, widest};
  }

  Planar_ring::Status cut_along(Vector normal)
  {
    normal = normal / length(normal);
    // A projection along a coordinate axis rounds nothing.
    std::size_t axis = 0;
    for (const int i : {1, 2})
      axis = std::abs(normal[i]) < std::abs(normal[int(axis)]) ? std::size_t(i) : axis;
    Vector x = cross_product(Vector(axis == 0, axis == 1, axis == 2), normal);
    x = x / length(x);
    const Vector y = cross_product(normal, x);
    std::vector<Planar_ring::Point> ring;
    std::vector<double> heights;
    for (const Vector& p : places_) {
      ring.emplace_back(p * x, p * y);
      heights.push_back(p * normal);
    }
    const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
    const double deviation = (*highest - *lowest) / 2;
    const Bbox_2 box = bbox_2(ring.begin(), ring.end());
    const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    deviation_ = (std::min)(deviation_, deviation);
    is_near_plane_ = deviation <= size / 100;

    // Corners are uncertain by their distance from a plane, and by six digits.
    Planar_ring planar(ring, (std::min)((std::max)(deviation, size * 1e-6), size / 256));
    const Planar_ring::Status status = planar.cut();
    if (status == Planar_ring::CUT)
      triangles_ = planar.triangles();
    else if (status == Planar_ring::CROSSING)
      note_crossing(planar.crossing_sides(), ring, heights, size / 100);
    else if (status == Planar_ring::OVERLAPPING && is_near_plane_ && crossing_.empty())
      crossing_ = "face " + std::to_string(face_) + " winds twice around a part of itself, beside vertex " +
                  std::to_string(polygon_[planar.overlap()]) + "; a hole has to run in the other direction";
    return status;
  }

  // Notes that two sides cross, unless they cross in the plane only and miss each other in space by more than a gap.
  void note_crossing(const std::array<std::array<std::size_t, 2>, 2>& sides,
                     const std::vector<Planar_ring::Point>& ring, const std::vector<double>& heights, double gap)
  {
    const auto [a, b] = sides[0];
    const auto [c, d] = sides[1];
    const auto area = [](const Kernel::Vector_2& v, const Kernel::Vector_2& w) {
      return v.x() * w.y() - v.y() * w.x();
    };
    const Kernel::Vector_2 one = ring[b] - ring[a], other = ring[d] - ring[c], from = ring[c] - ring[a];
    const double both = area(one, other), s = area(from, other) / both, t = area(from, one) / both;
    const double distance = heights[a] + s * (heights[b] - heights[a]) - heights[c] - t * (heights[d] - heights[c]);
    if (std::abs(distance) > gap || !crossing_.empty())
      return;
    const auto side = [this](std::size_t i, std::size_t j) {
      return std::to_string(polygon_[i]) + "-" + std::to_string(polygon_[j]);
    };
    std::ostringstream text;
    text << "face " << face_ << " crosses itself: its sides " << side(a, b) << " and " << side(c, d) << " meet at (";
    for (std::size_t i = 0; i < 3; ++i) {
      const double p = points_[polygon_[a]][i], q = points_[polygon_[b]][i];
      text << (i == 0 ? "" : ", ") << p + s * (q - p);
    }
    text << "); put its corners into order, or make a vertex there";
    crossing_ = text.str();
  }

  // Separate loops between the visits of a vertex.
  void cut_in_space(bool is_flat)
  {
    std::vector<std::size_t> path;
    std::map<std::size_t, std::size_t> place; // of each vertex in the path
    const auto cut_path = [&](std::size_t begin) {
      if (path.size() - begin >= 3)
        cut_loop({path.begin() + std::ptrdiff_t(begin), path.end()}, is_flat);
      for (; path.size() > begin; path.pop_back())
        place.erase(polygon_[path.back()]);
    };
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      if (const auto it = place.find(polygon_[i]); it != place.end())
        cut_path(it->second);
      place.emplace(polygon_[i], path.size());
      path.push_back(i);
    }
    cut_path(0);
  }

  void cut_loop(const std::vector<std::size_t>& corners, bool is_flat)
  {
    // Takes quadratic memory and cubic time: half a minute for a thousand corners.
    std::vector<Triple<int, int, int>> triples;
    if (!is_flat && corners.size() <= 200) {
      std::vector<Kernel::Point_3> points;
      for (const std::size_t c : corners)
        points.push_back(ORIGIN + places_[c]);
      Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(triples),
                                                         parameters::use_2d_constrained_delaunay_triangulation(false));
    }
    if (triples.size() == corners.size() - 2) {
      for (const auto& [i, j, k] : triples)
        triangles_.push_back({corners[std::size_t(i)], corners[std::size_t(j)], corners[std::size_t(k)]});
      return;
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles_.push_back({corners[0], corners[i - 1], corners[i]});
    if (is_flat)
      return;
    std::ostringstream text;
    text << "face " << face_ << " (" << polygon_.size() << " corners) is " << 4 * std::ldexp(deviation_, exponent_)
         << " away from any plane, and was cut into a fan of triangles, which may overlap";
    warning_ = text.str();
  }

  const std::vector<std::array<double, 3>>& points_;
  const std::vector<std::size_t>& polygon_;
  const std::size_t face_;
  std::vector<Vector> places_; // of the corners, from the first
  int exponent_ = 0;
  double deviation_ = std::numeric_limits<double>::infinity(); // from the nearest plane tried
  bool is_near_plane_ = false;                                 // the plane tried last
  std::vector<Triangle> triangles_;
  std::string crossing_, warning_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_CUTTER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One half of a surface and its exact mirror image.

#ifndef IDT_TEST_PROPERTY_MIRRORED_SURFACE_H
#define IDT_TEST_PROPERTY_MIRRORED_SURFACE_H

#include "samples/sample_surface_types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace mirrored_surface {

// Clips triangles against the plane x = 0 after a translation, and keeps the parts on the positive side.
class Clipper
{
public:
  Clipper(const samples::Indexed_triangles& surface, std::size_t axis, double offset)
  {
    for (const auto& p : surface.points)
      points_.push_back({p[axis] - offset, p[(axis + 1) % 3], p[(axis + 2) % 3]});
    for (const auto& t : surface.triangles)
      clip(t);
  }

  // The mirror image is welded to the half where both meet the plane.
  samples::Indexed_triangles mirrored() const
  {
    constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();
    samples::Indexed_triangles result;
    std::vector<std::array<std::uint32_t, 2>> number(points_.size(), {none, none});
    const auto vertex = [&](std::size_t v, std::size_t side) {
      std::uint32_t& n = number[v][points_[v][0] == 0 ? 0 : side];
      if (n == none) {
        n = std::uint32_t(result.points.size());
        auto p = points_[v];
        if (side == 1)
          p[0] = -p[0];
        result.points.push_back(p);
      }
      return n;
    };
    for (const auto& t : triangles_) {
      result.triangles.push_back({vertex(t[0], 0), vertex(t[1], 0), vertex(t[2], 0)});
      result.triangles.push_back({vertex(t[0], 1), vertex(t[2], 1), vertex(t[1], 1)});
    }
    return result;
  }

private:
  using Triangle = std::array<std::size_t, 3>;

  template <class Indices>
  void clip(const Indices& t)
  {
    std::vector<std::size_t> polygon;
    for (int i = 0; i < 3; ++i) {
      const std::size_t v = t[i], w = t[(i + 1) % 3];
      if (points_[v][0] >= 0)
        polygon.push_back(v);
      if ((points_[v][0] < 0 && points_[w][0] > 0) || (points_[v][0] > 0 && points_[w][0] < 0))
        polygon.push_back(cut((std::min)(v, w), (std::max)(v, w)));
    }
    if (std::all_of(polygon.begin(), polygon.end(), [&](std::size_t v) { return points_[v][0] == 0; }))
      return;
    for (std::size_t i = 2; i < polygon.size(); ++i)
      triangles_.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }

  std::size_t cut(std::size_t v, std::size_t w)
  {
    const auto [position, is_new] = cuts_.emplace(std::make_pair(v, w), points_.size());
    if (is_new) {
      const std::array<double, 3> p = points_[v], q = points_[w];
      const double s = p[0] / (p[0] - q[0]);
      points_.push_back({0, p[1] + s * (q[1] - p[1]), p[2] + s * (q[2] - p[2])});
    }
    return position->second;
  }

  std::vector<std::array<double, 3>> points_;
  std::vector<Triangle> triangles_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> cuts_;
};

// Cuts across an axis, at the median of the coordinates.
inline samples::Indexed_triangles mirrored(const samples::Indexed_triangles& surface, std::size_t axis)
{
  std::vector<double> x;
  for (const auto& p : surface.points)
    x.push_back(p[axis]);
  std::nth_element(x.begin(), x.begin() + std::ptrdiff_t(x.size() / 2), x.end());
  return Clipper(surface, axis, x[x.size() / 2]).mirrored();
}

} // namespace mirrored_surface

#endif // IDT_TEST_PROPERTY_MIRRORED_SURFACE_H

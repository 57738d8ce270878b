// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Places that are much nearer to each other than the edges there are long.

#include "Gap_search.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::optional<std::size_t> shortest_side(std::array<std::array<double, 3>, 3> p)
{
  for (std::array<double, 3>& point : p)
    for (double& x : point)
      x /= 4; // so that differences do not overflow
  std::array<double, 3> lengths;
  for (std::size_t i = 0; i < 3; ++i)
    lengths[i] = Vertices_on_edges::norm(Vertices_on_edges::difference(p[i], p[(i + 1) % 3]));
  const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
  if (*shortest > closeness * *longest)
    return std::nullopt;
  return std::size_t(shortest - lengths.begin());
}

// Each border edge begins where another one ends.
inline std::vector<std::uint32_t> even_numbers_below(std::size_t n)
{
  std::vector<std::uint32_t> result;
  for (std::size_t i = 0; i < n; i += 2)
    result.push_back(std::uint32_t(i));
  return result;
}

Border_gaps::Border_gaps(const std::vector<std::array<double, 3>>& points)
  : points_(points), near_(std::make_shared<Vertices_on_edges>(points, even_numbers_below(points.size())))
{}

bool Border_gaps::are_within(const std::array<double, 3>& p, const std::array<double, 3>& q) const
{
  bool result = false;
  near_->for_each_within_edge(p, q, 0, closeness, [&](std::uint32_t, double, double) { result = true; });
  return result;
}

bool Border_gaps::are_close() const
{
  bool result = false;
  for (std::size_t i = 0; i < points_.size(); i += 2)
    for (const std::size_t v : {i, i + 1})
      near_->for_each_within(
        points_[v], close_distance(Vertices_on_edges::norm(Vertices_on_edges::difference(points_[i], points_[i + 1]))),
        [&](std::uint32_t w, double) { result = result || points_[v] != points_[w]; });
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of sides_of_curve.h.

#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include "../gluing/Cut_faces.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<Surface_point>& curve)
{
  const internal::Cut_faces faces(input, curve);
  const std::vector<std::array<std::uint32_t, 3>>& triangles = faces.triangles();
  const auto key = [](std::uint32_t from, std::uint32_t to) { return (std::uint64_t(from) << 32) | to; };
  std::unordered_map<std::uint64_t, std::uint32_t> left_of; // the triangle to the left of a side
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      if (!left_of.insert({key(from, to), t}).second)
        throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, from, 1,
                                    "two edges join vertex " + std::to_string(from) + " and vertex " +
                                      std::to_string(to) + ": the corners of triangles do not tell them apart");
    }

  std::vector<Sign> result(faces.number_of_vertices(), POSITIVE), of_triangle(triangles.size(), ZERO);
  std::unordered_set<std::uint64_t> seam;
  std::vector<std::uint32_t> open;
  const auto mark = [&](std::uint32_t t, Sign sign) {
    if (of_triangle[t] == ZERO)
      open.push_back(t);
    else if (of_triangle[t] != sign)
      throw Invalid_argument_error("the curve does not separate its left side from its right one, so distances have no "
                                   "sign: it has to be closed and to cut something off");
    of_triangle[t] = sign;
  };
  const auto mark_beside = [&](std::uint32_t from, std::uint32_t to, Sign sign) {
    const auto beside = left_of.find(key(from, to));
    if (beside != left_of.end())
      mark(beside->second, sign);
  };
  for (const auto& [from, to] : faces.seam()) {
    seam.insert({key(from, to), key(to, from)});
    mark_beside(from, to, POSITIVE);
    mark_beside(to, from, NEGATIVE);
  }
  while (!open.empty()) {
    const std::uint32_t t = open.back();
    open.pop_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
      result[from] = of_triangle[t];
      if (seam.count(key(from, to)) == 0)
        mark_beside(to, from, of_triangle[t]);
    }
  }
  for (const auto& [from, to] : faces.seam())
    result[from] = result[to] = ZERO;
  result.resize(input.number_of_vertices());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

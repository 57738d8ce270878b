// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a conformal map claims, checked in rational numbers.

#ifndef IDT_TEST_PROPERTY_CONFORMAL_CLAIMS_H
#define IDT_TEST_PROPERTY_CONFORMAL_CLAIMS_H

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/conformal_parameterization.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace conformal_claims {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using IT::Conformal_map;

inline Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

inline int exact_orientation(const std::array<Conformal_map::Point, 3>& t)
{
  const auto q = [&](int i, int k) { return CGAL::Gmpq(t[std::size_t(i)][std::size_t(k)]); };
  return CGAL::sign(CGAL::Gmpq((q(1, 0) - q(0, 0)) * (q(2, 1) - q(0, 1)) - (q(1, 1) - q(0, 1)) * (q(2, 0) - q(0, 0))));
}

// What is wrong with a map; empty if nothing is.
inline std::string defect(const Conformal_map& map, const Triangulation& t)
{
  if (!map.is_certified || !map.turned.empty())
    return "it is not certified";
  std::vector<double> areas(t.input().number_of_faces(), 0.);
  std::map<std::array<std::uint32_t, 2>, std::size_t> sides;
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    if (exact_orientation(map.uv[i]) <= 0)
      return "triangle " + std::to_string(i) + " is turned over";
    // Its area, as a part of the input face.
    std::array<std::array<double, 3>, 3> b;
    for (std::size_t k = 0; k < 3; ++k)
      b[k] = map.coordinates_in_face(map.places[map.triangles[i][k]], map.input_faces[i]);
    areas[map.input_faces[i].idx()] += b[0][0] * (b[1][1] * b[2][2] - b[1][2] * b[2][1]) -
                                       b[0][1] * (b[1][0] * b[2][2] - b[1][2] * b[2][0]) +
                                       b[0][2] * (b[1][0] * b[2][1] - b[1][1] * b[2][0]);
    for (std::size_t k = 0; k < 3; ++k)
      if (!sides.insert({{map.triangles[i][k], map.triangles[i][(k + 1) % 3]}, 3 * i + k}).second)
        return "two triangles have the same side in the same direction";
  }
  for (double area : areas)
    if (!(std::abs(area - 1) < 1e-9))
      return "the triangles do not make up a face";
  for (const auto& [side, s] : sides) {
    const auto other = sides.find({side[1], side[0]});
    if (other == sides.end())
      continue;
    const auto end = [&](std::size_t x, std::size_t k) { return map.uv[x / 3][(x % 3 + k) % 3]; };
    const bool agree = end(s, 0) == end(other->second, 1) && end(s, 1) == end(other->second, 0);
    const bool is_cut = map.is_cut[s / 3][s % 3];
    if (is_cut != map.is_cut[other->second / 3][other->second % 3])
      return "a side is cut from one side alone";
    if (!agree && !is_cut)
      return "triangles " + std::to_string(s / 3) + " and " + std::to_string(other->second / 3) +
             " do not fit together";
    const auto length = [&](std::size_t x) {
      return std::hypot(end(x, 1)[0] - end(x, 0)[0], end(x, 1)[1] - end(x, 0)[1]);
    };
    if (is_cut && std::abs(length(s) - length(other->second)) > map.seam)
      return "a seam does not fit together";
  }
  return "";
}

} // namespace conformal_claims

#endif // IDT_TEST_PROPERTY_CONFORMAL_CLAIMS_H

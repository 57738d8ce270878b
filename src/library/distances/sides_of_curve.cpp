// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of sides_of_curve.h.

#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include "../gluing/Cut_faces.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

std::string name_of(std::size_t part) { return "curve " + std::to_string(part); }

// \param parts_at for each region, the parts of the curve to whose right and to whose left it lies
void check_sides(const std::map<std::uint32_t, std::array<std::set<std::size_t>, 2>>& parts_at,
                 std::size_t number_of_parts)
{
  const std::string counted = " (counted from 0)", no_sign = ", so distances have no sign: ";
  std::set<std::size_t> open;
  bool has_side[2] = {false, false};
  for (const auto& [region, parts] : parts_at) {
    std::set_intersection(parts[0].begin(), parts[0].end(), parts[1].begin(), parts[1].end(),
                          std::inserter(open, open.end()));
    for (std::size_t i : {0, 1})
      has_side[i] = has_side[i] || !parts[i].empty();
  }
  std::string names;
  for (std::size_t part : open)
    names += (names.empty() ? "" : ", ") + name_of(part);
  if (!open.empty() && number_of_parts == 1)
    throw Invalid_argument_error("the curve does not separate its left side from its right one" + no_sign +
                                 "it has to be closed, or to lead from border to border, and to cut something off");
  if (!open.empty())
    throw Invalid_argument_error(names + counted + (open.size() == 1 ? " does" : " do") +
                                 " not separate left sides from right ones" + no_sign +
                                 "curves have to be closed, or to lead from border to border, and to cut something off "
                                 "together");
  for (const auto& [region, parts] : parts_at)
    if (!parts[0].empty() && !parts[1].empty())
      throw Invalid_argument_error("the same points lie to the left of " + name_of(*parts[1].begin()) +
                                   " and to the right of " + name_of(*parts[0].begin()) + counted + no_sign +
                                   "reverse one of the curves");
  if (parts_at.empty())
    throw Invalid_argument_error("the curve has no length, and therefore no sides, so distances have no sign");
  if (!has_side[0] || !has_side[1])
    throw Invalid_argument_error(std::string("nothing lies to the ") + (has_side[1] ? "right" : "left") +
                                 " of the curve, which follows the border: distances have no sign");
}

// Whether the triangles into which a curve divides the faces lie to its left. Triangles of other components do.
std::vector<Sign> sides_of_triangles(const internal::Cut_faces& faces, std::size_t number_of_parts)
{
  const auto key = internal::Cut_faces::key;
  const auto opposite = [](std::uint64_t side) { return (side << 32) | (side >> 32); };
  std::unordered_set<std::uint64_t> seam;
  for (const auto& edge : faces.seam())
    seam.insert({key(edge.from, edge.to), key(edge.to, edge.from)});
  internal::Disjoint_sets regions(faces.triangles().size());
  for (const auto& [side, place] : faces.sides()) {
    const auto beside = faces.sides().find(opposite(side));
    if (beside != faces.sides().end() && seam.count(side) == 0)
      regions.unite(place / 3, beside->second / 3);
  }
  std::map<std::uint32_t, std::array<std::set<std::size_t>, 2>> parts_at;
  for (const auto& edge : faces.seam())
    for (std::size_t is_left : {0, 1}) {
      const auto side = faces.sides().find(is_left == 1 ? key(edge.from, edge.to) : key(edge.to, edge.from));
      if (side != faces.sides().end())
        parts_at[regions.find(side->second / 3)][is_left].insert(edge.path);
    }
  check_sides(parts_at, number_of_parts);
  std::vector<Sign> result;
  for (std::uint32_t t = 0; t < faces.triangles().size(); ++t) {
    const auto found = parts_at.find(regions.find(t));
    result.push_back(found == parts_at.end() || found->second[0].empty() ? POSITIVE : NEGATIVE);
  }
  return result;
}

// The smallest barycentric coordinate of a point in a triangle; negative outside.
double depth_in_triangle(const internal::Cut_faces& faces, const Surface_point& p, std::uint32_t triangle)
{
  std::array<std::array<double, 3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i)
    corners[i] = faces.coordinates(p.halfedge, faces.triangles()[triangle][i]);
  const auto area = [](const auto& a, const auto& b, const auto& c) {
    return (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
  };
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i)
    result = (std::min)(result, area(corners[i], corners[(i + 1) % 3], p.coordinates));
  return result / area(corners[0], corners[1], corners[2]);
}

} // namespace

std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts)
{
  const internal::Cut_faces faces(input, parts);
  const std::vector<Sign> of_triangle = sides_of_triangles(faces, parts.size());
  std::vector<Sign> result(faces.number_of_vertices(), POSITIVE);
  for (std::size_t t = 0; t < of_triangle.size(); ++t)
    for (std::uint32_t v : faces.triangles()[t])
      result[v] = of_triangle[t];
  for (const auto& edge : faces.seam())
    result[edge.from] = result[edge.to] = ZERO;
  result.resize(input.number_of_vertices());
  return result;
}

std::vector<Sign> sides_of_curve(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts,
                                 const std::vector<Surface_point>& points)
{
  const internal::Cut_faces faces(input, parts);
  const std::vector<Sign> of_triangle = sides_of_triangles(faces, parts.size());
  std::vector<std::vector<std::uint32_t>> triangles_in(input.number_of_faces());
  for (std::uint32_t t = 0; t < of_triangle.size(); ++t)
    triangles_in[faces.input_faces()[t]].push_back(t);
  std::vector<Sign> result;
  for (const Surface_point& p : points) { // the triangle where the point lies deepest decides
    double deepest = -std::numeric_limits<double>::infinity();
    result.push_back(POSITIVE);
    for (std::uint32_t t : triangles_in[input.face(p.halfedge).idx()]) {
      const double depth = depth_in_triangle(faces, p, t);
      if (depth > deepest) {
        deepest = depth;
        result.back() = of_triangle[t];
      }
    }
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removes faces without area from a glued surface, without changing its metric.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H

#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Vertex_number_pair = std::pair<std::uint32_t, std::uint32_t>;

// Triangles in space with glued sides. Side 3f + i runs from corner i of face f to corner i + 1.
struct Glued_faces
{
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::vector<std::uint32_t> face_of; // for each face, the face of which it is a copy or a part of a copy
  std::vector<bool> is_back;
  Large_vector<std::uint32_t> corners;  // for each side the vertex where it begins
  Large_vector<std::uint32_t> glued_to; // for each side its partner, or none

  std::size_t size() const { return face_of.size(); }

  void glue(std::uint32_t s, std::uint32_t t)
  {
    glued_to[s] = t;
    glued_to[t] = s;
  }
  // Removes faces.
  void keep(const std::vector<bool>& is_kept)
  {
    std::vector<std::uint32_t> new_number(size(), none);
    std::uint32_t n = 0;
    for (std::uint32_t f = 0; f < size(); ++f)
      if (is_kept[f])
        new_number[f] = n++;
    for (std::uint32_t f = 0; f < size(); ++f) {
      const std::uint32_t g = new_number[f];
      if (g == none)
        continue;
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t t = glued_to[3 * f + i];
        glued_to[3 * g + i] = t == none ? none : 3 * new_number[t / 3] + t % 3;
        corners[3 * g + i] = corners[3 * f + i];
      }
      face_of[g] = face_of[f];
      is_back[g] = is_back[f];
    }
    corners.resize(3 * n);
    glued_to.resize(3 * n);
    face_of.resize(n);
    is_back.resize(n);
  }
};

// The longest side of a face without area runs past its third corner. Flipping it cuts the face on its other side
// there, into two triangles that lie in space where that face did. If both faces have no area, this can make an edge
// between two corners at the same place. Such an edge is shrunk to a point: its faces vanish, and their other sides are
// united in pairs. In a closed part that has an area, no face without area remains: from each one, ever longer longest
// sides lead to a face with an area, or to one with the same longest side. All flipped edges are not Delaunay.
class Flat_face_remover
{
public:
  Flat_face_remover(const Points& points, Glued_faces& faces)
    : points_(points), faces_(faces), is_kept_(faces.size(), true)
  {}

  // \param flat the faces without area
  // \return the pairs of different vertices that turned out to be at one point
  std::vector<Vertex_number_pair> run(std::vector<std::uint32_t> flat)
  {
    std::vector<Vertex_number_pair> pairs;
    while (!flat.empty()) {
      const std::uint32_t face = flat.back();
      std::uint32_t s;
      if (!is_kept_[face] || !is_flat(face) || !find_flippable_side(face, s)) {
        flat.pop_back();
        continue;
      }
      const std::uint32_t a = s / 3, b = faces_.glued_to[s] / 3;
      flip(s);
      const std::uint32_t v = faces_.corners[3 * a + 1], w = faces_.corners[3 * a + 2];
      if (points_[v] != points_[w]) {
        flat.insert(flat.end(), {a, b});
        continue;
      }
      shrink(a, 3 * a, 3 * a + 2);
      shrink(b, 3 * b, 3 * b + 1);
      if (v != w)
        pairs.push_back({v, w});
    }
    faces_.keep(is_kept_);
    return pairs;
  }

private:
  bool is_flat(std::uint32_t face) const
  {
    const std::uint32_t* const v = faces_.corners.data() + 3 * face;
    return are_collinear(points_[v[0]], points_[v[1]], points_[v[2]]);
  }

  // The side opposite to the corner between the other two. \pre is_flat(face)
  std::uint32_t longest_side(std::uint32_t face) const
  {
    for (std::uint32_t i = 0; i < 2; ++i) {
      const auto &p = points_[faces_.corners[3 * face + i]], &q = points_[faces_.corners[3 * face + (i + 1) % 3]],
                 &r = points_[faces_.corners[3 * face + (i + 2) % 3]];
      if ((q < p) != (r < p)) // on a line, points are in the order of their coordinates
        return 3 * face + i + 1;
    }
    return 3 * face;
  }

  // Follows longest sides from a face without area. \return whether they end at one that is not on the border
  bool find_flippable_side(std::uint32_t face, std::uint32_t& side) const
  {
    for (;;) {
      side = longest_side(face);
      const std::uint32_t other = faces_.glued_to[side];
      if (other == Glued_faces::none)
        return false;
      face = other / 3;
      if (!is_flat(face) || longest_side(face) == other)
        return true;
    }
  }

  // Flips the side from i to j of face a, with k to its left and l on the other side in face b: the faces become (i, l,
  // k) and (l, j, k), parts of face b.
  void flip(std::uint32_t side)
  {
    const std::uint32_t ij = side, ji = faces_.glued_to[side], a = ij / 3, b = ji / 3;
    const std::uint32_t jk = next_side(ij), ki = previous_side(ij), il = next_side(ji), lj = previous_side(ji);
    const std::uint32_t i = faces_.corners[ij], j = faces_.corners[ji], k = faces_.corners[ki], l = faces_.corners[lj];
    const std::array<std::uint32_t, 4> before = {il, ki, lj, jk}, after = {3 * a, 3 * a + 2, 3 * b, 3 * b + 1};
    std::array<std::uint32_t, 4> partner;
    for (std::size_t n = 0; n < 4; ++n) {
      partner[n] = faces_.glued_to[before[n]];
      const auto found = std::find(before.begin(), before.end(), partner[n]);
      if (found != before.end())
        partner[n] = after[std::size_t(found - before.begin())];
    }
    for (std::size_t n = 0; n < 4; ++n) {
      if (partner[n] == Glued_faces::none)
        faces_.glued_to[after[n]] = Glued_faces::none;
      else
        faces_.glue(after[n], partner[n]);
    }
    faces_.glue(3 * a + 1, 3 * b + 2);
    const std::array<std::uint32_t, 6> corners = {i, l, k, l, j, k};
    std::copy(corners.begin(), corners.begin() + 3, faces_.corners.begin() + 3 * a);
    std::copy(corners.begin() + 3, corners.end(), faces_.corners.begin() + 3 * b);
    faces_.face_of[a] = faces_.face_of[b];
    faces_.is_back[a] = faces_.is_back[b];
  }

  // Removes a face whose third side has length zero, and glues its neighbors beyond the other two sides.
  void shrink(std::uint32_t face, std::uint32_t first, std::uint32_t second)
  {
    is_kept_[face] = false;
    const std::uint32_t s = faces_.glued_to[first], t = faces_.glued_to[second];
    if (s == second)
      return;
    if (s != Glued_faces::none)
      faces_.glued_to[s] = t;
    if (t != Glued_faces::none)
      faces_.glued_to[t] = s;
  }

  const Points& points_;
  Glued_faces& faces_;
  std::vector<bool> is_kept_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_COVER_FLAT_FACE_REMOVER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sample surfaces that no indexed triangles can express: lengths and gluings
// alone, with loops, multiple edges and faces that are glued to themselves.

#ifndef IDT_SAMPLES_SAMPLE_GLUINGS_H
#define IDT_SAMPLES_SAMPLE_GLUINGS_H

#include "samples/sample_surface_tools.h"
#include "samples/sample_surface_types.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace samples {

inline void require_triangle_inequality(double a, double b, double c)
{
  require_sample_argument(a > 0 && b > 0 && c > 0 && a < b + c && b < c + a && c < a + b,
                          "three lengths violate the strict triangle inequality");
}

// A flat torus made of two congruent triangles, with one vertex.
//
// All three edges are loops. Good as the smallest closed surface with a flip, and for testing code
// that looks edges up by their end vertices.
// Euler characteristic 0; 1 vertex, 3 edges, 2 faces.
// \param a,b,c the lengths of the edges, which satisfy the strict triangle inequality
inline Glued_triangles one_vertex_torus(double a = 1, double b = 1.25, double c = 2)
{
  require_triangle_inequality(a, b, c);
  // The second triangle is the first, turned by half a turn.
  return {2, {{0, 3}, {1, 4}, {2, 5}}, {a, b, c, a, b, c}};
}

// The flat torus of the lattice of (1, 0) and (shear, 1), with one vertex.
//
// For an integer shear this is the square torus, up to the rounding of the lengths, triangulated by
// two slivers. Good for long chains of flips on three edges, about |shear| of them, and for edges
// that cross few input edges very often.
// Euler characteristic 0; 1 vertex, 3 edges, 2 faces.
// \param shear at most about 1e5 in absolute value; beyond that the rounded lengths form no triangle
inline Glued_triangles sheared_one_vertex_torus(double shear = 100)
{
  return one_vertex_torus(1, std::sqrt(1 + shear * shear), std::sqrt(1 + (shear + 1) * (shear + 1)));
}

// An isosceles triangle whose two legs are glued: a cone.
//
// The leg ends at a vertex of degree 1, the base is a loop on the boundary. Good for an edge that
// has the same face on both sides, which cannot be flipped.
// Euler characteristic 1; 2 vertices, 2 edges, 1 face, 1 boundary edge.
// \param leg the length of the two glued sides
// \param base the length of the third side, below twice the leg
inline Glued_triangles self_glued_triangle(double leg = 1, double base = 1)
{
  require_triangle_inequality(leg, leg, base);
  return {1, {{0, 1}}, {leg, leg, base}};
}

// Two cones that are glued along their bases: a sphere of two self-glued triangles.
//
// Good as the smallest closed surface with self-glued faces; the base, a loop, is the one edge
// that can be flipped.
// Euler characteristic 2; 3 vertices, 3 edges, 2 faces.
// \param first_leg,second_leg the lengths of the two pairs of glued sides
// \param base the length of the common base, below twice the legs
inline Glued_triangles self_glued_sphere(double first_leg = 1, double second_leg = 1.5, double base = 1)
{
  require_triangle_inequality(first_leg, first_leg, base);
  require_triangle_inequality(second_leg, second_leg, base);
  return {2, {{0, 1}, {3, 4}, {2, 5}}, {first_leg, first_leg, base, second_leg, second_leg, base}};
}

// Triangles that are glued at random, with random lengths in [1, 1.9).
//
// The lengths satisfy the strict triangle inequality for every gluing. The surface is oriented;
// it may have loops, multiple edges, self-glued faces, any genus, and, unless `connected` is set,
// several components. Good for property tests of the combinatorics.
// The Euler characteristic depends on the gluing and is usually far below zero: F faces have at
// least 3 F / 2 edges, and a random gluing leaves few vertices.
// \param number_of_faces at least 1; even if there is no boundary
// \param seed of the gluing and the lengths
// \param with_boundary whether about a quarter of the sides that are free to choose, at least one, stay unglued
// \param connected glues each face to an earlier one first
inline Glued_triangles random_gluing(std::size_t number_of_faces, std::uint64_t seed, bool with_boundary = false,
                                     bool connected = false)
{
  require_sample_argument(number_of_faces >= 1, "a gluing has a face at least");
  require_sample_argument(number_of_faces < std::numeric_limits<std::uint32_t>::max() / 3, "too many faces");
  require_sample_argument(with_boundary || number_of_faces % 2 == 0, "a closed surface has an even number of faces");
  Sample_random random(seed);
  Glued_triangles gluing;
  gluing.number_of_faces = number_of_faces;
  gluing.side_lengths.resize(3 * number_of_faces);
  for (double& length : gluing.side_lengths)
    length = random.uniform(1, 1.9);

  std::vector<std::uint32_t> free_sides;
  const auto take_free_side = [&free_sides, &random] {
    std::swap(free_sides[random.below(free_sides.size())], free_sides.back());
    const std::uint32_t side = free_sides.back();
    free_sides.pop_back();
    return side;
  };
  const auto glue = [&gluing](std::uint32_t first, std::uint32_t second) {
    gluing.glued_sides.push_back({first, second});
    gluing.side_lengths[second] = gluing.side_lengths[first];
  };

  for (std::size_t face = 0; face < number_of_faces; ++face) {
    std::uint32_t glued_corner = 3; // none
    if (connected && face > 0) {
      glued_corner = static_cast<std::uint32_t>(random.below(3));
      glue(take_free_side(), static_cast<std::uint32_t>(3 * face) + glued_corner);
    }
    for (std::uint32_t corner = 0; corner < 3; ++corner)
      if (corner != glued_corner)
        free_sides.push_back(static_cast<std::uint32_t>(3 * face) + corner);
  }
  const std::size_t number_of_boundary_sides = with_boundary ? 1 + free_sides.size() / 4 : 0;
  while (free_sides.size() >= number_of_boundary_sides + 2) {
    const std::uint32_t first = take_free_side();
    glue(first, take_free_side());
  }
  return gluing;
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_GLUINGS_H

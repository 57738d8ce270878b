// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Flat surfaces with exact squared lengths, which can be sheared any distance.

#ifndef IDT_SAMPLES_SAMPLE_EXACT_GLUINGS_H
#define IDT_SAMPLES_SAMPLE_EXACT_GLUINGS_H

#include "samples/sample_surface_tools.h"

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace samples {

namespace IT = CGAL::Intrinsic_triangulations;

// Triangles with a squared length for each side, glued.
inline IT::Exact_gluing exact_gluing(std::size_t number_of_faces,
                                     const std::vector<std::array<std::uint32_t, 2>>& glued_sides,
                                     const std::vector<IT::Rational>& squared_side_lengths)
{
  IT::Exact_gluing gluing;
  gluing.complex = IT::make_Delta_complex_from_gluing(number_of_faces, glued_sides);
  gluing.squared_lengths.resize(gluing.complex.number_of_edges());
  for (IT::Face_index f : gluing.complex.faces()) {
    IT::Halfedge_index h = gluing.complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = gluing.complex.next(h))
      gluing.squared_lengths[gluing.complex.edge(h).idx()] = squared_side_lengths[3 * f.idx() + i];
  }
  return gluing;
}

// The flat torus of the lattice of two vectors u and v, with one vertex, as the triangles with the sides u, v and u +
// v.
//
// Euler characteristic 0; 1 vertex, 3 edges, 2 faces.
// \param u, v vectors that are linearly independent
inline IT::Exact_gluing lattice_torus(const std::array<IT::Integer, 2>& u, const std::array<IT::Integer, 2>& v)
{
  require_sample_argument(u[0] * v[1] != u[1] * v[0], "two vectors span no lattice");
  const auto square = [](const IT::Integer& x, const IT::Integer& y) { return IT::Rational(x * x + y * y); };
  const IT::Rational a = square(u[0], u[1]), b = square(v[0], v[1]), c = square(u[0] + v[0], u[1] + v[1]);
  return exact_gluing(2, {{0, 3}, {1, 4}, {2, 5}}, {a, b, c, a, b, c});
}

// The same as sheared_one_vertex_torus() of a double, without rounding: the lattice of (1, 0) and (shear, 1).
inline IT::Exact_gluing sheared_one_vertex_torus(const IT::Integer& shear)
{
  return lattice_torus({IT::Integer(1), IT::Integer(0)}, {shear, IT::Integer(1)});
}

// The lattice of (F, F') and (F', F'') with three consecutive Fibonacci numbers, whose reduction takes the most twists
// for their size.
// \param n the index of the first, at least 2
inline IT::Exact_gluing Fibonacci_torus(std::size_t n)
{
  require_sample_argument(n >= 2, "a Fibonacci torus needs three numbers");
  IT::Integer a(1), b(1), c(0); // F1, F1, F0
  for (std::size_t i = 1; i < n; ++i) {
    const IT::Integer sum = a + b;
    c = std::move(b);
    b = std::move(a);
    a = sum;
  }
  return lattice_torus({a, b}, {b, c});
}

// Triangles with a squared length for each side, into which tubes of two faces can be inserted.
struct Tubed_triangles
{
  std::size_t number_of_faces = 0;
  std::vector<std::array<std::uint32_t, 2>> glued_sides;
  std::vector<IT::Rational> squared_side_lengths;

  // Opens the surface along a pair of glued sides, which form a loop, and glues a tube into the gap.
  // \param pair the index of the pair of sides
  // \param squared_height the square of the height of the tube
  // \param shear the slant of an edge from the first side of the pair to the second, in circumferences of the tube
  void insert_tube(std::size_t pair, const IT::Rational& squared_height, const IT::Rational& shear)
  {
    const std::uint32_t second = glued_sides[pair][1];
    const std::uint32_t top = append_tube(glued_sides[pair][0], squared_height, shear);
    glued_sides[pair] = {second, top};
  }

  // The same at a side that is not glued, and is a loop; the other end of the tube is on the border.
  // \return the side at that end
  std::uint32_t append_tube(std::uint32_t side, const IT::Rational& squared_height, const IT::Rational& shear)
  {
    const IT::Rational a = squared_side_lengths[side];
    const IT::Rational right = shear * shear * a + squared_height,
                       left = (shear + 1) * (shear + 1) * a + squared_height;
    const auto lower = static_cast<std::uint32_t>(3 * number_of_faces), upper = lower + 3;
    number_of_faces += 2;
    squared_side_lengths.insert(squared_side_lengths.end(), {a, right, left, a, right, left});
    glued_sides.push_back({side, lower});
    glued_sides.push_back({lower + 1, upper + 1});
    glued_sides.push_back({lower + 2, upper + 2});
    return upper;
  }

  IT::Exact_gluing gluing() const { return exact_gluing(number_of_faces, glued_sides, squared_side_lengths); }
};

// Two equilateral triangles, glued along a side, and twice along a tube of length one, which is sheared: a surface of
// genus 2.
//
// Euler characteristic -2; 1 vertex, 9 edges, 6 faces.
inline IT::Exact_gluing sheared_genus_two(const IT::Integer& first_shear, const IT::Integer& second_shear)
{
  Tubed_triangles triangles{2, {{0, 3}, {1, 4}, {2, 5}}, std::vector<IT::Rational>(6, IT::Rational(1))};
  triangles.insert_tube(0, IT::Rational(1), IT::Rational(first_shear));
  triangles.insert_tube(1, IT::Rational(1), IT::Rational(second_shear));
  return triangles.gluing();
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_EXACT_GLUINGS_H

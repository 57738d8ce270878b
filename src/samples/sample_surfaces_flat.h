// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sample surfaces made of flat pieces: grids, strips and pillows whose flips
// can be counted by hand, and families that floating point gets wrong.

#ifndef IDT_SAMPLES_SAMPLE_SURFACES_FLAT_H
#define IDT_SAMPLES_SAMPLE_SURFACES_FLAT_H

#include "samples/sample_surface_tools.h"
#include "samples/sample_surface_types.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace samples {

// A prism over a regular polygon of radius 1, of height 5.
//
// Both polygons are fans around their first vertex, and each side is split by a diagonal.
// Good for true ties (all corners of a polygon are cocircular, and so are those of a side):
// with rounded decisions the same edges flip forever.
// Euler characteristic 2; `2 * n` vertices, `4 * n - 4` faces.
// \param n the number of corners of the polygon, at least 3
// \param rotation_seed of the rigid rotation, 0 for none
inline Indexed_triangles prism(std::size_t n = 80, std::uint64_t rotation_seed = 0)
{
  require_sample_argument(n >= 3, "a prism has 3 sides at least");
  Indexed_triangles surface;
  for (double height : {0.0, 5.0})
    for (std::size_t corner = 0; corner < n; ++corner) {
      const double angle = 2 * sample_pi * corner / n;
      surface.points.push_back({std::cos(angle), std::sin(angle), height});
    }
  append_grid(surface, n, 2, true, false, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  for (std::size_t corner = 1; corner + 1 < n; ++corner) {
    append_triangle(surface, 0, corner + 1, corner);
    append_triangle(surface, n, n + corner, n + corner + 1);
  }
  rotate_sample(surface.points, rotation_seed);
  return surface;
}

// A kite with a chain of vertices near its long diagonal.
//
// The 21 points `k / 20` of a line are raised to the height `bulge * sin(pi k / 20)`. An apex above is
// joined to the chain, an apex below to its two ends, and the thin polygon between the chain and the line
// is a fan around point 0.
// Good for caps: triangles with an angle near pi whose height is below any tolerance. With bulge 0
// and no rotation, 19 faces have three distinct corners and exactly zero area.
// Euler characteristic 1; 23 vertices, 40 faces, 4 boundary edges.
// \param bulge the height of the chain, in [0, 1)
// \param rotation_seed of the rigid rotation, 0 for none
inline Indexed_triangles cap(double bulge = 1e-10, std::uint64_t rotation_seed = 0)
{
  require_sample_argument(bulge >= 0 && bulge < 1, "a bulge lies in [0, 1)");
  const std::size_t last = 20, above = last + 1, below = last + 2;
  Indexed_triangles surface;
  for (std::size_t k = 0; k <= last; ++k) {
    // Both ends lie on the line, which sin(pi) misses by a rounding error.
    const double lift = std::sin(sample_pi * static_cast<double>(std::min(k, last - k)) / last);
    surface.points.push_back({static_cast<double>(k) / last, bulge * lift, 0});
  }
  surface.points.push_back({0.5, 1, 0});
  surface.points.push_back({0.5, -1, 0});
  for (std::size_t k = 0; k < last; ++k)
    append_triangle(surface, k, k + 1, above);
  for (std::size_t k = 1; k < last; ++k)
    append_triangle(surface, 0, k + 1, k);
  append_triangle(surface, 0, below, last);
  rotate_sample(surface.points, rotation_seed);
  return surface;
}

// A wavy square sheet that is squeezed in x and z, with wavy rows.
//
// Every triangle is a sliver, but none is degenerate: with the scale s, the squared area divided by the
// fourth power of the longest side is about s squared.
// Good for termination: the input is valid, but at scales of 1e-9 and less, edge lengths in double
// precision lose the small directions altogether, so flips can go on forever or stop too early.
// Euler characteristic 1; `n * n` vertices, `2 * (n - 1) * (n - 1)` faces, `4 * (n - 1)` boundary
// edges: 1,600 vertices and 3,042 faces with the default arguments.
// \param n the number of vertices in each direction, at least 2
// \param scale_x the width of the sheet of length 1, in [1e-12, 1]
// \param scale_z the scale of the waves, in [0, 1]
inline Indexed_triangles sliver_sheet(std::size_t n = 40, double scale_x = 1e-9, double scale_z = 1e-9)
{
  require_sample_argument(n >= 2, "a sheet has 2 vertices in each direction at least");
  require_sample_argument(scale_x >= 1e-12 && scale_x <= 1, "the scale of x lies in [1e-12, 1]");
  require_sample_argument(scale_z >= 0 && scale_z <= 1, "the scale of z lies in [0, 1]");
  Indexed_triangles surface;
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column) {
      const double x = static_cast<double>(column) / (n - 1), y = static_cast<double>(row) / (n - 1);
      const double z = 0.2 * std::sin(7 * x + 2 * y) * std::cos(5 * y - x);
      const double y_shift = 0.3 / n * std::sin(40 * x + 17 * y);
      surface.points.push_back({scale_x * x, y + y_shift, scale_z * z});
    }
  append_grid(surface, n, n, false, false, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  return surface;
}

// Unit squares in a plane, each split by a random diagonal.
//
// Good for ties: every diagonal is one. Without rotation there is nothing to flip,
// and the Delaunay tessellation consists of the squares. With a rotation, rounding breaks the ties.
// Euler characteristic 1; `(columns + 1) * (rows + 1)` vertices, `2 * columns * rows` faces,
// `2 * (columns + rows)` boundary edges.
// \param columns the number of squares to the right, at least 1
// \param rows the number of squares upwards, at least 1
// \param seed of the random diagonals
// \param rotation_seed of the rigid rotation, 0 for none
inline Indexed_triangles random_diagonal_grid(std::size_t columns = 40, std::size_t rows = 40, std::uint64_t seed = 1,
                                              std::uint64_t rotation_seed = 0)
{
  require_sample_argument(columns >= 1 && rows >= 1, "a grid has a square at least");
  Indexed_triangles surface;
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column <= columns; ++column)
      surface.points.push_back({static_cast<double>(column), static_cast<double>(row), 0});
  Sample_random random(seed);
  append_grid(surface, columns + 1, rows + 1, false, false,
              [&random](std::size_t, std::size_t) { return random.coin() ? Diagonal::RISING : Diagonal::FALLING; });
  rotate_sample(surface.points, rotation_seed);
  return surface;
}

// A grid of unit squares in a plane, sheared along its rows.
//
// Good for many flips with few vertices: each row slides back over the next, and an integer shear
// ends in the ties of the square grid. The coordinates are exact for integer shears.
// Euler characteristic 1; `(columns + 1) * (rows + 1)` vertices, `2 * columns * rows` faces,
// `2 * (columns + rows)` boundary edges.
// \param columns the number of squares to the right, at least 1
// \param rows the number of squares upwards, at least 1
// \param shear by how much each row of points is shifted against the one below
inline Indexed_triangles sheared_grid(std::size_t columns = 40, std::size_t rows = 40, double shear = 5)
{
  require_sample_argument(columns >= 1 && rows >= 1, "a grid has a square at least");
  Indexed_triangles surface;
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column <= columns; ++column)
      surface.points.push_back({column + shear * row, static_cast<double>(row), 0});
  append_grid(surface, columns + 1, rows + 1, false, false, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  return surface;
}

// A long thin strip between two rows of points, in which every edge leans far to one side.
//
// Lower point `k` lies at `(k, 0)`, upper point `k` at `(k + 1/2, width)`; upper point `k` is joined
// to the lower points `k + shift` and `k + shift + 1` as far as these exist, with a fan at each end.
// Each flip moves an edge across the strip one step back towards upright, so
// the number of flips does not depend on their order: about `n * shift`.
// Good for many flips, and for intrinsic edges that cross many input edges: with the default arguments,
// 19,997 edges need 298,110 flips, and most of the final edges cross about 2 * `shift` input edges.
// Euler characteristic 1; `2 * n` vertices, `2 * n - 2` faces, `2 * n` boundary edges.
// \param n the number of points of each row, at least 2
// \param shift by how many points the edges lean to the right, below `n`
// \param width the distance between the two rows; the points in a row are 1 apart
inline Indexed_triangles strip(std::size_t n = 5000, std::size_t shift = 60, double width = 1)
{
  require_sample_argument(n >= 2 && shift < n, "a strip has 2 points a row at least, and more than the shift");
  require_sample_argument(width > 0, "a strip has a positive width");
  Indexed_triangles surface;
  for (std::size_t k = 0; k < n; ++k)
    surface.points.push_back({static_cast<double>(k), 0, 0});
  for (std::size_t k = 0; k < n; ++k)
    surface.points.push_back({k + 0.5, width, 0});
  std::size_t lower = 0, upper = 0;
  while (lower + 1 < n || upper + 1 < n)
    if (lower + 1 < n && (lower <= upper + shift || upper + 1 == n)) {
      append_triangle(surface, lower, lower + 1, n + upper);
      ++lower;
    } else {
      append_triangle(surface, lower, n + upper + 1, n + upper);
      ++upper;
    }
  return surface;
}

// Two copies of a parallelogram, glued along the border, that need a huge number of flips.
//
// All vertices lie on the border, half of them on the lower side from (0, 0) to (1, 0) and half of
// them on the upper side from (-1, `width`) to (0, `width`). Between two straight rows of points an
// edge can be flipped only one step at a time. The front starts with a fan from the upper left corner
// to the lower side and one from the lower right corner to the upper side, and has to end with
// the fans of the other two corners. On the front alone, this would take `(n / 2 - 1)` squared flips in
// any order. The back is nearly the same, offset by one step, so no two edges join the same vertices.
// Flips of the border edges add a few percent.
// Good for long chains of flips that run through vertices of degree about `n / 2`, for loops, and for
// ties between the two mirrored sides: about `n * n / 2` flips, that is, 46,600 to 48,800 with 300 vertices
// and 4.6 to 5 million with 3,000, depending on the order of the flips.
// Euler characteristic 2; `n` vertices, `2 * n - 4` faces. Both sides lie in the plane z = 0.
// \param n the number of vertices, even, at least 6
// \param width the distance between the two sides of length 1
inline Indexed_triangles pillow(std::size_t n = 300, double width = 1)
{
  require_sample_argument(n >= 6 && n % 2 == 0, "a pillow has an even number of vertices, 6 at least");
  require_sample_argument(width > 0, "a pillow has a positive width");
  const std::size_t m = n / 2;
  Indexed_triangles surface;
  for (std::size_t k = 0; k < m; ++k)
    surface.points.push_back({static_cast<double>(k) / (m - 1), 0, 0});
  for (std::size_t k = 0; k < m; ++k)
    surface.points.push_back({static_cast<double>(k) / (m - 1) - 1, width, 0});
  const auto lower = [](std::size_t k) { return k; };
  const auto upper = [m](std::size_t k) { return m + k; };
  // front
  for (std::size_t k = 0; k + 1 < m; ++k) {
    append_triangle(surface, lower(k), lower(k + 1), upper(0));
    append_triangle(surface, upper(k + 1), upper(k), lower(m - 1));
  }
  // back
  append_triangle(surface, upper(0), upper(1), lower(0));
  for (std::size_t k = 0; k + 2 < m; ++k) {
    append_triangle(surface, lower(k + 1), lower(k), upper(1));
    append_triangle(surface, upper(k + 1), upper(k + 2), lower(m - 2));
  }
  append_triangle(surface, lower(m - 1), lower(m - 2), upper(m - 1));
  return surface;
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_SURFACES_FLAT_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sample surfaces that bend in space: spheres, tori, disks, a tube, a
// lantern. The shapes are smooth; only the triangulations are bad.

#ifndef IDT_SAMPLES_SAMPLE_SURFACES_CURVED_H
#define IDT_SAMPLES_SAMPLE_SURFACES_CURVED_H

#include "samples/sample_surface_tools.h"
#include "samples/sample_surface_types.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace samples {

// \cond SKIP_IN_MANUAL
// Moves a point of the unit sphere along its radius.
inline std::array<double, 3> bumped(double x, double y, double z, double bump_height)
{
  const double radius = 1 + bump_height * std::sin(6 * x + 1) * std::sin(5 * y + 2) * std::sin(7 * z + 0.5);
  return {radius * x, radius * y, radius * z};
}

// \endcond

// The unit sphere with meridians and parallels, each cell split in two,
// and a fan around each pole.
//
// Good for needles at the poles, and for ties that rounding breaks: each cell is a symmetric trapezoid.
// Euler characteristic 2; `columns * (rows - 1) + 2` vertices, `2 * columns * (rows - 1)` faces.
// \param columns the number of meridians, at least 3
// \param rows the number of bands from pole to pole, at least 2
inline Indexed_triangles latitude_longitude_sphere(std::size_t columns = 60, std::size_t rows = 30)
{
  require_sample_argument(columns >= 3 && rows >= 2, "a sphere has 3 columns and 2 rows at least");
  Indexed_triangles surface;
  for (std::size_t row = 1; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double latitude = sample_pi * (static_cast<double>(row) / rows - 0.5);
      const double longitude = 2 * sample_pi * column / columns;
      surface.points.push_back(
        {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude), std::sin(latitude)});
    }
  append_grid(surface, columns, rows - 1, true, false, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  append_fan(surface, 0, columns, {0, 0, -1}, false);
  append_fan(surface, (rows - 2) * columns, columns, {0, 0, 1}, true);
  return surface;
}

// A sphere with smooth bumps and many needles and obtuse triangles.
//
// Points on a grid of meridians and parallels are shifted at random,
// the meridians are twisted around the axis, and each cell is split at random.
// Good as a typical bad mesh: nearly as many flips as vertices, nothing degenerate, no ties.
// Euler characteristic 2; `columns * (rows - 1) + 2` vertices, `2 * columns * (rows - 1)` faces:
// 5,002 vertices and 10,000 faces with the default arguments.
// \param columns the number of meridians, at least 3
// \param rows the number of bands from pole to pole, at least 2
// \param bump_height the largest change of the radius 1, in [0, 1)
// \param seed of the random shifts and diagonals
inline Indexed_triangles bumpy_sphere(std::size_t columns = 100, std::size_t rows = 51, double bump_height = 0.3,
                                      std::uint64_t seed = 1)
{
  require_sample_argument(columns >= 3 && rows >= 2, "a sphere has 3 columns and 2 rows at least");
  require_sample_argument(bump_height >= 0 && bump_height < 1, "a bump height lies in [0, 1)");
  const double largest_shift = 0.2; // of a cell; below 1/4 all cells stay convex
  const double twist = 1;           // radians from the equator to a pole
  Sample_random random(seed);
  Indexed_triangles surface;
  for (std::size_t row = 1; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double row_shift = random.uniform(-largest_shift, largest_shift);
      const double column_shift = random.uniform(-largest_shift, largest_shift);
      const double height = 2 * (row + row_shift) / rows - 1; // in (-1, 1)
      const double latitude = 0.5 * sample_pi * height;
      const double longitude = 2 * sample_pi * (column + column_shift) / columns + twist * height;
      surface.points.push_back(bumped(std::cos(latitude) * std::cos(longitude),
                                      std::cos(latitude) * std::sin(longitude), std::sin(latitude), bump_height));
    }
  append_grid(surface, columns, rows - 1, true, false,
              [&random](std::size_t, std::size_t) { return random.coin() ? Diagonal::RISING : Diagonal::FALLING; });
  append_fan(surface, 0, columns, bumped(0, 0, -1, bump_height), false);
  append_fan(surface, (rows - 2) * columns, columns, bumped(0, 0, 1, bump_height), true);
  return surface;
}

// A round disk with a tall thin spike in the middle.
//
// Seen from above, the rings of the disk are evenly spaced, so the triangles on the flanks of the spike
// are needles. The rings are also twisted, which makes the triangles around the spike obtuse.
// Good for parameterization: with the default arguments, 480 of the 2,920 extrinsic weights of interior
// edges are negative, and the spike has little room in the plane.
// Euler characteristic 1; `columns * rings + 1` vertices, `columns * (2 * rings - 1)` faces,
// `columns` boundary edges: 1,001 vertices and 1,960 faces with the default arguments.
// \param columns the number of vertices of each ring, at least 3
// \param rings the number of rings, the boundary included, at least 1
// \param height of the spike over the disk of radius 1
// \param width the distance from the axis at which the height has fallen by the factor e
inline Indexed_triangles disk_with_spike(std::size_t columns = 40, std::size_t rings = 25, double height = 3,
                                         double width = 0.1)
{
  require_sample_argument(columns >= 3 && rings >= 1, "a disk has 3 columns and 1 ring at least");
  require_sample_argument(width > 0, "a spike has a positive width");
  const double twist = 2; // radians from the axis to the boundary
  Indexed_triangles surface;
  for (std::size_t ring = 1; ring <= rings; ++ring)
    for (std::size_t column = 0; column < columns; ++column) {
      const double radius = static_cast<double>(ring) / rings;
      // Clockwise, so that triangles are counterclockwise when seen from above.
      const double angle = -2 * sample_pi * column / columns + twist * radius;
      surface.points.push_back(
        {radius * std::cos(angle), radius * std::sin(angle), height * std::exp(-(radius / width) * (radius / width))});
    }
  append_grid(surface, columns, rings, true, false, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  append_fan(surface, 0, columns, {0, 0, height}, false);
  return surface;
}

// A dome with smooth bumps, open below, whose triangles wind around its axis.
//
// Like `bumpy_sphere()`, but a disk, and with a twist that stretches the triangles across the
// bumps. The vertices of the boundary are not shifted along the meridians.
// Good for parameterization and for pictures. With the default arguments, the harmonic map to the unit
// disk by the extrinsic operator turns 8 triangles over. The intrinsic triangulation has no loops and no
// multiple edges, and the map by its operator turns none over.
// Euler characteristic 1; `columns * rows + 1` vertices, `columns * (2 * rows - 1)` faces, `columns`
// boundary edges: 433 vertices and 840 faces with the default arguments.
// \param columns the number of vertices of each ring, at least 3
// \param rows the number of rings, the boundary included, at least 1
// \param bump_height the largest change of the radius 1, in [0, 1)
// \param twist of the meridians, in radians from the pole to the boundary
// \param seed of the random shifts and diagonals
inline Indexed_triangles bumpy_dome(std::size_t columns = 24, std::size_t rows = 18, double bump_height = 0.2,
                                    double twist = 8, std::uint64_t seed = 1)
{
  require_sample_argument(columns >= 3 && rows >= 1, "a dome has 3 columns and 1 row at least");
  require_sample_argument(bump_height >= 0 && bump_height < 1, "a bump height lies in [0, 1)");
  const double largest_shift = 0.24;       // of a cell; below 1/4 all cells stay convex
  const double boundary = 0.7 * sample_pi; // radians from the pole
  Sample_random random(seed);
  Indexed_triangles surface;
  for (std::size_t row = 1; row <= rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double row_shift = row < rows ? random.uniform(-largest_shift, largest_shift) : 0;
      const double column_shift = random.uniform(-largest_shift, largest_shift);
      const double height = (row + row_shift) / rows; // 0 at the pole, 1 at the boundary
      // Clockwise, so that triangles are counterclockwise when seen from outside.
      const double longitude = -2 * sample_pi * (column + column_shift) / columns + twist * height;
      surface.points.push_back(bumped(std::sin(boundary * height) * std::cos(longitude),
                                      std::sin(boundary * height) * std::sin(longitude), std::cos(boundary * height),
                                      bump_height));
    }
  append_grid(surface, columns, rows, true, false,
              [&random](std::size_t, std::size_t) { return random.coin() ? Diagonal::RISING : Diagonal::FALLING; });
  append_fan(surface, 0, columns, bumped(0, 0, 1, bump_height), false);
  return surface;
}

// A torus of revolution with a regular grid of triangles.
//
// Each cell is a symmetric trapezoid, so its diagonal is a tie except for the rounding of the
// coordinates. Good for varying the size, for ties that rounding breaks, and for a second topology.
// Euler characteristic 0; `columns * rows` vertices, `2 * columns * rows` faces.
// \param columns the number of vertices around the axis, at least 3
// \param rows the number of vertices around the tube, at least 3
// \param tube_radius for the distance 1 between the axis and the middle of the tube, in (0, 1)
inline Indexed_triangles torus(std::size_t columns = 60, std::size_t rows = 30, double tube_radius = 0.4)
{
  require_sample_argument(columns >= 3 && rows >= 3, "a torus has 3 columns and 3 rows at least");
  require_sample_argument(tube_radius > 0 && tube_radius < 1, "a tube radius lies in (0, 1)");
  Indexed_triangles surface;
  surface.points.reserve(columns * rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double around_axis = 2 * sample_pi * column / columns;
      const double around_tube = 2 * sample_pi * row / rows;
      const double distance = 1 + tube_radius * std::cos(around_tube);
      surface.points.push_back(
        {distance * std::cos(around_axis), distance * std::sin(around_axis), tube_radius * std::sin(around_tube)});
    }
  append_grid(surface, columns, rows, true, true, [](std::size_t, std::size_t) { return Diagonal::RISING; });
  return surface;
}

// A torus with random bad triangles, of any size.
//
// The points of a grid are shifted at random, the cells are longer around the axis than around
// the tube, and each cell is split at random. Nothing is degenerate.
// Good for measuring time: with as many columns as rows, the number of flips is 37 % of
// the number of edges at any size. 1,000 by 1,000 vertices have 3,000,000 edges and need about
// 1,110,000 flips, slightly depending on the seed and the order of the flips.
// Euler characteristic 0; `columns * rows` vertices, `2 * columns * rows` faces.
// \param columns the number of vertices around the axis, at least 3
// \param rows the number of vertices around the tube, at least 3
// \param seed of the random shifts and diagonals
inline Indexed_triangles bad_torus(std::size_t columns = 100, std::size_t rows = 100, std::uint64_t seed = 1)
{
  require_sample_argument(columns >= 3 && rows >= 3, "a torus has 3 columns and 3 rows at least");
  const double largest_shift = 0.2; // of a cell; below 1/4 all cells stay convex
  const double tube_radius = 0.32;  // of the distance 1; sets how much longer than wide the cells are
  Sample_random random(seed);
  Indexed_triangles surface;
  surface.points.reserve(columns * rows);
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double column_shift = random.uniform(-largest_shift, largest_shift);
      const double row_shift = random.uniform(-largest_shift, largest_shift);
      const double around_axis = 2 * sample_pi * (column + column_shift) / columns;
      const double around_tube = 2 * sample_pi * (row + row_shift) / rows;
      const double distance = 1 + tube_radius * std::cos(around_tube);
      surface.points.push_back(
        {distance * std::cos(around_axis), distance * std::sin(around_axis), tube_radius * std::sin(around_tube)});
    }
  append_grid(surface, columns, rows, true, true,
              [&random](std::size_t, std::size_t) { return random.coin() ? Diagonal::RISING : Diagonal::FALLING; });
  return surface;
}

// A closed helical tube, much longer than it is thick.
//
// The vertices wind around the axis like those of a stack of tetrahedra. Consecutive vertices are
// `pitch` apart along the axis and the tube has radius 1, so all edges are long and the way
// around the tube is short. In the intrinsic Delaunay triangulation each vertex except the outermost
// ones gets an edge around the tube to itself.
// Good for loops, multiple edges and self-glued faces that arise from an embedded mesh
// without a degenerate face: with the default arguments the intrinsic Delaunay triangulation has
// 58 loops among its 174 edges, and 2 edges that have the same face on both sides.
// Euler characteristic 2; `number_of_vertices` vertices, `2 * number_of_vertices - 4` faces.
// \param number_of_vertices at least 4
// \param pitch the step along the axis in tube radii, at most 1e7, so that areas are not lost in rounding
inline Indexed_triangles helical_tube(std::size_t number_of_vertices = 60, double pitch = 30)
{
  require_sample_argument(number_of_vertices >= 4, "a helical tube has 4 vertices at least");
  require_sample_argument(pitch > 0 && pitch <= 1e7, "a pitch lies in (0, 1e7]");
  const double turn = std::acos(-2.0 / 3.0); // that of a stack of regular tetrahedra
  Indexed_triangles surface;
  for (std::size_t vertex = 0; vertex < number_of_vertices; ++vertex)
    surface.points.push_back({std::cos(turn * vertex), std::sin(turn * vertex), pitch * vertex});
  append_triangle(surface, 0, 2, 1);
  for (std::size_t vertex = 0; vertex + 3 < number_of_vertices; ++vertex) {
    append_triangle(surface, vertex, vertex + 1, vertex + 3);
    append_triangle(surface, vertex, vertex + 3, vertex + 2);
  }
  append_triangle(surface, number_of_vertices - 3, number_of_vertices - 2, number_of_vertices - 1);
  return surface;
}

// The Schwarz lantern: a cylinder whose area grows without bound with the number of rows.
//
// The open cylinder of radius 1 and height 1 is split into congruent isosceles triangles, every
// other ring turned by half a step. With many more rows than columns the triangles are flat and
// obtuse and stand nearly at right angles to the cylinder.
// Good for flips that no smooth shape requires, and for the topology of an annulus.
// Euler characteristic 0; `columns * (rows + 1)` vertices, `2 * columns * rows` faces,
// `2 * columns` boundary edges.
// \param columns the number of vertices of each ring, at least 3
// \param rows the number of bands, at least 1
inline Indexed_triangles Schwarz_lantern(std::size_t columns = 16, std::size_t rows = 64)
{
  require_sample_argument(columns >= 3 && rows >= 1, "a lantern has 3 columns and 1 row at least");
  Indexed_triangles surface;
  for (std::size_t row = 0; row <= rows; ++row)
    for (std::size_t column = 0; column < columns; ++column) {
      const double angle = 2 * sample_pi * (column + (row % 2 == 0 ? 0.0 : 0.5)) / columns;
      surface.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(row) / rows});
    }
  append_grid(surface, columns, rows + 1, true, false,
              [](std::size_t, std::size_t row) { return row % 2 == 0 ? Diagonal::FALLING : Diagonal::RISING; });
  return surface;
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_SURFACES_CURVED_H

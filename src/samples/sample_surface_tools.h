// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tools shared by the generators of sample surfaces: random numbers that are the same with every standard library,
// rotations, and triangulated grids.

#ifndef IDT_SAMPLES_SAMPLE_SURFACE_TOOLS_H
#define IDT_SAMPLES_SAMPLE_SURFACE_TOOLS_H

#include "samples/sample_surface_types.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace samples {

constexpr double sample_pi = 3.14159265358979323846;

inline void require_sample_argument(bool condition, const char* message)
{
  if (!condition)
    throw std::invalid_argument(std::string("sample surface: ") + message);
}

// The standard fixes the sequence of mt19937_64 but not its distributions, hence the conversions here.
class Sample_random
{
public:
  explicit Sample_random(std::uint64_t seed) : engine_(seed) {}

  // uniform in [0, 1)
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  bool coin() { return (engine_() >> 63) != 0; }

  // in [0, bound); the bias is below bound / 2^64
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(engine_() % bound); }

private:
  std::mt19937_64 engine_;
};

// Rotates by a random unit quaternion; seed 0 leaves every bit as it is.
inline void rotate_sample(std::vector<std::array<double, 3>>& points, std::uint64_t rotation_seed)
{
  if (rotation_seed == 0)
    return;
  Sample_random random(rotation_seed);
  double w, x, y, z, norm;
  do {
    w = random.uniform(-1, 1);
    x = random.uniform(-1, 1);
    y = random.uniform(-1, 1);
    z = random.uniform(-1, 1);
    norm = std::sqrt(w * w + x * x + y * y + z * z);
  } while (norm > 1 || norm < 0.1);
  w /= norm;
  x /= norm;
  y /= norm;
  z /= norm;
  for (std::array<double, 3>& p : points)
    p = {(1 - 2 * (y * y + z * z)) * p[0] + 2 * (x * y - w * z) * p[1] + 2 * (x * z + w * y) * p[2],
         2 * (x * y + w * z) * p[0] + (1 - 2 * (x * x + z * z)) * p[1] + 2 * (y * z - w * x) * p[2],
         2 * (x * z - w * y) * p[0] + 2 * (y * z + w * x) * p[1] + (1 - 2 * (x * x + y * y)) * p[2]};
}

inline void append_triangle(Indexed_triangles& surface, std::size_t a, std::size_t b, std::size_t c)
{
  surface.triangles.push_back(
    {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
}

// Which diagonal splits the cell whose lowest corner is (column, row):
// rising joins (column, row) to (column + 1, row + 1).
enum class Diagonal {
  RISING,
  FALLING
};

// Splits every cell of a grid of points, stored row by row, into two triangles
// that are counterclockwise when columns go right and rows go up.
// `columns` and `rows` count points; a closed direction has as many cells as
// points, an open one has a cell less.
// `diagonal(column, row)` is called once for each cell, row by row.
template <typename Diagonal_of_cell>
void append_grid(Indexed_triangles& surface, std::size_t columns, std::size_t rows, bool columns_closed,
                 bool rows_closed, Diagonal_of_cell diagonal)
{
  require_sample_argument(columns < std::numeric_limits<std::uint32_t>::max() / (rows + 1), "too many vertices");
  const std::size_t cell_columns = columns_closed ? columns : columns - 1;
  const std::size_t cell_rows = rows_closed ? rows : rows - 1;
  surface.triangles.reserve(surface.triangles.size() + 2 * cell_columns * cell_rows);
  for (std::size_t row = 0; row < cell_rows; ++row)
    for (std::size_t column = 0; column < cell_columns; ++column) {
      const std::size_t right = (column + 1) % columns, up = (row + 1) % rows;
      const std::size_t a = row * columns + column, b = row * columns + right;
      const std::size_t c = up * columns + right, d = up * columns + column;
      if (diagonal(column, row) == Diagonal::RISING) {
        append_triangle(surface, a, b, c);
        append_triangle(surface, a, c, d);
      } else {
        append_triangle(surface, a, b, d);
        append_triangle(surface, b, c, d);
      }
    }
}

// Joins a new last point to a closed row of `columns` points that starts at
// point `first`; `above` says on which side of the row the apex is.
inline void append_fan(Indexed_triangles& surface, std::size_t first, std::size_t columns,
                       const std::array<double, 3>& apex, bool above)
{
  const std::size_t apex_index = surface.points.size();
  surface.points.push_back(apex);
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t here = first + column, next = first + (column + 1) % columns;
    if (above)
      append_triangle(surface, here, next, apex_index);
    else
      append_triangle(surface, next, here, apex_index);
  }
}

} // namespace samples

#endif // IDT_SAMPLES_SAMPLE_SURFACE_TOOLS_H

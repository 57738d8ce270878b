// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Turns bytes into triangles that are glued along their sides and have lengths or points: any gluing of a few
// triangles, with numbers that make decisions hard.

#ifndef IDT_TEST_FUZZ_METRIC_GLUING_H
#define IDT_TEST_FUZZ_METRIC_GLUING_H

#include "fuzz_target.h"

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace fuzz {

namespace IT = CGAL::Intrinsic_triangulations;

struct Metric_gluing
{
  enum class Metric {
    LENGTHS,          // arbitrary: most violate the triangle inequality
    MENDED_LENGTHS,   // where they do, the longest is the sum of the others, rounded
    POINTS,           // of the vertices, on a small grid or near it; loops have length zero
    SQUARED_DISTANCES // of points as above, without the points
  };

  std::size_t number_of_faces = 0;
  std::vector<std::array<std::uint32_t, 2>> glued_sides;
  IT::Delta_complex connectivity;
  Metric metric = Metric::LENGTHS;
  std::vector<double> lengths;               // one for each edge, unless there are points
  std::vector<std::array<double, 3>> points; // one for each vertex, or none
};

namespace detail {

// Each side that is still free is left on the boundary or glued to a later one.
inline void decode_gluing(Bytes& bytes, Metric_gluing& result)
{
  result.number_of_faces = 1 + bytes.below(8);
  std::vector<std::uint32_t> free_sides;
  for (std::uint32_t side = 0; side < 3 * result.number_of_faces; ++side)
    free_sides.push_back(side);
  while (free_sides.size() > 1) {
    const unsigned choice = bytes.below(unsigned(free_sides.size()));
    if (choice > 0) {
      result.glued_sides.push_back({free_sides[0], free_sides[choice]});
      free_sides.erase(free_sides.begin() + choice);
    }
    free_sides.erase(free_sides.begin());
  }
  result.connectivity = IT::make_Delta_complex_from_gluing(result.number_of_faces, result.glued_sides);
}

// A length of some kind, or one that depends on earlier ones.
inline double decode_length(Bytes& bytes, const std::vector<double>& before)
{
  const unsigned kind = bytes.below(16), value = bytes.next();
  const auto earlier = [&](unsigned n) { return before.empty() ? 1 : before[n % before.size()]; };
  switch (kind) {
  case 0: // three of these obey the triangle inequality
  case 1:
  case 2:
  case 3:
    return 1 + value / 256.;
  case 4:
  case 5:
    return 1 + value % 16;
  case 6:
    return std::sqrt(double(1 + value));
  case 7:
    return earlier(value);
  case 8: // a few units in the last place more or less
    return earlier(value) * (1 + (int(value % 7) - 3) * std::numeric_limits<double>::epsilon());
  case 9:
    return earlier(value % 16) + earlier(value / 16);
  case 10:
    return std::abs(earlier(value % 16) - earlier(value / 16));
  case 11: // the hypotenuse and the diagonals of kites: edges on the same circle
    return std::hypot(earlier(value % 16), earlier(value / 16));
  case 12:
    return std::ldexp(1 + value % 8 / 8., 3 * (int(value) - 128));
  case 13:
    return std::ldexp(earlier(value % 16), int(value / 16) - 8);
  case 14:
    return 1 + std::ldexp(double(value), -60); // 1, except for the largest values
  default: {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::array<double, 8> extreme{0,
                                        -1,
                                        infinity,
                                        std::numeric_limits<double>::quiet_NaN(),
                                        0x1p-1074,
                                        std::numeric_limits<double>::min(),
                                        std::numeric_limits<double>::max(),
                                        1e150};
    return extreme[value % 8];
  }
  }
}

// Shortens the longest side of a face to the sum of the others if it is longer.
inline bool shorten_longest_side(const IT::Delta_complex& complex, IT::Face_index f, std::vector<double>& lengths)
{
  IT::Halfedge_index h = complex.halfedge(f);
  for (int i = 0; i < 3; ++i, h = complex.next(h)) {
    double& l = lengths[complex.edge(h).idx()];
    const double sum = lengths[complex.edge(complex.next(h)).idx()] + lengths[complex.edge(complex.prev(h)).idx()];
    if (l > sum) {
      l = sum;
      return true;
    }
  }
  return false;
}

inline void mend_lengths(const IT::Delta_complex& complex, std::vector<double>& lengths)
{
  bool has_changed = true;
  for (int round = 0; has_changed && round < 50; ++round) {
    has_changed = false;
    for (IT::Face_index f : complex.faces())
      has_changed = shorten_longest_side(complex, f, lengths) || has_changed;
  }
}

// On a grid of integers, most of them in one plane, and some moved by very little.
inline std::array<double, 3> decode_point(Bytes& bytes)
{
  const int x = bytes.signed_next() / 16, y = bytes.signed_next() / 16;
  const unsigned rest = bytes.next();
  const double z = rest % 4 == 0 ? double(rest / 32) : 0;
  const double shift = rest % 4 == 1 ? std::ldexp(double(rest / 4 % 8), -int(rest / 32) * 7 - 4) : 0;
  return {x + shift, double(y), z};
}

} // namespace detail

inline Metric_gluing decode_metric_gluing(Bytes& bytes)
{
  using Metric = Metric_gluing::Metric;
  Metric_gluing result;
  detail::decode_gluing(bytes, result);
  const unsigned choice = bytes.next();
  result.metric = std::array<Metric, 6>{Metric::LENGTHS, Metric::MENDED_LENGTHS, Metric::MENDED_LENGTHS,
                                        Metric::POINTS,  Metric::POINTS,         Metric::SQUARED_DISTANCES}[choice % 6];
  // A unit of any size, now and then.
  const double unit = choice / 6 % 4 == 0 ? std::ldexp(1., 8 * bytes.signed_next()) : 1;
  if (result.metric == Metric::POINTS || result.metric == Metric::SQUARED_DISTANCES) {
    for (std::size_t v = 0; v < result.connectivity.number_of_vertices(); ++v) {
      result.points.push_back(detail::decode_point(bytes));
      for (double& x : result.points.back())
        x *= unit;
    }
    return result;
  }
  for (std::size_t e = 0; e < result.connectivity.number_of_edges(); ++e)
    result.lengths.push_back(detail::decode_length(bytes, result.lengths));
  if (result.metric == Metric::MENDED_LENGTHS)
    detail::mend_lengths(result.connectivity, result.lengths);
  for (double& l : result.lengths)
    l *= unit;
  return result;
}

} // namespace fuzz

#endif // IDT_TEST_FUZZ_METRIC_GLUING_H

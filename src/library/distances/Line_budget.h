// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How many points lines may have, and an estimate before they are traced.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_BUDGET_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_BUDGET_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

class Line_budget
{
public:
  explicit Line_budget(std::uint64_t number_of_vertices) : most_points_(1000000 + 10 * number_of_vertices) {}

  // Levels that meet a triangle, and by how much the distance bends along them in multiples of the tolerance: chords
  // take about a square root of it.
  void expect(double number_of_levels, double bend) { crossings_.push_back({number_of_levels, bend}); }

  // \exception Invalid_argument_error if too many points are expected
  void require_few_expected(bool has_several_levels) const
  {
    const double number = expected(1);
    if (!(number > double(most_points_)))
      return;
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(1) << "the lines need about " << number / 1e6
         << " million points, more than " << double(most_points_) / 1e6 << " million; " << std::setprecision(0);
    const char* separator = "";
    if (has_several_levels) {
      text << "one in " << std::ceil(number / double(most_points_)) << " of the distances would do";
      separator = ", or ";
    }
    if (expected(std::numeric_limits<double>::infinity()) < double(most_points_)) {
      double factor = 2;
      while (expected(factor) > double(most_points_))
        factor *= 2;
      text << separator << "a chord tolerance " << factor << " times as large" << (*separator ? "" : " would do");
    }
    throw Invalid_argument_error(text.str());
  }

  // \exception Invalid_argument_error if there are too many
  void count(std::uint64_t points, std::size_t number_of_triangles)
  {
    number_of_points_ += points;
    if (number_of_points_ > 2 * most_points_ || number_of_triangles > 20 * most_points_)
      throw Invalid_argument_error("the lines need more than " + std::to_string(2 * most_points_) +
                                   " points: give fewer distances at a time, or a larger chord tolerance");
  }

private:
  // The expected number of points with a multiple of the tolerance.
  double expected(double factor) const
  {
    double result = 0;
    for (const auto& [number, bend] : crossings_)
      result += number * (std::max)(1., std::sqrt(bend / factor));
    return result;
  }

  std::uint64_t most_points_;
  std::uint64_t number_of_points_ = 0;
  std::vector<std::pair<double, double>> crossings_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_LINE_BUDGET_H

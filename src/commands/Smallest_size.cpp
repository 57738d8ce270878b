// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Smallest_size.h"

#include "output/Triangulation_result.h"
#include "system/Progress.h"
#include "system/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <limits>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// As powers of two of the extent: the first is 16 units in the last place of a float as large as that.
constexpr std::array<int, 3> levels = {-20, -17, -14};

double extent_of(const Surface& surface)
{
  if (!surface.has_points())
    return surface.lengths.empty() ? 0 : *std::max_element(surface.lengths.begin(), surface.lengths.end());
  double result = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = (std::numeric_limits<double>::infinity)(), high = -low;
    for (IT::Vertex_index v : surface.connectivity.vertices())
      if (surface.connectivity.halfedge(v).is_valid()) {
        low = (std::min)(low, surface.points[v.idx()][axis]);
        high = (std::max)(high, surface.points[v.idx()][axis]);
      }
    result = (std::max)(result, high - low);
  }
  return (std::min)(result, (std::numeric_limits<double>::max)());
}

} // namespace

Smallest_size::Smallest_size(const Surface& surface)
  : extent_(extent_of(surface)), maximum_(10000 + std::uint64_t(surface.connectivity.number_of_vertices()))
{}

double Smallest_size::largest() const { return std::ldexp(extent_, levels.back()); }

bool Smallest_size::is_exceeded(const IT::Refinement_progress& progress)
{
  return covers(progress.size) && ++number_ > maximum_;
}

void Smallest_size::increase()
{
  size_ = std::ldexp(extent_, *std::find_if(levels.begin(), levels.end(),
                                            [this](int level) { return std::ldexp(extent_, level) > size_; }));
  number_ = 0;
}

std::string Smallest_size::text() const
{
  if (size_ == 0)
    return "0: no place needs one";
  return in_short(size_) + ", chosen as 2^" + std::to_string(std::ilogb(size_ / extent_)) +
         " of the box: smaller sides need more than " + with_separators(maximum_) +
         " new vertices, which --minimum-size 0 allows";
}

void Budget_warning::look(const IT::Refinement_progress& progress, const std::function<Short_side()>& where)
{
  if (is_written_ || progress.estimated_points == estimate_)
    return;
  estimate_ = progress.estimated_points;
  if (progress.points + estimate_ <= budget_) {
    was_exceeded_ = false;
    return;
  }
  if (!std::exchange(was_exceeded_, true))
    return;
  is_written_ = true;
  std::cerr << erased_progress() << "idt: " << path_ << ": after " << with_separators(progress.points)
            << " new vertices, about " << with_separators(estimate_) << " more are needed, now for sides of "
            << idt::text(where()) << ": the budget of " << with_separators(budget_)
            << " may not suffice; then try a larger --minimum-size, --maximum-edge-length or --maximum-points"
            << std::endl;
}

} // namespace idt

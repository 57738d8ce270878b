// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How many elements show something, and the first of them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_ELEMENT_COLLECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_ELEMENT_COLLECTOR_H

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Counts elements and keeps the ten smallest.
class Element_collector
{
public:
  void add(const std::size_t element)
  {
    ++count_;
    if (kept_ == smallest_.size() && element > smallest_[kept_ - 1])
      return;
    std::size_t i = kept_ < smallest_.size() ? kept_++ : kept_ - 1;
    for (; i > 0 && smallest_[i - 1] > element; --i)
      smallest_[i] = smallest_[i - 1];
    smallest_[i] = element;
  }
  std::size_t count() const { return count_; }
  std::size_t first() const { return smallest_[0]; }
  std::vector<std::size_t> elements() const
  {
    return std::vector<std::size_t>(smallest_.begin(), smallest_.begin() + kept_);
  }

private:
  std::array<std::size_t, 10> smallest_;
  std::size_t kept_ = 0;
  std::size_t count_ = 0;
};
} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_ELEMENT_COLLECTOR_H

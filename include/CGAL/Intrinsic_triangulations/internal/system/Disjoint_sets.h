// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Union and find on small integers.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DISJOINT_SETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DISJOINT_SETS_H

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Disjoint sets of the integers below n.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t n) : parent_(n)
  {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t(0));
  }
  std::uint32_t find(std::uint32_t x)
  {
    while (parent_[x] != x) {
      parent_[x] = parent_[parent_[x]];
      x = parent_[x];
    }
    return x;
  }
  void unite(const std::uint32_t x, const std::uint32_t y)
  {
    // The smaller root wins: elements come in file order, which keeps trees flat.
    const std::uint32_t a = find(x), b = find(y);
    if (a < b)
      parent_[b] = a;
    else
      parent_[a] = b;
  }
  // Numbers the sets in the order of their smallest elements. Returns how many sets there are.
  std::size_t number(std::vector<std::size_t>& number_of)
  {
    std::size_t n = 0;
    number_of.resize(parent_.size());
    for (std::size_t x = 0; x < parent_.size(); ++x) {
      const std::uint32_t root = find(std::uint32_t(x)); // not larger than x
      number_of[x] = root == x ? n++ : number_of[root];
    }
    return n;
  }

private:
  std::vector<std::uint32_t> parent_;
};
} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DISJOINT_SETS_H

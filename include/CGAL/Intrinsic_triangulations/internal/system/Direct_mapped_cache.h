// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DIRECT_MAPPED_CACHE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DIRECT_MAPPED_CACHE_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Values by keys, each in the one slot that its hash selects. The cache grows with the number of questions, so that few
// do not pay for the memory of many.
//
// \tparam Key its default value is never looked up
template <class Key, class Value>
class Direct_mapped_cache
{
public:
  // \param number_of_keys the number of different keys, or an upper bound
  explicit Direct_mapped_cache(std::size_t number_of_keys)
  {
    while (largest_size_ < (std::min)(number_of_keys, most_entries))
      largest_size_ *= 2;
    entries_.resize((std::min)(largest_size_, first_entries));
  }

  // Valid until the next call. `compute` must not ask the cache.
  template <class Compute>
  const Value& operator()(const Key& key, std::uint32_t hash, const Compute& compute)
  {
    Entry* entry = &entries_[hash & (entries_.size() - 1)];
    if (entry->key == key)
      return entry->value;
    if (++misses_ > 4 * entries_.size() && entries_.size() < largest_size_) {
      entries_ = std::vector<Entry>(2 * entries_.size());
      misses_ = 0;
      entry = &entries_[hash & (entries_.size() - 1)];
    }
    entry->value = compute();
    entry->key = key;
    return entry->value;
  }

private:
  // Powers of two, as all sizes are. At most some megabytes for each thread.
  static constexpr std::size_t first_entries = 1024, most_entries = 32768;

  struct Entry
  {
    Key key;
    Value value;
  };

  std::size_t largest_size_ = 16, misses_ = 0;
  std::vector<Entry> entries_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_DIRECT_MAPPED_CACHE_H

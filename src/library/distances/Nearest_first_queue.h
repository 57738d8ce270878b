// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A queue for events that cause others at the same distance or farther away.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_NEAREST_FIRST_QUEUE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_NEAREST_FIRST_QUEUE_H

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Only the next events form a heap, which fits into the cache. The others wait in any order. The order in which events
// leave is that of one heap.
//
// \tparam Event has a member `first`, the distance
// \tparam Comes_later compares two events as for std::priority_queue, the distance first
template <class Event, class Comes_later>
class Nearest_first_queue
{
public:
  explicit Nearest_first_queue(const Comes_later& comes_later) : comes_later_(comes_later) {}

  bool empty() const { return near_.empty(); }
  const Event& top() const { return near_.front(); }

  void push(const Event& event)
  {
    if (event.first > limit_) {
      far_.push_back(event);
      return;
    }
    near_.push_back(event);
    std::push_heap(near_.begin(), near_.end(), comes_later_);
    if (near_.size() > most_near_)
      split();
  }

  void pop()
  {
    std::pop_heap(near_.begin(), near_.end(), comes_later_);
    near_.pop_back();
    if (near_.empty())
      refill();
  }

private:
  static constexpr std::size_t most_at_once = 2048;

  void refill()
  {
    near_.swap(far_);
    split();
  }

  // Makes a heap of the nearest events.
  void split()
  {
    limit_ = std::numeric_limits<double>::infinity();
    const std::size_t n = (std::max)(most_at_once, near_.size() / 16);
    if (n < near_.size()) {
      const auto is_nearer = [](const Event& a, const Event& b) { return a.first < b.first; };
      std::nth_element(near_.begin(), near_.begin() + std::ptrdiff_t(n), near_.end(), is_nearer);
      limit_ = near_[n].first;
      const auto beyond = std::partition(near_.begin() + std::ptrdiff_t(n), near_.end(),
                                         [this](const Event& event) { return event.first <= limit_; });
      far_.insert(far_.end(), beyond, near_.end());
      near_.erase(beyond, near_.end());
    }
    std::make_heap(near_.begin(), near_.end(), comes_later_);
    most_near_ = 2 * near_.size() + 2 * most_at_once; // also if all events have the same distance
  }

  Comes_later comes_later_;
  std::vector<Event> near_; // a heap of all events up to the limit
  std::vector<Event> far_;
  double limit_ = std::numeric_limits<double>::infinity();
  std::size_t most_near_ = 4 * most_at_once;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_NEAREST_FIRST_QUEUE_H

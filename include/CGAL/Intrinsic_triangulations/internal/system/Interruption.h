// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Ends a single long decision or solution from outside.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H

#include <atomic>
#include <chrono>
#include <functional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// The exact stages call check() before each step that takes a microsecond or more, and the heat methods before each
// system. The user's function need not be fast: it is called at most a hundred times a second, possibly by several
// threads at once.
class Interruption
{
public:
  using Go_further = std::function<bool()>;

  explicit Interruption(Go_further go_further = {}) : go_further_(std::move(go_further)) {}

  // Replaces the function; returns the previous one.
  Go_further exchange(Go_further go_further)
  {
    next_question_ = now();
    return std::exchange(go_further_, std::move(go_further));
  }

  void check() const
  {
    if (go_further_ && now() >= next_question_.load(std::memory_order_relaxed))
      ask();
  }

private:
  using Clock = std::chrono::steady_clock;
  using Ticks = Clock::duration::rep;

  static Ticks now() { return Clock::now().time_since_epoch().count(); }

  void ask() const;

  Go_further go_further_;
  mutable std::atomic<Ticks> next_question_{0};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H

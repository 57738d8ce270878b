// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How a single decision that takes long is ended from outside.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <chrono>
#include <functional>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The exact stages call check() before each step that takes a microsecond or more. The user's
// function is called a hundred times a second at most, so that it need not be fast.
class Interruption
{
public:
  using Go_further = std::function<bool()>;

  // Replaces the function; returns the one before.
  Go_further exchange(Go_further go_further)
  {
    next_question_ = Clock::now();
    return std::exchange(go_further_, std::move(go_further));
  }

  void check()
  {
    if (go_further_ && Clock::now() >= next_question_)
      ask();
  }

private:
  using Clock = std::chrono::steady_clock;

  void ask()
  {
    if (!go_further_())
      throw Cancelled_error("an exact decision was cancelled");
    next_question_ = Clock::now() + std::chrono::milliseconds(10);
  }

  Go_further go_further_;
  Clock::time_point next_question_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_INTERRUPTION_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_STOPWATCH_H
#define IDT_STOPWATCH_H

#include <chrono>

namespace idt {

// Wall clock time in seconds.
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  // Returns the seconds so far and begins anew.
  double restart()
  {
    const Clock::time_point now = Clock::now();
    const double result = std::chrono::duration<double>(now - start_).count();
    start_ = now;
    return result;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

} // namespace idt

#endif // IDT_STOPWATCH_H

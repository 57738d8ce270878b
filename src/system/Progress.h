// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One line on the terminal that says how far a long job is.

#ifndef IDT_PROGRESS_H
#define IDT_PROGRESS_H

#include "system/Stopwatch.h"

#include <cstdint>
#include <string>

namespace idt {

// Writes to the standard error, and only if that is a terminal; the line is erased at
// the end.
class Progress
{
public:
  explicit Progress(const std::string& path);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // Nobody knows how many flips there will be.
  void show_flips(std::uint64_t tests, std::uint64_t flips)
  {
    if (is_shown_ && tests >= next_look_)
      look(tests, flips);
  }
  // The same of refinement, where a step takes long enough for a look at the clock.
  void show_points(std::uint64_t points);
  // A bar. \param fraction what is done of it, from 0 to 1
  void show(const char* what, double fraction);

private:
  void look(std::uint64_t tests, std::uint64_t flips);
  // Whether it is time for another line.
  bool is_due(double now);
  void write(const std::string& text);

  std::string name_;
  bool is_shown_;
  bool has_written_ = false;
  // A test takes between nanoseconds and seconds: the clock is read so often that it
  // does not matter, and seldom enough.
  std::uint64_t next_look_ = 0;
  std::uint64_t stride_ = 1;
  double last_look_ = 0;
  double last_write_ = 0;
  Stopwatch stopwatch_;
};

} // namespace idt

#endif // IDT_PROGRESS_H

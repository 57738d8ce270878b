// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One line on the terminal that shows the progress of a long job.

#ifndef IDT_PROGRESS_H
#define IDT_PROGRESS_H

#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/observer.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace idt {

// Writes to the standard error, and only if that is a terminal; the line is erased at the end. The library can ask a
// reference to it whether to go on, which it does until an interruption.
class Progress
{
public:
  // \param phase shown, with the time, while the progress is unknown
  Progress(const std::string& path, const char* phase);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // Whether progress is shown from now on; as always, only on a terminal.
  static void set_shown(bool is_shown);

  // Begins another phase.
  void begin(const char* phase);
  // The total number of flips is unknown.
  void show_flips(std::uint64_t tests, std::uint64_t flips)
  {
    if (is_shown_ && tests >= next_look_)
      look(tests, flips);
  }
  // The same for refinement, where each step takes long enough for a look at the clock.
  // \param faces the number of faces to refine, at most \param size the shortest side of the next one
  void show_points(std::uint64_t points, std::size_t faces, double size);
  // A bar. \param fraction the part that is done, from 0 to 1
  void show(const char* what, double fraction);

  // Shows the finished part of the phase.
  bool operator()(double fraction);
  // Shows the progress of flips.
  bool operator()(const CGAL::Intrinsic_triangulations::Progress& flips);

private:
  void look(std::uint64_t tests, std::uint64_t flips);
  // Writes the phase whenever nothing else was written for a while, until the end.
  void show_phases();
  // Whether it is time for another line.
  bool is_due(double now);
  void write(const std::string& text);

  std::string name_;
  bool is_shown_;
  // A test takes between nanoseconds and seconds: the clock is read often enough, yet seldom enough not to matter.
  std::uint64_t next_look_ = 0;
  std::uint64_t stride_ = 1;
  double last_look_ = 0;
  Stopwatch stopwatch_;

  std::mutex mutex_; // guards the members below
  const char* phase_;
  double last_write_ = 0;
  double phase_begin_ = 0;
  bool has_ended_ = false;
  std::condition_variable end_;
  std::thread thread_;
};

// The text that erases the line from the terminal; empty if there is no line. Any thread may call it.
std::string erased_progress();

} // namespace idt

#endif // IDT_PROGRESS_H

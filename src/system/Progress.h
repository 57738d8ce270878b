// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One line on the terminal that says how far a long job is.

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

// Writes to the standard error, and only if that is a terminal; the line is erased at
// the end. A reference to it is what the library can ask whether to go on: until an interruption.
class Progress
{
public:
  // \param phase what is shown, with the time, while nobody knows how much of it is done
  Progress(const std::string& path, const char* phase);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  // Whether any is shown from now on; on a terminal alone, as always.
  static void set_shown(bool is_shown);

  // Another phase begins.
  void begin(const char* phase);
  // Nobody knows how many flips there will be.
  void show_flips(std::uint64_t tests, std::uint64_t flips)
  {
    if (is_shown_ && tests >= next_look_)
      look(tests, flips);
  }
  // The same of refinement, where a step takes long enough for a look at the clock.
  // \param faces how many are to be refined, at most \param size the shortest side of the next one
  void show_points(std::uint64_t points, std::size_t faces, double size);
  // A bar. \param fraction what is done of it, from 0 to 1
  void show(const char* what, double fraction);

  // Shows how much of the phase is done.
  bool operator()(double fraction);
  // Shows how far flips are.
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
  // A test takes between nanoseconds and seconds: the clock is read so often that it
  // does not matter, and seldom enough.
  std::uint64_t next_look_ = 0;
  std::uint64_t stride_ = 1;
  double last_look_ = 0;
  Stopwatch stopwatch_;

  std::mutex mutex_; // of what follows
  const char* phase_;
  double last_write_ = 0;
  double phase_begin_ = 0;
  bool has_ended_ = false;
  std::condition_variable end_;
  std::thread thread_;
};

// What erases the line from the terminal; empty if there is none. Any thread may call it.
std::string erased_progress();

} // namespace idt

#endif // IDT_PROGRESS_H

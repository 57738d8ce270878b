// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Progress.h"

#include "system/Interruption.h"
#include "system/system_calls.h"
#include "system/text.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <system_error>

namespace idt {
namespace {

std::atomic<bool> is_line_shown{false};
const char* const erasure = "\r\x1b[K";

// The end of a path, of limited length and without control characters.
std::string short_name(const std::string& path)
{
  std::string name = path.substr(path.find_last_of('/') + 1);
  if (name.size() > 30)
    name = "..." + name.substr(name.size() - 27);
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '?';
  return name;
}

bool is_any_shown = true;

} // namespace

void Progress::set_shown(bool is_shown) { is_any_shown = is_shown; }

Progress::Progress(const std::string& path, const char* phase)
  : name_(short_name(path)), is_shown_(is_any_shown && is_error_output_a_terminal()), phase_(phase)
{
  if (is_shown_)
    try {
      thread_ = std::thread([this] { show_phases(); });
    } catch (const std::system_error&) {
      is_shown_ = false;
    }
}

Progress::~Progress()
{
  if (!is_shown_)
    return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    has_ended_ = true;
  }
  end_.notify_one();
  thread_.join();
  std::cerr << erased_progress() << std::flush;
}

void Progress::begin(const char* phase)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  phase_ = phase;
  phase_begin_ = stopwatch_.seconds();
}

void Progress::show_phases()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (!end_.wait_for(lock, std::chrono::milliseconds(500), [this] { return has_ended_; })) {
    const double now = stopwatch_.seconds();
    if (now - last_write_ < 0.5)
      continue;
    last_write_ = now;
    write(std::string(phase_) + ", " + std::to_string(static_cast<int>(now - phase_begin_)) + " s");
  }
}

void Progress::show_points(std::uint64_t points, std::size_t faces, double size)
{
  if (is_shown_ && is_due(stopwatch_.seconds()))
    write("refining, " + std::to_string(points) + " new vertices, " + std::to_string(faces) + " faces left, sides of " +
          in_short(size));
}

void Progress::show(const char* what, double fraction)
{
  constexpr int width = 20;
  if (!is_shown_ || !is_due(stopwatch_.seconds()))
    return;
  const int percent = static_cast<int>(100 * (std::max)(0., (std::min)(1., fraction)));
  const std::size_t done = static_cast<std::size_t>(width * percent / 100);
  write(std::string(what) + " [" + std::string(done, '#') + std::string(width - done, ' ') + "] " +
        std::to_string(percent) + " %");
}

bool Progress::operator()(double fraction)
{
  show(phase_, fraction);
  return !is_interrupted();
}

bool Progress::operator()(const CGAL::Intrinsic_triangulations::Progress& flips)
{
  show_flips(flips.tests, flips.flips);
  return !is_interrupted();
}

void Progress::look(std::uint64_t tests, std::uint64_t flips)
{
  const double now = stopwatch_.seconds();
  if (now - last_look_ < 0.02)
    stride_ *= 2;
  else if (stride_ > 1)
    stride_ /= 2;
  last_look_ = now;
  next_look_ = tests + stride_;
  if (is_due(now))
    write("flipping, " + std::to_string(flips) + " flips in " + std::to_string(tests) + " tests");
}

bool Progress::is_due(double now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (now - last_write_ < 0.2)
    return false;
  last_write_ = now;
  return true;
}

void Progress::write(const std::string& text)
{
  is_line_shown = true;
  std::cerr << (erasure + (name_ + ": " + text)) << std::flush;
}

std::string erased_progress() { return is_line_shown.exchange(false) ? erasure : ""; }

} // namespace idt

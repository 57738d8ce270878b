// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Progress.h"

#include <unistd.h>

#include <algorithm>
#include <iostream>

namespace idt {
namespace {

// The end of a path, in a line of its own length and without what a terminal would obey.
std::string short_name(const std::string& path)
{
  std::string name = path.substr(path.find_last_of('/') + 1);
  if (name.size() > 30)
    name = "..." + name.substr(name.size() - 27);
  for (char& c : name)
    if ((c >= 0 && c < ' ') || c == '\x7f')
      c = '?';
  return name;
}

} // namespace

Progress::Progress(const std::string& path)
  : name_(short_name(path)), is_shown_(::isatty(STDERR_FILENO) == 1)
{}

Progress::~Progress()
{
  if (has_written_)
    std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::show_points(std::uint64_t points)
{
  if (is_shown_ && is_due(stopwatch_.seconds()))
    write("refining, " + std::to_string(points) + " new vertices");
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
  if (now - last_write_ < 0.2)
    return false;
  last_write_ = now;
  return true;
}

void Progress::write(const std::string& text)
{
  has_written_ = true;
  std::cerr << "\r\x1b[K" << name_ << ": " << text << std::flush;
}

} // namespace idt

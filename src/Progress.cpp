// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>

namespace idt {

Progress::Progress(const std::string& name)
  : name_(name), is_shown_(::isatty(STDERR_FILENO) == 1)
{}

Progress::~Progress()
{
  if (has_written_)
    std::cerr << "\r\x1b[K" << std::flush;
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
  if (now - last_write_ < 0.2)
    return;
  last_write_ = now;
  has_written_ = true;
  std::cerr << "\r\x1b[K" << name_ << ": " << flips << " flips in " << tests << " tests"
            << std::flush;
}

} // namespace idt

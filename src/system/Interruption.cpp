// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Interruption.h"

#include "system/Stopwatch.h"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace idt {
namespace {

volatile std::sig_atomic_t interrupted = 0;

} // namespace

extern "C" {
static void handle_interruption(int)
{
  interrupted = 1;
}
}

void install_signal_handlers()
{
  struct sigaction action = {};
  action.sa_handler = handle_interruption;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (int signal_number : {SIGINT, SIGTERM, SIGHUP}) {
    // What a parent chose to ignore (as nohup does) stays ignored.
    struct sigaction old = {};
    sigaction(signal_number, nullptr, &old);
    if (old.sa_handler != SIG_IGN || signal_number == SIGINT)
      sigaction(signal_number, &action, nullptr);
  }
  struct sigaction ignore = {};
  ignore.sa_handler = SIG_IGN;
  sigemptyset(&ignore.sa_mask);
  sigaction(SIGPIPE, &ignore, nullptr);
  sigaction(SIGXFSZ, &ignore, nullptr);
}

void occupy_standard_descriptors()
{
  for (int descriptor : {0, 1, 2})
    if (::fcntl(descriptor, F_GETFD) == -1)
      // The lowest free descriptor is this one. Not writable, but for the messages.
      static_cast<void>(::open("/dev/null", descriptor == 2 ? O_WRONLY : O_RDONLY));
}

bool is_interrupted()
{
  return interrupted != 0;
}

bool has_time_to_decide()
{
  if (!is_interrupted())
    return true;
  static const Stopwatch since_interruption;
  return since_interruption.seconds() < 0.25;
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Interruption.h"

#include "system/Progress.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <initializer_list>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace idt {
namespace {

using Clock = std::chrono::steady_clock;

// Then the process is ended, and the rest of the second is for the system, which takes its memory back.
constexpr std::chrono::milliseconds time_for_an_orderly_end(500);

std::atomic<bool> interrupted{false};
std::atomic<Clock::rep> interruption_time{0};

// What the signal handlers, the watcher and the main thread share. A copy of the process has another one.
struct Watch
{
  std::timed_mutex mutex; // of the rest; held for ever by who ends the process
  std::list<std::function<void()>> undo;
  bool is_over = false;
  bool is_copy = false;
  pid_t process = ::getpid();
  int to_watcher[2] = {-1, -1};
};

// Never destroyed: the watcher outlives static objects.
Watch*& watch()
{
  static Watch* watch = new Watch;
  return watch;
}
// For the signal handler alone, with what may be done there.
std::atomic<int> to_watcher{-1};
std::atomic<pid_t> watched_process{-1};

// Ends the process, unless it ends by itself. \param signal_number the second signal, or 0 if time is up
void end_process(Watch& w, int signal_number)
{
  // Opening a file can take for ever, where a server is down.
  const bool is_locked = w.mutex.try_lock_for(std::chrono::milliseconds(100));
  if (is_locked && w.is_over) {
    w.mutex.unlock();
    return;
  }
  for (const std::function<void()>& undo : w.undo)
    undo();
  if (!w.is_copy) {
    const std::string message = erased_progress() + "idt: cancelled; files that were not complete are removed\n";
    static_cast<void>(::write(STDERR_FILENO, message.data(), message.size()) + 1);
  }
  if (signal_number != 0) {
    // As who waits for the process expects.
    struct sigaction action = {};
    action.sa_handler = SIG_DFL;
    sigemptyset(&action.sa_mask);
    sigaction(signal_number, &action, nullptr);
    ::kill(::getpid(), signal_number);
  }
  ::_exit(static_cast<int>(Exit_status::NOT_FINISHED));
}

// Waits for a signal, then for another one of its kind or until time is up.
void watch_signals(Watch& w)
{
  bool was_seen[64] = {};
  for (bool is_first = true;;) {
    const Clock::time_point end = Clock::time_point(Clock::duration(interruption_time)) + time_for_an_orderly_end;
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    struct pollfd in = {w.to_watcher[0], POLLIN, 0};
    const int ready = ::poll(&in, 1, is_first ? -1 : rest > 0 ? static_cast<int>(rest)
                                                              : 0);
    unsigned char signal_number = 0;
    if (ready == 0) {
      end_process(w, 0);
      return;
    }
    if (ready < 0 || ::read(w.to_watcher[0], &signal_number, 1) != 1)
      continue;
    if (std::exchange(was_seen[signal_number % 64], true)) {
      end_process(w, signal_number);
      return;
    }
    is_first = false;
  }
}

// Returns whether there is a thread that waits for signals.
bool start_watcher(Watch& w)
{
  if (::pipe(w.to_watcher) != 0)
    return false;
  for (int end : w.to_watcher)
    ::fcntl(end, F_SETFD, FD_CLOEXEC);
  try {
    std::thread(watch_signals, std::ref(w)).detach();
  } catch (const std::system_error&) {
    return false;
  }
  to_watcher = w.to_watcher[1];
  watched_process = w.process;
  return true;
}

} // namespace

extern "C" {
static void handle_interruption(int signal_number)
{
  const int error_number = errno;
  if (!interrupted)
    interruption_time = Clock::now().time_since_epoch().count();
  interrupted = true;
  // A copy of the process that has no watcher yet must not wake that of the first one.
  const unsigned char byte = static_cast<unsigned char>(signal_number);
  if (watched_process == ::getpid())
    static_cast<void>(::write(to_watcher, &byte, 1) + 1);
  errno = error_number;
}
}

void install_signal_handlers()
{
  struct sigaction action = {};
  action.sa_handler = handle_interruption;
  action.sa_flags = static_cast<int>(SA_RESTART);
  // Without a watcher, the second signal ends the process as it does any other.
  if (!start_watcher(*watch()))
    action.sa_flags |= static_cast<int>(SA_RESETHAND);
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

void install_signal_handlers_in_copy()
{
  watch() = new Watch;
  watch()->is_copy = true;
  install_signal_handlers();
}

void end_in_good_order()
{
  // If the process is being ended, this waits for that.
  const std::lock_guard<std::timed_mutex> lock(watch()->mutex);
  watch()->is_over = true;
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
  return interrupted;
}

bool has_time_to_decide()
{
  return !interrupted ||
         Clock::now() - Clock::time_point(Clock::duration(interruption_time)) < std::chrono::milliseconds(250);
}

Unfinished::Unfinished(const std::function<void()>& begin, std::function<void()> undo)
{
  Watch& w = *watch();
  const std::lock_guard<std::timed_mutex> lock(w.mutex);
  undo_ = w.undo.insert(w.undo.end(), std::move(undo));
  try {
    begin();
  } catch (...) {
    w.undo.erase(undo_);
    throw;
  }
}

Unfinished::~Unfinished()
{
  Watch& w = *watch();
  const std::lock_guard<std::timed_mutex> lock(w.mutex);
  w.undo.erase(undo_);
}

} // namespace idt

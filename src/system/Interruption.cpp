// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Interruption.h"

#include "system/Progress.h"
#include "system/system_calls.h"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

namespace idt {
namespace {

using Clock = std::chrono::steady_clock;

// Then the process is ended; the rest of the second is for the system, which reclaims its memory.
constexpr std::chrono::milliseconds time_for_an_orderly_end(500);

std::atomic<bool> interrupted{false};
std::atomic<Clock::rep> interruption_time{0};

Clock::duration since_interruption() { return Clock::now() - Clock::time_point(Clock::duration(interruption_time)); }

// The state that the watcher shares with other threads. A copy of the process has its own.
struct Watch
{
  std::timed_mutex mutex; // of the rest; held forever by the thread that ends the process
  std::list<std::function<void()>> undo;
  bool is_over = false;
  bool is_copy = false;
};

// Never destroyed: the watcher outlives static objects.
Watch*& watch()
{
  static Watch* watch = new Watch;
  return watch;
}

// Called by signal handlers.
void note_interruption()
{
  if (!interrupted)
    interruption_time = Clock::now().time_since_epoch().count();
  interrupted = true;
}

// Ends the process, unless it ends by itself. \param request the second of its kind, or 0 if time is up
void end_process(Watch& w, int request)
{
  // Opening a file can take forever if a server is down.
  const bool is_locked = w.mutex.try_lock_for(std::chrono::milliseconds(100));
  if (is_locked && w.is_over) {
    w.mutex.unlock();
    return;
  }
  for (const std::function<void()>& undo : w.undo)
    undo();
  if (!w.is_copy)
    write_error_output(erased_progress() + "idt: cancelled; files that were not complete are removed\n");
  if (request != 0)
    end_by_request(request); // as programs that wait for this process expect
  std::_Exit(static_cast<int>(Exit_status::NOT_FINISHED));
}

// Waits for a request, then for another one of its kind or until time is up.
void watch_requests(Watch& w)
{
  bool was_seen[256] = {};
  for (bool is_first = true;; is_first = false) {
    const auto rest =
      std::chrono::duration_cast<std::chrono::milliseconds>(time_for_an_orderly_end - since_interruption()).count();
    const int request = wait_for_request(is_first ? -1 : rest > 0 ? static_cast<long>(rest) : 0);
    if (request == 0 || std::exchange(was_seen[request], true)) {
      end_process(w, request);
      return;
    }
  }
}

// Returns whether there is a thread that waits for requests.
bool start_watcher(Watch& w)
{
  if (!prepare_to_wait_for_requests())
    return false;
  try {
    std::thread(watch_requests, std::ref(w)).detach();
  } catch (const std::system_error&) {
    return false;
  }
  return true;
}

} // namespace

void install_signal_handlers()
{
  const bool has_watcher = start_watcher(*watch());
  catch_requests(note_interruption, !has_watcher);
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

bool is_interrupted() { return interrupted; }

bool has_time_to_decide() { return !interrupted || since_interruption() < std::chrono::milliseconds(250); }

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

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Long calls: other threads of Python continue meanwhile, and Ctrl-C ends them.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_SIGNAL_WATCH_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_SIGNAL_WATCH_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <pybind11/pybind11.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

namespace idt_python {

namespace py = pybind11;
namespace IT = CGAL::Intrinsic_triangulations;

// While it lives, `goes_on()` in its thread returns whether Python has received no signal that ends the call. It runs
// the signal handlers twenty times a second, so that short calls do not pay for it.
class Signal_watch
{
public:
  Signal_watch() : before_(std::exchange(current(), this)) {}
  Signal_watch(const Signal_watch&) = delete;
  Signal_watch& operator=(const Signal_watch&) = delete;
  ~Signal_watch() { current() = before_; }

  static bool goes_on() { return !current() || current()->ask(); }
  static void check()
  {
    if (!goes_on())
      throw IT::Cancelled_error("the call was interrupted");
  }
  // The exception that the signal handler raised, usually KeyboardInterrupt.
  void raise()
  {
    if (!error_)
      return;
    py::error_already_set error = *error_;
    error_.reset();
    throw error;
  }

private:
  using Clock = std::chrono::steady_clock;

  static Signal_watch*& current()
  {
    static thread_local Signal_watch* watch = nullptr;
    return watch;
  }

  bool ask()
  {
    if (error_)
      return false;
    const Clock::time_point now = Clock::now();
    if (now < next_question_)
      return true;
    next_question_ = now + std::chrono::milliseconds(50);
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0)
      error_.emplace();
    return !error_;
  }

  Signal_watch* before_;
  Clock::time_point next_question_ = Clock::now() + std::chrono::milliseconds(50);
  std::optional<py::error_already_set> error_;
};

// Calls a function without Python's lock, which may be released already. \pre the function does not touch Python
// objects, and returns a value
template <class Function>
auto without_lock(const Function& function)
{
  if (PyGILState_Check() == 0)
    return function();
  Signal_watch watch;
  std::optional<decltype(function())> result;
  try {
    const py::gil_scoped_release unlocked;
    result.emplace(function());
  } catch (const IT::Cancelled_error&) {
    watch.raise();
    throw;
  }
  watch.raise();
  return std::move(*result);
}

// The visitor of flips, of refinement and of paths.
struct Signal_visitor
{
  bool go_further(const IT::Progress&) { return ++calls % 16 != 0 || Signal_watch::goes_on(); }

  std::uint64_t calls = 0;
};

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_SIGNAL_WATCH_H

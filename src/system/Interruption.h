// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ctrl-C and the like: an orderly end if there is time for one, otherwise a quick end that leaves nothing half done.

#ifndef IDT_INTERRUPTION_H
#define IDT_INTERRUPTION_H

#include "system/Exit_status.h"

#include <functional>
#include <list>

namespace idt {

// Lets SIGINT, SIGTERM and SIGHUP ask for an orderly end. After half a second, the process ends anyway, with the status
// NOT_FINISHED; a second signal of the same kind ends it at once. Either way, everything Unfinished is undone. Broken
// pipes and file size limits become write errors.
void install_signal_handlers();

// The same in a copy of this process, which has a single thread and does not own the unfinished files. It ends
// silently.
void install_signal_handlers_in_copy();

// The process is about to end by itself: from now on, nothing ends it sooner unless its end takes long.
void end_in_good_order();

// Whether an end was requested.
bool is_interrupted();

// Whether long decisions may still be made: until a quarter of a second after an end was requested. Results that depend
// on them are then omitted.
bool has_time_to_decide();

// Something that must not outlive the process in its current state: half a file, another process.
class Unfinished
{
public:
  // \param begin is called at once, and never while the process is being ended
  // \param undo is called by another thread if the process is ended during the lifetime of this object; must not throw
  Unfinished(const std::function<void()>& begin, std::function<void()> undo);
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  ~Unfinished();

private:
  std::list<std::function<void()>>::iterator undo_;
};

} // namespace idt

#endif // IDT_INTERRUPTION_H

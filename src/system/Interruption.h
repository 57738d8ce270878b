// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signals that ask the command to end, and descriptors that a shell may have closed.

#ifndef IDT_INTERRUPTION_H
#define IDT_INTERRUPTION_H

namespace idt {

// Lets SIGINT, SIGTERM and SIGHUP ask for an orderly end; a second one of the same
// kind ends the process at once. Broken pipes and file size limits become write errors.
void install_signal_handlers();

// Occupies the standard descriptors that are closed, lest a file that is opened later is
// taken for one of them; writing to them fails as it should.
void occupy_standard_descriptors();

// Whether an end was asked for.
bool is_interrupted();

// Whether decisions that take long may still be made: until a quarter of a second after the first call that
// finds that an end was asked for. What they are for is then left out.
bool has_time_to_decide();

} // namespace idt

#endif // IDT_INTERRUPTION_H

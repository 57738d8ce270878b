// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The exit status of the command. Scripts rely on the numbers.

#ifndef IDT_EXIT_STATUS_H
#define IDT_EXIT_STATUS_H

#include <stdexcept>

namespace idt {

enum class Exit_status {
  DONE = 0,
  OUTPUT_FAILED = 1, // a result could not be written, or there was no memory for it
  WRONG_USAGE = 2,   // the command line is wrong
  UNUSABLE_INPUT = 3,
  NOT_FINISHED = 4 // undecided, not flippable, out of budget or cancelled
};

// The command line makes no sense.
class Usage_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// A result could not be written.
class Output_error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// Of several inputs, the first that failed decides.
inline void keep_first_failure(Exit_status& status, Exit_status next)
{
  if (status == Exit_status::DONE)
    status = next;
}

} // namespace idt

#endif // IDT_EXIT_STATUS_H

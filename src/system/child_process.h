// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work that may run forever without asking whether to continue, or end its process.

#ifndef IDT_CHILD_PROCESS_H
#define IDT_CHILD_PROCESS_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace idt {

struct Child_result
{
  enum class End {
    DONE,
    TIME_LIMIT, // it was ended because the next line took too long
    DIED,       // a signal or an exception ended it
    INTERRUPTED // it was ended because the command was interrupted
  };
  End end = End::DONE;
  std::vector<std::string> lines; // its output until then
};

using Say_function = std::function<void(const std::string& line)>;

// Runs `function` in a copy of this process and returns the lines that it wrote. The copy has no standard output or
// error, and its changes are not seen here.
// \param seconds the time limit for the first line, between two lines, and to the end
// \exception Output_error if the process cannot be created
Child_result run_in_child_process(const std::function<void(const Say_function&)>& function, double seconds);

// Runs `function` in a copy of this process, which shares the standard output and error, and returns its result;
// nothing if the process ended before, as CORE may end it, or a recursion that is too deep. An interruption is passed
// on.
// \exception Output_error if the process cannot be created
std::optional<int> run_in_expendable_process(const std::function<int()>& function);

} // namespace idt

#endif // IDT_CHILD_PROCESS_H

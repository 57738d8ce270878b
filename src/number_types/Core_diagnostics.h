// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Keeps CORE from writing to the user's folder.

#ifndef IDT_NUMBER_TYPES_CORE_DIAGNOSTICS_H
#define IDT_NUMBER_TYPES_CORE_DIAGNOSTICS_H

#include <string>

namespace idt {

// CORE appends warnings to a file `Core_Diagnostics` in the current folder, and exits if it cannot. While an object of
// this class lives, the current folder is a temporary one in which that file is the null device.
class Discarded_core_diagnostics
{
public:
  Discarded_core_diagnostics();
  Discarded_core_diagnostics(const Discarded_core_diagnostics&) = delete;
  Discarded_core_diagnostics& operator=(const Discarded_core_diagnostics&) = delete;
  ~Discarded_core_diagnostics();

private:
  int old_folder_ = -1;
  std::string folder_;
};

} // namespace idt

#endif // IDT_NUMBER_TYPES_CORE_DIAGNOSTICS_H

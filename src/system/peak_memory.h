// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_PEAK_MEMORY_H
#define IDT_PEAK_MEMORY_H

#include <sys/resource.h>

#include <cstdint>

namespace idt {

// The most memory that the process has had so far, all inputs together.
inline std::uint64_t peak_memory_bytes()
{
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  // Linux counts in kibibytes.
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

} // namespace idt

#endif // IDT_PEAK_MEMORY_H

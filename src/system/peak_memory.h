// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef IDT_PEAK_MEMORY_H
#define IDT_PEAK_MEMORY_H

#include <sys/resource.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace idt {

// The most memory that the process has had so far, all inputs together.
inline std::uint64_t peak_memory_bytes()
{
  // What getrusage() tells on Linux includes the program that this one replaced in its process, that is a copy of whatever started it.
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (std::uint64_t kibibytes = 0; word == "VmHWM:" && status >> kibibytes)
      return kibibytes * 1024;
  struct rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
#ifdef __APPLE__
  return static_cast<std::uint64_t>(usage.ru_maxrss);
#else
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
#endif
}

} // namespace idt

#endif // IDT_PEAK_MEMORY_H

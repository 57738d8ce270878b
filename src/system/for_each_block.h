// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A loop that all processors share.

#ifndef IDT_FOR_EACH_BLOCK_H
#define IDT_FOR_EACH_BLOCK_H

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>
#include <vector>

namespace idt {

constexpr std::size_t elements_of_block = std::size_t(1) << 14;

// Calls f(first, last) for blocks of that size that make up [0, n), from this thread and others.
template <class Function>
void for_each_block(std::size_t n, std::size_t size, const Function& f)
{
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t first; (first = next.fetch_add(size)) < n;)
      f(first, (std::min)(n, first + size));
  };
  std::vector<std::future<void>> others;
  const std::size_t blocks = (n + size - 1) / size;
  for (std::size_t i = 1; i < (std::min<std::size_t>)(blocks, std::thread::hardware_concurrency()); ++i)
    others.push_back(std::async(work)); // where there can be no thread, get() finds nothing left to do
  work();
  for (std::future<void>& other : others)
    other.get();
}

// Blocks of the usual size.
template <class Function>
void for_each_block(std::size_t n, const Function& f)
{
  for_each_block(n, elements_of_block, f);
}

} // namespace idt

#endif // IDT_FOR_EACH_BLOCK_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Long_text.h"

#include "system/for_each_block.h"

#include <algorithm>
#include <deque>
#include <future>
#include <thread>

namespace idt {

void write_blocks(std::ostream& os, const std::size_t n,
                  const std::function<void(Long_text&, std::size_t, std::size_t)>& format)
{
  // One more than there are processors: they go on while this thread writes.
  const std::size_t at_most = std::max(1u, std::thread::hardware_concurrency()) + std::size_t(1);
  std::deque<std::future<Long_text>> blocks;
  for (std::size_t first = 0; (first < n || !blocks.empty()) && os;) { // a disk may be full: the caller finds out
    for (; first < n && blocks.size() < at_most; first += elements_of_block)
      // Where there can be no thread, this one does it.
      blocks.push_back(std::async([&format, first, last = (std::min)(n, first + elements_of_block)] {
        Long_text text;
        format(text, first, last);
        return text;
      }));
    const Long_text text = blocks.front().get();
    blocks.pop_front();
    os.write(text.string().data(), static_cast<std::streamsize>(text.string().size()));
  }
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "system/Long_text.h"

#include <algorithm>
#include <deque>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace idt {

void write_blocks(std::ostream& os, const std::size_t n,
                  const std::function<void(Long_text&, std::size_t, std::size_t)>& format)
{
  // One more than there are processors: they continue while this thread writes.
  const std::size_t at_most = std::max(1u, std::thread::hardware_concurrency()) + std::size_t(1);
  std::deque<std::future<Long_text>> blocks;
  // Their memory is reused: the system would have to clear new pages.
  std::vector<Long_text> written;
  for (std::size_t first = 0; (first < n || !blocks.empty()) && os;) { // the disk may be full; the caller will notice
    for (; first < n && blocks.size() < at_most; first += elements_of_block) {
      Long_text empty;
      if (!written.empty()) {
        empty = std::move(written.back());
        written.pop_back();
      }
      // If no thread can be started, this one does the work.
      blocks.push_back(std::async(
        [&format, text = std::move(empty), first, last = (std::min)(n, first + elements_of_block)]() mutable {
          text.clear();
          format(text, first, last);
          return std::move(text);
        }));
    }
    written.push_back(blocks.front().get());
    blocks.pop_front();
    const std::string& text = written.back().string();
    os.write(text.data(), static_cast<std::streamsize>(text.size()));
  }
}

} // namespace idt

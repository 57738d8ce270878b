// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A type-erased parallel loop, so that code that is compiled once need not depend on TBB.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_BLOCK_RUNNER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_BLOCK_RUNNER_H

#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Calls f(first, last) for ranges that make up [0, n), as for_each_block().
using Block_runner =
  std::function<void(std::size_t n, std::size_t size, const std::function<void(std::size_t, std::size_t)>& f)>;

// The loop of a tag. It may be run under a lock: a thread that waits for the others begins no work from elsewhere,
// which could ask for the same lock.
template <class ConcurrencyTag>
Block_runner block_runner()
{
  return [](std::size_t n, std::size_t size, const std::function<void(std::size_t, std::size_t)>& f) {
    const auto run = [&] { for_each_block<ConcurrencyTag>(n, size, f); };
#ifdef CGAL_LINKED_WITH_TBB
    if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
      tbb::this_task_arena::isolate(run);
      return;
    }
#endif
    run();
  };
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_BLOCK_RUNNER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Loops that run on several threads if they are asked to.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_FOR_EACH_BLOCK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_FOR_EACH_BLOCK_H

#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL::Intrinsic_triangulations::internal {

// Whether several threads may work on numbers of this type at once: the type must have no shared state, and be read and
// written in one piece.
template <class T>
constexpr bool is_for_threads = std::is_same<T, double>::value || std::is_same<T, float>::value;

// The maximum number of threads.
template <class ConcurrencyTag>
std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
#endif
  return 1;
}

template <class ConcurrencyTag>
constexpr void require_threads()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is used, but TBB is not: link with the target CGAL::TBB_support");
#endif
}

// Blocks of this many elements are worth a task of their own.
constexpr std::size_t elements_of_block = std::size_t(1) << 14;

// Calls f(first, last) for ranges that make up [0, n): with `Parallel_tag`, for ranges of the given size (the last may
// be smaller) on the threads of TBB; otherwise, once for all.
template <class ConcurrencyTag, class Function>
void for_each_block(std::size_t n, std::size_t size, const Function& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value) {
    tbb::parallel_for(
      std::size_t(0), (n + size - 1) / size,
      [&](std::size_t i) {
        const Standard_arithmetic arithmetic; // each thread has its own modes
        f(i * size, (std::min)((i + 1) * size, n));
      },
      tbb::simple_partitioner());
    return;
  }
#endif
  require_threads<ConcurrencyTag>();
  (void)size;
  if (n != 0)
    f(std::size_t(0), n);
}

// Calls f(first, last, begin, end) for parts of the range, which has n elements, with the positions
// of the part's elements. Returns whether all calls returned `true`. If the range does not have
// n elements, it returns `false`, or calls f(0, n, range.begin(), range.end()).
template <class ConcurrencyTag, class Range, class Function>
bool for_each_element(const Range& range, std::size_t n, const Function& f)
{
  using Iterator = decltype(range.begin());
  constexpr bool has_random_access = std::is_convertible<typename std::iterator_traits<Iterator>::iterator_category,
                                                         std::random_access_iterator_tag>::value;
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value && has_random_access) {
    if (std::size_t(range.end() - range.begin()) != n)
      return false;
    std::atomic<bool> result{true};
    for_each_block<ConcurrencyTag>(n, elements_of_block, [&](std::size_t first, std::size_t last) {
      const Iterator begin = range.begin() + std::ptrdiff_t(first);
      if (!f(first, last, begin, begin + std::ptrdiff_t(last - first)))
        result = false;
    });
    return result;
  }
  return f(std::size_t(0), n, range.begin(), range.end());
}

// Calls f(first, last) for ranges that make up [0, n), as for_each_block().
using Block_runner =
  std::function<void(std::size_t n, std::size_t size, const std::function<void(std::size_t, std::size_t)>& f)>;

// The loop of a tag. It may run under a lock: a waiting thread does not begin unrelated work, which could ask for the
// same lock.
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

// The threads of a tag; empty if there is only one.
template <class ConcurrencyTag>
Block_runner threads()
{
  require_threads<ConcurrencyTag>();
  if constexpr (std::is_convertible<ConcurrencyTag, Parallel_tag>::value)
    return block_runner<ConcurrencyTag>();
  else
    return {};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_FOR_EACH_BLOCK_H

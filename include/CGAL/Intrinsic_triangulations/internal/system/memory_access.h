// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Explicit memory access: prefetching, and access by several threads.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_MEMORY_ACCESS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_MEMORY_ACCESS_H

#ifndef __GNUC__
#include <boost/atomic/atomic_ref.hpp>
#endif
#include <boost/config.hpp>

namespace CGAL::Intrinsic_triangulations::internal {

// Has the cache line of `*p` fetched in the background, for reading, since other threads may read it, too. (x86
// processors without PREFETCHW have no other way.) A function that does nothing else has to be forced inline: GCC
// assumes that it has no effect, and omits its calls.
BOOST_FORCEINLINE void prefetch(const void* p)
{
#ifdef __GNUC__
  __builtin_prefetch(p, 0);
#else
  (void)p;
#endif
}

// ---------------- Ordinary variables that several threads read, or store the same value in.

// What std::atomic_ref of C++20 does. Boost's has 20,000 lines, which each user of a Delta_complex would parse.
template <class T>
T relaxed_load(const T& from)
{
#ifdef __GNUC__
  T result;
  __atomic_load(&from, &result, __ATOMIC_RELAXED);
  return result;
#else
  return boost::atomic_ref<T>(const_cast<T&>(from)).load(boost::memory_order_relaxed);
#endif
}

template <class T>
void relaxed_store(T& to, T value)
{
#ifdef __GNUC__
  __atomic_store(&to, &value, __ATOMIC_RELAXED);
#else
  boost::atomic_ref<T>(to).store(value, boost::memory_order_relaxed);
#endif
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_MEMORY_ACCESS_H

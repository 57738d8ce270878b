// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Memory that will soon be needed.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_PREFETCH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_PREFETCH_H

#include <boost/config.hpp>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Has the cache line of `*p` fetched in the background, to be written.
inline void prefetch(const void* p)
{
#ifdef __GNUC__
  __builtin_prefetch(p, 1);
#else
  (void)p;
#endif
}

// The same to read it, as other threads may, too. A function that does nothing else has to be forced inline: GCC takes
// it for one without effect, and leaves out its calls.
BOOST_FORCEINLINE void prefetch_to_read(const void* p)
{
#ifdef __GNUC__
  __builtin_prefetch(p, 0);
#else
  (void)p;
#endif
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_PREFETCH_H

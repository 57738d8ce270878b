// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The vector that holds one item for each element of a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LARGE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LARGE_VECTOR_H

#include <boost/container/vector.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace CGAL::Intrinsic_triangulations {

namespace internal {

constexpr std::size_t huge_page = std::size_t(1) << 21;

// Asks for huge pages for memory that is not used yet. Best effort: a failure is ignored.
inline void wish_for_huge_pages(void* const p, const std::size_t size)
{
#ifdef __linux__
  const std::uintptr_t first = (std::uintptr_t(p) + huge_page - 1) / huge_page * huge_page,
                       last = (std::uintptr_t(p) + size) / huge_page * huge_page;
  if (first < last)
    ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
  (void)p;
  (void)size;
#endif
}

// Asks for huge pages if an array is large enough. Arrays are filled once and then hardly touched: with small pages,
// the page faults of that first pass can take longer than all computations. On other systems this is the operator
// `new`.
template <class T>
class Huge_page_allocator
{
public:
  using value_type = T;

  Huge_page_allocator() = default;
  template <class U>
  Huge_page_allocator(const Huge_page_allocator<U>&)
  {}

  T* allocate(std::size_t n)
  {
    if (n > (std::numeric_limits<std::size_t>::max)() / 2 / sizeof(T))
      throw std::bad_alloc();
    const std::size_t size = n * sizeof(T);
#ifdef __linux__
    if (size >= huge_page) {
      // Not by aligned_alloc(): glibc's does not reuse a freed block for another one of the same size, so a program
      // that makes one triangulation after the other would grow.
      const std::size_t rounded = (size + huge_page - 1) / huge_page * huge_page;
      void* const block = ::operator new(rounded + huge_page);
      const std::uintptr_t begin = std::uintptr_t(block) / huge_page * huge_page + huge_page;
      void* const p = static_cast<char*>(block) + (begin - std::uintptr_t(block));
      static_cast<void**>(p)[-1] = block; // `new` aligns to more than a pointer, so there is room
      wish_for_huge_pages(p, rounded);
      return static_cast<T*>(p);
    }
#endif
    return static_cast<T*>(::operator new(size));
  }
  void deallocate(T* p, std::size_t n)
  {
#ifdef __linux__
    if (n * sizeof(T) >= huge_page) {
      ::operator delete(reinterpret_cast<void**>(p)[-1]);
      return;
    }
#else
    (void)n;
#endif
    ::operator delete(p);
  }

  friend bool operator==(const Huge_page_allocator&, const Huge_page_allocator&) { return true; }
  friend bool operator!=(const Huge_page_allocator&, const Huge_page_allocator&) { return false; }
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsConnectivity
/// \brief a vector that holds one item for each element of a surface: a vector of Boost with an allocator of its own.
///
/// Unlike a `std::vector`, it can be made without a pass over the memory that initializes it: `Large_vector<T> v(n,
/// boost::container::default_init)`. It is constructed from a range by `Large_vector<T> v(begin, end)`.
template <class T>
using Large_vector = boost::container::vector<T, internal::Huge_page_allocator<T>>;

namespace internal {
using boost::container::default_init;

// Makes room for n more elements, so that appending them does not throw. Amortized like `push_back()`.
template <class Vector>
void make_room(Vector& vector, std::size_t n)
{
  if (vector.capacity() - vector.size() < n)
    vector.reserve(vector.size() + vector.size() / 2 + n);
}
} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LARGE_VECTOR_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Scratch space for const member functions that several threads call at once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H

#include <array>
#include <atomic>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A small number for each thread, the same for its whole life.
inline std::size_t number_of_this_thread()
{
  static std::atomic<std::size_t> next{0};
  thread_local const std::size_t number = next.fetch_add(1, std::memory_order_relaxed);
  return number;
}

// Keeps objects that remember between calls what is slow to compute. A call takes one out and puts it back; so no two calls
// ever share one. A thread finds its own object again, without a lock: unless 16 threads have come before it, no other one
// looks into its slot.
template <class Scratch>
class Scratch_pool
{
  // On a cache line of its own.
  struct alignas(64) Slot
  {
    std::atomic<Scratch*> scratch{nullptr};
  };

public:
  // An object that was taken out, and goes back at the end.
  class Lease
  {
  public:
    Lease(std::atomic<Scratch*>& slot, Scratch* scratch) : slot_(&slot), scratch_(scratch) {}
    Lease(Lease&& other) noexcept : slot_(other.slot_), scratch_(std::exchange(other.scratch_, nullptr)) {}
    Lease& operator=(Lease&&) = delete;
    ~Lease()
    {
      if (scratch_)
        delete slot_->exchange(scratch_, std::memory_order_acq_rel);
    }

    Scratch& operator*() const { return *scratch_; }
    Scratch* operator->() const { return scratch_; }

  private:
    std::atomic<Scratch*>* slot_;
    Scratch* scratch_;
  };

  Scratch_pool() = default;
  Scratch_pool(const Scratch_pool&) = delete;
  Scratch_pool& operator=(const Scratch_pool&) = delete;
  ~Scratch_pool() { clear(); }

  // `make()` returns a new object, from `new`.
  template <class Make>
  Lease take(const Make& make)
  {
    std::atomic<Scratch*>& slot = slots_[number_of_this_thread() % slots_.size()].scratch;
    Scratch* const scratch = slot.exchange(nullptr, std::memory_order_acq_rel);
    return {slot, scratch ? scratch : make()};
  }

  // To be called when none is taken.
  void clear()
  {
    for (Slot& slot : slots_)
      delete slot.scratch.exchange(nullptr, std::memory_order_acq_rel);
  }

private:
  std::array<Slot, 16> slots_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H

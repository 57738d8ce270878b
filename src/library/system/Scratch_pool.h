// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Scratch space for const member functions that several threads call at once.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H

#include <boost/config.hpp>

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A small number for each thread, the same for its whole life.
inline std::size_t number_of_this_thread()
{
  static std::atomic<std::size_t> next{0};
  thread_local const std::size_t number = next.fetch_add(1, std::memory_order_relaxed);
  return number;
}

// Keeps objects that remember results between calls. A call takes one out and puts it back, so no two calls ever share
// one. A thread finds its own object again, without a lock, unless another thread has the same slot or has taken it:
// then any object that is not in use will do. There are never more objects than were in use at once.
template <class Scratch>
class Scratch_pool
{
  // On a cache line of its own.
  struct alignas(64) Slot
  {
    std::atomic<Scratch*> scratch{nullptr};
  };

public:
  // An object that was taken out and goes back when this is destroyed.
  class Lease
  {
  public:
    Lease(Scratch_pool& pool, std::atomic<Scratch*>& slot, Scratch* scratch)
      : pool_(&pool), slot_(&slot), scratch_(scratch)
    {}
    Lease(Lease&& other) noexcept
      : pool_(other.pool_), slot_(other.slot_), scratch_(std::exchange(other.scratch_, nullptr))
    {}
    Lease& operator=(Lease&&) = delete;
    ~Lease()
    {
      if (scratch_)
        if (Scratch* const other = slot_->exchange(scratch_, std::memory_order_acq_rel))
          pool_->keep(other);
    }

    Scratch& operator*() const { return *scratch_; }
    Scratch* operator->() const { return scratch_; }

  private:
    Scratch_pool* pool_;
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
    return {*this, slot, scratch ? scratch : take_other(make)};
  }

  // How many objects there are, in use or not.
  std::size_t size()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return size_;
  }

  // Must be called while none is taken.
  void clear()
  {
    for (Slot& slot : slots_)
      delete slot.scratch.exchange(nullptr, std::memory_order_acq_rel);
    for (Scratch* scratch : others_)
      delete scratch;
    others_.clear();
    size_ = 0;
  }

private:
  template <class Make>
  BOOST_NOINLINE Scratch* take_other(const Make& make)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!others_.empty()) {
      Scratch* const scratch = others_.back();
      others_.pop_back();
      return scratch;
    }
    for (Slot& slot : slots_)
      if (Scratch* const scratch = slot.scratch.exchange(nullptr, std::memory_order_acq_rel))
        return scratch;
    others_.reserve(size_ + 1);
    Scratch* const scratch = make();
    ++size_;
    return scratch;
  }
  BOOST_NOINLINE void keep(Scratch* scratch)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    others_.push_back(scratch); // there is room for all
  }

  std::array<Slot, 64> slots_;
  std::mutex mutex_;
  std::vector<Scratch*> others_;
  std::size_t size_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SYSTEM_SCRATCH_POOL_H

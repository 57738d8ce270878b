// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The flips that some reader has not read yet.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_LOG_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_LOG_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// One log of flips with three cursors: the integers (Correspondence) and the knowledge of faces (Straight_faces,
// Developed_faces) are brought up to date independently of each other; numbers (Repeated_flips) begin at the first
// flip.
//
// A reader either follows each flip at once, or has a cursor: the first flip that it has not read. A query makes the
// reader that it needs read the rest and follow. `begin()` makes both stop, so that a run of flips without queries only
// appends to the log. Numbers follow from where other changes, or too many flips, end what they can repeat. As soon as
// all follow, the log is empty.
//
// Each flip is noted as the halfedges around the edge before it. The log consists of parts, so that it grows without
// copying and can adopt the logs of threads.
//
// Several threads may ask `is_followed_by()` while one of them reads and calls `follow()`.
class Flip_log
{
public:
  enum Reader {
    INTEGERS,
    FACES,
    NUMBERS
  };

  Flip_log() = default;
  Flip_log& operator=(const Flip_log& other)
  {
    parts_ = other.parts_;
    size_of_full_parts_ = other.size_of_full_parts_;
    for (Reader reader : {INTEGERS, FACES, NUMBERS})
      cursors_[reader] = other.cursors_[reader].load();
    return *this;
  }

  bool is_followed_by(Reader reader) const { return cursors_[reader].load(std::memory_order_acquire) == at_end; }
  // Whether a reader follows that stops when the log begins.
  bool is_followed() const { return is_followed_by(INTEGERS) || is_followed_by(FACES); }
  bool is_followed_by_all() const
  {
    return is_followed_by(INTEGERS) && is_followed_by(FACES) && is_followed_by(NUMBERS);
  }

  // From now on, integers and faces do not follow.
  void begin()
  {
    for (Reader reader : {INTEGERS, FACES})
      if (is_followed_by(reader))
        cursors_[reader] = size();
  }

  // Notes a flip for the readers that do not follow. \pre not `is_followed_by_all()`
  void push_back(const Hinge_halfedges& flip)
  {
    if (parts_.empty() || parts_.back().size() == parts_.back().capacity())
      begin_part();
    parts_.back().push_back(flip);
  }
  // Removes the last flip, which no reader has read.
  void pop_back()
  {
    while (parts_.back().empty()) {
      parts_.pop_back();
      size_of_full_parts_ -= parts_.back().size();
    }
    parts_.back().pop_back();
  }
  // Afterwards, this many calls of append() do not throw.
  void make_room(std::size_t number) { parts_.reserve(parts_.size() + number); }
  // Adopts flips that were noted elsewhere. \pre no reader follows
  void append(std::vector<Hinge_halfedges> flips)
  {
    CGAL_precondition(!is_followed());
    const std::size_t n = size();
    parts_.push_back(std::move(flips));
    size_of_full_parts_ = n;
  }
  std::size_t size() const { return parts_.empty() ? 0 : size_of_full_parts_ + parts_.back().size(); }

  // f(flip) for each that a reader has not read, in order.
  template <class Function>
  void for_each_unread(Reader reader, const Function& f) const
  {
    std::size_t read = size() - number_of_unread(reader);
    for (const std::vector<Hinge_halfedges>& part : parts_) {
      const std::size_t skipped = (std::min)(read, part.size());
      read -= skipped;
      for (std::size_t i = skipped; i < part.size(); ++i)
        f(part[i]);
    }
  }
  // The same from the last flip to the first.
  template <class Function>
  void for_each_unread_backwards(Reader reader, const Function& f) const
  {
    std::size_t unread = number_of_unread(reader);
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part)
      for (auto flip = part->rbegin(); flip != part->rend() && unread != 0; ++flip, --unread)
        f(*flip);
  }
  // f(complex, flip) for each, with the triangulation before it. \param complex the triangulation now
  template <class Function>
  void repeat_unread(Reader reader, Delta_complex complex, const Function& f) const
  {
    for_each_unread_backwards(reader, [&](const Hinge_halfedges& flip) { complex.flip_back(flip); });
    for_each_unread(reader, [&](const Hinge_halfedges& flip) {
      f(std::as_const(complex), flip);
      complex.flip(flip);
    });
  }
  std::size_t number_of_unread(Reader reader) const
  {
    return is_followed_by(reader) ? 0 : size() - cursors_[reader].load(std::memory_order_relaxed);
  }
  // The reader has read everything, and follows each flip from now on.
  void follow(Reader reader)
  {
    cursors_[reader].store(at_end, std::memory_order_release);
    if (is_followed_by_all()) {
      parts_ = {};
      size_of_full_parts_ = 0;
    }
  }

private:
  static constexpr std::size_t at_end = (std::numeric_limits<std::size_t>::max)();

  void begin_part()
  {
    constexpr std::size_t size_of_part = 2048;
    const std::size_t n = size();
    parts_.emplace_back();
    size_of_full_parts_ = n;
    parts_.back().reserve(size_of_part);
  }

  std::vector<std::vector<Hinge_halfedges>> parts_;
  std::size_t size_of_full_parts_ = 0; // of all parts except the last
  std::array<std::atomic<std::size_t>, 3> cursors_{};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_LOG_H

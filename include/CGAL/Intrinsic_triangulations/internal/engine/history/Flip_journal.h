// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The flips that were made, in their order.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_JOURNAL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_JOURNAL_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Each flip as the halfedges around the edge before it. In parts, so that it grows without being
// copied, and takes over what others have noted.
class Flip_journal
{
public:
  void push_back(const Hinge_halfedges& flip)
  {
    if (parts_.empty() || parts_.back().size() == parts_.back().capacity())
      begin_part();
    parts_.back().push_back(flip);
  }
  // \pre the last flip was noted by push_back()
  void pop_back() { parts_.back().pop_back(); }
  // So many calls of append() do not throw then.
  void make_room(std::size_t number) { parts_.reserve(parts_.size() + number); }
  void append(std::vector<Hinge_halfedges> flips)
  {
    const std::size_t n = size();
    parts_.push_back(std::move(flips));
    size_of_full_parts_ = n;
  }
  std::size_t size() const { return parts_.empty() ? 0 : size_of_full_parts_ + parts_.back().size(); }

  template <class Function>
  void for_each(const Function& f) const
  {
    for (const std::vector<Hinge_halfedges>& part : parts_)
      for (const Hinge_halfedges& flip : part)
        f(flip);
  }
  // From the last to the first.
  template <class Function>
  void for_each_backwards(const Function& f) const
  {
    for (auto part = parts_.rbegin(); part != parts_.rend(); ++part)
      for (auto flip = part->rbegin(); flip != part->rend(); ++flip)
        f(*flip);
  }

private:
  void begin_part()
  {
    constexpr std::size_t size_of_part = 2048;
    const std::size_t n = size();
    parts_.emplace_back();
    size_of_full_parts_ = n;
    parts_.back().reserve(size_of_part);
  }

  std::vector<std::vector<Hinge_halfedges>> parts_;
  std::size_t size_of_full_parts_ = 0; // of all but the last
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_HISTORY_FLIP_JOURNAL_H

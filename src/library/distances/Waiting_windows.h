// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Windows that wait at their sides for their turn; some are dropped or merged.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAITING_WINDOWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAITING_WINDOWS_H

#include "Nearest_first_queue.h"
#include "Window.h"

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/system/memory_access.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Windows that wait at the same side are merged if they come from the same point, as on both sides of a flat vertex. Of
// two that come from the same vertex over different faces, each is cut off where the other is shorter.
//
// With a tolerance, all windows at a side wait for each other. Those that are nowhere the shortest are dropped, and
// neighbors are merged if that changes no distance and no direction by more than the tolerance. Far from the sources,
// most sides are then crossed by a single window, however fine the faces are.
class Waiting_windows
{
public:
  // \param rests lower bounds of the distances of rows from a goal, or null: windows are ordered by a lower bound of
  //   their distance plus the rest
  Waiting_windows(const Laid_out_faces& surface, double tolerance, const std::vector<double>* rests)
    : surface_(surface), tolerance_(tolerance), rests_(rests),
      waiting_(tolerance > 0 ? surface.sides().size() : 0, none), in_order_(tolerance > 0 ? 0 : surface.sides().size())
  {}
  Waiting_windows(const Waiting_windows&) = delete; // the queue refers to it
  Waiting_windows& operator=(const Waiting_windows&) = delete;

  // A bundle.
  void add(Window w)
  {
    if (tolerance_ == 0)
      return add_in_order(w);
    std::uint32_t& first = waiting_[w.side];
    w.next = first;
    first = store(w);
    if (w.next == none) // a front enters a face without obtuse angle through sides whose middles are nearer
      queue_.push({w.distance(surface_.side(w.side).length / 2), first});
  }

  // \param event sigma becomes the distance
  void add_event(double distance, Window event)
  {
    event.sigma = distance;
    queue_.push({rests_ ? distance + (*rests_)[surface_.side(event.side).row] : distance, store(event)});
  }

  bool is_empty() const { return queue_.empty(); }

  // The next window with its place in the order. With a tolerance, a bundle stands for all at its side, and stays
  // there. Without one, it may have been taken by another one (`Window::taken`).
  std::pair<double, Window> pop()
  {
    const auto [distance, slot] = queue_.top();
    queue_.pop();
    if (!queue_.empty())
      prefetch(&windows_[queue_.top().second]);
    const Window w = windows_[slot];
    if (!w.is_bundle() || tolerance_ == 0) {
      if (w.is_bundle() && w.next != Window::taken)
        remove(slot);
      free_.push_back(slot);
    }
    return {distance, w};
  }

  // All windows that wait at a side, merged as far as the tolerance allows. Valid until the next call.
  const std::vector<Window>& take_all(std::uint32_t side)
  {
    meeting_.clear();
    for (std::uint32_t slot = waiting_[side]; slot != none; slot = windows_[slot].next) {
      meeting_.push_back(windows_[slot]);
      free_.push_back(slot);
    }
    waiting_[side] = none;
    std::sort(meeting_.begin(), meeting_.end(), is_before);
    std::size_t last = 0;
    for (std::size_t i = 1; i < meeting_.size(); ++i)
      if (!unite_nearly(meeting_[last], meeting_[i]))
        meeting_[++last] = meeting_[i];
    meeting_.erase(meeting_.begin() + std::ptrdiff_t(last) + 1, meeting_.end());
    return meeting_;
  }

private:
  static constexpr std::uint32_t none = Laid_out_faces::none;

  // A window in the queue: its distance, and where it is stored.
  using Place = std::pair<double, std::uint32_t>;
  // Among windows at the same distance, those at the first side come first, independent of numbering.
  struct Comes_later
  {
    const Waiting_windows& waiting;

    bool operator()(const Place& a, const Place& b) const
    {
      if (a.first != b.first)
        return a.first > b.first;
      const Window &u = waiting.windows_[a.second], &v = waiting.windows_[b.second];
      return u.side == v.side ? is_before(v, u) : waiting.surface_.is_before(v.side, u.side);
    }
  };

  // Along the side, the rest falls no faster than the distance to an end.
  double least_length(const Window& w) const
  {
    const double least = w.distance(w.nearest());
    if (!rests_)
      return least;
    const Laid_out_faces::Side& s = surface_.side(w.side);
    const double at_begin = (*rests_)[s.row], at_end = (*rests_)[surface_.side(Laid_out_faces::next(w.side)).row];
    return (std::max)({least, w.distance(w.b1) + at_begin - w.b1, w.distance(w.b0) + at_end - (s.length - w.b0)});
  }

  std::uint32_t store(const Window& window)
  {
    std::uint32_t slot = std::uint32_t(windows_.size());
    if (free_.empty())
      windows_.push_back(window);
    else {
      slot = free_.back();
      free_.pop_back();
      windows_[slot] = window;
    }
    return slot;
  }

  // Removes a window from those that wait at its side in order.
  void remove(std::uint32_t slot)
  {
    std::vector<Place>& row = in_order_[windows_[slot].side];
    auto place = std::lower_bound(row.begin(), row.end(), Place(windows_[slot].place_in_order(), 0));
    while (place->second != slot)
      ++place;
    row.erase(place);
  }

  // Adds a window between the waiting ones whose ways come from farther to the left and from farther to the right. Of
  // all these windows, parts that others reach sooner are cut off.
  void add_in_order(Window& w)
  {
    std::vector<Place>& row = in_order_[w.side];
    auto place = unite_with_waiting(w);
    while (place != row.end() && place->first < w.place_in_order())
      ++place;
    for (; place != row.end(); place = row.erase(place)) {
      Window& other = windows_[place->second];
      if (!trim_end(w, other))
        return;
      if (trim_beginning(other, w))
        break;
      other.next = Window::taken;
    }
    for (; place != row.begin(); place = row.erase(place)) {
      Window& other = windows_[std::prev(place)->second];
      if (!trim_beginning(w, other))
        return;
      if (trim_end(other, w))
        break;
      other.next = Window::taken;
      --place;
    }
    const std::uint32_t slot = store(w);
    row.insert(place, Place(w.place_in_order(), slot));
    // The window waits for the distance of its nearest point: windows derived from it are not nearer, so ways continue
    // from a vertex only once the shortest way to it is known.
    queue_.push({least_length(w), slot});
  }

  // Merges a window with waiting ones that come from the same point, if possible.
  // \return the first one that comes from about the same place, or from beyond it
  std::vector<Place>::iterator unite_with_waiting(Window& w)
  {
    const double least_gap = least_width * surface_.side(w.side).length;
    std::vector<Place>& row = in_order_[w.side];
    const auto first_near = [&] {
      return std::lower_bound(row.begin(), row.end(), Place(w.place_in_order() - 2 * least_difference(w), 0));
    };
    const auto is_near = [&](const Place& place) {
      return place.first <= w.place_in_order() + 2 * least_difference(w);
    };
    auto first = first_near();
    for (auto place = first; place != row.end() && is_near(*place);) {
      Window& other = windows_[place->second];
      const Window &u = other.b0 < w.b0 ? other : w, &v = other.b0 < w.b0 ? w : other;
      if (v.b0 > u.b1 + least_gap || !come_from_same_point(u, v)) {
        ++place;
        continue;
      }
      w = both(u, v);
      other.next = Window::taken;
      row.erase(place);
      place = first = first_near();
    }
    return first;
  }

  // \param u begins before v
  // \return whether u now represents both
  bool unite_nearly(Window& u, const Window& v) const
  {
    const double length = surface_.side(u.side).length;
    if (is_nowhere_shorter(v, u))
      return true;
    if (is_nowhere_shorter(u, v)) {
      u = v;
      return true;
    }
    // Changed windows leave gaps between them, which grow with the distance.
    if (v.b1 <= u.b1 || v.b0 > u.b1 + length / 10 || u.source != v.source)
      return false;
    Window result = both(u, v);
    if (!come_from_same_point(u, v)) {
      // The distances of the ends do not change.
      const double width = result.b1 - result.b0, at_b0 = u.distance(u.b0), at_b1 = v.distance(v.b1);
      if (u.kind == Window::FRONT || v.kind == Window::FRONT) {
        result.kind = Window::FRONT;
        result.x = (at_b1 - at_b0) / width;
        if (!(std::abs(result.x) < 1))
          return false;
        result.y = std::sqrt((1 - result.x) * (1 + result.x));
        result.sigma = at_b0 - result.x * result.b0;
      } else {
        result.sigma = (std::min)(u.sigma, v.sigma);
        const double r0 = at_b0 - result.sigma, r1 = at_b1 - result.sigma,
                     x = (width + (r0 - r1) * ((r0 + r1) / width)) / 2;
        if (!(std::abs(x) < r0))
          return false;
        result.x = result.b0 + x;
        result.y = std::sqrt((r0 - x) * (r0 + x));
      }
      const auto differs = [&](const Window& w, double b) {
        return std::abs(w.distance(b) - result.distance(b)) > tolerance_ * length;
      };
      if (turns(u, result, u.b0) || turns(v, result, v.b1) || differs(u, u.b1) || differs(v, v.b0) ||
          differs(u, (u.b0 + u.b1) / 2) || differs(v, (v.b0 + v.b1) / 2))
        return false;
    }
    u = result;
    return true;
  }

  // Whether the ways of another window are shorter at all points of w; or longer by at most the tolerance, if they have
  // the same direction.
  bool is_nowhere_shorter(const Window& w, const Window& other) const
  {
    if (w.b0 < other.b0 || w.b1 > other.b1)
      return false;
    const double more = turns(w, other, w.b0) || turns(w, other, w.b1) ? 0 : tolerance_ * surface_.side(w.side).length;
    for (double b : {w.b0, (w.b0 + w.b1) / 2, w.b1})
      if (other.distance(b) > w.distance(b) + more)
        return false;
    return true;
  }

  // In a corridor of thin faces, turned ways would run into the wall.
  bool turns(const Window& u, const Window& v, double b) const
  {
    const auto cosine = [b](const Window& w) { return w.run(b) / length_of(w.run(b), w.y); };
    return std::abs(cosine(u) - cosine(v)) > 3 * tolerance_;
  }

  const Laid_out_faces& surface_;
  double tolerance_;
  const std::vector<double>* rests_;
  std::vector<Window> windows_;
  std::vector<std::uint32_t> free_;          // places for windows
  std::vector<std::uint32_t> waiting_;       // at each side, the first window, with a tolerance
  std::vector<std::vector<Place>> in_order_; // at each side, all windows from left to right, without a tolerance
  std::vector<Window> meeting_;
  Nearest_first_queue<Place, Comes_later> queue_{Comes_later{*this}};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WAITING_WINDOWS_H

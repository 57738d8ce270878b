// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Chord_arrangement.h.

#include "Chord_arrangement.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

void Chord_arrangement::build(std::uint32_t n, std::vector<Chord> chords, std::size_t size_of_first_family)
{
  n_ = n;
  chords_ = std::move(chords);
  size_of_first_family_ = size_of_first_family;
  nest();
  find_crossings();
  make_paths();
  sort_ends();
}

// Chords that do not cross are nested like brackets. A chord is around a node if the node lies strictly between its ends.
void Chord_arrangement::nest()
{
  std::vector<std::uint32_t> opening(size_of_first_family_), open;
  std::iota(opening.begin(), opening.end(), 0u);
  const auto low = [&](std::uint32_t c) { return (std::min)(chords_[c].a, chords_[c].b); };
  const auto high = [&](std::uint32_t c) { return (std::max)(chords_[c].a, chords_[c].b); };
  std::sort(opening.begin(), opening.end(),
            [&](std::uint32_t c, std::uint32_t d) { return low(c) != low(d) ? low(c) < low(d) : high(c) > high(d); });
  around_node_.assign(n_, none);
  around_chord_.assign(size_of_first_family_, none);
  auto c = opening.begin();
  for (std::uint32_t x = 0; x < n_; ++x) {
    while (!open.empty() && high(open.back()) == x)
      open.pop_back();
    if (!open.empty())
      around_node_[x] = open.back();
    for (; c != opening.end() && low(*c) == x; ++c) {
      if (!open.empty())
        around_chord_[*c] = open.back();
      open.push_back(*c);
    }
  }
}

// A chord leaves all chords that are around its lower end, but not around the higher one or ending there, and then enters
// those around the higher end alone.
void Chord_arrangement::find_crossings()
{
  crossings_.clear();
  std::vector<std::uint32_t> crossed, entered;
  for (std::uint32_t d = std::uint32_t(size_of_first_family_); d < chords_.size(); ++d) {
    const auto [low, high] = std::minmax(chords_[d].a, chords_[d].b);
    crossed.clear();
    entered.clear();
    for (std::uint32_t c = around_node_[low]; c != none && (std::max)(chords_[c].a, chords_[c].b) < high;
         c = around_chord_[c])
      crossed.push_back(c);
    for (std::uint32_t c = around_node_[high]; c != none && (std::min)(chords_[c].a, chords_[c].b) > low;
         c = around_chord_[c])
      entered.push_back(c);
    crossed.insert(crossed.end(), entered.rbegin(), entered.rend());
    if (chords_[d].a > chords_[d].b)
      std::reverse(crossed.begin(), crossed.end());
    for (std::uint32_t c : crossed)
      crossings_.push_back({c, d});
  }
}

// The crossings of the second family are in order. Along a chord of the first family from its lower end, the nearer the
// end of another chord between its ends is to that end, the earlier it comes; from the same end, the farther its other one.
void Chord_arrangement::make_paths()
{
  std::vector<std::uint32_t> counts(chords_.size(), 2);
  for (const Crossing& x : crossings_) {
    ++counts[x.first];
    ++counts[x.second];
  }
  first_places_.assign(1, 0);
  for (std::uint32_t count : counts)
    first_places_.push_back(first_places_.back() + count);
  path_.resize(first_places_.back());
  chord_at_.resize(path_.size());
  for (std::uint32_t c = 0; c < chords_.size(); ++c) {
    std::fill(chord_at_.begin() + first_places_[c], chord_at_.begin() + first_places_[c + 1], c);
    path_[first_places_[c]] = chords_[c].a;
    path_[first_places_[c + 1] - 1] = chords_[c].b;
  }
  places_of_crossing_.resize(crossings_.size());
  std::vector<std::uint32_t> filled(first_places_.begin(), first_places_.end() - 1);
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;
  std::vector<Key> order;
  for (std::uint32_t x = 0; x < crossings_.size(); ++x) {
    const auto [c, d] = crossings_[x];
    places_of_crossing_[x].second = ++filled[d];
    path_[filled[d]] = n_ + x;
    const auto [low, high] = std::minmax(chords_[c].a, chords_[c].b);
    std::uint32_t inside = chords_[d].a, outside = chords_[d].b;
    if (!(low < inside && inside < high))
      std::swap(inside, outside);
    order.emplace_back(c, inside, n_ - after(low, outside), x);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [c, inside, outside, x] : order) {
    const std::uint32_t i = ++filled[c] - first_places_[c];
    const std::uint32_t place = chords_[c].a < chords_[c].b ? first_places_[c] + i : first_places_[c + 1] - 1 - i;
    places_of_crossing_[x].first = place;
    path_[place] = n_ + x;
  }
}

void Chord_arrangement::sort_ends()
{
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> order; // node, distance, dart
  for (std::size_t c = 0; c < chords_.size(); ++c) {
    const auto [a, b] = chords_[c];
    order.emplace_back(a, after(a, b), forward(first_places_[c]));
    order.emplace_back(b, after(b, a), backward(first_places_[c + 1] - 1));
  }
  std::sort(order.begin(), order.end());
  ends_.clear();
  first_ends_.assign(n_ + 1, 0);
  ranks_.resize(2 * chords_.size());
  for (const auto& [node, distance, d] : order) {
    ranks_[2 * chord_at_[place(d)] + (is_forward(d) ? 0 : 1)] = std::uint32_t(ends_.size());
    ends_.push_back(d);
    ++first_ends_[node + 1];
  }
  std::partial_sum(first_ends_.begin(), first_ends_.end(), first_ends_.begin());
}

Chord_arrangement::Dart Chord_arrangement::dart(std::uint32_t d) const
{
  if (d < n_)
    return {d, none, true};
  return {path_[place(d) + (is_forward(d) ? 0 : 1)], chord_at_[place(d)], is_forward(d)};
}

std::uint32_t Chord_arrangement::target(std::uint32_t d) const
{
  if (d < n_)
    return d + 1 == n_ ? 0 : d + 1;
  return path_[place(d) + (is_forward(d) ? 1 : 0)];
}

// As far to the left as possible.
std::uint32_t Chord_arrangement::next(std::uint32_t d) const
{
  const std::uint32_t y = target(d);
  if (y < n_) { // clockwise from where d comes from; the circle is last
    const std::uint32_t came = d < n_ ? first_ends_[y + 1] : ranks_[2 * chord_at_[place(d)] + (is_forward(d) ? 1 : 0)];
    return came == first_ends_[y] ? y : ends_[came - 1];
  }
  const auto [c, e] = crossings_[y - n_];
  const Chord &first = chords_[c], &second = chords_[e];
  const auto [on_first, on_second] = places_of_crossing_[y - n_];
  const bool leads_left = after(first.a, second.b) > after(first.a, first.b), is_first = chord_at_[place(d)] == c;
  const std::uint32_t other = is_first ? on_second : on_first;
  return is_forward(d) == (is_first == leads_left) ? forward(other) : backward(other);
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds the triangles of another system in ours. Both are triangulations of the same surface with the same vertices;
// sides are compared from face to face, outward from an edge with few similar ones. Where faces have a common
// circumcircle the choice of diagonals is free: there ours are flipped to theirs.

#ifndef IDT_BENCHMARK_SYSTEMS_MATCH_TRIANGLES_H
#define IDT_BENCHMARK_SYSTEMS_MATCH_TRIANGLES_H

#include "own_triangulation.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace systems {

// An edge counts as a tie if its cotangents cancel up to this fraction of the larger one: rounded decisions may choose
// either diagonal. The verdict is decided exactly afterwards.
constexpr double tie_tolerance = 1e-5;

class Match
{
public:
  using Halfedge = IT::Halfedge_index;

  // \pre `ours` is Delaunay, and `theirs` has as many faces, corners that exist, and sides that are glued in pairs
  Match(const Own_triangulation& ours, const Triangles& theirs) : theirs_(theirs), state_(ours, theirs)
  {
    while (state_.number_of_faces < theirs.corners.size() && match_a_component()) {
    }
  }

  // The number of their faces that are in ours.
  std::size_t number_of_faces() const { return state_.number_of_faces; }
  // Whether all are, and are glued like ours.
  bool is_complete() const
  {
    if (state_.number_of_faces < theirs_.corners.size())
      return false;
    for (std::size_t side = 0; side < theirs_.number_of_sides(); ++side) {
      const Halfedge opposite = complex().opposite(state_.halfedges[side]);
      if (complex().is_border(opposite)
            ? theirs_.opposite[side] >= 0
            : theirs_.opposite[side] < 0 || state_.halfedges[std::size_t(theirs_.opposite[side])] != opposite)
        return false;
    }
    return true;
  }
  // Ours, with their diagonals.
  const Own_triangulation& triangulation() const { return state_.ours; }
  // \pre is_complete()
  Halfedge halfedge(std::size_t side) const { return state_.halfedges[side]; }

private:
  struct State
  {
    State(const Own_triangulation& triangulation, const Triangles& theirs)
      : ours(triangulation), halfedges(theirs.number_of_sides()),
        is_matched(triangulation.connectivity().number_of_halfedges(), false)
    {}
    Own_triangulation ours;
    std::vector<Halfedge> halfedges; // of their sides; invalid if not matched
    std::vector<bool> is_matched;    // of our halfedges
    std::size_t number_of_faces = 0;
  };

  // A corner that the face at a halfedge can get by flipping these edges, the last one first.
  struct Candidate
  {
    double error = std::numeric_limits<double>::infinity(); // of the lengths of its two other sides, relative
    std::vector<Halfedge> path;
  };

  using Position = std::complex<double>;

  const IT::Delta_complex& complex() const { return state_.ours.connectivity(); }

  bool is_free_diagonal(Halfedge h) const
  {
    const IT::Edge_index e = complex().edge(h);
    if (!complex().is_flippable(e) || state_.is_matched[h.idx()] || state_.is_matched[complex().opposite(h).idx()])
      return false;
    const double a = state_.ours.cotangent(h), b = state_.ours.cotangent(complex().opposite(h));
    return std::abs(a + b) <= tie_tolerance * (std::max)(1., (std::max)(std::abs(a), std::abs(b)));
  }

  // The corner to the left of the way from p to q.
  Position apex(Position p, Position q, double from_p, double from_q) const
  {
    const double base = std::abs(q - p);
    const double x = (base * base + from_p * from_p - from_q * from_q) / (2 * base);
    return p + (q - p) / base * Position(x, std::sqrt((std::max)(0., from_p * from_p - x * x)));
  }

  double length(Halfedge h) const { return state_.ours.length(complex().edge(h)); }

  void look_at_corner(std::size_t side, Position p, Position q, Position r, std::uint32_t vertex,
                      const std::vector<Halfedge>& path, Candidate& best) const
  {
    const std::size_t next = Triangles::next(side);
    if (vertex != theirs_.apex(side))
      return;
    const double to_r = theirs_.lengths[next], from_r = theirs_.lengths[Triangles::next(next)];
    const double error =
      (std::max)(std::abs(std::abs(r - q) - to_r) / to_r, std::abs(std::abs(r - p) - from_r) / from_r);
    if (error < best.error)
      best = {error, path};
  }

  // Looks for the corner of their face at `side` in ours, at `h` and across free diagonals.
  Candidate find_apex(std::size_t side, Halfedge h) const
  {
    constexpr std::size_t most_faces = 2000;
    constexpr double is_close = 1e-6;
    struct Step
    {
      Halfedge h;
      Position p, q;
      std::size_t previous; // in steps
    };
    std::vector<Step> steps{{h, 0, length(h), 0}};
    std::vector<std::uint32_t> visited{complex().face(h).idx()};
    Candidate best;
    for (std::size_t i = 0; i < steps.size() && i < most_faces; ++i) {
      const Step step = steps[i];
      const Halfedge next = complex().next(step.h), prev = complex().prev(step.h);
      const Position r = apex(step.p, step.q, length(prev), length(next));
      std::vector<Halfedge> path;
      for (std::size_t k = i; k != 0; k = steps[k].previous)
        path.push_back(steps[k].h);
      look_at_corner(side, 0, length(h), r, complex().target(next).idx(), path, best);
      if (best.error < is_close)
        break;
      const auto cross = [&](Halfedge over, Position p, Position q) {
        const Halfedge opposite = complex().opposite(over);
        if (!is_free_diagonal(over))
          return;
        const std::uint32_t face = complex().face(opposite).idx();
        if (std::find(visited.begin(), visited.end(), face) != visited.end())
          return;
        visited.push_back(face);
        steps.push_back({opposite, p, q, i});
      };
      cross(next, r, step.q);
      cross(prev, step.p, r);
    }
    return best;
  }

  // Matches the face at `side` with the one at `h`.
  bool match_face(std::size_t side, Halfedge h)
  {
    if (complex().is_border(h) || state_.is_matched[h.idx()] || complex().source(h).idx() != theirs_.source(side) ||
        complex().target(h).idx() != theirs_.target(side))
      return false;
    for (Halfedge over : find_apex(side, h).path)
      if (state_.ours.flip(complex().edge(over)) != Own_triangulation::Flip_outcome::FLIPPED)
        return false;
    if (complex().target(complex().next(h)).idx() != theirs_.apex(side))
      return false;
    for (int i = 0; i < 3; ++i, side = Triangles::next(side), h = complex().next(h)) {
      state_.halfedges[side] = h;
      state_.is_matched[h.idx()] = true;
    }
    ++state_.number_of_faces;
    return true;
  }

  // Matches everything reachable from one pair of sides. \return whether there was no contradiction
  bool match_from(std::size_t first_side, Halfedge first)
  {
    bool is_same = true;
    std::vector<std::pair<std::size_t, Halfedge>> pairs{{first_side, first}};
    while (!pairs.empty()) {
      auto [side, h] = pairs.back();
      pairs.pop_back();
      if (state_.halfedges[side].is_valid())
        continue;
      if (!match_face(side, h)) {
        is_same = false;
        continue;
      }
      for (int i = 0; i < 3; ++i, side = Triangles::next(side), h = complex().next(h))
        if (theirs_.opposite[side] >= 0)
          pairs.emplace_back(std::size_t(theirs_.opposite[side]), complex().opposite(h));
    }
    return is_same;
  }

  // Of the angle opposite to a side, by their lengths.
  double their_cotangent(std::size_t side) const
  {
    const std::size_t next = Triangles::next(side);
    const double a = theirs_.lengths[side], b = theirs_.lengths[next], c = theirs_.lengths[Triangles::next(next)];
    return (b * b + c * c - a * a) / std::sqrt((a + b + c) * (b + c - a) * (a + c - b) * (a + b - c));
  }

  // Whether it is not the diagonal of a tie or near tie, which may be missing in ours.
  bool can_be_first(std::size_t side) const
  {
    if (theirs_.opposite[side] < 0)
      return true;
    const double a = their_cotangent(side), b = their_cotangent(std::size_t(theirs_.opposite[side]));
    return std::abs(a + b) > 1e-3 * (std::max)(1., (std::max)(std::abs(a), std::abs(b)));
  }

  struct First_pair
  {
    bool is_preferred; // no tie, and the lengths agree
    std::size_t side;
    std::vector<Halfedge> candidates;
  };

  // The sides with the fewest candidates among ours, each side once.
  std::vector<First_pair> first_pairs() const
  {
    constexpr std::size_t most_pairs = 8, most_candidates = 16;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Halfedge>> sides_of;
    for (Halfedge h : complex().halfedges())
      if (!complex().is_border(h) && !state_.is_matched[h.idx()] && !is_free_diagonal(h))
        sides_of[{complex().source(h).idx(), complex().target(h).idx()}].push_back(h);
    std::vector<First_pair> result;
    const auto is_before = [](const First_pair& a, const First_pair& b) {
      return a.is_preferred != b.is_preferred ? a.is_preferred : a.candidates.size() < b.candidates.size();
    };
    for (std::size_t side = 0; side < theirs_.number_of_sides(); ++side) {
      const auto found = sides_of.find({theirs_.source(side), theirs_.target(side)});
      if (state_.halfedges[side].is_valid() || found == sides_of.end())
        continue;
      const auto error = [&](Halfedge h) { return std::abs(length(h) - theirs_.lengths[side]); };
      First_pair pair{false, side, found->second};
      std::stable_sort(pair.candidates.begin(), pair.candidates.end(),
                       [&](Halfedge a, Halfedge b) { return error(a) < error(b); });
      pair.is_preferred = can_be_first(side) && error(pair.candidates.front()) < 1e-3 * theirs_.lengths[side];
      pair.candidates.resize((std::min)(pair.candidates.size(), most_candidates));
      result.push_back(pair);
      if (result.size() == 2 * most_pairs) {
        std::stable_sort(result.begin(), result.end(), is_before);
        result.resize(most_pairs);
      }
    }
    std::stable_sort(result.begin(), result.end(), is_before);
    result.resize((std::min)(result.size(), most_pairs));
    return result;
  }

  // The best of some attempts. \return whether there was any
  bool match_a_component()
  {
    const State before = state_;
    State best = state_;
    for (const First_pair& first : first_pairs())
      for (Halfedge h : first.candidates) {
        if (contradictions_ == most_contradictions)
          break;
        state_ = before;
        const bool is_same = match_from(first.side, h);
        const double error = largest_error(state_);
        if (state_.number_of_faces > best.number_of_faces ||
            (state_.number_of_faces == best.number_of_faces && error < largest_error(best)))
          best = state_;
        if (is_same && error < 1e-6)
          return true;
        ++contradictions_;
      }
    const bool is_larger = best.number_of_faces > before.number_of_faces;
    state_ = best;
    return is_larger;
  }

  // Of the lengths, relative.
  double largest_error(const State& state) const
  {
    double result = 0;
    for (std::size_t side = 0; side < theirs_.number_of_sides(); ++side)
      if (state.halfedges[side].is_valid()) {
        const double l = state.ours.length(state.ours.connectivity().edge(state.halfedges[side]));
        result = (std::max)(result, std::abs(theirs_.lengths[side] - l) / l);
      }
    return result;
  }

  // More attempts would only count the wrong faces more precisely.
  static constexpr int most_contradictions = 32;

  const Triangles& theirs_;
  State state_;
  int contradictions_ = 0;
};

} // namespace systems

#endif // IDT_BENCHMARK_SYSTEMS_MATCH_TRIANGLES_H

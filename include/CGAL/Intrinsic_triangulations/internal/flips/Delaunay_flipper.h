// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The engine of flip_to_Delaunay().

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Cotangent_bounds.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A list whose entries are written before it is known whether they stay, which avoids a branch that cannot be
// predicted.
class Edge_list
{
public:
  // makes room for n more entries, and one to be overwritten
  void make_room(std::size_t n)
  {
    if (edges_.size() <= size_ + n)
      edges_.resize(2 * size_ + n + 1);
  }
  void push_if(bool condition, Edge_index e)
  {
    edges_[size_] = e;
    size_ += condition;
  }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  const Edge_index* begin() const { return edges_.data(); }
  const Edge_index* end() const { return edges_.data() + size_; }

private:
  std::vector<Edge_index> edges_;
  std::size_t size_ = 0;
};

// Not a character type, whose stores could alias anything.
enum class Edge_mark : std::uint8_t {
  SETTLED,     // Delaunay, or not to be flipped
  CANDIDATE,   // to be tested: in a list, or in a block still to come
  NOT_DELAUNAY // tested, and its hinge has not changed since
};
using Edge_marks = Large_vector<Edge_mark>;

// The edges are settled group by group, and a group in rounds: all candidates are tested, those that are not Delaunay
// are flipped, and the edges around them are the next candidates, as are edges that a flip of the same round has
// changed. Most tests of a round are independent of each other, and so are most flips, so the processor works on
// several at once; with a stack, each would wait for the one before. A group is small enough for its data to stay in
// the cache until it is settled.
//
// Edges that cannot be settled within a Triangulation_block are listed as postponed or uncertain.
template <class Triangulation, class ConstraintMap, class Visitor>
class Delaunay_flipper
{
  using Flip_outcome = typename Triangulation::Flip_outcome;
  static constexpr bool is_whole = Triangulation::is_whole;
  // Whether several edges can be tested at once.
  static constexpr bool tests_together =
    Has_cotangent_bounds<typename Triangulation::Traits>::value && Visitor::Is_silent::value &&
    std::is_same<ConstraintMap, Static_boolean_property_map<Edge_index, false>>::value;

  static constexpr Edge_index::size_type group_size = 1024;

public:
  // `marks` has an entry for each edge of the triangulation: `CANDIDATE` for edges that may be flipped, `SETTLED` for
  // all others.
  Delaunay_flipper(Triangulation& triangulation, const ConstraintMap& is_constrained, Visitor& visitor,
                   std::uint64_t budget, Edge_marks& marks)
    : triangulation_(triangulation), is_constrained_(is_constrained), visitor_(visitor), budget_(budget),
      marks_(marks.data())
  {}

  const Flip_report& report() const { return report_; }

  // Asks the visitor once more during a test.
  bool goes_further() { return visitor_.go_further(report_.tests, report_.flips); }
  // \exception Cancelled_error if it says no
  void ask() { ask(report_.tests); }

  // Edges left to others, some of them more than once, ...
  std::vector<Edge_index>& postponed() { return postponed_; }
  // ... and edges whose test was left to others: they need not be looked at again before everything that can be flipped
  // has been.
  std::vector<Edge_index>& uncertain() { return uncertain_; }

  // Takes over the results of others.
  void add(const Flip_report& report)
  {
    report_.tests += report.tests;
    report_.flips += report.flips;
    add(report_.not_flippable, report.not_flippable);
    add(report_.inconsistent, report.inconsistent);
    add(report_.undecided, report.undecided);
  }

  // Settles the candidates among these edges and everything that depends on them. Returns whether the budget sufficed;
  // if not, the status says so.
  // \exception Cancelled_error if the visitor says so, or the interruption of the triangulation within a test
  bool settle(const Edge_index* begin, const Edge_index* end) { return settle_groups(begin, end); }
  bool settle(Edge_index::size_type first, Edge_index::size_type last)
  {
    using Iterator = Delta_complex::Edge_iterator;
    return settle_groups(Iterator(first), Iterator(last));
  }

  // Ends the run of a whole triangulation, once it is settled or the budget is spent.
  Flip_report finish(bool is_settled)
  {
    const auto is_not_Delaunay = [&](Edge_index e) { return !possibly(triangulation_.is_locally_Delaunay(e)); };
    collect(report_.not_flippable, is_not_Delaunay);
    collect(report_.inconsistent, is_not_Delaunay);
    collect(report_.undecided, [&](Edge_index e) {
      const auto answer = triangulation_.is_locally_Delaunay(e);
      return !is_certain(answer) || !certainly(answer);
    });
    if (is_settled && !report_.undecided.empty())
      report_.status = Flip_status::UNDECIDED;
    else if (is_settled && !report_.not_flippable.empty())
      report_.status = Flip_status::NOT_FLIPPABLE;
    else if (is_settled && !report_.inconsistent.empty())
      report_.status = Flip_status::INCONSISTENT;
    return std::move(report_);
  }

private:
  template <class Iterator>
  bool settle_groups(Iterator begin, Iterator end)
  {
    while (begin != end) {
      const Iterator middle = begin + (std::min)(end - begin, std::ptrdiff_t(group_size));
      test(begin, middle);
      while (not_Delaunay_.size() != 0) {
        candidates_.clear();
        if (!flip_found())
          return false;
        test(candidates_.begin(), candidates_.end());
      }
      begin = middle;
    }
    return true;
  }

  // Finds the edges that are not Delaunay.
  template <class Iterator>
  void test(Iterator begin, Iterator end)
  {
    suspects_.clear();
    suspects_.make_room(std::size_t(end - begin));
    if constexpr (tests_together && std::is_same<Iterator, Delta_complex::Edge_iterator>::value)
      find_consecutive_suspects(begin, end);
    else
      find_suspects(begin, end);
    test_suspects();
  }

  // Skips edges that are known to be Delaunay: on an ordinary surface, most of them.
  template <class Iterator>
  void find_suspects(Iterator begin, Iterator end)
  {
    std::uint64_t number_of_known = 0;
    for (; begin != end; ++begin) {
      const Edge_index e = *begin;
      marks_[e.idx()] = Edge_mark::SETTLED;
      if (get(is_constrained_, e))
        continue;
      const bool is_known = triangulation_.is_known_Delaunay(e);
      if (is_known)
        ask(report_.tests + number_of_known);
      number_of_known += is_known;
      suspects_.push_if(!is_known, e);
    }
    report_.tests += number_of_known;
    triangulation_.count_as_tested(number_of_known);
  }

  // The same for consecutive edges, four at once.
  void find_consecutive_suspects(Delta_complex::Edge_iterator begin, Delta_complex::Edge_iterator end)
  {
    const std::size_t first = (*begin).idx(), n = std::size_t(end - begin);
    std::fill(marks_ + first, marks_ + first + n, Edge_mark::SETTLED);
    for (; end - begin >= 4; begin += 4) {
      const unsigned known = triangulation_.are_known_Delaunay(*begin);
      if (known == 15) // the usual case where few edges need a flip
        continue;
      for (int i = 0; i < 4; ++i)
        suspects_.push_if((known >> i & 1) == 0, begin[i]);
    }
    for (; begin != end; ++begin)
      suspects_.push_if(!triangulation_.is_known_Delaunay(*begin), *begin);
    const std::size_t number_of_known = n - suspects_.size();
    report_.tests += number_of_known;
    triangulation_.count_as_tested(number_of_known);
  }

  void test_suspects()
  {
    not_Delaunay_.clear();
    not_Delaunay_.make_room(suspects_.size());
    for (Edge_index e : suspects_) {
      if (triangulation_.connectivity().is_border(e))
        continue;
      ask();
      if (triangulation_.connectivity().is_self_glued(e)) { // Delaunay, since both angles belong to one face
        ++report_.tests;
        triangulation_.count_as_tested(1);
        continue;
      }
      if (!contains_hinge(e)) {
        postponed_.push_back(e);
        continue;
      }
      const auto is_Delaunay = triangulation_.test_and_recompute(e);
      if (!is_whole && !is_certain(is_Delaunay)) {
        uncertain_.push_back(e);
        continue;
      }
      ++report_.tests;
      const bool is_found = !possibly(is_Delaunay);
      marks_[e.idx()] = is_found ? Edge_mark::NOT_DELAUNAY : Edge_mark::SETTLED;
      not_Delaunay_.push_if(is_found, e);
      if (is_found) // data that the flip changes is fetched while other edges are tested
        triangulation_.connectivity().prefetch(triangulation_.connectivity().hinge(e));
      if (!is_certain(is_Delaunay))
        report_.undecided.push_back(e);
    }
  }

  // Returns whether the budget sufficed.
  bool flip_found()
  {
    candidates_.make_room(4 * not_Delaunay_.size());
    for (Edge_index e : not_Delaunay_) {
      if (marks_[e.idx()] != Edge_mark::NOT_DELAUNAY) { // its hinge has changed
        candidates_.push_if(true, e);
        continue;
      }
      ask();
      if (report_.flips == budget_) {
        report_.status = Flip_status::BUDGET_EXHAUSTED;
        return false;
      }
      marks_[e.idx()] = Edge_mark::SETTLED;
      const Hinge_halfedges around = triangulation_.connectivity().hinge(e);
      const std::optional<Flip_outcome> outcome = triangulation_.flip_not_Delaunay(around);
      if (!outcome) {
        postponed_.push_back(e);
        continue;
      }
      switch (*outcome) {
      case Flip_outcome::FLIPPED:
        ++report_.flips;
        if constexpr (!Triangulation::Traits::Has_exact_decisions::value)
          check_flipped(e);
        add_surrounding_edges(around);
        visitor_.after_flip(e);
        break;
      case Flip_outcome::NOT_CONVEX:
        report_.not_flippable.push_back(e);
        break;
      case Flip_outcome::UNDECIDED:
        report_.undecided.push_back(e);
      }
    }
    return true;
  }

  bool contains_hinge(Edge_index e) const
  {
    if constexpr (is_whole)
      return true;
    else
      return triangulation_.contains_hinge(e);
  }

  void check_flipped(Edge_index e)
  {
    if (triangulation_.is_known_Delaunay(e))
      return;
    const auto is_mended = triangulation_.is_locally_Delaunay(e);
    if (!certainly(is_mended))
      (possibly(is_mended) ? report_.undecided : report_.inconsistent).push_back(e);
  }

  void ask(std::uint64_t number_of_tests)
  {
    if (!visitor_.go_further(number_of_tests, report_.flips))
      throw Cancelled_error("the flips were cancelled");
  }

  void add_surrounding_edges(const Hinge_halfedges& around)
  {
    for (Halfedge_index h : {around.ki, around.il, around.lj, around.jk})
      add_candidate(triangulation_.connectivity().edge(h));
  }

  // An edge that is marked is a candidate already, or will be when flip_found() comes to it.
  void add_candidate(Edge_index e)
  {
    Edge_mark& mark = marks_[e.idx()];
    candidates_.push_if(mark == Edge_mark::SETTLED, e);
    mark = Edge_mark::CANDIDATE;
  }

  // Edges noted on the way may have changed since: keep those, once each, for which the finding still holds.
  template <class Predicate>
  static void collect(std::vector<Edge_index>& edges, const Predicate& still_holds)
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges.erase(std::remove_if(edges.begin(), edges.end(), [&](Edge_index e) { return !still_holds(e); }), edges.end());
  }

  static void add(std::vector<Edge_index>& edges, const std::vector<Edge_index>& more)
  {
    edges.insert(edges.end(), more.begin(), more.end());
  }

  Triangulation& triangulation_;
  const ConstraintMap& is_constrained_;
  Visitor& visitor_;
  std::uint64_t budget_;
  Flip_report report_;
  Edge_list candidates_, suspects_, not_Delaunay_;
  Edge_mark* marks_;
  std::vector<Edge_index> postponed_, uncertain_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DELAUNAY_FLIPPER_H

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The engine of flip_to_Delaunay().

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <CGAL/Uncertain.h>

#include <boost/core/ref.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief how a run of `flip_to_Delaunay()` ended.
enum class Flip_status {
  DELAUNAY,         ///< every edge that is not constrained is Delaunay
  NOT_FLIPPABLE,    ///< some edge is not Delaunay, but its hinge has no other diagonal
  INCONSISTENT,     ///< some edge is not Delaunay though it was just flipped: rounded decisions
                    ///< contradict each other near a tie
  UNDECIDED,        ///< the number type could not decide on some edge
  BUDGET_EXHAUSTED, ///< the given number of flips did not suffice
  CANCELLED         ///< the visitor cancelled
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief what a run of `flip_to_Delaunay()` did.
struct Flip_report
{
  Flip_status status = Flip_status::DELAUNAY; ///< how the run ended
  std::uint64_t flips = 0;                    ///< number of flips
  std::uint64_t tests = 0;                    ///< number of Delaunay tests
  std::vector<Edge_index> not_flippable;      ///< not Delaunay, but without another diagonal
  std::vector<Edge_index> inconsistent;       ///< not Delaunay although the flip should have made them so
  std::vector<Edge_index> undecided;          ///< the number type could not decide on them
};

namespace internal {

// A list whose entries are written before it is known whether they stay: without a branch
// that nothing could predict.
class Edge_list
{
public:
  // makes room for n entries more, and one to be overwritten
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

// The edges are settled block by block, and a block in rounds: all candidates are tested, those
// that are not Delaunay are flipped, and what lies around them are the next candidates, as is
// what a flip of the same round has changed. Most tests of a round do not depend on each other,
// and neither do most flips, so that the processor works on several at once; with a stack,
// each would wait for the one before. A block is small enough for its data to stay in the
// cache until it is settled.
template <class Triangulation, class ConstraintMap, class Visitor>
class Delaunay_flipper
{
  using Flip_outcome = typename Triangulation::Flip_outcome;

  // Not a character type: stores of these may alias everything.
  enum class Mark : std::uint8_t {
    SETTLED,     // Delaunay, or not to be flipped
    CANDIDATE,   // to be tested: in a list, or in a block still to come
    NOT_DELAUNAY // tested, and its hinge has not changed since
  };

  static constexpr Edge_index::size_type block_size = 1024;

public:
  Delaunay_flipper(Triangulation& triangulation, const ConstraintMap& is_constrained,
                   Visitor& visitor, std::uint64_t budget)
    : triangulation_(triangulation), is_constrained_(is_constrained), visitor_(visitor),
      budget_(budget), marks_(triangulation.connectivity().number_of_edges(), default_init)
  {
    std::memset(marks_.data(), int(Mark::CANDIDATE), marks_.size());
  }

  Flip_report run()
  {
    const bool is_done = settle_all();
    const auto is_not_Delaunay = [&](Edge_index e) {
      return !possibly(triangulation_.is_locally_Delaunay(e));
    };
    collect(report_.not_flippable, is_not_Delaunay);
    collect(report_.inconsistent, is_not_Delaunay);
    collect(report_.undecided, [&](Edge_index e) {
      const auto answer = triangulation_.is_locally_Delaunay(e);
      return !is_certain(answer) || !certainly(answer);
    });
    if (is_done && !report_.undecided.empty())
      report_.status = Flip_status::UNDECIDED;
    else if (is_done && !report_.not_flippable.empty())
      report_.status = Flip_status::NOT_FLIPPABLE;
    else if (is_done && !report_.inconsistent.empty())
      report_.status = Flip_status::INCONSISTENT;
    return std::move(report_);
  }

private:
  bool settle_all()
  {
    using Iterator = Delta_complex::Edge_iterator;
    const Edge_index::size_type n = triangulation_.connectivity().number_of_edges();
    for (Edge_index::size_type first = 0; first < n; first += (std::min)(block_size, n - first)) {
      const Edge_index::size_type last = first + (std::min)(block_size, n - first);
      bool goes_on = test(Iterator(first), Iterator(last));
      while (goes_on && not_Delaunay_.size() != 0) {
        candidates_.clear();
        goes_on = flip_found() && test(candidates_.begin(), candidates_.end());
      }
      if (!goes_on)
        return false;
    }
    return true;
  }

  // Finds the edges that are not Delaunay.
  template <class Iterator>
  bool test(Iterator begin, Iterator end)
  {
    return find_suspects(begin, end) && test_suspects();
  }

  // Leaves out those that are known to be Delaunay: on an ordinary surface, most.
  template <class Iterator>
  bool find_suspects(Iterator begin, Iterator end)
  {
    suspects_.clear();
    suspects_.make_room(std::size_t(end - begin));
    std::uint64_t number_of_known = 0;
    bool goes_on = true;
    for (; begin != end; ++begin) {
      const Edge_index e = *begin;
      marks_[e.idx()] = Mark::SETTLED;
      if (get(is_constrained_, e))
        continue;
      const bool is_known = triangulation_.is_known_Delaunay(e);
      if (is_known && !goes_further(report_.tests + number_of_known)) {
        goes_on = false;
        break;
      }
      number_of_known += is_known;
      suspects_.push_if(!is_known, e);
    }
    report_.tests += number_of_known;
    triangulation_.count_as_tested(number_of_known);
    return goes_on;
  }

  bool test_suspects()
  {
    not_Delaunay_.clear();
    not_Delaunay_.make_room(suspects_.size());
    for (Edge_index e : suspects_) {
      if (triangulation_.connectivity().is_border(e))
        continue;
      if (!goes_further(report_.tests))
        return false;
      ++report_.tests;
      if (triangulation_.connectivity().is_self_glued(e)) { // Delaunay, as the angles of one face
        triangulation_.count_as_tested(1);
        continue;
      }
      const auto is_Delaunay = triangulation_.test_and_refine(e);
      const bool is_found = !possibly(is_Delaunay);
      marks_[e.idx()] = is_found ? Mark::NOT_DELAUNAY : Mark::SETTLED;
      not_Delaunay_.push_if(is_found, e);
      if (!is_certain(is_Delaunay))
        report_.undecided.push_back(e);
    }
    return true;
  }

  bool flip_found()
  {
    candidates_.make_room(4 * not_Delaunay_.size());
    for (Edge_index e : not_Delaunay_) {
      if (marks_[e.idx()] != Mark::NOT_DELAUNAY) { // its hinge has changed
        candidates_.push_if(true, e);
        continue;
      }
      if (!goes_further(report_.tests))
        return false;
      marks_[e.idx()] = Mark::SETTLED;
      if (report_.flips == budget_) {
        report_.status = Flip_status::BUDGET_EXHAUSTED;
        return false;
      }
      switch (triangulation_.flip_not_Delaunay(e)) {
      case Flip_outcome::FLIPPED:
        ++report_.flips;
        if constexpr (!Triangulation::Traits::Has_exact_decisions::value)
          check_flipped(e);
        add_surrounding_edges(e);
        unwrapped_visitor().after_flip(e);
        break;
      case Flip_outcome::NOT_CONVEX:
        report_.not_flippable.push_back(e);
        break;
      case Flip_outcome::UNDECIDED:
        report_.undecided.push_back(e);
        break;
      }
    }
    return true;
  }

  void check_flipped(Edge_index e)
  {
    if (triangulation_.is_known_Delaunay(e))
      return;
    const auto is_mended = triangulation_.is_locally_Delaunay(e);
    if (!certainly(is_mended))
      (possibly(is_mended) ? report_.undecided : report_.inconsistent).push_back(e);
  }

  bool goes_further(std::uint64_t number_of_tests)
  {
    if (unwrapped_visitor().go_further(number_of_tests, report_.flips))
      return true;
    report_.status = Flip_status::CANCELLED;
    return false;
  }

  void add_surrounding_edges(Edge_index e)
  {
    const Delta_complex& complex = triangulation_.connectivity();
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    add_candidate(complex.edge(complex.next(h)));
    add_candidate(complex.edge(complex.prev(h)));
    add_candidate(complex.edge(complex.next(g)));
    add_candidate(complex.edge(complex.prev(g)));
  }

  // An edge that is marked is a candidate already, or will be when flip_found() comes to it.
  void add_candidate(Edge_index e)
  {
    Mark& mark = marks_[e.idx()];
    candidates_.push_if(mark == Mark::SETTLED, e);
    mark = Mark::CANDIDATE;
  }

  // An edge that was noted on the way may have changed since: keep those, once each, for
  // which the finding still holds.
  template <class Predicate>
  static void collect(std::vector<Edge_index>& edges, const Predicate& still_holds)
  {
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    edges.erase(std::remove_if(edges.begin(), edges.end(),
                               [&](Edge_index e) { return !still_holds(e); }),
                edges.end());
  }

  auto& unwrapped_visitor() { return unwrap(visitor_); }
  template <class T>
  static T& unwrap(T& visitor)
  {
    return visitor;
  }
  template <class T>
  static T& unwrap(std::reference_wrapper<T>& visitor)
  {
    return visitor.get();
  }
  template <class T>
  static T& unwrap(boost::reference_wrapper<T>& visitor)
  {
    return visitor.get();
  }

  Triangulation& triangulation_;
  const ConstraintMap& is_constrained_;
  Visitor& visitor_;
  std::uint64_t budget_;
  Flip_report report_;
  Edge_list candidates_, suspects_, not_Delaunay_;
  Large_vector<Mark> marks_;
};

template <class Triangulation, class ConstraintMap, class Visitor>
Delaunay_flipper<Triangulation, ConstraintMap, Visitor>
make_Delaunay_flipper(Triangulation& triangulation, const ConstraintMap& is_constrained,
                      Visitor& visitor, std::uint64_t budget)
{
  return {triangulation, is_constrained, visitor, budget};
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELAUNAY_FLIPPER_H

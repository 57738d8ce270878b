// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The engine of flip_to_Delaunay().

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>

#include <CGAL/Uncertain.h>

#include <boost/config.hpp>
#include <boost/core/ref.hpp>

#include <cstdint>
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

template <class Triangulation, class ConstraintMap, class Visitor>
class Delaunay_flipper
{
  using Flip_outcome = typename Triangulation::Flip_outcome;

public:
  Delaunay_flipper(Triangulation& triangulation, const ConstraintMap& is_constrained,
                   Visitor& visitor, std::uint64_t budget)
    : triangulation_(triangulation), is_constrained_(is_constrained), visitor_(visitor),
      budget_(budget), is_pending_(triangulation.connectivity().number_of_edges(), 1)
  {}

  Flip_report run()
  {
    const bool is_done = visit_all();
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
  // A mark is set while the edge is on the stack or still to be visited in order.
  bool visit_all()
  {
    for (Edge_index e : triangulation_.connectivity().edges()) {
      if (!visit(e))
        return false;
      while (!stack_.empty()) {
        const Edge_index top = stack_.back();
        stack_.pop_back();
        if (!visit(top))
          return false;
      }
    }
    return true;
  }

  // Most edges are Delaunay: this much is inlined in the loop, and no more.
  bool visit(Edge_index e)
  {
    is_pending_[e.idx()] = 0;
    if (get(is_constrained_, e) || !triangulation_.connectivity().is_flippable(e))
      return true;
    if (!unwrapped_visitor().go_further(report_.tests, report_.flips)) {
      report_.status = Flip_status::CANCELLED;
      return false;
    }
    ++report_.tests;
    const auto is_Delaunay = triangulation_.test_and_refine(e);
    return certainly(is_Delaunay) || flip_or_note(e, possibly(is_Delaunay));
  }

  BOOST_NOINLINE bool flip_or_note(Edge_index e, bool is_possibly_Delaunay)
  {
    if (is_possibly_Delaunay) {
      report_.undecided.push_back(e);
      return true;
    }
    if (report_.flips == budget_) {
      report_.status = Flip_status::BUDGET_EXHAUSTED;
      return false;
    }
    switch (triangulation_.flip(e)) {
    case Flip_outcome::FLIPPED:
      ++report_.flips;
      if constexpr (!Triangulation::Traits::Has_exact_decisions::value) {
        const auto is_mended = triangulation_.is_locally_Delaunay(e);
        if (!certainly(is_mended))
          (possibly(is_mended) ? report_.undecided : report_.inconsistent).push_back(e);
      }
      push_surrounding_edges(e);
      unwrapped_visitor().after_flip(e);
      break;
    case Flip_outcome::NOT_CONVEX:
      report_.not_flippable.push_back(e);
      break;
    case Flip_outcome::UNDECIDED:
      report_.undecided.push_back(e);
      break;
    }
    return true;
  }

  void push_surrounding_edges(Edge_index e)
  {
    const Delta_complex& complex = triangulation_.connectivity();
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    push(complex.edge(complex.next(h)));
    push(complex.edge(complex.prev(h)));
    push(complex.edge(complex.next(g)));
    push(complex.edge(complex.prev(g)));
  }

  void push(Edge_index e)
  {
    if (is_pending_[e.idx()])
      return;
    is_pending_[e.idx()] = 1;
    stack_.push_back(e);
  }

  // An edge that was noted on the way may have changed since: keep those, once each, for
  // which the finding still holds.
  template <class Predicate>
  void collect(std::vector<Edge_index>& edges, const Predicate& still_holds)
  {
    std::vector<Edge_index> kept;
    for (Edge_index e : edges)
      is_pending_[e.idx()] = 0;
    for (Edge_index e : edges) {
      if (is_pending_[e.idx()] == 0 && still_holds(e))
        kept.push_back(e);
      is_pending_[e.idx()] = 1;
    }
    edges.swap(kept);
  }

  auto& unwrapped_visitor() { return unwrap(visitor_); }
  template <class T>
  static T& unwrap(T& visitor) { return visitor; }
  template <class T>
  static T& unwrap(std::reference_wrapper<T>& visitor) { return visitor.get(); }
  template <class T>
  static T& unwrap(boost::reference_wrapper<T>& visitor) { return visitor.get(); }

  Triangulation& triangulation_;
  const ConstraintMap& is_constrained_;
  Visitor& visitor_;
  std::uint64_t budget_;
  Flip_report report_;
  std::vector<Edge_index> stack_;
  Large_vector<std::uint8_t> is_pending_;
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

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Tests on several threads while nothing is flipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_OPEN_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_OPEN_EDGES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges that were left open when blocks were flipped: most of them are ties, near ties or edges with hinges in
// several blocks, and most of them turn out to be Delaunay. These are settled here, each by the first stage that
// decides it, as long as that takes little time; the others are left to one thread, which flips, and remembers what
// makes long decisions cheap.
//
// An answer is a function of the triangulation, which does not change meanwhile: so neither the answers nor their
// numbers depend on the threads.
template <class Traits, class ConstraintMap, class Flipper>
class Open_edges
{
public:
  // \param flipper counts the tests in its report and asks its visitor
  Open_edges(Whole_triangulation<Traits> triangulation, const ConstraintMap& is_constrained, Flipper& flipper,
             Edge_marks& marks)
    : triangulation_(triangulation), is_constrained_(is_constrained), flipper_(flipper), marks_(marks)
  {
    if constexpr (uses_exact_geometry) // which the threads would otherwise ask at the same time
      interruption_.exchange(triangulation_.set_interruption({}));
  }
  Open_edges(const Open_edges&) = delete;
  Open_edges& operator=(const Open_edges&) = delete;
  ~Open_edges()
  {
    if constexpr (uses_exact_geometry)
      triangulation_.set_interruption(interruption_.exchange({}));
  }

  // Removes the edges that are found to be Delaunay from the list, and settles them. Each edge is given once and marked
  // as a candidate.
  // \exception Cancelled_error if the visitor or the interruption says so
  void settle_Delaunay(std::vector<Edge_index>& edges)
  {
    answers_.assign(edges.size(), Answer::OPEN);
    test_by_stages(edges);
    std::size_t number_of_others = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (answers_[i] == Answer::DELAUNAY)
        marks_[edges[i].idx()] = Edge_mark::SETTLED;
      else
        edges[number_of_others++] = edges[i];
    }
    edges.resize(number_of_others);
  }

private:
  static constexpr bool uses_exact_geometry = Traits::Uses_exact_geometry::value;

  // As many as may be tested without asking the visitor.
  static constexpr std::size_t size_of_block = 1000;

  enum class Answer : std::uint8_t {
    OPEN,
    DELAUNAY,
    LEFT // not Delaunay, or not to be tested here: the one thread will find it again
  };

  void test_by_stages(const std::vector<Edge_index>& edges)
  {
    const auto by_filter = [this](Edge_index e, Stage_counts& counts) { return answer_by_filter(e, counts); };
    if (!test_open(edges, by_filter))
      return;
    if constexpr (uses_exact_geometry) {
      const Exact_engine& engine = triangulation_.engine();
      const auto test_with = [&](Exact_engine::Means means) {
        return test_open(edges,
                         [&](Edge_index e, Stage_counts& counts) { return answer(engine.test(e, means), counts); });
      };
      if (!test_with(Exact_engine::Means::PLANES))
        return;
      engine.prepare<Parallel_tag>();
      test_with(Exact_engine::Means::SHORT_STRIPS);
    }
  }

  // Asks `test` for all edges that are still open. Returns whether some remain so.
  template <class Test>
  bool test_open(const std::vector<Edge_index>& edges, const Test& test)
  {
    bool is_any_open = false;
    for_each_block<Parallel_tag>(edges.size(), size_of_block, [&](std::size_t first, std::size_t last) {
      if (is_stopped())
        return;
      Stage_counts counts;
      bool is_open = false;
      for (std::size_t i = first; i < last; ++i) {
        if (answers_[i] == Answer::OPEN)
          answers_[i] = test(edges[i], counts);
        is_open = is_open || answers_[i] == Answer::OPEN;
      }
      const std::lock_guard<std::mutex> lock(mutex_);
      is_any_open = is_any_open || is_open;
      count(counts);
      ask();
    });
    return is_any_open;
  }

  Answer answer_by_filter(Edge_index e, Stage_counts& counts) const
  {
    if (get(is_constrained_, e) || !triangulation_.connectivity().is_flippable(e))
      return Answer::LEFT;
    const auto is_Delaunay = triangulation_.is_Delaunay_by_filter(e);
    if (!is_certain(is_Delaunay))
      return Answer::OPEN;
    return answer(Exact_decision{certainly(is_Delaunay) ? POSITIVE : NEGATIVE, Stage::FILTER}, counts);
  }

  // Only tests that settle an edge are counted, because others are repeated.
  static Answer answer(const std::optional<Exact_decision>& test, Stage_counts& counts)
  {
    if (!test)
      return Answer::OPEN;
    if (test->sign == NEGATIVE)
      return Answer::LEFT;
    counts.add(test->stage, test->sign == ZERO);
    return Answer::DELAUNAY;
  }

  // Until another thread's exception has ended the loop, which may take long on a busy machine.
  bool is_stopped()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return is_stopped_;
  }

  // Once an exception was thrown, nothing is asked again.
  void ask()
  {
    if (std::exchange(is_stopped_, true))
      return;
    flipper_.ask();
    interruption_.check();
    is_stopped_ = false;
  }

  void count(Stage_counts counts)
  {
    Flip_report report;
    for (std::uint64_t number : counts.decided)
      report.tests += number;
    flipper_.add(report);
    triangulation_.count_as_tested(std::exchange(counts.decided[std::size_t(Stage::FILTER)], 0));
    if constexpr (uses_exact_geometry)
      triangulation_.engine().decisions().counts += counts;
  }

  Whole_triangulation<Traits> triangulation_;
  const ConstraintMap& is_constrained_;
  Flipper& flipper_;
  Edge_marks& marks_;
  Interruption interruption_; // the triangulation's own, asked by one thread at a time
  std::vector<Answer> answers_;
  std::mutex mutex_;
  bool is_stopped_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_OPEN_EDGES_H

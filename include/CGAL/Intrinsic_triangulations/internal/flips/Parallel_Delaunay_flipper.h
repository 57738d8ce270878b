// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Flips on several threads, each of which has a part of the triangulation to itself; and tests while nothing is
// flipped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_PARALLEL_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_PARALLEL_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Open_edges.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Delaunay_flipper.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Consecutive edges of a triangulation, and the data with which a Delaunay_flipper flips the edges whose hinges lie
// completely in the block.
//
// Several threads may use disjoint blocks at once. A flip reads and writes only data of the five edges and two faces of
// its hinge, and the halfedges of the vertices (see Delta_complex). All three edges of a face of the hinge are in the
// block, so it is not a face of a hinge of another block.
//
// Decisions that need the rest of the triangulation are postponed: the exact stages follow edges through input faces
// wherever they lie.
template <class Traits_>
class Triangulation_block
{
public:
  using Triangulation = Intrinsic_triangulation<Traits_>;
  using Traits = Traits_;
  using Boolean = typename Triangulation::Boolean;
  using Flip_outcome = typename Triangulation::Flip_outcome;
  static constexpr bool is_whole = false;

  // Whether blocks are possible: the number type must not share state between threads.
  static constexpr bool are_possible = is_for_threads<typename Triangulation::Edge_data>;
  using Logs = Exact_engine::Logs; // one for each block

  // \param most the maximum number of blocks
  static Logs logs(Triangulation& triangulation, std::size_t most)
  {
    return {Engine_access::measured(triangulation).engine(), most};
  }

  Triangulation_block(Triangulation& triangulation, Edge_index::size_type first, Edge_index::size_type last,
                      Logs::Log& log)
    : triangulation_(triangulation), measured_(Engine_access::measured(triangulation)), first_(first),
      size_(last - first), log_(log)
  {}

  const Delta_complex& connectivity() const { return triangulation_.connectivity(); }

  bool contains_hinge(Edge_index e) const
  {
    const Delta_complex& complex = connectivity();
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    return contains(complex.next(h)) && contains(complex.prev(h)) && contains(complex.next(g)) &&
           contains(complex.prev(g));
  }

  bool is_known_Delaunay(Edge_index e) const { return whole().is_known_Delaunay(e); }
  unsigned are_known_Delaunay(Edge_index e) const { return whole().are_known_Delaunay(e); }

  // By stored numbers alone.
  Boolean is_locally_Delaunay(Edge_index e) const
  {
    return measured_.traits().is_locally_Delaunay_object()(measured_.hinge(connectivity().hinge(e)));
  }
  Boolean test_and_recompute(Edge_index e) const { return is_locally_Delaunay(e); }
  void count_as_tested(std::uint64_t) const {} // all at once, after the blocks

  // \return nothing if the flip is postponed
  std::optional<Flip_outcome> flip_not_Delaunay(const Hinge_halfedges& around)
  {
    const typename Triangulation::Hinge_data old = measured_.hinge(around);
    if (!measured_.is_new_edge_known_to_have_length(old))
      return std::nullopt;
    return measured_.flip_hinge(around, old, measured_.traits().construct_flipped_hinge_object(),
                                [&] { log_.flip(around); });
  }

private:
  Whole_triangulation<Traits> whole() const { return Whole_triangulation<Traits>(triangulation_); }

  bool contains(Halfedge_index h) const
  {
    return connectivity().edge(h).idx() - first_ < size_; // the difference is unsigned
  }

  Triangulation& triangulation_;
  Measured_triangulation<Traits_>& measured_;
  Edge_index::size_type first_, size_;
  Logs::Log& log_;
};

// Asks one visitor on behalf of all blocks, for one block at a time and not before each test.
template <class Visitor>
class Shared_visitor
{
  static constexpr bool is_trivial = Visitor::Is_silent::value;

public:
  explicit Shared_visitor(Visitor& visitor) : visitor_(visitor) {}

  // The visitor as one block sees it.
  class Of_block
  {
  public:
    using Is_silent = Boolean_tag<is_trivial>;
    explicit Of_block(Shared_visitor& shared) : shared_(shared) {}

    bool go_further(std::uint64_t tests, std::uint64_t flips)
    {
      if constexpr (is_trivial)
        return true;
      if (--patience_ > 0)
        return true;
      patience_ = tests_between_questions;
      const std::uint64_t more_tests = tests - tests_, more_flips = flips - flips_;
      tests_ = tests;
      flips_ = flips;
      return shared_.go_further(more_tests, more_flips);
    }
    void after_flip(Edge_index e)
    {
      if constexpr (!is_trivial)
        shared_.after_flip(e);
    }

  private:
    static constexpr int tests_between_questions = 1024;

    Shared_visitor& shared_;
    int patience_ = 1;
    std::uint64_t tests_ = 0, flips_ = 0; // that the visitor was told of
  };

  bool is_stopped() const { return is_stopped_.load(std::memory_order_relaxed); }
  void stop() { is_stopped_.store(true, std::memory_order_relaxed); }

private:
  bool go_further(std::uint64_t more_tests, std::uint64_t more_flips)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    tests_ += more_tests;
    flips_ += more_flips;
    if (!is_stopped() && !visitor_.go_further(tests_, flips_))
      stop();
    return !is_stopped();
  }
  void after_flip(Edge_index e)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    visitor_.after_flip(e);
  }

  Visitor& visitor_;
  std::mutex mutex_;
  std::uint64_t tests_ = 0, flips_ = 0;
  std::atomic<bool> is_stopped_{false};
};

// On several threads, settles what can be settled within blocks of consecutive edges, then within blocks that are
// shifted by half of their size. The Delaunay edges among the others are found on several threads, too, and the few
// that remain are flipped on one. Neither the blocks nor the result depend on the number of threads.
template <class Traits, class ConstraintMap, class Visitor>
class Parallel_Delaunay_flipper
{
  using Triangulation = Intrinsic_triangulation<Traits>;
  using Block = Triangulation_block<Traits>;
  using Block_visitor = typename Shared_visitor<Visitor>::Of_block;
  using Flipper = Delaunay_flipper<Whole_triangulation<Traits>, ConstraintMap, Visitor>;

  // Smaller blocks contain fewer complete hinges; larger ones are too few for many threads.
  static constexpr int exponent = 16;
  static constexpr std::size_t size = std::size_t(1) << exponent;

public:
  // The marks are all `CANDIDATE`.
  Parallel_Delaunay_flipper(Triangulation& triangulation, const ConstraintMap& is_constrained, Visitor& visitor,
                            std::uint64_t budget, Edge_marks& marks)
    : triangulation_(triangulation), is_constrained_(is_constrained), visitor_(visitor), budget_(budget), marks_(marks)
  {}

  // Otherwise a Delaunay_flipper does the same.
  static bool is_useful(const Triangulation& triangulation)
  {
    return triangulation.connectivity().number_of_edges() > size && Block::are_possible;
  }

  // Makes the triangulation Delaunay; `flipper` makes the last flips and keeps the report. Returns whether the budget
  // sufficed.
  bool settle_all(Flipper& flipper)
  {
    const std::size_t n = marks_.size(), number_of_blocks = (n + size - 1) / size;
    // No block may use up the budget of all, nor fill the memory with its log.
    budget_of_block_ = (std::min)(budget_ / (2 * number_of_blocks + 1), 16 * std::uint64_t(size));

    settle_blocks(n, number_of_blocks, flipper);
    postponed_.insert(postponed_.end(), uncertain_.begin(), uncertain_.end());
    mark_postponed();
    settle_Delaunay(flipper);
    return flipper.settle(postponed_.data(), postponed_.data() + postponed_.size());
  }

private:
  struct Task
  {
    Edge_index::size_type first, last; // the edges of the block
    std::vector<Edge_index> candidates;
    Flip_report report;
    Exact_engine::Logs::Log* log;
    std::vector<Edge_index> postponed, uncertain;
    std::exception_ptr exception;
  };

  // Runs both rounds. Whatever happens, the flips made so far are noted.
  // \exception Cancelled_error if the visitor says so
  void settle_blocks(std::size_t n, std::size_t number_of_blocks, Flipper& flipper)
  {
    Exact_engine::Logs logs = Block::logs(triangulation_, 2 * number_of_blocks + 1);
    std::exception_ptr exception;
    for (std::size_t shift : {std::size_t(0), size / 2}) {
      is_first_round_ = shift == 0;
      std::vector<Task> tasks = make_tasks(n, shift, logs);
      for_each_block<Parallel_tag>(tasks.size(), 1, [&](std::size_t i, std::size_t) { settle(tasks[i]); });
      postponed_.clear();
      for (Task& task : tasks) {
        exception = exception ? exception : task.exception;
        flipper.add(task.report);
        Whole_triangulation<Traits>(triangulation_).count_as_tested(task.report.tests);
        postponed_.insert(postponed_.end(), task.postponed.begin(), task.postponed.end());
        uncertain_.insert(uncertain_.end(), task.uncertain.begin(), task.uncertain.end());
      }
      mark_postponed();
      if (visitor_.is_stopped())
        break;
    }
    if (exception)
      std::rethrow_exception(exception);
    if (visitor_.is_stopped())
      throw Cancelled_error("the flips were cancelled");
  }

  std::vector<Task> make_tasks(std::size_t n, std::size_t shift, Exact_engine::Logs& logs) const
  {
    std::vector<Task> tasks((n + shift + size - 1) / size);
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      tasks[i].log = &logs.next();
      tasks[i].first = Edge_index::size_type((std::max)(i * size, shift) - shift);
      tasks[i].last = Edge_index::size_type((std::min)((i + 1) * size - shift, n));
    }
    for (Edge_index e : postponed_)
      tasks[(e.idx() + shift) / size].candidates.push_back(e);
    return tasks;
  }

  void settle(Task& task)
  {
    if (visitor_.is_stopped())
      return;
    try {
      Block block(triangulation_, task.first, task.last, *task.log);
      Block_visitor visitor(visitor_);
      Delaunay_flipper<Block, ConstraintMap, Block_visitor> flipper(block, is_constrained_, visitor, budget_of_block_,
                                                                    marks_);
      const bool is_settled =
        is_first_round_ ? flipper.settle(task.first, task.last)
                        : flipper.settle(task.candidates.data(), task.candidates.data() + task.candidates.size());
      task.report = flipper.report();
      task.postponed = std::move(flipper.postponed());
      task.uncertain = std::move(flipper.uncertain());
      if (!is_settled) // the budget did not suffice
        for (Edge_index::size_type e = task.first; e < task.last; ++e)
          if (marks_[e] != Edge_mark::SETTLED)
            task.postponed.push_back(Edge_index(e));
    } catch (const Cancelled_error&) {
      visitor_.stop();
    } catch (...) {
      task.exception = std::current_exception();
      visitor_.stop();
    }
  }

  void settle_Delaunay(Flipper& flipper)
  {
    Open_edges<Traits, ConstraintMap, Flipper>(Whole_triangulation<Traits>(triangulation_), is_constrained_, flipper,
                                               marks_)
      .settle_Delaunay(postponed_);
  }

  // Marks them as candidates, and keeps each of them once.
  void mark_postponed()
  {
    for (Edge_index e : postponed_)
      marks_[e.idx()] = Edge_mark::SETTLED;
    const auto is_marked = [&](Edge_index e) {
      return std::exchange(marks_[e.idx()], Edge_mark::CANDIDATE) == Edge_mark::CANDIDATE;
    };
    postponed_.erase(std::remove_if(postponed_.begin(), postponed_.end(), is_marked), postponed_.end());
  }

  Triangulation& triangulation_;
  const ConstraintMap& is_constrained_;
  Shared_visitor<Visitor> visitor_;
  std::uint64_t budget_, budget_of_block_ = 0;
  Edge_marks& marks_;
  bool is_first_round_ = true; // all edges at first, later the postponed ones
  std::vector<Edge_index> postponed_, uncertain_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_PARALLEL_DELAUNAY_FLIPPER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often a number type decides otherwise than exact arithmetic would.

#ifndef IDT_KERNELS_DECISION_COUNTER_H
#define IDT_KERNELS_DECISION_COUNTER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstdint>

namespace idt {

// Checks each test of the flip algorithm against the exact geometry of the same edge. The decision remains that of the
// triangulation. A test that is left undecided is not wrong.
template <class Traits>
class Decision_counter : public CGAL::Intrinsic_triangulations::internal::Whole_triangulation<Traits>
{
  using Base = CGAL::Intrinsic_triangulations::internal::Whole_triangulation<Traits>;
  using Edge_index = CGAL::Intrinsic_triangulations::Edge_index;

public:
  using typename Base::Boolean;

  // \param wrong_decisions is raised with each wrong decision
  // \pre the triangulation keeps its input
  Decision_counter(typename Base::Triangulation& triangulation, std::uint64_t& wrong_decisions)
    : Base(triangulation), wrong_decisions_(wrong_decisions)
  {}

  // Each edge is to come to the test.
  bool is_known_Delaunay(Edge_index) const { return false; }
  unsigned are_known_Delaunay(Edge_index) const { return 0; }
  void count_as_tested(std::uint64_t) {}
  Boolean test_and_recompute(Edge_index e)
  {
    const Boolean answer = Base::test_and_recompute(e);
    if (CGAL::is_certain(answer) && is_wrong(e, CGAL::certainly(answer)))
      ++wrong_decisions_;
    return answer;
  }

private:
  // What cannot be proven wrong is not counted.
  bool is_wrong(Edge_index e, bool answer) const
  {
    try {
      return answer == (CGAL::Intrinsic_triangulations::internal::engine(this->triangulation()).sign_of_cotangents(e) == CGAL::NEGATIVE);
    } catch (const CGAL::Intrinsic_triangulations::Undecided_error&) {
      return false;
    }
  }

  std::uint64_t& wrong_decisions_;
};

} // namespace idt

#endif // IDT_KERNELS_DECISION_COUNTER_H

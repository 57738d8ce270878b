// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often a number type decides otherwise than exact arithmetic would.

#ifndef IDT_KERNELS_DECISION_COUNTER_H
#define IDT_KERNELS_DECISION_COUNTER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace idt {

// A triangulation, as far as flip_to_Delaunay() needs one, that checks each test against
// the exact geometry of the same edge. The decision remains that of the triangulation. A
// test that is left undecided is not wrong.
template <class Triangulation>
class Decision_counter
{
public:
  using Traits = typename Triangulation::Traits;
  using Boolean = typename Triangulation::Boolean;
  using Flip_outcome = typename Triangulation::Flip_outcome;
  using Edge_index = CGAL::Intrinsic_triangulations::Edge_index;

  // \pre the triangulation keeps its input
  explicit Decision_counter(Triangulation& triangulation) : triangulation_(triangulation) {}

  const CGAL::Intrinsic_triangulations::Delta_complex& connectivity() const
  {
    return triangulation_.connectivity();
  }
  Boolean is_locally_Delaunay(Edge_index e) const { return triangulation_.is_locally_Delaunay(e); }
  Flip_outcome flip_not_Delaunay(const CGAL::Intrinsic_triangulations::Hinge_halfedges& around)
  {
    return triangulation_.flip_not_Delaunay(around);
  }

  std::function<bool()> set_interruption(std::function<bool()> go_further)
  {
    return triangulation_.set_interruption(std::move(go_further));
  }

  // Each edge is to come to the test.
  bool is_known_Delaunay(Edge_index) const { return false; }
  unsigned are_known_Delaunay(Edge_index) const { return 0; }
  void count_as_tested(std::uint64_t) {}
  Boolean test_and_refine(Edge_index e)
  {
    const Boolean answer = triangulation_.test_and_refine(e);
    if (CGAL::is_certain(answer) && is_wrong(e, CGAL::certainly(answer)))
      ++wrong_decisions_;
    return answer;
  }

  std::uint64_t wrong_decisions() const { return wrong_decisions_; }

private:
  // What cannot be proven wrong is not counted.
  bool is_wrong(Edge_index e, bool answer) const
  {
    try {
      return answer == (triangulation_.exact_geometry().sign_of_cotangents(
                          triangulation_.connectivity(), e) == CGAL::NEGATIVE);
    } catch (const CGAL::Intrinsic_triangulations::Undecided_error&) {
      return false;
    }
  }

  Triangulation& triangulation_;
  std::uint64_t wrong_decisions_ = 0;
};

} // namespace idt

#endif // IDT_KERNELS_DECISION_COUNTER_H

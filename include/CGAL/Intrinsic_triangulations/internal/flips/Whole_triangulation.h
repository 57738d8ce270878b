// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The view of a triangulation for the algorithms of this package.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_WHOLE_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_WHOLE_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <CGAL/Uncertain.h>

#include <cstdint>
#include <functional>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

// The parts of a triangulation that the algorithms of this package use besides its public members.
template <class Traits_>
class Whole_triangulation
{
  using Measured = Measured_triangulation<Traits_>;

public:
  using Triangulation = Intrinsic_triangulation<Traits_>;
  using Traits = Traits_;
  using Boolean = typename Triangulation::Boolean;
  using Flip_outcome = typename Triangulation::Flip_outcome;
  static constexpr bool is_whole = true;

  explicit Whole_triangulation(Triangulation& triangulation)
    : triangulation_(triangulation), measured_(Engine_access::measured(triangulation))
  {}

  Triangulation& triangulation() const { return triangulation_; }
  const Delta_complex& connectivity() const { return triangulation_.connectivity(); }

  // Whether the bounds kept for the corners prove that e is Delaunay; `false` means nothing. This holds for most edges
  // of an ordinary surface, and is much faster than a test, with which it never disagrees.
  bool is_known_Delaunay(Edge_index e) const { return Measured::keeps_bounds && measured_.bounds().imply_Delaunay(e); }
  // The same for four edges: bit i of the result belongs to the i-th edge after e. \pre these edges exist
  unsigned are_known_Delaunay(Edge_index e) const
  {
    return Measured::keeps_bounds ? measured_.bounds().imply_Delaunay_of_four(e) : 0;
  }

  Boolean is_locally_Delaunay(Edge_index e) const { return triangulation_.is_locally_Delaunay(e); }
  // By stored numbers alone. \pre e is flippable
  Boolean is_Delaunay_by_filter(Edge_index e) const
  {
    return measured_.traits().is_locally_Delaunay_object()(measured_.hinge(e));
  }

  // If the stored numbers cannot decide, they are replaced by tight ones that do.
  Boolean test_and_recompute(Edge_index e)
  {
    const Boolean answer = is_Delaunay_by_filter(e);
    if constexpr (Triangulation::uses_exact_geometry)
      if (!is_certain(answer))
        return measured_.decide_and_recompute(e);
    count_as_tested(1);
    return answer;
  }

  // It may not be prepared yet.
  Exact_engine& engine() const { return measured_.engine(); }

  std::function<bool()> set_interruption(std::function<bool()> go_further)
  {
    return engine().decisions().interruption.exchange(std::move(go_further));
  }

  // Counts, for the statistics, edges that stored numbers decided.
  void count_as_tested(std::uint64_t number) { measured_.count_filter_decisions(number); }

  Flip_outcome flip_not_Delaunay(const Hinge_halfedges& around) { return measured_.flip_not_Delaunay(around); }
  Flip_outcome flip_not_Delaunay(Edge_index e) { return measured_.flip_not_Delaunay(e); }

  // \pre the quadrilateral is strictly convex. \param construct computes the numbers, like the traits' functor
  template <class Construct>
  Flip_outcome flip_convex(const Hinge_halfedges& around, const Construct& construct)
  {
    return measured_.flip_convex(around, construct);
  }
  // The data that a flip or `recompute(f)` replaces, to be put back.
  using Replaced = typename Measured::Replaced;
  using Face_numbers = typename Measured::Face_numbers;
  Replaced replaced(const Hinge_halfedges& around) const { return measured_.replaced(around); }
  Face_numbers numbers_of_face(Halfedge_index h) const { return measured_.numbers_of_face(h); }
  void flip_back(const Hinge_halfedges& around, const Replaced& before) { measured_.flip_back(around, before); }
  void put_back(Halfedge_index h, const Face_numbers& numbers) { measured_.put_back(h, numbers); }

  Vertex_index split_face(const Triangle_piece& piece, const Surface_point& location)
  {
    return measured_.split_face(piece, location);
  }
  Vertex_index split_edge(Halfedge_index h, const Surface_point& location) { return measured_.split_edge(h, location); }
  Removed_elements unsplit_face(Vertex_index v) { return measured_.unsplit_face(v); }
  Removed_elements unsplit_edge(Halfedge_index h) { return measured_.unsplit_edge(h); }

  template <class ConcurrencyTag, class Saved>
  void restore(Saved saved)
  {
    measured_.template restore<ConcurrencyTag>(std::move(saved));
  }

  template <class Element>
  auto recompute(Element x)
  {
    return measured_.recompute(x);
  }

private:
  Triangulation& triangulation_;
  Measured& measured_;
};

// A triangulation whose edges are all tested, with a visitor that is told about the tests.
template <class Traits_, class Visitor>
class Watched_triangulation : public Whole_triangulation<Traits_>
{
  using Base = Whole_triangulation<Traits_>;

public:
  Watched_triangulation(typename Base::Triangulation& triangulation, Visitor& visitor)
    : Base(triangulation), visitor_(visitor)
  {}

  bool is_known_Delaunay(Edge_index) const { return false; }
  unsigned are_known_Delaunay(Edge_index) const { return 0; }
  void count_as_tested(std::uint64_t) {}
  typename Base::Boolean test_and_recompute(Edge_index e)
  {
    const typename Base::Boolean answer = Base::test_and_recompute(e);
    visitor_.after_test(e, answer);
    return answer;
  }

private:
  Visitor& visitor_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_WHOLE_TRIANGULATION_H

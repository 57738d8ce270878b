// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgIntrinsicTriangulationsConcepts
\cgalConcept

The concept `IntrinsicFlipVisitor` describes what `flip_to_Delaunay()` tells of its progress,
and how it is stopped. A model is `CopyConstructible`: the algorithm works on a copy, unless
the visitor is passed as `std::ref(visitor)`.

The member functions may read the triangulation, but not change it.

With `Parallel_tag` they are called from several threads, one at a time, while other threads change
the triangulation: they must not read it then. `go_further()` is called at least once for each thousand
tests of a thread.

\cgalHasModel `CGAL::Intrinsic_triangulations::Default_flip_visitor`

\sa `IntrinsicTriangulationTraits`
*/
class IntrinsicFlipVisitor
{
public:
  /// is called before each Delaunay test and before each flip, with their numbers so far.
  /// If it returns `false` the algorithm stops and reports `Flip_status::CANCELLED`; the
  /// triangulation is valid then. A further run goes on from it, but begins all tests again.
  ///
  /// During an exact test that takes long, it is called again with the same numbers, up to a hundred times a second, and
  /// can end the test. So it must not ask the triangulation for lengths, angles or areas.
  bool go_further(std::uint64_t tests, std::uint64_t flips);

  /// is called after each flip, when connectivity and metric have changed; the edge has the
  /// descriptor that it had before.
  void after_flip(CGAL::Intrinsic_triangulations::Edge_index e);

  /// is called after each test, with the answer, a `Boolean` of the traits. Optional: with it, each edge is tested by itself, and the
  /// algorithm runs on one thread.
  void after_test(CGAL::Intrinsic_triangulations::Edge_index e, Boolean is_Delaunay);
};

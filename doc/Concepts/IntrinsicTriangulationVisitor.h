// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgIntrinsicTriangulationsConcepts
\cgalConcept

The concept `IntrinsicTriangulationVisitor` describes how a long computation tells of its progress and of what it does, and how it is
stopped. Every function that may take long has a named parameter `visitor` of this kind.

Only `go_further()` is required; the other functions are called if the model has them. A function `bool(const Progress&)`, `bool(double
fraction)` or `bool()` is a model, too, and called in place of `go_further()`. A model is `CopyConstructible`: the algorithm works on a
copy, unless the visitor is passed as `std::ref(visitor)`.

If `go_further()` returns `false`, the computation throws `Cancelled_error`. The object that it worked on is valid then, what was done is
kept, and another call goes on from it or begins again. How far it was, the visitor knows from `go_further()`.

The functions may read the triangulation, but not change it. With `Parallel_tag` they are called from several threads, one at a
time, while other threads change the triangulation: they must not read it then.

\cgalHasModel `CGAL::Intrinsic_triangulations::Default_visitor`

\sa `IntrinsicTriangulationTraits`
*/
class IntrinsicTriangulationVisitor
{
public:
  /// is called now and then. `flip_to_Delaunay()` calls it before each Delaunay test and before each flip, with
  /// `Parallel_tag` at least once for each thousand tests of a thread; other algorithms say what they fill in.
  ///
  /// During an exact decision that takes long, it is called again with the same numbers, up to a hundred times a
  /// second, and can end the decision. So it must not ask the triangulation for lengths, angles or areas.
  bool go_further(const CGAL::Intrinsic_triangulations::Progress& progress);

  /// is called after each flip of `flip_to_Delaunay()` and of `Geodesic_path_network`, when connectivity and metric
  /// have changed; the edge has the descriptor that it had before.
  void after_flip(CGAL::Intrinsic_triangulations::Edge_index e);

  /// is called after each test of `flip_to_Delaunay()`, with the answer, a `Boolean` of the traits. With it, each edge
  /// is tested by itself, and the algorithm runs on one thread.
  void after_test(CGAL::Intrinsic_triangulations::Edge_index e, Boolean is_Delaunay);

  /// is called before each face that `refine_Delaunay()` refines, with what is left to do.
  void before_step(const CGAL::Intrinsic_triangulations::Refinement_progress& progress);

  /// is called after each vertex that `refine_Delaunay()` inserts, when the triangulation is Delaunay again.
  void after_insertion(CGAL::Intrinsic_triangulations::Vertex_index v);
};

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgIntrinsicTriangulationsConcepts
\cgalConcept

The concept `IntrinsicTriangulationVisitor` describes how a long computation reports its progress and steps, and how you
cancel it. Every function that may take long has a named parameter `visitor` for a model of it.

Only `go_further()` is required; other functions are called if the model has them. A function `bool(const Progress&)`,
`bool(double fraction)` or `bool()` is also a model, and is called instead of `go_further()`. A model is
`CopyConstructible`; the algorithm uses a copy unless you pass `std::ref(visitor)`.

If `go_further()` returns `false`, the computation throws `Cancelled_error`. The object in use stays valid and keeps the
work done so far; another call continues or starts again.

The functions may read the triangulation, but must not change it. With `Parallel_tag`, they are called from several
threads, one at a time, while other threads change the triangulation: then they must not read it, either.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Intrinsic_triangulations::Default_visitor}
\cgalHasModelsEnd

\sa `IntrinsicTriangulationTraits`
*/
class IntrinsicTriangulationVisitor
{
public:
  /// is called from time to time. `flip_to_Delaunay()` calls it before each Delaunay test and each flip; with
  /// `Parallel_tag`, at least once per thousand tests of a thread. Other algorithms document which numbers they set.
  ///
  /// During a long exact decision it is called again with the same numbers, up to a hundred times a second, and can end
  /// the decision. Therefore it must not query lengths, angles or areas of the triangulation.
  bool go_further(const CGAL::Intrinsic_triangulations::Progress& progress);

  /// is called after each flip by `flip_to_Delaunay()` or `Geodesic_path_network`, when connectivity and metric have
  /// changed; the edge keeps its descriptor.
  void after_flip(CGAL::Intrinsic_triangulations::Edge_index e);

  /// is called after each test of `flip_to_Delaunay()` with the result, a `Boolean` of the traits. If the model has this
  /// function, each edge is tested individually, and on one thread.
  void after_test(CGAL::Intrinsic_triangulations::Edge_index e, Boolean is_Delaunay);

  /// is called before `refine_Delaunay()` refines a face, with the remaining work.
  void before_step(const CGAL::Intrinsic_triangulations::Refinement_progress& progress);

  /// is called after `refine_Delaunay()` inserts a vertex, when the triangulation is Delaunay again.
  void after_insertion(CGAL::Intrinsic_triangulations::Vertex_index v);
};

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgIntrinsicTriangulationsConcepts
\cgalConcept

The concept `IntrinsicTriangulationTraits` describes the metric of an `Intrinsic_triangulation`: what is stored for each
edge and face, when an edge is Delaunay, and how a flip changes the numbers. It knows nothing of the connectivity:
functors see one hinge, an edge `ij` with the triangle `ijk` to its left and `jil` to its right, and never a descriptor.

The triangles are Euclidean, or, with `Ptolemy_traits`, ideal hyperbolic ones: then "length" is λ-length, and areas and
cotangents are those of the Euclidean triangle with the same lengths.

A model is `CopyConstructible`, and `DefaultConstructible` if users need not pass it. Member functions with the suffix
`_object` return the functors, whose operators are `const`.

The algorithms trust the model's decisions. If `Boolean` is `CGAL::Uncertain<bool>`, an interval number type can fail to
decide: the algorithms then report the edge and do not guess.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Intrinsic_triangulations::Edge_length_traits}
\cgalHasModels{CGAL::Intrinsic_triangulations::Half_angle_traits}
\cgalHasModels{CGAL::Intrinsic_triangulations::Filtered_edge_length_traits}
\cgalHasModels{CGAL::Intrinsic_triangulations::Ptolemy_traits}
\cgalHasModelsEnd

\sa `IntrinsicTriangulationVisitor`
*/
class IntrinsicTriangulationTraits
{
public:
  /// \name Types
  /// @{

  /*!
  The number type of lengths, areas and weights.

  It is `CopyConstructible`, `CopyAssignable` and constructible from `int`. It has binary `+`, `-` and `*`, and `<` and
  `>` that return `Boolean`. `CGAL::Real_embeddable_traits<FT>` provides `To_double`, and `To_interval` unless `FT` is a
  built-in floating-point type.

  Constructing a triangulation from points also requires that `FT` is `DefaultConstructible`, has `==`, and is
  constructible from `double` and from coordinates of built-in types. Other coordinates (rational, algebraic, or with
  more digits than `double`) are converted to a sum of doubles with as many digits as `FT` has. If `FT` is exact,
  rational coordinates are converted exactly.

  For a built-in floating-point type, `CGAL::Interval_nt`, or a float of Boost.Multiprecision with a similar exponent
  range, very large or small input is multiplied by a power of two before the functors see it.

  `Edge_length_traits` and `Half_angle_traits` accept any model `FT` of `FieldWithSqrt` and `RealEmbeddable` with
  `CGAL::Algebraic_structure_traits<FT>` and `CGAL::Real_embeddable_traits<FT>`. The package provides these for
  `__float128` and for the floats of Boost.Multiprecision, with and without expression templates. A type without square
  roots fails to compile, with a one-sentence message. Decisions are exact if
  `CGAL::Algebraic_structure_traits<FT>::Is_exact` is `CGAL::Tag_true`. The page "Number types compared" lists their
  costs.
  */
  typedef unspecified_type FT;

  /// `bool` or `CGAL::Uncertain<bool>`
  typedef unspecified_type Boolean;

  /// the data stored for an edge: `DefaultConstructible`, `CopyConstructible` and `CopyAssignable`.
  /// A default-constructed value is never read.
  typedef unspecified_type Edge_data;

  /// the data stored for a face, with the requirements of `Edge_data`
  typedef unspecified_type Face_data;

  /// `CGAL::Tag_false` if any three positive lengths are those of a face. Optional: without it, lengths have to obey the
  /// triangle inequality.
  typedef unspecified_type Has_Euclidean_faces;

  /// `CGAL::Tag_true` if every decision is exact for the surface that the input defines, otherwise
  /// `CGAL::Tag_false`. With `CGAL::Tag_true`, `flip_to_Delaunay()` has no flip budget by default.
  typedef unspecified_type Has_exact_decisions;

  /// \brief whether the triangulation keeps its input, and decides from it if `Is_locally_Delaunay` is uncertain.
  ///
  /// `CGAL::Tag_false` for a model whose answers are final. With `CGAL::Tag_true`, `FT` is `double`, `Boolean` is
  /// `CGAL::Uncertain<bool>`, and the model also has `Construct_refined_data`, `Is_convex` and `Has_positive_area`.
  typedef unspecified_type Uses_exact_geometry;

  /// a point in space
  typedef std::array<FT, 3> Point_data;

  /// the data around an edge, by reference
  typedef CGAL::Intrinsic_triangulations::Hinge<Edge_data, Face_data> Hinge_data;

  /// the data of the other diagonal and the two faces beside it: `DefaultConstructible`, with the members `kl` of type
  /// `Edge_data`, and `ilk` and `jkl` of type `Face_data`; for instance
  /// `CGAL::Intrinsic_triangulations::Flipped_hinge<Edge_data, Face_data>`
  typedef unspecified_type Flipped_hinge_data;

  /*!
  A functor that constructs the data of an edge. It provides

  `Edge_data operator()(const Point_data& p, const Point_data& q) const`: the edge between two points, the same for
  `(p, q)` and `(q, p)`;

  `Edge_data from_length(const FT& length) const`: the edge with this length.

  Each is required only by triangulations constructed in this way.
  */
  typedef unspecified_type Construct_edge_data;

  /*!
  A functor that constructs the data of a face. It provides

  `Face_data operator()(const Point_data& p, const Point_data& q, const Point_data& r) const`;

  `Face_data from_lengths(const FT& ij, const FT& jk, const FT& ki) const`; if the lengths violate the triangle
  inequality, the value is discarded.

  Each is required only by triangulations constructed in this way. The area may be zero.
  */
  typedef unspecified_type Construct_face_data;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge) const`: whether the edge `ij` is Delaunay, that is, whether the
  angles at `k` and `l` sum to at most π, or a corresponding criterion. If it fails, the flipped edge is Delaunay. Ties must be
  Delaunay; otherwise `flip_to_Delaunay()` would not end.
  */
  typedef unspecified_type Is_locally_Delaunay;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge) const`: whether the two faces form a strictly convex
  quadrilateral, uncertain if the stored numbers do not decide. Required only if `Uses_exact_geometry` is
  `CGAL::Tag_true`.
  */
  typedef unspecified_type Is_convex;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge, Flipped_hinge_data& flipped) const`: returns whether the hinge is
  strictly convex. If it certainly is, sets `flipped` to the edge `kl` and the faces `ilk` and `jkl`; otherwise `flipped`
  is unspecified. If `Uses_exact_geometry` is `CGAL::Tag_true`, it is called only for convex hinges and need not check.
  */
  typedef unspecified_type Construct_flipped_hinge;

  /*!
  A functor that constructs data from the results of the exact stages. It provides, for a number type `N` of these
  stages,

  `Edge_data operator()(const N& s) const`: the data of an edge with squared length `s`;

  `Face_data operator()(const N& a, const N& ij, const N& jk, const N& ki) const`: the data of a face with area `a / 4`
  and these squared edge lengths. If its member `error` is infinite, the numbers are too inaccurate to replace the
  stored ones.

  Required only if `Uses_exact_geometry` is `CGAL::Tag_true`.
  */
  typedef unspecified_type Construct_refined_data;

  /*!
  Provides `std::array<float, 3> operator()(const Face_data& ijk, const Edge_data& ij,
  const Edge_data& jk, const Edge_data& ki) const`: lower bounds on the cotangents of the corners opposite to `ij`, `jk`
  and `ki`. An edge whose two opposite bounds have a positive sum must be Delaunay, by `Is_locally_Delaunay` or by the
  exact stages.

  Optional: without it and `compute_cotangent_bounds_object()`, `Is_locally_Delaunay` tests every edge.
  */
  typedef unspecified_type Compute_cotangent_bounds;

  /*!
  Provides `CGAL::Intrinsic_triangulations::Bounded_double operator()(const Face_data& ijk, const Edge_data& ij,
  const Edge_data& jk, const Edge_data& ki) const`: the cotangent of the corner `k`, opposite to `ij`, and a bound on its
  error, infinite if the cotangent is unknown.

  Optional: without it and `compute_bounded_cotangent_object()`, `cotangent_weights()` queries the triangulation for
  every weight.
  */
  typedef unspecified_type Compute_bounded_cotangent;

  /// provides `bool operator()(const Face_data& f) const`: whether the stored data of a face are so accurate that they
  /// need not be recomputed from points. Required only if `Uses_exact_geometry` is `CGAL::Tag_true`.
  typedef unspecified_type Is_accurate;

  /// provides `bool operator()(const Face_data& ijk) const`: whether the area is certainly positive. Required only if
  /// `Uses_exact_geometry` is `CGAL::Tag_true`.
  typedef unspecified_type Has_positive_area;

  /// provides `FT operator()(const Edge_data& ij) const`: the squared length
  typedef unspecified_type Compute_squared_length;

  /// provides `FT operator()(const Edge_data& ij) const`: the length
  typedef unspecified_type Compute_length;

  /// provides `FT operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
  /// const Edge_data& ki) const`: the area
  typedef unspecified_type Compute_area;

  /// provides `FT operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
  /// const Edge_data& ki) const`: the cotangent of the corner `k`, opposite to `ij`
  typedef unspecified_type Compute_cotangent;

  /// @}

  /// \name Operations
  /// @{

  /// returns the functor.
  Construct_edge_data construct_edge_data_object() const;
  Construct_face_data construct_face_data_object() const;
  Is_locally_Delaunay is_locally_Delaunay_object() const;
  Is_convex is_convex_object() const;
  Construct_flipped_hinge construct_flipped_hinge_object() const;
  Construct_refined_data construct_refined_data_object() const;
  Is_accurate is_accurate_object() const;
  Has_positive_area has_positive_area_object() const;
  Compute_squared_length compute_squared_length_object() const;
  Compute_length compute_length_object() const;
  Compute_area compute_area_object() const;
  Compute_cotangent compute_cotangent_object() const;
  Compute_cotangent_bounds compute_cotangent_bounds_object() const;
  Compute_bounded_cotangent compute_bounded_cotangent_object() const;
  /// @}
};

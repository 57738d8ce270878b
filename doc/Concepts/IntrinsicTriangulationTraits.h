// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgIntrinsicTriangulationsConcepts
\cgalConcept

The concept `IntrinsicTriangulationTraits` says what `Intrinsic_triangulation` needs to know
about a metric: what is kept for each edge and each face, when an edge is Delaunay, and what
a flip makes of the numbers. The connectivity is not its business: functors see one hinge, an
edge `ij` with the triangle `ijk` to its left and `jil` to its right, and never a
descriptor.

A model is `CopyConstructible`. It is `DefaultConstructible` if it is to be used without being
passed. Functors are made by the member functions with suffix `_object`; they are called on
`const` objects.

The decisions are those of the model. `CGAL::Uncertain<bool>` as `Boolean` lets an interval
number type say that it cannot tell; the algorithms then report the edge and do not guess.

\cgalHasModel `CGAL::Intrinsic_triangulations::Edge_length_traits`
\cgalHasModel `CGAL::Intrinsic_triangulations::Half_angle_traits`
\cgalHasModel `CGAL::Intrinsic_triangulations::Filtered_edge_length_traits`

\sa `IntrinsicTriangulationVisitor`
*/
class IntrinsicTriangulationTraits
{
public:
  /// \name Types
  /// @{

  /*!
  The number type of lengths, areas and weights.

  It is `CopyConstructible`, `CopyAssignable`, and constructible from `int`; it has binary
  `+`, `-` and `*`, and `<` and `>`, whose values are `Boolean`.
  `CGAL::Real_embeddable_traits<FT>` provides `To_double`, and `To_interval` if `FT` is not a
  built-in floating-point type.

  To construct a triangulation from points, `FT` is `DefaultConstructible` and has `==` as
  well, and is constructible from `double` and from coordinates of a built-in type. Other coordinates,
  rational, algebraic or of more digits than `double`, reach it as a sum of doubles that stops where
  `FT` has no more digits; if `FT` is exact, rational ones by the digits of numerator and denominator.

  For a built-in floating-point type, `CGAL::Interval_nt` or a float of Boost.Multiprecision with
  exponents like theirs, very large or small input is multiplied by a power of two before the functors
  see it.

  `Edge_length_traits` and `Half_angle_traits` take any `FT` that is a model of `FieldWithSqrt` and
  `RealEmbeddable`, with `CGAL::Algebraic_structure_traits<FT>` and `CGAL::Real_embeddable_traits<FT>`. Those
  of `__float128` and of the floats of Boost.Multiprecision, with and without expression templates, come
  with the package; a type without square roots is refused by one sentence of the compiler. Decisions are
  exact if `CGAL::Algebraic_structure_traits<FT>::Is_exact` says so. The page "Number types compared" says what each costs.
  */
  typedef unspecified_type FT;

  /// `bool` or `CGAL::Uncertain<bool>`
  typedef unspecified_type Boolean;

  /// what is kept for an edge; `DefaultConstructible`, `CopyConstructible` and
  /// `CopyAssignable`. A default constructed value is assigned to before it is read.
  typedef unspecified_type Edge_data;

  /// what is kept for a face; as `Edge_data`
  typedef unspecified_type Face_data;

  /// `CGAL::Tag_true` if each decision is that of exact arithmetic on the surface that the
  /// input defines, else `CGAL::Tag_false`. With `CGAL::Tag_true`, `flip_to_Delaunay()` runs
  /// without a flip budget.
  typedef unspecified_type Has_exact_decisions;

  /// \brief whether the triangulation is to keep its input, and to decide by it where the
  /// answer of `Is_locally_Delaunay` is not certain.
  ///
  /// `CGAL::Tag_false` for a model whose answers are final. With `CGAL::Tag_true`, `FT` is
  /// `double`, `Boolean` is `CGAL::Uncertain<bool>`, and the model has
  /// `Construct_refined_data`, `Is_convex` and `Has_positive_area` as well.
  typedef unspecified_type Uses_exact_geometry;

  /// a point in space
  typedef std::array<FT, 3> Point_data;

  /// the data around an edge, by reference
  typedef CGAL::Intrinsic_triangulations::Hinge<Edge_data, Face_data> Hinge_data;

  /// the data of the other diagonal and of the faces beside it: `DefaultConstructible`, with
  /// members `kl` of type `Edge_data`, `ilk` and `jkl` of type `Face_data`; for instance
  /// `CGAL::Intrinsic_triangulations::Flipped_hinge<Edge_data, Face_data>`
  typedef unspecified_type Flipped_hinge_data;

  /*!
  Provides

  `Edge_data operator()(const Point_data& p, const Point_data& q) const`: the edge between two
  points, the same for `(p, q)` and `(q, p)`;

  `Edge_data from_length(const FT& length) const`: the edge of a length.

  Each is required only for triangulations that are constructed that way.
  */
  typedef unspecified_type Construct_edge_data;

  /*!
  Provides

  `Face_data operator()(const Point_data& p, const Point_data& q, const Point_data& r) const`;

  `Face_data from_lengths(const FT& ij, const FT& jk, const FT& ki) const`, where the lengths
  obey the triangle inequality, or a value that is thrown away if they do not.

  Each is required only for triangulations that are constructed that way. The area may be
  zero.
  */
  typedef unspecified_type Construct_face_data;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge) const`: whether the edge
  `ij` is Delaunay, that is, whether the angles at `k` and `l` sum to at most
  π. A tie is Delaunay: only then does `flip_to_Delaunay()` end.
  */
  typedef unspecified_type Is_locally_Delaunay;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge) const`: whether the two faces form a strictly convex
  quadrilateral, as far as the numbers tell. Required only if `Uses_exact_geometry` is `CGAL::Tag_true`.
  */
  typedef unspecified_type Is_convex;

  /*!
  Provides `Boolean operator()(const Hinge_data& hinge, Flipped_hinge_data& flipped) const`:
  returns whether the hinge is strictly convex, and if it certainly is, sets `flipped` to the
  edge `kl` and the faces `ilk` and `jkl`. Otherwise `flipped` may hold anything.
  With `Uses_exact_geometry` it is called for convex hinges only, and need not look.
  */
  typedef unspecified_type Construct_flipped_hinge;

  /*!
  Provides, for a number type `N` of the exact stages,

  `Edge_data operator()(const N& s) const`: what is to be kept for an edge of this squared
  length;

  `Face_data operator()(const N& a, const N& ij, const N& jk, const N& ki) const`: what is to
  be kept for a face of this area times four between edges of these squared lengths. If its
  member `error` is infinite, the numbers are not good enough to replace what is kept.

  Required only if `Uses_exact_geometry` is `CGAL::Tag_true`.
  */
  typedef unspecified_type Construct_refined_data;

  /*!
  Provides `std::array<float, 3> operator()(const Face_data& ijk, const Edge_data& ij,
  const Edge_data& jk, const Edge_data& ki) const`: lower bounds for the cotangents of the
  corners opposite to `ij`, `jk` and `ki`. If the two bounds of the corners opposite to
  an edge sum to more than zero, `Is_locally_Delaunay` certainly holds, or the exact stages
  would find so.

  Optional: without it, and without `compute_cotangent_bounds_object()`, each edge is tested by
  `Is_locally_Delaunay`.
  */
  typedef unspecified_type Compute_cotangent_bounds;

  /*!
  Provides `CGAL::Intrinsic_triangulations::Bounded_double operator()(const Face_data& ijk, const Edge_data& ij,
  const Edge_data& jk, const Edge_data& ki) const`: the cotangent of the corner `k`, opposite to `ij`, with a bound on its
  error, which is infinite if the cotangent is not known.

  Optional: without it, and without `compute_bounded_cotangent_object()`, `cotangent_weights()` asks the
  triangulation for each weight.
  */
  typedef unspecified_type Compute_bounded_cotangent;

  /// provides `bool operator()(const Face_data& f) const`: whether what is kept for a face is so
  /// good that it need not be replaced where the points are at hand. Only for traits that use exact geometry.
  typedef unspecified_type Is_accurate;

  /// provides `bool operator()(const Face_data& ijk) const`: whether the area is known to be
  /// positive. Required only if `Uses_exact_geometry` is `CGAL::Tag_true`.
  typedef unspecified_type Has_positive_area;

  /// provides `FT operator()(const Edge_data& ij) const`
  typedef unspecified_type Compute_squared_length;

  /// provides `FT operator()(const Edge_data& ij) const`
  typedef unspecified_type Compute_length;

  /// provides `FT operator()(const Face_data& ijk, const Edge_data& ij, const Edge_data& jk,
  /// const Edge_data& ki) const`
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

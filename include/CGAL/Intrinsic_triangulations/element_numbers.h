// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengths, areas, angles, cotangents and weights of all elements as doubles; angles and their sums around vertices.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_NUMBERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_NUMBERS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Cotangent_weight.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Element_measurer.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsAngles
/// @{

namespace internal {

// From the numbers of the traits. A face without area has one angle of π, opposite to its longest edge.
template <class Triangulation>
double angle_by_number_type(const Triangulation& triangulation, Halfedge_index h)
{
  const Delta_complex& complex = triangulation.connectivity();
  if (certainly(triangulation.area(complex.face(h)) > typename Triangulation::FT(0)))
    return std::atan2(1., CGAL::to_double(triangulation.cotangent(h)));
  const auto length = [&](Halfedge_index side) { return CGAL::to_double(triangulation.length(complex.edge(side))); };
  return h == side_with_largest(complex, complex.face(h), length) ? CGAL_PI : 0;
}

// Calls `visit(h)` for each halfedge with source v, counterclockwise, and on the border from border to border: the
// last one is a border halfedge then.
template <class Visit>
void for_each_halfedge_from(const Delta_complex& complex, Vertex_index v, const Visit& visit)
{
  if (!complex.halfedge(v).is_valid())
    return;
  const Halfedge_index first = complex.opposite(complex.halfedge(v));
  Halfedge_index h = first;
  for (;;) {
    visit(h);
    if (complex.is_border(h))
      return;
    h = complex.next_around_source(h);
    if (h == first)
      return;
  }
}

} // namespace internal

/// \brief the numbers of all edges and faces.
struct Element_numbers
{
  std::vector<double> lengths;           ///< for each edge, in the unit of the input
  std::vector<double> areas;             ///< for each face, in the unit of the input
  std::vector<double> cotangent_weights; ///< for each edge, `cot k + cot l`; infinite beside a face of zero area
};

/// \brief returns lengths, areas and cotangent weights, equal to those that the member functions of
/// `Intrinsic_triangulation` return for single elements.
///
/// With traits that use exact geometry, one corner is laid out for each face: this takes a fraction of the time of
/// single queries. None of the numbers is NaN: beside a face of zero area the weight is infinite, and zero if two such
/// faces have opposite angles of 0 and of π. The weight of an edge that the traits decide to be Delaunay is not
/// negative.
///
/// O(size + number of input edges that the edges cross).
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the numbers are
///   the same. Without exact geometry, one thread is used
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{reports progress, called by the calling thread, and can cancel}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error as `area()` of `Intrinsic_triangulation`
/// \exception Cancelled_error if the visitor or the function given to `set_interruption()` asks for it
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
Element_numbers element_numbers(const Intrinsic_triangulation<Traits>& triangulation,
                                const NamedParameters& np = parameters::default_values())
{
  internal::Element_measurer<ConcurrencyTag, Traits> measurer(triangulation, internal::progress_function_of(np));
  Element_numbers result;
  result.lengths = measurer.lengths();
  result.cotangent_weights = measurer.weights();
  result.areas = measurer.areas();
  return result;
}

/// \brief returns the length of each edge, as `element_numbers()`.
/// \param triangulation, np as for `element_numbers()`
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> edge_lengths(const Intrinsic_triangulation<Traits>& triangulation,
                                 const NamedParameters& np = parameters::default_values())
{
  return internal::Element_measurer<ConcurrencyTag, Traits>(triangulation, internal::progress_function_of(np))
    .lengths();
}

/// \brief returns the length of each edge, from the input and the connectivity alone: within one unit in the last
/// place, whatever the number type.
/// \param triangulation the triangulation
/// \pre `triangulation.keeps_input()`
/// \exception Cancelled_error if the function given to `set_interruption()` asks for it
template <class Traits>
std::vector<double> exact_edge_lengths(const Intrinsic_triangulation<Traits>& triangulation)
{
  const internal::Engine_numbers numbers(internal::engine(triangulation));
  std::vector<double> result;
  result.reserve(triangulation.connectivity().number_of_edges());
  for (Edge_index e : triangulation.connectivity().edges())
    result.push_back(numbers.length(e));
  return result;
}

/// \brief returns the cotangent of the angle opposite to each halfedge, in the order of the halfedges; 0 for border
/// halfedges.
///
/// With traits that use exact geometry, the error is at most `2^-50 (1 + |cot|)`. In a face of zero area, cotangents
/// are infinite.
/// \param triangulation, np as for `element_numbers()`
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> cotangents(const Intrinsic_triangulation<Traits>& triangulation,
                               const NamedParameters& np = parameters::default_values())
{
  return internal::Element_measurer<ConcurrencyTag, Traits>(triangulation, internal::progress_function_of(np))
    .cotangents();
}

/// \brief returns the cotangent weight of each edge, in the order of the edges: the sum of the
/// cotangents of the one or two opposite angles, without a factor and dimensionless.
///
/// These weights are for matrices, and take less time than those of `element_numbers()`.
/// With `Filtered_edge_length_traits` each weight is within `2^-32 (1 + |cot k| + |cot l|)` of
/// the exact one and has its sign, and the weight of a tie is exactly zero. So on an exact intrinsic
/// Delaunay triangulation no weight of an interior edge is negative. The exact geometry is used only
/// where the stored numbers are not accurate enough. With other traits, weights are computed in their number type, and
/// none is negative if the traits decide that the edge is Delaunay. A border edge has one angle, which may be obtuse.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the weights are
///   the same
/// \param triangulation the triangulation
/// \exception Invalid_surface_error if a face has zero area
///
/// O(size), except for the edges that need the exact geometry.
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 3.1.
template <class ConcurrencyTag = Sequential_tag, class Traits>
std::vector<double> cotangent_weights(const Intrinsic_triangulation<Traits>& triangulation)
{
  return internal::numbers_of_elements<ConcurrencyTag, Edge_index>(triangulation.connectivity().number_of_edges(),
                                                                   internal::Cotangent_weight<Traits>(triangulation));
}

/// \brief returns the area of each face, in the order of the faces and in the unit of the
/// input.
///
/// With `Filtered_edge_length_traits` the relative error is at most `2^-32`; with other traits, it is that of the
/// number type. O(size), except for the faces that need the exact geometry.
/// \exception Invalid_surface_error if the unit of the input is so large that an area is beyond the
///   range of `double`, or, with `Filtered_edge_length_traits`, so small that it is below
/// \tparam ConcurrencyTag as for `cotangent_weights()`
/// \param triangulation the triangulation
template <class ConcurrencyTag = Sequential_tag, class Traits>
std::vector<double> face_areas(const Intrinsic_triangulation<Traits>& triangulation)
{
  return internal::numbers_of_elements<ConcurrencyTag, Face_index>(triangulation.connectivity().number_of_faces(),
                                                                   internal::Face_area<Traits>(triangulation));
}

/// \brief a summary of the cotangent weights of a triangulation.
struct Weight_summary
{
  std::optional<double> smallest; ///< the smallest finite weight of an interior edge, if there is one
  std::size_t negative = 0;       ///< interior edges that are not Delaunay
  std::size_t infinite = 0;       ///< edges without a weight, beside a face of zero area; on the border, too
};

/// \brief returns the smallest cotangent weight, and how many are negative or infinite.
///
/// The weights are those of `element_numbers()`, but with `Filtered_edge_length_traits` the exact geometry computes
/// only the few that can be the smallest. O(size), except for the edges that need the exact geometry.
/// \param triangulation the triangulation
/// \exception Cancelled_error if the function given to `set_interruption()` asks for it
template <class Traits>
Weight_summary summarize_cotangent_weights(const Intrinsic_triangulation<Traits>& triangulation)
{
  Weight_summary result;
  internal::Weight_summarizer<Traits>(triangulation).summarize(result);
  return result;
}

/// \brief returns the angle opposite to `h` in its face, the one whose cotangent is `triangulation.cotangent(h)`.
///
/// So the angle at the source of `h` is that of `next(h)`, and the angle at its target that of `prev(h)`.
///
/// With traits that use exact geometry, the relative error is at most 2^-49 unless the angle is below 2^-400, however
/// thin the face is. With other traits, the angle is computed from their cotangent. A face of zero area has one angle
/// of π and two of 0; the angle of π is the one that the flips use. An angle is never NaN.
///
/// \param triangulation the triangulation
/// \param h a halfedge of it
/// \pre `h` is not a border halfedge
/// \exception Undecided_error as `sign_of_cotangent_weight()`
template <class Traits>
double angle(const Intrinsic_triangulation<Traits>& triangulation, Halfedge_index h)
{
  CGAL_precondition(!triangulation.connectivity().is_border(h));
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry)
    return internal::Engine_numbers(internal::engine(triangulation)).angle(h);
  else
    return internal::angle_by_number_type(triangulation, h);
}

/// \brief returns the angle opposite to each halfedge, in the order of the halfedges; 0 for border halfedges.
///
/// As `angle()`, with the same bounds, and otherwise as `element_numbers()`.
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{relative_error}
///     \cgalParamDescription{a sufficient accuracy, if larger than the error of `angle()`: for slivers, multiple
///       precision takes most of the time}
///     \cgalParamType{`double`}
///     \cgalParamDefault{2^-49}
///   \cgalParamNEnd
///   \cgalParamVisitor{as for `element_numbers()`}
/// \cgalNamedParamsEnd
///
/// \tparam ConcurrencyTag as for `element_numbers()`
/// \exception Undecided_error as `angle()`
template <class ConcurrencyTag = Sequential_tag, class Traits,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> opposite_angles(const Intrinsic_triangulation<Traits>& triangulation,
                                    const NamedParameters& np = parameters::default_values())
{
  const double relative_error = internal::value_of<internal::Parameter::RELATIVE_ERROR>(np, 0x1p-49);
  return internal::Element_measurer<ConcurrencyTag, Traits>(triangulation, internal::progress_function_of(np))
    .angles(relative_error, [&](Halfedge_index h) { return angle(triangulation, h); });
}

/// \brief returns the cone angle of `v`: the sum of the angles at `v`. O(degree of `v`).
///
/// It is a property of the surface: flips change it by no more than rounding, a relative error of 2^-49, and 2^-53 for
/// each face at `v`. It is 2π where the surface is flat around `v`, and 0 for an isolated vertex.
/// \param triangulation the triangulation
/// \param v a vertex of it
/// \exception Undecided_error as `angle()`
template <class Traits>
double cone_angle(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index v)
{
  const Delta_complex& complex = triangulation.connectivity();
  double sum = 0;
  internal::for_each_halfedge_from(complex, v, [&](Halfedge_index h) {
    if (!complex.is_border(h))
      sum += angle(triangulation, complex.next(h));
  });
  return sum;
}

/// \brief returns the angle defect of `v`: 2π minus its cone angle, or π minus it on the border. O(degree of `v`).
///
/// It is the integral of the Gaussian curvature at an interior vertex, and of the geodesic curvature of the border at
/// a border vertex. The sum over all vertices is 2π times the Euler characteristic (Gauss–Bonnet).
/// \param triangulation the triangulation
/// \param v a vertex of it
/// \exception Undecided_error as `angle()`
template <class Traits>
double angle_defect(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index v)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index h = complex.halfedge(v);
  const bool is_on_border = h.is_valid() && complex.is_border(h);
  return (is_on_border ? CGAL_PI : 2 * CGAL_PI) - cone_angle(triangulation, v);
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ELEMENT_NUMBERS_H

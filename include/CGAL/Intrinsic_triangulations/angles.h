// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Angles of faces, and their sums around vertices.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// From the numbers of the traits. A face without area has one angle of π, opposite to its longest edge.
template <class Triangulation>
double angle_by_number_type(const Triangulation& triangulation, Halfedge_index h)
{
  const Delta_complex& complex = triangulation.connectivity();
  if (certainly(triangulation.area(complex.face(h)) > typename Triangulation::FT(0)))
    return std::atan2(1., CGAL::to_double(triangulation.cotangent(h)));
  const auto length = [&](Halfedge_index side) { return CGAL::to_double(triangulation.length(complex.edge(side))); };
  const Halfedge_index first = complex.halfedge(complex.face(h));
  Halfedge_index longest = first;
  for (Halfedge_index side : {complex.next(first), complex.prev(first)})
    if (length(side) > length(longest))
      longest = side;
  return h == longest ? CGAL_PI : 0;
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
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the angle opposite to `h` in its face, the one whose cotangent is `triangulation.cotangent(h)`.
///
/// So the angle at the source of `h` is that of `next(h)`, and the angle at its target that of `prev(h)`.
///
/// With traits that use exact geometry, the relative error is at most 2^-49 unless the angle is below 2^-400,
/// however thin the face is. With other traits, the angle is computed from their cotangent. A face of zero area
/// has one angle of π and two of 0; the angle of π is that on which the flips decide. An angle is never NaN.
///
/// \pre `h` is not a border halfedge
/// \exception Undecided_error as `sign_of_cotangents()` of `Exact_geometry`
template <class Traits>
double angle(const Intrinsic_triangulation<Traits>& triangulation, Halfedge_index h)
{
  CGAL_precondition(!triangulation.connectivity().is_border(h));
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry)
    return internal::engine(triangulation).angle(h);
  else
    return internal::angle_by_number_type(triangulation, h);
}

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the angle opposite to each halfedge, in the order of the halfedges; 0 for border halfedges.
///
/// As `angle()`, with the same bounds, but one corner is laid out for each face instead of each angle by itself.
/// O(size + number of input edges that the edges cross).
/// \param triangulation the triangulation
/// \param relative_error what is enough, if that is more than the error of `angle()`: among slivers, multiple precision takes most of the time
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: the angles are the same
/// \exception Undecided_error as `angle()`
template <class ConcurrencyTag = Sequential_tag, class Traits>
std::vector<double> opposite_angles(const Intrinsic_triangulation<Traits>& triangulation, double relative_error = 0x1p-49)
{
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<double> result;
  result.reserve(complex.number_of_halfedges());
  const auto append = [&](Halfedge_index h, const auto& known) {
    const double a = complex.is_border(h) ? 0 : known(h);
    result.push_back(std::isnan(a) ? angle(triangulation, h) : a);
  };
  if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
    const internal::Exact_engine& engine = internal::engine<ConcurrencyTag>(triangulation);
    internal::Exact_engine::Rounded_numbers numbers(complex);
    internal::for_each_block<ConcurrencyTag>(
      complex.number_of_faces(), internal::elements_of_block,
      [&](std::size_t first, std::size_t last) { engine.find_numbers(first, last, numbers); });
    for (Halfedge_index h : complex.halfedges())
      append(h, [&](Halfedge_index side) { return numbers.angle(side, relative_error); });
  } else {
    for (Halfedge_index h : complex.halfedges())
      append(h, [&](Halfedge_index side) { return angle(triangulation, side); });
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the cone angle of `v`: the sum of the angles at `v`. O(degree of `v`).
///
/// It is a property of the surface: flips change it by no more than rounding, a relative error of 2^-49, and 2^-53 for each
/// face at `v`. It is 2π where the surface is flat around `v`, and 0 for an isolated vertex.
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

/// \ingroup PkgIntrinsicTriangulationsAngles
/// \brief returns the angle defect of `v`: what its cone angle lacks of 2π, or of π on the border. O(degree of `v`).
///
/// It is the integral of the Gaussian curvature at an interior vertex, and of the geodesic curvature of the border at
/// a border vertex. The sum over all vertices is 2π times the Euler characteristic (Gauss–Bonnet).
/// \exception Undecided_error as `angle()`
template <class Traits>
double angle_defect(const Intrinsic_triangulation<Traits>& triangulation, Vertex_index v)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index h = complex.halfedge(v);
  const bool is_on_border = h.is_valid() && complex.is_border(h);
  return (is_on_border ? CGAL_PI : 2 * CGAL_PI) - cone_angle(triangulation, v);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ANGLES_H

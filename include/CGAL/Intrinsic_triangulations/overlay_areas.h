// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The areas of the faces of an overlay.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_AREAS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_AREAS_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/area_in_input_unit.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/affine_image.h>
#include <CGAL/Intrinsic_triangulations/internal/positions/overlay_layers.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// The fraction that the triangle of three points takes of the face in whose coordinates they are.
inline double area_fraction(const Coordinates& a, const Coordinates& b, const Coordinates& c)
{
  return determinant(b[1] - a[1], b[2] - a[2], c[1] - a[1], c[2] - a[2]);
}

// A face of the overlay, as a fan of triangles around its first corner.
struct Overlay_fan
{
  // The coordinates `from` are those in the input face, relative to the halfedge that it names,
  // `to` those in the intrinsic face.
  Corners_in_both corners;
  double input_area;
  double intrinsic_area;

  std::size_t size() const { return corners.size() - 2; }

  // The area of triangle i. Rounding errors are relative to the smaller of the two faces, so
  // that small areas in large faces keep their digits.
  double area(std::size_t i) const
  {
    const Corner_in_both &a = corners[0], &b = corners[i + 1], &c = corners[i + 2];
    return input_area < intrinsic_area ? input_area * area_fraction(a.from, b.from, c.from)
                                       : intrinsic_area * area_fraction(a.to, b.to, c.to);
  }
};

// The areas of the faces of both triangulations, in the unit of the input.
struct Areas_in_both
{
  explicit Areas_in_both(const Common_subdivision& subdivision)
  {
    const internal::Exact_engine& engine = internal::engine(subdivision);
    const Delta_complex& complex = subdivision.input();
    for (Face_index f : complex.faces())
      input.push_back(
        area_in_input_unit(engine.metric().four_areas_double_double(complex, f).hi() / 4,
                           engine.metric().unit_exponent(), f));
    for (Face_index f : subdivision.intrinsic().faces())
      intrinsic.push_back(engine.area(f));
  }

  std::vector<double> input, intrinsic;
};

// Calls `visit(f, fan)` for each face f of the overlay.
template <class Visit>
void for_each_overlay_fan(const Common_subdivision& subdivision, const Areas_in_both& areas, const Visit& visit)
{
  const Input_layer input{subdivision.input(), subdivision.overlay(), subdivision.positions()};
  const Intrinsic_layer intrinsic{subdivision.intrinsic(), subdivision.overlay(), subdivision.positions()};
  for (Overlay::Face f : subdivision.overlay().faces()) {
    const Face_index in_input = input.face(f), in_intrinsic = intrinsic.face(f);
    visit(f, Overlay_fan{corners_in_both(input, input.complex.halfedge(in_input), intrinsic,
                                         intrinsic.complex.halfedge(in_intrinsic), f),
                         areas.input[in_input.idx()], areas.intrinsic[in_intrinsic.idx()]});
  }
}

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns the area of each face of the overlay, in the unit of the input.
///
/// It is the fraction of its input face or intrinsic face that the face covers, times the
/// area of that face, so no embedding is needed. The error is a few units in the last place of the
/// area of the smaller of the two.
/// \param subdivision the common subdivision. O(size of the overlay).
/// \exception Invalid_surface_error as `area()` of `Exact_geometry`
inline std::vector<double> face_areas(const Common_subdivision& subdivision)
{
  std::vector<double> areas(subdivision.overlay().number_of_faces());
  internal::for_each_overlay_fan(subdivision, internal::Areas_in_both(subdivision),
                                 [&](Overlay::Face f, const internal::Overlay_fan& fan) {
                                   double area = 0;
                                   for (std::size_t i = 0; i < fan.size(); ++i)
                                     area += fan.area(i);
                                   areas[f.idx()] = area;
                                 });
  return areas;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OVERLAY_AREAS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Is a list of polygons a surface that the package can work on? If not, which
// element is at fault, how many are there like it, and what can be done?

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_report.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Surface_gluer.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Length_range.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/Surface_examiner.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <vector>
#include <cstdint>
#include <cstddef>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief examines whether polygons form an oriented 2-manifold of triangles with usable edge lengths.
///
/// The function looks for every kind of defect, as far as earlier
/// findings allow: a face with an invalid index is ignored in all later checks, and lengths and
/// areas are not checked where a coordinate is not finite. No topological check assumes an
/// orientation. Coordinates are examined as `double`. Their range is checked as by the constructors of
/// `Intrinsic_triangulation` with traits on `double`: what is not refused here is not refused there.
///
/// \tparam PointRange a model of `RandomAccessRange`, of points whose coordinates are `p[0]`, `p[1]` and `p[2]`
/// \tparam PolygonRange a model of `ForwardRange`, of ranges of integers of any length
///
/// \param points the vertices
/// \param polygons the faces, as indices into `points`
///
/// \return the findings in the order of `Finding_kind`; none for a connected
/// triangulated surface without defects. No input makes the function throw
/// (except `std::bad_alloc`).
///
/// Complexity: linear in the numbers of vertices and corners, except for the
/// union-find structures (linear for all practical purposes) and a sort of the faces at
/// edges with more than two faces; a constant number of memory allocations.
template <class PointRange, class PolygonRange>
Surface_report examine_polygons(const PointRange& points, const PolygonRange& polygons)
{
  return internal::Surface_examiner<PointRange>(points).examine(polygons);
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns whether `examine_polygons()` would find nothing but possibly
/// several components: a faster check if the connectivity has been built.
///
/// \param complex the result of `make_Delta_complex_from_triangles()`, which has checked that the faces
///   form an oriented 2-manifold
/// \param points the vertices; coordinates are `p[0]`, `p[1]` and `p[2]`
///
/// Complexity: linear; no memory.
template <class PointRange>
bool is_clean(const Delta_complex& complex, const PointRange& points)
{
  const auto place = [&points](Vertex_index v) {
    const auto& p = points[v.idx()];
    return std::array<double, 3>{{to_double(p[0]), to_double(p[1]), to_double(p[2])}};
  };
  if (complex.number_of_faces() == 0)
    return false;
  internal::Box box;
  for (Vertex_index v : complex.vertices()) {
    const std::array<double, 3> p = place(v);
    if (!complex.halfedge(v).is_valid() ||
        !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
      return false;
    for (int i = 0; i < 3; ++i)
      box.add(i, p[i]);
  }
  const int exponent = internal::unit_exponent<double>(box.half_extent());
  if (exponent != 0)
    for (Vertex_index v : complex.vertices())
      if (std::array<double, 3> p = place(v); !internal::scale_point(p, box, exponent))
        return false;
  internal::Length_range lengths;
  for (Edge_index e : complex.edges()) {
    const Halfedge_index h = complex.halfedge(e);
    if (!lengths.add(place(complex.source(h)), place(complex.target(h)), e.idx()))
      return false;
  }
  if (lengths.vanishes_in_unit(exponent))
    return false;
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f), i = complex.next(h), j = complex.prev(h);
    const Face_index g = complex.face(complex.opposite(h));
    // Two faces with three common edges are the same triangle twice.
    if (g.is_valid() && complex.face(complex.opposite(i)) == g && complex.face(complex.opposite(j)) == g)
      return false;
    if (internal::are_collinear(place(complex.target(h)), place(complex.target(i)), place(complex.target(j))))
      return false;
  }
  return true;
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns which triangles to turn over, by exchanging two corners, so that neighbors agree; in increasing order.
///
/// The first triangle of each part that edges join stays as it is. Where an even number of triangles meets at an edge, directions
/// alternate around it, as they do around solids that touch. A surface that is one-sided is cut open somewhere.
/// \param points the positions of the vertices
/// \param triangles three different vertices for each triangle
inline std::vector<std::size_t> turned_triangles(const std::vector<std::array<double, 3>>& points,
                                                 const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  const internal::Surface_gluer gluer(internal::Points(points.begin(), points.end()), triangles);
  std::vector<std::size_t> result;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    if (gluer.is_turned(f))
      result.push_back(f);
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H

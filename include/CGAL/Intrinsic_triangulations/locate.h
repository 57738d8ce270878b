// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The nearest point of a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LOCATE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LOCATE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \cond SKIP_IN_MANUAL
namespace internal {

// The point of a triangle that is nearest to the origin.
class Nearest_in_triangle
{
  using Vector = std::array<double, 3>;

public:
  std::array<double, 3> coordinates{0, 0, 0};
  double squared_distance = std::numeric_limits<double>::infinity();

  explicit Nearest_in_triangle(const std::array<Vector, 3>& corners) : corners_(corners)
  {
    const Vector normal = cross_product(difference(1, 0), difference(2, 0));
    std::array<double, 3> inside;
    for (std::size_t i = 0; i < 3; ++i)
      inside[i] = scalar_product(normal, cross_product(corners[(i + 1) % 3], corners[(i + 2) % 3]));
    const double sum = inside[0] + inside[1] + inside[2];
    if (inside[0] > 0 && inside[1] > 0 && inside[2] > 0) {
      consider({inside[0] / sum, inside[1] / sum, inside[2] / sum});
      return;
    }
    for (std::size_t i = 0; i < 3; ++i)
      consider_side(i, (i + 1) % 3);
  }

private:
  Vector difference(std::size_t i, std::size_t j) const
  {
    return {corners_[i][0] - corners_[j][0], corners_[i][1] - corners_[j][1], corners_[i][2] - corners_[j][2]};
  }

  void consider_side(std::size_t i, std::size_t j)
  {
    const Vector along = difference(j, i);
    const double squared_length = scalar_product(along, along);
    const double t = squared_length > 0 ? (std::min)((std::max)(-scalar_product(corners_[i], along) / squared_length, 0.), 1.) : 0;
    std::array<double, 3> point{0, 0, 0};
    point[i] = 1 - t;
    point[j] = t;
    consider(point);
  }

  void consider(const std::array<double, 3>& point)
  {
    double squared = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double x = point[0] * corners_[0][k] + point[1] * corners_[1][k] + point[2] * corners_[2][k];
      squared += x * x;
    }
    if (squared < squared_distance) {
      squared_distance = squared;
      coordinates = point;
    }
  }

  const std::array<Vector, 3>& corners_;
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsGeodesics
/// \brief returns the point of a surface in space that is nearest to a given point, as one that was picked.
///
/// All faces are looked at, which takes about as long for a few points as building a search tree. Where several points are equally near, it is
/// that in the face with the smallest number.
///
/// \param complex the triangles; each has three different vertices in space
/// \param points a random access range of the points of the vertices, each with three coordinates
/// \param p the point
/// \return a point in a face, with rounded coordinates that sum to 1. It is exactly on an edge or at a vertex if these are nearest
/// \exception Invalid_point_error if a coordinate of `p` is not finite, or there are no faces. O(size).
template <class PointRange>
Surface_point locate(const Delta_complex& complex, const PointRange& points, const std::array<double, 3>& p)
{
  double largest = (std::max)({std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    throw Invalid_point_error("a coordinate of the point to be located is not finite");
  if (complex.number_of_faces() == 0)
    throw Invalid_point_error("a point cannot be located on a surface without faces");
  for (Vertex_index v : complex.vertices())
    for (int k = 0; k < 3; ++k)
      largest = (std::max)(largest, std::abs(CGAL::to_double(points[v.idx()][k])));
  const int exponent = largest > 0 ? -std::ilogb(largest) - 1 : 0; // so that no product overflows
  const auto relative = [&](Vertex_index v) {
    std::array<double, 3> result;
    for (int k = 0; k < 3; ++k)
      result[k] = std::ldexp(CGAL::to_double(points[v.idx()][k]), exponent) - std::ldexp(p[k], exponent);
    return result;
  };
  Surface_point nearest{complex.halfedge(Face_index(0)), {1, 0, 0}};
  double squared_distance = std::numeric_limits<double>::infinity();
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f);
    const std::array<std::array<double, 3>, 3> corners{relative(complex.source(h)), relative(complex.target(h)),
                                                       relative(complex.target(complex.next(h)))};
    const internal::Nearest_in_triangle found(corners);
    if (found.squared_distance < squared_distance) {
      squared_distance = found.squared_distance;
      nearest = {h, found.coordinates};
    }
  }
  return nearest;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LOCATE_H

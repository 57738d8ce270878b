// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Converts a vector in space to a direction on the surface, at a vertex or in a face. This is computed in doubles; the
// line that begins there is exact for the resulting direction.

#ifndef INTRINSIC_TRIANGULATIONS_PYTHON_TANGENT_DIRECTION_H
#define INTRINSIC_TRIANGULATIONS_PYTHON_TANGENT_DIRECTION_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

namespace IT = CGAL::Intrinsic_triangulations;

// A direction, and the length of the vector's projection.
struct Tangent_direction
{
  IT::Surface_direction direction;
  double length;
};

// The directions at the vertices and faces of a surface in space.
class Tangent_directions
{
public:
  using Points = std::vector<std::array<double, 3>>;
  using Vector = Eigen::Vector3d;

  // \param unit the exponent of the internal unit, in which products of lengths are doubles
  Tangent_directions(const IT::Delta_complex& complex, const Points& points, int unit)
    : complex_(complex), points_(points), unit_(unit)
  {}

  // In a face: projected to its plane.
  Tangent_direction in_face(const IT::Surface_point& point, const Vector& given) const
  {
    const auto [vector, exponent] = normalized(given);
    const Vector p = edge_vector(point.halfedge), q = -edge_vector(complex_.prev(point.halfedge));
    const Vector normal = p.cross(q);
    const double squared_area = normal.squaredNorm();
    if (!(squared_area > 0))
      throw IT::Invalid_point_error("the face of the point has no area, so that there are no directions in it");
    const Vector projected = vector - normal * (vector.dot(normal) / squared_area);
    // Projected = x p + y q.
    const double x = projected.cross(q).dot(normal) / squared_area, y = p.cross(projected).dot(normal) / squared_area;
    return {{point, {x, y}}, std::ldexp(projected.norm(), exponent)};
  }

  // At a vertex: projected to its tangent plane, together with the edges. Between two neighboring edges, angles in the
  // plane and in the face are proportional; where the surface is flat, they are equal.
  Tangent_direction at_vertex(IT::Vertex_index v, const Vector& given) const
  {
    const auto [vector, exponent] = normalized(given);
    const Vector normal = normal_at(v);
    const Vector projected = in_plane(vector, normal);
    const double length = std::ldexp(projected.norm(), exponent);
    if (!(projected.norm() > 0))
      throw IT::Invalid_point_error("at vertex " + std::to_string(v.idx()) +
                                    ", the direction has no part along the surface");
    std::optional<Tangent_direction> found;
    for_each_halfedge_from(v, [&](IT::Halfedge_index h) {
      if (found || complex_.is_border(h))
        return;
      const Vector first = in_plane(edge_vector(h), normal), last = in_plane(-edge_vector(complex_.prev(h)), normal);
      const double wedge = angle_in_plane(first, last, normal), turn = angle_in_plane(first, projected, normal);
      if (!(turn <= wedge))
        return;
      const double fraction = wedge > 0 ? turn / wedge : 0;
      found = Tangent_direction{turned(h, fraction), length};
    });
    if (!found)
      throw IT::Invalid_point_error("at vertex " + std::to_string(v.idx()) +
                                    ", the direction leads away from the surface");
    return *found;
  }

private:
  // Counterclockwise, and on the border from border to border.
  template <class Visit>
  void for_each_halfedge_from(IT::Vertex_index v, const Visit& visit) const
  {
    if (!complex_.halfedge(v).is_valid())
      return;
    const IT::Halfedge_index first = complex_.opposite(complex_.halfedge(v));
    IT::Halfedge_index h = first;
    do {
      visit(h);
      if (complex_.is_border(h))
        return;
      h = complex_.next_around_source(h);
    } while (h != first);
  }

  static Vector scaled(const Vector& v, int exponent)
  {
    return {std::ldexp(v[0], exponent), std::ldexp(v[1], exponent), std::ldexp(v[2], exponent)};
  }
  // A vector of about 1 and the exponent of the factor that was taken out.
  static std::pair<Vector, int> normalized(const Vector& v)
  {
    const double largest = v.lpNorm<Eigen::Infinity>();
    const int exponent = largest > 0 && std::isfinite(largest) ? std::ilogb(largest) : 0;
    return {scaled(v, -exponent), exponent};
  }

  Vector point(IT::Vertex_index v) const { return scaled(Vector(points_[v.idx()].data()), -unit_); }
  Vector edge_vector(IT::Halfedge_index h) const { return point(complex_.target(h)) - point(complex_.source(h)); }

  static Vector in_plane(const Vector& vector, const Vector& normal) { return vector - normal * vector.dot(normal); }

  // Counterclockwise, from 0 to 2 pi.
  static double angle_in_plane(const Vector& a, const Vector& b, const Vector& normal)
  {
    const double angle = std::atan2(a.cross(b).dot(normal), a.dot(b));
    return angle >= 0 ? angle : angle + 2 * CGAL_PI;
  }

  double corner_angle(IT::Halfedge_index h) const
  {
    const Vector a = edge_vector(h), b = -edge_vector(complex_.prev(h));
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  // The mean of the normals of its faces, weighted by angles.
  Vector normal_at(IT::Vertex_index v) const
  {
    Vector sum = Vector::Zero();
    for_each_halfedge_from(v, [&](IT::Halfedge_index h) {
      if (!complex_.is_border(h))
        sum += edge_vector(h).cross(-edge_vector(complex_.prev(h))).stableNormalized() * corner_angle(h);
    });
    if (!(sum.norm() > 0))
      throw IT::Invalid_point_error("at vertex " + std::to_string(v.idx()) + ", there is no tangent plane");
    return sum.normalized();
  }

  // The direction at this fraction of the corner at the source of a side.
  IT::Surface_direction turned(IT::Halfedge_index h, double fraction) const
  {
    const double corner = corner_angle(h), angle = fraction * corner;
    const double a = edge_vector(h).norm(), b = edge_vector(complex_.prev(h)).norm();
    // With unit vectors along both sides, the direction is their sum with the weights of the law of sines.
    return {{h, {1, 0, 0}}, {std::sin(corner - angle) / a, std::sin(angle) / b}};
  }

  const IT::Delta_complex& complex_;
  const Points& points_;
  int unit_;
};

} // namespace idt_python

#endif // INTRINSIC_TRIANGULATIONS_PYTHON_TANGENT_DIRECTION_H

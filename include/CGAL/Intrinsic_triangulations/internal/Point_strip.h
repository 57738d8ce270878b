// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where an intrinsic edge crosses input edges, from the points of the input: fast, or not at all.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/Strip_layout.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// The layout is that of Edge_layout. Here the corner ratios come straight from the points, and
// there is one bound for the error of all that is computed instead of one for each number:
//
// In double-doubles a corner ratio, divided by its absolute value, is good to 2^-97 whatever the
// shape of the triangle: scalar and cross product are good to 2^-101 of the product of the
// lengths. The direction of a crossed edge is a product of up to m ratios, m the number of
// triangles, and good to m 2^-96; so a position, a sum of directions of total length X, is good
// to m 2^-95 X, and a cross product of two positions, at most Y from the source, to m 2^-93 X Y.
// Positions on the edges are quotients of such cross products.
class Point_strip
{
  using Number = Split_double_double;
  using Vector = std::array<Number, 3>; // exact: a difference of two points
  using Complex = Split_complex;

public:
  // \param points of the input, none further from another than 4, or none at all
  Point_strip(const Delta_complex& input, const Points& points) : input_(input), points_(points) {}

  // Starts the strip of an edge with the first input edge that it crosses, as the halfedge from
  // the left end to the right end.
  void start(Halfedge_index crossed)
  {
    const Halfedge_index right_to_left = input_.opposite(crossed);
    const Vector v = vector(input_.prev(right_to_left)), // from the source to the right end
      left = vector(input_.opposite(input_.next(right_to_left)));
    is_good_ = true;
    vector_ = vector(crossed);
    const Triangle triangle = lay_out(v, left);
    layout_.start(corner_ratio(triangle, v, left, 1), {{1, 0}, {0, 0}});
    direction_ = corner_ratio(triangle, v, vector_, -1);
    extent_ = 1 + modulus(layout_.left()) + modulus(direction_);
    last_ = crossed;
  }

  // Adds the next input edge that is crossed.
  void add(Halfedge_index crossed)
  {
    const bool keeps_left = crossed == input_.opposite(input_.prev(last_));
    const Vector w = vector(crossed);
    direction_ = direction_ * corner_ratio(lay_out(vector_, w), vector_, w, keeps_left ? 1 : -1);
    layout_.add(keeps_left ? layout_.left() + direction_ : layout_.right() - direction_, keeps_left);
    extent_ += modulus(direction_);
    vector_ = w;
    last_ = crossed;
  }

  // As `Strip_layout::finish()`.
  template <class Visit>
  bool finish(const Visit& visit)
  {
    const Vector w = vector(input_.opposite(input_.prev(last_)));
    direction_ = direction_ * corner_ratio(lay_out(vector_, w), vector_, w, 1);
    const Complex target = layout_.left() + direction_;
    extent_ += modulus(direction_);
    const double error = 0x1p-93 * double(layout_.number_of_edges() + 1) * extent_ *
                         (std::max)(layout_.distance(), modulus(target));
    return is_good_ && layout_.finish(target, error, visit);
  }

private:
  // What two sides v and w of a triangle have in common.
  struct Triangle
  {
    Number squared_length; // of v
    double reciprocal;
    Number height; // four times the area over two times the squared length
  };

  Vector vector(Halfedge_index h) const
  {
    const std::array<double, 3>&p = points_[input_.source(h).idx()], &q = points_[input_.target(h).idx()];
    return {Number::difference(q[0], p[0]), Number::difference(q[1], p[1]),
            Number::difference(q[2], p[2])};
  }

  Triangle lay_out(const Vector& v, const Vector& w)
  {
    // Far from underflow; it has to be far for the error bound to hold.
    is_good_ = is_good_ && rough_square(v) > 1e-100 && rough_square(w) > 1e-100;
    const Number s = scalar_product(v, v), n0 = sum(v[1] * w[2], -(v[2] * w[1])),
                 n1 = sum(v[2] * w[0], -(v[0] * w[2])), n2 = sum(v[0] * w[1], -(v[1] * w[0]));
    const double reciprocal = 1 / s.hi;
    return {s, reciprocal,
            quotient(square_root(sum(n0 * n0, n1 * n1, n2 * n2)), s, reciprocal)};
  }

  // w / v as vectors in the plane, where v and w are sides of the triangle; w is to the left of
  // v if the side is 1, else to its right.
  static Complex corner_ratio(const Triangle& t, const Vector& v, const Vector& w, double side)
  {
    return {quotient(scalar_product(v, w), t.squared_length, t.reciprocal),
            {side * t.height.hi, side * t.height.lo}};
  }

  static Number scalar_product(const Vector& v, const Vector& w)
  {
    return sum(v[0] * w[0], v[1] * w[1], v[2] * w[2]);
  }

  static double rough_square(const Vector& v)
  {
    return v[0].hi * v[0].hi + v[1].hi * v[1].hi + v[2].hi * v[2].hi;
  }

  const Delta_complex& input_;
  const Points& points_;
  bool is_good_ = false;
  Halfedge_index last_; // crossed edge, ...
  Vector vector_;       // ... in space, ...
  Complex direction_;   // ... and in the plane
  Strip_layout layout_;
  double extent_ = 0; // at least X
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H

// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where an intrinsic edge crosses input edges, from the points of the input: fast, or not at all.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Split_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/Flat_geometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

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

  struct Complex
  {
    Number x, y;

    friend Complex operator+(const Complex& a, const Complex& b) { return {a.x + b.x, a.y + b.y}; }
    friend Complex operator-(const Complex& a, const Complex& b) { return {a.x - b.x, a.y - b.y}; }
    friend Complex operator*(const Complex& a, const Complex& b)
    {
      return {sum(a.x * b.x, -(a.y * b.y)), sum(a.x * b.y, a.y * b.x)};
    }
    // Positive if b is to the left of a.
    friend Number cross_product(const Complex& a, const Complex& b)
    {
      return sum(a.x * b.y, -(a.y * b.x));
    }
  };

public:
  // \param points of the input, none further from another than 4, or none at all
  Point_strip(const Delta_complex& input, const Points& points) : input_(input), points_(points) {}

  // Starts the strip of an edge with the first input edge that it crosses, as the halfedge from
  // the left end to the right end.
  void start(Halfedge_index crossed)
  {
    ends_.clear();
    const Halfedge_index source_to_right = input_.prev(input_.opposite(crossed));
    const Vector v = vector(source_to_right);
    is_good_ = true;
    vector_ = vector(crossed);
    const Vector left = vector(input_.opposite(input_.next(input_.opposite(crossed))));
    const Complex ratio = corner_ratio(v, left, 1);
    direction_ = corner_ratio(v, vector_, -1);
    ends_.push_back({ratio, {{1, 0}, {0, 0}}});
    distance_ = 1 + modulus(ratio);
    extent_ = distance_ + modulus(direction_);
    last_ = crossed;
  }

  // Adds the next input edge that is crossed.
  void add(Halfedge_index crossed)
  {
    const Ends ends = ends_.back();
    const bool keeps_left = crossed == input_.opposite(input_.prev(last_));
    const Vector w = vector(crossed);
    direction_ = direction_ * corner_ratio(vector_, w, keeps_left ? 1 : -1);
    const Complex apex = keeps_left ? ends.left + direction_ : ends.right - direction_;
    ends_.push_back(keeps_left ? Ends{ends.left, apex} : Ends{apex, ends.right});
    distance_ = (std::max)(distance_, modulus(apex));
    extent_ += modulus(direction_);
    vector_ = w;
    last_ = crossed;
  }

  // Calls `visit(crossing)` for each crossing: which part of the crossed edge lies to
  // the left, and where on the intrinsic edge it is. Both are good to 2^-52.
  // \return whether all are so good; nothing is visited otherwise
  template <class Visit>
  bool finish(const Visit& visit)
  {
    const Vector w = vector(input_.opposite(input_.prev(last_)));
    direction_ = direction_ * corner_ratio(vector_, w, 1);
    const Complex target = ends_.back().left + direction_;
    extent_ += modulus(direction_);
    // Quotients of cross products that are good to 2^-55 are good to 2^-54, before they are rounded.
    const double error = 0x1p-93 * double(ends_.size() + 1) * extent_ *
                         (std::max)(distance_, modulus(target));
    const double enough = 0x1p55 * error;
    crossings_.clear();
    for (const Ends& ends : ends_) {
      const Number left = cross_product(target, ends.left),
                   right = cross_product(ends.right, target),
                   along = cross_product(ends.right, ends.left);
      is_good_ = is_good_ && left.hi >= enough && right.hi >= enough && along.hi >= enough;
      crossings_.push_back({left, right, along});
    }
    if (!is_good_)
      return false;
    for (const Crossing& crossing : crossings_)
      visit(crossing);
    return true;
  }

  struct Crossing
  {
    Number left, right, along;

    double from_left() const { return fraction(left); }
    double from_right() const { return fraction(right); }
    double on_edge() const { return fraction(along); }

  private:
    double fraction(const Number& part) const
    {
      const Number whole = left + right;
      return quotient(part, whole, 1 / whole.hi).hi;
    }
  };

private:
  struct Ends
  {
    Complex left, right;
  };

  Vector vector(Halfedge_index h) const
  {
    const std::array<double, 3>&p = points_[input_.source(h).idx()], &q = points_[input_.target(h).idx()];
    return {Number::difference(q[0], p[0]), Number::difference(q[1], p[1]),
            Number::difference(q[2], p[2])};
  }

  // w / v as vectors in the plane; w is to the left of v if the side is 1, else to its right.
  Complex corner_ratio(const Vector& v, const Vector& w, double side)
  {
    // Far from underflow; it has to be far for the error bound to hold.
    is_good_ = is_good_ && rough_square(v) > 1e-100 && rough_square(w) > 1e-100;
    const Number s = scalar_product(v, v), x = scalar_product(v, w),
                 n0 = sum(v[1] * w[2], -(v[2] * w[1])), n1 = sum(v[2] * w[0], -(v[0] * w[2])),
                 n2 = sum(v[0] * w[1], -(v[1] * w[0])),
                 a = square_root(sum(n0 * n0, n1 * n1, n2 * n2));
    const double reciprocal = 1 / s.hi;
    const Number y = quotient(a, s, reciprocal);
    return {quotient(x, s, reciprocal), {side * y.hi, side * y.lo}};
  }

  static Number scalar_product(const Vector& v, const Vector& w)
  {
    return sum(v[0] * w[0], v[1] * w[1], v[2] * w[2]);
  }

  static double rough_square(const Vector& v)
  {
    return v[0].hi * v[0].hi + v[1].hi * v[1].hi + v[2].hi * v[2].hi;
  }

  // An upper bound.
  static double modulus(const Complex& z) { return 1.5 * (std::abs(z.x.hi) + std::abs(z.y.hi)); }

  const Delta_complex& input_;
  const Points& points_;
  bool is_good_ = false;
  Halfedge_index last_;
  Vector vector_;     // of the last crossed edge in space ...
  Complex direction_; // ... and in the plane
  double extent_ = 0;   // at least X
  double distance_ = 0; // at least Y, without the target
  std::vector<Ends> ends_; // of the crossed edges
  std::vector<Crossing> crossings_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_POINT_STRIP_H

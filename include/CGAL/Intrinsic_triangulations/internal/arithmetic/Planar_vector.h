// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers over any ring.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsMetric
/// \brief a complex number, or a vector in a plane, over a ring.
template <class Real>
class Planar_vector
{
public:
  /// constructs x + i y.
  Planar_vector(const Real& x, const Real& y) : x_(x), y_(y) {}

  /// returns the real part.
  const Real& x() const { return x_; }
  /// returns the imaginary part.
  const Real& y() const { return y_; }

  /// returns the product of complex numbers.
  friend Planar_vector operator*(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x_ * b.x_ - a.y_ * b.y_, a.x_ * b.y_ + a.y_ * b.x_};
  }
  /// returns the sum.
  friend Planar_vector operator+(const Planar_vector& a, const Planar_vector& b) { return {a.x_ + b.x_, a.y_ + b.y_}; }
  /// returns the difference.
  friend Planar_vector operator-(const Planar_vector& a, const Planar_vector& b) { return {a.x_ - b.x_, a.y_ - b.y_}; }
  /// returns `a` times the conjugate of `b`.
  friend Planar_vector times_conjugate(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x_ * b.x_ + a.y_ * b.y_, a.y_ * b.x_ - a.x_ * b.y_};
  }
  /// returns the quotient by a real number.
  friend Planar_vector operator/(const Planar_vector& a, const Real& b) { return {a.x_ / b, a.y_ / b}; }
  /// returns the squared absolute value.
  friend Real squared_norm(const Planar_vector& a) { return a.x_ * a.x_ + a.y_ * a.y_; }

private:
  Real x_;
  Real y_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H

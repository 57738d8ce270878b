// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Complex numbers over any ring.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H

namespace CGAL::Intrinsic_triangulations {

// A complex number: a vector in the plane whose coordinates may be of any number type.
template <class Real>
class Planar_vector
{
public:
  Planar_vector(const Real& x, const Real& y) : x_(x), y_(y) {}

  const Real& x() const { return x_; }
  const Real& y() const { return y_; }

  friend Planar_vector operator*(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x_ * b.x_ - a.y_ * b.y_, a.x_ * b.y_ + a.y_ * b.x_};
  }
  friend Planar_vector operator+(const Planar_vector& a, const Planar_vector& b) { return {a.x_ + b.x_, a.y_ + b.y_}; }
  friend Planar_vector operator-(const Planar_vector& a, const Planar_vector& b) { return {a.x_ - b.x_, a.y_ - b.y_}; }
  friend Planar_vector times_conjugate(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x_ * b.x_ + a.y_ * b.y_, a.y_ * b.x_ - a.x_ * b.y_};
  }
  friend Planar_vector operator/(const Planar_vector& a, const Real& b) { return {a.x_ / b, a.y_ / b}; }
  friend Real squared_norm(const Planar_vector& a) { return a.x_ * a.x_ + a.y_ * a.y_; }

private:
  Real x_;
  Real y_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ARITHMETIC_PLANAR_VECTOR_H

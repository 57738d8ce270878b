// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Complex numbers over any ring.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_PLANAR_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_PLANAR_VECTOR_H

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsCorrespondence
/// \brief a complex number, or a vector in a plane, over a ring.
template <class Real>
struct Planar_vector
{
  Real x; ///< real part
  Real y; ///< imaginary part

  /// returns the product of complex numbers.
  friend Planar_vector operator*(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
  /// returns the sum.
  friend Planar_vector operator+(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x + b.x, a.y + b.y};
  }
  /// returns the difference.
  friend Planar_vector operator-(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x - b.x, a.y - b.y};
  }
  /// returns `a` times the conjugate of `b`.
  friend Planar_vector times_conjugate(const Planar_vector& a, const Planar_vector& b)
  {
    return {a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y};
  }
  /// returns the squared absolute value.
  friend Real squared_norm(const Planar_vector& a) { return a.x * a.x + a.y * a.y; }
};

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_PLANAR_VECTOR_H

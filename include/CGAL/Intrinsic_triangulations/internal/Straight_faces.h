// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which faces of the current triangulation are triangles in space.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/Bounded_double_double.h>
#include <CGAL/Intrinsic_triangulations/internal/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/Rational.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// A face is known to be straight if it is the flat triangle in space between its corners:
// at first all are, and the two faces of a flip are if those before were and lie in one
// plane, one beyond the other. Then lengths and angles come from three points, however
// many input edges are crossed. In the flat parts of a model, where ties are, this is what
// keeps the exact stages cheap.
class Straight_faces
{
public:
  using Points = Large_vector<std::array<double, 3>>;
  using Real = Bounded_double_double;
  template <class FT>
  using Vector = std::array<FT, 3>;

  Straight_faces() = default;
  Straight_faces(std::size_t number_of_faces, std::size_t number_of_points)
    : is_straight_(number_of_faces, number_of_points != 0)
  {}

  bool operator()(Face_index f) const { return is_straight_[f.idx()] != 0; }

  // To be called before the flip of the connectivity.
  void flip(const Delta_complex& complex, const Points& points, Edge_index e)
  {
    const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
    std::uint8_t &first = is_straight_[complex.face(h).idx()],
                 &second = is_straight_[complex.face(g).idx()];
    if (first && second && is_flat(complex, points, h))
      return;
    first = second = 0;
  }

  // The difference of two points: exact as a rational, nearly so as a double-double.
  template <class FT>
  static Vector<FT> difference(const Points& points, Vertex_index from, Vertex_index to)
  {
    Vector<FT> result;
    for (int i = 0; i < 3; ++i)
      result[i] = difference(points[to.idx()][i], points[from.idx()][i], FT());
    return result;
  }

  template <class FT>
  static FT product(const Vector<FT>& a, const Vector<FT>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  template <class FT>
  static Vector<FT> cross_product(const Vector<FT>& a, const Vector<FT>& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

private:
  static Real difference(double a, double b, const Real&) { return Real::difference(a, b); }
  static Rational difference(double a, double b, const Rational&)
  {
    return Rational(a) - Rational(b);
  }

  // Whether the faces of an edge lie in one plane, on different sides of the edge. The
  // answer `false` is always safe.
  static bool is_flat(const Delta_complex& complex, const Points& points, Halfedge_index ij)
  {
    const Halfedge_index ji = complex.opposite(ij);
    const Vertex_index i = complex.source(ij), j = complex.target(ij),
                       k = complex.target(complex.next(ij)), l = complex.target(complex.next(ji));
    if (is_clearly_bent(points[i.idx()], points[j.idx()], points[k.idx()], points[l.idx()]))
      return false;
    const auto ij_vector = difference<Real>(points, i, j), ik = difference<Real>(points, i, k),
               il = difference<Real>(points, i, l);
    const auto above = cross_product(ij_vector, ik);
    const Uncertain<Sign> volume = product(above, il).sign();
    if (!possibly(volume == ZERO) ||
        !certainly(product(above, cross_product(il, ij_vector)).sign() == POSITIVE))
      return false;
    return is_certain(volume) ||
           product(cross_product(difference<Rational>(points, i, j),
                                 difference<Rational>(points, i, k)),
                   difference<Rational>(points, i, l)) == 0;
  }

  // A volume far above its rounding errors, which are less than 2^-48 of the product of
  // the sums of the absolute values.
  static bool is_clearly_bent(const std::array<double, 3>& p, const std::array<double, 3>& q,
                              const std::array<double, 3>& r, const std::array<double, 3>& s)
  {
    Vector<double> a, b, c;
    for (int i = 0; i < 3; ++i) {
      a[i] = q[i] - p[i];
      b[i] = r[i] - p[i];
      c[i] = s[i] - p[i];
    }
    const auto sum = [](const Vector<double>& v) {
      return std::abs(v[0]) + std::abs(v[1]) + std::abs(v[2]);
    };
    return std::abs(product(cross_product(a, b), c)) > 0x1p-48 * sum(a) * sum(b) * sum(c) + 1e-290;
  }

  Large_vector<std::uint8_t> is_straight_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_STRAIGHT_FACES_H

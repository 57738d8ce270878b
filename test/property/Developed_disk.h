// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A disk without vertices inside, laid out in the plane with 20,000 bits: a reference for Delaunay tests
// that shares nothing with the tested ones.

#ifndef IDT_TEST_PROPERTY_DEVELOPED_DISK_H
#define IDT_TEST_PROPERTY_DEVELOPED_DISK_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <CGAL/enum.h>

#include <boost/multiprecision/mpfr.hpp>

#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace developed_disk {

namespace IT = CGAL::Intrinsic_triangulations;
using Rational = IT::Rational;
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<6021>,
                                           boost::multiprecision::et_off>; // decimal digits

// Each triangle is placed at a side of an earlier one, by the distances of its third vertex from both ends. Delaunay
// tests are made on the positions, in high precision.
class Developed_disk
{
public:
  Developed_disk(const IT::Delta_complex& complex, const std::vector<Rational>& squared_lengths)
    : positions_(complex.number_of_vertices()), is_placed_(complex.number_of_vertices())
  {
    const auto square = [&](IT::Halfedge_index h) {
      return Real(numerator(squared_lengths[complex.edge(h).idx()])) /
             Real(denominator(squared_lengths[complex.edge(h).idx()]));
    };
    const IT::Halfedge_index first = complex.halfedge(*complex.faces().begin());
    place(complex.source(first), {Real(0), Real(0)});
    place(complex.target(first), {sqrt(square(first)), Real(0)});
    std::vector<IT::Halfedge_index> sides{first}; // the triangle to the left of each is to be placed
    if (!complex.is_border(complex.opposite(first)))
      sides.push_back(complex.opposite(first));
    while (!sides.empty()) {
      const IT::Halfedge_index side = sides.back();
      sides.pop_back();
      const IT::Halfedge_index next = complex.next(side), prev = complex.prev(side);
      const Vector p = position(complex.source(side)), q = position(complex.target(side));
      const Real s = square(side);
      const Real along = (s + square(prev) - square(next)) / (2 * s);
      const Real across = sqrt(square(prev) / s - along * along);
      place(complex.target(next), {p[0] + along * (q[0] - p[0]) - across * (q[1] - p[1]),
                                   p[1] + along * (q[1] - p[1]) + across * (q[0] - p[0])});
      for (IT::Halfedge_index h : {next, prev})
        if (!complex.is_border(complex.opposite(h)))
          sides.push_back(complex.opposite(h));
    }
  }

  // The sum of the cotangents of the angles at k, left of the segment from i to j, and l, right of it.
  CGAL::Sign sign_of_cotangents(IT::Vertex_index i, IT::Vertex_index j, IT::Vertex_index k, IT::Vertex_index l) const
  {
    const Real sum = cotangent(k, i, j) + cotangent(l, j, i);
    // Rounding errors are far below this, and the tested values are far above it, or exactly zero.
    const Real smallest = ldexp(Real(1), -15000);
    return sum > smallest ? CGAL::POSITIVE : sum < -smallest ? CGAL::NEGATIVE : CGAL::ZERO;
  }

private:
  using Vector = std::array<Real, 2>;

  const Vector& position(IT::Vertex_index v) const { return positions_[v.idx()]; }

  void place(IT::Vertex_index v, const Vector& position)
  {
    if (is_placed_[v.idx()])
      throw std::logic_error("a vertex lies inside of the surface");
    is_placed_[v.idx()] = true;
    positions_[v.idx()] = position;
  }

  // The angle at `apex` runs counterclockwise from the direction of `from` to the direction of `to`.
  Real cotangent(IT::Vertex_index apex, IT::Vertex_index from, IT::Vertex_index to) const
  {
    const Vector &o = position(apex), &a = position(from), &b = position(to);
    const Vector u{a[0] - o[0], a[1] - o[1]}, v{b[0] - o[0], b[1] - o[1]};
    const Real area = u[0] * v[1] - u[1] * v[0];
    if (area <= 0)
      throw std::logic_error("a hinge is laid out with the wrong orientation");
    return (u[0] * v[0] + u[1] * v[1]) / area;
  }

  std::vector<Vector> positions_;
  std::vector<bool> is_placed_;
};

} // namespace developed_disk

#endif // IDT_TEST_PROPERTY_DEVELOPED_DISK_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/sharp_edges.h"

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Vector = std::array<double, 3>;

// In units of the largest coordinate, lest squares overflow or vanish.
Vector normalized(Vector v)
{
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest > 0)
    for (double& x : v)
      x /= largest;
  return v;
}

Vector side(const Surface& surface, IT::Halfedge_index h)
{
  const Vector &p = surface.points[surface.connectivity.source(h).idx()], &q = surface.points[surface.connectivity.target(h).idx()];
  return normalized({q[0] / 2 - p[0] / 2, q[1] / 2 - p[1] / 2, q[2] / 2 - p[2] / 2});
}

Vector cross_product(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double scalar_product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector normal(const Surface& surface, IT::Face_index f)
{
  const IT::Halfedge_index h = surface.connectivity.halfedge(f);
  return normalized(cross_product(side(surface, h), side(surface, surface.connectivity.next(h))));
}

} // namespace

std::vector<bool> sharp_edges(const Surface& surface, double degrees)
{
  const IT::Delta_complex& complex = surface.connectivity;
  std::vector<bool> result(complex.number_of_edges());
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_border(e))
      continue;
    const IT::Halfedge_index h = complex.halfedge(e);
    const Vector m = normal(surface, complex.face(h)), n = normal(surface, complex.face(complex.opposite(h)));
    const Vector across = cross_product(m, n);
    result[e.idx()] = std::atan2(std::sqrt(scalar_product(across, across)), scalar_product(m, n)) > degrees * (CGAL_PI / 180);
  }
  return result;
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A custom number type: numbers that carry a derivative along. With it the lengths of the intrinsic Delaunay
// triangulation say how they change when a vertex of the mesh is moved.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

struct Dual
{
  double value, derivative;
  Dual(double x = 0, double d = 0) : value(x), derivative(d) {}
  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.derivative + b.derivative}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.derivative - b.derivative}; }
  friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.derivative * b.value + a.value * b.derivative}; }
  friend Dual operator/(Dual a, Dual b)
  {
    return {a.value / b.value, (a.derivative - a.value / b.value * b.derivative) / b.value};
  }
  friend bool operator==(Dual a, Dual b) { return a.value == b.value; }
  friend bool operator<(Dual a, Dual b) { return a.value < b.value; }
  friend bool operator>(Dual a, Dual b) { return b < a; }
  friend bool operator>=(Dual a, Dual b) { return !(a < b); }
};

// What CGAL has to know about a number type.
namespace CGAL {
template <>
class Algebraic_structure_traits<Dual> : public Algebraic_structure_traits_base<Dual, Field_with_sqrt_tag>
{
public:
  using Is_exact = Tag_false;
  struct Sqrt : cpp98::unary_function<Dual, Dual>
  {
    Dual operator()(Dual x) const
    {
      const double root = std::sqrt(x.value);
      return {root, x.derivative / (2 * root)};
    }
  };
};
template <>
class Real_embeddable_traits<Dual> : public INTERN_RET::Real_embeddable_traits_base<Dual, Tag_true>
{
public:
  struct To_double : cpp98::unary_function<Dual, double>
  {
    double operator()(Dual x) const { return x.value; }
  };
  struct To_interval : cpp98::unary_function<Dual, std::pair<double, double>>
  {
    std::pair<double, double> operator()(Dual x) const { return {x.value, x.value}; }
  };
};
} // namespace CGAL

// The triangulation when vertex 0 lies higher by `step`.
auto triangulation_of(const samples::Indexed_triangles& surface, double step)
{
  std::vector<IT::Edge_length_traits<Dual>::Point_data> points;
  for (const auto& p : surface.points)
    points.push_back({Dual(p[0]), Dual(p[1]), Dual(p[2])});
  points[0][2] = Dual(points[0][2].value + step, 1); // the derivative is that by this coordinate
  IT::Intrinsic_triangulation<IT::Edge_length_traits<Dual>> result(
    IT::make_Delta_complex_from_triangles(points.size(), surface.triangles), points);
  IT::flip_to_Delaunay(result);
  return result;
}

int main()
{
  const samples::Indexed_triangles surface = samples::bumpy_sphere(20, 11);
  const double step = 1e-6;
  const auto idt = triangulation_of(surface, 0), moved = triangulation_of(surface, step);
  double largest = 0, error = 0;
  for (IT::Edge_index e : idt.connectivity().edges()) {
    const double derivative = idt.length(e).derivative,
                 difference = (moved.length(e).value - idt.length(e).value) / step;
    largest = (std::max)(largest, std::abs(derivative));
    error = (std::max)(error, std::abs(derivative - difference));
  }
  std::cout << "largest derivative " << largest << ", from difference quotients " << error << '\n';
  return largest > 0.1 && error < 1e-4 ? EXIT_SUCCESS : EXIT_FAILURE;
}

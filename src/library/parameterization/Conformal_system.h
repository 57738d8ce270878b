// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The ideal Delaunay triangulation for given scale factors, its angles, and the linear model around it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H

#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include "Conformal_targets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The largest minus the smallest.
inline double range_of(const std::vector<double>& x)
{
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  return x.empty() ? 0 : *most - *least;
}

// The angles opposite to the sides, half their cotangents, and the area. With a >= b >= c, a - b is exact if there is a
// triangle, so sums and differences of sides are rounded at most twice, and the tangent of half an angle is known to 10
// units in the last place; with the error of the arc tangent, an angle is known to 2^-49 (Kahan, "Miscalculating area
// and angles of a needle-like triangle"). Where rounding makes a side longer than the sum of the others, its angle is
// π.
struct Measured_triangle
{
  explicit Measured_triangle(const std::array<double, 3>& sides)
  {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return sides[i] > sides[j]; });
    const double a = sides[order[0]], b = sides[order[1]], c = sides[order[2]], s = a + (b + c);
    std::array<double, 3> t; // the sum of the other sides minus this one
    t[order[0]] = (std::max)(c - (a - b), 0.);
    t[order[1]] = c + (a - b);
    t[order[2]] = a + (b - c);
    is_triangle = c >= a - b;
    const double root = std::sqrt(s);
    const std::array<double, 3> roots{std::sqrt(t[0]), std::sqrt(t[1]), std::sqrt(t[2])};
    area = root * roots[0] * roots[1] * roots[2] / 4;
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = roots[(i + 1) % 3] * roots[(i + 2) % 3], y = root * roots[i]; // x / y = tan of half the angle
      angles[i] = 2 * std::atan2(x, y);
      constexpr double most = 1e10;
      half_cotangents[i] =
        x * y > 0 ? (std::max)(-most, (std::min)((y - x) * (y + x) / (4 * x * y), most)) : (x > 0 ? -most : most);
    }
  }
  std::array<double, 3> angles, half_cotangents;
  double area;
  bool is_triangle;
};

// Notes the flips, and ends a run as soon as a length has an error bound of 2^-40 of itself.
template <class Triangulation>
struct Flip_recorder
{
  const Triangulation& triangulation;
  const Progress_function& progress;
  std::vector<Edge_index>& flips;
  bool is_rounded = false;

  bool go_further(const Progress&) const { return !is_rounded && (!progress || progress(0.5)); }
  void after_flip(Edge_index e)
  {
    flips.push_back(e);
    is_rounded = is_rounded || triangulation.edge_data(e).relative_error > 0x1p-40;
  }
};

// The variables are the values of u at the vertices of the surface; the copies of a vertex share one. Sums of angles
// and derivatives refer to the double.
class Conformal_system
{
public:
  Conformal_system(const Doubled_surface& doubled, std::size_t number_of_vertices, const Conformal_options& options,
                   const Factorize& factorize)
    : doubled_(doubled), complex_(doubled.triangulation.connectivity()), lengths_(doubled.lengths), options_(options),
      factorize_(factorize), sums_(number_of_vertices)
  {}

  // Flips to the ideal Delaunay triangulation with scaled lengths; finds sums of angles and the weights of the linear
  // model.
  // \exception Numerical_error if a length leaves the range of double
  void evaluate(const std::vector<double>& u)
  {
    flip(u);
    measure();
  }

  // The ideal Delaunay triangulation of the last evaluation, the flips that led to it, and its lengths.
  const Delta_complex& complex() const { return complex_; }
  const std::vector<Edge_index>& flips() const { return flips_; }
  const std::vector<double>& lengths() const { return scaled_; }

  // By how much the sum of angles at a vertex, of all its copies, is too large.
  double excess(std::size_t v, const Conformal_targets& targets) const
  {
    return targets.has_angle(v) ? sums_[v] - doubled_.factor() * targets.angle(v) : 0;
  }
  double sum_of_angles(std::size_t v) const { return sums_[v]; }
  // A proven bound on all differences between the wanted sum of angles at a copy of a vertex and the one for exactly
  // the lengths of the last evaluation.
  double residual(const Conformal_targets& targets) const
  {
    std::vector<int> copies(sums_.size(), 0);
    for (Vertex_index v : complex_.vertices())
      ++copies[vertex(v)];
    double result = 0;
    for (Vertex_index v : complex_.vertices())
      if (const std::size_t w = vertex(v); targets.has_angle(w)) {
        const double wanted = targets.given_angle(w) * (copies[w] == 1 ? factor() : 1);
        const auto& [sum, error] = corners_[v.idx()];
        // Sums beyond 8 are rounded by more, and π is rounded, too.
        result =
          (std::max)({result, (std::abs(sum - wanted) + error * (std::max)(1., sum / 8)) * (1 + 0x1p-50) + 0x1p-50});
      }
    return result;
  }

  // The derivative of the excess by u.
  double sensitivity(std::size_t v) const { return sensitivities_[v]; }
  double factor() const { return doubled_.factor(); }
  // The area of a component, with both copies, in the scale of the last evaluation.
  double area(const Conformal_targets& targets, std::size_t component) const
  {
    double result = 0;
    for (std::size_t v : targets.components()[component].vertices)
      result += areas_[v];
    return result;
  }

  // Factorizes the linear model. Only vertices with a wanted angle are variable, except for pins.
  // \exception Numerical_error as `Factorize`
  void factorize(const Conformal_targets& targets)
  {
    std::vector<Weighted_pair> pairs;
    pairs.reserve(sums_.size() + pairs_.size());
    is_fixed_.resize(sums_.size());
    for (std::size_t v = 0; v < sums_.size(); ++v) {
      is_fixed_[v] = !targets.has_angle(v) || targets.component_of(v).is_pin(v);
      if (is_fixed_[v])
        pairs.push_back({int(v), -1, 1});
    }
    const auto variable = [this](int v) { return is_fixed_[std::size_t(v)] ? -1 : v; };
    for (const auto& [i, j, weight] : pairs_)
      pairs.push_back({variable(i), variable(j), weight});
    solve_ = factorize_(int(sums_.size()), pairs);
  }

  // Solves the linear model; zero for the other vertices. \pre it was factorized
  std::vector<double> solve(std::vector<double> right) const
  {
    for (std::size_t v = 0; v < right.size(); ++v)
      if (is_fixed_[v])
        right[v] = 0;
    return solve_(right);
  }

  // As `solve()`, by conjugate gradients with a relative error in energy of at most `precision`, or 10^-4 if that is
  // larger. Nothing if the last factorization is too far from the present model.
  std::optional<std::vector<double>> solve_by_last_factors(const std::vector<double>& right, double precision) const
  {
    constexpr int as_slow_as_factorization = 8;
    const auto dot = [](const std::vector<double>& x, const std::vector<double>& y) {
      return std::inner_product(x.begin(), x.end(), y.begin(), 0.);
    };
    std::vector<double> result(right.size(), 0.), left = right, direction = solve(left);
    const double first = dot(left, direction);
    double energy = first;
    precision = (std::min)(0.1, (std::max)(precision, 1e-4));
    for (int i = 0; i < as_slow_as_factorization; ++i) {
      const std::vector<double> image = product(direction);
      const double factor = energy / dot(direction, image);
      for (std::size_t v = 0; v < left.size(); ++v) {
        result[v] += factor * direction[v];
        left[v] -= factor * image[v];
      }
      const std::vector<double> correction = solve(left);
      const double last = energy;
      energy = dot(left, correction);
      if (energy <= precision * precision * first)
        return result;
      for (std::size_t v = 0; v < left.size(); ++v)
        direction[v] = correction[v] + energy / last * direction[v];
    }
    return std::nullopt;
  }

  // Minus the change of the excesses for a small change of u.
  std::vector<double> product(const std::vector<double>& u) const
  {
    std::vector<double> result(u.size(), 0.);
    for (const auto& [i, j, weight] : pairs_) {
      const double flow = weight * (u[std::size_t(i)] - u[std::size_t(j)]);
      result[std::size_t(i)] += flow;
      result[std::size_t(j)] -= flow;
    }
    return result;
  }

private:
  std::size_t vertex(Vertex_index v) const { return doubled_.vertices[v.idx()].idx(); }
  double scale(Edge_index e, const std::vector<double>& scales) const
  {
    const Halfedge_index h = complex_.halfedge(e);
    return scales[vertex(complex_.source(h))] * scales[vertex(complex_.target(h))];
  }

  void scale_lengths(const std::vector<double>& scales)
  {
    scaled_.resize(lengths_.size());
    for (Edge_index e : complex_.edges()) {
      scaled_[e.idx()] = lengths_[e.idx()] * scale(e, scales);
      if (!(scaled_[e.idx()] > 0x1p-900 && scaled_[e.idx()] < 0x1p900)) // products of roots remain normal
        throw Numerical_error("lengths leave the range of double");
    }
  }

  // Decisions are exact for the doubles with which a run begins. In long chains of flips, the bounds on the errors of
  // lengths become too large to be useful; then the lengths are rounded, and another run begins.
  void flip(const std::vector<double>& u)
  {
    using Triangulation = Intrinsic_triangulation<Ptolemy_traits<double>>;
    std::vector<double> scales; // of ends of edges
    for (double x : u)
      scales.push_back(std::exp(x / 2));
    for (bool is_settled = false; !is_settled;) {
      scale_lengths(scales);
      Triangulation triangulation = Triangulation::from_lengths(complex_, scaled_);
      const std::size_t before = flips_.size();
      Flip_recorder<Triangulation> recorder{triangulation, options_.progress, flips_};
      try {
        flip_to_Delaunay(triangulation, parameters::visitor(std::ref(recorder)));
        is_settled = true;
      } catch (const Cancelled_error&) {
        if (!recorder.is_rounded)
          throw;
      }
      complex_ = triangulation.connectivity();
      for (std::size_t i = before; i < flips_.size(); ++i) {
        const Edge_index e = flips_[i];
        lengths_[e.idx()] = triangulation.length(e) / scale(e, scales);
        scaled_[e.idx()] = lengths_[e.idx()] * scale(e, scales);
      }
    }
  }

  void measure()
  {
    std::fill(sums_.begin(), sums_.end(), 0.);
    corners_.assign(complex_.number_of_vertices(), {});
    areas_.assign(sums_.size(), 0.);
    sensitivities_ = areas_;
    std::vector<double> weights(complex_.number_of_edges(), 0.);
    for (Face_index f : complex_.faces()) {
      const Halfedge_index h = complex_.halfedge(f);
      const std::array<Halfedge_index, 3> sides{h, complex_.next(h), complex_.prev(h)};
      std::array<double, 3> of_sides;
      for (std::size_t i = 0; i < 3; ++i)
        of_sides[i] = scaled_[complex_.edge(sides[i]).idx()];
      const Measured_triangle triangle(of_sides);
      for (std::size_t i = 0; i < 3; ++i) {
        const Vertex_index corner = complex_.target(complex_.next(sides[i]));
        const std::size_t v = vertex(corner);
        corners_[corner.idx()] +=
          {triangle.angles[i], triangle.is_triangle ? 0x1p-49 : std::numeric_limits<double>::infinity()};
        sums_[v] += triangle.angles[i];
        areas_[v] += triangle.area / 3;
        weights[complex_.edge(sides[i]).idx()] += triangle.half_cotangents[i];
      }
    }
    pairs_.clear();
    for (Edge_index e : complex_.edges()) {
      const Halfedge_index h = complex_.halfedge(e);
      const std::size_t i = vertex(complex_.source(h)), j = vertex(complex_.target(h));
      if (i != j) { // the derivatives of a loop cancel, and so do those of an edge between the copies of a vertex
        const double weight = (std::max)(weights[e.idx()], 0.);
        pairs_.push_back({int(i), int(j), weight});
        sensitivities_[i] += weight;
        sensitivities_[j] += weight;
      }
    }
  }

  const Doubled_surface& doubled_;
  Delta_complex complex_;
  std::vector<double> lengths_, scaled_; // scaled by the u of the last evaluation
  std::vector<Edge_index> flips_;
  const Conformal_options& options_;
  const Factorize& factorize_;
  std::vector<Bounded_angle> corners_; // the sums of angles at the vertices of the double
  std::vector<double> sums_, sensitivities_,
    areas_; // for each vertex of the surface, a third of the area of each face at it
  std::vector<Weighted_pair> pairs_;
  std::vector<bool> is_fixed_; // in the linear model
  Solve solve_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The ideal Delaunay triangulation for given scale factors, its angles, and the linear model around it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H

#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Angle_sum.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include "Conformal_targets.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The variables are the values of u at the vertices of the surface; the copies of a vertex share one. Sums of angles, and
// derivatives, are those of the double.
class Conformal_system
{
public:
  Conformal_system(const Doubled_surface& doubled, std::size_t number_of_vertices, const Conformal_options& options,
                   const Factorize& factorize)
    : doubled_(doubled), complex_(doubled.triangulation.connectivity()), lengths_(doubled.lengths), options_(options),
      factorize_(factorize), sums_(number_of_vertices)
  {}

  // Flips to the ideal Delaunay triangulation with scaled lengths; finds sums of angles and the weights of the linear model.
  // \exception Numerical_error if a length leaves the range of double
  void evaluate(const std::vector<double>& u);

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
  // Proven: a bound of all differences between the sum of the angles at a copy of a vertex, with exactly the lengths of the
  // last evaluation, and the wanted one.
  double residual(const Conformal_targets& targets) const;
  // The derivative of the excess by u.
  double sensitivity(std::size_t v) const { return sensitivities_[v]; }
  double factor() const { return doubled_.factor(); }
  // The area of a component, of both copies, and by the scale of the last evaluation.
  double area(const Conformal_targets& targets, std::size_t component) const;

  // Factorizes the linear model. Only vertices with a wanted angle are variable, except for pins.
  // \exception Numerical_error as `Factorize`
  void factorize(const Conformal_targets& targets);
  // Solves the linear model; zero for the other vertices. \pre it was factorized
  std::vector<double> solve(std::vector<double> right) const;
  // By conjugate gradients, with a relative error in energy of at most `precision`, or of 10^-4 if that is more: null if the
  // last factorization is too far from the present model.
  std::optional<std::vector<double>> solve_by_last_factors(const std::vector<double>& right, double precision) const;
  // The change of the excesses, times -1, that a small change of u makes.
  std::vector<double> product(const std::vector<double>& u) const;

private:
  std::size_t vertex(Vertex_index v) const { return doubled_.vertices[v.idx()].idx(); }
  static std::vector<double> scales_of(const std::vector<double>& u);
  double scale(Edge_index e, const std::vector<double>& scales) const;
  void scale_lengths(const std::vector<double>& scales);
  void flip(const std::vector<double>& u);
  void measure();

  const Doubled_surface& doubled_;
  Delta_complex complex_;
  std::vector<double> lengths_, scaled_; // scaled by the u of the last evaluation
  std::vector<Edge_index> flips_;
  const Conformal_options& options_;
  const Factorize& factorize_;
  std::vector<Bounded_angle> corners_; // the sums of angles at the vertices of the double
  std::vector<double> sums_, sensitivities_,
    areas_; // of the vertices of the surface; of a face, a third is at each corner
  std::vector<Weighted_pair> pairs_;
  std::vector<bool> is_fixed_; // in the linear model
  Solve solve_;
};

// The largest minus the smallest.
double range_of(const std::vector<double>& x);

// With three digits.
std::string shown(double x);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONFORMAL_SYSTEM_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of conformal_solver.h: Newton's method, and the proof of its result.

#include <CGAL/Intrinsic_triangulations/internal/parameterization/conformal_solver.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include "Conformal_system.h"
#include "Conformal_targets.h"
#include "Cone_chooser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr double tolerable_error = 1e-10;
constexpr int maximum_number_of_steps = 100;

std::vector<double> lengths_of_border(const Doubled_surface::Triangulation& surface)
{
  std::vector<double> result;
  for (Edge_index e : surface.connectivity().edges())
    result.push_back(surface.connectivity().is_border(e) ? surface.length(e) : 0);
  return result;
}

class Conformal_solver
{
public:
  Conformal_solver(const Doubled_surface::Triangulation& surface, const Doubled_surface& doubled,
                   const Conformal_options& options, const Factorize& factorize)
    : doubled_(doubled), options_(options), targets_(surface.connectivity(), lengths_of_border(surface), options),
      system_(doubled, surface.connectivity().number_of_vertices(), options, factorize),
      u_(surface.connectivity().number_of_vertices(), 0.)
  {}

  Discrete_conformal_metric run()
  {
    evaluate();
    std::vector<double> areas;
    for (std::size_t i = 0; i < targets_.components().size(); ++i)
      areas.push_back(system_.area(targets_, i));
    choose_cones();
    targets_.check_sums();
    minimize();
    bool is_scaled = false;
    for (std::size_t i = 0; i < areas.size(); ++i)
      if (!targets_.components()[i].keeps_scale && areas[i] > 0) {
        is_scaled = true;
        const double factor = areas[i] / system_.area(targets_, i);
        for (std::size_t v : targets_.components()[i].vertices)
          u_[v] += 0.5 * std::log(factor);
      }
    if (is_scaled)
      evaluate();
    std::vector<double> cone_angles;
    for (Vertex_index v : targets_.cones())
      cone_angles.push_back(system_.sum_of_angles(v.idx()) / system_.factor());
    return {u_,
            targets_.cones(),
            cone_angles,
            system_.residual(targets_),
            range_of(u_),
            steps_,
            system_.complex(),
            system_.lengths(),
            doubled_.vertices,
            doubled_.halfedges,
            system_.flips()};
  }

private:
  void evaluate()
  {
    try {
      system_.evaluate(u_);
    } catch (const Numerical_error& error) {
      throw_not_converged(error.what());
    }
  }

  void choose_cones()
  {
    const bool is_given = !options_.number_of_cones && !targets_.cones().empty();
    if (is_given || (options_.number_of_cones && *options_.number_of_cones == 0))
      return;
    try {
      system_.factorize(targets_);
      Cone_chooser(system_, targets_, options_).run();
    } catch (const Numerical_error& error) {
      throw_not_converged(error.what());
    }
  }

  std::size_t worst_vertex() const
  {
    std::size_t worst = 0;
    for (std::size_t v = 0; v < u_.size(); ++v)
      if (std::abs(system_.excess(v, targets_)) > std::abs(system_.excess(worst, targets_)))
        worst = v;
    return worst;
  }
  // Whether the excesses are as small as rounded lengths allow. What a pin has is the sum of all rounding.
  bool is_sufficient() const
  {
    for (std::size_t v = 0; v < u_.size(); ++v)
      if (!(std::abs(system_.excess(v, targets_)) <=
            (targets_.component_of(v).is_pin(v)
               ? tolerable_error
               : (std::min)(1e-12 + 0x1p-51 * system_.sensitivity(v), tolerable_error))))
        return false;
    return true;
  }
  double largest_excess() const { return std::abs(system_.excess(worst_vertex(), targets_)) / system_.factor(); }

  // The gradient of the convex energy is half the wanted minus the present angles. So the energy still falls at the end of
  // a step as long as the product of the step and the excesses is not negative.
  void minimize()
  {
    double least = largest_excess();
    const double first = (std::max)(least, 1.);
    for (int idle = 0; !is_sufficient(); ++steps_) {
      report_progress(options_.progress, fraction_of_digits(first, least, 1e-12), "the search for a conformal metric");
      if (idle > 0 && least <= tolerable_error)
        return;
      if (steps_ == maximum_number_of_steps || idle == 6)
        throw_not_converged("the sum of the angles at vertex " + std::to_string(worst_vertex()) + " still differs by " +
                            shown(least) + " from the wanted one");
      const std::vector<double> step = newton_step(steps_ == 0 || idle > 0, least), before = u_;
      const double squares = sum_of_squares(), range = range_of(step);
      double part = 1;
      while (part * range > 10) // beyond that, the linear model is useless
        part /= 2;
      for (int halvings = 0;; ++halvings, part /= 2) {
        for (std::size_t v = 0; v < u_.size(); ++v)
          u_[v] = before[v] + part * step[v];
        evaluate();
        double slope = 0;
        for (std::size_t v = 0; v < u_.size(); ++v)
          slope += step[v] * system_.excess(v, targets_);
        if (slope >= 0 || sum_of_squares() < squares / 4 || halvings == 40)
          break;
      }
      const double now = largest_excess();
      idle = now < 0.9 * least ? 0 : idle + 1;
      least = now;
    }
  }

  std::vector<double> newton_step(bool factorizes, double least)
  {
    std::vector<double> excesses;
    for (std::size_t v = 0; v < u_.size(); ++v)
      excesses.push_back(system_.excess(v, targets_));
    try {
      if (!factorizes)
        if (std::optional<std::vector<double>> step = system_.solve_by_last_factors(excesses, least))
          return *std::move(step);
      system_.factorize(targets_);
      return system_.solve(excesses);
    } catch (const Numerical_error& error) {
      throw_not_converged(error.what());
    }
  }

  double sum_of_squares() const
  {
    double result = 0;
    for (std::size_t v = 0; v < u_.size(); ++v)
      result += system_.excess(v, targets_) * system_.excess(v, targets_);
    return result;
  }

  [[noreturn]] void throw_not_converged(const std::string& what) const
  {
    std::size_t largest = 0;
    for (std::size_t v = 0; v < u_.size(); ++v)
      if (std::abs(u_[v]) > std::abs(u_[largest]))
        largest = v;
    throw Numerical_error("the conformal metric does not converge: " + what + ", with a range of u of " +
                          shown(range_of(u_)) + ": allow more cones, the first at vertex " + std::to_string(largest) +
                          ", or repair triangles that are too thin");
  }

  const Doubled_surface& doubled_;
  const Conformal_options& options_;
  Conformal_targets targets_;
  Conformal_system system_;
  std::vector<double> u_;
  int steps_ = 0;
};

} // namespace

Discrete_conformal_metric find_conformal_metric(const Doubled_surface::Triangulation& surface,
                                                const Doubled_surface& doubled, const Conformal_options& options,
                                                const Factorize& factorize)
{
  return Conformal_solver(surface, doubled, options, factorize).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal

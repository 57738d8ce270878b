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
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr double tolerable_error = 1e-10;
constexpr int maximum_number_of_steps = 100;

class Conformal_solver
{
public:
  Conformal_solver(const Doubled_surface::Triangulation& surface, const Doubled_surface& doubled,
                   const Conformal_options& options, const Factorize& factorize)
    : doubled_(doubled), options_(options), targets_(surface, options),
      system_(doubled, surface.connectivity().number_of_vertices(), options, factorize),
      u_(surface.connectivity().number_of_vertices(), 0.)
  {}

  Discrete_conformal_metric run()
  {
    try {
      find_u();
    } catch (const Numerical_error& error) {
      const auto largest =
        std::max_element(u_.begin(), u_.end(), [](double x, double y) { return std::abs(x) < std::abs(y); });
      throw Numerical_error("the conformal metric does not converge: " + std::string(error.what()) +
                            ", with a range of u of " + shown(range_of(u_), 3) +
                            ": allow more cones, the first at vertex " + std::to_string(largest - u_.begin()) +
                            ", or repair triangles that are too thin");
    }
    std::vector<double> cone_angles;
    for (Vertex_index v : targets_.cones())
      cone_angles.push_back(system_.sum_of_angles(v.idx()) / system_.factor());
    std::vector<double> lengths;
    for (double l : system_.lengths())
      lengths.push_back(std::ldexp(l, doubled_.unit));
    return {u_,     targets_.cones(),  cone_angles, system_.residual(targets_), range_of(u_),
            steps_, system_.complex(), lengths,     doubled_.vertices,          system_.flips()};
  }

private:
  void find_u()
  {
    system_.evaluate(u_);
    std::vector<double> areas;
    for (std::size_t i = 0; i < targets_.components().size(); ++i)
      areas.push_back(system_.area(targets_, i));
    if (options_.number_of_cones ? *options_.number_of_cones > 0 : targets_.cones().empty()) {
      system_.factorize(targets_);
      Cone_chooser(system_, targets_, options_).run();
    }
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
      system_.evaluate(u_);
  }

  std::size_t worst_vertex() const
  {
    std::size_t worst = 0;
    for (std::size_t v = 0; v < u_.size(); ++v)
      if (std::abs(system_.excess(v, targets_)) > std::abs(system_.excess(worst, targets_)))
        worst = v;
    return worst;
  }
  // Whether the excesses are as small as rounded lengths allow. The excess of a pin is the sum of all rounding errors.
  bool is_sufficient(const Conformal_targets::Component& component) const
  {
    return std::all_of(component.vertices.begin(), component.vertices.end(), [&](std::size_t v) {
      return std::abs(system_.excess(v, targets_)) <=
             (component.is_pin(v) ? tolerable_error : 1e-12 + 0x1p-51 * system_.sensitivity(v));
    });
  }
  bool is_sufficient() const
  {
    return std::all_of(targets_.components().begin(), targets_.components().end(),
                       [this](const auto& component) { return is_sufficient(component); });
  }
  double largest_excess() const { return std::abs(system_.excess(worst_vertex(), targets_)) / system_.factor(); }

  void minimize()
  {
    double least = largest_excess();
    const double first = (std::max)(least, 1.);
    for (int idle = 0; !is_sufficient(); ++steps_) {
      report_progress(options_.progress, fraction_of_digits(first, least, 1e-12), "the search for a conformal metric");
      if (idle > 0 && least <= tolerable_error)
        return;
      // Far away, only the energy falls.
      const bool is_rounding = least < 0x1p-48 * system_.sensitivity(worst_vertex());
      if (steps_ == maximum_number_of_steps || idle == (is_rounding || least < 1e-6 ? 6 : 30))
        throw Numerical_error("the sum of the angles at vertex " + std::to_string(worst_vertex()) +
                              " still differs by " + shown(least, 3) + " from the wanted one" +
                              (is_rounding ? " (rounding of lengths alone changes it as much)" : ""));
      take(newton_step(steps_ == 0 || idle > 0, least));
      const double now = largest_excess();
      idle = now < 0.9 * least ? 0 : idle + 1;
      least = now;
    }
  }

  // The gradient of the convex energy is half the difference of the wanted and the present angles. So the energy still
  // falls at the end of a step as long as the product of the step and the excesses is not negative. Each component
  // takes its own fraction of the step.
  void take(const std::vector<double>& step)
  {
    const std::vector<double> before = u_;
    const std::vector<Conformal_targets::Component>& components = targets_.components();
    std::vector<double> parts(components.size(), 1), squares;
    for (std::size_t i = 0; i < components.size(); ++i) {
      const std::vector<std::size_t>& vertices = components[i].vertices;
      const auto [least, most] =
        std::minmax_element(vertices.begin(), vertices.end(), [&](auto v, auto w) { return step[v] < step[w]; });
      while (parts[i] * (step[*most] - step[*least]) > 10) // beyond that, the linear model is useless
        parts[i] /= 2;
      squares.push_back(product(vertices, [&](std::size_t v) { return system_.excess(v, targets_); }));
    }
    bool is_done = false;
    for (int halvings = 0; !is_done && halvings <= 40; ++halvings) {
      for (std::size_t i = 0; i < components.size(); ++i)
        for (std::size_t v : components[i].vertices)
          u_[v] = before[v] + parts[i] * step[v];
      system_.evaluate(u_);
      is_done = true;
      for (std::size_t i = 0; i < components.size(); ++i) {
        const std::vector<std::size_t>& vertices = components[i].vertices;
        if (product(vertices, [&](std::size_t v) { return step[v]; }) >= 0 || is_sufficient(components[i]) ||
            product(vertices, [&](std::size_t v) { return system_.excess(v, targets_); }) < squares[i] / 4)
          continue;
        parts[i] /= 2;
        is_done = false;
      }
    }
  }

  // The sum of f(v) times the excess.
  template <class F>
  double product(const std::vector<std::size_t>& vertices, const F& f) const
  {
    return std::accumulate(vertices.begin(), vertices.end(), 0.,
                           [&](double sum, std::size_t v) { return sum + f(v) * system_.excess(v, targets_); });
  }

  std::vector<double> newton_step(bool factorizes, double least)
  {
    std::vector<double> excesses;
    for (std::size_t v = 0; v < u_.size(); ++v)
      excesses.push_back(system_.excess(v, targets_));
    if (!factorizes)
      if (std::optional<std::vector<double>> step = system_.solve_by_last_factors(excesses, least))
        return *std::move(step);
    system_.factorize(targets_);
    return system_.solve(excesses);
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

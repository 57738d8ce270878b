// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Cones where the linear model of a conformal metric has the largest scale factors.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONE_CHOOSER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONE_CHOOSER_H

#include "Conformal_system.h"
#include "Conformal_targets.h"

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// In the linear model, L u = excess. The vertex with the largest |u| becomes the next cone: it keeps its scale. For each
// cone there is a function that is 1 there, zero at all cones before, and harmonic elsewhere. Subtracting multiples of
// these makes u zero at all cones, so one factorization suffices.
class Cone_chooser
{
public:
  // \pre `system` was factorized for the targets, which have no chosen cones yet
  Cone_chooser(const Conformal_system& system, Conformal_targets& targets, const Conformal_options& options)
    : system_(system), targets_(targets), options_(options)
  {}

  // Chooses cones of one component.
  void run(const Conformal_targets::Component& component)
  {
    members_ = &component.vertices;
    is_closed_ = !component.keeps_scale;
    functions_.clear();
    std::vector<double> excesses(targets_.number_of_vertices(), 0.);
    double total = 0;
    for (std::size_t v : *members_)
      total += excesses[v] = system_.excess(v, targets_);
    std::vector<double> chosen_by = excesses;
    if (is_closed_) // until there is a cone, what cannot be removed is spread evenly
      for (std::size_t v : *members_)
        chosen_by[v] -= total / double(members_->size());
    std::vector<double> u = system_.solve(chosen_by);
    for (std::size_t k = 0;; ++k) {
      if (is_closed_ && k == 0)
        center(u);
      if (options_.number_of_cones ? k >= *options_.number_of_cones : is_sufficient(u, k, total))
        return;
      const std::optional<std::size_t> cone = largest(u);
      if (!cone)
        return;
      if (is_closed_ && k == 0) { // all of it goes to the first cone
        first_ = *cone;
        excesses[first_] -= total;
        u = system_.solve(excesses);
        shift(u, first_);
      } else {
        add_function(*cone);
        subtract(u, u[*cone], functions_.back().second);
      }
      targets_.make_cone(*cone);
    }
  }

private:
  // Angles of cones must be positive: by the linear model, they shall not be smaller than π / 2.
  bool is_sufficient(const std::vector<double>& u, std::size_t k, double total) const
  {
    if (is_closed_ && k == 0 && std::abs(total) > 1e-6)
      return false;
    std::vector<double> values;
    for (std::size_t v : *members_)
      values.push_back(u[v]);
    if (range_of(values) > options_.largest_range)
      return false;
    const std::vector<double> change = system_.product(u);
    for (std::size_t v : *members_)
      if (targets_.is_chosen(v) && system_.sum_of_angles(v) - change[v] < system_.factor() * CGAL_PI / 2)
        return false;
    return true;
  }

  // The vertex with the largest |u| that can still become a cone.
  std::optional<std::size_t> largest(const std::vector<double>& u) const
  {
    std::optional<std::size_t> result;
    for (std::size_t v : *members_)
      if (targets_.can_become_cone(v) && (!result || std::abs(u[v]) > std::abs(u[*result])))
        result = v;
    return result;
  }

  void center(std::vector<double>& u) const
  {
    double least = u[members_->front()], most = least;
    for (std::size_t v : *members_) {
      least = (std::min)(least, u[v]);
      most = (std::max)(most, u[v]);
    }
    for (std::size_t v : *members_)
      u[v] -= (least + most) / 2;
  }
  void shift(std::vector<double>& u, std::size_t cone) const
  {
    const double value = u[cone];
    for (std::size_t v : *members_)
      u[v] -= value;
  }
  void subtract(std::vector<double>& u, double factor, const std::vector<double>& function) const
  {
    for (std::size_t v : *members_)
      u[v] -= factor * function[v];
  }

  void add_function(std::size_t cone)
  {
    std::vector<double> right(targets_.number_of_vertices(), 0.);
    right[cone] = 1;
    if (is_closed_)
      right[first_] = -1;
    std::vector<double> function = system_.solve(right);
    if (is_closed_)
      shift(function, first_);
    for (const auto& [other, values] : functions_)
      subtract(function, function[other], values);
    const double value = function[cone];
    for (std::size_t v : *members_)
      function[v] /= value;
    functions_.emplace_back(cone, std::move(function));
  }

  const Conformal_system& system_;
  Conformal_targets& targets_;
  const Conformal_options& options_;
  const std::vector<std::size_t>* members_ = nullptr;
  bool is_closed_ = false;
  std::size_t first_ = 0; // cone of a closed surface
  std::vector<std::pair<std::size_t, std::vector<double>>> functions_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONE_CHOOSER_H

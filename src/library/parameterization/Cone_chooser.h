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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// In the linear model, L u = excess. The vertex of a component with the largest |u| becomes its next cone: it keeps its
// scale. Vertices whose u is the same up to rounding follow one after the other, if they are few, so that symmetries
// remain. For each cone there is a function that is 1 there, zero at all cones before, and harmonic elsewhere.
// Subtracting multiples of these makes u zero at all cones, so one factorization suffices. In each round every
// component gets a cone, as one solution serves all.
class Cone_chooser
{
public:
  // \pre `system` was factorized for the targets, which have no chosen cones yet
  Cone_chooser(const Conformal_system& system, Conformal_targets& targets, const Conformal_options& options)
    : system_(system), targets_(targets), options_(options)
  {}

  void run()
  {
    std::vector<double> right(targets_.number_of_vertices(), 0.);
    for (const Conformal_targets::Component& component : targets_.components()) {
      if (component.vertices.size() == 1)
        continue;
      Part& part = open_.emplace_back();
      part.members = &component.vertices;
      part.is_closed = !component.keeps_scale;
      part.largest_range = component.has_border ? options_.largest_range_with_border : options_.largest_range;
      for (std::size_t v : component.vertices)
        part.total += right[v] = system_.excess(v, targets_);
      if (part.is_closed) // until there is a cone, what cannot be removed is spread evenly
        shift(part, right, part.total / double(component.vertices.size()));
    }
    u_ = system_.solve(right);
    for (const Part& part : open_)
      if (part.is_closed) {
        const auto [least, most] = range(part);
        shift(part, u_, (least + most) / 2);
      }
    for (choose_next(); !open_.empty(); choose_next()) {
      std::fill(right.begin(), right.end(), 0.);
      for (const Part& part : open_) {
        right[part.cones.back()] = 1;
        if (part.cones.size() > 1 && part.is_closed)
          right[part.cones.front()] = -1;
        else if (part.is_closed)
          shift(part, right, 1 / double(part.members->size()));
      }
      std::vector<double> function = system_.solve(right);
      for (const Part& part : open_)
        add(part, function);
      functions_.push_back(std::move(function));
    }
  }

private:
  // A component that still has too few cones.
  struct Part
  {
    const std::vector<std::size_t>* members;
    bool is_closed; // no vertex keeps its scale at first
    double largest_range;
    double total = 0;               // of the excesses
    std::vector<std::size_t> cones; // one in each round
    std::vector<std::size_t> next;  // those that are to follow
  };

  void choose_next()
  {
    const std::vector<double> change = system_.product(u_);
    const auto is_done = [&](Part& part) {
      if (part.next.empty() &&
          (options_.number_of_cones ? part.cones.size() >= *options_.number_of_cones : is_sufficient(part, change)))
        return true;
      if (part.next.empty())
        part.next = largest(part);
      if (part.next.empty())
        return true;
      part.cones.push_back(part.next.back());
      part.next.pop_back();
      return false;
    };
    open_.erase(std::remove_if(open_.begin(), open_.end(), is_done), open_.end());
    for (const Part& part : open_)
      targets_.make_cone(part.cones.back());
  }

  // Angles of cones must be positive: in the linear model, they must not be smaller than π / 2.
  bool is_sufficient(const Part& part, const std::vector<double>& change) const
  {
    if (part.is_closed && part.cones.empty() && std::abs(part.total) > 1e-6)
      return false;
    const auto [least, most] = range(part);
    if (most - least > part.largest_range)
      return false;
    return std::none_of(part.members->begin(), part.members->end(), [&](std::size_t v) {
      return targets_.is_chosen(v) && system_.sum_of_angles(v) - change[v] < system_.factor() * CGAL_PI / 2;
    });
  }

  // Of the vertices that can still become cones, those with the largest |u| and one sign; only the first one if there
  // are many.
  std::vector<std::size_t> largest(const Part& part) const
  {
    double least = 0, most = 0;
    for (std::size_t v : *part.members)
      if (targets_.can_become_cone(v)) {
        least = (std::min)(least, u_[v]);
        most = (std::max)(most, u_[v]);
      }
    constexpr double same = 1 - 1e-6;
    const double sign = most >= -least * same ? 1 : -1, bound = same * (std::max)(most, -least) - 1e-12;
    std::vector<std::size_t> result;
    for (std::size_t v : *part.members)
      if (targets_.can_become_cone(v) && sign * u_[v] >= bound)
        result.push_back(v);
    constexpr std::size_t many = 16;
    if (result.size() >
        (std::min)(many, options_.number_of_cones.value_or(many + part.cones.size()) - part.cones.size()))
      result.resize(1);
    return result;
  }

  std::pair<double, double> range(const Part& part) const
  {
    std::pair<double, double> result(u_[part.members->front()], u_[part.members->front()]);
    for (std::size_t v : *part.members)
      result = {(std::min)(result.first, u_[v]), (std::max)(result.second, u_[v])};
    return result;
  }
  static void shift(const Part& part, std::vector<double>& u, double value)
  {
    for (std::size_t v : *part.members)
      u[v] -= value;
  }

  // Makes the function zero at all cones before the last one, and 1 there, and u zero at all. The first cone of a
  // closed surface takes all that cannot be removed.
  void add(const Part& part, std::vector<double>& function)
  {
    const std::vector<std::size_t>& cones = part.cones;
    const auto subtract = [&](std::vector<double>& from, double factor, const std::vector<double>& x) {
      for (std::size_t v : *part.members)
        from[v] -= factor * x[v];
    };
    if (part.is_closed)
      shift(part, function, function[cones.front()]);
    for (std::size_t i = 0; i + 1 < cones.size(); ++i)
      subtract(function, function[cones[i]], functions_[i]);
    if (part.is_closed && cones.size() == 1) {
      subtract(u_, part.total, function);
      shift(part, u_, u_[cones.front()]);
      return;
    }
    const double value = function[cones.back()];
    for (std::size_t v : *part.members)
      function[v] /= value;
    subtract(u_, u_[cones.back()], function);
  }

  const Conformal_system& system_;
  Conformal_targets& targets_;
  const Conformal_options& options_;
  std::vector<double> u_;
  std::vector<Part> open_;
  std::vector<std::vector<double>> functions_; // for each round
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_CONE_CHOOSER_H

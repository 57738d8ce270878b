// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plain numbers for what leaves a kernel: lengths, areas and weights.

#ifndef IDT_KERNELS_NUMBER_COLLECTOR_H
#define IDT_KERNELS_NUMBER_COLLECTOR_H

#include "kernels/Kernel.h"
#include "system/for_each_block.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/area_in_input_unit.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// What an exact decision finds out, or something else if it is cancelled.
template <class Decide, class Otherwise>
auto unless_cancelled(const Decide& decide, const Otherwise& otherwise)
{
  try {
    return decide();
  } catch (const IT::Cancelled_error&) {
    return otherwise();
  }
}

// Cotangent weights as doubles, none of them NaN, from the triangulation's own accessors,
// with the sign that its number type decides.
template <class Triangulation>
class Weight_evaluator
{
  using FT = typename Triangulation::FT;

public:
  explicit Weight_evaluator(const Triangulation& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity()),
      has_area_(complex_.number_of_faces(), unknown)
  {}

  // After an interruption, from the stored numbers where a decision would take long.
  double operator()(IT::Edge_index e)
  {
    return unless_cancelled([&] { return decided_weight(e); }, [&] { return stored_weight(e); });
  }

  // Only then can the weight be infinite, but for overflow.
  bool is_beside_flat_face(IT::Edge_index e)
  {
    const IT::Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    return (!complex_.is_border(h) && !has_positive_area(complex_.face(h))) ||
           (!complex_.is_border(g) && !has_positive_area(complex_.face(g)));
  }

private:
  static constexpr std::int8_t unknown = -1;

  double decided_weight(IT::Edge_index e)
  {
    const IT::Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    double result = std::numeric_limits<double>::quiet_NaN();
    if ((complex_.is_border(h) || has_positive_area(complex_.face(h))) &&
        (complex_.is_border(g) || has_positive_area(complex_.face(g))))
      result = CGAL::to_double(triangulation_.cotangent_weight(e));
    if (std::isnan(result)) {
      result = (complex_.is_border(h) ? 0 : rough_cotangent(h)) +
               (complex_.is_border(g) ? 0 : rough_cotangent(g));
      // Two faces of zero area, with angles of 0 and of π opposite to the edge: a tie.
      if (std::isnan(result))
        result = 0;
    }
    // A sum of two rounded cotangents that cancel can have another sign.
    if (result < 0 && !complex_.is_border(e) &&
        CGAL::certainly(triangulation_.is_locally_Delaunay(e)))
      result = 0;
    return result;
  }

  double stored_weight(IT::Edge_index e) const
  {
    double sum = 0;
    for (IT::Halfedge_index h : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))})
      if (!complex_.is_border(h))
        sum += CGAL::to_double(triangulation_.traits().compute_cotangent_object()(
          triangulation_.face_data(complex_.face(h)), triangulation_.edge_data(complex_.edge(h)),
          triangulation_.edge_data(complex_.edge(complex_.next(h))),
          triangulation_.edge_data(complex_.edge(complex_.prev(h)))));
    return std::isnan(sum) ? 0 : sum;
  }

  bool has_positive_area(IT::Face_index f)
  {
    std::int8_t& answer = has_area_[f.idx()];
    if (answer == unknown)
      answer = find_positive_area(f) ? 1 : 0;
    return answer != 0;
  }

  bool find_positive_area(IT::Face_index f) const
  {
    if constexpr (Triangulation::uses_exact_geometry)
      // The stored bound mostly knows; a rounded area can be tiny though the exact one is zero.
      return triangulation_.traits().has_positive_area_object()(triangulation_.face_data(f)) ||
             unless_cancelled([&] { return triangulation_.exact_geometry().sign_of_area(complex_, f) == CGAL::POSITIVE; },
                              [] { return true; });
    else
      return CGAL::certainly(triangulation_.area(f) > FT(0));
  }

  // For a face whose area is zero, or not known to be positive, or beside one.
  double rough_cotangent(IT::Halfedge_index h)
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      if (has_positive_area(complex_.face(h)))
        return triangulation_.cotangent(h);
      // At the corner of a flat face the scalar product is that of two parallel sides.
      const double p = triangulation_.exact_geometry().corner(complex_, h).p.hi();
      return std::copysign(std::numeric_limits<double>::infinity(), p);
    }
    const auto length = [&](IT::Halfedge_index k) {
      return CGAL::to_double(triangulation_.length(complex_.edge(k)));
    };
    const double l_ij = length(h), l_jk = length(complex_.next(h)), l_ki = length(complex_.prev(h));
    // In units of the longest side, lest a square overflows.
    const double longest = std::fmax(l_ij, std::fmax(l_jk, l_ki));
    const double ij = l_ij / longest, jk = l_jk / longest, ki = l_ki / longest;
    const double p = IT::twice_scalar_product<double>(jk * jk, ki * ki, ij * ij);
    // Rounded lengths make a little area of none, and a number of what is infinite.
    if (Triangulation::Traits::Has_exact_decisions::value && !has_positive_area(complex_.face(h)))
      return std::copysign(std::numeric_limits<double>::infinity(), p);
    const double q = IT::squared_four_areas_from_lengths(ij, jk, ki);
    return q > 0 ? p / std::sqrt(q)
                 : std::copysign(std::numeric_limits<double>::infinity(), p);
  }

  const Triangulation& triangulation_;
  const IT::Delta_complex& complex_;
  std::vector<std::int8_t> has_area_;
};

inline void add(Weight_summary& summary, double weight)
{
  if (!std::isfinite(weight))
    ++summary.infinite;
  else if (!summary.smallest || weight < *summary.smallest)
    summary.smallest = weight;
}

// Where the stored numbers have error bounds, the exact geometry is only asked for the few
// weights that can be the smallest.
template <class Triangulation>
Weight_summary summarize_weights(const Triangulation& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  Weight_evaluator<Triangulation> weight(triangulation);
  Weight_summary summary;
  if constexpr (!Triangulation::uses_exact_geometry) {
    for (IT::Edge_index e : complex.edges()) {
      const double w = weight(e);
      if (!complex.is_border(e)) {
        add(summary, w);
        summary.negative += w < 0;
      } else {
        summary.infinite += !std::isfinite(w);
      }
    }
  } else {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    // The cotangent opposite to h from below and from above.
    const auto cotangent_bounds = [&](IT::Halfedge_index h) -> std::pair<double, double> {
      const auto c = triangulation.traits().compute_bounded_cotangent_object()(
        triangulation.face_data(complex.face(h)), triangulation.edge_data(complex.edge(h)),
        triangulation.edge_data(complex.edge(complex.next(h))),
        triangulation.edge_data(complex.edge(complex.prev(h))));
      return {c.value - c.error, c.value + c.error};
    };
    std::vector<double> from_below(complex.number_of_edges(), infinity);
    double smallest_from_above = infinity;
    for (IT::Edge_index e : complex.edges()) {
      if (complex.is_border(e)) {
        summary.infinite += weight.is_beside_flat_face(e);
        continue;
      }
      summary.negative += !unless_cancelled(
        [&] { return CGAL::certainly(triangulation.is_locally_Delaunay(e)); }, [&] { return weight(e) >= 0; });
      if (weight.is_beside_flat_face(e)) {
        add(summary, weight(e));
        continue;
      }
      const IT::Halfedge_index h = complex.halfedge(e);
      const auto k = cotangent_bounds(h), l = cotangent_bounds(complex.opposite(h));
      from_below[e.idx()] = k.first + l.first;
      smallest_from_above = (std::min)(smallest_from_above, k.second + l.second);
    }
    // The bounds are those of the exact weight; what is reported is rounded once more.
    smallest_from_above += 0x1p-40 * (1 + std::abs(smallest_from_above));
    for (IT::Edge_index e : complex.edges())
      if (from_below[e.idx()] < infinity && from_below[e.idx()] <= smallest_from_above)
        add(summary, weight(e));
  }
  return summary;
}

template <class Triangulation>
double length(const Triangulation& triangulation, IT::Edge_index e)
{
  return unless_cancelled([&] { return CGAL::to_double(triangulation.length(e)); },
                          [&] { return std::sqrt(CGAL::to_double(triangulation.squared_length(e))); });
}

template <class Triangulation>
double area(const Triangulation& triangulation, IT::Face_index f)
{
  return unless_cancelled([&] { return CGAL::to_double(triangulation.area(f)); }, [&] {
    const IT::Delta_complex& complex = triangulation.connectivity();
    const IT::Halfedge_index h = complex.halfedge(f);
    const double stored = CGAL::to_double(triangulation.traits().compute_area_object()(
      triangulation.face_data(f), triangulation.edge_data(complex.edge(h)),
      triangulation.edge_data(complex.edge(complex.next(h))),
      triangulation.edge_data(complex.edge(complex.prev(h)))));
    return std::ldexp(stored, 2 * triangulation.unit_exponent()); });
}

// What the functions above return for most elements, found for all corners at a vertex together and by several threads; NaN for the
// others, and for all if the number type has no exact geometry.
class Known_numbers
{
public:
  template <class Triangulation>
  explicit Known_numbers(const Triangulation& triangulation) : complex_(triangulation.connectivity())
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      numbers_.emplace(complex_);
      unit_exponent_ = triangulation.unit_exponent();
      const IT::Exact_geometry& geometry = triangulation.exact_geometry();
      for_each_block(complex_.number_of_vertices(), [&](std::size_t first, std::size_t last) {
        unless_cancelled([&] { geometry.find_numbers(complex_, first, last, *numbers_); }, [] {});
      });
    }
  }

  double length(IT::Edge_index e) const { return numbers_ ? numbers_->lengths[e.idx()] : unknown; }
  double weight(IT::Edge_index e) const
  {
    return numbers_ && !complex_.is_border(e) ? numbers_->cotangent_weight(complex_, e) : unknown;
  }
  double area(IT::Face_index f) const
  {
    return numbers_ && !std::isnan(numbers_->areas[f.idx()])
             ? IT::internal::area_in_input_unit(numbers_->areas[f.idx()], unit_exponent_, f)
             : unknown;
  }

private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  const IT::Delta_complex& complex_;
  std::optional<IT::Exact_geometry::Rounded_numbers> numbers_;
  int unit_exponent_ = 0;
};

template <class Triangulation>
void collect_numbers(const Triangulation& triangulation, bool with_lengths, bool with_weights_and_areas, Numbers& numbers)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const Known_numbers known(triangulation);
  if (with_lengths) {
    numbers.lengths.reserve(complex.number_of_edges());
    for (IT::Edge_index e : complex.edges()) {
      const double x = known.length(e);
      numbers.lengths.push_back(std::isnan(x) ? length(triangulation, e) : x);
    }
  }
  if (!with_weights_and_areas)
    return;
  Weight_evaluator<Triangulation> weight(triangulation);
  numbers.weights.reserve(complex.number_of_edges());
  for (IT::Edge_index e : complex.edges()) {
    const double x = known.weight(e);
    numbers.weights.push_back(std::isnan(x) ? weight(e) : x);
  }
  numbers.areas.reserve(complex.number_of_faces());
  for (IT::Face_index f : complex.faces()) {
    const double x = known.area(f);
    numbers.areas.push_back(std::isnan(x) ? area(triangulation, f) : x);
  }
}

} // namespace idt

#endif // IDT_KERNELS_NUMBER_COLLECTOR_H

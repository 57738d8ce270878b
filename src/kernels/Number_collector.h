// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plain numbers for what leaves a kernel: lengths, areas and weights.

#ifndef IDT_KERNELS_NUMBER_COLLECTOR_H
#define IDT_KERNELS_NUMBER_COLLECTOR_H

#include "kernels/Kernel.h"
#include "system/for_each_block.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
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

// The cotangent weight of an interior edge of a triangulation that was never flipped, from the metric of the input; NaN where
// double-doubles do not tell, or the exact weight would be rounded to another double.
inline double input_weight(const IT::Delta_complex& input, const IT::Input_metric& metric, IT::Edge_index e)
{
  const auto cotangent = [&](IT::Halfedge_index h) {
    const auto squared_length = [&](IT::Halfedge_index side) { return metric.squared_length_double_double(input, input.edge(side)); };
    const auto p = squared_length(input.next(h)) + squared_length(input.prev(h)) - squared_length(h);
    return p / metric.four_areas_double_double(input, input.face(h));
  };
  const IT::Halfedge_index h = input.halfedge(e);
  const IT::internal::Bounded_double_double weight = cotangent(h) + cotangent(input.opposite(h));
  return IT::internal::is_rounded_alike(weight) ? weight.hi() : std::numeric_limits<double>::quiet_NaN();
}

// Where the stored numbers have error bounds, the exact geometry is only asked for the few
// weights that can be the smallest.
// \param known a weight that is known, or NaN
template <class Triangulation, class Known>
Weight_summary summarize_weights(const Triangulation& triangulation, const Known& known)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  std::optional<Weight_evaluator<Triangulation>> evaluator;
  const auto weight = [&]() -> Weight_evaluator<Triangulation>& {
    if (!evaluator)
      evaluator.emplace(triangulation);
    return *evaluator;
  };
  Weight_summary summary;
  if constexpr (!Triangulation::uses_exact_geometry) {
    for (IT::Edge_index e : complex.edges()) {
      const double w = weight()(e);
      if (!complex.is_border(e)) {
        add(summary, w);
        summary.negative += w < 0;
      } else {
        summary.infinite += !std::isfinite(w);
      }
    }
  } else {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto has_area = [&](IT::Halfedge_index h) {
      return complex.is_border(h) || triangulation.traits().has_positive_area_object()(triangulation.face_data(complex.face(h)));
    };
    const auto is_beside_flat_face = [&](IT::Edge_index e) {
      const IT::Halfedge_index h = complex.halfedge(e);
      return !(has_area(h) && has_area(complex.opposite(h))) && weight().is_beside_flat_face(e);
    };
    // The cotangent opposite to h from below and from above.
    const auto cotangent_bounds = [&](IT::Halfedge_index h) -> std::pair<double, double> {
      const auto c = triangulation.traits().compute_bounded_cotangent_object()(
        triangulation.face_data(complex.face(h)), triangulation.edge_data(complex.edge(h)),
        triangulation.edge_data(complex.edge(complex.next(h))),
        triangulation.edge_data(complex.edge(complex.prev(h))));
      return {c.value - c.error, c.value + c.error};
    };
    const auto is_Delaunay = [&](IT::Edge_index e) {
      return unless_cancelled([&] { return CGAL::certainly(triangulation.is_locally_Delaunay(e)); }, [&] { return weight()(e) >= 0; });
    };
    std::vector<double> from_below(complex.number_of_edges(), infinity);
    double smallest_from_above = infinity;
    for (IT::Edge_index e : complex.edges()) {
      if (complex.is_border(e)) {
        summary.infinite += is_beside_flat_face(e);
        continue;
      }
      if (is_beside_flat_face(e)) {
        summary.negative += !is_Delaunay(e);
        add(summary, weight()(e));
        continue;
      }
      const IT::Halfedge_index h = complex.halfedge(e);
      const auto k = cotangent_bounds(h), l = cotangent_bounds(complex.opposite(h));
      const double low = k.first + l.first, high = k.second + l.second;
      from_below[e.idx()] = low;
      smallest_from_above = (std::min)(smallest_from_above, high);
      // The bounds are rounded. An edge with one face on both sides is Delaunay, whatever its weight.
      if (low < 0x1p-40 * (1 + std::abs(low)))
        summary.negative += (high < -0x1p-40 * (1 + std::abs(high)) && complex.is_flippable(e)) || !is_Delaunay(e);
    }
    // The bounds are those of the exact weight; what is reported is rounded once more.
    smallest_from_above += 0x1p-40 * (1 + std::abs(smallest_from_above));
    for (IT::Edge_index e : complex.edges())
      if (from_below[e.idx()] < infinity && from_below[e.idx()] <= smallest_from_above) {
        const double w = known(e);
        add(summary, std::isnan(w) ? weight()(e) : w);
      }
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

// What the functions above return for most elements, found for each face by several threads; NaN for the
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
      for_each_block(complex_.number_of_faces(), [&](std::size_t first, std::size_t last) {
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
    if (!numbers_ || std::isnan(numbers_->areas[f.idx()]))
      return unknown;
    try {
      return IT::internal::area_in_input_unit(numbers_->areas[f.idx()], unit_exponent_, f);
    } catch (const IT::Invalid_surface_error&) { // one thread finds the first of them
      return unknown;
    }
  }

  // Gives their memory back.
  void forget_lengths()
  {
    if (numbers_)
      numbers_->lengths = {};
  }

private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  const IT::Delta_complex& complex_;
  std::optional<IT::Exact_geometry::Rounded_numbers> numbers_;
  int unit_exponent_ = 0;
};

// One number for each of n elements: `known(element)`, by several threads, or `compute(element)` where that is NaN.
template <class Element, class Known, class Compute>
void collect(std::size_t n, const Known& known, const Compute& compute, std::vector<double>& numbers)
{
  numbers.resize(n);
  const auto element = [](std::size_t i) { return Element(typename Element::size_type(i)); };
  for_each_block(n, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      numbers[i] = known(element(i));
  });
  for (std::size_t i = 0; i < n; ++i)
    if (std::isnan(numbers[i]))
      numbers[i] = compute(element(i));
}

template <class Triangulation>
void collect_numbers(const Triangulation& triangulation, bool with_lengths, bool with_weights_and_areas, Numbers& numbers)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  Known_numbers known(triangulation);
  if (with_lengths)
    collect<IT::Edge_index>(
      complex.number_of_edges(), [&](IT::Edge_index e) { return known.length(e); },
      [&](IT::Edge_index e) { return length(triangulation, e); }, numbers.lengths);
  if (!with_weights_and_areas)
    return;
  known.forget_lengths();
  Weight_evaluator<Triangulation> weight(triangulation);
  collect<IT::Edge_index>(
    complex.number_of_edges(), [&](IT::Edge_index e) { return known.weight(e); }, [&](IT::Edge_index e) { return weight(e); },
    numbers.weights);
  collect<IT::Face_index>(
    complex.number_of_faces(), [&](IT::Face_index f) { return known.area(f); },
    [&](IT::Face_index f) { return area(triangulation, f); }, numbers.areas);
}

} // namespace idt

#endif // IDT_KERNELS_NUMBER_COLLECTOR_H

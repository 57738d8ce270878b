// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Numbers of all elements, equal to those of single queries, but with one layout for each face.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ELEMENT_MEASURER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ELEMENT_MEASURER_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Engine_numbers.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Cotangent_weight.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Cotangents and their sums for faces of any area, without NaN.
template <class Traits>
class Extended_cotangents
{
public:
  explicit Extended_cotangents(const Intrinsic_triangulation<Traits>& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity()),
      has_area_(complex_.number_of_faces(), unknown)
  {}

  // The cotangent weight of an edge, with the sign that the number type decides.
  double weight(Edge_index e)
  {
    const Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    double result = std::numeric_limits<double>::quiet_NaN();
    if (has_area(h) && has_area(g))
      result = CGAL::to_double(triangulation_.cotangent_weight(e));
    if (std::isnan(result)) {
      result = (complex_.is_border(h) ? 0 : rough_cotangent(h)) + (complex_.is_border(g) ? 0 : rough_cotangent(g));
      // Two faces of zero area, with the angles 0 and π opposite the edge: a tie.
      if (std::isnan(result))
        result = 0;
    }
    return with_decided_sign(triangulation_, e, result);
  }

  // Opposite to h. \pre h is not a border halfedge
  double cotangent(Halfedge_index h)
  {
    const double result =
      has_area(h) ? CGAL::to_double(triangulation_.cotangent(h)) : std::numeric_limits<double>::quiet_NaN();
    return std::isnan(result) ? rough_cotangent(h) : result;
  }

  // Whether a face beside e has no area. Apart from overflow, only then can the weight be infinite.
  bool is_beside_flat_face(Edge_index e)
  {
    const Halfedge_index h = complex_.halfedge(e);
    return !(has_area(h) && has_area(complex_.opposite(h)));
  }

private:
  static constexpr std::int8_t unknown = -1;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  bool has_area(Halfedge_index h)
  {
    if (complex_.is_border(h))
      return true;
    const Face_index f = complex_.face(h);
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry)
      if (triangulation_.traits().has_positive_area_object()(
            triangulation_.face_data(f))) // usually known, and faster than from memory
        return true;
    std::int8_t& answer = has_area_[f.idx()];
    if (answer == unknown)
      answer = has_positive_area(triangulation_, f);
    return answer != 0;
  }

  // For a face whose area is zero or not known to be positive, or that is next to such a face.
  double rough_cotangent(Halfedge_index h)
  {
    if constexpr (Intrinsic_triangulation<Traits>::uses_exact_geometry) {
      if (has_area(h))
        return triangulation_.cotangent(h);
      // At the corner of a flat face, the scalar product has two parallel factors.
      return std::copysign(infinity, Engine_numbers(internal::engine(triangulation_)).corner(h).p.hi());
    }
    const auto length = [&](Halfedge_index k) { return CGAL::to_double(triangulation_.length(complex_.edge(k))); };
    const double l_ij = length(h), l_jk = length(complex_.next(h)), l_ki = length(complex_.prev(h));
    // In units of the longest side, lest a square overflows.
    const double longest = std::fmax(l_ij, std::fmax(l_jk, l_ki));
    const double ij = l_ij / longest, jk = l_jk / longest, ki = l_ki / longest;
    const double p = twice_scalar_product<double>(jk * jk, ki * ki, ij * ij);
    // Rounded lengths turn a zero area into a small one, and an infinite number into a finite one.
    if (Traits::Has_exact_decisions::value && !has_area(h))
      return std::copysign(infinity, p);
    const double q = squared_four_areas_from_lengths(ij, jk, ki);
    return q > 0 ? p / std::sqrt(q) : std::copysign(infinity, p);
  }

  const Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  std::vector<std::int8_t> has_area_; // or `unknown`
};

// Several threads lay out one corner of each face; elements are queried one by one if that does not suffice, or if the
// traits have no exact geometry.
template <class ConcurrencyTag, class Traits>
class Element_measurer
{
  using Triangulation = Intrinsic_triangulation<Traits>;

public:
  Element_measurer(const Triangulation& triangulation, const Progress_function& progress)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), progress_(progress)
  {
    if constexpr (Triangulation::uses_exact_geometry)
      lay_out_faces(internal::engine<ConcurrencyTag>(triangulation));
  }

  std::vector<double> lengths()
  {
    std::vector<double> result = numbers<Edge_index>(
      complex_.number_of_edges(), [&](Edge_index e) { return known_->lengths[e.idx()]; },
      [&](Edge_index e) { return CGAL::to_double(triangulation_.length(e)); });
    if (known_)
      known_->lengths = {}; // gives the memory back
    return result;
  }

  std::vector<double> areas()
  {
    return numbers<Face_index>(
      complex_.number_of_faces(), [&](Face_index f) { return known_area(f); },
      [&](Face_index f) { return CGAL::to_double(triangulation_.area(f)); });
  }

  std::vector<double> weights()
  {
    Extended_cotangents<Traits> extended(triangulation_);
    return numbers<Edge_index>(
      complex_.number_of_edges(),
      [&](Edge_index e) { return complex_.is_border(e) ? unknown : known_->cotangent_weight(complex_, e); },
      [&](Edge_index e) { return extended.weight(e); });
  }

  std::vector<double> cotangents()
  {
    Extended_cotangents<Traits> extended(triangulation_);
    return numbers<Halfedge_index>(
      complex_.number_of_halfedges(), [&](Halfedge_index h) { return known_cotangent(h); },
      [&](Halfedge_index h) { return complex_.is_border(h) ? 0 : extended.cotangent(h); });
  }

  // \param angle(h) returns a single one
  template <class Angle>
  std::vector<double> angles(double relative_error, const Angle& angle)
  {
    return numbers<Halfedge_index>(
      complex_.number_of_halfedges(),
      [&](Halfedge_index h) { return complex_.is_border(h) ? 0 : known_->angle(h, relative_error); },
      [&](Halfedge_index h) { return complex_.is_border(h) ? 0 : angle(h); });
  }

private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  static constexpr const char* name = "the measurement";

  void lay_out_faces(const Exact_engine& engine)
  {
    known_.emplace(complex_);
    const std::size_t n = complex_.number_of_faces(), between_reports = progress_ ? 16 * elements_of_block : n;
    for (std::size_t begin = 0; begin < n; begin += between_reports) {
      report_progress(progress_, 0.5 * double(begin) / double(n), name);
      for_each_block<ConcurrencyTag>((std::min)(between_reports, n - begin), elements_of_block / 4,
                                     [&](std::size_t first, std::size_t last) {
                                       Engine_numbers(engine).find_numbers(begin + first, begin + last, *known_);
                                     });
    }
  }

  double known_area(Face_index f) const
  {
    const double area = known_->areas[f.idx()];
    try {
      return std::isnan(area) ? area : area_in_input_unit(area, triangulation_.unit_exponent(), f);
    } catch (const Invalid_surface_error&) { // of several, one thread finds the first
      return unknown;
    }
  }

  double known_cotangent(Halfedge_index h) const
  {
    if (complex_.is_border(h))
      return 0;
    const auto& [hi, lo, error] = known_->cotangents[h.idx()];
    return error < 0x1p-53 * (1 + std::abs(hi)) ? hi : unknown;
  }

  // A value for each of n elements: `known(element)`, or `compute(element)` if that is NaN.
  template <class Element, class Known, class Compute>
  std::vector<double> numbers(std::size_t n, const Known& known, const Compute& compute)
  {
    std::vector<double> result(n, unknown);
    const auto element = [](std::size_t i) { return Element(typename Element::size_type(i)); };
    if (known_)
      for_each_block<ConcurrencyTag>(n, elements_of_block, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
          result[i] = known(element(i));
      });
    // The number of elements left for this loop, and of loops to come, is not known.
    const double done = (fraction_ + 1) / 2;
    const Loop_progress progress(progress_, name, std::exchange(fraction_, done), done, n);
    for (std::size_t i = 0; i < n; ++i) {
      progress.at(i);
      if (std::isnan(result[i]))
        result[i] = compute(element(i));
    }
    return result;
  }

  const Triangulation& triangulation_;
  const Delta_complex& complex_;
  const Progress_function progress_;
  double fraction_ = 0.5;
  std::optional<Rounded_numbers> known_; // of a triangulation with exact geometry
};

// Counts negative cotangent weights, and finds the smallest; exact geometry is used only for candidates.
template <class Traits>
class Weight_summarizer
{
public:
  explicit Weight_summarizer(const Intrinsic_triangulation<Traits>& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity()), extended_(triangulation)
  {}

  // \tparam Summary has `smallest`, `negative` and `infinite`
  template <class Summary>
  void summarize(Summary& summary)
  {
    if constexpr (Cotangent_weight<Traits>::has_bounds && Traits::Uses_exact_geometry::value)
      by_bounds(summary);
    else
      for (Edge_index e : complex_.edges())
        add(e, summary);
  }

private:
  template <class Summary>
  void add(Edge_index e, Summary& summary)
  {
    const double weight = extended_.weight(e);
    summary.infinite += !std::isfinite(weight);
    if (complex_.is_border(e))
      return;
    summary.negative += weight < 0;
    if (std::isfinite(weight))
      summary.smallest = (std::min)(weight, summary.smallest.value_or(weight));
  }

  template <class Summary>
  void by_bounds(Summary& summary)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> lowest(complex_.number_of_edges(), infinity);
    double smallest_from_above = infinity;
    for (Edge_index e : complex_.edges()) {
      if (extended_.is_beside_flat_face(e)) {
        add(e, summary);
      } else if (!complex_.is_border(e)) {
        const auto [low, high] = bounds(e);
        lowest[e.idx()] = low;
        smallest_from_above = (std::min)(smallest_from_above, high);
        // The bounds are rounded. An edge with one face on both sides is Delaunay, whatever its weight.
        if (low < margin(low))
          summary.negative +=
            (high < -margin(high) && complex_.is_flippable(e)) || !certainly(triangulation_.is_locally_Delaunay(e));
      }
    }
    // The bounds are for the exact weight; the reported one is rounded once more.
    smallest_from_above += margin(smallest_from_above);
    for (Edge_index e : complex_.edges())
      if (lowest[e.idx()] < infinity && lowest[e.idx()] <= smallest_from_above) {
        const double weight = extended_.weight(e);
        summary.smallest = (std::min)(weight, summary.smallest.value_or(weight));
      }
  }

  static double margin(double x) { return 0x1p-40 * (1 + std::abs(x)); }

  // Bounds on the weight of an interior edge, from the stored numbers.
  std::pair<double, double> bounds(Edge_index e) const
  {
    double low = 0, high = 0;
    for (Halfedge_index h : {complex_.halfedge(e), complex_.opposite(complex_.halfedge(e))}) {
      const auto c = bounded_cotangent(triangulation_, h);
      low += c.value - c.error;
      high += c.value + c.error;
    }
    return {low, high};
  }

  const Intrinsic_triangulation<Traits>& triangulation_;
  const Delta_complex& complex_;
  Extended_cotangents<Traits> extended_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_NUMBERS_ELEMENT_MEASURER_H

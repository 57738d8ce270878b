// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plain numbers for what leaves a kernel.

#ifndef IDT_KERNELS_NUMBER_COLLECTOR_H
#define IDT_KERNELS_NUMBER_COLLECTOR_H

#include "Kernel.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

// Lengths, areas and weights as doubles, none of them NaN. They come from the
// triangulation's own accessors, and so are as good as its number type.
template <class Triangulation>
class Number_collector
{
  using FT = typename Triangulation::FT;

public:
  explicit Number_collector(const Triangulation& triangulation)
    : triangulation_(triangulation), complex_(triangulation.connectivity())
  {
    lengths_.reserve(complex_.number_of_edges());
    for (IT::Edge_index e : complex_.edges())
      lengths_.push_back(CGAL::to_double(triangulation_.length(e)));
    areas_.reserve(complex_.number_of_faces());
    has_area_.reserve(complex_.number_of_faces());
    for (IT::Face_index f : complex_.faces()) {
      const FT area = triangulation_.area(f);
      areas_.push_back(CGAL::to_double(area));
      has_area_.push_back(has_positive_area(f, area));
    }
    weights_.reserve(complex_.number_of_edges());
    for (IT::Edge_index e : complex_.edges())
      weights_.push_back(weight(e));
  }

  Weight_summary summary() const
  {
    Weight_summary result;
    for (IT::Edge_index e : complex_.edges()) {
      if (complex_.is_border(e))
        continue;
      const double w = weights_[e.idx()];
      if (!result.smallest || w < *result.smallest)
        result.smallest = w;
      result.negative += w < 0;
    }
    return result;
  }

  void move_to(Outcome& outcome)
  {
    outcome.lengths = std::move(lengths_);
    outcome.areas = std::move(areas_);
    outcome.weights = std::move(weights_);
  }

private:
  bool has_positive_area(IT::Face_index f, const FT& area) const
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      // The stored bound mostly knows; a rounded area can be tiny though the exact one is zero.
      const auto& traits = triangulation_.traits();
      return traits.has_positive_area_object()(triangulation_.face_data(f)) ||
             triangulation_.exact_geometry().sign_of_area(complex_, f) == CGAL::POSITIVE;
    }
    return CGAL::certainly(area > FT(0));
  }

  double weight(IT::Edge_index e) const
  {
    const IT::Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    double result = std::numeric_limits<double>::quiet_NaN();
    if ((complex_.is_border(h) || has_area_[complex_.face(h).idx()]) &&
        (complex_.is_border(g) || has_area_[complex_.face(g).idx()]))
      result = CGAL::to_double(triangulation_.cotangent_weight(e));
    if (std::isnan(result)) {
      result = (complex_.is_border(h) ? 0 : rough_cotangent(h)) +
               (complex_.is_border(g) ? 0 : rough_cotangent(g));
      // Two faces of zero area, with angles of 0 and of π opposite to the edge: a tie.
      if (std::isnan(result))
        result = 0;
    }
    // The sign is what the number type decides; a sum of two rounded cotangents that
    // cancel can have another.
    if (result < 0 && !complex_.is_border(e) &&
        CGAL::certainly(triangulation_.is_locally_Delaunay(e)))
      result = 0;
    return result;
  }

  // For a face whose area is zero, or not known to be positive.
  double rough_cotangent(IT::Halfedge_index h) const
  {
    if constexpr (Triangulation::uses_exact_geometry) {
      if (has_area_[complex_.face(h).idx()])
        return triangulation_.cotangent(h);
      // At the corner of a flat face the scalar product is that of two parallel sides.
      const double p = triangulation_.exact_geometry().corner(complex_, h).p.hi();
      return std::copysign(std::numeric_limits<double>::infinity(), p);
    }
    const auto length = [&](IT::Halfedge_index k) { return lengths_[complex_.edge(k).idx()]; };
    // In units of the longest side, lest a square overflows.
    const double longest =
      std::fmax(length(h), std::fmax(length(complex_.next(h)), length(complex_.prev(h))));
    const double ij = length(h) / longest, jk = length(complex_.next(h)) / longest,
                 ki = length(complex_.prev(h)) / longest;
    const double p = IT::twice_scalar_product<double>(jk * jk, ki * ki, ij * ij);
    const double q = IT::squared_four_areas_from_lengths(ij, jk, ki);
    return q > 0 ? p / std::sqrt(q)
                 : std::copysign(std::numeric_limits<double>::infinity(), p);
  }

  const Triangulation& triangulation_;
  const IT::Delta_complex& complex_;
  std::vector<double> lengths_;
  std::vector<double> areas_;
  std::vector<std::uint8_t> has_area_;
  std::vector<double> weights_;
};

} // namespace idt

#endif // IDT_KERNELS_NUMBER_COLLECTOR_H

// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every kernel does, for any traits; each source beside this file instantiates it
// once.

#ifndef IDT_KERNELS_RUN_KERNEL_H
#define IDT_KERNELS_RUN_KERNEL_H

#include "Kernel.h"

#include "../Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/internal/number_conversion.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

template <class Traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const Surface& surface, const Traits& traits)
{
  using FT = typename Traits::FT;
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  if (!surface.has_points()) {
    std::vector<FT> lengths;
    lengths.reserve(surface.lengths.size());
    for (double length : surface.lengths)
      lengths.push_back(IT::internal::convert_number<FT>(length));
    return Triangulation::from_lengths(surface.connectivity, std::move(lengths), traits);
  }
  std::vector<typename Traits::Point_data> points;
  points.reserve(surface.points.size());
  for (const std::array<double, 3>& p : surface.points)
    points.push_back({IT::internal::convert_number<FT>(p[0]),
                      IT::internal::convert_number<FT>(p[1]),
                      IT::internal::convert_number<FT>(p[2])});
  return Triangulation(surface.connectivity, std::move(points), traits);
}

// The squared edge lengths and areas handle a face of zero area; half-angle tangents do
// not, and what they make of it is no answer. The factors are those that
// tan_half_angle() forms, in its order of operations.
template <class Traits>
void require_usable_faces(const IT::Intrinsic_triangulation<Traits>&)
{}
template <class FT>
void require_usable_faces(const IT::Intrinsic_triangulation<IT::Half_angle_traits<FT>>& triangulation)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  const auto length = [&](IT::Halfedge_index h) -> const FT& {
    return triangulation.edge_data(complex.edge(h));
  };
  IT::internal::Offenders offenders;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    const FT &a = length(h), &b = length(complex.next(h)), &c = length(complex.prev(h));
    const auto is_usable = [](const FT& x, const FT& y, const FT& z) {
      return CGAL::certainly(x - y + z > FT(0)) && CGAL::certainly(x + y - z > FT(0)) &&
             CGAL::certainly(y + z - x > FT(0));
    };
    if (!is_usable(a, b, c) || !is_usable(b, c, a) || !is_usable(c, a, b))
      offenders.add(f.idx());
  }
  if (offenders.count > 0)
    throw IT::Invalid_surface_error(
      IT::Invalid_surface_error::Defect::DEGENERATE_FACE, offenders.first, offenders.count,
      "face " + std::to_string(offenders.first) + " has zero area" + offenders.and_more() +
        ", which half-angle tangents cannot handle: choose another number type");
}

// Plain numbers for what leaves the kernel.
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
      has_area_.push_back(CGAL::certainly(area > FT(0)));
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
    if (result < 0 && !complex_.is_border(e) && CGAL::certainly(triangulation_.is_locally_Delaunay(e)))
      result = 0;
    return result;
  }

  // For a face whose area is zero, or not known to be positive.
  double rough_cotangent(IT::Halfedge_index h) const
  {
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

// Marks what was flipped, and asks the caller whether to go on.
class Recording_visitor
{
public:
  Recording_visitor(const Continue_function& go_further, std::vector<std::uint8_t>& is_original)
    : go_further_(go_further), is_original_(is_original)
  {}

  bool go_further(std::uint64_t tests, std::uint64_t flips)
  {
    return !go_further_ || go_further_(tests, flips);
  }
  // An edge that is flipped back onto an input edge counts as changed: only its normal
  // coordinates can tell.
  void after_flip(IT::Edge_index e) { is_original_[e.idx()] = 0; }

private:
  const Continue_function& go_further_;
  std::vector<std::uint8_t>& is_original_;
};

template <class Traits>
Outcome run_kernel(const Job& job, const Traits& traits = Traits())
{
  using FT = typename Traits::FT;
  constexpr bool is_exact = CGAL::Algebraic_structure_traits<FT>::Is_exact::value;

  Outcome outcome;
  Stopwatch stopwatch;
  auto triangulation = make_triangulation(job.surface, traits);
  require_usable_faces(triangulation);
  outcome.build_seconds = stopwatch.restart();

  outcome.weights_before = Number_collector(triangulation).summary();
  const std::size_t number_of_edges = triangulation.connectivity().number_of_edges();
  outcome.is_original.assign(number_of_edges, 1);
  Recording_visitor visitor(job.go_further, outcome.is_original);
  const std::uint64_t budget = job.options.maximum_number_of_flips.value_or(
    is_exact ? (std::numeric_limits<std::uint64_t>::max)()
             : IT::default_maximum_number_of_flips(number_of_edges));
  stopwatch.restart();
  outcome.report = IT::flip_to_Delaunay(
    triangulation, CGAL::parameters::visitor(std::ref(visitor)).maximum_number(budget));
  outcome.flip_seconds = stopwatch.restart();

  Number_collector collector(triangulation);
  outcome.weights_after = collector.summary();
  collector.move_to(outcome);
  outcome.connectivity = triangulation.connectivity();
  return outcome;
}

} // namespace idt

#endif // IDT_KERNELS_RUN_KERNEL_H

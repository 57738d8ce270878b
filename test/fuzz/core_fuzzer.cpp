// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Glued triangles with any lengths: they are refused for a good reason, or their intrinsic Delaunay triangulation and
// its overlay pass every check.

#include "Metric_gluing.h"
#include "check_core.h"
#include "fuzz_target.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace {

using fuzz::Metric_gluing;
using fuzz::require;
namespace IT = fuzz::IT;
using Defect = IT::Invalid_surface_error::Defect;
using Rational = IT::Rational;
using Filtered = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Some lengths need as many flips as one length holds the other, and on a spiral the time that
// an exact decision takes grows with the square of the crossings.
constexpr std::uint64_t flip_budget = 30;
constexpr std::uint32_t crossing_budget = 80;

std::vector<Rational> squared_distances(const Metric_gluing& input)
{
  const IT::Input_metric metric = IT::Input_metric::from_points({input.points.begin(), input.points.end()});
  std::vector<Rational> result;
  for (IT::Edge_index e : input.connectivity.edges())
    result.push_back(squared_length(metric, input.connectivity, e));
  return result;
}

template <class Traits>
IT::Intrinsic_triangulation<Traits> make_triangulation(const Metric_gluing& input)
{
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  if (!input.lengths.empty())
    return Triangulation::from_lengths(input.connectivity, input.lengths);
  if constexpr (Triangulation::uses_exact_geometry)
    if (input.metric == Metric_gluing::Metric::SQUARED_DISTANCES)
      return Triangulation::from_metric(input.connectivity, IT::metric_from_squared_lengths(squared_distances(input)));
  return Triangulation(input.connectivity, input.points);
}

// Exact defects of the numbers.
struct Faults
{
  explicit Faults(const Metric_gluing& input)
  {
    for (double l : input.lengths)
      if (!(l > 0) || !std::isfinite(l)) {
        not_finite = true;
        return;
      }
    std::vector<Rational> squares;
    if (input.lengths.empty())
      squares = squared_distances(input);
    else
      for (double l : input.lengths)
        squares.push_back(Rational(l) * Rational(l));
    Rational smallest = squares[0], largest = squares[0];
    for (const Rational& s : squares) {
      zero_length = zero_length || s == 0;
      smallest = s < smallest ? s : smallest;
      largest = s > largest ? s : largest;
    }
    wide_range = largest > smallest * Rational(0x1p400);
    for (IT::Face_index f : input.connectivity.faces()) {
      const auto square = [&](IT::Halfedge_index h) { return squares[input.connectivity.edge(h).idx()]; };
      const IT::Halfedge_index h = input.connectivity.halfedge(f);
      const Rational s = square(h), t = square(input.connectivity.next(h)), u = square(input.connectivity.prev(h));
      const Rational q = 4 * s * t - (s + t - u) * (s + t - u); // 16 squared areas
      no_triangle = no_triangle || q < 0;
      no_area = no_area || q == 0;
    }
  }

  bool not_finite = false, zero_length = false, no_triangle = false, no_area = false, wide_range = false;

  bool explain(const IT::Invalid_surface_error& error) const
  {
    switch (error.defect()) {
    case Defect::NOT_FINITE:
      return not_finite;
    case Defect::ZERO_LENGTH_EDGE:
      return zero_length;
    case Defect::TRIANGLE_INEQUALITY:
      return no_triangle;
    case Defect::OUT_OF_RANGE:
      return wide_range;
    default:
      return false;
    }
  }
};

// Every number type ends with a valid triangulation and without NaN.
template <class Traits>
void check_inexact(const Metric_gluing& input, const Faults& faults, const Filtered* exact)
{
  using Triangulation = IT::Intrinsic_triangulation<Traits>;
  std::optional<Triangulation> triangulation;
  try {
    triangulation.emplace(make_triangulation<Traits>(input));
  } catch (const IT::Invalid_surface_error& error) {
    require(error.what()[0] != 0, "an exception has a message");
    // Faces without area after rounding count as degenerate for it.
    require(!exact || faults.wide_range || error.defect() == Defect::DEGENERATE_FACE,
            std::string("an inexact number type accepts what is a surface: ") + error.what());
    return;
  }
  triangulation->keep_input(input.lengths.empty()
                              ? IT::Input_metric::from_points({input.points.begin(), input.points.end()})
                              : IT::Input_metric::from_lengths(input.lengths));
  const IT::Flip_report report = IT::flip_to_Delaunay(*triangulation, CGAL::parameters::maximum_number(flip_budget));
  require(triangulation->connectivity().is_valid(true), "the connectivity is valid after rounded flips");
  if (exact && !faults.no_area && report.status == IT::Flip_status::DELAUNAY)
    fuzz::compare_results(*triangulation, *exact);
}

void check_all(const Metric_gluing& input)
{
  const Faults faults(input);
  std::optional<Filtered> triangulation;
  try {
    triangulation.emplace(make_triangulation<IT::Filtered_edge_length_traits>(input));
  } catch (const IT::Invalid_surface_error& error) {
    require(error.what()[0] != 0, "an exception has a message");
    require(faults.explain(error), std::string("the surface is as it was said to be: ") + error.what());
  }
  require(!triangulation || !(faults.not_finite || faults.zero_length || faults.no_triangle),
          "what is no surface is refused");
  bool is_done = false;
  if (triangulation) {
    fuzz::Recording_visitor record(triangulation->connectivity(), crossing_budget);
    try {
      try {
        const IT::Flip_report report =
          IT::flip_to_Delaunay(*triangulation, CGAL::parameters::visitor(std::ref(record)).maximum_number(flip_budget));
        is_done = report.status == IT::Flip_status::DELAUNAY;
        require(is_done || report.status == IT::Flip_status::BUDGET_EXHAUSTED,
                "exact decisions end with a Delaunay triangulation, unless they are stopped");
      } catch (const IT::Cancelled_error&) {
      }
      fuzz::check_result(*triangulation, record, input.connectivity, is_done, faults.no_area, !faults.wide_range);
    } catch (const IT::Invalid_surface_error& error) {
      // Vertices at distance zero are found on the way.
      require(error.what()[0] != 0, "an exception has a message");
      require(faults.no_area && error.defect() == Defect::ZERO_LENGTH_EDGE,
              std::string("flips fail for no good reason: ") + error.what());
      is_done = false;
    }
  }
  const Filtered* const exact = is_done ? &*triangulation : nullptr;
  check_inexact<IT::Edge_length_traits<double>>(input, faults, exact);
  check_inexact<IT::Half_angle_traits<double>>(input, faults, exact);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  fuzz::Bytes bytes(data, size);
  check_all(fuzz::decode_metric_gluing(bytes));
  return 0;
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Properties of every intrinsic Delaunay triangulation.

#ifndef IDT_TEST_FUZZ_CHECK_CORE_H
#define IDT_TEST_FUZZ_CHECK_CORE_H

#include "fuzz_target.h"
#include "overlay_triangulations.h"
#include "property/Incremental_overlay_check.h"
#include "property/flip_test_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fuzz {

namespace IT = CGAL::Intrinsic_triangulations;
using Filtered_triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Remembers the flips, does them in the overlay, and stops when that becomes too large.
struct Recording_visitor
{
  Recording_visitor(const IT::Delta_complex& input, std::uint32_t crossing_budget)
    : overlay(input), budget(crossing_budget)
  {}
  bool go_further(const IT::Progress&) const { return overlay.number_of_crossings() <= budget; }
  void after_flip(IT::Edge_index e)
  {
    flips.push_back(e);
    overlay.flip(e);
  }

  IT::Incremental_overlay overlay;
  std::vector<IT::Edge_index> flips;
  std::uint32_t budget;
};

// The overlay from the integers and from single flips, and the triangulations read back from it.
inline void check_overlay(const Filtered_triangulation& triangulation, const Recording_visitor& record,
                          const IT::Delta_complex& input)
{
  const IT::Overlay overlay(triangulation);
  require(overlay_check::is_valid(record.overlay), "the incremental overlay is valid");
  require(overlay_check::are_same_overlay(overlay, record.overlay), "both overlays are the same");
  require(test_surfaces::are_same_links(IT::intrinsic_triangulation_of(overlay), triangulation.connectivity()),
          "the overlay contains the result");
  require(test_surfaces::are_same_links(IT::input_triangulation_of(overlay), input), "the overlay contains the input");
}

inline void check_positions(const IT::Overlay& overlay, const IT::Overlay_positions& positions)
{
  const auto check = [](double position, double& last, const char* edge) {
    require(position >= last && position <= 1, std::string("crossings come in order along an ") + edge + " edge");
    last = position;
  };
  for (std::uint32_t e = 0; e < overlay.number_of_intrinsic_edges(); ++e) {
    double last = 0;
    for (IT::Overlay::Vertex x : overlay.intrinsic_crossings(IT::Edge_index(e)))
      check(positions.on_intrinsic_edge(x), last, "intrinsic");
  }
  for (std::uint32_t e = 0; e < overlay.number_of_input_edges(); ++e) {
    double last = 0;
    for (std::uint32_t i = 0; i + 1 < overlay.number_of_input_segments(IT::Edge_index(e)); ++i)
      check(positions.on_input_edge(overlay.input_crossing(IT::Edge_index(e), i)), last, "input");
  }
}

// Each face of either triangulation is the sum of the faces of the overlay in it.
inline void check_areas(const Filtered_triangulation& triangulation, const IT::Common_subdivision& subdivision,
                        const std::vector<double>& input_areas)
{
  std::vector<double> areas;
  try {
    areas = IT::face_areas(subdivision);
  } catch (const IT::Invalid_surface_error& error) { // beyond the range of double
    require(error.defect() == IT::Invalid_surface_error::Defect::OUT_OF_RANGE, error.what());
    return;
  }
  const std::vector<double> intrinsic_areas = IT::face_areas(triangulation);
  std::vector<double> in_input(input_areas.size()), in_intrinsic(intrinsic_areas.size());
  const IT::Overlay& overlay = subdivision.overlay();
  for (IT::Overlay::Face f : overlay.faces()) {
    in_input[overlay.input_face(f).idx()] += areas[f.idx()];
    in_intrinsic[overlay.intrinsic_face(f).idx()] += areas[f.idx()];
  }
  double total = 0;
  for (double area : input_areas)
    total += area;
  // Areas that are denormalized have few digits.
  const double tolerance = 1e-9 * total + 1e-300;
  for (std::size_t f = 0; f < in_input.size(); ++f)
    require(std::abs(in_input[f] - input_areas[f]) <= tolerance, "the overlay covers each input face");
  for (std::size_t f = 0; f < in_intrinsic.size(); ++f)
    require(std::abs(in_intrinsic[f] - intrinsic_areas[f]) <= tolerance, "the overlay covers each intrinsic face");
}

inline void check_numbers(const Filtered_triangulation& triangulation, bool is_Delaunay, bool has_no_area)
{
  const IT::Delta_complex& complex = triangulation.connectivity();
  for (IT::Edge_index e : complex.edges()) {
    const double length = triangulation.length(e);
    require(length > 0 && std::isfinite(length), "lengths are positive and finite");
  }
  try {
    const std::vector<double> weights = IT::cotangent_weights(triangulation);
    for (IT::Edge_index e : complex.edges()) {
      require(std::isfinite(weights[e.idx()]), "weights are finite");
      require(!is_Delaunay || !complex.is_flippable(e) || weights[e.idx()] >= 0, "no weight is negative");
    }
  } catch (const IT::Invalid_surface_error& error) {
    require(error.defect() == IT::Invalid_surface_error::Defect::OUT_OF_RANGE ||
              (has_no_area && error.defect() == IT::Invalid_surface_error::Defect::DEGENERATE_FACE),
            std::string("there are no weights: ") + error.what());
  }
}

// All flips once more, each three times, from the last to the first: four are the identity.
inline void check_flips_back(Filtered_triangulation triangulation, const std::vector<IT::Edge_index>& flips,
                             const IT::Delta_complex& input)
{
  for (std::size_t i = flips.size(); i-- > 0;)
    for (int turn = 0; turn < 3; ++turn)
      require(triangulation.flip(flips[i]) == Filtered_triangulation::Flip_outcome::FLIPPED,
              "what was flipped can be flipped back");
  require(test_surfaces::are_same_links(triangulation.connectivity(), input), "flips back lead to the input");
  const IT::internal::Correspondence& correspondence = IT::internal::engine(triangulation).correspondence();
  for (IT::Edge_index e : input.edges())
    require(correspondence.coordinates().is_original(e), "an edge that was flipped back is an input edge");
  for (IT::Halfedge_index h : input.halfedges())
    if (!input.is_border(h))
      require(correspondence.input_halfedge(h) == h, "a halfedge that was flipped back is itself");
}

inline void check_result(const Filtered_triangulation& triangulation, const Recording_visitor& record,
                         const IT::Delta_complex& input, bool is_done, bool has_no_area, bool has_accurate_areas)
{
  require(triangulation.connectivity().is_valid(true), "the connectivity is valid");
  const IT::Delaunay_verification verification = IT::verify_Delaunay(triangulation);
  require(verification.inverted.empty(), "no face is inverted");
  require(!is_done || verification.is_Delaunay(), "the result is Delaunay");
  check_overlay(triangulation, record, input);
  const IT::Common_subdivision subdivision(triangulation);
  check_positions(subdivision.overlay(), subdivision.positions());
  check_numbers(triangulation, is_done, has_no_area);
  const auto& geometry = IT::internal::engine(triangulation);
  std::vector<double> input_areas;
  for (IT::Face_index f : input.faces())
    input_areas.push_back(
      std::ldexp(geometry.metric().four_areas_double_double(input, f).hi() / 4, 2 * triangulation.unit_exponent()));
  if (has_accurate_areas)
    check_areas(triangulation, subdivision, input_areas);
  // A flip that straightens an angle cannot be made the other way round.
  if (!has_no_area)
    check_flips_back(triangulation, record.flips, input);
}

// The edges of a triangulation, each identified by its crossings.
template <class Triangulation>
std::vector<std::vector<std::uint32_t>> named_edges(const Triangulation& triangulation)
{
  const IT::Overlay overlay(triangulation);
  std::vector<std::vector<std::uint32_t>> names;
  for (IT::Edge_index e : triangulation.connectivity().edges()) {
    const IT::Overlay::Halfedge first = overlay.halfedge(*overlay.intrinsic_segments(e).begin());
    if (overlay.input_halfedge(first).is_valid()) {
      names.push_back({0, overlay.input_halfedge(first).idx() / 2});
      continue;
    }
    // In one direction the input halfedges, in the other their opposites in reverse order.
    std::vector<std::uint32_t> forward{1}, backward{1};
    for (IT::Overlay::Vertex x : overlay.intrinsic_crossings(e)) {
      forward.push_back(overlay.crossing_input_halfedge(x).idx());
      backward.push_back(overlay.crossing_input_halfedge(x).idx() ^ 1);
    }
    std::reverse(backward.begin() + 1, backward.end());
    names.push_back((std::min)(forward, backward));
  }
  std::sort(names.begin(), names.end());
  return names;
}

// If no four vertices lie on an empty circle, there is one Delaunay triangulation: a rounded result that is proven
// Delaunay is the exact one.
template <class Triangulation>
void compare_results(const Triangulation& rounded, const Filtered_triangulation& exact)
{
  const IT::Delaunay_verification verification = IT::verify_Delaunay(rounded);
  if (!verification.is_Delaunay() || verification.ties > 0)
    return;
  require(IT::verify_Delaunay(exact).ties == 0, "two Delaunay triangulations have the same ties");
  require(named_edges(rounded) == named_edges(exact), "there is one Delaunay triangulation");
}

} // namespace fuzz

#endif // IDT_TEST_FUZZ_CHECK_CORE_H

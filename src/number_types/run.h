// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a surface to its intrinsic Delaunay triangulation as plain numbers, computed with any number type.

#ifndef IDT_NUMBER_TYPES_RUN_H
#define IDT_NUMBER_TYPES_RUN_H

#include "input/Surface.h"
#include "number_types/Number_type.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/reports.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace idt {

// The results that a run determines besides the flips; results that are not requested cost nothing.
struct Requested_results
{
  bool weights = false;         // their summaries, before and after
  bool lengths = false;         // of the result
  bool numbers = false;         // lengths, weights and areas of the result
  bool input_numbers = false;   // lengths, weights and areas of the input
  bool crossings = false;       // where the input lies in the result
  bool tessellation = false;    // ties and cells, of a result that is Delaunay
  bool verification = false;    // the exact check of each edge
  bool exact_lengths = false;   // of the edges of the result, for any number type
  bool wrong_decisions = false; // compares each test with the exact one
  bool overlay = false;         // of input and result, with the positions of the crossings
  bool shapes = false;          // of the faces of the result
  bool saved = false;           // the triangulation as a file, with FILTERED alone

  bool needs_input() const
  {
    return crossings || tessellation || verification || exact_lengths || wrong_decisions || overlay || shapes || saved;
  }
};

// A face that refinement has left or is working on, by its shortest side.
struct Short_side
{
  double length = 0;
  std::optional<std::array<double, 3>> place; // of an end, if the surface is in space
};

// The named parameters of `refine_Delaunay()`.
struct Refinement_criteria
{
  double minimum_angle = 25;
  double maximum_circumradius = std::numeric_limits<double>::infinity();
  double maximum_edge_length = std::numeric_limits<double>::infinity();
  double maximum_deviation = std::numeric_limits<double>::infinity();
  std::optional<double> minimum_size;     // the library chooses it otherwise
  std::optional<double> sharp_edge_angle; // in degrees
  std::optional<double> normal_angle;     // likewise
  double gradation = 0.3;                 // of sizes
};

// The task of Delaunay refinement after the flips.
struct Refinement_options
{
  Refinement_criteria criteria;
  std::optional<std::uint64_t> maximum_number_of_points;
  std::vector<bool> is_constrained; // for each input edge: whether no flip may remove it
  std::vector<bool> is_whole;       // for each input edge: whether it must not be split, either
  std::vector<double> sizes;        // at each vertex of the input: how long edges may be
  // Called before each face is refined, and may ask where that face is.
  std::function<void(const CGAL::Intrinsic_triangulations::Refinement_progress&, const std::function<Short_side()>&)>
    look;
};

struct Run_options
{
  Number_type number_type = default_number_type;
  int precision = 128; // bits at least, for MPFR alone
  std::optional<std::uint64_t> maximum_number_of_flips;
  CGAL::Intrinsic_triangulations::Tie_proof tie_proof = CGAL::Intrinsic_triangulations::Tie_proof::PROBABLE_IF_COSTLY;
  bool keeps_saved = false;                     // a saved triangulation is not flipped any more
  std::optional<Refinement_options> refinement; // with FILTERED alone
  Requested_results wanted;
};

// Called before each test, with the numbers of tests and flips so far; returning `false` ends the flips.
using Continue_function = std::function<bool(std::uint64_t tests, std::uint64_t flips)>;
// The same for refinement, before each new vertex.
using Continue_refining_function = std::function<bool(const CGAL::Intrinsic_triangulations::Refinement_progress&)>;

struct Job
{
  const Surface& surface;
  Run_options options;
  Continue_function go_further;
  // Called during long exact decisions; returning false ends them, and the result is omitted or taken from the stored
  // numbers.
  std::function<bool()> go_on_deciding;
  // Called during the construction of the overlay, and once right after the flips; returning false omits the overlay.
  CGAL::Intrinsic_triangulations::Progress_function overlay_progress;
  Continue_refining_function refine_further = {};
};

// Statistics from the normal coordinates.
struct Crossing_summary
{
  std::uint64_t simple = 0;    // intrinsic edges that cross exactly one input edge
  std::uint64_t longest = 0;   // the largest number of segments in one intrinsic edge
  std::uint64_t crossings = 0; // in all
  std::uint64_t changed = 0;   // intrinsic edges that are not input edges
  double seconds = 0;          // for these numbers, and for the graph of the overlay if it was requested
  double position_seconds = 0; // for the positions of the crossings in the overlay
};

// The cells of a Delaunay triangulation that are left when its ties are removed.
struct Tessellation_summary
{
  std::size_t ties = 0;
  std::size_t cells = 0;
};

// The results of refinement.
struct Refinement_summary
{
  bool is_cancelled = false; // by the caller; the report then lists the faces that do not meet the criteria
  CGAL::Intrinsic_triangulations::Refinement_report report;
  std::vector<CGAL::Intrinsic_triangulations::Surface_point> points; // on the input, of the new vertices in order
  std::vector<bool> is_constrained;                                  // for each input edge: those given, and sharp ones
  // The face with the shortest side among those left as too small or for the budget.
  std::optional<Short_side> smallest_left;
  // A smallest size with which, judged by areas, a tenth of the budget would suffice for the remaining faces; 0 if
  // unknown.
  double sufficient_size = 0;
  double seconds = 0;
};

// The worst faces.
struct Shape_summary
{
  double minimum_angle = 0;                    // in degrees
  std::optional<double> minimum_refined_angle; // of the faces that refinement does not list, if any
  double maximum_circumradius = 0;             // infinite beside a face of zero area
};

// No number is NaN. A weight beside a face of zero area is infinite. Results that were not requested or could not be
// determined are empty.
struct Outcome
{
  CGAL::Intrinsic_triangulations::Delta_complex connectivity;
  CGAL::Intrinsic_triangulations::Element_numbers numbers;       // of the result
  CGAL::Intrinsic_triangulations::Element_numbers input_numbers; // before the flips
  std::vector<std::int64_t> crossings;                           // for each edge: -1 if it is an input edge
  // If the surface was untwisted: how often each edge crosses edges of the surface before that.
  std::optional<CGAL::Intrinsic_triangulations::Crossing_counts> original_crossings;
  std::vector<double> exact_lengths; // for each edge, within one unit in the last place
  std::vector<std::uint8_t> is_tie;  // for each edge
  CGAL::Intrinsic_triangulations::Flip_report report;
  bool are_flips_cancelled = false; // cancelled by the caller; the report has the numbers until then
  std::string failure;              // why the flips ended, or a result could not be determined
  bool is_interrupted = false;      // the caller cancelled something other than flips
  // The number of tests decided by each stage, for the number type that has stages.
  std::optional<CGAL::Intrinsic_triangulations::Stage_counts> stages;
  std::optional<CGAL::Intrinsic_triangulations::Weight_summary> weights_before;
  std::optional<CGAL::Intrinsic_triangulations::Weight_summary> weights_after;
  std::optional<Crossing_summary> crossing_summary;
  std::optional<CGAL::Intrinsic_triangulations::Common_subdivision> subdivision;
  std::optional<Tessellation_summary> tessellation;
  std::optional<Refinement_summary> refinement;
  std::optional<Shape_summary> shapes;
  std::optional<CGAL::Intrinsic_triangulations::Delaunay_verification> verification;
  std::string saved; // the bytes of a file, or none
  std::optional<std::uint64_t> wrong_decisions;
  double build_seconds = 0;
  double flip_seconds = 0;
  double check_seconds = 0;   // for verification, ties and shapes
  double number_seconds = 0;  // for lengths, weights and areas of the result
  double summary_seconds = 0; // for the summaries of weights
};

// Makes a surface Delaunay with the number type that the options name.
// \exception Invalid_surface_error if the number type cannot hold the surface
// \exception Undecided_error if it cannot make a decision that the construction needs
Outcome run(const Job& job);

} // namespace idt

#endif // IDT_NUMBER_TYPES_RUN_H

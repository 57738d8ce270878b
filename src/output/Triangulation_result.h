// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that a run of `idt triangulate` knows about one input, and its forms of output.

#ifndef IDT_TRIANGULATION_RESULT_H
#define IDT_TRIANGULATION_RESULT_H

#include "system/Exit_status.h"
#include "input/Surface.h"
#include "number_types/run.h"

#include <CGAL/Intrinsic_triangulations/straight_mesh.h>

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace idt {

struct Triangulation_result
{
  static constexpr double thin_angle = 10; // of straight triangles, in degrees

  Surface surface;
  Run_options options;
  Outcome outcome;
  std::string smallest_size;            // of a refinement, and why it was chosen
  std::optional<double> flat_tolerance; // the tolerance for the removal of flat vertices, if any
  double flat_deviation = 0;            // and a bound on how far it moved the surface
  std::optional<CGAL::Intrinsic_triangulations::Straight_mesh> straight; // if requested
  // Why there is no Laplacian, although it was requested.
  std::optional<CGAL::Intrinsic_triangulations::Invalid_surface_error> no_Laplacian;
  Surface_counts counts;                                    // of the intrinsic triangulation
  double count_seconds = 0;                                 // for `counts`
  std::vector<std::pair<const char*, double>> file_seconds; // for each file, by the option that requested it

  // For all of them.
  double write_seconds() const
  {
    double sum = 0;
    for (const auto& [option, seconds] : file_seconds)
      sum += seconds;
    return sum;
  }
};

// The exit status for the outcome, and for the straight triangles, too.
Exit_status exit_status(const Outcome& outcome);
Exit_status exit_status(const Triangulation_result& result);

// How it ended, for programs: `done`, `interrupted`, `flip budget`, `point budget`, `undecided`, `not flippable`,
// `inconsistent`, `not Delaunay`, `no surface` or `bad triangles` that are straight, or `incomplete` if something could
// not be determined.
const char* status_word(const Triangulation_result& result);

// The same in words, with the first edge to blame.
std::string describe_status(const Triangulation_result& result);

// Why a face was left as it is, in words.
const char* name(CGAL::Intrinsic_triangulations::Refinement_obstacle reason);

// The number of faces left, by reason; reasons without a face are missing.
std::map<std::string, std::size_t> unrefined_faces(const Outcome& outcome);

// "1.2e-07 at (0.1, 0.2, 0.3)"
std::string text(const Short_side& side);

// The result of the exact check, in words. \pre it was made
std::string describe_verification(const Outcome& outcome);

// The text for people: the essentials, or everything known.
void write_report(std::ostream& os, const Triangulation_result& result, bool is_verbose);

// The object for programs; unknown values are null.
nlohmann::ordered_json statistics(const Triangulation_result& result);

// The intrinsic edges as comma-separated values:
// `source,target,length,cotan_weight,crossings,original`.
void write_edges(std::ostream& os, const Triangulation_result& result);

// The vertices that refinement has inserted as comma-separated values:
// `vertex,input_face,b0,b1,b2,x,y,z`, with barycentric coordinates in the order of the corners of the face.
void write_points(std::ostream& os, const Triangulation_result& result);

// Stiffness and lumped mass matrix of the result in the format Matrix Market.
// \exception Invalid_surface_error if a weight is infinite, next to a face without area
void write_Laplacian(std::ostream& os, const Triangulation_result& result);
void write_mass(std::ostream& os, const Triangulation_result& result);

// The crossings along each intrinsic edge in order, as comma-separated values:
// `source,target,edge,position,input_source,input_target,t,u`. \pre the overlay was found
void write_crossings(std::ostream& os, const Triangulation_result& result);

} // namespace idt

#endif // IDT_TRIANGULATION_RESULT_H

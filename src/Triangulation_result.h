// SPDX-License-Identifier: GPL-3.0-or-later
//
// Everything that a run of `idt triangulate` knows about one input, and the forms in
// which it is told.

#ifndef IDT_TRIANGULATION_RESULT_H
#define IDT_TRIANGULATION_RESULT_H

#include "Exit_status.h"
#include "Surface.h"
#include "kernels/Kernel.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

namespace idt {

// What needs the common refinement of the input and the intrinsic triangulation; none of
// it is known yet where that was not built.
struct Overlay_counts
{
  std::uint64_t simple = 0;    // intrinsic edges that cross exactly one input edge
  std::uint64_t longest = 0;   // the largest number of segments in one intrinsic edge
  std::uint64_t crossings = 0; // in all
  double seconds = 0;
};

struct Triangulation_result
{
  Surface surface;
  Kernel_options options;
  Outcome outcome;
  Surface_counts counts; // of the intrinsic triangulation
  std::optional<Overlay_counts> overlay;
  double write_seconds = 0;
};

// The number of edges of the result that are not known to be input edges.
std::size_t number_of_changed_edges(const Outcome& outcome);

// What the end of the flips means for the shell.
Exit_status exit_status(const CGAL::Intrinsic_triangulations::Flip_report& report);

// The same in words, with the first edge that is to blame.
std::string describe_status(const Triangulation_result& result);

// The text that people read.
void write_report(std::ostream& os, const Triangulation_result& result);

// The object that programs read; what is not known is null.
nlohmann::ordered_json statistics(const Triangulation_result& result);

// The intrinsic edges as comma-separated values:
// `source,target,length,cotan_weight,crossings,original`.
void write_edges(std::ostream& os, const Triangulation_result& result);

} // namespace idt

#endif // IDT_TRIANGULATION_RESULT_H

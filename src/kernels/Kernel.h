// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one interface behind which each number type is compiled by itself: a surface goes
// in, its intrinsic Delaunay triangulation comes out as plain numbers.

#ifndef IDT_KERNELS_KERNEL_H
#define IDT_KERNELS_KERNEL_H

#include "../Number_type.h"
#include "../Surface.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace idt {

struct Kernel_options
{
  Number_type number_type = default_number_type;
  int precision = 128; // bits at least, for MPFR alone
  std::optional<std::uint64_t> maximum_number_of_flips;
};

// Is asked before each test, with the numbers of tests and flips so far; the flips end
// when it answers `false`.
using Continue_function = std::function<bool(std::uint64_t tests, std::uint64_t flips)>;

struct Job
{
  const Surface& surface;
  Kernel_options options;
  Continue_function go_further;
};

// The smallest cotangent weight of an interior edge, and how many are negative.
struct Weight_summary
{
  std::optional<double> smallest; // none if there is no interior edge
  std::size_t negative = 0;
};

// No number is NaN. A weight beside a face of zero area is infinite.
struct Outcome
{
  CGAL::Intrinsic_triangulations::Delta_complex connectivity;
  std::vector<double> lengths;           // for each edge
  std::vector<double> weights;           // for each edge, cot + cot
  std::vector<double> areas;             // for each face
  std::vector<std::uint8_t> is_original; // for each edge: it was never flipped
  CGAL::Intrinsic_triangulations::Flip_report report;
  Weight_summary weights_before;
  Weight_summary weights_after;
  double build_seconds = 0;
  double flip_seconds = 0;
};

// Makes a surface Delaunay with the number type that the options name.
// \exception Invalid_surface_error if the number type cannot hold the surface
// \exception Undecided_error if it cannot decide something that must be
Outcome run(const Job& job);

// Whether the command was built with a number type.
bool is_available(Number_type number_type);

// One for each number type, each in a file of its own.
Outcome run_double(const Job& job);
Outcome run_float(const Job& job);
Outcome run_long_double(const Job& job);
Outcome run_interval(const Job& job);
Outcome run_mpfr(const Job& job);
Outcome run_core(const Job& job);
Outcome run_half_angle_double(const Job& job);
Outcome run_half_angle_core(const Job& job);

} // namespace idt

#endif // IDT_KERNELS_KERNEL_H

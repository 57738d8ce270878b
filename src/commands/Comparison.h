// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of several number types on the same surface, each compared with the exact one.

#ifndef IDT_COMPARISON_H
#define IDT_COMPARISON_H

#include "number_types/Number_type.h"
#include "input/Surface.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace idt {

struct Compared_type
{
  Number_type number_type = default_number_type;
  std::optional<int> precision; // of MPFR alone
};

// "mpfr 128"
std::string title(const Compared_type& type);

struct Comparison_options
{
  std::vector<Compared_type> types;
  double time_limit = 10; // seconds for the flips with one type
  int repetitions = 5;
  Repair_options repair;
  // By default, decisions are checked only on small surfaces.
  std::optional<bool> counts_wrong_decisions;
};

constexpr std::size_t large_number_of_edges = 100000;

// Unknown values are empty.
struct Comparison_row
{
  Compared_type type;
  // `done`, or how else it ended: `not flippable`, `inconsistent`, `undecided`; or why it
  // did not end: `flip budget`, `time limit`, `overflow`, `crashed`; or `refused` if the
  // number type cannot hold the surface.
  std::string status;
  std::optional<std::uint64_t> flips;
  std::optional<std::uint64_t> tests;
  std::optional<std::uint64_t> wrong_decisions; // tests that exact arithmetic decides differently
  std::optional<std::uint64_t> not_Delaunay;    // edges of the result, by the exact check
  std::optional<std::uint64_t> inverted_faces;
  std::optional<std::uint64_t> missing_edges; // edges of the exact result, except ties
  std::optional<double> length_error;         // the largest relative one
  std::optional<double> seconds;              // to build and to flip
  std::optional<double> ratio_to_double;

  bool was_refused() const { return status == "refused"; }
  bool has_ended() const;
  // Whether the result is known not to be a Delaunay triangulation.
  bool is_wrong() const;
};

struct Surface_comparison
{
  std::string path;
  Surface_counts counts; // of the exact result
  std::size_t ties = 0;
  Repairs repairs; // if requested
  std::vector<std::string> warnings;
  std::vector<Comparison_row> rows;
};

// Compares the number types on a surface.
// \exception Invalid_surface_error if the surface cannot be used
// \exception Undecided_error if there is no exact result for comparison
Surface_comparison compare(const std::string& path, const Comparison_options& options);

// One number type over several surfaces.
struct Comparison_total
{
  Compared_type type;
  std::size_t surfaces = 0;
  std::size_t refused = 0;
  std::size_t not_ended = 0;
  std::size_t wrong = 0;     // surfaces with a wrong result ...
  std::size_t unnoticed = 0; // ... that the number type does not report
  std::uint64_t wrong_decisions = 0;
  std::uint64_t not_Delaunay = 0;
  std::uint64_t inverted_faces = 0;
  std::uint64_t missing_edges = 0;
  std::optional<double> length_error;    // the largest
  std::optional<double> ratio_to_double; // the median
};

std::vector<Comparison_total> totals(const std::vector<Surface_comparison>& comparisons,
                                     const std::vector<Compared_type>& types);

nlohmann::ordered_json to_json_value(const Comparison_row& row);
nlohmann::ordered_json to_json_value(const Surface_comparison& comparison);
nlohmann::ordered_json to_json_value(const Comparison_total& total);

} // namespace idt

#endif // IDT_COMPARISON_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What number types make of the same surface, each beside the exact result.

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
  bool is_repaired = false;
  // Without a wish, decisions are checked for surfaces that are not large.
  std::optional<bool> counts_wrong_decisions;
};

constexpr std::size_t large_number_of_edges = 100000;

// What is not known is empty.
struct Comparison_row
{
  Compared_type type;
  // `done`, or how else it ended: `not flippable`, `inconsistent`, `undecided`; or why it
  // did not end: `flip budget`, `time limit`, `overflow`, `crashed`; or `refused` if the
  // number type cannot hold the surface.
  std::string status;
  std::optional<std::uint64_t> flips;
  std::optional<std::uint64_t> tests;
  std::optional<std::uint64_t> wrong_decisions; // tests that exact arithmetic decides otherwise
  std::optional<std::uint64_t> not_Delaunay;    // edges of the result, by the exact check
  std::optional<std::uint64_t> inverted_faces;
  std::optional<std::uint64_t> missing_edges; // edges of the exact result, ties apart
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
  Repairs repairs; // if it was asked for
  std::vector<std::string> warnings;
  std::vector<Comparison_row> rows;
};

// Compares the number types on a surface.
// \exception Invalid_surface_error if the surface cannot be used
// \exception Undecided_error if there is no exact result to compare with
Surface_comparison compare(const std::string& path, const Comparison_options& options);

// One number type over several surfaces.
struct Comparison_total
{
  Compared_type type;
  std::size_t surfaces = 0;
  std::size_t refused = 0;
  std::size_t not_ended = 0;
  std::size_t wrong = 0;     // surfaces whose result is wrong ...
  std::size_t unnoticed = 0; // ... though the number type does not say so
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

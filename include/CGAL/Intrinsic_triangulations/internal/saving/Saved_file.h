// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A triangulation and its input in a file.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_FILE_H

#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Saved_triangulation.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <array>
#include <functional>
#include <iosfwd>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The data that define the metric of the input.
enum class Metric_kind {
  POINTS,
  LENGTHS,
  SQUARED_LENGTHS
};

struct Saved_file
{
  Metric_kind metric_kind = Metric_kind::POINTS;
  Delta_complex input;
  Input_metric::Point_vector points; // or
  std::vector<double> lengths;       // or
  Input_metric metric;               // of squared lengths
  Saved_triangulation triangulation;
  std::vector<bool> is_constrained; // for each edge of the triangulation, or empty
  Stage_counts counts;
  Tie_proof tie_proof = Tie_proof::PROBABLE_IF_COSTLY;
};

// Asked for each block of bytes.
using Go_further = std::function<bool()>;

// The data of the traits, as in `Saved_triangulation`, and for each input face the halfedge that is listed first.
struct Stored_numbers
{
  const std::vector<Halfedge_index>& first_sides; // must outlive this; or empty for the one of the input
  std::function<double(Edge_index)> squared_length;
  std::function<std::array<double, 2>(Face_index)> area;
  bool are_known = true; // otherwise the reader computes them
};

// \exception Undecided_error if an edge crosses more input edges than can be laid out
void write_saved_file(std::ostream& os, const Exact_engine& engine, const Stage_counts& counts,
                      const Stored_numbers& numbers, const std::vector<bool>& is_constrained,
                      const Go_further& go_further);
// Checks the connectivity of input and triangulation, and that there is an entry for each element, but nothing that
// needs the metric. Memory: proportional to the bytes read, whatever the header says
Saved_file read_saved_file(std::istream& is, const Go_further& go_further);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_SAVING_SAVED_FILE_H

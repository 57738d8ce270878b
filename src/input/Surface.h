// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An input surface in the form that number types take, from any kind of file.

#ifndef IDT_SURFACE_H
#define IDT_SURFACE_H

#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
struct Repair;
struct Surface_report;
} // namespace CGAL::Intrinsic_triangulations

namespace idt {

// One entry for each kind of repair, none if nothing had to be done; null if no repair was requested.
using Repairs = std::shared_ptr<const std::vector<CGAL::Intrinsic_triangulations::Repair>>;

// Mollification of the lengths, before anything else, on request.
struct Mollification_options
{
  double delta = 0; // relative to the mean length
  bool is_local = false;
};

// The repairs, and the origins of the vertices and faces of the surface.
struct Repair_report
{
  Repairs repairs;
  std::vector<std::size_t> input_vertices, input_faces;
};

struct Repair_options
{
  bool is_wanted = false;
  std::optional<double> stitching_tolerance;
};

struct Saved_triangulation;
struct Triangle_soup;

struct Surface
{
  std::string path;
  CGAL::Intrinsic_triangulations::Delta_complex connectivity;
  // One of the two is empty: the metric comes from points or from edge lengths.
  std::vector<std::array<double, 3>> points;
  std::vector<double> lengths;
  // Their squares, if these are known exactly; the lengths are then rounded roots.
  std::vector<CGAL::Intrinsic_triangulations::Rational> squared_lengths;
  // The triangulation of a file that holds one; this is its input.
  std::shared_ptr<const Saved_triangulation> saved;
  // The untwisting of the file's surface, if it was untwisted.
  std::optional<CGAL::Intrinsic_triangulations::Untwisting> untwisting;
  std::optional<CGAL::Intrinsic_triangulations::Mollification_report> mollification;
  std::optional<Repair_report> repair;                    // if requested
  std::optional<std::vector<std::size_t>> input_vertices; // the origins of the vertices, if flat ones were removed
  std::size_t number_of_removed_vertices = 0;
  // Warnings about a usable surface; and those of them that are no reason for a line on the standard error.
  std::vector<std::string> warnings, notes;
  Stopwatch stopwatch; // since loading began
  double read_seconds = 0;
  double build_seconds = 0;
  double untwist_seconds = 0;

  bool has_points() const { return lengths.empty(); }
};

// Reads a surface from a mesh file, from a `.gluing` file of triangles and lengths, or from a `.idt` file of a saved
// triangulation.
//
// Unused vertices and faces of zero area are accepted and noted. Mollification that changes a length replaces the
// points by lengths.
// \param soup if not null, receives the triangles of a mesh that is no surface but could be repaired; then the surface
//   is empty
// \exception Invalid_surface_error if the surface cannot be used; the message begins
//            with `path` and names the first element at fault and how many more
// \exception Cancelled_error if an interruption ends the reading
Surface load_surface(const std::string& path, const Repair_options& repair_options = {},
                     const std::optional<Mollification_options>& mollification = {},
                     std::optional<Triangle_soup>* soup = nullptr);

// Reports the gaps on the standard error.
// \param advice the remedy
// \return the same texts
std::vector<std::string> gap_warnings(const CGAL::Intrinsic_triangulations::Surface_report& report,
                                      const std::string& path, const std::string& advice);

// Replaces a gluing by its untwisted form.
// \exception Usage_error if the surface has points
void untwist(Surface& surface);

// The part of a report about the connectivity of a surface.
struct Surface_counts
{
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_edges = 0;
  std::size_t components = 0;         // pieces that have faces
  long long euler_characteristic = 0; // of the vertices that have faces
  std::size_t loops = 0;
  std::size_t multiple_edges = 0; // edges, other than loops, that share both ends with another edge
};

Surface_counts count_elements(const CGAL::Intrinsic_triangulations::Delta_complex& complex);

} // namespace idt

#endif // IDT_SURFACE_H

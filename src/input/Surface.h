// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An input surface as the number types take it, whatever kind of file it came from.

#ifndef IDT_SURFACE_H
#define IDT_SURFACE_H

#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/untwist.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
struct Repair;
}

namespace idt {

// One entry for each kind of repair, none if nothing had to be done; null if no repair was asked for. Few want to know
// more about them.
using Repairs = std::shared_ptr<const std::vector<CGAL::Intrinsic_triangulations::Repair>>;

// What is done to the lengths before anything else, if it is asked for.
struct Mollification_options
{
  double delta = 0; // relative to the mean length
  bool is_local = false;
};

// What was mended, and where the vertices and faces of the surface come from.
struct Repair_report
{
  Repairs repairs;
  std::vector<std::size_t> input_vertices, input_faces;
};

struct Saved_triangulation;

struct Surface
{
  std::string path;
  CGAL::Intrinsic_triangulations::Delta_complex connectivity;
  // One of the two is empty: the metric comes from points or from edge lengths.
  std::vector<std::array<double, 3>> points;
  std::vector<double> lengths;
  // Their squares, if these are known better than the lengths, which are rounded roots then.
  std::vector<CGAL::Intrinsic_triangulations::Rational> squared_lengths;
  // The triangulation of a file that holds one, whose input this is.
  std::shared_ptr<const Saved_triangulation> saved;
  // What was done to the surface of the file, if it was untwisted.
  std::optional<CGAL::Intrinsic_triangulations::Untwisting> untwisting;
  std::optional<CGAL::Intrinsic_triangulations::Mollification_report> mollification;
  std::optional<Repair_report> repair;                    // if it was asked for
  std::optional<std::vector<std::size_t>> input_vertices; // where the vertices come from, if flat ones were removed
  std::size_t number_of_removed_vertices = 0;
  // What a user should know though the surface can be used.
  std::vector<std::string> warnings;
  Stopwatch stopwatch; // since loading began
  double read_seconds = 0;
  double build_seconds = 0;
  double untwist_seconds = 0;

  bool has_points() const { return lengths.empty(); }
};

// Reads a surface from a mesh file, from a `.gluing` file of triangles and lengths, or from a `.idt` file of a saved
// triangulation.
//
// Vertices that no face names and faces of zero area are accepted and noted.
// Mollification that changes a length replaces the points by lengths.
// \exception Invalid_surface_error if the surface cannot be used; the message begins
//            with `path` and names the first element at fault and how many more
// \exception Cancelled_error if an interruption ends the reading
Surface load_surface(const std::string& path, bool is_repaired = false,
                     const std::optional<Mollification_options>& mollification = {});

// Replaces a gluing by what untwist() leaves of it.
// \exception Usage_error if the surface has points
void untwist(Surface& surface);

// What a report tells about the connectivity of a surface.
struct Surface_counts
{
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t boundary_edges = 0;
  std::size_t components = 0;         // pieces that have faces
  long long euler_characteristic = 0; // of the vertices that have faces
  std::size_t loops = 0;
  std::size_t multiple_edges = 0; // no loops, but not alone between their two vertices
};

Surface_counts count_elements(const CGAL::Intrinsic_triangulations::Delta_complex& complex);

} // namespace idt

#endif // IDT_SURFACE_H

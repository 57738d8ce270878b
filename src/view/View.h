// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The contents of a page about a surface.

#ifndef IDT_VIEW_H
#define IDT_VIEW_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idt {

// A triangulation and its numbers. Side i of a face runs from its corner i to the next one.
struct View_triangulation
{
  std::size_t number_of_vertices = 0;
  std::vector<std::uint32_t> corners; // three for each face
  std::vector<std::uint32_t> sides;   // the edges of each face
  std::vector<float> weights;         // of the edges: sums of the cotangents, with their signs
  std::vector<float> cotangents;      // of the angles opposite to the sides; NaN in a face without area
  std::vector<float> lengths;         // of the edges
};

// A function that colours the surface.
struct View_field
{
  std::string name, unit;
  bool is_of_faces = false;
  // One for each triangulation, or one for both: at the vertices of the view, or on the faces of the triangulation, the
  // input if there is one.
  std::vector<std::vector<double>> numbers;
};

// An image of the surface in the plane, which is shown beside it. Its third coordinates are zero.
struct View_plane
{
  std::vector<std::array<double, 3>> corners;     // of each triangle
  std::vector<std::array<double, 3>> path, marks; // the images of `View::path` and `View::marks`
};

struct View
{
  std::string title;
  std::string result;                             // the name of the second triangulation
  std::vector<View_triangulation> triangulations; // the input, and the result if there is one
  // The triangles into which they cut the surface. Their vertices are input vertices, inserted ones, and crossings.
  std::vector<std::array<double, 3>> points;
  std::vector<std::uint32_t> corners;            // three for each triangle
  std::vector<std::uint8_t> sides;               // (i + 1) + 4 (j + 1) for side i of the input face and j of the other
  std::vector<std::vector<std::uint32_t>> faces; // for each triangulation, the face that contains the triangle
  std::vector<View_field> fields;
  std::vector<std::array<double, 3>> path; // lines, with NaN between them
  std::string path_name = "the line";
  std::vector<double> path_numbers;         // which colour the lines: for each point, or none
  std::string path_unit;                    // what they are
  std::vector<std::array<double, 3>> marks; // points
  std::string marks_name;
  View_plane plane; // without corners if there is none
};

// The view of an input and of its result.
// \param points, input_numbers of the input
// \param numbers of the result
// \exception Usage_error if it is too large for a page
View make_view(const std::string& title, const std::string& result,
               const CGAL::Intrinsic_triangulations::Common_subdivision& subdivision,
               std::vector<std::array<double, 3>> points,
               const CGAL::Intrinsic_triangulations::Element_numbers& input_numbers,
               const CGAL::Intrinsic_triangulations::Element_numbers& numbers);

// The view of any triangles.
// \exception Usage_error as above
View make_view(const std::string& title, const std::vector<std::array<double, 3>>& points,
               const std::vector<std::array<std::uint32_t, 3>>& triangles);

// Checks the size as far as possible before anything is computed, and whether pages can be written at all; does nothing
// if `path` is empty.
// \exception Usage_error as above, or if the command was built without three.js, or `path` is of another type
void check_view(const std::string& path, std::size_t number_of_triangles = 0);

// Writes the page; does nothing if `path` is empty.
// \exception Output_error as Output_file
void write_view(const std::string& path, const View& view);

} // namespace idt

#endif // IDT_VIEW_H

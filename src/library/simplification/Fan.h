// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces around a vertex that is about to be removed, how they are laid flat, and how the hole is triangulated: in
// doubles. Nothing relies on these numbers: Fan_proof.h proves the result.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_H

#include <boost/container/small_vector.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

template <class T>
using Fan_array = boost::container::small_vector<T, 16>;

// Bounds of the squared factors by which the map into a face changes lengths: `down <= squared factor <= up`.
struct Squared_change
{
  double down = 1, up = 1;
};

// The faces around a vertex, counterclockwise: face j has the spokes to the points j and j + 1 of the link. A closed
// fan surrounds the vertex. An open one lies on one side of a line through it, along its first and its last spoke.
struct Fan
{
  bool is_closed = true;
  Fan_array<double> spokes;          // their lengths
  Fan_array<double> link;            // from point j to point j + 1: one for each face
  Fan_array<Squared_change> changes; // of the faces

  std::size_t size() const { return spokes.size(); }
  std::size_t after(std::size_t j) const { return j + 1 == size() ? 0 : j + 1; }
  void clear()
  {
    spokes.clear();
    link.clear();
    changes.clear();
  }
};

// Finds factors by which the spokes become longer, so that the fan is flat: angles that sum to 2π, or π if it is open.
// Those of an open fan are all the same.
// \param largest the largest factor of interest, and the inverse of the least
// \return whether they were found
bool flatten(const Fan& fan, double largest, Fan_array<double>& factors);
// As above for an open fan, with a given factor for its ends. \param factors the result for both
bool flatten_between_ends(const Fan& fan, double ends, double largest, Fan_array<double>& factors);

// The largest squared factor by which the map to the flat fan, after those before, changes a length, or its inverse.
double largest_squared_change(const Fan& fan, const Fan_array<double>& factors);

// A triangle of three points of the link, counterclockwise, and the lengths of its sides. It is cut off at `tip`; the
// last triangle is the rest.
struct Ear
{
  std::uint32_t before, tip, after;
  double before_tip, tip_after, after_before;
};

// The triangulation of a flat fan without its vertex, and where that lies in the last triangle.
struct Fan_triangulation
{
  Fan_array<Ear> ears;
  std::array<double, 3> place; // barycentric coordinates; that of the tip is zero if the fan is open
};

// \param line the length of the line that closes an open fan
// \return whether a triangulation was found
bool triangulate(const Fan& fan, const Fan_array<double>& factors, double line, Fan_triangulation& result);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_FAN_H

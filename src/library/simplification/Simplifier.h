// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Removes vertices from triangles that are given by lengths.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_SIMPLIFIER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_SIMPLIFIER_H

#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Simplification
{
  std::vector<double> lengths;
  std::vector<bool> is_constrained;
  std::vector<Vertex_index> kept;
  std::vector<Metric_change> changes; // of the faces
  // The faces that doubles cannot describe, with their earlier descriptors. Such a face is unchanged if its sides are:
  // their lengths here are only within one unit in the last place of the right ones, and the changes of the faces
  // beside them allow for that.
  std::vector<std::pair<Face_index, Face_index>> thin_faces;
  Kept_vertices reasons;
  Simplification_map map;
};

// \param lengths each within one unit in the last place of the exact length
Simplification simplify(const Delta_complex& complex, std::vector<double> lengths,
                        const Simplification_options& options);

// The number of the component of each face, in the order of the faces with the smallest numbers.
std::vector<std::size_t> numbers_of_components(const Delta_complex& complex);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_SIMPLIFICATION_SIMPLIFIER_H

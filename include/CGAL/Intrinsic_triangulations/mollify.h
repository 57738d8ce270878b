// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lengthens edges until no triangle is nearly degenerate. This changes the surface, so
// it is never done implicitly.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the changes made by `mollify_lengths()`.
struct Mollification_report
{
  double delta = 0;                        ///< the margin in the unit of the lengths
  double epsilon = 0;                      ///< the largest length that was added to an edge
  std::size_t number_of_changed_edges = 0; ///< the number of edges that are longer now
  double largest_relative_change = 0;      ///< the largest of `new length / old length − 1`;
                                           ///< infinite if an edge of length zero was lengthened
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief lengthens edges until every triangle satisfies the triangle inequality with a
/// margin: `l_ij + l_jk >= l_ki + delta` at each corner j.
///
/// Nearly degenerate triangles lose digits in an inexact number type, and lengths that violate
/// the triangle inequality slightly are not a metric at all. Mollification repairs both, but it
/// changes the surface: use it only if that is better than the alternatives. Exact
/// decisions do not need it.
///
/// The same ε is added to every length, the smallest that satisfies all corners (Sharp and Crane 2020, section 4.5).
/// Two linear passes. If all triangles have the margin, nothing changes.
///
/// \param complex the triangles
/// \param lengths the length of each edge, in the order of the edges; they need not
///   satisfy the triangle inequality
/// \param delta_relative the margin as a multiple of the mean edge length; 0 repairs
///   only the triangle inequality, with equality
///
/// \return the changes
/// \exception Invalid_surface_error if a length, or the margin, is negative or not finite
/// \pre there is one length for each edge
///
/// Source: N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", 2020.
Mollification_report mollify_lengths(const Delta_complex& complex, std::vector<double>& lengths, double delta_relative);

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief as `mollify_lengths()`, but only edges of triangles that lack the margin become longer.
///
/// The margins of all
/// three corners imply lengths of at least delta, so shorter edges are first raised to
/// delta. Then edges are processed in the order of decreasing length. If the current
/// edge, of length c, lacks the margin against the other two sides of a triangle, the
/// shorter of these is raised, at most up to the longer one. If that is not enough, both are
/// raised to (c + delta)/2. As delta ≤ c, no side is raised beyond c: a processed edge
/// never changes again. So each edge is processed once, and the function terminates in
/// O(n log n). In each triangle the longest side has the margin against the other two,
/// which implies the same for these.
///
/// A triangle that has the margin, and no edge that a neighbor had to raise, keeps its
/// lengths bit for bit. If all triangles have the margin, nothing changes.
///
/// \param complex, lengths, delta_relative as for `mollify_lengths()`
/// \return the changes
/// \exception Invalid_surface_error as `mollify_lengths()`
/// \pre as for `mollify_lengths()`
Mollification_report mollify_lengths_locally(const Delta_complex& complex, std::vector<double>& lengths,
                                             double delta_relative);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_MOLLIFY_H

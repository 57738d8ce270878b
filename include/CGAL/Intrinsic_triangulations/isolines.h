// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Lines at a distance from points and curves, and the borders between the points nearest to each of them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_ISOLINES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_ISOLINES_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_search.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/trace_lines.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Row_of_vertex.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief a line on the input, as a part of a `Geodesic_source` is.
struct Surface_line
{
  /// two consecutive points lie in the face of the first; a closed line ends where it begins
  std::vector<Surface_point> points;
  double distance = 0;                        ///< from the sources, if it is an isoline
  std::array<std::uint32_t, 2> sources{0, 0}; ///< if it is a border, those that are nearest on either side
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the result of `isolines()`, `offset_curves()` and `borders_of_cells()`.
struct Surface_lines
{
  std::vector<Surface_line> lines;  ///< in the order of their distances
  double maximum_deviation = 0;     ///< as given, or the default
  std::uint64_t number_of_ways = 0; ///< as in `Geodesic_distances`
  bool is_complete = true;          ///< likewise
};

namespace internal {

// The absolute values, without repetition, in ascending order.
// \exception Invalid_argument_error if one is not finite or zero, or negative although there are no signs
std::vector<double> checked_levels(std::vector<double> distances, bool are_signed);

// \param wanted in the unit of the input; an infinite deviation is replaced by the default
// \exception Invalid_argument_error if the deviation is not positive, or too many points are needed
Surface_lines lines_of_waves(const Common_subdivision& subdivision, const Laid_out_faces& faces, const Waves& waves,
                             Wanted_lines wanted, const Interruption& interruption);

// Keeps the lines on the side that the sign of a distance tells, and gives them that sign.
void keep_sides(const Delta_complex& input, const std::vector<std::vector<Surface_point>>& parts,
                const std::vector<double>& distances, std::vector<Surface_line>& lines);

template <class Traits, class NamedParameters>
Surface_lines lines_at(const Intrinsic_triangulation<Traits>& triangulation,
                       const std::vector<Geodesic_source>& sources, const std::vector<double>& levels,
                       const NamedParameters& np)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Distance_search<Traits, Row_of_vertex> search(triangulation, Row_of_vertex(triangulation.connectivity()), np);
  const Waves waves = search.waves(search.at_points(sources), levels.empty() ? infinity : levels.back());
  const Common_subdivision subdivision(search.triangulation(), np);
  return lines_of_waves(subdivision, search.faces(), waves,
                        {levels, value_of<Parameter::MAXIMUM_DEVIATION>(np, infinity), search.tolerance()},
                        search.interruption());
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the lines whose points have a given distance from the nearest source.
///
/// In each face, the distance is the smallest of the lengths of ways from corners, from sources in the face, and
/// through each bundle that enters it. These functions are known in closed form, so lines are arcs of circles around
/// unfolded sources and segments parallel to unfolded curves. With a `tolerance` of 0, **points** have the given
/// distance up to rounding; otherwise up to what the tolerance changes. **Chords** between them keep to
/// `maximum_deviation`: the distance of each of their points differs no more from the given one. Parts of a line can be
/// missing only where distances differ by no more than that from the given one. All this follows from the convexity of
/// the functions in each of the triangles into which faces are divided, except for rounding and, with a positive
/// `tolerance`, for jumps of distances between faces, which are then added.
///
/// Lines are closed or end on the border. Smaller distances lie to their left.
///
/// \param triangulation a triangulation that keeps its input, preferably Delaunay
/// \param sources points of `triangulation.input()`
/// \param distances positive numbers; ways are followed up to the largest one only
/// \param np the named parameters of `geodesic_distances()`, and
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{the chord tolerance, in the unit of the input. The number of points grows as its inverse
///       square root}
///     \cgalParamType{`double`, positive}
///     \cgalParamDefault{a ten-thousandth of the largest of the distances}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Invalid_argument_error if a distance is not positive or not finite, the deviation is not positive, or
///   more than about a million points, and ten for each vertex, are needed: this is estimated first, and the message
///   says what would suffice
/// \exception Invalid_point_error, Cancelled_error, Undecided_error as `geodesic_distances_from()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Surface_lines isolines(const Intrinsic_triangulation<Traits>& triangulation,
                       const std::vector<Geodesic_source>& sources, const std::vector<double>& distances,
                       const NamedParameters& np = parameters::default_values())
{
  const std::vector<double> levels = internal::checked_levels(distances, false);
  return levels.empty() ? Surface_lines() : internal::lines_at(triangulation, sources, levels, np);
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the lines at a distance from a curve on one of its sides: the left one for positive distances, the
/// right one for negative ones.
/// \param triangulation, np as above
/// \param parts of the curve, points of `triangulation.input()`; it has to separate, as for `sides_of_curve()`
/// \param distances numbers other than 0
/// \exception Invalid_argument_error, Invalid_surface_error, Invalid_point_error as `isolines()` and `sides_of_curve()`
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Surface_lines offset_curves(const Intrinsic_triangulation<Traits>& triangulation,
                            const std::vector<std::vector<Surface_point>>& parts, const std::vector<double>& distances,
                            const NamedParameters& np = parameters::default_values())
{
  const std::vector<double> levels = internal::checked_levels(distances, true);
  if (levels.empty())
    return {};
  Surface_lines result = internal::lines_at(triangulation, {{parts}}, levels, np);
  internal::keep_sides(triangulation.input(), parts, distances, result.lines);
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief returns the lines where the nearest source changes: the borders of the geodesic Voronoi cells.
///
/// They are arcs of hyperbolas and parabolas, and segments. Their points are as far from both sources as `isolines()`
/// says; between them the distances differ by the deviation at most. A line is closed, or ends on the border or where
/// three cells meet. The cell of the source with the smaller number lies to its left.
///
/// \param triangulation, sources as above
/// \param np as above; by default, the deviation is a ten-thousandth of the largest distance of a corner of a face
/// \exception Invalid_argument_error, Invalid_point_error, Cancelled_error, Undecided_error as above
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Surface_lines borders_of_cells(const Intrinsic_triangulation<Traits>& triangulation,
                               const std::vector<Geodesic_source>& sources,
                               const NamedParameters& np = parameters::default_values())
{
  return internal::lines_at(triangulation, sources, {}, np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_ISOLINES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Fewer vertices: another surface, with a proven bound on the change of any distance.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFY_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFY_SURFACE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Simplification_map.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/property_map.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief proven factors of a change of lengths: `shrink * l <= l' <= stretch * l`.
struct Metric_change
{
  double shrink = 1;  ///< at most 1, unless all lengths grow
  double stretch = 1; ///< at least 1, unless all lengths shrink
};

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief how many vertices of a simplified surface were kept, by the reason.
struct Kept_vertices
{
  std::size_t by_request = 0; ///< marked as kept, or an end of one, or of three or more constrained edges
  std::size_t as_corners = 0; ///< on a border or a line of constrained edges, with one triangle on a side of it
  std::size_t for_gluing = 0; ///< with a loop, fewer than three triangles around it, or a border of two edges
  std::size_t by_bound = 0;   ///< their removal would change distances too much, or would give no triangles
  std::size_t by_number = 0;  ///< not asked for, because few enough vertices were left
  std::size_t isolated = 0;   ///< without a face
};

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief a surface with fewer vertices, and its relation to the original one.
///
/// With the map φ from one surface to the other, `shrink * d(p, q) <= d'(φp, φq) <= stretch * d(p, q)` for all points p
/// and q of the same component, and the same is true of the lengths of all curves. This is proven, by intervals that
/// are rounded outward: it includes the rounding of all lengths. Only coordinates of points on the new surface are
/// rounded without a bound, in their last digits.
struct Simplified_surface
{
  /// the new surface, with a Delaunay triangulation. Its input consists of the triangles that `map` and everything
  /// below refer to
  Intrinsic_triangulation<Filtered_edge_length_traits> triangulation;
  /// for each vertex of the new surface, the vertex of the given one that it is
  std::vector<Vertex_index> kept;
  /// for each vertex of the given surface, where it lies on `triangulation.input()`; undefined if it is isolated
  std::vector<Surface_point> places;
  double shrink = 1;                           ///< proven for all components at once
  double stretch = 1;                          ///< likewise
  std::vector<Metric_change> changes_in_faces; ///< the proven bounds within each face of `triangulation.input()`
  /// the proven bounds for each component, by its face with the smallest number
  std::vector<std::pair<Face_index, Metric_change>> changes_of_components;
  std::vector<bool> is_constrained; ///< for each edge of `triangulation.input()`: whether it is on a line to keep
  Kept_vertices reasons;            ///< the reasons why vertices were kept
  Simplification_map map;           ///< φ and its inverse
};

namespace internal {

struct Simplification_options
{
  double maximum_change;
  std::size_t number_of_vertices;
  std::vector<bool> is_kept, is_constrained; // of all vertices and edges
  Progress_function progress;
};

// Checked options. Constrained are the edges of the input, and parts of them, that are sharp; no vertex is kept.
Simplification_options simplification_options(const Exact_engine& engine, std::optional<double> maximum_change,
                                              std::size_t number_of_vertices, double sharp_angle,
                                              Progress_function progress);

Simplified_surface simplify(const Exact_engine& engine, const Simplification_options& options);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief removes vertices as long as it is proven that no distance changes by more than a given factor.
///
/// \b The \b result \b is \b another \b surface: this function, and no other of the package, changes lengths; by how
/// much is a part of the result.
///
/// The triangles around a vertex are laid flat, with longer or shorter edges from the vertex, and the polygon is
/// triangulated without it. Each face has bounds for everything that has been mapped into it so far. The vertex whose
/// removal gives the least bound is next. Flat vertices, and those on straight edges, cost nothing but rounding, so
/// they go first. On the border, and on lines of constrained edges, vertices are removed by making the line straight.
///
/// First `triangulation` is flipped to Delaunay, which does not change its surface; `Simplified_surface::map` refers to
/// its triangles after that.
///
/// \tparam Traits traits with exact geometry
/// \param triangulation a triangulation that keeps its input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{maximum_change}
///     \cgalParamDescription{the fraction by which a distance may change: `shrink >= 1 / (1 + maximum_change)` and
///       `stretch <= 1 + maximum_change`. Values below 10<sup>-12</sup> count as 10<sup>-12</sup>, which rounding
///       takes. Faces so thin that doubles do not describe them stay as they are; beside them, the rounding of one
///       length is added}
///     \cgalParamType{`double`, not negative}
///     \cgalParamDefault{0.05, and no limit if `number_of_vertices` is given}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_vertices}
///     \cgalParamDescription{no more vertices are removed when this many are left}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{which vertices are kept}
///     \cgalParamType{a model of `ReadablePropertyMap` with keys of type `Vertex_index`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamConstraints{which edges are kept: they are not flipped, and become parts of straight edges of the new
///     surface}
///   \cgalParamNBegin{sharp_angle}
///     \cgalParamDescription{edges of the input whose faces have directions that differ by more are kept as well, as by
///       `sharp_edges()`}
///     \cgalParamType{`double`, from 0 to 180 degrees}
///     \cgalParamDefault{180: none}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the new surface. O(n log n) for vertices of bounded degree
/// \exception Invalid_argument_error if `maximum_change` or `sharp_angle` is out of range, or sharp edges are asked for
///   on a surface that has only lengths
/// \exception Invalid_surface_error if the length of an edge is below the range of normal doubles, or a face has an
///   angle below 2<sup>-400</sup> and a side that is not an edge of the input
/// \exception Cancelled_error if the visitor asks for it
/// \exception Undecided_error as `flip_to_Delaunay()`
///
/// Source: for the idea of laying a vertex flat, H.-T. D. Liu, M. Gillespie, B. Chislett, N. Sharp, A. Jacobson, K.
/// Crane, "Surface simplification using intrinsic error metrics" (2023), which gives no bound.
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Simplified_surface simplify_surface(Intrinsic_triangulation<Traits>& triangulation,
                                    const NamedParameters& np = parameters::default_values())
{
  static_assert(Traits::Uses_exact_geometry::value, "simplify_surface(): needs traits that use exact geometry");
  using internal::Parameter;
  const Delta_complex& complex = triangulation.connectivity();
  internal::Simplification_options options = internal::simplification_options(
    internal::engine(triangulation), internal::value_of<Parameter::MAXIMUM_CHANGE>(np, std::optional<double>()),
    internal::value_of<Parameter::NUMBER_OF_VERTICES>(np, std::size_t(0)),
    internal::value_of<Parameter::SHARP_ANGLE>(np, 180.), internal::progress_function_of(np));
  const auto is_kept = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                                    Static_boolean_property_map<Vertex_index, false>());
  for (Vertex_index v : complex.vertices())
    options.is_kept[v.idx()] = get(is_kept, v);
  const auto is_given = internal::edge_constraints_of(np);
  for (Edge_index e : complex.edges())
    if (get(is_given, e))
      options.is_constrained[e.idx()] = true;
  const auto is_constrained = boost::make_function_property_map<Edge_index, bool>(
    [&](Edge_index e) { return bool(options.is_constrained[e.idx()]); });
  flip_to_Delaunay(triangulation, parameters::edge_is_constrained_map(is_constrained).visitor([&] {
    return !options.progress || options.progress(0);
  }));
  return internal::simplify(internal::engine(triangulation), options);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFY_SURFACE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces of an intrinsic triangulation as straight triangles in space, and how good these are.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_STRAIGHT_MESH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_STRAIGHT_MESH_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief the faces of an intrinsic triangulation as straight triangles between their corners in space.
///
/// This is another surface, about which nothing is known except what is recorded here.
struct Straight_mesh
{
  std::vector<std::array<double, 3>> points; ///< of the vertices, rounded where they were inserted
  /// for each vertex of the triangulation, its point. They are the same in number and order unless vertices are merged
  std::vector<std::uint32_t> points_of_vertices;
  std::vector<Vertex_index> merged_vertices; ///< vertices that share the point of another one
  std::size_t number_of_removed_pieces = 0;  ///< how many connected pieces were left out that lie along others
  /// how many pieces without thickness lie along no others, and became rods that are as thick as the deviation allows
  std::size_t number_of_rods = 0;
  /// \brief the area of films that are left out: two sheets of the surface that enclose no volume, as both are within
  /// `maximum_deviation` of the same triangles. Only from there, the triangles may be farther away than `deviation`
  double area_of_films = 0;
  std::array<double, 3> film_place{}; ///< a point of the first of them
  /// how many more components there are because parts of the surface that only thin ones join came apart
  std::size_t number_of_new_components = 0;
  /// the faces in order; those with loops are several
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Face_index> faces; ///< for each triangle, the face of the triangulation that it is, or where it belongs
  std::vector<Face_index> input_faces; ///< for each triangle, the face of the input that covers most of it
  /// for each triangle, the number of its region. Marked edges separate regions. Merged vertices can divide a region
  std::vector<std::uint32_t> regions;
  std::uint32_t number_of_regions = 0; ///< the number of regions

  /// the marked edges, those of the border, and those between regions, by their ends
  std::vector<std::array<std::uint32_t, 2>> marked_edges;
  /// for each of them, the number of its line: connected edges with the same region, or two, beside them
  std::vector<std::uint32_t> lines;
  std::uint32_t number_of_lines = 0; ///< the number of lines

  /// \brief films apart, neither surface is farther than this from the other at any point. It is proven, rounding
  /// included. It exceeds `maximum_deviation` if the triangulation has faces that are farther from their triangles
  double deviation = 0;
  std::array<double, 3> deviation_place{}; ///< where on the surface this distance is approximately attained

  double minimum_angle = 180; ///< the smallest angle of the triangles, in degrees
  std::vector<std::uint32_t>
    thin_triangles; ///< those with an angle below the given bound; first those not at sharp corners
  /// how many of them have it between two marked edges, where every mesh has that angle
  std::size_t number_of_sharp_corners = 0;
  /// a larger maximum deviation, at most 64 times the given one, with which the triangles were found to be good; 0 if
  /// they are good already, or none was found
  double sufficient_deviation = 0;

  static constexpr double smallest_dihedral_angle = 0.1; ///< in degrees. Programs that fill volumes refuse less
  double minimum_dihedral_angle = 180; ///< the smallest angle between two triangles at an edge, in degrees
  /// edges of closed triangles at which this angle is below `smallest_dihedral_angle`, by their ends
  std::vector<std::array<std::uint32_t, 2>> folded_edges;

  /// edges of the triangulation whose ends are the same. Two more points make each a triangle, and divide the faces
  /// beside it
  std::vector<Edge_index> loops;
  std::vector<Edge_index> multiple_edges;     ///< edges that share both ends with an earlier one, other than loops
  std::size_t number_of_new_border_edges = 0; ///< how many border edges there are that the surface does not have
  /// with `maximum_deviation`, the pairs of triangles that have more in common than their common corners and edges, as
  /// decided exactly; first those where the surface does not cross itself
  std::vector<std::array<std::uint32_t, 2>> crossing_triangles;
  /// how many of them do not stand for parts of input faces that cross. Steps that lead to such pairs are avoided, but
  /// parts of the surface that are nearer to each other than `maximum_deviation` may leave no other way
  std::size_t number_of_new_crossings = 0;
  Surface_report surface; ///< what `examine_polygons()` finds in the triangles: edges of three triangles, for instance

  /// returns whether the only thin triangles are at sharp corners. Complexity: constant.
  bool has_good_angles() const { return thin_triangles.size() == number_of_sharp_corners; }

  /// returns whether the triangles have no border. Complexity: constant.
  bool is_closed() const { return surface.number_of_border_edges == 0; }

  /// \brief returns whether they are closed, nowhere folded onto themselves, and, as far as that was examined, do not
  /// cross: programs that fill volumes take them. Complexity: constant.
  bool can_be_filled() const
  {
    return is_surface() && is_closed() && folded_edges.empty() && crossing_triangles.empty();
  }

  /// \brief returns whether they are a surface with good angles that, if it is closed, is nowhere folded onto itself,
  /// and crosses itself only where the given one does. Complexity: constant.
  bool is_good() const
  {
    return is_surface() && has_good_angles() &&
           (!is_closed() || (folded_edges.empty() && number_of_new_crossings == 0));
  }

  /// returns whether the triangles are a manifold without holes that the surface does not have, and no two of them have
  /// the same corners. Complexity: constant.
  bool is_surface() const
  {
    return number_of_new_border_edges == 0 && surface.first_fatal() == nullptr &&
           surface.find(Invalid_surface_error::Defect::DUPLICATE_FACE) == nullptr;
  }
};

namespace internal {

Straight_mesh straight_mesh(const Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points,
                            const std::vector<bool>& is_marked, double thin_angle, double maximum_deviation,
                            const std::vector<bool>& is_fixed, const Progress_function& progress,
                            bool tries_larger_deviations = true);

// Whether the area is at least half of what it was. Where most is left out, little that is left can be bad.
bool keeps_most(const Straight_mesh& mesh, const Straight_mesh& before);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief makes straight triangles of the faces of an intrinsic triangulation, for programs that know no other
/// triangles.
///
/// The distance from the surface is the maximum of |x − φ(x)| for the map φ that is linear on each intrinsic face. It is
/// attained at a vertex of the overlay: x − φ(x) is linear on each of its faces, as these lie in a plane of the input. Where
/// triangles are changed, parts of both surfaces are divided until each is near one triangle of the other surface.
///
/// CAD models have edges and gaps that are shorter than any useful triangle. With `maximum_deviation`, vertices are
/// merged or moved and edges flipped where that makes thin triangles better, or where edges are shorter than that and
/// nothing does. Thin tubes are cut and closed, pieces without any thickness that lie along others are left out, and wires
/// that do not become rods. Films of closed surfaces go: two sheets, around material or a gap, that a wall thinner than the
/// deviation joins, or a fold below a degree. The triangulation and the surface stay as they are, and the triangles stay
/// closed where the surface is. Distances are measured between both surfaces; no change goes beyond that bound, except
/// that films are missing.
///
/// \param subdivision the common subdivision of the triangulation and its input
/// \param points the positions of the vertices of the input
/// \param is_marked for each edge of the input, whether the edges of the triangulation that are parts of it are marked;
///   empty if none is. Mark those that refinement has kept, for no other edge of the input stays an edge for sure
/// \param thin_angle triangles with a smaller angle, in degrees, are listed
/// \param maximum_deviation the deviation up to which vertices may be merged, in the unit of the input; 0 if none may
/// \param is_fixed for each vertex of the input, whether it must not be merged with another one, such as the ends of edges
///   that stay whole; empty if all may
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the triangles with regions, lines and defects
/// \exception Invalid_argument_error if there are not as many points or marks as vertices or edges of the input, or a
///   coordinate is not finite
/// \exception Cancelled_error if the visitor asks for it
///
/// Complexity: linear in the size of the overlay, and O(n log n) for n edges, for vertices of bounded degree. If the
/// triangles are not good, larger deviations are tried, at most six.
template <class NamedParameters = parameters::Default_named_parameters>
Straight_mesh straight_mesh(const Common_subdivision& subdivision, const std::vector<std::array<double, 3>>& points,
                            const std::vector<bool>& is_marked = {}, double thin_angle = 10,
                            double maximum_deviation = 0, const std::vector<bool>& is_fixed = {},
                            const NamedParameters& np = parameters::default_values())
{
  return internal::straight_mesh(subdivision, points, is_marked, thin_angle, maximum_deviation, is_fixed,
                                 internal::progress_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsOverlay
/// \brief returns a sentence that says why straight triangles are not a surface, with the numbers and the first places.
/// \param mesh the triangles
/// \return for example "edges 17 and 18 of the triangulation both join vertices 3 and 4 at (0, 0, 1), and ...". Empty if
///   `mesh.is_surface()`. Complexity: constant.
std::string message(const Straight_mesh& mesh);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_STRAIGHT_MESH_H

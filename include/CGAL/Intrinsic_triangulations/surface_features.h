// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The sides of a part: sharp edges between them, lines on them, and unneeded vertices inside them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_FEATURES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_FEATURES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief the result of `remove_nearly_flat_vertices()`.
struct Flat_vertex_removal
{
  std::vector<Vertex_index> vertices; ///< for each remaining vertex, its previous descriptor
  double deviation = 0; ///< a bound on how far the surface has moved, in the unit of the points: at most the tolerance
};

namespace internal {
std::vector<Vertex_index> remove_flat_vertices(Delta_complex& complex, std::vector<std::array<double, 3>>& points,
                                               const Progress_function& progress);
Flat_vertex_removal remove_nearly_flat_vertices(Delta_complex& complex, std::vector<std::array<double, 3>>& points,
                                                double tolerance, const Progress_function& progress);
} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief removes vertices from a surface in space without moving any point of it.
///
/// A vertex is removed if it lies inside the surface, its angles sum to 2π, and its faces lie in one plane, or in two
/// half-planes with a straight edge on either side of the vertex. That is decided exactly; a vertex that is off its
/// plane by one unit in the last place stays. The plane is then triangulated without it, so that all edges join
/// vertices and lie on the surface. Vertices of faces of zero area stay, and so does the border.
///
/// Other vertices whose angles happen to sum to 2π stay, too: an edge past such a vertex bends in space, and its
/// squared length is not rational.
///
/// \param complex the connectivity; its last elements take the place of those that are removed
/// \param points the positions of the vertices, which follow them
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return for each remaining vertex, its previous descriptor
///
/// \pre there is one point for each vertex, and the coordinates are finite
/// \exception Cancelled_error if the visitor asks for it; then `complex` and `points` describe the surface with some
///   vertices removed
///
/// O(number of halfedges), with filtered exact predicates.
template <class NamedParameters = parameters::Default_named_parameters>
std::vector<Vertex_index> remove_flat_vertices(Delta_complex& complex, std::vector<std::array<double, 3>>& points,
                                               const NamedParameters& np = parameters::default_values())
{
  return internal::remove_flat_vertices(complex, points, internal::progress_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief as `remove_flat_vertices()`, for vertices that are slightly off their planes and lines, for instance after a
/// rotation.
///
/// The surface changes, but no point moves by more than a tolerance: everything that a face has replaced so far lies in
/// a slab of known width around it, and a vertex is removed if the widths of its faces allow it. Vertices that are left
/// do not move. So a part that was rotated loses the vertices of its flat sides with a tolerance of a few units in the
/// last place.
///
/// \param complex the connectivity; its last elements take the place of those that are removed
/// \param points the positions of the vertices, which follow them
/// \param tolerance the largest distance by which a point of the surface may move
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is called from time to time with the fraction that is done, and can cancel}
/// \cgalNamedParamsEnd
///
/// \pre as `remove_flat_vertices()`, `tolerance >= 0`
/// \exception Cancelled_error as `remove_flat_vertices()`
///
/// O(sum of the squared degrees). It is decided exactly that triangles are not turned over, seen along the axis closest
/// to their normal. Widths are rounded.
template <class NamedParameters = parameters::Default_named_parameters>
Flat_vertex_removal remove_nearly_flat_vertices(Delta_complex& complex, std::vector<std::array<double, 3>>& points,
                                                double tolerance,
                                                const NamedParameters& np = parameters::default_values())
{
  return internal::remove_nearly_flat_vertices(complex, points, tolerance, internal::progress_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief returns the spacing of the coordinates: a unit in the last place of the largest one, as a `float` if all of
/// them are floats, as in STL files, and as a `double` otherwise.
/// \param points the points
/// \return the spacing in the unit of the points; 0 if all coordinates are 0
///
/// \pre the coordinates are finite
double coordinate_spacing(const std::vector<std::array<double, 3>>& points);

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief finds the edges at which the directions of the two faces differ by more than an angle, to be constrained in
/// `refine_Delaunay()`.
///
/// The direction of a face is that of its normal. The normal of a face that is thinner than `minimum_size`, or than
/// four times `coordinate_spacing()`, is meaningless. Such a face takes the direction of the face beyond its longest
/// side, which may be as thin itself. So a sliver between two sides of a part has one sharp edge and not two.
///
/// Sharp edges with common vertices make chains; those whose edges have a total length below `minimum_size` are
/// dropped.
///
/// \param complex the connectivity
/// \param points the positions of the vertices
/// \param degrees the angle, from 0 to 180 degrees
/// \param minimum_size the height below which a face is thin, in the unit of the points
/// \return for each edge whether it is sharp; border edges are not
///
/// \pre there is one point for each vertex, and the coordinates are finite
///
/// O(n log n) for n edges of thin faces, otherwise linear. Directions and lengths are rounded.
std::vector<bool> sharp_edges(const Delta_complex& complex, const std::vector<std::array<double, 3>>& points,
                              double degrees, double minimum_size = 0);

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief divides edges and faces so that lines on a surface become edges, to be constrained in `refine_Delaunay()`.
///
/// Each point of a line inside an edge or a face becomes a vertex, and edges join consecutive ones. So two consecutive
/// points lie in one face, as those of `Geodesic_path` do. Lines may cross each other and themselves, which makes a vertex,
/// too. Points that differ by less than 2^-40 of a face are one.
class Line_divider
{
public:
  /// vertices, and the positive weights of a point between them, which sum to 1: one at a vertex, two on an edge, three
  /// in a face
  using Corners = std::vector<std::pair<Vertex_index, double>>;

  /// \param complex, points the connectivity, and the positions of its vertices. They are changed as by
  ///   `Delta_complex::split_edge()` and `Delta_complex::split_face()`, and have to outlive this
  Line_divider(Delta_complex& complex, std::vector<std::array<double, 3>>& points)
    : complex_(complex), points_(points), number_before_(complex.number_of_vertices())
  {}

  /// begins another line.
  void begin_line() { last_.reset(); }
  /// \brief appends a point to the line.
  /// \param corners the point, by vertices of the complex as it was given
  /// \exception Invalid_point_error if there is no such edge or face, or the point does not lie in one face with the
  ///   point before. Then only edges and faces were divided. O(sum of the degrees of the corners, and the parts of the face)
  void add_point(Corners corners);
  /// \brief keeps an edge of the complex as it was given.
  /// \exception Invalid_point_error if no edge joins these vertices
  void add_edge(Vertex_index v, Vertex_index w);

  /// returns for each edge whether it is part of a line, or was kept.
  std::vector<bool> edges() const;

private:
  using Face = std::array<Vertex_index, 3>;

  std::optional<Halfedge_index> halfedge(Vertex_index v, Vertex_index w) const;
  void keep(Vertex_index v, Vertex_index w);
  Corners place(Vertex_index v) const;
  std::optional<std::array<double, 2>> coordinates(Vertex_index v, const Face& face) const;
  Vertex_index split(Halfedge_index h, const Corners& corners);
  Vertex_index on_edge(const Corners& corners);
  Vertex_index in_face(const Corners& corners);
  void connect(Vertex_index from, Vertex_index to);
  void add_place(const Corners& corners);

  Delta_complex& complex_;
  std::vector<std::array<double, 3>>& points_;
  const std::uint32_t number_before_; // of vertices
  std::vector<Corners> places_;       // of later ones
  std::set<Edge_index> edges_;
  std::optional<Vertex_index> last_; // of the current line
  // For each edge that was cut, from the smaller vertex: the vertices on it, by their weights at the larger one.
  std::map<std::pair<Vertex_index, Vertex_index>, std::map<double, Vertex_index>> cuts_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_FEATURES_H

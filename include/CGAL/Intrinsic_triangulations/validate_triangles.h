// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Whether a list of polygons is a surface that the package can work on; if not, which elements are at fault, and the
// remedy.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Length_range.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/are_collinear.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief a finding of `examine_polygons()`, with the first elements that it concerns.
struct Finding
{
  /// the defect or peculiarity.
  Invalid_surface_error::Defect defect;
  /// the smallest indices, at most ten, increasing where they are vertices or
  /// faces; for a finding about edges, the first face of each of `edges`.
  std::vector<std::size_t> elements;
  /// the end vertices of the first edges, smaller first; empty for other findings.
  std::vector<std::array<std::size_t, 2>> edges;
  /// the number of elements concerned (for `SEVERAL_COMPONENTS`: of components).
  std::size_t count;
  /// whether the package cannot work on the surface.
  bool is_fatal;
  /// a description of the first element with its vertices, e.g. "edge 3-17 has 4 faces (faces 5, 8, 9, 11)".
  std::string description;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief a kind of invisible gap in a surface. Distances go around it.
enum class Gap_kind {
  T_JUNCTION,    ///< an edge ends within another one, exactly or nearly, and the faces there do not meet
  CLOSE_VERTICES ///< two border vertices, or the ends of an edge, are much nearer to each other than to others
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief one kind of gap that `examine_polygons()` found, with the first edges that it concerns. No gap is fatal.
struct Gap
{
  /// the kind of gap.
  Gap_kind kind;
  /// the end vertices of the first ten edges with a vertex within, or the first ten pairs of vertices.
  std::vector<std::array<std::size_t, 2>> edges;
  /// a face at each of them.
  std::vector<std::size_t> faces;
  /// the number of gaps of this kind.
  std::size_t count;
  /// a description of the first one, e.g. "vertex 6 lies within edge 1-2 of face 1, which does not end there".
  std::string description;
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief everything that `examine_polygons()` found, and the numbers of elements.
struct Surface_report
{
  /// one entry per defect that occurs, in the order of `Invalid_surface_error::Defect`; but vertices and edges that are
  /// out of range have one each.
  std::vector<Finding> findings;
  std::size_t number_of_vertices = 0;     ///< points, referenced or not
  std::size_t number_of_faces = 0;        ///< polygons, valid or not
  std::size_t number_of_edges = 0;        ///< edges of the faces with valid indices
  std::size_t number_of_border_edges = 0; ///< those with one face
  std::size_t number_of_components = 0;   ///< pieces that share no vertex
  /// whether the faces can be oriented consistently (known only if no edge has three faces).
  bool is_orientable = true;
  /// the smallest `e` such that no coordinate differs by 2<sup>e</sup> or more along any edge.
  int exponent_of_longest_edge = 0;
  /// the same for the shortest edge of nonzero length.
  int exponent_of_shortest_edge = 0;
  /// one entry per kind of gap.
  std::vector<Gap> gaps;
  /// the tolerance by which `repair_polygons()` closes these gaps.
  double stitching_tolerance = 0;

  /// returns the first entry of a defect, or `nullptr` if there is none. Complexity: constant.
  const Finding* find(Invalid_surface_error::Defect defect) const
  {
    for (const Finding& finding : findings)
      if (finding.defect == defect)
        return &finding;
    return nullptr;
  }

  /// returns the first fatal entry, or `nullptr` if the surface can be used. Complexity: constant.
  const Finding* first_fatal() const
  {
    for (const Finding& finding : findings)
      if (finding.is_fatal)
        return &finding;
    return nullptr;
  }
};

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a sentence that says what was found, where, how often, and what to do about it.
/// \param finding an entry of a report
/// \param advice the remedy, instead of the default advice for programmers; empty for no advice
/// \return for example "edge 3-17 has 4 faces (faces 5, 8, 9, 11), and 2 more edges like it; remove ...".
/// Complexity: constant.
std::string message(const Finding& finding, const std::optional<std::string>& advice = std::nullopt);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a sentence about a kind of gap: what it is, how often it occurs, and the remedy.
/// \param gap an entry of a report
/// \param advice the remedy, instead of the default advice for programmers Complexity: constant.
std::string message(const Gap& gap, const std::optional<std::string>& advice = std::nullopt);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns a text that describes the defects of a surface.
/// \param report what `examine_polygons()` returned
/// \param name the name of the surface, e.g. of its file; it precedes the text unless it is empty
/// \param advice what to do about the first fatal entry, instead of the default advice for programmers
/// \return if the report has fatal entries, the first one in full and the counts of the
/// others; otherwise all entries and gaps, one after the other; the
/// empty string if there is none. Complexity: constant.
std::string message(const Surface_report& report, const std::string& name = std::string(),
                    const std::optional<std::string>& advice = std::nullopt);

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief does nothing if a surface can be used; otherwise throws an exception that says why not.
/// \param report what `examine_polygons()` returned
/// \param name the name of the surface, e.g. of its file; it precedes the message unless it is empty
/// \exception Invalid_surface_error with the defect, first element and count of the first
/// fatal entry (for an edge, the element is its first face), and the text of `message()`.
/// Complexity: constant.
void throw_if_fatal(const Surface_report& report, const std::string& name = std::string());

namespace internal {

class Vertices_on_edges;

// Points and polygons as they were given.
struct Polygon_copies
{
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  std::size_t number_of_vertices, number_of_faces;
  std::vector<std::array<double, 3>> points; // empty if there are no faces, or too many elements
  std::vector<std::uint32_t> corners;        // of one face after the other; none instead of a bad index
  std::vector<std::uint32_t> ends;           // of the faces in `corners`
  std::size_t first_bad_index = 0;

  bool can_be_numbered() const
  {
    return number_of_vertices < none && number_of_faces < none / 3 && corners.size() < none;
  }
};

template <class PointRange, class PolygonRange>
Polygon_copies copy_polygons(const PointRange& points, const PolygonRange& polygons)
{
  Polygon_copies result{std::size_t(std::distance(std::begin(points), std::end(points))),
                        std::size_t(std::distance(std::begin(polygons), std::end(polygons))),
                        {},
                        {},
                        {}};
  if (result.number_of_faces == 0 || !result.can_be_numbered())
    return result;
  bool has_bad_index = false;
  result.corners.reserve(3 * result.number_of_faces);
  result.ends.reserve(result.number_of_faces);
  for (const auto& polygon : polygons) {
    for (const auto index : polygon) {
      const auto value = static_cast<std::size_t>(index);
      const bool is_bad = value >= result.number_of_vertices;
      if (is_bad && !std::exchange(has_bad_index, true))
        result.first_bad_index = value;
      result.corners.push_back(is_bad ? Polygon_copies::none : static_cast<std::uint32_t>(value));
    }
    if (!result.can_be_numbered())
      return result;
    result.ends.push_back(static_cast<std::uint32_t>(result.corners.size()));
  }
  result.points.reserve(result.number_of_vertices);
  for (const auto& p : points)
    result.points.push_back({to_double(p[0]), to_double(p[1]), to_double(p[2])});
  return result;
}

// \param only_gaps whether to look for gaps alone
Surface_report examine(Polygon_copies polygons, bool only_gaps);

// The first corner of the side whose ends are close compared with the other sides, if any.
std::optional<std::size_t> shortest_side(std::array<std::array<double, 3>, 3> p);

// Whether all faces are joined by edges.
bool is_connected(const Delta_complex& complex);

// The ends of border edges, two for each.
class Border_gaps
{
public:
  // \param points must outlive this
  explicit Border_gaps(const std::vector<std::array<double, 3>>& points);

  // Whether one of them lies within this edge.
  bool are_within(const std::array<double, 3>& p, const std::array<double, 3>& q) const;
  // Whether two of them lie beside each other.
  bool are_close() const;

private:
  const std::vector<std::array<double, 3>>& points_;
  std::shared_ptr<const Vertices_on_edges> near_;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief examines whether polygons form an oriented 2-manifold of triangles with usable edge lengths.
///
/// Every kind of defect is checked unless earlier findings prevent it: a face with an invalid index is
/// ignored in all later checks, and lengths and areas are not checked where a coordinate is not finite. No topological
/// check assumes an orientation. Coordinates are examined as `double`. Their range is checked as by the constructors of
/// `Intrinsic_triangulation` with traits on `double`: a surface accepted here is accepted there.
///
/// \tparam PointRange a model of `RandomAccessRange`, of points whose coordinates are `p[0]`, `p[1]` and `p[2]`
/// \tparam PolygonRange a model of `ForwardRange`, of ranges of integers of any length
///
/// \param points the vertices
/// \param polygons the faces, as indices into `points`
///
/// \return the findings in the order of `Invalid_surface_error::Defect`; none for a connected
/// triangulated surface without defects. No input makes the function throw
/// (except `std::bad_alloc`).
///
/// Complexity: linear in the numbers of vertices and corners, except for the
/// union-find structures (linear for all practical purposes), a sort of the faces at
/// edges with more than two faces, and O(n log k) for k edges at the border and where sheets meet.
template <class PointRange, class PolygonRange>
Surface_report examine_polygons(const PointRange& points, const PolygonRange& polygons)
{
  return internal::examine(internal::copy_polygons(points, polygons), false);
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief finds the gaps in triangles that `examine_polygons()` finds, and nothing else: for functions that take any
/// triangles as they are.
///
/// Distances go around a gap, and operators do not know of it. Vertices that are as near as a billionth of an edge are
/// found; whether a vertex lies within an edge is decided exactly.
/// \param points the vertices
/// \param triangles the faces
/// \return a report with numbers of edges, without findings. Complexity: as `examine_polygons()`
template <class PointRange, class TriangleRange>
Surface_report find_gaps(const PointRange& points, const TriangleRange& triangles)
{
  return internal::examine(internal::copy_polygons(points, triangles), true);
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns whether `examine_polygons()` would find nothing but possibly
/// several components: a faster check if the connectivity has been built.
///
/// \param complex the result of `make_Delta_complex_from_triangles()`, which has checked that the faces
///   form an oriented 2-manifold
/// \param points the vertices; coordinates are `p[0]`, `p[1]` and `p[2]`
///
/// Complexity: linear, and O(n log k) for k border edges, which alone need memory.
template <class PointRange>
bool is_clean(const Delta_complex& complex, const PointRange& points)
{
  const auto place = [&points](Vertex_index v) {
    const auto& p = points[v.idx()];
    return std::array<double, 3>{{to_double(p[0]), to_double(p[1]), to_double(p[2])}};
  };
  if (complex.number_of_faces() == 0)
    return false;
  internal::Box box;
  for (Vertex_index v : complex.vertices()) {
    const std::array<double, 3> p = place(v);
    if (!complex.halfedge(v).is_valid() || !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
      return false;
    for (int i = 0; i < 3; ++i)
      box.add(i, p[i]);
  }
  const int exponent = internal::unit_exponent<double>(box.half_extent());
  if (exponent != 0)
    for (Vertex_index v : complex.vertices())
      if (std::array<double, 3> p = place(v); !internal::scale_point(p, box, exponent))
        return false;
  internal::Length_range lengths;
  for (Edge_index e : complex.edges()) {
    const Halfedge_index h = complex.halfedge(e);
    if (!lengths.add(place(complex.source(h)), place(complex.target(h)), e.idx()))
      return false;
  }
  if (lengths.vanishes_in_unit(exponent))
    return false;
  const bool may_be_close = lengths.exponent_of_longest() - lengths.exponent_of_shortest() >= 28;
  std::vector<std::array<double, 3>> border;
  for (Face_index f : complex.faces()) {
    const Halfedge_index h = complex.halfedge(f), i = complex.next(h), j = complex.prev(h);
    const Face_index g = complex.face(complex.opposite(h));
    // Two faces with three common edges are the same triangle twice.
    if (g.is_valid() && complex.face(complex.opposite(i)) == g && complex.face(complex.opposite(j)) == g)
      return false;
    const std::array<std::array<double, 3>, 3> p = {
      {place(complex.source(h)), place(complex.source(i)), place(complex.source(j))}};
    if (internal::are_collinear(p[0], p[1], p[2]) || (may_be_close && internal::shortest_side(p)))
      return false;
    Halfedge_index side = h;
    for (std::uint32_t k = 0; k < 3; ++k, side = complex.next(side))
      if (complex.is_border(complex.opposite(side)))
        border.insert(border.end(), {p[k], p[(k + 1) % 3]});
  }
  if (border.empty())
    return true;
  const internal::Border_gaps gaps(border);
  for (std::size_t i = 0; i < border.size(); i += 2)
    if (gaps.are_within(border[i], border[i + 1]))
      return false;
  // Within an edge of two faces, only vertices of other components hang.
  if (!internal::is_connected(complex))
    for (Edge_index e : complex.edges()) {
      const Halfedge_index h = complex.halfedge(e);
      if (!complex.is_border(e) && gaps.are_within(place(complex.source(h)), place(complex.target(h))))
        return false;
    }
  return !gaps.are_close();
}

/// \ingroup PkgIntrinsicTriangulationsValidation
/// \brief returns which triangles to turn over, by exchanging two corners, so that neighbors agree; in increasing
/// order.
///
/// The first triangle of each edge-connected part keeps its orientation. If an even number of triangles meets at an
/// edge, directions alternate around it, as at solids that touch. A one-sided surface is cut open somewhere.
/// \param points the positions of the vertices
/// \param triangles three different vertices for each triangle
std::vector<std::size_t> turned_triangles(const std::vector<std::array<double, 3>>& points,
                                          const std::vector<std::array<std::uint32_t, 3>>& triangles);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VALIDATE_TRIANGLES_H

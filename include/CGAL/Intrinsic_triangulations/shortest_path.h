// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Shortest paths on a surface.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H

#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Laid_out_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Window_propagation.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/shortest_edge_path.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief what `shortest_path()` found.
struct Shortest_path
{
  std::vector<Halfedge_index> halfedges; ///< each begins where the one before ends
  double distance = 0;                   ///< the length of the shortest path, up to rounding, in the unit of the input
  bool is_complete = true;               ///< whether it was found; if not, `halfedges` are any path
};

/// \cond SKIP_IN_MANUAL
namespace internal {

// From a vertex back along the straight ways by which distances were found, which become edges.
template <class Traits>
class Way_back
{
public:
  Way_back(Intrinsic_triangulation<Traits>& triangulation, const Laid_out_faces& faces, const Window_propagation& windows,
           const Interruption& interruption)
    : triangulation_(triangulation), faces_(faces), windows_(windows), interruption_(interruption)
  {}

  // The edge from v to the vertex where the straight way to it comes from. The faces that other straight ways cross remain.
  // \return the null descriptor if that was not found
  Halfedge_index follow(std::uint32_t v)
  {
    const std::uint32_t side = windows_.arrival(v).side;
    if (side == Laid_out_faces::none)
      return {};
    v_ = v;
    // v lies in the origin, and the way along the axis. It runs between the last corner on the left and that on the right.
    const double sine = std::sin(windows_.arrival(v).angle), cosine = std::cos(windows_.arrival(v).angle);
    const Laid_out_faces::Side& first = faces_.side(side);
    corners_ = {{first.apex_x * cosine + first.apex_y * sine, first.apex_y * cosine - first.apex_x * sine}, {first.length * cosine, -first.length * sine}};
    crossed_.clear();
    if (comes_from(faces_.side(faces_.prev(side)).vertex, corners_[0]))
      return complex().opposite(faces_.halfedge(faces_.prev(side)));
    if (comes_from(faces_.side(faces_.next(side)).vertex, corners_[1]))
      return faces_.halfedge(side);
    const std::uint32_t u = cross_faces(faces_.next(side));
    return u == Laid_out_faces::none ? Halfedge_index() : join_with(u);
  }

private:
  struct Point
  {
    double x, y;
  };
  // An edge that the way crosses.
  struct Crossing
  {
    Edge_index edge;
    std::size_t left, right; // corners
  };

  const Delta_complex& complex() const { return triangulation_.connectivity(); }

  // \return the vertex where the way comes from
  std::uint32_t cross_faces(std::uint32_t crossed)
  {
    std::size_t left = 0, right = 1;
    for (std::size_t i = 0; i < faces_.sides().size(); ++i) {
      const std::uint32_t side = faces_.side(crossed).opposite;
      if (side == Laid_out_faces::none)
        return Laid_out_faces::none;
      crossed_.push_back({complex().edge(faces_.halfedge(side)), left, right});
      const Laid_out_faces::Side& s = faces_.side(side);
      const Point &l = corners_[left], &r = corners_[right];
      const double ex = (r.x - l.x) / s.length, ey = (r.y - l.y) / s.length;
      const Point apex{l.x + s.apex_x * ex - s.apex_y * ey, l.y + s.apex_x * ey + s.apex_y * ex};
      const std::uint32_t vertex = faces_.side(faces_.prev(side)).vertex;
      if (comes_from(vertex, apex))
        return vertex;
      (apex.y > 0 ? left : right) = corners_.size();
      corners_.push_back(apex);
      crossed = apex.y > 0 ? faces_.next(side) : faces_.prev(side);
    }
    return Laid_out_faces::none;
  }

  // Whether the way meets a vertex at a point, and what remains of it is as long as the way from there.
  bool comes_from(std::uint32_t vertex, const Point& p) const
  {
    const double gone = std::hypot(p.x, p.y), whole = windows_.distances()[v_];
    return p.x > 0 && std::abs(p.y) <= 1e-5 * gone &&
           std::abs(windows_.distances()[vertex] + gone - whole) <= 1e-9 * whole;
  }

  // Flips the edges that are crossed, until none is: those after whose flip there is one less, and those that are not Delaunay if all
  // distances along the way are shortened by the same large factor. The way is then an edge of the constrained Delaunay triangulation of the faces
  // that it crosses, which can be laid out in the plane: its ends come as near to each other as to nothing else. So there is always an edge to flip.
  Halfedge_index join_with(std::uint32_t u)
  {
    Edge_index last;
    std::size_t budget = crossed_.size() * crossed_.size() + 100; // more flips come of rounding
    for (std::size_t i = 0; i < crossed_.size() && budget > 0;) {
      const Edge_index e = crossed_[i].edge;
      const std::size_t before = i == 0 ? none : other_corner(i - 1, i), behind = i + 1 == crossed_.size() ? none : other_corner(i + 1, i);
      const bool is_less = before == none || behind == none || (corners_[before].y > 0) == (corners_[behind].y > 0);
      if (!(is_less || is_in_circle(corners_[before], corners_[crossed_[i].right], corners_[crossed_[i].left], corners_[behind])) ||
          !complex().is_flippable(e) || triangulation_.flip(e) != Intrinsic_triangulation<Traits>::Flip_outcome::FLIPPED) {
        ++i;
        continue;
      }
      interruption_.check();
      --budget;
      last = e;
      if (is_less)
        crossed_.erase(crossed_.begin() + std::ptrdiff_t(i));
      else
        crossed_[i] = corners_[before].y > 0 ? Crossing{e, before, behind} : Crossing{e, behind, before};
      i -= i > 0; // the edge before it may now be flipped, too
    }
    if (!crossed_.empty())
      return {};
    const Halfedge_index h = complex().halfedge(last), g = complex().opposite(h);
    const auto joins = [&](Halfedge_index k) { return complex().source(k).idx() == v_ && complex().target(k).idx() == u; };
    return joins(h) ? h : joins(g) ? g
                                   : Halfedge_index();
  }

  // Whether s lies in the circle through p, q and r, which are counterclockwise, after that shortening.
  static bool is_in_circle(const Point& p, const Point& q, const Point& r, const Point& s)
  {
    const double px = p.x - s.x, py = p.y - s.y, qx = q.x - s.x, qy = q.y - s.y, rx = r.x - s.x, ry = r.y - s.y;
    return px * qy * ry * (ry - qy) + qx * ry * py * (py - ry) + rx * py * qy * (qy - py) > 0;
  }

  // Of one crossing, the corner that is none of its neighbor's.
  std::size_t other_corner(std::size_t i, std::size_t neighbor) const
  {
    return crossed_[i].left == crossed_[neighbor].left ? crossed_[i].right : crossed_[i].left;
  }

  static constexpr std::size_t none = std::size_t(-1);

  Intrinsic_triangulation<Traits>& triangulation_;
  const Laid_out_faces& faces_;
  const Window_propagation& windows_;
  const Interruption& interruption_;
  std::uint32_t v_ = 0;
  std::vector<Point> corners_;
  std::vector<Crossing> crossed_;
};

} // namespace internal
/// \endcond

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief finds a shortest path between two vertices, which becomes one of edges.
///
/// The distances from the source are found as by `geodesic_distances()` without a tolerance, the straight ways are followed back, and edges that
/// these cross are flipped until the ways are edges. `Geodesic_path_network` proves that the path is locally shortest, and leaves nothing but
/// rounding between its length and `distance`.
///
/// \param triangulation a triangulation, best a Delaunay one: its faces are the least to cross. It is flipped along the path
/// \param source, target vertices
/// \param options as of `geodesic_distances()`; the tolerance plays no part
/// \return the path; one without edges if both vertices are the same
/// \exception Invalid_point_error if there is no such vertex, or no path
/// \exception Cancelled_error as the options say
/// \exception Undecided_error as `flip()` of `Intrinsic_triangulation`
template <class Traits>
Shortest_path shortest_path(Intrinsic_triangulation<Traits>& triangulation, Vertex_index source, Vertex_index target,
                            const Geodesic_distance_options& options = Geodesic_distance_options())
{
  const Delta_complex& complex = triangulation.connectivity();
  const internal::Row_of_vertex row(complex);
  for (Vertex_index v : {source, target})
    if (!(v.idx() < row.number_of_rows()))
      throw Invalid_point_error("there is no vertex " + std::to_string(v.idx()) + ": the surface has " + std::to_string(row.number_of_rows()));
  Shortest_path result;
  if (source == target)
    return result;
  const internal::Laid_out_faces faces(triangulation, row);
  internal::Window_propagation windows(faces, 0);
  const internal::Interruption interruption(options.go_further);
  result.is_complete = windows.run({source.idx()}, internal::number_of_ways(options, complex), interruption);
  result.distance = std::ldexp(windows.distances()[target.idx()], faces.exponent());
  internal::Way_back<Traits> way(triangulation, faces, windows, interruption);
  for (Vertex_index v = target; v != source; v = complex.target(result.halfedges.back())) {
    const Halfedge_index h = way.follow(v.idx());
    if (h.is_valid()) {
      result.halfedges.push_back(h);
      continue;
    }
    const std::vector<Halfedge_index> rest = shortest_edge_path(triangulation, v, source);
    result.halfedges.insert(result.halfedges.end(), rest.begin(), rest.end());
    result.is_complete = false;
    break;
  }
  std::reverse(result.halfedges.begin(), result.halfedges.end());
  for (Halfedge_index& h : result.halfedges)
    h = complex.opposite(h);
  return result;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SHORTEST_PATH_H

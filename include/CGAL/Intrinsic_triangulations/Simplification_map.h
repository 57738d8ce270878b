// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Maps points of a surface to a simplified one, and back.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFICATION_MAP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFICATION_MAP_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsSimplification
/// \brief the map from a surface to a simplified one: it is continuous, one to one, and linear on pieces of faces.
///
/// It consists of the steps of the simplification in order: in each step a few triangles are replaced by others. It
/// needs about 600 bytes for each vertex that was removed.
class Simplification_map
{
public:
  /// \brief returns where points of the given surface lie on the simplified one.
  ///
  /// Vertices that remain stay vertices, exactly. Other coordinates are rounded in each step. O(number of points and
  /// steps).
  /// \param points points of `fine()`
  /// \return points of `coarse()`, whose coordinates sum to 1
  /// \exception Invalid_point_error if a halfedge is a border halfedge or out of range, or coordinates are not finite,
  ///   negative, or all zero
  std::vector<Surface_point> to_coarse(const std::vector<Surface_point>& points) const;
  /// \brief returns where points of the simplified surface lie on the given one; as `to_coarse()`, but in the other
  /// direction.
  std::vector<Surface_point> to_fine(const std::vector<Surface_point>& points) const;

  /// a part of a line within one face: its ends, with the same halfedge
  using Line_part = std::array<Surface_point, 2>;
  /// a polyline: each part begins where the one before ends, in the same face or in one beside it
  using Line = std::vector<Line_part>;
  /// \brief returns the polylines on the given surface that become straight lines within faces of the simplified one.
  ///
  /// O(number of steps, and of parts in all steps).
  /// \param lines straight lines, each within a face of `coarse()`
  /// \return polylines on `fine()`
  /// \exception Invalid_point_error as above, and if the ends of a line do not have the same halfedge
  std::vector<Line> lines_to_fine(const std::vector<Line_part>& lines) const;

  /// returns the triangles of the given surface: the connectivity of the triangulation that was simplified.
  const Delta_complex& fine() const { return fine_; }
  /// returns the triangles of the simplified surface: the input of the resulting triangulation.
  const Delta_complex& coarse() const { return coarse_; }

  /// \cond SKIP_IN_MANUAL
  // A triangle of a step: its number among all triangles of all steps, and its corners by the points of the step.
  struct Triangle
  {
    std::uint32_t number;
    std::array<std::uint32_t, 3> corners;
  };
  // The triangles around a vertex are replaced by others that cover the same part of the plane. The new ones can be
  // laid out in order, each beside one before. The last point of the step is the vertex.
  struct Step
  {
    std::size_t first; // of its triangles: first the old ones
    std::uint32_t number_of_old, number_of_new, number_of_points;
    std::array<double, 3> place; // of the vertex in the first new triangle
  };

  // Begins with the identity. `add_step()` follows the lines of its triangles; `finish()` ends with the numbers of the
  // faces of the result. The first corner of a face is the source of its `halfedge()`.
  explicit Simplification_map(const Delta_complex& complex, const std::vector<double>& lengths);
  Simplification_map() = default;
  std::uint32_t add_triangle(const std::array<double, 3>& sides)
  {
    sides_.push_back(sides);
    return std::uint32_t(sides_.size() - 1);
  }
  void add_to_step(const Triangle& triangle) { triangles_.push_back(triangle); }
  void add_step(std::uint32_t number_of_old, std::uint32_t number_of_points, const std::array<double, 3>& place);
  void finish(const Delta_complex& complex, std::vector<std::uint32_t> numbers);

  const std::vector<std::array<double, 3>>& sides() const { return sides_; } // from each corner to the next
  const std::vector<Step>& steps() const { return steps_; }
  const Triangle* triangles(const Step& step) const { return triangles_.data() + step.first; }
  std::uint32_t number_of_coarse_face(Face_index f) const { return number_of_face(f, false); }
  /// \endcond

private:
  using Coordinates = std::array<double, 3>;
  struct Layout;
  class Carrier;
  std::uint32_t number_of_face(Face_index f, bool is_fine) const
  {
    return is_fine ? f.idx() : coarse_numbers_[f.idx()];
  }
  template <class F>
  void for_each_step(bool is_forward, const F& f) const;
  std::vector<Surface_point> carried(const std::vector<Surface_point>& points, bool is_forward) const;

  Delta_complex fine_, coarse_;
  std::vector<std::array<double, 3>> sides_; // of all triangles that ever were, in the order in which they came
  std::vector<Triangle> triangles_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> coarse_numbers_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SIMPLIFICATION_MAP_H

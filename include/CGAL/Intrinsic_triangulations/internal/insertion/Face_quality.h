// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The faces that refinement makes smaller, and what prevents it.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Edge_sizes.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Measured_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Segments.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Small_cones.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Straight_edges.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The criteria for refinement; see `refine_Delaunay()` for the members.
struct Refinement_criteria
{
  double minimum_angle = 25;
  double maximum_circumradius = (std::numeric_limits<double>::infinity)();
  double maximum_edge_length = (std::numeric_limits<double>::infinity)();
  double maximum_deviation = (std::numeric_limits<double>::infinity)();
  bool splits_encroached_edges = false;
  double minimum_size = 0;
  std::vector<double> sizes = {}; // of the vertices of the input, or none
};

template <class Traits>
class Face_quality
{
public:
  Face_quality(const Delta_complex& complex, const Refinement_criteria& criteria, const Measured_faces<Traits>& faces,
               const Segments<Traits>& segments, const Small_cones& cones, const Straight_edges& straight,
               const Edge_sizes& sizes)
    : complex_(complex), criteria_(criteria), faces_(faces), segments_(segments), cones_(cones), straight_(straight),
      sizes_(sizes), sine_of_minimum_angle_(std::sin(minimum_angle()))
  {}

  const Refinement_criteria& criteria() const { return criteria_; }
  // In radians.
  double minimum_angle() const { return criteria_.minimum_angle / 180 * CGAL_PI; }

  bool is_below_smallest_size(Face_index f) const { return has_short_side(f) || is_too_low(f); }
  bool is_too_large(Face_index f) const
  {
    return has_long_side(f) || faces_.circumradius(f) > criteria_.maximum_circumradius || deviates(f);
  }
  bool has_small_angle(Face_index f) const
  {
    return has_small_angle(faces_.length(faces_.shortest_side(f)), faces_.circumradius(f));
  }
  // Whether a triangle with these measures would be refined, if nothing fixes its angles.
  bool is_bad(double shortest, double longest, double circumradius) const
  {
    return is_too_large(longest, circumradius) || has_small_angle(shortest, circumradius);
  }
  bool is_too_small(double angle) const { return angle < minimum_angle(); }

  // Whether f must be refined.
  bool is_bad(Face_index f) const
  {
    if (has_short_side(f))
      return false;
    if (is_too_low(f)) // the circumcircle of a low face tells how low it is
      return has_long_side(f) ||
             faces_.length(faces_.longest_side(f)) > std::sqrt(3.) * criteria_.maximum_circumradius || deviates(f);
    if (is_too_large(f))
      return true;
    const Halfedge_index h = complex_.halfedge(f);
    if (!has_small_angle(f))
      return false;
    for (Halfedge_index corner : {h, complex_.next(h), complex_.prev(h)})
      if (is_to_be_enlarged(corner))
        return true;
    return false;
  }
  bool is_to_be_enlarged(Halfedge_index corner) const
  {
    return is_too_small(faces_.angle(corner)) && !obstacle_at(corner) &&
           !segments_.is_between_shells(complex_.next(corner));
  }
  // How far the vertex may be that protects a small cone. The circumcenters of faces that are left lie closer to the tip
  // than 2 / sqrt(3) of that, so their sides are shorter than twice as much. There, sizes are at least 0.7 of that at the
  // tip. Straight triangles may leave out the part before that vertex.
  // \param radius of the input faces around it
  double radius_of_protected_cone(Vertex_index tip, double radius) const
  {
    return (std::min)({radius / (criteria_.sizes.empty() ? 2 : 8), 0.3 * sizes_.longest_between(tip, tip),
                       0.8 * criteria_.maximum_circumradius, criteria_.maximum_deviation / 3});
  }
  // Whether refinement cannot change the corner at the source of h.
  std::optional<Refinement_obstacle> obstacle_at(Halfedge_index h) const
  {
    if (segments_.contains(h) && segments_.contains(complex_.prev(h)))
      return Refinement_obstacle::SMALL_INPUT_ANGLE;
    if (cones_.contains(complex_.source(h)))
      return Refinement_obstacle::CONE;
    return std::nullopt;
  }

private:
  // Whole edges do not count.
  bool has_long_side(Face_index f) const
  {
    const Halfedge_index h = complex_.halfedge(f);
    for (Halfedge_index side : {h, complex_.next(h), complex_.prev(h)})
      if (faces_.length(side) > sizes_.longest_between(complex_.source(side), complex_.target(side)) &&
          !segments_.is_whole(complex_.edge(side)))
        return true;
    return false;
  }
  bool has_short_side(Face_index f) const { return faces_.length(faces_.shortest_side(f)) < criteria_.minimum_size; }
  bool is_too_low(Face_index f) const
  {
    return criteria_.minimum_size > 0 && faces_.smallest_height(f) < criteria_.minimum_size;
  }
  bool deviates(Face_index f) const
  {
    return std::isfinite(criteria_.maximum_deviation) &&
           straight_.deviates(f, criteria_.maximum_deviation, has_small_angle(f));
  }
  bool is_too_large(double longest, double circumradius) const
  {
    return longest > criteria_.maximum_edge_length || circumradius > criteria_.maximum_circumradius;
  }
  // The sine of the smallest angle is the shortest side over the diameter of the circumcircle.
  bool has_small_angle(double shortest, double circumradius) const
  {
    return !(shortest > 2 * circumradius * sine_of_minimum_angle_ * (1 + 1e-9));
  }

  const Delta_complex& complex_;
  const Refinement_criteria criteria_;
  const Measured_faces<Traits>& faces_;
  const Segments<Traits>& segments_;
  const Small_cones& cones_;
  const Straight_edges& straight_;
  const Edge_sizes& sizes_;
  const double sine_of_minimum_angle_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_FACE_QUALITY_H

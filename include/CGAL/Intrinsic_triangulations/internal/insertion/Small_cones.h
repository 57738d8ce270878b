// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Vertices at which small angles cannot be avoided.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/Exact_engine.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>

#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Vertices with a small sum of angles, from which refinement keeps its distance: see doc/termination.md. Lengths are in
// the unit of the input.
class Small_cones
{
public:
  Small_cones(const Exact_engine& engine, Input_shapes& shapes)
    : input_(engine.correspondence().input()), unit_exponent_(engine.metric().unit_exponent()), shapes_(shapes)
  {}

  void add(Vertex_index v, double angle) { cones_.emplace(v, Cone{angle, 0}); }
  bool contains(Vertex_index v) const { return cones_.count(v) != 0; }
  std::vector<Vertex_index> vertices() const;

  // A circle around v of this radius lies in the input faces there: the smallest height from v.
  double radius_of_input_faces(Vertex_index v) const;

  // Keeps the circumcircle of the triangle empty that a vertex at this distance forms with v.
  void protect(Vertex_index v, double distance);

  bool is_too_close(const Surface_point& point) const;

private:
  struct Cone
  {
    double angle;
    double radius; // of the circle that is kept empty
  };

  const Delta_complex& input_;
  const int unit_exponent_;
  Input_shapes& shapes_;
  std::unordered_map<Vertex_index, Cone> cones_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_INSERTION_SMALL_CONES_H

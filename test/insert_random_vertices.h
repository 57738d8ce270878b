// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// New vertices at random points, many of them on edges and on common lines.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TEST_INSERT_RANDOM_VERTICES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TEST_INSERT_RANDOM_VERTICES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>

#include <cstddef>
#include <random>

namespace CGAL {
namespace Intrinsic_triangulations {

// The coordinates are integers up to `largest_coordinate`; a quarter or more of the points lie on edges of the input;
// points on edges that are not in the triangulation are omitted, as are points inserted before.
// \return the number of new vertices
template <class Traits>
std::size_t insert_random_vertices(Intrinsic_triangulation<Traits>& triangulation, std::size_t number,
                                   unsigned largest_coordinate, std::mt19937& random)
{
  const Delta_complex& input = triangulation.input();
  std::size_t inserted = 0;
  for (std::size_t i = 0; i < number; ++i) {
    Surface_point point;
    do
      point.halfedge = Halfedge_index(std::uint32_t(random() % input.number_of_halfedges()));
    while (input.is_border(point.halfedge));
    for (double& x : point.coordinates)
      x = 1 + random() % largest_coordinate;
    if (random() % 2 == 0)
      point.coordinates[random() % 3] = 0;
    try {
      insert_vertex(triangulation, point);
      ++inserted;
    } catch (const Invalid_point_error&) {
    }
  }
  return inserted;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TEST_INSERT_RANDOM_VERTICES_H

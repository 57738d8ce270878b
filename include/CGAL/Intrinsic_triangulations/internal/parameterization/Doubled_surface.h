// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Two copies of a surface, glued along its border.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DOUBLED_SURFACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DOUBLED_SURFACE_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Face n + f of the input is the mirror image of face f, if there are n. A closed surface is not doubled.
struct Doubled_surface
{
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;

  // Flips to Delaunay.
  // \exception Invalid_argument_error if vertices were inserted into a surface with a border
  Doubled_surface(const Triangulation& surface, const Progress_function& progress);

  // The number of copies of a face, by which all sums of angles are multiplied.
  double factor() const { return is_doubled ? 2 : 1; }
  // Whether a face of the input is not a mirror image.
  bool is_given(Face_index f) const { return !is_doubled || f.idx() < triangulation.input().number_of_faces() / 2; }

  bool is_doubled;
  Triangulation triangulation;
  std::vector<double> lengths; // of its edges, within 1 ulp, the longest in [1, 2), so that no scale rounds roots
  int unit;                    // 2^unit units of the input are 1
  std::vector<Vertex_index> vertices;    // for each vertex, that of the surface
  std::vector<Vertex_index> images;      // for each vertex of the surface, that in the first copy
  std::vector<Halfedge_index> halfedges; // for each halfedge of the surface's input with a face, that of the first copy

private:
  void glue(const Triangulation& surface);
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_DOUBLED_SURFACE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The plain arrays of an overlay graph.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// Segments of intrinsic edges come first, edge by edge; the crossing at the end of segment s
// of edge e has the number s - e. Segments of input edges follow, edge by edge, too, but
// without those that coincide with intrinsic edges.
struct Overlay_arrays
{
  using size_type = std::uint32_t;
  static constexpr size_type null = Halfedge_index::null_index();

  struct Halfedge
  {
    size_type next;
    size_type target;
    size_type face;
  };
  struct Face
  {
    size_type halfedge;
    size_type intrinsic;
    size_type input;
  };
  struct Input_edge
  {
    size_type first;        // the first halfedge, out of the source of 2e; odd if it runs against an oc segment
    size_type count : 31;   // number of segments
    size_type is_split : 1; // if vertices were inserted on it, `first` is the index of its first part in `split_parts`
  };

  size_type intrinsic_segments_end(size_type e) const { return first_segments[e + 1]; }

  // The input halfedge that h is part of, or null.
  size_type input_halfedge(size_type h) const
  {
    const size_type parent = parents[h >> 1];
    if ((h >> 1) >= first_input_segment)
      return (parent << 1) | (h & 1);
    return coinciding_halfedges[parent] == null ? null : coinciding_halfedges[parent] ^ (h & 1);
  }

  // The part of an input edge at a position.
  size_type input_part(const Input_edge& edge, size_type position) const
  {
    return edge.is_split ? split_parts[edge.first + position] : edge.first + 2 * position;
  }

  size_type number_of_original_vertices = 0; // including inserted ones
  size_type number_of_input_vertices = 0;
  size_type first_input_segment = 0; // earlier ones have the label c or oc
  Large_vector<Halfedge> halfedges;
  Large_vector<size_type> parents; // the edge of each segment
  Large_vector<size_type> vertex_halfedges;
  Large_vector<Face> faces;
  Large_vector<size_type> first_segments;       // the first of each intrinsic edge, and the end of all
  Large_vector<size_type> coinciding_halfedges; // for each intrinsic edge, the input halfedge that 2e is part of
  Large_vector<Input_edge> input_edges;
  Large_vector<size_type> split_parts; // for input edges with inserted vertices, the halfedges from end to end
};

// \param threads runs the blocks of loops; without it, all is done at once
Overlay_arrays build_overlay(const Delta_complex& intrinsic, const Correspondence& correspondence,
                             const Progress_function& progress, const Block_runner& threads = {});

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_OVERLAY_OVERLAY_ARRAYS_H

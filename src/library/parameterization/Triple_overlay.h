// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The overlay of the input, its Delaunay triangulation, and the ideal Delaunay triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_TRIPLE_OVERLAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_TRIPLE_OVERLAY_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// With A the input, B the Delaunay triangulation and C the ideal one, edges of A and of C are straight within faces of B:
// those of C as lines of the projective model. B divides both into chords, which cross at most once in a face. The order of
// all ends around a face tells which chords cross, and in which order: pieces are found by integers, and numbers decide only
// how ends of A and of C alternate on an edge of B.
class Triple_overlay
{
public:
  // A point on an edge of C, seen from one side: `(1 - t) source + t target` of halfedge 2e, in the new metric.
  struct Ideal_point
  {
    Halfedge_index side;
    double t = 0;
  };
  struct Corner
  {
    std::uint32_t node = 0;
    // Where it lies in the face of C: `(1 - t) from + t to`.
    Ideal_point from, to;
    double t = 0;
    Halfedge_index ideal, input; // of C and of A, along the side to the next corner; null if there is none
  };
  struct Piece
  {
    std::vector<Corner> corners; // counterclockwise
    Face_index input;
  };

  // The constructor does all, and alone uses its arguments.
  // \param ideal_overlay of `subdivision.intrinsic()` and `ideal`
  // \param lengths of the Delaunay triangulation
  // \param u at its vertices
  Triple_overlay(const Common_subdivision& subdivision, const Delta_complex& ideal, const Overlay& ideal_overlay,
                 const std::vector<double>& lengths, const std::vector<double>& u, const Progress_function& progress);

  const std::vector<Surface_point>& nodes() const { return nodes_; } // on the input; vertices of the surface come first
  // Of nodes: those of homogeneous coordinates in the new metric that are linear on faces of B.
  const std::vector<double>& weights() const { return node_weights_; }
  const std::vector<Piece>& pieces() const { return pieces_; }

private:
  class Face_builder;
  // A crossing of an edge of B with one of C: its position on the former, in the direction of 2e, and on the latter, in the
  // new metric.
  struct Ideal_crossing
  {
    double position, t;
  };
  // On an edge of B, in the direction of 2e.
  struct On_edge
  {
    double position;
    std::uint32_t node;
    bool is_ideal;
  };

  // Of an edge of B, between crossings with A: its number, and its ends on the edge.
  struct Part_of_input
  {
    Edge_index edge;
    std::size_t number;
    double from, to;
  };

  void place_ideal_crossings(Edge_index e);
  void merge(Edge_index e);
  void divide_faces(const Progress_function& progress);
  Surface_point place_on_input(const Part_of_input& part, double position) const;
  static double fraction_of(double x, double from, double to)
  {
    return to > from ? (std::min)(1., (std::max)(0., (x - from) / (to - from))) : 0.5;
  }

  const Common_subdivision& subdivision_;
  const Delta_complex &intrinsic_, &ideal_;
  const Overlay& ideal_overlay_;
  const std::vector<double>& lengths_;
  std::vector<double> weights_, node_weights_; // of the vertices; of nodes
  std::vector<Surface_point> nodes_;
  std::uint32_t first_ideal_node_; // of the crossings of B and C, after those of A and B
  std::vector<Piece> pieces_;
  std::vector<Ideal_crossing> ideal_crossings_;
  std::vector<std::vector<On_edge>> on_edges_; // of B
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_TRIPLE_OVERLAY_H

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

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <tuple>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// With A the input, B the Delaunay triangulation and C the ideal one, edges of A and of C are straight within faces of
// B; edges of C are straight in the projective model. So each face of B is divided by chords of both, which cross at
// most once. The order of all ends around a face tells which chords cross, and in which order: pieces are found by
// integers, and numbers decide only how ends of A and of C alternate on an edge of B.
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
  using Visit = std::function<void(const Piece&)>;

  // \param ideal_overlay of `subdivision.intrinsic()` and `ideal`
  // \param lengths of the Delaunay triangulation
  // \param u at its vertices
  // \pre `subdivision`, `ideal` and `lengths` outlive it
  Triple_overlay(const Common_subdivision& subdivision, const Delta_complex& ideal, Overlay ideal_overlay,
                 const std::vector<double>& lengths, const std::vector<double>& u, const Progress_function& progress);

  // Calls `visit` with all pieces, those in one face of B one after the other. Crossings of A and C get other nodes
  // each time.
  void for_each_piece(const Visit& visit, const Progress_function& progress);

  // Where nodes lie on the input, except for vertices of the surface, which come first.
  const std::vector<Surface_point>& nodes() const { return nodes_; }
  // The weights of nodes: of homogeneous coordinates in the new metric that are linear on faces of B.
  const std::vector<double>& weights() const { return weights_; }

private:
  static constexpr std::uint32_t none = std::uint32_t(-1);

  // A crossing of an edge of B with one of C: its position on the former, in the direction of 2e, and on the latter, in
  // the new metric.
  struct Ideal_crossing
  {
    double position, t;
  };
  // A node on an edge of B, in the direction of 2e.
  struct On_edge
  {
    double position;
    std::uint32_t node;
    bool is_ideal;
  };
  // A node of a face of B: first those on its boundary, counterclockwise from its first corner, then those where chords
  // cross.
  struct Local_node
  {
    std::uint32_t number;
    bool is_ideal;                // a corner, or on C
    std::array<double, 3> place;  // on the boundary: barycentric
    Overlay::Halfedge input_part; // by crossings with A, that begins here or around it
    Overlay::Face start;          // of B and C: where the last chord of A began here
  };
  // A chord of A in a face of B and C.
  struct Part_of_chord
  {
    std::uint32_t from, to;
    Overlay::Halfedge chord;
  };
  // A crossing of a chord of C with one of A, in the order from the source of halfedge 2s: the nearer to it the other
  // chord's end on the right is, the earlier; with the same end, the farther its end on the left is.
  struct Crossing
  {
    std::uint32_t segment, right, left, node;
    double t; // on the edge of C
    bool operator<(const Crossing& x) const
    {
      return std::tie(segment, right, left) < std::tie(x.segment, x.right, x.left);
    }
  };
  // A corner of a face of B and C.
  struct Place
  {
    Corner corner;
    Face_index input; // beside the side to the next corner, if that is known
    std::uint32_t local, next;
  };

  double length(Halfedge_index h) const { return lengths_[intrinsic_.edge(h).idx()]; }
  double weight(std::uint32_t node) const { return weights_[local_[node].number]; }
  // The number of a node, counted around the boundary from a on.
  std::uint32_t after(std::uint32_t a, std::uint32_t x) const { return x >= a ? x - a : x + size_of_boundary_ - a; }
  std::uint32_t source(Overlay::Halfedge h) const { return ideal_begins_[h.idx()]; }
  std::uint32_t target(Overlay::Halfedge h) const { return source(ideal_overlay_.next(h)); }
  bool is_chord(Overlay::Halfedge h) const
  {
    return ideal_overlay_.label(ideal_overlay_.segment(h)) == Segment_label::INTRINSIC;
  }

  std::vector<std::array<double, 2>> lengths_to(const std::vector<Halfedge_index>& gates) const;
  void place_ideal_crossings(Edge_index e);
  void merge(Edge_index e);
  Surface_point place_on_input(Overlay::Halfedge part, double t) const;
  void collect_boundary(Face_index f);
  void follow(Overlay::Halfedge chord);
  void cross(Overlay::Halfedge chord, Overlay::Segment segment, bool leads_right);
  Ideal_point ideal_point(std::uint32_t node, Halfedge_index h, bool begins) const;
  void collect_places(Overlay::Face f);
  void collect_side(Overlay::Halfedge h, Ideal_point first, Ideal_point second);
  void divide_by_chords(std::vector<Part_of_chord>& chords, const Visit& visit);

  const Common_subdivision& subdivision_;
  const Overlay& overlay_;
  const Delta_complex &intrinsic_, &ideal_;
  Overlay ideal_overlay_;
  const std::vector<double>& lengths_;
  std::uint32_t first_ideal_node_; // of the crossings of B and C, after those of A and B
  std::vector<Ideal_crossing> ideal_crossings_;
  std::vector<Surface_point> nodes_;
  std::vector<double> weights_;
  std::vector<On_edge> on_edges_; // of B, one after the other
  std::vector<std::size_t> first_on_edge_;
  // The nodes of the present face of B where halfedges in it begin, and the number of each face of B and C in it.
  std::vector<std::uint32_t> input_begins_, ideal_begins_, numbers_;
  // For the present face of B:
  std::vector<Local_node> local_;
  std::uint32_t size_of_boundary_ = 0;
  std::vector<Overlay::Halfedge> chords_; // of A, once from each end
  std::vector<Overlay::Face> faces_;      // of B and C
  std::vector<std::vector<Part_of_chord>> parts_;
  std::vector<Crossing> crossings_;
  // For the present face of B and C, counterclockwise; and the positions of local nodes among places.
  std::vector<Overlay::Halfedge> sides_;
  std::vector<Ideal_point> corners_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> number_of_place_;
  Piece piece_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_LIBRARY_PARAMETERIZATION_TRIPLE_OVERLAY_H

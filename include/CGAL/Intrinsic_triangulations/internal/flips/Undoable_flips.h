// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Flips that can be undone.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Flips, with error bounds, that can be undone: this restores connectivity, integers and stored numbers to the last
// bit.
//
// A single stored bound for a face and its sides grows several times over with each flip, because it adds up the errors
// of all of them: after a dozen flips of thin faces nothing can be decided. So here each edge and each face has a bound
// of its own, from the first flip that needs it, and the stored bounds follow from these.
//
// \pre nothing else changes the triangulation, and no `begin_log()` is called
template <class Traits>
class Undoable_flips
{
  using Whole = Whole_triangulation<Traits>;

public:
  using Triangulation = Intrinsic_triangulation<Traits>;
  using Real = Double_with_bound;

  explicit Undoable_flips(Triangulation& triangulation)
    : whole_(triangulation), edge_errors_(complex().number_of_edges(), unknown),
      face_errors_(complex().number_of_faces(), unknown)
  {}

  Triangulation& triangulation() const { return whole_.triangulation(); }

  // In the unit of the metric.
  Real squared_length(Edge_index e)
  {
    double& error = edge_errors_[e.idx()];
    if (error == unknown)
      error = stored_error(e);
    return {whole_.triangulation().edge_data(e), error};
  }
  Real four_areas(Face_index f)
  {
    const auto& stored = whole_.triangulation().face_data(f);
    const double error = face_errors_[f.idx()];
    return {stored.value, error < 0 ? two_thirds * stored.error : error};
  }

  // The number of changes so far.
  std::size_t size() const { return changes_.size(); }

  // Undoes changes down to an earlier number of them. Never throws.
  void undo(std::size_t size)
  {
    for (; changes_.size() > size; changes_.pop_back()) {
      const auto& [side, is_flip, before] = changes_.back();
      if (is_flip) {
        const Hinge_halfedges now = complex().hinge(complex().edge(side));
        whole_.flip_back({now.ij, now.lj, now.jk, now.ji, now.ki, now.il}, before);
        forget_errors(complex().opposite(side));
      } else {
        whole_.put_back(side, before.ijk);
      }
      forget_errors(side);
    }
  }

  // As `flip()` and `recompute()` of a triangulation. After an exception everything is as before, except that numbers
  // may be better.
  // \return whether the edge was flipped. \pre it is flippable
  bool flip(Edge_index e)
  {
    const Hinge_halfedges around = complex().hinge(e);
    Quadrilateral sides = quadrilateral(around);
    Uncertain<bool> is_convex = sides.is_convex();
    if (!is_certain(is_convex)) {
      recompute(complex().face(around.ij));
      recompute(complex().face(around.ji));
      sides = quadrilateral(around);
      is_convex = sides.is_convex();
      if (!is_certain(is_convex))
        is_convex = whole_.engine().is_convex(e);
    }
    if (!is_convex)
      return false;
    make_room(changes_, 1);
    const Change change{around.ij, true, whole_.replaced(around)};
    const Real kl = sides.other_diagonal(), ilk = sides.area_at_i(), jkl = sides.area_at_j();
    const double errors[] = {stored_error(kl.error() + sides.error_of_ki_and_il, ilk.error()),
                             stored_error(kl.error() + sides.error_of_jk_and_lj, jkl.error())};
    whole_.flip_convex(around, [&](const auto&, auto& flipped) {
      flipped.kl = kl.hi();
      flipped.ilk = {ilk.hi(), errors[0]};
      flipped.jkl = {jkl.hi(), errors[1]};
      return true;
    });
    changes_.push_back(change);
    edge_errors_[e.idx()] = kl.error();
    note_error(complex().face(around.ij), ilk, errors[0]);
    note_error(complex().face(around.ji), jkl, errors[1]);
    return true;
  }
  // \return whether that may have made them better
  bool recompute(Face_index f)
  {
    if (face_errors_[f.idx()] == recomputed)
      return false;
    const Halfedge_index h = complex().halfedge(f);
    make_room(changes_, 1);
    changes_.push_back({h, false, {whole_.numbers_of_face(h), {}, {}}});
    if (whole_.recompute(f))
      for (Halfedge_index side : {h, complex().next(h), complex().prev(h)})
        edge_errors_[complex().edge(side).idx()] = least_error * whole_.triangulation().edge_data(complex().edge(side));
    face_errors_[f.idx()] = recomputed;
    return true;
  }

private:
  // Four times the doubled areas of both triangles at an end of the edge, and the like. See `flip_hinge()`.
  struct Quadrilateral
  {
    Real ij, along, across, at_i, at_j;
    double error_of_ki_and_il, error_of_jk_and_lj;

    Uncertain<bool> is_convex() const { return (at_i.sign() == POSITIVE) & (at_j.sign() == POSITIVE); }
    Real inverse() const { return Real(1) / ij.scaled(2); }
    Real area_at_i() const { return at_i * inverse(); }
    Real area_at_j() const { return at_j * inverse(); }
    Real other_diagonal() const
    {
      const Real s = (along * along + across * across) * inverse().scaled(0.5);
      return {s.hi(), (std::max)(s.error(), least_error * s.hi())};
    }
  };
  Quadrilateral quadrilateral(const Hinge_halfedges& around)
  {
    const auto squared = [this](Halfedge_index h) { return squared_length(complex().edge(h)); };
    const Real ij = squared(around.ij), jk = squared(around.jk), ki = squared(around.ki), il = squared(around.il),
               lj = squared(around.lj), ijk = four_areas(complex().face(around.ij)),
               jil = four_areas(complex().face(around.ji));
    const Real of_k = ki - jk, of_l = il - lj;
    return {ij,
            of_k - of_l,
            ijk + jil,
            (ij + of_k) * jil + (ij + of_l) * ijk,
            (ij - of_k) * jil + (ij - of_l) * ijk,
            ki.error() + il.error(),
            jk.error() + lj.error()};
  }

  struct Change
  {
    Halfedge_index side; // of the edge that was flipped, or of the face whose numbers were replaced
    bool is_flip;
    typename Whole::Replaced before;
  };

  static constexpr double unknown = -1, recomputed = -2; // the stored bound is the only one
  static constexpr double u = 0x1p-53;
  // The bound of a squared length from which (1) and (3) of `Filtered_edge_length_traits` follow; a number may be
  // replaced by one that is as accurate as the initial ones.
  static constexpr double least_error = 8.01 * u;
  static constexpr double two_thirds = 0.6667;

  const Delta_complex& complex() const { return whole_.connectivity(); }

  // The bound E that follows from the bounds of the sides and of the area.
  static double stored_error(double of_sides, double of_area)
  {
    const bool are_numbers = of_sides >= 0 && of_area >= 0;
    return are_numbers ? 1.50001 * (std::max)(of_sides, of_area) : std::numeric_limits<double>::infinity();
  }
  // The bound that follows from the bounds E beside an edge, of which the other two sides have their share.
  double stored_error(Edge_index e) const
  {
    double result = std::numeric_limits<double>::infinity();
    for (Halfedge_index h : {complex().halfedge(e), complex().opposite(complex().halfedge(e))})
      if (!complex().is_border(h)) {
        const auto numbers = whole_.numbers_of_face(h);
        result = (std::min)(result, two_thirds * numbers.face.error - 5.99 * u * (numbers.next + numbers.prev));
      }
    return (std::max)(result, least_error * whole_.triangulation().edge_data(e));
  }
  // \param stored the bound that came with the area. A face in a plane has been measured anew
  void note_error(Face_index f, const Real& area, double stored)
  {
    face_errors_[f.idx()] = whole_.triangulation().face_data(f).error == stored ? area.error() : unknown;
  }
  void forget_errors(Halfedge_index h)
  {
    face_errors_[complex().face(h).idx()] = unknown;
    for (Halfedge_index side : {h, complex().next(h), complex().prev(h)})
      edge_errors_[complex().edge(side).idx()] = unknown;
  }

  Whole whole_;
  std::vector<Change> changes_;
  Large_vector<double> edge_errors_; // of squared lengths
  Large_vector<double> face_errors_; // of four times the areas
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_UNDOABLE_FLIPS_H

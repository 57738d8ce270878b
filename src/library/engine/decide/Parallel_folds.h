// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Proofs across parallel folds, without a root: that points lie on one straight line, or on one circle.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_PARALLEL_FOLDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_PARALLEL_FOLDS_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/Rational.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include "../history/Crossing_sequence.h"
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossed_halfedges.h>
#include "../layout/Vertex_positions.h"
#include "../layout/metric_images.h"
#include "../../measures/Flat_geometry.h"

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Let all input edges that two edges va and vb cross, and those that leave v between them, be parallel to one direction
// u, or have coplanar faces. Then each triangle of the strips lies in a plane that contains u, and unfolding preserves
// the coordinates of its points along u. So if a and b are level with v, that is, (a − v)·u = (b − v)·u = 0, then va
// and vb are perpendicular to u in the plane of the unfolding, and the angle between them is a multiple of π: on
// cylinders, prisms and folded plates, whatever lies between, without a root.
//
// Two segments along u with level midpoints are the bases of an isosceles trapezoid, whose corners lie on one circle:
// an edge between them is a tie.
class Parallel_folds
{
public:
  Parallel_folds(const Delta_complex& complex, const Correspondence& correspondence, Input_surface& surface)
    : complex_(complex), correspondence_(correspondence), input_(correspondence.input()), surface_(surface)
  {}

  // Whether the angle at their common source, counterclockwise from va to vb, is proven to be a multiple of π.
  bool are_level(Halfedge_index va, Halfedge_index vb)
  {
    const Vertex_index v = complex_.source(va), a = complex_.target(va), b = complex_.target(vb);
    if (points().empty() || correspondence_.is_inserted(v) || correspondence_.is_inserted(a) ||
        correspondence_.is_inserted(b))
      return false;
    fold_.reset();
    return folds_around_are_parallel(va, vb) && crossed_folds_are_parallel(va) && crossed_folds_are_parallel(vb) &&
           fold_ && is_perpendicular({v, a}, *fold_) && is_perpendicular({v, b}, *fold_);
  }

  // Whether a point of an input face that h runs through is proven to lie on h, being level with both ends.
  bool contains(Halfedge_index h, const Vertex_positions& positions, const Surface_point& point)
  {
    fold_.reset();
    if (points().empty() || !crossed_folds_are_parallel(h) || !fold_)
      return false;
    const auto rational = [](double x) { return Rational(x); };
    const auto u = difference<Rational>(points(), fold_->first, fold_->second);
    const Rational level = scalar_product(u, positions.position(point, rational));
    return level == Rational(scalar_product(u, positions.position(complex_.source(h), rational))) &&
           level == Rational(scalar_product(u, positions.position(complex_.target(h), rational)));
  }

  // Whether the hinge of an edge that has two faces is proven to be an isosceles trapezoid whose bases run along the
  // folds.
  bool is_trapezoid(Edge_index e)
  {
    fold_.reset();
    const Hinge_halfedges around = complex_.hinge(e);
    if (points().empty() || !folds_along_are_parallel(around.ij) || !fold_)
      return false;
    const std::array<Halfedge_index, 4> sides{around.il, around.lj, around.jk, around.ki};
    return (are_level_bases(sides[0], sides[2]) || are_level_bases(sides[1], sides[3])) &&
           std::all_of(sides.begin(), sides.end(), [&](Halfedge_index h) { return crossed_folds_are_parallel(h); });
  }

private:
  const Points& points() const { return surface_.metric().points(); }

  // The halfedges between va and vb.
  bool folds_around_are_parallel(Halfedge_index va, Halfedge_index vb)
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    std::int64_t number = 0;
    Halfedge_index vi = va;
    do { // once around v if va is vb
      if (complex_.is_border(vi))
        return false;
      number += coordinates.triangle_crossings(complex_, complex_.next(vi)).e_k +
                (vi != va && coordinates.is_original(complex_.edge(vi)) ? 1 : 0);
      vi = complex_.next_around_source(vi);
    } while (vi != vb);
    Halfedge_index h = correspondence_.input_halfedge(va);
    if (coordinates.is_original(complex_.edge(va)))
      h = input_.next_around_source(h);
    for (; number > 0; --number, h = input_.next_around_source(h))
      if (!is_parallel_fold(h))
        return false;
    return true;
  }

  bool crossed_folds_are_parallel(Halfedge_index h)
  {
    return all_crossed(h, [&](Halfedge_index crossed) { return is_parallel_fold(crossed); });
  }

  // The input edges that h crosses, or the one with which it coincides.
  bool folds_along_are_parallel(Halfedge_index h)
  {
    return correspondence_.coordinates().is_original(complex_.edge(h))
             ? is_parallel_fold(correspondence_.input_halfedge(h))
             : crossed_folds_are_parallel(h);
  }

  // Whether two edges run along the first fold, in planes that they do not leave, with midpoints at one level.
  bool are_level_bases(Halfedge_index g, Halfedge_index h) const
  {
    static const Vertex_positions::Inserted none; // exact positions are computed, not cached
    const Vertex_positions positions(input_, points(), correspondence_.locations(), none);
    const auto u = difference<Rational>(points(), fold_->first, fold_->second);
    Rational levels[2];
    for (int i = 0; i < 2; ++i) {
      const Halfedge_index side = i == 0 ? g : h;
      const auto position = [&](Halfedge_index at) {
        return positions.position(complex_.source(at), [](double x) { return Rational(x); });
      };
      const auto p = position(side), q = position(complex_.opposite(side));
      const Vector_3<Rational> along = minus(q, p), normal = cross_product(u, along);
      if (scalar_product(along, along) == 0 || scalar_product(normal, normal) != 0 ||
          !all_crossed(side, [&](Halfedge_index crossed) { return surface_.is_flat(crossed); }))
        return false;
      levels[i] = scalar_product(u, p) + scalar_product(u, q);
    }
    return levels[0] == levels[1];
  }

  // Whether a test holds for all input edges that h crosses; false if they are too many. (The corners beside an edge
  // that crosses too many can be laid out if their sides do not.)
  template <class Test>
  bool all_crossed(Halfedge_index h, const Test& test) const
  {
    const std::int64_t number = correspondence_.coordinates().number_of_crossings(complex_.edge(h));
    if (number == 0)
      return true;
    if (number > Crossing_sequence::largest_number)
      return false;
    const Crossed_halfedges crossed(complex_, correspondence_, h, surface_.interruption());
    for (std::size_t i = 0; i < crossed.size(); ++i)
      if (!test(crossed[i]))
        return false;
    return true;
  }

  // The first fold gives the direction.
  bool is_parallel_fold(Halfedge_index h)
  {
    if (surface_.is_flat(h))
      return true;
    const Vertex_pair ends{input_.source(h), input_.target(h)};
    if (fold_)
      return are_parallel(*fold_, ends);
    fold_ = ends;
    return true;
  }

  bool are_parallel(Vertex_pair p, Vertex_pair q) const
  {
    const auto is_zero = [&](std::size_t x, std::size_t y) {
      return has_sign_zero([&](auto zero) {
        using FT = decltype(zero);
        const auto d = difference<FT>(points(), p.first, p.second), e = difference<FT>(points(), q.first, q.second);
        return FT(d[x] * e[y] - d[y] * e[x]);
      });
    };
    return is_zero(0, 1) && is_zero(1, 2) && is_zero(2, 0);
  }
  bool is_perpendicular(Vertex_pair p, Vertex_pair q) const
  {
    return has_sign_zero([&](auto zero) {
      using FT = decltype(zero);
      return FT(
        scalar_product(difference<FT>(points(), p.first, p.second), difference<FT>(points(), q.first, q.second)));
    });
  }
  template <class Evaluate>
  static bool has_sign_zero(const Evaluate& evaluate)
  {
    const Uncertain<Sign> sign = evaluate(Bounded_double_double()).sign();
    return is_certain(sign) ? get_certain(sign) == ZERO : CGAL::is_zero(evaluate(Exact_ring()));
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Input_surface& surface_;
  std::optional<Vertex_pair> fold_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_PARALLEL_FOLDS_H

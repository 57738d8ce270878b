// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Squared lengths and areas in double-doubles, found by repeating all flips.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_REPEATED_FLIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_REPEATED_FLIPS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include "decide/corner_signs.h"
#include "history/Flip_log.h"
#include "layout/Developed_faces.h"
#include "layout/Vertex_positions.h"
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/With_error.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/Triangle_corner.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The numbers of faces that flips have changed. A flip takes as long as laying out a few triangles of the input,
// whatever the edges cross; after many flips, most edges cross more. Squared lengths take the least time. Where edges
// cross much, each flip would multiply their errors, so positions are carried along instead.
class Repeated_flips
{
public:
  using Real = Bounded_double_double;

  // \pre `log` is not followed by numbers
  Repeated_flips(const Delta_complex& complex, const Flip_log& log, const Input_metric& metric,
                 const Interruption& interruption)
    : squared_lengths_(complex.number_of_edges(), unknown()), four_areas_(complex.number_of_faces(), unknown())
  {
    std::size_t number = 0;
    log.repeat_unread(Flip_log::NUMBERS, complex, [&](const Delta_complex& before, const Hinge_halfedges& around) {
      if (++number % 1024 == 0)
        interruption.check();
      flip(before, metric, around);
    });
  }

  // Repeats the flips with positions.
  // \pre the input has points, and no vertex was inserted
  Repeated_flips(const Delta_complex& complex, const Flip_log& log, const Vertex_positions& positions,
                 const Interruption& interruption)
  {
    std::vector<bool> is_changed(complex.number_of_faces());
    std::size_t number = 0;
    log.repeat_unread(Flip_log::NUMBERS, complex, [&](const Delta_complex& before, const Hinge_halfedges& around) {
      if (++number % 1024 == 0)
        interruption.check();
      if (!faces_.flip_in_plane(around))
        faces_.flip(before, around, [&](Halfedge_index h) -> std::optional<Known_corner> {
          if (is_changed[before.face(h).idx()])
            return std::nullopt;
          return Known_corner{h, internal::straight_corner(before, positions, h), std::nullopt};
        });
      is_changed[before.face(around.ij).idx()] = is_changed[before.face(around.ji).idx()] = true;
    });
  }
  Developed_faces& faces() { return faces_; }

  // The corner opposite to h, unless its face has not changed, or a number errs by more than this part of it.
  std::optional<Triangle_corner<Real>> corner(const Delta_complex& complex, Halfedge_index h,
                                              double relative_error) const
  {
    const auto is_accurate = [&](const Real& x) { return x.error() <= relative_error * x.hi(); };
    if (squared_lengths_.empty()) {
      if (!faces_.contains(h))
        return std::nullopt;
      relative_error = (std::max)(relative_error, 0x1p-62); // a layout is hardly better
      const Triangle_corner<Real> c = faces_.corner(complex, h);
      if (is_accurate(c.four_areas) && is_accurate(c.s_first) && is_accurate(c.s_second) && is_accurate(c.s_opposite))
        return c;
      return std::nullopt;
    }
    const auto squared_length = [&](Halfedge_index side) { return squared_lengths_[complex.edge(side).idx()]; };
    const Real &a = four_areas_[complex.face(h).idx()], s_ij = squared_length(h),
               s_jk = squared_length(complex.next(h)), s_ki = squared_length(complex.prev(h));
    if (!(is_accurate(a) && is_accurate(s_ij) && is_accurate(s_jk) && is_accurate(s_ki)))
      return std::nullopt;
    return Triangle_corner<Real>{twice_scalar_product(s_jk, s_ki, s_ij), a, s_ki, s_jk, s_ij};
  }

private:
  // No computed number has this lower part.
  static Real unknown() { return {0, 1, std::numeric_limits<double>::infinity()}; }
  static bool is_unknown(const Real& x) { return x.hi() == 0 && x.lo() != 0; }

  // Elements that no flip has touched are those of the input.
  void flip(const Delta_complex& complex, const Input_metric& metric, const Hinge_halfedges& around)
  {
    const auto squared_length = [&](Halfedge_index h) -> Real& {
      Real& s = squared_lengths_[complex.edge(h).idx()];
      if (is_unknown(s))
        s = metric.squared_length_double_double(complex, complex.edge(h));
      return s;
    };
    const auto four_areas = [&](Halfedge_index h) -> Real& {
      Real& a = four_areas_[complex.face(h).idx()];
      if (is_unknown(a))
        a = metric.four_areas_double_double(complex, complex.face(h));
      return a;
    };
    // As flip_hinge(), with fewer operations.
    Real &s = squared_length(around.ij), &a = four_areas(around.ij), &b = four_areas(around.ji);
    const Real x_k = twice_scalar_product(s, squared_length(around.ki), squared_length(around.jk)),
               x_l = twice_scalar_product(s, squared_length(around.il), squared_length(around.lj)),
               r = Real(1) / s.scaled(2), along = x_k - x_l, across = a + b;
    s = ((along * along + across * across) * r).scaled(0.5);
    a = (x_k * b + x_l * a) * r;
    b = across - a;
  }

  Large_vector<Real> squared_lengths_, four_areas_; // by edges and faces; or else
  Developed_faces faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_REPEATED_FLIPS_H

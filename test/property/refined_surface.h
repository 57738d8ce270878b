// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Invariants under new vertices.

#ifndef IDT_TEST_PROPERTY_REFINED_SURFACE_H
#define IDT_TEST_PROPERTY_REFINED_SURFACE_H

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include "library/engine/layout/Unfolding.h"
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include "library/engine/decide/Ladder.h"
#include "library/engine/layout/metric_images.h"

#include <CGAL/enum.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

using Refined_triangulation =
  CGAL::Intrinsic_triangulations::Intrinsic_triangulation<CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>;

inline double total_area(const Refined_triangulation& t)
{
  long double sum = 0;
  for (CGAL::Intrinsic_triangulations::Face_index f : t.connectivity().faces())
    sum += t.area(f);
  return double(sum);
}

// Whether the angles at a vertex sum exactly to 2π, or to π on the border (Gauss-Bonnet): the product of the numbers
// p + i a of all corners, whose arguments are the angles, is real, of the right sign, and the sum is no other multiple
// of 2π by far.
inline bool is_exactly_flat(const Refined_triangulation& t, CGAL::Intrinsic_triangulations::Vertex_index v)
{
  namespace IT = CGAL::Intrinsic_triangulations;
  const IT::Delta_complex& complex = t.connectivity();
  std::vector<IT::Halfedge_index> opposite_sides;
  const IT::Halfedge_index first = complex.opposite(complex.halfedge(v));
  IT::Halfedge_index h = first;
  do {
    if (!complex.is_border(h))
      opposite_sides.push_back(complex.next(h));
    h = complex.next_around_source(h);
  } while (h != first);
  const auto sign_of_part = [&](auto part) {
    const auto surface = IT::internal::engine(t).input_surface();
    const auto evaluate = [&](auto& metric) {
      using Metric = std::decay_t<decltype(metric)>;
      const IT::internal::Unfolding<Metric> unfolding(complex, IT::internal::engine(t).correspondence(), metric);
      const auto vector = [&](IT::Halfedge_index opposite) {
        const auto corner = unfolding.opposite_corner(opposite);
        return typename Metric::Vector(corner.p, corner.four_areas);
      };
      auto product = vector(opposite_sides[0]);
      for (std::size_t i = 1; i < opposite_sides.size(); ++i)
        product = product * vector(opposite_sides[i]);
      return part(product);
    };
    return IT::internal::exact_sign(*surface, evaluate, [] { return std::string("angles at a vertex"); });
  };
  const bool is_on_border = complex.is_border(complex.halfedge(v));
  return std::abs(IT::angle_defect(t, v)) < 1 && sign_of_part([](const auto& z) { return z.y(); }) == CGAL::ZERO &&
         sign_of_part([](const auto& z) { return z.x(); }) == (is_on_border ? CGAL::NEGATIVE : CGAL::POSITIVE);
}

#endif // IDT_TEST_PROPERTY_REFINED_SURFACE_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Ties that a symmetry of the input makes: a proof by congruence.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H

#include <CGAL/Intrinsic_triangulations/internal/engine/history/Correspondence.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/history/Crossing_sequence.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/layout/metric_images.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/Flat_geometry.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Let z, a, b, c be the corners of the hinge of an edge, counterclockwise. If a reflection maps the input triangles
// that the hinge lies in, laid out in the plane, so that a ↔ b and z ↔ c, then the hinge is an isosceles trapezoid, and
// its edge is a tie, given that both faces have positive area. That is the case for two points and their mirror images
// in an exactly symmetric mesh. The reflection is found triangle by triangle: the strip of ab has to read the same from
// both ends, the fans at a and b have to be mirror images, and so have the strips of az and bc. Time: that of so many
// comparisons of rational numbers.
class Mirror_symmetry
{
public:
  Mirror_symmetry(const Delta_complex& complex, const Correspondence& correspondence, Input_surface& surface)
    : complex_(complex), correspondence_(correspondence), input_(correspondence.input()), surface_(surface)
  {}

  // Whether the hinge of e is proven to be symmetric in that way.
  bool operator()(Edge_index e)
  {
    const Halfedge_index ij = complex_.halfedge(e), ji = complex_.opposite(ij);
    for (Halfedge_index h : {ij, complex_.next(ij), ji, complex_.next(ji)})
      if (correspondence_.is_inserted(complex_.target(h))) // it begins in no corner of an input triangle
        return false;
    const Halfedge_index sides[] = {complex_.next(ji), complex_.prev(ji), complex_.next(ij), complex_.prev(ij)};
    for (int i = 0; i < 4; ++i)
      if (swaps_ends(sides[(i + 3) % 4], sides[i], sides[(i + 1) % 4]))
        return true;
    return false;
  }

private:
  // For three sides za, ab, bc in succession.
  bool swaps_ends(Halfedge_index za, Halfedge_index ab, Halfedge_index bc)
  {
    const Halfedge_index az = complex_.opposite(za), ba = complex_.opposite(ab);
    return are_mirror_images(az, bc) && are_mirror_images(ab, ba) && are_mirror_images(fan(ab, az), fan(bc, ba));
  }

  bool is_original(Halfedge_index h) const { return correspondence_.coordinates().is_original(complex_.edge(h)); }

  // The input halfedge along h or, clockwise, next to it.
  Halfedge_index reference(Halfedge_index h) const
  {
    const Halfedge_index roundabout = correspondence_.input_halfedge(h);
    return is_original(h) ? roundabout : input_.next(input_.opposite(roundabout));
  }

  // The input triangles around the source of two sides of the hinge, from the first in which its interior lies
  // to the last, counterclockwise: each to the left of one of the halfedges from `first` on.
  struct Fan
  {
    Halfedge_index first;
    std::int64_t size;
  };

  // \pre from `from` counterclockwise to `to` there are one or two corners of the hinge
  Fan fan(Halfedge_index from, Halfedge_index to) const
  {
    Fan result{reference(from), is_original(to) ? 0 : 1};
    for (Halfedge_index h = from; h != to; h = complex_.next_around_source(h))
      result.size += fan_of_corner(h);
    return result;
  }

  // The number of steps from the reference of h to that of the next halfedge around its source.
  std::int64_t fan_of_corner(Halfedge_index h) const
  {
    const Halfedge_index opposite_side = complex_.next(h), next = complex_.opposite(complex_.prev(h));
    return correspondence_.coordinates().triangle_crossings(complex_, opposite_side).e_k + (is_original(next) ? 1 : 0);
  }

  // The first fan is read counterclockwise, the second one clockwise.
  bool are_mirror_images(const Fan& a, const Fan& b)
  {
    if (a.size != b.size)
      return false;
    Halfedge_index last = b.first;
    for (std::int64_t i = 1; i < b.size; ++i)
      last = input_.next_around_source(last);
    Halfedge_index h = a.first, g = last;
    for (std::int64_t i = 0; i < a.size; ++i) {
      if (!are_mirrored_triangles(h, input_.opposite(input_.prev(g))))
        return false;
      h = input_.next_around_source(h);
      g = input_.next(input_.opposite(g));
    }
    return true;
  }

  // Whether the triangle to the left of h is the mirror image of that to the right of g.
  bool are_mirrored_triangles(Halfedge_index h, Halfedge_index g)
  {
    const Halfedge_index right = input_.opposite(g); // its triangle is on its left
    return have_equal_lengths(h, right) && have_equal_lengths(input_.next(h), input_.prev(right)) &&
           have_equal_lengths(input_.prev(h), input_.next(right));
  }

  bool have_equal_lengths(Halfedge_index h, Halfedge_index g)
  {
    surface_.interruption().check();
    const Edge_index d = input_.edge(h), e = input_.edge(g);
    const Input_metric& metric = surface_.metric();
    if (d == e || (!metric.points().empty() && are_mirrored_in_space(h, g)))
      return true;
    const auto sign =
      (metric.squared_length_double_double(input_, d) - metric.squared_length_double_double(input_, e)).sign();
    return is_certain(sign) && get_certain(sign) != ZERO
             ? false
             : squared_length(metric, input_, d) == squared_length(metric, input_, e);
  }

  // Whether two edges have the same extent along each axis, as they have if a plane between two axes mirrors them. A
  // difference of doubles is exact.
  bool are_mirrored_in_space(Halfedge_index h, Halfedge_index g) const
  {
    const auto& points = surface_.metric().points();
    const auto u = difference<Double_double>(points, input_.source(h), input_.target(h)),
               v = difference<Double_double>(points, input_.source(g), input_.target(g));
    for (std::size_t i = 0; i < 3; ++i)
      if (!(u[i].hi == v[i].hi && u[i].lo == v[i].lo) && !(u[i].hi == -v[i].hi && u[i].lo == -v[i].lo))
        return false;
    return true;
  }

  // Whether the strip of h, read from its source, is the mirror image of that of g.
  bool are_mirror_images(Halfedge_index h, Halfedge_index g)
  {
    const Normal_coordinates& coordinates = correspondence_.coordinates();
    const std::int64_t n = coordinates.crossings(complex_.edge(h));
    if (coordinates.crossings(complex_.edge(g)) != n)
      return false;
    Halfedge_index left = reference(h), right = reference(g);
    if (n < 0)
      return have_equal_lengths(left, right);
    // In the first triangle, h runs from a corner, to the left of `left`; g to the right of `right`.
    right = input_.opposite(input_.prev(right));
    if (!are_mirrored_triangles(left, right))
      return false;
    const Crossed_halfedges sequence_h(complex_, correspondence_, h, surface_.interruption()),
      sequence_g(complex_, correspondence_, g, surface_.interruption());
    // From here on the halfedges that are crossed, each with the triangle that follows on its left.
    Halfedge_index crossed_h = input_.opposite(input_.next(left)),
                   crossed_g = input_.opposite(input_.prev(input_.opposite(right)));
    for (std::int64_t i = 0;; ++i) {
      if (!are_mirrored_triangles(crossed_h, input_.opposite(crossed_g)))
        return false;
      if (i + 1 == n)
        return true;
      const bool turns_left = sequence_h.turns_left(std::size_t(i + 1));
      if (sequence_g.turns_left(std::size_t(i + 1)) == turns_left)
        return false;
      crossed_h = input_.opposite(turns_left ? input_.prev(crossed_h) : input_.next(crossed_h));
      crossed_g = input_.opposite(turns_left ? input_.next(crossed_g) : input_.prev(crossed_g));
    }
  }

  const Delta_complex& complex_;
  const Correspondence& correspondence_;
  const Delta_complex& input_;
  Input_surface& surface_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_DECIDE_MIRROR_SYMMETRY_H

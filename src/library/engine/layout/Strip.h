// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The strip of input triangles that an edge crosses, laid out in the plane.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRIP_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include "Fan_positions.h"

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The input edges that an edge crosses, in order, as halfedges from the left end to the right end.
using Crossed_edges = std::vector<Halfedge_index>;

// Whether a crossed edge shares its left end with the previous one.
inline bool keeps_left_end(const Delta_complex& input, Halfedge_index before, Halfedge_index crossed)
{
  return crossed == input.next_around_source(before);
}

// The third corner of the face of h.
inline Vertex_index apex(const Delta_complex& complex, Halfedge_index h) { return complex.target(complex.next(h)); }

// The last triangles laid out. They lie in one plane, so that a corner can be computed directly from the first edge of
// the run.
template <class Vector>
struct Strip_run
{
  Halfedge_index base; // the first edge, with the first triangle to its left
  Vector left;         // where its source lies
  Vector direction;    // from there to its target
  std::size_t length;  // number of triangles
};

// The first run, and the position of its base's target.
template <class Vector>
struct Strip_start
{
  Strip_run<Vector> run;
  Vector right;
};

// Twice the area of the triangle (0, a, b): positive if b is to the left of a.
template <class Complex>
auto area_between(const Complex& a, const Complex& b)
{
  return times_conjugate(b, a).y();
}

// The edge starts at 0, in the first triangle. Each crossed edge keeps one end of the previous one. Directions are
// products, and positions are sums of such products, so errors only add up.
//
// A number type and the data from which it computes make a frame:
//
// \tparam Frame with a type `Vector` of complex numbers;
//   `start(crossed)`, a `Strip_start`: of the first side of the first triangle, to the right end of the first
//     crossed edge;
//   `is_flat(h)`, whether the triangles of a crossed edge are known to lie in one plane; a `std::true_type` or
//     `std::false_type` where the answer is always the same, and functions for the other are not needed,
//   `turn_left(run, i)`, `turn_right(run, i, right)`: make of a run of one triangle, number i, its side from the
//     left end to the apex, or from there to the right end;
//   `position(run, v)`, `leave(run, h)`: in a run of several triangles, where a vertex lies, and what makes of the
//     run one that begins with h;
//   `keeps_fans()`, a `std::false_type`, or whether `turn_far_left(run, h)` and `turn_far_right(run, h)` make of a run
//     of one triangle one that begins with h, a later crossed edge with the same left or right end; asked by `end()`
//     alone,
//   `weights(coordinates)`, `real(weight)`: barycentric coordinates that sum to 1, and one of them as a vector,
//   `note(corner)`, to which each corner is shown that is kept; `check_interruption()`
template <class Frame>
class Strip
{
public:
  using Vector = typename Frame::Vector;

  Strip(const Delta_complex& input, Frame frame) : input_(input), frame_(std::move(frame)) {}

  // The end of the edge. Inside flat parts, nothing is computed.
  // \tparam Crossed like `Crossed_edges`, except for iterators
  // \param n the number of crossed edges, at least one
  // \param end in the triangle after them, or null for its third corner
  template <class Crossed>
  Vector end(const Crossed& crossed, std::size_t n, const Surface_point* end)
  {
    return walk<false>(crossed, n, end);
  }

  // Lays out all corners.
  // \pre something is crossed
  template <class Crossed, class End = std::nullptr_t>
  void lay_out(const Crossed& crossed, End end = nullptr)
  {
    corners_.clear();
    walk<true>(crossed, crossed.size(), end);
  }
  // Does the same for an edge that starts within the first triangle.
  void move_source(const Vector& source)
  {
    for (Corner& corner : corners_)
      corner.position = corner.position - source;
  }

  // The layout:
  const Vector& target() const { return corners_.back().position; }
  // The ends of the first edge; together with the source they are the corners of the first triangle.
  const Vector& first_right() const { return corners_[0].position; }
  const Vector& first_left() const { return corners_[1].position; }
  std::size_t number_of_edges() const { return corners_.size() - 2; }

  // The ends of a crossed edge, and the third corner of the triangle beyond it.
  struct Triangle
  {
    const Vector &left, &right, &apex;
  };
  Triangle triangle_behind(std::size_t edge) const
  {
    CGAL_precondition(edge < number_of_edges());
    const Vector *right = &first_right(), *left = &first_left();
    for (std::size_t i = 2; i < edge + 2; ++i)
      (corners_[i].is_on_right ? right : left) = &corners_[i].position;
    return {*left, *right, corners_[edge + 2].position};
  }

  // Twice the areas of the triangles that a crossed edge makes: from its left end to the line, from there to its
  // right end, and with the source.
  template <class Real>
  struct Crossing
  {
    Real left, right, along;
  };

  // Calls `visit(crossing, left, right)` for each edge, with its ends, as long as that returns `true`.
  // \return whether all were visited
  template <class Visit>
  bool for_each_crossing(const Visit& visit) const
  {
    const Vector *right = &first_right(), *left = &first_left();
    const auto area_left = [&] { return area_between(target(), *left); };
    const auto area_right = [&] { return area_between(*right, target()); };
    const auto area_along = [&] { return area_between(*right, *left); };
    Crossing<decltype(area_left())> crossing{area_left(), area_right(), area_along()};
    for (auto corner = corners_.begin() + 2;; ++corner) {
      if (!visit(crossing, *left, *right))
        return false;
      if (corner + 1 == corners_.end())
        return true;
      if (corner->is_on_right) {
        right = &corner->position;
        crossing.right = area_right();
      } else {
        left = &corner->position;
        crossing.left = area_left();
      }
      crossing.along = area_along();
    }
  }

  const Frame& frame() const { return frame_; }

private:
  using Run = Strip_run<Vector>;
  using Flatness = decltype(std::declval<Frame>().is_flat(Halfedge_index()));
  static constexpr bool can_be_flat = !std::is_same<Flatness, std::false_type>::value;
  static constexpr bool can_be_bent = !std::is_same<Flatness, std::true_type>::value;

  struct Corner
  {
    BOOST_FORCEINLINE Corner(const Vector& p, bool right) : position(p), is_on_right(right) {}
    Vector position;
    bool is_on_right;
  };

  template <bool keeps_corners>
  BOOST_FORCEINLINE void keep(const Vector& position, bool is_on_right)
  {
    if constexpr (keeps_corners) {
      Corner corner(position, is_on_right); // a copy: so `position` can stay in registers
      corners_.push_back(std::move(corner));
      frame_.note(position);
    }
  }

  // Returns the target, or keeps it as the last corner.
  // \tparam End `const Surface_point*`, or `std::nullptr_t` where no point is given
  template <bool keeps_corners, class Crossed, class End>
  auto walk(const Crossed& all, std::size_t n, [[maybe_unused]] End end)
  {
    Strip_start<Vector> first = frame_.start(all);
    Run& run = first.run;
    Vector& right = first.right;
    keep<keeps_corners>(right, true);
    Halfedge_index before, crossed = all.front();
    [[maybe_unused]] bool turned_left_before = false;
    for (std::size_t i = 0;;) {
      if (i % 64 == 63)
        frame_.check_interruption();
      // The first triangle has its corner on the left.
      const auto turned_left = [&] { return i > 0 && keeps_left_end(input_, before, crossed); };
      if (can_be_flat && frame_.is_flat(crossed)) {
        ++run.length;
        if constexpr (can_be_flat && keeps_corners) {
          const bool turns_left = turned_left();
          keep<true>(frame_.position(run, turns_left ? input_.target(crossed) : input_.source(crossed)), turns_left);
        }
      } else if constexpr (can_be_bent) {
        const bool turns_left = turned_left();
        if constexpr (!keeps_corners) {
          if (turns_left != turned_left_before || !cross_fan(all, n, run, crossed, i, turns_left))
            bend(run, right, crossed, i, turns_left);
          turned_left_before = turns_left;
        } else {
          bend(run, right, crossed, i, turns_left);
          if (turns_left) {
            right = run.left + run.direction;
            keep<true>(right, true);
          } else
            keep<true>(run.left, false);
        }
      }
      if (++i == n)
        break;
      before = crossed;
      crossed = all[i];
    }
    const auto target = [&] {
      if constexpr (!std::is_same<End, std::nullptr_t>::value)
        if (BOOST_UNLIKELY(end != nullptr))
          return position_in_triangle(run, n, crossed, *end);
      if constexpr (can_be_flat)
        if (run.length > 1)
          return frame_.position(run, apex(input_, crossed));
      if constexpr (can_be_bent)
        frame_.turn_left(run, n);
      return run.left + run.direction;
    };
    if constexpr (keeps_corners)
      corners_.emplace_back(target(), false);
    else
      return target();
  }

  // Where a point of the triangle to the left of h lies, the last one.
  BOOST_NOINLINE Vector position_in_triangle(Run& run, std::size_t n, Halfedge_index h, const Surface_point& point)
  {
    const auto weighted = [&](const Vector& left, const Vector& right, const Vector& apex) {
      const auto weight = frame_.weights(coordinates_from(input_, point, h));
      return frame_.real(weight[0]) * left + frame_.real(weight[1]) * right + frame_.real(weight[2]) * apex;
    };
    if constexpr (can_be_flat)
      if (run.length > 1)
        return weighted(frame_.position(run, input_.source(h)), frame_.position(run, input_.target(h)),
                        frame_.position(run, apex(input_, h)));
    const Vector left = run.left, right = run.left + run.direction;
    frame_.turn_left(run, n);
    return weighted(left, right, run.left + run.direction);
  }

  // Makes the run that begins with h, after triangle number i.
  BOOST_FORCEINLINE void bend(Run& run, const Vector& right, Halfedge_index h, std::size_t i, bool turns_left)
  {
    bool is_done = false;
    if constexpr (can_be_flat)
      if (run.length > 1) {
        frame_.leave(run, h);
        is_done = true;
      }
    if (!is_done) {
      if (turns_left)
        frame_.turn_left(run, i);
      else
        frame_.turn_right(run, i, right);
    }
    run.base = h;
    run.length = 1;
  }

  // Crosses at once many triangles that share an end of the base, from edge i to the last one; returns whether there
  // are that many.
  template <class Crossed>
  bool cross_fan(const Crossed& all, std::size_t n, Run& run, Halfedge_index& crossed, std::size_t& i, bool turns_left)
  {
    if constexpr (std::is_same<decltype(frame_.keeps_fans()), std::false_type>::value) {
      return false;
    } else {
      if (i == 0 || run.length > 1 || !frame_.keeps_fans())
        return false;
      Halfedge_index last = crossed;
      std::size_t end = i + 1;
      while (end < n && last != run.base && keeps_left_end(input_, last, all[end]) == turns_left)
        last = all[end++];
      if (end - i < Fan_positions::long_fan)
        return false;
      frame_.check_interruption();
      if (turns_left)
        frame_.turn_far_left(run, last);
      else
        frame_.turn_far_right(run, last);
      run.base = crossed = last;
      i = end - 1;
      return true;
    }
  }

  const Delta_complex& input_;
  Frame frame_;
  std::vector<Corner> corners_; // after the source; first those of the first crossed edge, last the target
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_ENGINE_LAYOUT_STRIP_H

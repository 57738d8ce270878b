// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A bundle of straight ways across a side of a face, and what is shorter of two of them.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace CGAL::Intrinsic_triangulations::internal {

constexpr double shorter = 1 - 1e-12; // by more than rounding

// std::hypot() takes four times as long. It is needed only if squares leave the range of double.
inline double length_of(double x, double y)
{
  const double square = x * x + y * y;
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : std::hypot(x, y);
}

// The part from b0 to b1 of a side, to be crossed into its face. Relative to the side, the way comes from (x, -y),
// where its length is sigma. A negative sigma means the way that reaches the vertex where the side begins, at the
// angle x to the left of the side.
struct Window
{
  double b0, b1, x, y, sigma;
  std::uint32_t side;
  std::uint32_t next = Laid_out_faces::none; // of the windows that wait at the side; invalid once another one has taken
                                             // its place
  std::uint32_t turns = 0;                   // the number of narrow edges crossed since the vertex

  double distance(double b) const { return sigma + length_of(b - x, y); }
};

// At the same side. If both are equal in all numbers, their order does not matter.
inline bool is_before(const Window& u, const Window& v)
{
  const auto key = [](const Window& w) { return std::make_tuple(w.b0, -w.b1, w.sigma, w.x, w.y); };
  return key(u) < key(v);
}

// The window as seen from a face that is turned over.
inline Window turned_over(const Window& w, double length)
{
  return {length - w.b1, length - w.b0, length - w.x, w.y, w.sigma, 0, Laid_out_faces::none, w.turns};
}

// By how much points may differ from that of w and be the same.
inline double least_difference(const Window& w) { return 1e-11 * (std::abs(w.x) + w.y + w.sigma); }

inline bool come_from_same_point(const Window& u, const Window& v)
{
  return std::abs(u.x - v.x) + std::abs(u.y - v.y) + std::abs(u.sigma - v.sigma) <= least_difference(u);
}

// Of two windows that come from the same point, the first one beginning first.
inline Window both(const Window& u, const Window& v)
{
  Window result = u.b1 - u.b0 > v.b1 - v.b0 ? u : v;
  result.b0 = u.b0;
  result.b1 = (std::max)(u.b1, v.b1);
  return result;
}

// Whether the ways of a window, and from its ends along the edge, are nowhere longer than those of w times a factor.
inline bool is_nowhere_longer(const Window& other, const Window& w, double factor)
{
  const auto is_longer = [&](double b) {
    const double at = (std::min)((std::max)(b, other.b0), other.b1);
    return other.distance(at) + std::abs(b - at) > w.distance(b) * factor;
  };
  if (is_longer(w.b0) || is_longer(w.b1))
    return false;
  // Beyond the ends of the other window, the difference grows outward. Between them, its derivative is zero where
  // both ways have the same direction.
  const double b = (w.x * other.y - other.x * w.y) / (other.y - w.y);
  return !(b > (std::max)(w.b0, other.b0) && b < (std::min)(w.b1, other.b1) && is_longer(b));
}

// From where on the ways of v, which come from farther to the right, are shorter than those of u by more than rounding,
// if both come from the same vertex. If v comes from farther to the left, up to where.
//
// Since |(b, 0) − (x, −y)|² = (b − x)² + y², the difference of the squares is linear in b. It has to be 2·10⁻¹² of the
// squares, and more if the way before that vertex is long.
inline double shorter_from(const Window& u, const Window& v)
{
  const double dx = v.x - u.x, meeting = ((u.x + v.x) + (u.y + v.y) * ((v.y - u.y) / dx)) / 2,
               r = length_of(meeting - u.x, u.y);
  return meeting + 4e-12 * r * ((r + u.sigma) / dx);
}

// Cuts off the end of u where v is shorter.
// \param v comes from farther to the right, and so is shorter at all points behind one where it is
// \return whether something remains
inline bool trim_end(Window& u, const Window& v)
{
  if (u.sigma != v.sigma || u.b1 <= v.b0 || u.b1 > v.b1)
    return true;
  const double b = (std::max)(v.b0, shorter_from(u, v));
  if (b < u.b1 && v.distance(b) < u.distance(b) * shorter && v.distance(u.b1) < u.distance(u.b1) * shorter)
    u.b1 = b;
  return u.b1 > u.b0;
}

// Likewise the beginning.
// \param v comes from farther to the left
inline bool trim_beginning(Window& u, const Window& v)
{
  if (u.sigma != v.sigma || u.b0 >= v.b1 || u.b0 < v.b0)
    return true;
  const double b = (std::min)(v.b1, shorter_from(u, v));
  if (b > u.b0 && v.distance(b) < u.distance(b) * shorter && v.distance(u.b0) < u.distance(u.b0) * shorter)
    u.b0 = b;
  return u.b1 > u.b0;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// A bundle of straight ways across a side of a face, and which of two is shorter.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H

#include <CGAL/Intrinsic_triangulations/internal/distances/Laid_out_faces.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

constexpr double shorter = 1 - 1e-12; // by more than rounding
constexpr double least_width = 1e-12; // of a window, as a fraction of its side

// std::hypot() takes four times as long. It is needed only if squares leave the range of double.
inline double length_of(double x, double y)
{
  const double square = x * x + y * y;
  return square > 0x1p-900 && square < 0x1p1000 ? std::sqrt(square) : std::hypot(x, y);
}

// The part from b0 to b1 of a side, to be crossed into its face.
//
// From a point: relative to the side, the way comes from (x, -y), where its length is sigma. A front: all ways have the
// direction (x, y), a unit vector, and where the side begins, the length is sigma, as if the front reached that far.
//
// Two other kinds stand for events at the vertex where the side begins: the way that reaches it at the angle x to the
// left of the side, and a source there.
struct Window
{
  enum Kind : std::uint16_t {
    POINT,
    FRONT,
    WAY_TO_VERTEX,
    SOURCE
  };

  static constexpr std::uint32_t taken = Laid_out_faces::none - 1;

  double b0, b1, x, y, sigma;
  std::uint32_t side;
  std::uint32_t next = Laid_out_faces::none; // of the windows that wait at the side; `taken` once another one has taken
                                             // its place
  std::uint32_t source = 0;                  // where the ways originally come from
  std::uint16_t turns = 0;                   // the number of narrow edges crossed since the vertex
  Kind kind = POINT;

  bool is_bundle() const { return kind <= FRONT; }
  double distance(double b) const { return kind == FRONT ? sigma + b * x : sigma + length_of(b - x, y); }
  // How far the way to a point of the side runs along the side while it rises by y.
  double run(double b) const { return kind == FRONT ? x : b - x; }
  double nearest() const { return kind == FRONT ? (x < 0 ? b1 : b0) : (std::min)((std::max)(x, b0), b1); }
  // The smaller, the farther to the left the ways come from.
  double place_in_order() const { return kind == FRONT ? -x : x; }
};

// An order of windows at the same side. If all numbers of two are equal, their order does not matter.
inline bool is_before(const Window& u, const Window& v)
{
  if (u.b0 != v.b0)
    return u.b0 < v.b0;
  const auto key = [](const Window& w) {
    return std::make_tuple(-w.b1, w.sigma, w.x, w.y, std::uint16_t(w.kind), w.source);
  };
  return key(u) < key(v);
}

// The window as seen from a face that is turned over.
inline Window turned_over(Window w, double length)
{
  if (w.kind == Window::FRONT) {
    w.sigma += length * w.x;
    w.x = -w.x;
  } else {
    w.x = length - w.x;
  }
  w.b0 = length - std::exchange(w.b1, length - w.b0);
  return w;
}

// By how much a point may differ from that of w and still count as the same; likewise for directions of fronts.
inline double least_difference(const Window& w)
{
  return w.kind == Window::FRONT ? 1e-13 * (1 + std::abs(w.sigma) / w.b1) : 1e-11 * (std::abs(w.x) + w.y + w.sigma);
}

inline bool come_from_same_point(const Window& u, const Window& v)
{
  return u.kind == v.kind && u.source == v.source &&
         std::abs(u.x - v.x) + std::abs(u.y - v.y) +
             std::abs(u.sigma - v.sigma) / (u.kind == Window::FRONT ? u.b1 : 1) <=
           least_difference(u);
}

// Unites two windows that come from the same point, or are parts of the same front. \pre u begins before v
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
  const double b = w.kind == other.kind      ? (w.x * other.y - other.x * w.y) / (other.y - w.y)
                   : w.kind == Window::FRONT ? other.x + other.y * (w.x / w.y)
                                             : w.x + w.y * (other.x / other.y);
  if (w.kind == Window::FRONT && other.kind == Window::FRONT)
    return true; // the difference is linear
  return !(b > (std::max)(w.b0, other.b0) && b < (std::min)(w.b1, other.b1) && is_longer(b));
}

// Where the ways of v, which come from farther to the right, begin to be shorter than those of u by more than rounding,
// if both are comparable; if v comes from farther to the left, where they cease to be.
//
// Since |(b, 0) − (x, −y)|² = (b − x)² + y², the difference of the squares is linear in b. It has to be 2·10⁻¹² of the
// squares, and more if the way before that vertex is long.
inline double shorter_from(const Window& u, const Window& v)
{
  if (u.kind == Window::FRONT) {
    const double meeting = (v.sigma - u.sigma) / (u.x - v.x);
    return meeting + 4e-12 * std::abs(u.distance(meeting)) / (u.x - v.x);
  }
  const double dx = v.x - u.x, meeting = ((u.x + v.x) + (u.y + v.y) * ((v.y - u.y) / dx)) / 2,
               r = length_of(meeting - u.x, u.y);
  return meeting + 4e-12 * r * ((r + u.sigma) / dx);
}

// Whether at most one point separates where either window is shorter: for two fronts, and two windows from the same
// vertex.
inline bool are_comparable(const Window& u, const Window& v)
{
  return u.kind == v.kind && (u.kind == Window::FRONT || u.sigma == v.sigma);
}

// Cuts off the end of u where v is shorter.
// \param v comes from farther to the right, and so is shorter at all points behind one where it is
// \return whether something remains
inline bool trim_end(Window& u, const Window& v)
{
  if (!are_comparable(u, v) || u.b1 <= v.b0 || u.b1 > v.b1)
    return true;
  const double b = (std::max)(v.b0, shorter_from(u, v));
  if (b < u.b1 && v.distance(b) < u.distance(b) * shorter && v.distance(u.b1) < u.distance(u.b1) * shorter)
    u.b1 = b;
  return u.b1 > u.b0;
}

// Likewise cuts off the beginning of u.
// \param v comes from farther to the left
inline bool trim_beginning(Window& u, const Window& v)
{
  if (!are_comparable(u, v) || u.b0 >= v.b1 || u.b0 < v.b0)
    return true;
  const double b = (std::min)(v.b1, shorter_from(u, v));
  if (b > u.b0 && v.distance(b) < u.distance(b) * shorter && v.distance(u.b0) < u.distance(u.b0) * shorter)
    u.b0 = b;
  return u.b1 > u.b0;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_WINDOW_H

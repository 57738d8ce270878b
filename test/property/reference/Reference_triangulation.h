// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Intrinsic Delaunay flips once more, in another way: each face keeps the plane positions of
// its corners as numbers of several hundred digits, a neighbor is carried over by a rotation
// of the complex plane, and the test is the in-circle determinant. Nothing of the package is
// used here, so that it can be compared with the package.

#ifndef IDT_TEST_REFERENCE_TRIANGULATION_H
#define IDT_TEST_REFERENCE_TRIANGULATION_H

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reference {

using Size = std::uint32_t;
constexpr Size none = std::numeric_limits<Size>::max();

// The combinatorics of a triangulation: side 3 f + c leads from corner c to corner c + 1 of
// face f.
struct Sides
{
  std::vector<Size> corner; // the vertex where a side starts
  std::vector<Size> twin;   // the side on the other side of the edge, or none
  std::vector<Size> edge;   // the number of the edge: in order of first appearance

  Size number_of_sides() const { return Size(corner.size()); }
  static Size next(Size side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static Size prev(Size side) { return side % 3 == 0 ? side + 2 : side - 1; }

  void number_edges()
  {
    edge.assign(number_of_sides(), none);
    Size count = 0;
    for (Size side = 0; side < number_of_sides(); ++side)
      if (edge[side] == none) {
        edge[side] = count;
        if (twin[side] != none)
          edge[twin[side]] = count;
        ++count;
      }
  }
};

// The sides of a simplicial surface.
inline Sides sides_of_triangles(const std::vector<std::array<Size, 3>>& triangles)
{
  Sides sides;
  std::map<std::pair<Size, Size>, Size> side_of;
  for (const std::array<Size, 3>& triangle : triangles)
    for (int c = 0; c < 3; ++c) {
      if (!side_of.emplace(std::make_pair(triangle[c], triangle[(c + 1) % 3]), sides.number_of_sides()).second)
        throw std::invalid_argument("two faces traverse an edge in the same direction");
      sides.corner.push_back(triangle[c]);
    }
  sides.twin.assign(sides.number_of_sides(), none);
  for (const auto& [ends, side] : side_of) {
    const auto opposite = side_of.find({ends.second, ends.first});
    if (opposite != side_of.end())
      sides.twin[side] = opposite->second;
  }
  sides.number_edges();
  return sides;
}

// The sides of triangles that are glued pairwise; vertices are numbered by their first corner.
inline Sides sides_of_gluing(std::size_t number_of_faces, const std::vector<std::array<Size, 2>>& glued_sides)
{
  Sides sides;
  sides.twin.assign(3 * number_of_faces, none);
  for (const std::array<Size, 2>& pair : glued_sides) {
    sides.twin[pair[0]] = pair[1];
    sides.twin[pair[1]] = pair[0];
  }
  sides.corner.assign(3 * number_of_faces, none);
  Size count = 0;
  for (Size first = 0; first < sides.number_of_sides(); ++first) {
    if (sides.corner[first] != none)
      continue;
    std::vector<Size> corners{first};
    while (!corners.empty()) {
      const Size side = corners.back();
      corners.pop_back();
      if (sides.corner[side] != none)
        continue;
      sides.corner[side] = count;
      if (sides.twin[side] != none) // the twin ends at this vertex: its next side starts there
        corners.push_back(Sides::next(sides.twin[side]));
      const Size incoming = Sides::prev(side);
      if (sides.twin[incoming] != none)
        corners.push_back(sides.twin[incoming]);
    }
    ++count;
  }
  sides.number_edges();
  return sides;
}

// Two vertices, to be merged, were found to coincide on the surface.
struct Coincident_vertices : std::runtime_error
{
  Coincident_vertices() : std::runtime_error("two vertices coincide on the surface") {}
};

enum class Circle_test {
  DELAUNAY,
  TIE,
  NOT_DELAUNAY
};

template <unsigned digits = 510>
class Reference_triangulation
{
public:
  using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<digits, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

  struct Point
  {
    Real x, y;
    friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
    friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
  };

  // An edge as it can be compared: where it leads and how long it is.
  struct Measured_edge
  {
    Size a, b; // a <= b
    Real squared_length;
    bool operator<(const Measured_edge& other) const
    {
      return a != other.a ? a < other.a : b != other.b ? b < other.b : squared_length < other.squared_length;
    }
  };

  // From positions in space.
  Reference_triangulation(Sides sides, const std::vector<std::array<double, 3>>& points)
    : Reference_triangulation(std::move(sides))
  {
    for (Size i = 0; i < sides_.number_of_sides(); i += 3) {
      std::array<Real, 3> u, v;
      for (int c = 0; c < 3; ++c) {
        const Real origin = points[sides_.corner[i]][c];
        u[c] = Real(points[sides_.corner[i + 1]][c]) - origin;
        v[c] = Real(points[sides_.corner[i + 2]][c]) - origin;
      }
      const Real uu = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
      const Real uv = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
      const Real nx = u[1] * v[2] - u[2] * v[1], ny = u[2] * v[0] - u[0] * v[2], nz = u[0] * v[1] - u[1] * v[0];
      const Real length = sqrt(uu);
      if (length == 0 || (v[0] == 0 && v[1] == 0 && v[2] == 0) || (u[0] == v[0] && u[1] == v[1] && u[2] == v[2]))
        throw Coincident_vertices();
      position_[i] = {0, 0};
      position_[i + 1] = {length, 0};
      position_[i + 2] = {uv / length, sqrt(nx * nx + ny * ny + nz * nz) / length};
    }
  }

  // From the lengths of the sides.
  Reference_triangulation(Sides sides, const std::vector<double>& side_lengths)
    : Reference_triangulation(std::move(sides))
  {
    for (Size i = 0; i < sides_.number_of_sides(); i += 3) {
      const Real a = side_lengths[i], b = side_lengths[i + 1], c = side_lengths[i + 2];
      const Real heron = (a + b + c) * (a + b - c) * (b + c - a) * (c + a - b);
      if (heron < 0)
        throw std::invalid_argument("three lengths that no triangle has");
      position_[i] = {0, 0};
      position_[i + 1] = {a, 0};
      position_[i + 2] = {(a * a + c * c - b * b) / (2 * a), sqrt(heron) / (2 * a)};
    }
  }

  const Sides& sides() const { return sides_; }
  Size number_of_edges() const { return Size(side_of_edge_.size()); }
  // A side of an edge.
  Size side(Size edge) const { return side_of_edge_[edge]; }
  bool is_border(Size edge) const { return sides_.twin[side(edge)] == none; }
  // Whether two different faces meet in the edge.
  bool is_flippable(Size edge) const
  {
    const Size s = side(edge), t = sides_.twin[s];
    return t != none && s / 3 != t / 3;
  }

  Real squared_length_of_side(Size s) const { return squared_norm(position_[Sides::next(s)] - position_[s]); }
  Real squared_length(Size edge) const { return squared_length_of_side(side(edge)); }
  Real length(Size edge) const { return sqrt(squared_length(edge)); }
  // Twice the area of the face of a side.
  Real double_area(Size s) const
  {
    const Size i = s - s % 3;
    return cross(position_[i + 1] - position_[i], position_[i + 2] - position_[i]);
  }
  // The cotangent of the angle opposite to a side.
  Real cotangent(Size s) const
  {
    const Point& apex = position_[Sides::prev(s)];
    const Point u = position_[s] - apex, v = position_[Sides::next(s)] - apex;
    return dot(u, v) / cross(u, v);
  }

  // Compares the sum of the angles opposite to a flippable edge with pi.
  Circle_test circle_test(Size edge)
  {
    const Size s = side(edge);
    const Point& i = position_[s];
    const Point& j = position_[Sides::next(s)];
    const Point& k = position_[Sides::prev(s)];
    const Point l = far_corner(s);
    const Point a = i - l, b = j - l, c = k - l;
    const Real aa = squared_norm(a), bb = squared_norm(b), cc = squared_norm(c);
    const Real determinant = aa * cross(b, c) + bb * cross(c, a) + cc * cross(a, b);
    const Real ki2 = squared_norm(i - k), kj2 = squared_norm(j - k);
    const Real scale2 = ki2 * kj2 * aa * bb;
    if (scale2 == 0)
      throw Coincident_vertices();
    // The determinant over its scale is the sine of the angle by which the sum exceeds pi.
    const Real sine2 = determinant * determinant / scale2;
    if (sine2 > tie_bound2()) {
      if (sine2 < smallest_sine2_)
        smallest_sine2_ = sine2;
      return determinant > 0 ? Circle_test::NOT_DELAUNAY : Circle_test::DELAUNAY;
    }
    if (sine2 > largest_tie_sine2_)
      largest_tie_sine2_ = sine2;
    // The angles sum to 0, to pi or to 2 pi.
    const bool is_k_obtuse = dot(i - k, j - k) < 0, is_l_obtuse = dot(a, b) < 0;
    const Real k_sine2 = square(cross(i - k, j - k)) / (ki2 * kj2);
    if (k_sine2 > tie_bound2())
      return Circle_test::TIE;
    return is_k_obtuse && is_l_obtuse   ? Circle_test::NOT_DELAUNAY
           : is_k_obtuse || is_l_obtuse ? Circle_test::TIE
                                        : Circle_test::DELAUNAY;
  }

  // Replaces an edge by the other diagonal of its quadrilateral.
  void flip(Size edge)
  {
    const Size s = side(edge), t = sides_.twin[s];
    if (t == none || s / 3 == t / 3)
      throw std::logic_error("the edge cannot be flipped");
    const Point i = position_[s], j = position_[Sides::next(s)], k = position_[Sides::prev(s)], l = far_corner(s);
    if (squared_norm(k - l) <= tie_bound2() * (squared_norm(k - i) + squared_norm(l - i)))
      throw Coincident_vertices();
    const Size f = 3 * (s / 3), g = 3 * (t / 3);
    const Size jk = Sides::next(s), ki = Sides::prev(s), il = Sides::next(t), lj = Sides::prev(t);
    const Size vi = sides_.corner[s], vj = sides_.corner[t], vk = sides_.corner[ki], vl = sides_.corner[lj];
    const std::array<Size, 4> old_side{il, ki, lj, jk}, new_side{f, f + 2, g, g + 1};
    std::array<Size, 4> edges, twins;
    for (int n = 0; n < 4; ++n) {
      edges[n] = sides_.edge[old_side[n]];
      twins[n] = sides_.twin[old_side[n]];
      for (int m = 0; m < 4; ++m)
        if (sides_.twin[old_side[n]] == old_side[m])
          twins[n] = new_side[m];
    }
    // (i, l, k) and (l, j, k)
    sides_.corner[f] = vi, sides_.corner[f + 1] = vl, sides_.corner[f + 2] = vk;
    sides_.corner[g] = vl, sides_.corner[g + 1] = vj, sides_.corner[g + 2] = vk;
    position_[f] = i, position_[f + 1] = l, position_[f + 2] = k;
    position_[g] = l, position_[g + 1] = j, position_[g + 2] = k;
    for (int n = 0; n < 4; ++n) {
      sides_.edge[new_side[n]] = edges[n];
      sides_.twin[new_side[n]] = twins[n];
      if (twins[n] != none)
        sides_.twin[twins[n]] = new_side[n];
      side_of_edge_[edges[n]] = new_side[n];
    }
    sides_.edge[f + 1] = sides_.edge[g + 2] = edge;
    sides_.twin[f + 1] = g + 2;
    sides_.twin[g + 2] = f + 1;
    side_of_edge_[edge] = f + 1;
  }

  // Flips until every edge that may be flipped is Delaunay, first in, first out.
  // Returns the number of flips, or none if more than `budget` would be needed.
  Size make_Delaunay(const std::vector<char>& is_constrained = {}, Size budget = 20000000)
  {
    std::deque<Size> queue;
    std::vector<char> is_queued(number_of_edges(), 1);
    for (Size e = 0; e < number_of_edges(); ++e)
      queue.push_back(e);
    Size flips = 0;
    while (!queue.empty()) {
      const Size e = queue.front();
      queue.pop_front();
      is_queued[e] = 0;
      if (!is_flippable(e) || (!is_constrained.empty() && is_constrained[e]) ||
          circle_test(e) != Circle_test::NOT_DELAUNAY)
        continue;
      if (flips == budget)
        return none;
      flip(e);
      ++flips;
      const Size s = side(e), t = sides_.twin[s];
      for (Size around : {Sides::next(s), Sides::prev(s), Sides::next(t), Sides::prev(t)}) {
        const Size next = sides_.edge[around];
        if (!is_queued[next]) {
          is_queued[next] = 1;
          queue.push_back(next);
        }
      }
    }
    return flips;
  }

  // The edges that every Delaunay triangulation of the surface has, sorted.
  std::vector<Measured_edge> unique_edges(const std::vector<char>& is_constrained = {})
  {
    std::vector<Measured_edge> edges;
    for (Size e = 0; e < number_of_edges(); ++e)
      if (!is_flippable(e) || (!is_constrained.empty() && is_constrained[e]) ||
          circle_test(e) == Circle_test::DELAUNAY) {
        const Size s = side(e), a = sides_.corner[s], b = sides_.corner[Sides::next(s)];
        edges.push_back({(std::min)(a, b), (std::max)(a, b), squared_length_of_side(s)});
      }
    std::sort(edges.begin(), edges.end());
    return edges;
  }

  // The largest relative difference of the squared lengths that an edge has in its two faces:
  // what rounding has done so far.
  double inconsistency() const
  {
    Real largest = 0;
    for (Size s = 0; s < sides_.number_of_sides(); ++s)
      if (sides_.twin[s] != none && s < sides_.twin[s]) {
        const Real a = squared_length_of_side(s), b = squared_length_of_side(sides_.twin[s]);
        largest = (std::max)(largest, Real(abs(a - b) / (std::max)(a, b)));
      }
    return log10_of(largest);
  }
  // The decimal logarithm of the smallest sine that was not taken for zero so far.
  double smallest_sine() const { return log10_of(smallest_sine2_) / 2; }
  // The decimal logarithm of the largest sine that was taken for zero so far.
  double largest_tie_sine() const { return log10_of(largest_tie_sine2_) / 2; }

private:
  explicit Reference_triangulation(Sides sides) : sides_(std::move(sides))
  {
    position_.resize(sides_.number_of_sides());
    for (Size s = 0; s < sides_.number_of_sides(); ++s) {
      if (sides_.edge[s] >= side_of_edge_.size())
        side_of_edge_.resize(sides_.edge[s] + 1);
      side_of_edge_[sides_.edge[s]] = s;
    }
  }

  // A sine below 10^-(3/5 of the digits) is zero: 1e-306 with 510 digits.
  static const Real& tie_bound2()
  {
    static const Real bound = pow(Real(10), -int(digits / 5 * 6));
    return bound;
  }
  static double log10_of(const Real& x)
  {
    return x == 0 ? -std::numeric_limits<double>::infinity() : static_cast<double>(log10(x));
  }
  static Real square(const Real& x) { return x * x; }
  static Real cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
  static Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
  static Real squared_norm(const Point& a) { return dot(a, a); }

  // The corner opposite to a side in the face beyond it, in the plane of its own face.
  Point far_corner(Size s) const
  {
    const Size t = sides_.twin[s];
    const Point& j = position_[Sides::next(s)];
    const Point here = position_[s] - j;
    const Point there = position_[Sides::next(t)] - position_[t];
    const Point apex = position_[Sides::prev(t)] - position_[t];
    // apex * here / there in complex numbers
    const Real n = squared_norm(there);
    if (n == 0)
      throw Coincident_vertices();
    const Real rx = dot(there, here) / n, ry = cross(there, here) / n;
    return {j.x + apex.x * rx - apex.y * ry, j.y + apex.x * ry + apex.y * rx};
  }

  Sides sides_;
  std::vector<Point> position_; // of the corner where a side starts
  std::vector<Size> side_of_edge_;
  Real smallest_sine2_ = 1;
  Real largest_tie_sine2_ = 0;
};

} // namespace reference

#endif // IDT_TEST_REFERENCE_TRIANGULATION_H

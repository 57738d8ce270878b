// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lays the faces around a vertex flat, and triangulates the hole.

#include "Fan.h"

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr double pi = 3.14159265358979323846;

// The triangle of two spokes and their link edge.
struct Flat_corner
{
  Flat_corner(double r, double t, double c)
    : s(r * r), t(t * t), c(c * c), cosine(twice_scalar_product(s, this->t, this->c)),
      squared_sine(squared_four_areas_from_lengths(r, t, c)), sine(std::sqrt(squared_sine))
  {}
  double s, t, c; // squared lengths
  double cosine;  // of the angle between the spokes, times twice their lengths
  double squared_sine, sine;
};

double factor_of(const Fan& fan, const Spoke_factors& factors, std::size_t j)
{
  return !fan.is_closed && (j == 0 || j + 1 == fan.size()) ? factors.ends : factors.others;
}

Flat_corner scaled_corner(const Fan& fan, const Spoke_factors& factors, std::size_t j)
{
  const std::size_t k = fan.after(j);
  return {factor_of(fan, factors, j) * fan.spokes[j], factor_of(fan, factors, k) * fan.spokes[k], fan.link[j]};
}

// Newton's method for the logarithm of the factor.
bool find_factors(const Fan& fan, double largest, bool moves_ends, Spoke_factors& factors)
{
  const double wanted = fan.is_closed ? 2 * pi : pi, limit = 2 * std::log(largest);
  double logarithm = std::log(factors.others);
  for (int i = 0; i < 10; ++i) {
    double sum = 0, slope = 0;
    for (std::size_t j = 0; j < fan.link.size(); ++j) {
      const Flat_corner corner = scaled_corner(fan, factors, j);
      if (!(corner.squared_sine > 0))
        return false;
      sum += std::atan2(corner.sine, corner.cosine);
      if (moves_ends || fan.is_closed || j > 0)
        slope += (corner.s - corner.t + corner.c) / corner.sine;
      if (moves_ends || fan.is_closed || j + 1 < fan.link.size())
        slope += (corner.t - corner.s + corner.c) / corner.sine;
    }
    const double missing = sum - wanted;
    if (std::abs(missing) < 1e-15)
      return true;
    const double step = missing / slope;
    logarithm += step;
    if (!(std::abs(logarithm) <= limit))
      return false;
    const double factor = std::exp(logarithm);
    factors.others = factor;
    if (moves_ends)
      factors.ends = factor;
    if (std::abs(step) < 1e-9) // the next one would be its square
      return true;
  }
  return false;
}

} // namespace

bool flatten(const Fan& fan, double largest, Spoke_factors& factors)
{
  factors = {};
  return find_factors(fan, largest, true, factors);
}
bool flatten_between_ends(const Fan& fan, double largest, Spoke_factors& factors)
{
  return fan.size() > 2 && find_factors(fan, largest, false, factors);
}

// The squared factors are the eigenvalues of 1 + M, where M is the change of the metric relative to it. As the side on the
// link keeps its length, M has a closed form without cancellation.
double largest_squared_change(const Fan& fan, const Spoke_factors& factors)
{
  double result = 1;
  for (std::size_t j = 0; j < fan.link.size(); ++j) {
    const std::size_t k = fan.after(j);
    const Flat_corner old(fan.spokes[j], fan.spokes[k], fan.link[j]);
    const double f = factor_of(fan, factors, j), g = factor_of(fan, factors, k);
    const double d = (f - 1) * (f + 1) * old.s, e = (g - 1) * (g + 1) * old.t;
    const double half = ((old.t + old.c - old.s) * d + (old.s + old.c - old.t) * e) / old.squared_sine;
    const double root = std::sqrt(half * half + (d - e) * (d - e) / old.squared_sine);
    const double up = 1 + half + root, down = 1 + half - root;
    if (!(down > 0) || !(up < std::numeric_limits<double>::infinity()))
      return std::numeric_limits<double>::infinity();
    result = (std::max)({result, fan.changes[j].up * up, 1 / (fan.changes[j].down * down)});
  }
  return result;
}

namespace {

struct Laid_out_point
{
  double x = 0, y = 0;
  double squared_length() const { return x * x + y * y; }
};
Laid_out_point operator-(const Laid_out_point& p, const Laid_out_point& q) { return {p.x - q.x, p.y - q.y}; }
double determinant(const Laid_out_point& p, const Laid_out_point& q) { return p.x * q.y - p.y * q.x; }

class Fan_triangulator
{
public:
  Fan_triangulator(const Fan& fan, const Spoke_factors& factors, double line, Fan_triangulation& result)
    : fan_(fan), result_(result), points_(fan.size()), before_(fan.size()), after_(fan.size()),
      side_(fan.link.begin(), fan.link.end())
  {
    side_.resize(fan.size(), line);
    lay_out(factors);
    for (std::size_t j = 0; j < fan.size(); ++j) {
      after_[j] = std::uint32_t(fan.after(j));
      before_[after_[j]] = std::uint32_t(j);
    }
  }

  bool operator()()
  {
    result_.ears.clear();
    std::uint32_t begin = 0; // never cut off in an open fan
    for (std::size_t left = fan_.size(); left > 3; --left) {
      double best = std::numeric_limits<double>::infinity();
      std::uint32_t tip = 0, j = begin;
      for (std::size_t i = 0; i < left; ++i, j = after_[j]) {
        const double value = value_of(j);
        if (value < best) {
          best = value;
          tip = j;
        }
      }
      if (!(best < std::numeric_limits<double>::infinity()))
        return false;
      const std::uint32_t a = before_[tip], b = after_[tip];
      const double across = std::sqrt((points_[a] - points_[b]).squared_length());
      result_.ears.push_back({a, tip, b, side_[a], side_[tip], across});
      after_[a] = b;
      before_[b] = a;
      side_[a] = across;
      begin = a;
      if (!fan_.is_closed)
        begin = 0;
    }
    const std::uint32_t a = begin, tip = after_[a], b = after_[tip];
    if (!is_convex(a, tip, b))
      return false;
    result_.ears.push_back({a, tip, b, side_[a], side_[tip], side_[b]});
    place(points_[a], points_[tip], points_[b]);
    return true;
  }

private:
  void lay_out(const Spoke_factors& factors)
  {
    Laid_out_point direction{1, 0};
    for (std::size_t j = 0; j < fan_.size(); ++j) {
      const double r = factor_of(fan_, factors, j) * fan_.spokes[j];
      points_[j] = {r * direction.x, r * direction.y};
      if (j + 1 == fan_.size())
        break;
      const Flat_corner corner = scaled_corner(fan_, factors, j);
      const double scale = 1 / std::hypot(corner.cosine, corner.sine), c = corner.cosine * scale,
                   s = corner.sine * scale;
      direction = {direction.x * c - direction.y * s, direction.x * s + direction.y * c};
    }
  }

  bool is_convex(std::uint32_t a, std::uint32_t tip, std::uint32_t b) const
  {
    const Laid_out_point u = points_[tip] - points_[a], w = points_[b] - points_[tip];
    const double d = determinant(u, w);
    return d > 0 && d * d > 1e-18 * u.squared_length() * w.squared_length();
  }

  // Smallest for the triangle that is Delaunay without the vertex, which lies at the origin: O. Devillers, "On deletion
  // in Delaunay triangulations" (1999). Infinite if the point is no ear, or the vertex would be behind it.
  double value_of(std::uint32_t tip) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (!fan_.is_closed && (tip == 0 || tip + 1 == fan_.size()))
      return none;
    const std::uint32_t a = before_[tip], b = after_[tip];
    const Laid_out_point &p = points_[a], &q = points_[tip], &r = points_[b];
    const double pp = p.squared_length(), qq = q.squared_length(), rr = r.squared_length();
    if (!is_convex(a, tip, b) || !(determinant(p, r) >= -1e-13 * std::sqrt(pp * rr)))
      return none;
    const double in_circle = pp * determinant(q, r) - qq * determinant(p, r) + rr * determinant(p, q);
    return in_circle / determinant(q - p, r - q);
  }

  void place(const Laid_out_point& p, const Laid_out_point& q, const Laid_out_point& r)
  {
    std::array<double, 3>& b = result_.place;
    if (fan_.is_closed)
      b = {determinant(q, r), determinant(r, p), determinant(p, q)};
    else
      b = {fan_.spokes.back(), 0, fan_.spokes.front()}; // the same point from both sides of a line
    for (double& x : b)
      x = (std::max)(x, 0.);
    const double sum = b[0] + b[1] + b[2];
    for (double& x : b)
      x /= sum;
  }

  const Fan& fan_;
  Fan_triangulation& result_;
  Fan_array<Laid_out_point> points_;
  Fan_array<std::uint32_t> before_, after_; // of the remaining points
  Fan_array<double> side_;                  // to the next remaining point
};

} // namespace

bool triangulate(const Fan& fan, const Spoke_factors& factors, double line, Fan_triangulation& result)
{
  return fan.size() >= 3 && Fan_triangulator(fan, factors, line, result)();
}

} // namespace CGAL::Intrinsic_triangulations::internal

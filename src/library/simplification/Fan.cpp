// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lays the faces around a vertex flat, and triangulates the hole.

#include "Fan.h"
#include "flat_layout.h"

#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The triangle of two spokes and their link edge.
struct Flat_corner
{
  Flat_corner(double r, double t, double c)
    : s(r * r), t(t * t), c(c * c), scale(2 * r * t), cosine(twice_scalar_product(s, this->t, this->c)),
      squared_sine(squared_four_areas_from_lengths(r, t, c)), sine(std::sqrt(squared_sine))
  {}
  double s, t, c; // squared lengths
  double scale;   // twice the lengths of the spokes
  double cosine;  // of the angle between the spokes, times the scale
  double squared_sine, sine;
};

// Sums angles below π.
class Angle_sum_in_plane
{
public:
  void add(const Flat_corner& corner)
  {
    const double c = corner.cosine / corner.scale, s = corner.sine / corner.scale, x = x_ * c - y_ * s,
                 y = x_ * s + y_ * c;
    const bool is_past = y < 0 || (y == 0 && x < 0);
    x_ = is_past ? -x : x;
    y_ = is_past ? -y : y;
    half_turns_ += is_past;
  }
  double operator()() const { return half_turns_ * CGAL_PI + std::atan2(y_, x_); }

private:
  double x_ = 1, y_ = 0; // of a unit vector in the upper half plane
  int half_turns_ = 0;
};

Flat_corner corner(const Fan& fan, std::size_t j) { return {fan.spokes[j], fan.spokes[fan.after(j)], fan.link[j]}; }
Flat_corner corner(const Fan& fan, const Fan_array<double>& factors, std::size_t j)
{
  const std::size_t k = fan.after(j);
  return {factors[j] * fan.spokes[j], factors[k] * fan.spokes[k], fan.link[j]};
}

// Newton's method for the t for which the fan is flat when each spoke is lengthened by the factor 1 + t w, with its
// direction w.
bool flatten_along(const Fan& fan, const Fan_array<double>& w, double largest, Fan_array<double>& factors)
{
  const Fan_array<double> first = factors;
  double t = 0;
  for (int i = 0; i < 10; ++i) {
    Angle_sum_in_plane sum;
    double slope = 0;
    for (std::size_t j = 0; j < fan.link.size(); ++j) {
      const std::size_t k = fan.after(j);
      const Flat_corner c = corner(fan, factors, j);
      if (!(c.squared_sine > 0))
        return false;
      sum.add(c);
      slope +=
        (w[j] * first[j] / factors[j] * (c.s - c.t + c.c) + w[k] * first[k] / factors[k] * (c.t - c.s + c.c)) / c.sine;
    }
    const double missing = sum() - (fan.is_closed ? 2 * CGAL_PI : CGAL_PI);
    if (std::abs(missing) < 1e-15)
      return true;
    const double step = missing / slope;
    t += step;
    for (std::size_t j = 0; j < fan.size(); ++j) {
      factors[j] = first[j] * (1 + t * w[j]);
      if (!(factors[j] <= largest * largest && factors[j] * largest * largest >= 1))
        return false;
    }
    if (std::abs(step) < 1e-5) // the next step would be its square
      return true;
  }
  return false;
}

// The directions that strain the faces least. With w for the logarithms of the spokes, the squared eigenvalues of M,
// summed over the faces with a weight for each, are a quadratic form A, and g·w is the change of the angle at the
// vertex. So A w = g; a step toward that from equal directions comes close enough. A face has a larger weight if less
// of the change that it may have is left.
Fan_array<double> gentle_directions(const Fan& fan, double largest)
{
  const std::size_t n = fan.size();
  Fan_array<double> diagonal(n, 0.), beside(n), g(n, 0.); // of A: the second between a spoke and the next one
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t k = fan.after(j);
    const Flat_corner c = corner(fan, j);
    const double used = ((std::max)(fan.changes[j].up, 1 / fan.changes[j].down) - 1) / (largest * largest - 1),
                 left = (std::max)(1 - used, 0.02), weight = 1 / (left * left);
    // Half the sum of the eigenvalues is a w + b w', and the root that is added p w - q w'.
    const double a = c.s * (c.t + c.c - c.s) / c.squared_sine, b = c.t * (c.s + c.c - c.t) / c.squared_sine,
                 p = c.s / c.sine, q = c.t / c.sine;
    diagonal[j] += weight * (2 * a * a + p * p);
    diagonal[k] += weight * (2 * b * b + q * q);
    beside[j] = weight * (2 * a * b - p * q);
    g[j] += (c.s - c.t + c.c) / c.sine;
    g[k] += (c.t - c.s + c.c) / c.sine;
  }
  const auto times_A = [&](const Fan_array<double>& w) {
    Fan_array<double> result(n, 0.);
    for (std::size_t j = 0; j < n; ++j) {
      const std::size_t k = fan.after(j);
      result[j] += diagonal[j] * w[j] + beside[j] * w[k];
      result[k] += beside[j] * w[j];
    }
    return result;
  };
  const auto product = [](const Fan_array<double>& v, const Fan_array<double>& w) {
    return std::inner_product(v.begin(), v.end(), w.begin(), 0.);
  };
  Fan_array<double> w(n, 1.), rest = g, step(n);
  const Fan_array<double> image = times_A(w);
  const double scale = product(g, w) / product(w, image);
  for (std::size_t j = 0; j < n; ++j) {
    rest[j] -= scale * image[j];
    step[j] = rest[j] / diagonal[j];
  }
  const double energy = product(step, times_A(step)), length = energy > 0 ? product(rest, step) / energy : 0;
  double most = 0;
  for (std::size_t j = 0; j < n; ++j) {
    w[j] = scale + length * step[j];
    most = (std::max)(most, std::abs(w[j]));
  }
  for (double& x : w)
    x /= most;
  return w;
}

} // namespace

bool flatten(const Fan& fan, double largest, Fan_array<double>& factors)
{
  factors.assign(fan.size(), 1.);
  return flatten_along(fan, fan.is_closed ? gentle_directions(fan, largest) : factors, largest, factors);
}

bool flatten_between_ends(const Fan& fan, double ends, double largest, Fan_array<double>& factors)
{
  Fan_array<double> w(fan.size(), 1.);
  w.front() = w.back() = 0;
  factors.front() = factors.back() = ends;
  return fan.size() > 2 && flatten_along(fan, w, largest, factors);
}

double largest_squared_change(const Fan& fan, const Fan_array<double>& factors)
{
  double result = 1;
  for (std::size_t j = 0; j < fan.link.size(); ++j) {
    const std::size_t k = fan.after(j);
    const Flat_corner old = corner(fan, j);
    const double f = factors[j], g = factors[k];
    const double d = (f - 1) * (f + 1) * old.s, e = (g - 1) * (g + 1) * old.t;
    const auto [down, up] = squared_factors(old.s, old.t, old.c, old.squared_sine, d, e);
    if (!(down > 0) || !(up < std::numeric_limits<double>::infinity()))
      return std::numeric_limits<double>::infinity();
    result = (std::max)({result, fan.changes[j].up * up, 1 / (fan.changes[j].down * down)});
  }
  return result;
}

namespace {

using Laid_out_point = Planar_vector<double>;

class Fan_triangulator
{
public:
  Fan_triangulator(const Fan& fan, const Fan_array<double>& factors, double line, Fan_triangulation& result)
    : fan_(fan), result_(result), points_(fan.size(), Laid_out_point(0, 0)), before_(fan.size()), after_(fan.size()),
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
      const double across = std::sqrt(squared_norm(points_[a] - points_[b]));
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
  void lay_out(const Fan_array<double>& factors)
  {
    Laid_out_point direction{1, 0};
    for (std::size_t j = 0; j < fan_.size(); ++j) {
      const double r = factors[j] * fan_.spokes[j];
      points_[j] = {r * direction.x(), r * direction.y()};
      if (j + 1 == fan_.size())
        break;
      const Flat_corner flat = corner(fan_, factors, j);
      const double c = flat.cosine / flat.scale, s = flat.sine / flat.scale;
      direction = direction * Laid_out_point(c, s);
    }
  }

  bool is_convex(std::uint32_t a, std::uint32_t tip, std::uint32_t b) const
  {
    const Laid_out_point u = points_[tip] - points_[a], w = points_[b] - points_[tip];
    const double d = determinant(u, w);
    return d > 0 && d * d > 1e-18 * squared_norm(u) * squared_norm(w);
  }

  // Smallest for the triangle that is Delaunay without the vertex, which lies at the origin: O. Devillers, "On deletion
  // in Delaunay triangulations" (1999). Infinite if the point is not an ear, or the vertex would lie behind it.
  double value_of(std::uint32_t tip) const
  {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (!fan_.is_closed && (tip == 0 || tip + 1 == fan_.size()))
      return none;
    const std::uint32_t a = before_[tip], b = after_[tip];
    const Laid_out_point &p = points_[a], &q = points_[tip], &r = points_[b];
    const double pp = squared_norm(p), qq = squared_norm(q), rr = squared_norm(r);
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

bool triangulate(const Fan& fan, const Fan_array<double>& factors, double line, Fan_triangulation& result)
{
  return fan.size() >= 3 && Fan_triangulator(fan, factors, line, result)();
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Heat after a short time, including regions where it is below the range of double.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H

#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Heat in layers: each layer is, far from where it was passed on, a large multiple of the previous one.
struct Layered_heat
{
  std::vector<Eigen::VectorXd> layers;
  std::vector<int> exponents;            // for each layer, the exponent of 2 in that multiple, from the first layer on
  std::vector<std::uint32_t> layer_of;   // for each row, the first layer in which it is not lost
  std::vector<std::vector<bool>> behind; // for each layer that was passed on, the rows from which it was

  double operator[](std::size_t row) const { return layers[layer_of[row]][Eigen::Index(row)]; }

  // The exponent of 2 by which a layer was multiplied when it was passed on.
  int factor(std::size_t layer) const { return exponents[layer + 1] - exponents[layer]; }

  // The mean of this heat and a smaller one with the same sources.
  void average_with(const Layered_heat& less)
  {
    for (std::size_t l = 0; l < layers.size(); ++l)
      for (std::size_t v = 0; v < layer_of.size(); ++v) {
        double& u = layers[l][Eigen::Index(v)];
        const std::uint32_t k = less.layer_of[v];
        u = (u + std::ldexp(less.layers[k][Eigen::Index(v)], exponents[l] - less.exponents[k])) / 2;
      }
  }
};

// The flow from the rows behind a front to the others, times a power of two.
// \tparam Vector of numbers, or several of them as columns
template <class Matrix, class Vector>
Vector sent_on(const Matrix& matrix, const Vector& u, const std::vector<bool>& is_behind, int exponent)
{
  const double one_part = std::ldexp(1., exponent / 2), other_part = std::ldexp(1., exponent - exponent / 2);
  Vector result = Vector::Zero(u.rows(), u.cols());
  for (Eigen::Index c = 0; c < matrix.outerSize(); ++c)
    if (is_behind[std::size_t(c)])
      for (typename Matrix::InnerIterator i(matrix, c); i; ++i)
        if (!is_behind[std::size_t(i.row())])
          result.row(i.row()) -= i.value() * (u.row(c) * one_part * other_part);
  return result;
}

// The layers of another heat, which is passed on where `heat` is, so that both can be compared at each row.
// \param solve solves the system
// \param first the heat put at each row
// \param also adds further terms to the right side of a layer, given its number
template <class Heat, class Matrix, class Solve, class Also>
std::vector<Heat> spread_likewise(const Heat& first, const Layered_heat& heat, const Matrix& matrix, const Solve& solve,
                                  const Also& also)
{
  Heat right = first;
  also(right, std::size_t(0));
  std::vector<Heat> layers{solve(right)};
  for (std::size_t l = 0; l + 1 < heat.layers.size(); ++l) {
    right = sent_on(matrix, layers.back(), heat.behind[l], heat.factor(l));
    also(right, l + 1);
    layers.push_back(solve(right));
  }
  return layers;
}

// The heat at the corners of a face.
inline std::array<double, 3> heat_of_face(const Layered_heat& heat, const Heat_face& face)
{
  const auto& row = face.row;
  const Eigen::VectorXd& u =
    heat.layers[(std::max)({heat.layer_of[row[0]], heat.layer_of[row[1]], heat.layer_of[row[2]]})];
  return {u[row[0]], u[row[1]], u[row[2]]};
}

// For each row the integral of X · ∇(hat function), for X = -∇u/|∇u|. Nothing flows in a face in which u is constant.
// \param instead the heat used in faces without any other, such as those with all corners on a cold border
inline Eigen::VectorXd flux_of_unit_gradient(const Heat_surface& surface, const Layered_heat& heat,
                                             const Layered_heat& instead)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(Eigen::Index(surface.size()));
  for (const Heat_face& face : surface.faces) {
    std::array<double, 3> u = heat_of_face(heat, face);
    if (u[0] == 0 && u[1] == 0 && u[2] == 0)
      u = heat_of_face(instead, face);
    std::array<double, 2> v = face.slope(u);
    double norm = std::sqrt(v[0] * v[0] + v[1] * v[1]);
    if (!(norm > 0x1p-450 && norm < 0x1p450)) { // the squares are out of range, or there is no heat
      const double largest = (std::max)({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
      v = face.slope({u[0] / largest, u[1] / largest, u[2] / largest});
      norm = std::hypot(v[0], v[1]);
    }
    if (!(norm > 0))
      continue;
    const double x = -v[0] / norm, y = -v[1] / norm, to_second = face.share * (x * face.height - y * face.x) / 2,
                 to_third = face.share * y * face.base / 2;
    sums[face.row[0]] -= to_second + to_third;
    sums[face.row[1]] += to_second;
    sums[face.row[2]] += to_third;
  }
  return sums;
}

// M + L for a matrix L. A vertex without faces keeps its heat.
template <class Matrix>
Matrix with_masses(Matrix matrix, const Heat_surface& surface)
{
  for (Eigen::Index v = 0; v < matrix.rows(); ++v)
    matrix.coeffRef(v, v) += surface.mass[v] > 0 ? surface.mass[v] : 1;
  return matrix;
}

// Heat after a short time t: (M + t L) u = 0 except at its sources. It decreases by a constant factor at each edge, so
// after some 700 edges it vanishes in double. It is then passed on from where it is still positive.
// \tparam Solver as Sparse_Cholesky
template <class Solver>
class Heat_diffusion
{
  using Vector = Eigen::VectorXd;

  // Relative to the largest heat. Heat that was passed on has far to go until it is examined again.
  static constexpr double sent = 0x1p-600, lost = 0x1p-900;

public:
  // \param cold the rows that have no heat unless they are sources
  // \param interruption as for Pinned_system
  Heat_diffusion(const Heat_surface& surface, double time, const Interruption& interruption,
                 std::vector<bool> cold = {})
    : system_(with_masses<Eigen::SparseMatrix<double>>(time * surface.stiffness, surface), std::move(cold),
              "the matrix of the heat", interruption)
  {}

  // \param sources the heat of these rows
  // \param is_reachable the rows that heat can reach
  Layered_heat spread(const Pins& sources, const std::vector<bool>& is_reachable)
  {
    return send_on(system_.solve(Vector::Zero(system_.matrix().rows()), sources), is_reachable);
  }

  // \param heat the heat put at each row; nothing is cold
  Layered_heat spread(const Vector& heat, const std::vector<bool>& is_reachable) const
  {
    return send_on(system_.solve(heat), is_reachable);
  }

  // Another heat that is passed on where the first one is; nothing is cold. Several columns are spread at once.
  // \param also as for the function of that name
  template <class Heat, class Also>
  std::vector<Heat> spread_likewise(const Heat& heat, const Layered_heat& other, const Also& also) const
  {
    return internal::spread_likewise(
      heat, other, system_.matrix(), [this](const Heat& b) { return system_.solve(b); }, also);
  }

  // Other heat divided by the first, at each row; 0 where there is none.
  std::vector<double> quotients(const Layered_heat& heat, const Vector& other) const
  {
    const std::vector<Vector> layers = spread_likewise(other, heat, [](Vector&, std::size_t) {});
    std::vector<double> result(heat.layer_of.size(), 0);
    for (std::size_t row = 0; row < result.size(); ++row)
      if (heat[row] != 0)
        result[row] = layers[heat.layer_of[row]][Eigen::Index(row)] / heat[row];
    return result;
  }

  // Values at some rows, and elsewhere about the value of the nearest one; 0 where no heat arrives.
  std::vector<double> extend(const std::vector<std::pair<std::uint32_t, double>>& values,
                             const std::vector<bool>& is_reachable) const
  {
    Vector weighted = Vector::Zero(system_.matrix().rows()), heat = weighted;
    for (const auto& [row, value] : values) {
      heat[row] += 1;
      weighted[row] += value;
    }
    return quotients(spread(heat, is_reachable), weighted);
  }

  std::size_t number_of_factorizations() const { return system_.number_of_factorizations(); }

private:
  Layered_heat send_on(Vector first, const std::vector<bool>& is_reachable) const
  {
    const std::size_t n = is_reachable.size();
    Layered_heat result{{std::move(first)}, {0}, std::vector<std::uint32_t>(n, 0), {}};
    std::vector<bool> is_lost = is_reachable, is_ahead = is_reachable;
    for (std::size_t number_of_lost = n;;) {
      const Vector& u = result.layers.back();
      const double largest = largest_of(u, is_ahead);
      const auto stays_lost = [&](std::size_t v) {
        return std::abs(u[Eigen::Index(v)]) < lost * largest && is_lost[v] && !system_.is_cold(v);
      };
      std::size_t still_lost = 0;
      for (std::size_t v = 0; v < n; ++v)
        still_lost += stays_lost(v);
      if (still_lost == 0 || still_lost == number_of_lost || largest == 0)
        return result;
      number_of_lost = still_lost;
      std::vector<bool> is_behind(n); // whether heat is passed on from there
      for (std::size_t v = 0; v < n; ++v) {
        is_behind[v] = !is_lost[v] || std::abs(u[Eigen::Index(v)]) >= sent * largest;
        is_ahead[v] = !is_behind[v];
        is_lost[v] = stays_lost(v);
      }
      const int exponent = -std::ilogb(largest) - std::ilogb(sent);
      Vector front = sent_on(system_.matrix(), u, is_behind, exponent);
      for (std::size_t v = 0; v < n; ++v)
        if (system_.is_cold(v))
          front[Eigen::Index(v)] = 0;
      result.exponents.push_back(result.exponents.back() + exponent);
      result.behind.push_back(std::move(is_behind));
      result.layers.push_back(system_.solve(front));
      for (std::size_t v = 0; v < n; ++v)
        if (is_lost[v])
          result.layer_of[v] = std::uint32_t(result.layers.size() - 1);
    }
  }

  static double largest_of(const Vector& u, const std::vector<bool>& where)
  {
    double result = 0;
    for (Eigen::Index v = 0; v < u.size(); ++v)
      if (std::abs(u[v]) > result && where[std::size_t(v)])
        result = std::abs(u[v]);
    return result;
  }

  Pinned_system<Solver> system_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H

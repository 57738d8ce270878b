// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How heat spreads in a short time, also to where it is below the range of double.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H

#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

// Heat, layer by layer: each is, far from where it was sent on, a large multiple of the one before.
struct Layered_heat
{
  std::vector<Eigen::VectorXd> layers;
  std::vector<int> exponents;            // for each layer, the exponent of 2 in that multiple, from the first layer on
  std::vector<std::uint32_t> layer_of;   // for each row, the first layer in which it is not lost
  std::vector<std::vector<bool>> behind; // for each layer that was sent on, the rows where it was sent on from

  double operator[](std::size_t row) const { return layers[layer_of[row]][Eigen::Index(row)]; }

  // The mean of this and less heat with the same sources.
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

// What flows from the rows behind a front to the others, times a power of two.
inline Eigen::VectorXd sent_on(const Eigen::SparseMatrix<double>& matrix, const Eigen::VectorXd& u, const std::vector<bool>& is_behind,
                               int exponent)
{
  const double one_part = std::ldexp(1., exponent / 2), other_part = std::ldexp(1., exponent - exponent / 2);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(u.size());
  for (Eigen::Index c = 0; c < matrix.outerSize(); ++c)
    if (is_behind[std::size_t(c)])
      for (Eigen::SparseMatrix<double>::InnerIterator i(matrix, c); i; ++i)
        if (!is_behind[std::size_t(i.row())])
          result[i.row()] -= i.value() * (u[c] * one_part * other_part);
  return result;
}

inline Eigen::SparseMatrix<double> heat_matrix(const Heat_surface& surface, double time)
{
  Eigen::SparseMatrix<double> result = time * surface.stiffness;
  for (Eigen::Index v = 0; v < result.rows(); ++v) // a vertex without faces keeps its heat
    result.coeffRef(v, v) += surface.mass[v] > 0 ? surface.mass[v] : 1;
  return result;
}

// Heat after a short time t: (M + t L) u = 0 except at its sources. At each edge it decreases by a constant factor, so that after some
// 700 edges nothing is left of it in double. Then it is sent on from where it still is.
// \tparam Solver as Sparse_Cholesky
template <class Solver>
class Heat_diffusion
{
  using Vector = Eigen::VectorXd;

  // Relative to the largest heat. What is sent on has far to go until it is looked at again.
  static constexpr double sent = 0x1p-600, lost = 0x1p-900;

public:
  // \param cold the rows that have no heat unless they are sources
  Heat_diffusion(const Heat_surface& surface, double time, std::vector<bool> cold = {})
    : system_(heat_matrix(surface, time), std::move(cold), "the matrix of the heat")
  {}

  // \param sources the heat that these rows have
  // \param is_reachable the rows where heat can come
  Layered_heat spread(const Pins& sources, const std::vector<bool>& is_reachable)
  {
    return send_on(system_.solve(Vector::Zero(system_.matrix().rows()), sources), is_reachable);
  }

  // \param heat what is put at each row; nothing is cold
  Layered_heat spread(const Vector& heat, const std::vector<bool>& is_reachable) const
  {
    return send_on(system_.solve(heat), is_reachable);
  }

  // Other heat, to be divided by the first at each row; nothing is cold.
  std::vector<Vector> spread_likewise(const Vector& heat, const Layered_heat& other) const
  {
    std::vector<Vector> layers{system_.solve(heat)};
    for (std::size_t l = 0; l + 1 < other.layers.size(); ++l)
      layers.push_back(system_.solve(
        sent_on(system_.matrix(), layers.back(), other.behind[l], other.exponents[l + 1] - other.exponents[l])));
    return layers;
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
      std::vector<bool> is_behind(n); // whether heat is sent on from there
      std::size_t still_lost = 0;
      for (std::size_t v = 0; v < n; ++v) {
        const double x = std::abs(u[Eigen::Index(v)]);
        is_behind[v] = !is_lost[v] || x >= sent * largest;
        is_ahead[v] = !is_behind[v];
        is_lost[v] = is_lost[v] && x < lost * largest && !system_.is_cold(v);
        still_lost += is_lost[v];
      }
      if (still_lost == 0 || still_lost == number_of_lost || largest == 0)
        return result;
      number_of_lost = still_lost;
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
      if (where[std::size_t(v)])
        result = (std::max)(result, std::abs(u[v]));
    return result;
  }

  Pinned_system<Solver> system_;
};

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_HEAT_DIFFUSION_H

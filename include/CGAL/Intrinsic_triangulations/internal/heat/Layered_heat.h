// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Heat in layers, so that it can decrease below the range of double.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAYERED_HEAT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAYERED_HEAT_H

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <cstdint>
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

  // The exponent of 2 by which a layer was multiplied when it was sent on.
  int factor(std::size_t layer) const { return exponents[layer + 1] - exponents[layer]; }

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

// The layers of other heat, which is sent on where `heat` is, so that both can be compared at each row.
// \param solve solves the system
// \param first what is put at each row
// \param also adds to the right side of a layer what else it depends on, from its number
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

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_LAYERED_HEAT_H

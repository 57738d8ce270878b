// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Linear systems whose solution has given values at a few rows, which may change.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PINNED_SYSTEM_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PINNED_SYSTEM_H

#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Values by rows.
using Pins = std::map<std::uint32_t, double>;

// The argument, after the interruption was asked.
template <class T>
const T& after(const Interruption& interruption, const T& argument)
{
  interruption.check();
  return argument;
}

// Solves A x = b where x has given values at the pins, and A x is free there. One factorization of A serves all small
// sets of pins: a small dense system gives the forces at them. Its matrix has one column for each pin that was ever
// used, and is kept.
// \tparam Solver as Sparse_Cholesky
template <class Solver>
class Pinned_system
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Vector = Eigen::VectorXd;

public:
  // From this number of pins on, a factorization is cheaper.
  static constexpr std::size_t largest_dense_size = 32;

  // \param cold the rows at which x is zero unless they are pins; may be empty
  // \param interruption is asked before each factorization and solution; must outlive this
  Pinned_system(Matrix matrix, std::vector<bool> cold, const char* what, const Interruption& interruption)
    : matrix_(std::move(matrix)), cold_(std::move(cold)), what_(what), interruption_(interruption),
      solver_(after(interruption_, with_identity_at({})), what)
  {}

  // For a matrix whose kernel consists of the functions that are constant on each part, which are free.
  // \param part_of for each row the smallest row of its part
  Pinned_system(Matrix matrix, const std::vector<std::uint32_t>& part_of, const char* what,
                const Interruption& interruption)
    : matrix_(std::move(matrix)), part_of_(part_of), what_(what), interruption_(interruption),
      solver_(after(interruption_, anchored()), what)
  {}

  const Matrix& matrix() const { return matrix_; }
  bool is_cold(std::size_t row) const { return !cold_.empty() && cold_[row]; }

  // Without pins. With a kernel, b has to sum to zero over each part, and the solution lacks a constant. Each column is
  // a system.
  template <class Columns>
  Columns solve(const Columns& b) const
  {
    return solver_.solve(after(interruption_, b));
  }

  // Meaningless in parts without pins.
  Vector solve(const Vector& b, const Pins& pins)
  {
    Pins free_pins;
    for (const auto& pin : pins)
      if (!is_cold(pin.first))
        free_pins.insert(pin);
    if (free_pins.size() > largest_dense_size && parts_of(free_pins).size() < free_pins.size())
      return solve_by_factorization(b, pins);
    if (free_pins.size() == pins.size())
      return solve_by_forces(b, free_pins);
    Vector values = Vector::Zero(b.size());
    for (const auto& [row, value] : pins)
      if (is_cold(row))
        values[row] = value;
    return solve_by_forces(with_values(b - matrix_ * values, values, [this](std::size_t row) { return is_cold(row); }),
                           free_pins);
  }

  std::size_t number_of_factorizations() const { return number_of_factorizations_; }

private:
  std::set<std::uint32_t> parts_of(const Pins& pins) const
  {
    std::set<std::uint32_t> result;
    if (!part_of_.empty())
      for (const auto& pin : pins)
        result.insert(part_of_[pin.first]);
    return result;
  }

  template <class Is_given>
  static Vector with_values(Vector right, const Vector& values, const Is_given& is_given)
  {
    for (Eigen::Index v = 0; v < right.size(); ++v)
      if (is_given(std::size_t(v)))
        right[v] = values[v];
    return right;
  }

  // The pattern remains, so that a factorization can be repeated for other rows.
  Matrix with_identity_at(const std::vector<bool>& pinned) const
  {
    const auto is_given = [&](Eigen::Index row) {
      return is_cold(std::size_t(row)) || (!pinned.empty() && pinned[std::size_t(row)]);
    };
    Matrix result = matrix_;
    for (Eigen::Index c = 0; c < result.outerSize(); ++c)
      for (Matrix::InnerIterator i(result, c); i; ++i)
        if (is_given(i.row()) || is_given(c))
          i.valueRef() = i.row() == c ? 1 : 0;
    return result;
  }

  // With 1 added to one diagonal entry of each part, the matrix is positive definite, and the solution is zero there.
  Matrix anchored() const
  {
    Matrix result = matrix_;
    for (Eigen::Index v = 0; v < result.rows(); ++v)
      if (part_of_[std::size_t(v)] == v)
        result.coeffRef(v, v) += 1;
    return result;
  }

  Vector solve_by_forces(const Vector& b, const Pins& pins)
  {
    Vector x = solve(b);
    const std::set<std::uint32_t> parts = parts_of(pins);
    std::map<std::uint32_t, double> shift;
    if (parts.size() == pins.size()) { // one in each part: no force is needed
      for (const auto& [row, value] : pins)
        shift[part_of_[row]] = value - x[row];
    } else {
      Vector forces = Vector::Zero(b.size());
      find_forces(x, pins, parts, forces, shift);
      x += solve(forces);
    }
    if (!shift.empty())
      for (std::size_t v = 0; v < part_of_.size(); ++v) {
        const auto found = shift.find(part_of_[v]);
        if (found != shift.end())
          x[Eigen::Index(v)] += found->second;
      }
    return x;
  }

  // In each part of a kernel the forces sum to zero, and a constant is free, which adds as many equations and unknowns.
  void find_forces(const Vector& x, const Pins& pins, const std::set<std::uint32_t>& parts, Vector& forces,
                   std::map<std::uint32_t, double>& shift)
  {
    require_responses(pins);
    const Eigen::Index k = Eigen::Index(pins.size()), m = Eigen::Index(parts.size());
    std::map<std::uint32_t, Eigen::Index> number_of_part;
    for (std::uint32_t part : parts)
      number_of_part.emplace(part, k + Eigen::Index(number_of_part.size()));
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(k + m, k + m);
    Vector right = Vector::Zero(k + m);
    Eigen::Index i = 0;
    for (const auto& [row, value] : pins) {
      right[i] = value - x[row];
      Eigen::Index j = 0;
      for (const auto& pin : pins)
        matrix(i, j++) = responses_.at(row).at(pin.first);
      if (m > 0) {
        const Eigen::Index c = number_of_part.at(part_of_[row]);
        matrix(i, c) = matrix(c, i) = 1;
      }
      ++i;
    }
    const Vector solution = matrix.fullPivLu().solve(right);
    i = 0;
    for (const auto& pin : pins)
      forces[pin.first] = solution[i++];
    for (const auto& [part, c] : number_of_part)
      shift[part] = solution[c];
  }

  // The response at each pin to a force at each other pin.
  void require_responses(const Pins& pins)
  {
    if (responses_.size() > 8 * largest_dense_size)
      responses_.clear();
    for (const auto& pin : pins) {
      if (responses_.count(pin.first))
        continue;
      Vector force = Vector::Zero(matrix_.rows());
      force[pin.first] = 1;
      const Vector response = solve(force);
      auto& own = responses_[pin.first];
      for (auto& [row, others] : responses_)
        own[row] = others[pin.first] = response[row];
    }
  }

  // For many pins: their rows and columns are replaced by those of the identity. Parts without pins keep their anchor.
  Vector solve_by_factorization(const Vector& b, const Pins& pins)
  {
    Vector values = Vector::Zero(b.size());
    std::vector<bool> is_pinned(std::size_t(b.size()));
    for (const auto& [row, value] : pins) {
      values[row] = value;
      is_pinned[row] = true;
    }
    Matrix matrix = with_identity_at(is_pinned);
    const std::set<std::uint32_t> parts = parts_of(pins);
    for (std::size_t v = 0; v < part_of_.size(); ++v)
      if (part_of_[v] == v && !parts.count(std::uint32_t(v)))
        matrix.coeffRef(Eigen::Index(v), Eigen::Index(v)) += 1;
    if (!pinned_solver_)
      pinned_solver_.emplace(after(interruption_, matrix), what_);
    else
      pinned_solver_->factorize(after(interruption_, matrix));
    ++number_of_factorizations_;
    return pinned_solver_->solve(
      with_values(b - matrix_ * values, values, [&](std::size_t row) { return is_cold(row) || is_pinned[row]; }));
  }

  Matrix matrix_;
  std::vector<bool> cold_;
  std::vector<std::uint32_t> part_of_;
  const char* what_;
  const Interruption& interruption_;
  Solver solver_;
  std::optional<Solver> pinned_solver_;
  std::map<std::uint32_t, std::map<std::uint32_t, double>> responses_;
  std::size_t number_of_factorizations_ = 1;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_HEAT_PINNED_SYSTEM_H

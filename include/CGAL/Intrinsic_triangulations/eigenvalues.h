// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Smallest eigenvalues, condition numbers, and histograms of weights.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EIGENVALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EIGENVALUES_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>

#include <CGAL/assertions.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Spectra/MatOp/SparseSymMatProd.h>
#include <Spectra/SymEigsSolver.h>
#include <Spectra/SymGEigsShiftSolver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \addtogroup PkgIntrinsicTriangulationsOperators
/// @{

namespace internal {

constexpr Eigen::Index largest_dense_part = 64; // larger ones are iterated unless most eigenvalues are wanted

// Solves (L + M) x = b, as Spectra requires; the shift is always -1.
class Shifted_inverse
{
public:
  using Scalar = double;

  Shifted_inverse(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass)
    : rows_(stiffness.rows()), cholesky_(stiffness + mass, "the Laplace-Beltrami operator plus the mass matrix")
  {}
  Eigen::Index rows() const { return rows_; }
  Eigen::Index cols() const { return rows_; }
  void set_shift(double) {}
  void perform_op(const double* in, double* out) const
  {
    Eigen::Map<Eigen::VectorXd>(out, rows_) =
      cholesky_.solve<Eigen::VectorXd>(Eigen::Map<const Eigen::VectorXd>(in, rows_));
  }

private:
  Eigen::Index rows_;
  Sparse_Cholesky<> cholesky_;
};

// The rows of a connected part that have mass.
struct Spectrum_part
{
  std::vector<int> rows; // in increasing order
  double mass = 0;
  bool has_constants = true; // they solve the equation with zero: all sums of rows vanish

  // Other than the zero of the constants.
  std::size_t number_of_eigenvalues() const { return rows.size() - (has_constants ? 1 : 0); }
};

struct Eigenpair
{
  double value = 0;
  std::size_t part = 0;
  Eigen::VectorXd function; // on the rows of the part, if requested
};

inline std::vector<Spectrum_part> connected_parts(const Eigen::SparseMatrix<double>& stiffness,
                                                  const Eigen::SparseMatrix<double>& mass)
{
  CGAL_precondition(stiffness.rows() == mass.rows());
  const auto n = std::size_t(stiffness.rows());
  const Eigen::VectorXd masses = mass.diagonal();
  Disjoint_sets sets(n);
  std::vector<bool> has_sum_zero(n);
  for (int c = 0; c < stiffness.outerSize(); ++c) {
    double sum = 0, sum_of_sizes = 0, number = 4; // of roundings of a unit in the last place, at most
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, c); entry; ++entry) {
      if (!std::isfinite(entry.value()))
        throw Numerical_error("the stiffness matrix has an entry that is not finite, in row " + std::to_string(c));
      if (entry.value() != 0)
        sets.unite(std::uint32_t(entry.row()), std::uint32_t(c));
      sum += entry.value();
      sum_of_sizes += std::abs(entry.value());
      ++number;
    }
    has_sum_zero[std::size_t(c)] = std::abs(sum) <= number * 0x1p-52 * sum_of_sizes;
  }
  std::vector<std::size_t> part_of;
  std::vector<Spectrum_part> parts(sets.number(part_of));
  for (std::size_t row = 0; row < n; ++row) {
    Spectrum_part& part = parts[part_of[row]];
    const bool has_mass = masses[Eigen::Index(row)] > 0;
    part.has_constants = part.has_constants && has_mass && has_sum_zero[row];
    if (has_mass)
      part.rows.push_back(int(row));
  }
  for (int c = 0; c < mass.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator entry(mass, c); entry; ++entry)
      parts[part_of[std::size_t(c)]].mass += entry.value();
  return parts;
}

// The k smallest eigenvalues of a part beside the zero that is known.
// \param row_in_part of all rows; -1 before and after the call
inline std::vector<Eigenpair> eigenpairs_of_part(const Eigen::SparseMatrix<double>& stiffness,
                                                 const Eigen::SparseMatrix<double>& mass, const Spectrum_part& part,
                                                 Eigen::Index k, bool has_functions, std::vector<int>& row_in_part)
{
  const auto n = Eigen::Index(part.rows.size()), known = Eigen::Index(part.has_constants);
  // By Weyl's law the j-th eigenvalue of a surface of area 4π is about j.
  const double unit = 4 * 3.14159265358979 / part.mass;
  for (Eigen::Index i = 0; i < n; ++i)
    row_in_part[std::size_t(part.rows[std::size_t(i)])] = int(i);
  const Eigen::SparseMatrix<double> L = principal_submatrix(stiffness, part.rows, row_in_part),
                                    M = principal_submatrix(mass, part.rows, row_in_part) * unit;
  for (int row : part.rows)
    row_in_part[std::size_t(row)] = -1;
  std::vector<Eigenpair> result;
  const auto keep = [&](const auto& solver, bool is_solved) {
    if (!is_solved)
      throw Numerical_error("the smallest eigenvalues do not converge");
    const Eigen::VectorXd values = solver.eigenvalues() * unit;
    if (!values.allFinite())
      throw Numerical_error("the smallest eigenvalues leave the range of double: scale the surface");
    Eigen::MatrixXd functions;
    if (has_functions)
      functions = solver.eigenvectors() * std::sqrt(unit);
    for (Eigen::Index i = 0; i < values.size(); ++i)
      result.push_back({values[i], 0, has_functions ? Eigen::VectorXd(functions.col(i)) : Eigen::VectorXd()});
    std::sort(result.begin(), result.end(), [](const Eigenpair& a, const Eigenpair& b) { return a.value < b.value; });
    result.erase(result.begin() + known + k, result.end());
    result.erase(result.begin(), result.begin() + known);
  };
  const Eigen::Index number = known + k;
  if (n <= largest_dense_part || 3 * number > n) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      Eigen::MatrixXd(L), Eigen::MatrixXd(M),
      Eigen::Ax_lBx | (has_functions ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly));
    keep(solver, solver.info() == Eigen::Success);
  } else {
    Shifted_inverse inverse(L, M);
    Spectra::SparseSymMatProd<double> product(M);
    Spectra::SymGEigsShiftSolver<Shifted_inverse, Spectra::SparseSymMatProd<double>, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, product, number, (std::min)(n, (std::max)(3 * number, Eigen::Index(40))), -1);
    solver.init();
    solver.compute(Spectra::SortRule::LargestMagn, 1000, 1e-11);
    keep(solver, solver.info() == Spectra::CompInfo::Successful);
  }
  return result;
}

// The known zeros of all parts, and so many others of each part that those left out cannot be among the smallest.
inline std::vector<Eigenpair> smallest_eigenpairs(const Eigen::SparseMatrix<double>& stiffness,
                                                  const Eigen::SparseMatrix<double>& mass, std::size_t number,
                                                  bool has_functions, std::vector<Spectrum_part>& parts)
{
  parts = connected_parts(stiffness, mass);
  std::vector<Eigenpair> result;
  double total_mass = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Spectrum_part& part = parts[p];
    if (part.rows.empty())
      continue;
    if (!(part.mass > 0x1p-1016 && part.mass < 0x1p1016))
      throw Numerical_error("the mass of row " + std::to_string(part.rows.front()) +
                            " and of those connected with it leaves the range of double: scale the surface");
    total_mass += part.mass;
    if (part.has_constants && result.size() < number)
      result.push_back({0, p,
                        has_functions
                          ? Eigen::VectorXd::Constant(Eigen::Index(part.rows.size()), std::sqrt(1 / part.mass))
                          : Eigen::VectorXd()});
  }
  const std::size_t missing = number - result.size();
  std::vector<std::vector<Eigenpair>> found(parts.size());
  std::vector<int> row_in_part(std::size_t(stiffness.rows()), -1);
  double bound = std::numeric_limits<double>::infinity(); // of the wanted ones
  for (bool is_complete = missing == 0; !is_complete;) {
    is_complete = true;
    std::vector<double> values;
    for (std::size_t p = 0; p < parts.size(); ++p) {
      if (parts[p].rows.empty())
        continue;
      const std::size_t most = (std::min)(parts[p].number_of_eigenvalues(), missing), before = found[p].size();
      if (before < most && (before == 0 || found[p].back().value < bound)) {
        is_complete = false;
        const double share = double(missing) * (parts[p].mass / total_mass); // by Weyl's law
        const std::size_t k = parts[p].rows.size() <= std::size_t(largest_dense_part) ? most
                              : before > 0                                            ? 2 * before
                                                                                      : 2 + std::size_t(1.2 * share);
        found[p] =
          eigenpairs_of_part(stiffness, mass, parts[p], Eigen::Index((std::min)(k, most)), has_functions, row_in_part);
      }
      for (Eigenpair& pair : found[p]) {
        pair.part = p;
        values.push_back(pair.value);
      }
    }
    if (values.size() >= missing) {
      const auto last = values.begin() + std::ptrdiff_t(missing - 1);
      std::nth_element(values.begin(), last, values.end());
      bound = *last;
    }
  }
  for (std::vector<Eigenpair>& pairs : found)
    std::move(pairs.begin(), pairs.end(), std::back_inserter(result));
  std::stable_sort(result.begin(), result.end(),
                   [](const Eigenpair& a, const Eigenpair& b) { return a.value < b.value; });
  if (result.size() > number)
    result.erase(result.begin() + std::ptrdiff_t(number), result.end());
  return result;
}

} // namespace internal

/// \brief returns the smallest solutions λ of `L u = λ M u`, in increasing order.
///
/// Rows without mass, which belong to vertices without faces, are left out. Zero appears once for each connected
/// component whose rows sum to zero; these zeros are exact. The rest is found on each component by itself, as far as it
/// can be among the smallest.
///
/// Method: Lanczos (Spectra) for the inverse of `L + c M`, with one sparse Cholesky factorization; small components
/// with dense matrices. The error of an eigenvalue is about 1e-10 times the sum of itself and the first positive one.
///
/// \param stiffness a positive semidefinite matrix, for instance from `stiffness_matrix()` or `tufted_Laplacian()`
/// \param mass the mass matrix, lumped or Galerkin
/// \param number how many to compute; at most as many as there are rows with mass
/// \pre both matrices have the same size
/// \exception Numerical_error if the iteration does not converge, if the matrix is not positive definite after
///   rounding, if an entry is not finite, or if the masses or eigenvalues leave the range of `double`
inline std::vector<double> smallest_eigenvalues(const Eigen::SparseMatrix<double>& stiffness,
                                                const Eigen::SparseMatrix<double>& mass, std::size_t number)
{
  std::vector<double> result;
  std::vector<internal::Spectrum_part> parts;
  for (const internal::Eigenpair& pair : internal::smallest_eigenpairs(stiffness, mass, number, false, parts))
    result.push_back(pair.value);
  return result;
}

/// \brief the smallest eigenvalues with their eigenfunctions.
struct Eigenfunctions
{
  std::vector<double> eigenvalues; ///< in increasing order
  /// a column u for each: the values at the vertices, zero on other components; `uᵀ M u` is 1, and the entry with the
  /// largest absolute value is positive
  Eigen::MatrixXd functions;
};

/// \brief returns the smallest eigenvalues as `smallest_eigenvalues()`, and a solution u for each of them.
///
/// The functions of one eigenvalue are orthogonal: `uᵀ M v = 0`.
/// \param stiffness, mass, number as for `smallest_eigenvalues()`
/// \exception Numerical_error as `smallest_eigenvalues()`
inline Eigenfunctions smallest_eigenfunctions(const Eigen::SparseMatrix<double>& stiffness,
                                              const Eigen::SparseMatrix<double>& mass, std::size_t number)
{
  std::vector<internal::Spectrum_part> parts;
  const std::vector<internal::Eigenpair> pairs = internal::smallest_eigenpairs(stiffness, mass, number, true, parts);
  Eigenfunctions result;
  result.functions.setZero(stiffness.rows(), Eigen::Index(pairs.size()));
  for (const internal::Eigenpair& pair : pairs) {
    const auto column = Eigen::Index(result.eigenvalues.size());
    result.eigenvalues.push_back(pair.value);
    Eigen::Index largest = 0;
    pair.function.cwiseAbs().maxCoeff(&largest);
    const double sign = pair.function[largest] < 0 ? -1 : 1;
    const std::vector<int>& rows = parts[pair.part].rows;
    for (std::size_t i = 0; i < rows.size(); ++i)
      result.functions(rows[i], column) = sign * pair.function[Eigen::Index(i)];
  }
  return result;
}

/// \brief the extreme nonzero eigenvalues of a stiffness matrix.
struct Extreme_eigenvalues
{
  double smallest = 0; ///< the smallest nonzero eigenvalue
  double largest = 0;  ///< the largest eigenvalue

  /// returns the ratio of the largest to the smallest.
  double condition_number() const { return largest / smallest; }
};

namespace internal {

// The rows of the stiffness matrix that count, and where it is singular.
class Spectrum_domain
{
public:
  explicit Spectrum_domain(const Delta_complex& complex)
    : row_(complex.number_of_vertices(), -1), free_row_(complex.number_of_vertices(), -1)
  {
    const std::size_t n = complex.number_of_vertices();
    Disjoint_sets components(n);
    for (Edge_index e : complex.edges())
      components.unite(complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx());
    std::vector<bool> has_border(n, false);
    for (Vertex_index v : complex.vertices())
      if (is_on_border(complex, v))
        has_border[components.find(v.idx())] = true;
    std::vector<int> number_of_component(n, -1);
    for (Vertex_index v : complex.vertices()) {
      if (!complex.halfedge(v).is_valid() || is_on_border(complex, v))
        continue;
      row_[v.idx()] = number_of_rows();
      const std::uint32_t component = components.find(v.idx());
      int& number = number_of_component[component];
      const bool is_grounded = !has_border[component] && number < 0; // the first vertex of its component
      if (is_grounded) {
        number = number_of_closed_components();
        component_sizes_.push_back(0);
      }
      closed_component_.push_back(number);
      if (number >= 0)
        ++component_sizes_[std::size_t(number)];
      if (!is_grounded) {
        free_row_[v.idx()] = int(free_rows_.size());
        free_rows_.push_back(row_[v.idx()]);
      }
    }
  }

  int number_of_rows() const { return int(closed_component_.size()); }
  int number_of_closed_components() const { return int(component_sizes_.size()); }
  int number_of_eigenvalues() const { return number_of_rows() - number_of_closed_components(); }

  // Inner vertices with a face.
  Eigen::SparseMatrix<double> interior(const Eigen::SparseMatrix<double>& stiffness) const
  {
    return submatrix(stiffness, row_, row_, number_of_rows(), number_of_rows());
  }
  // The same without one vertex of each closed component: positive definite.
  Eigen::SparseMatrix<double> grounded(const Eigen::SparseMatrix<double>& stiffness) const
  {
    const int n = int(free_rows_.size());
    return submatrix(stiffness, free_row_, free_row_, n, n);
  }
  const std::vector<int>& free_rows() const { return free_rows_; }

  // Makes a vector orthogonal to the kernel, which is that of the functions that are constant on
  // closed components.
  template <class Vector>
  void project(Vector& x) const
  {
    std::vector<double> means(component_sizes_.size(), 0);
    for (std::size_t i = 0; i < closed_component_.size(); ++i)
      if (closed_component_[i] >= 0)
        means[std::size_t(closed_component_[i])] += x[Eigen::Index(i)];
    for (std::size_t c = 0; c < means.size(); ++c)
      means[c] /= component_sizes_[c];
    for (std::size_t i = 0; i < closed_component_.size(); ++i)
      if (closed_component_[i] >= 0)
        x[Eigen::Index(i)] -= means[std::size_t(closed_component_[i])];
  }

private:
  static bool is_on_border(const Delta_complex& complex, Vertex_index v)
  {
    const Halfedge_index h = complex.halfedge(v);
    return h.is_valid() && complex.is_border(h);
  }

  std::vector<int> row_, free_row_;   // by vertex; -1 for none
  std::vector<int> free_rows_;        // the rows that are not grounded
  std::vector<int> closed_component_; // of each row; -1 if it has a border
  std::vector<int> component_sizes_;
};

// The pseudoinverse of the stiffness matrix, as Spectra applies it: a right side without constant part has a solution
// that vanishes at the grounded vertices, from which only the constant part remains to be removed.
class Pseudoinverse
{
public:
  using Scalar = double;

  Pseudoinverse(const Spectrum_domain& domain, const Eigen::SparseMatrix<double>& stiffness)
    : domain_(domain), cholesky_(domain.grounded(stiffness), "the Laplace-Beltrami operator")
  {}

  Eigen::Index rows() const { return domain_.number_of_rows(); }
  Eigen::Index cols() const { return domain_.number_of_rows(); }

  void perform_op(const double* in, double* out) const
  {
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(in, rows());
    domain_.project(x);
    const std::vector<int>& free_rows = domain_.free_rows();
    Eigen::VectorXd right(Eigen::Index(free_rows.size()));
    for (std::size_t i = 0; i < free_rows.size(); ++i)
      right[Eigen::Index(i)] = x[free_rows[i]];
    const Eigen::VectorXd solution = cholesky_.solve(right);
    x.setZero();
    for (std::size_t i = 0; i < free_rows.size(); ++i)
      x[free_rows[i]] = solution[Eigen::Index(i)];
    domain_.project(x);
    Eigen::Map<Eigen::VectorXd>(out, rows()) = x;
  }

private:
  const Spectrum_domain& domain_;
  Sparse_Cholesky<> cholesky_;
};

template <class Operator>
double largest_eigenvalue(Operator& op)
{
  constexpr Eigen::Index dimension = 40; // of the Krylov space
  Spectra::SymEigsSolver<Operator> solver(op, 1, (std::min)(dimension, op.rows()));
  solver.init();
  solver.compute(Spectra::SortRule::LargestAlge, 3000, 1e-10);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw Numerical_error("the extreme eigenvalues do not converge");
  return solver.eigenvalues()[0];
}

} // namespace internal

/// \brief returns the smallest and the largest eigenvalue of a stiffness matrix, whose ratio is
/// the condition number of the operator.
///
/// *Definition.* Border vertices and isolated vertices are left out, as for
/// Dirichlet conditions. The remaining matrix has one zero eigenvalue for each closed component,
/// which is ignored; all others are positive. The mass matrix is not used.
///
/// Method: Lanczos (Spectra) for the largest eigenvalues of the matrix and of its pseudoinverse, with one sparse
/// Cholesky factorization. The relative error of an eigenvalue is about 1e-10, or 1e-16 times the condition number.
///
/// \param complex the triangles
/// \param stiffness their matrix, as returned by `stiffness_matrix()`
/// \exception Invalid_surface_error if no eigenvalue is left
/// \exception Numerical_error if an iteration does not converge, or if the matrix is not
///   positive definite after rounding
inline Extreme_eigenvalues extreme_eigenvalues(const Delta_complex& complex,
                                               const Eigen::SparseMatrix<double>& stiffness)
{
  CGAL_precondition(stiffness.rows() == Eigen::Index(complex.number_of_vertices()));
  const internal::Spectrum_domain domain(complex);
  if (domain.number_of_eigenvalues() == 0)
    throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, 0, 1,
                                "the surface has too few inner vertices for an operator with a "
                                "condition number");
  Eigen::SparseMatrix<double> interior = domain.interior(stiffness);
  if (interior.rows() <= 32) { // the smallest size that leaves room for a Krylov space
    const Eigen::VectorXd all =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(interior), Eigen::EigenvaluesOnly).eigenvalues();
    return {all[domain.number_of_closed_components()], all[all.size() - 1]};
  }
  // Spectra takes eigenvalues far below 1 for zeros. If the largest one is about 1, the wanted eigenvalues of the
  // matrix and of the pseudoinverse are at least about 1.
  const double unit = std::ldexp(1., std::ilogb(interior.diagonal().maxCoeff()));
  interior /= unit;
  Spectra::SparseSymMatProd<double> product(interior);
  internal::Pseudoinverse pseudoinverse(domain, stiffness / unit);
  return {unit / internal::largest_eigenvalue(pseudoinverse), unit * internal::largest_eigenvalue(product)};
}

/// \brief the numbers of cotangent weights in intervals of equal width.
struct Weight_histogram
{
  double low = 0;                  ///< where the first interval begins
  double high = 0;                 ///< where the last interval ends
  std::vector<std::size_t> counts; ///< half-open intervals, from `low` to `high`
  std::size_t below = 0;           ///< weights less than `low`
  std::size_t above = 0;           ///< weights of at least `high`, including infinite ones
};

/// \brief counts the weights of interior edges. Those of border edges are single cotangents
/// and say nothing about the Delaunay property.
///
/// \param complex the triangles
/// \param weights `cot k + cot l` for each edge, as returned by `cotangent_weights()`; none is NaN
/// \param low, high the range of the intervals
/// \param number_of_intervals their number
/// \pre `low < high`, `number_of_intervals > 0`, and there is a weight for each edge. O(size).
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), figure 6.
inline Weight_histogram weight_histogram(const Delta_complex& complex, const std::vector<double>& weights, double low,
                                         double high, std::size_t number_of_intervals)
{
  CGAL_precondition(low < high && number_of_intervals > 0);
  CGAL_precondition(weights.size() == complex.number_of_edges());
  Weight_histogram histogram{low, high, std::vector<std::size_t>(number_of_intervals, 0)};
  for (Edge_index e : complex.edges()) {
    const double w = weights[e.idx()];
    if (complex.is_border(e))
      continue;
    if (w < low)
      ++histogram.below;
    else if (w >= high)
      ++histogram.above;
    else
      ++histogram.counts[(std::min)(std::size_t((w - low) / (high - low) * double(number_of_intervals)),
                                    number_of_intervals - 1)];
  }
  return histogram;
}

/// @}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EIGENVALUES_H

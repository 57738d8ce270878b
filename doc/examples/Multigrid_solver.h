// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Linear systems that are too large to be factorized, by the algebraic multigrid solver of hypre
// (Debian: libhypre-dev; compile by mpicxx with -I/usr/include/hypre, link with -lHYPRE). The program calls
// MPI_Init() and HYPRE_Init() before.

#ifndef MULTIGRID_SOLVER_H
#define MULTIGRID_SOLVER_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <Eigen/SparseCore>
#include <HYPRE.h>
#include <HYPRE_parcsr_ls.h>
#include <mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

struct Hypre_objects
{
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_IJVector right = nullptr, solution = nullptr;
  HYPRE_Solver multigrid = nullptr, gradients = nullptr;

  Hypre_objects() = default;
  Hypre_objects(const Hypre_objects&) = delete;
  Hypre_objects& operator=(const Hypre_objects&) = delete;
  ~Hypre_objects()
  {
    if (gradients != nullptr)
      HYPRE_ParCSRPCGDestroy(gradients);
    if (multigrid != nullptr)
      HYPRE_BoomerAMGDestroy(multigrid);
    for (const HYPRE_IJVector v : {solution, right})
      if (v != nullptr)
        HYPRE_IJVectorDestroy(v);
    if (matrix != nullptr)
      HYPRE_IJMatrixDestroy(matrix);
  }
};

/// \brief solves large sparse systems by the conjugate gradient method, preconditioned by algebraic multigrid (BoomerAMG
/// of hypre).
///
///     Multigrid_solver solver(M + time * L);
///     Eigen::VectorXd u = solver.solve(M * u0);
///
/// Time and memory are proportional to the size of the matrix, where those of a factorization grow faster. The matrix
/// has to be symmetric and positive definite, and should have no positive entries beside the diagonal: the Laplacian of
/// an intrinsic Delaunay triangulation has none, as the weights of edges are not negative, and becomes positive definite
/// by a mass matrix or by given values at some vertices. Entries far from the largest one are as accurate as that one,
/// and not relative to themselves: heat after a short time (`Heat_method`) needs a factorization.
///
/// All processes of the communicator make the solver and call its functions together. The first one has the matrix
/// and the right sides, and gets the solutions; the others give and get empty ones. Rows are distributed in blocks.
/// Not copyable, and for one thread at a time, as hypre has one state.
class Multigrid_solver
{
public:
  /// a sparse matrix with both its triangles.
  using Matrix = Eigen::SparseMatrix<double>;
  /// a right side or a solution.
  using Vector = Eigen::VectorXd;

  /// how a system was solved.
  struct Report
  {
    int iterations = 0;           ///< of the conjugate gradient method
    double relative_residual = 0; ///< |A x − b| / |b|, computed from the solution itself
  };

  /// \brief sets up the hierarchy of coarser systems. O(entries).
  /// \param matrix the matrix, at the first process of `communicator`
  /// \param communicator the processes that solve together; by default this one alone
  /// \exception Invalid_argument_error if the matrix is not square, has entries that are not finite, or a diagonal that
  ///   is not positive
  /// \exception Numerical_error if hypre fails
  explicit Multigrid_solver(const Matrix& matrix, MPI_Comm communicator = MPI_COMM_SELF) : communicator_(communicator)
  {
    MPI_Comm_rank(communicator_, &rank_);
    int number_of_processes = 1;
    MPI_Comm_size(communicator_, &number_of_processes);
    require(rank_ != 0 || is_square_and_finite(matrix),
            "the matrix of a linear system must be square and finite, with a positive diagonal");
    size_ = int(matrix.rows());
    MPI_Bcast(&size_, 1, MPI_INT, 0, communicator_);
    if (rank_ == 0 && size_ > 0)
      unit_ = Vector(matrix.diagonal()).maxCoeff();
    MPI_Bcast(&unit_, 1, MPI_DOUBLE, 0, communicator_);
    for (int p = 0; p <= number_of_processes; ++p)
      first_rows_.push_back(int(std::int64_t(size_) * p / number_of_processes));
    for (int row = first_rows_[std::size_t(rank_)]; row < first_rows_[std::size_t(rank_) + 1]; ++row)
      rows_.push_back(row);
    if (size_ > 0)
      set_up(matrix);
  }

  /// \brief solves A x = b. O(entries) for each iteration, of which there are usually 10 to 30, whatever the size.
  ///
  /// \param b the right side, at the first process
  /// \return x at the first process, an empty vector at the others. |A x − b| is at most 10^-12 (|A| |x| + |b|)
  /// \exception Invalid_argument_error if b has another size than the matrix, or an entry that is not finite
  /// \exception Numerical_error if that is not reached: the matrix may not be positive definite
  Vector solve(const Vector& b) const
  {
    Report report;
    return solve(b, report);
  }
  /// as above. \param b the right side, at the first process \param report receives how the system was solved, at all processes
  Vector solve(const Vector& b, Report& report) const
  {
    require(rank_ != 0 || (b.size() == size_ && b.allFinite()),
            "the right side of a linear system must be finite, with an entry for each row of its matrix");
    report = {};
    double largest = rank_ == 0 && size_ > 0 ? b.cwiseAbs().maxCoeff() : 0;
    MPI_Bcast(&largest, 1, MPI_DOUBLE, 0, communicator_);
    if (largest == 0)
      return Vector::Zero(rank_ == 0 ? size_ : 0);
    scatter(rank_ == 0 ? Vector(b / largest) : Vector());
    HYPRE_ParCSRPCGSolve(hypre_.gradients, parallel_matrix(), parallel(hypre_.right), parallel(hypre_.solution));
    HYPRE_ClearAllErrors(); // one of which says that the residual is larger than it should be
    HYPRE_PCGGetNumIterations(hypre_.gradients, &report.iterations);
    const auto [of_b, of_x, of_residual] = norms();
    report.relative_residual = of_residual / of_b;
    if (!(of_residual <= largest_error * (of_x + of_b)))
      throw CGAL::Intrinsic_triangulations::Numerical_error(
        "a linear system is not solved after " + std::to_string(report.iterations) +
        " iterations: the matrix must be symmetric and positive definite");
    const Vector x = gathered() * (largest / unit_);
    if (!holds_everywhere(x.allFinite()))
      throw CGAL::Intrinsic_triangulations::Numerical_error(
        "a linear system cannot be solved: the solution is beyond the range of double");
    return x;
  }

private:
  static constexpr double wanted_residual = 1e-13, largest_error = 1e-12;
  static constexpr int most_iterations = 300;

  // So that all processes throw if one does.
  bool holds_everywhere(bool condition) const
  {
    int holds = condition ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &holds, 1, MPI_INT, MPI_MIN, communicator_);
    return holds != 0;
  }
  void require(bool condition, const char* message) const
  {
    if (!holds_everywhere(condition))
      throw CGAL::Intrinsic_triangulations::Invalid_argument_error(message);
  }

  static bool is_square_and_finite(const Matrix& matrix)
  {
    if (matrix.rows() != matrix.cols())
      return false;
    for (Eigen::Index c = 0; c < matrix.outerSize(); ++c) {
      if (!(matrix.coeff(c, c) > 0))
        return false;
      for (Matrix::InnerIterator i(matrix, c); i; ++i)
        if (!std::isfinite(i.value()))
          return false;
    }
    return true;
  }

  void set_up(const Matrix& matrix)
  {
    const int first = first_rows_[std::size_t(rank_)], last = first_rows_[std::size_t(rank_) + 1] - 1;
    HYPRE_IJMatrixCreate(communicator_, first, last, first, last, &hypre_.matrix);
    HYPRE_IJMatrixSetObjectType(hypre_.matrix, HYPRE_PARCSR);
    if (rank_ == 0) {
      std::vector<int> lengths;
      for (int row : rows_)
        lengths.push_back(int(matrix.innerVector(row).nonZeros()));
      HYPRE_IJMatrixSetRowSizes(hypre_.matrix, lengths.data());
    }
    HYPRE_IJMatrixInitialize(hypre_.matrix);
    if (rank_ == 0) { // which may add to rows of others. A symmetric matrix has its columns as rows.
      std::vector<int> columns;
      std::vector<double> values;
      for (int row = 0; row < size_; ++row) {
        columns.clear();
        values.clear();
        for (Matrix::InnerIterator i(matrix, row); i; ++i) {
          columns.push_back(int(i.row()));
          values.push_back(i.value() / unit_);
        }
        int n = int(columns.size());
        HYPRE_IJMatrixAddToValues(hypre_.matrix, 1, &n, &row, columns.data(), values.data());
      }
    }
    HYPRE_IJMatrixAssemble(hypre_.matrix);
    for (HYPRE_IJVector* v : {&hypre_.right, &hypre_.solution}) {
      HYPRE_IJVectorCreate(communicator_, first, last, v);
      HYPRE_IJVectorSetObjectType(*v, HYPRE_PARCSR);
    }
    scatter(Vector::Zero(rank_ == 0 ? size_ : 0));
    HYPRE_BoomerAMGCreate(&hypre_.multigrid);
    HYPRE_BoomerAMGSetMaxIter(hypre_.multigrid, 1);
    HYPRE_BoomerAMGSetTol(hypre_.multigrid, 0);
    HYPRE_ParCSRPCGCreate(communicator_, &hypre_.gradients);
    HYPRE_PCGSetMaxIter(hypre_.gradients, most_iterations);
    HYPRE_PCGSetTol(hypre_.gradients, wanted_residual);
    HYPRE_PCGSetTwoNorm(hypre_.gradients, 1);
    HYPRE_PCGSetPrecond(hypre_.gradients, HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSolve),
                        HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSetup), hypre_.multigrid);
    HYPRE_ParCSRPCGSetup(hypre_.gradients, parallel_matrix(), parallel(hypre_.right), parallel(hypre_.solution));
    const bool has_failed = HYPRE_GetError() != 0;
    HYPRE_ClearAllErrors();
    if (!holds_everywhere(!has_failed))
      throw CGAL::Intrinsic_triangulations::Numerical_error("a linear system cannot be set up by hypre");
  }

  HYPRE_ParCSRMatrix parallel_matrix() const
  {
    void* result = nullptr;
    HYPRE_IJMatrixGetObject(hypre_.matrix, &result);
    return static_cast<HYPRE_ParCSRMatrix>(result);
  }
  static HYPRE_ParVector parallel(HYPRE_IJVector v)
  {
    void* result = nullptr;
    HYPRE_IJVectorGetObject(v, &result);
    return static_cast<HYPRE_ParVector>(result);
  }

  // How many rows each process has.
  std::vector<int> numbers_of_rows() const
  {
    std::vector<int> result;
    for (std::size_t p = 0; p + 1 < first_rows_.size(); ++p)
      result.push_back(first_rows_[p + 1] - first_rows_[p]);
    return result;
  }

  // Makes this the right side, and zero the solution to begin with.
  void scatter(const Vector& b) const
  {
    std::vector<double> own(rows_.size());
    MPI_Scatterv(b.data(), numbers_of_rows().data(), first_rows_.data(), MPI_DOUBLE, own.data(), int(own.size()),
                 MPI_DOUBLE, 0, communicator_);
    for (const HYPRE_IJVector v : {hypre_.right, hypre_.solution}) {
      HYPRE_IJVectorInitialize(v);
      HYPRE_IJVectorSetValues(v, int(rows_.size()), rows_.data(), own.data());
      HYPRE_IJVectorAssemble(v);
      std::fill(own.begin(), own.end(), 0.);
    }
  }
  Vector gathered() const
  {
    std::vector<double> own(rows_.size());
    HYPRE_IJVectorGetValues(hypre_.solution, int(rows_.size()), rows_.data(), own.data());
    Vector result(rank_ == 0 ? size_ : 0);
    MPI_Gatherv(own.data(), int(own.size()), MPI_DOUBLE, result.data(), numbers_of_rows().data(), first_rows_.data(),
                MPI_DOUBLE, 0, communicator_);
    return result;
  }

  // Of right side, solution and residual, which replaces the right side.
  std::array<double, 3> norms() const
  {
    const HYPRE_ParVector b = parallel(hypre_.right), x = parallel(hypre_.solution);
    const auto norm = [](HYPRE_ParVector v) {
      double square = 0;
      HYPRE_ParVectorInnerProd(v, v, &square);
      return std::sqrt(square);
    };
    const double of_b = norm(b);
    HYPRE_ParCSRMatrixMatvec(-1, parallel_matrix(), x, 1, b);
    return {of_b, norm(x), norm(b)};
  }

  MPI_Comm communicator_;
  int rank_ = 0;
  int size_ = 0;                // the number of rows
  double unit_ = 1;             // the largest diagonal entry, so that nothing overflows
  std::vector<int> first_rows_; // of each process, and the number of rows
  std::vector<int> rows_;       // of this process
  Hypre_objects hypre_;
};

#endif // MULTIGRID_SOLVER_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The angles of a flat Delaunay triangulation that are nearest to given ones.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_COHERENT_ANGLES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_COHERENT_ANGLES_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/assertions.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Coherent_angles
{
  std::vector<double> angles; // for each halfedge, the opposite angle in its face; 0 for a border halfedge
  std::size_t number_of_clipped_edges =
    0; // the number of interior edges whose two given angles summed to more than is allowed
  double largest_change = 0;
};

// For each halfedge the opposite angle; 0 for border halfedges.
inline std::vector<double> opposite_angles(const Delta_complex& complex, const std::vector<double>& lengths,
                                           const std::vector<double>& areas)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  CGAL_precondition(areas.size() == complex.number_of_faces());
  std::vector<double> angles(complex.number_of_halfedges(), 0);
  for (Halfedge_index h : complex.halfedges()) {
    if (complex.is_border(h))
      continue;
    const double c = lengths[complex.edge(h).idx()], a = lengths[complex.edge(complex.next(h)).idx()],
                 b = lengths[complex.edge(complex.prev(h)).idx()];
    // Twice the cross product and twice the scalar product of the other sides.
    angles[h.idx()] = std::atan2(4 * areas[complex.face(h).idx()], a * a + (b - c) * (b + c));
  }
  return angles;
}

// The number of corners at each vertex.
inline std::vector<int> numbers_of_corners(const Delta_complex& complex)
{
  std::vector<int> result(complex.number_of_vertices(), 0);
  for (Halfedge_index h : complex.halfedges())
    if (!complex.is_border(h))
      ++result[complex.target(h).idx()];
  return result;
}

// How far angles at a vertex stay above 0, and sums opposite its edges below pi. Around an inner vertex of a flat
// triangulation, the corners share 2 pi for both.
inline std::vector<double> margins(const std::vector<int>& corners, double margin)
{
  std::vector<double> result;
  result.reserve(corners.size());
  for (int n : corners)
    result.push_back((std::min)(margin, boost::math::constants::pi<double>() / n));
  return result;
}

inline double edge_margin(const Delta_complex& complex, const std::vector<double>& margins, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e);
  return (std::min)(margins[complex.source(h).idx()], margins[complex.target(h).idx()]);
}

// Minimizes |x - given|^2 / 2 subject to A x = b, x >= lowest, and the sums over the two sides of each interior edge <=
// pi - margin, by a primal-dual interior-point method with Mehrotra's predictor and corrector (Nocedal, Wright,
// "Numerical optimization", section 16.6). Each unknown occurs in one edge sum only, so inequalities and objective add
// up to a matrix of 2 x 2 blocks, and only the Schur complement is factorized, with one row for each face and each
// inner vertex.
class Angle_optimizer
{
  using Array = Eigen::ArrayXd;
  using Matrix = Eigen::SparseMatrix<double>;

  // Angles, multipliers of the equations, and slacks and multipliers of the inequalities; or changes of all of these.
  struct Iterate
  {
    Array x, y, slack, dual;
  };

public:
  Angle_optimizer(const Delta_complex& complex, const std::vector<double>& angles, const std::vector<double>& margins)
    : complex_(complex), unknown_(complex.number_of_halfedges(), -1)
  {
    number_unknowns(angles, margins);
    build_equations();
  }

  std::vector<double> run(const Progress_function& progress)
  {
    start();
    const double first_gap = gap();
    for (int iteration = 0; iteration < 100; ++iteration) {
      report_progress(progress, fraction_of_digits(first_gap, gap(), 1e-10), "the search for angles");
      evaluate();
      if ((equation_error_.abs() < tolerance_).all() && slack_error_.abs().maxCoeff() < 1e-12 && gap() < 1e-10)
        return result();
      factorize();
      step();
    }
    throw Numerical_error("no angles were found with which the triangulation is flat and "
                          "Delaunay; perhaps it has none");
  }

private:
  void number_unknowns(const std::vector<double>& angles, const std::vector<double>& margins)
  {
    int n = 0;
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h))
        unknown_[h.idx()] = n++;
    for (Edge_index e : complex_.edges())
      if (!complex_.is_border(e))
        edges_.push_back(e);
    given_.resize(n);
    bounds_.resize(n + Eigen::Index(edges_.size()));
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h)) {
        const double given = angles[h.idx()];
        given_[unknown_[h.idx()]] = given;
        bounds_[unknown_[h.idx()]] = (std::min)(given / 2, margins[complex_.target(complex_.next(h)).idx()]);
      }
    for (std::size_t i = 0; i < edges_.size(); ++i)
      bounds_[row_of_edge(i)] = edge_margin(complex_, margins, edges_[i]) - boost::math::constants::pi<double>();
  }

  int left(std::size_t i) const { return unknown_[complex_.halfedge(edges_[i]).idx()]; }
  int right(std::size_t i) const { return unknown_[complex_.opposite(complex_.halfedge(edges_[i])).idx()]; }
  Eigen::Index row_of_edge(std::size_t i) const { return given_.size() + Eigen::Index(i); }

  // The angles of a face sum to pi, those around an inner vertex to 2 pi.
  void build_equations()
  {
    const double pi = boost::math::constants::pi<double>();
    std::vector<int> row(complex_.number_of_vertices(), -1);
    int rows = int(complex_.number_of_faces());
    for (Vertex_index v : complex_.vertices()) {
      const Halfedge_index h = complex_.halfedge(v);
      if (h.is_valid() && !complex_.is_border(h))
        row[v.idx()] = rows++;
    }
    std::vector<Eigen::Triplet<double>> entries;
    for (Halfedge_index h : complex_.halfedges()) {
      if (complex_.is_border(h))
        continue;
      const int i = unknown_[h.idx()];
      entries.emplace_back(int(complex_.face(h).idx()), i, 1);
      const int vertex_row = row[complex_.target(complex_.next(h)).idx()];
      if (vertex_row >= 0)
        entries.emplace_back(vertex_row, i, 1);
    }
    equations_.resize(rows, given_.size());
    equations_.setFromTriplets(entries.begin(), entries.end());
    sums_ = Array::Constant(rows, 2 * pi);
    sums_.head(complex_.number_of_faces()).setConstant(pi);
    tolerance_ = (equations_ * Eigen::VectorXd::Ones(given_.size())).array().max(1e-12 / rounding) * rounding;
  }

  void start()
  {
    now_.x = given_;
    now_.y = Array::Zero(sums_.size());
    now_.slack = (limited(now_.x) - bounds_).max(0.1);
    now_.dual = Array::Constant(bounds_.size(), 0.1);
  }

  // The quantities that are bounded from below: the angles, then the negative sums over the sides of edges.
  Array limited(const Array& x) const
  {
    Array result(bounds_.size());
    result.head(x.size()) = x;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      result[row_of_edge(i)] = -(x[left(i)] + x[right(i)]);
    return result;
  }
  // Adds the product of the transpose of that linear map and another vector.
  void add_transposed(Array& x, const Array& factor) const
  {
    x += factor.head(x.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      x[left(i)] -= factor[row_of_edge(i)];
      x[right(i)] -= factor[row_of_edge(i)];
    }
  }

  void evaluate()
  {
    gradient_ = now_.x - given_ + (equations_.transpose() * now_.y.matrix()).array();
    add_transposed(gradient_, -now_.dual);
    equation_error_ = (equations_ * now_.x.matrix()).array() - sums_;
    slack_error_ = limited(now_.x) - bounds_ - now_.slack;
  }

  // The mean of their products.
  double gap(const Array& slack, const Array& dual) const
  {
    const Eigen::Index n = given_.size(), m = slack.size() - n;
    return ((slack.head(n) * dual.head(n)).sum() + (slack.tail(m) * dual.tail(m)).sum()) / double(n + m);
  }
  double gap() const { return gap(now_.slack, now_.dual); }

  void factorize()
  {
    std::vector<Eigen::Triplet<double>> entries;
    const Array ratio = now_.dual / now_.slack, diagonal = 1 + ratio.head(given_.size());
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      const int h = left(i), g = right(i);
      const double a = diagonal[h], b = diagonal[g], d = ratio[row_of_edge(i)];
      const double determinant = a * b + d * (a + b);
      entries.emplace_back(h, h, (b + d) / determinant);
      entries.emplace_back(g, g, (a + d) / determinant);
      entries.emplace_back(h, g, -d / determinant);
      entries.emplace_back(g, h, -d / determinant);
    }
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h) && complex_.is_border(complex_.opposite(h)))
        entries.emplace_back(unknown_[h.idx()], unknown_[h.idx()], 1 / diagonal[unknown_[h.idx()]]);
    inverse_.resize(given_.size(), given_.size());
    inverse_.setFromTriplets(entries.begin(), entries.end());
    const Matrix schur = equations_ * inverse_ * Matrix(equations_.transpose());
    if (!cholesky_)
      cholesky_.emplace(schur, "the system for the angles");
    else
      cholesky_->factorize(schur);
  }

  // The Newton direction towards slack * dual = slack * dual + target.
  Iterate direction(const Array& target) const
  {
    Iterate d;
    Array right_side = -gradient_;
    add_transposed(right_side, (target - now_.dual * slack_error_) / now_.slack);
    const Eigen::VectorXd inverse_right = inverse_ * right_side.matrix();
    d.y = cholesky_->solve(Eigen::VectorXd(equations_ * inverse_right + equation_error_.matrix())).array();
    d.x = (inverse_right - inverse_ * (equations_.transpose() * d.y.matrix())).array();
    d.slack = limited(d.x) + slack_error_;
    d.dual = (target - now_.dual * d.slack) / now_.slack;
    return d;
  }

  // The longest step, at most 1, that leaves slacks and multipliers nonnegative.
  double longest_step(const Iterate& d) const
  {
    double step = 1;
    const auto limit = [&step](const Array& value, const Array& change) {
      for (Eigen::Index i = 0; i < value.size(); ++i)
        if (change[i] < 0)
          step = (std::min)(step, -value[i] / change[i]);
    };
    limit(now_.slack, d.slack);
    limit(now_.dual, d.dual);
    return step;
  }

  void step()
  {
    const double old_gap = gap();
    const Iterate predictor = direction(-now_.slack * now_.dual);
    const double trial = longest_step(predictor);
    const double trial_gap = gap(now_.slack + trial * predictor.slack, now_.dual + trial * predictor.dual);
    const double center = std::pow(trial_gap / old_gap, 3) * old_gap;
    const Iterate d = direction(center - now_.slack * now_.dual - predictor.slack * predictor.dual);
    const double t = (std::min)(1., 0.99 * longest_step(d));
    now_.x += t * d.x;
    now_.y += t * d.y;
    now_.slack += t * d.slack;
    now_.dual += t * d.dual;
  }

  std::vector<double> result() const
  {
    std::vector<double> angles(complex_.number_of_halfedges(), 0);
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h))
        angles[h.idx()] = now_.x[unknown_[h.idx()]];
    return angles;
  }

  static constexpr double rounding = 0x1p-52; // of a term of a sum

  const Delta_complex& complex_;
  std::vector<int> unknown_;      // by halfedge
  std::vector<Edge_index> edges_; // those with two sides
  Array given_, bounds_, sums_, tolerance_;
  Matrix equations_, inverse_;
  std::optional<Sparse_Cholesky<>> cholesky_;
  Iterate now_;
  Array gradient_, equation_error_, slack_error_;
};

// Finds the coherent angle system that is nearest to given angles in the least-squares sense.
//
// In a coherent angle system the angles of each face sum to π, those around each interior vertex sum to 2π, all are
// positive, and the two opposite an interior edge sum to less than π. If a triangulation is not Delaunay, some of its
// edges violate the last condition, and their angles are clipped. On an intrinsic Delaunay triangulation there is
// nothing to clip; only the curvature has to be distributed.
//
// \param angles those of `opposite_angles()`
// \param margin how far edge sums stay below π and angles stay above 0; angles less than twice the margin can become
//   half as large. At a vertex with d corners the margin is at most π/d
// \exception Invalid_surface_error if an interior vertex has fewer than three corners, whose angles cannot sum to 2π
// \exception Numerical_error if no such angles are found
//
// The convex quadratic program takes about twenty sparse Cholesky factorizations. Face and vertex sums are accurate to
// 1e-12, or to 2⁻⁵² for each corner of a vertex if that is more.
// Source: L. Kharevych, B. Springborn, P. Schröder, "Discrete conformal mappings via circle patterns", 2006, section 3.
inline Coherent_angles find_coherent_angles(const Delta_complex& complex, const std::vector<double>& angles,
                                            double margin = 1e-3, const Progress_function& progress = {})
{
  CGAL_precondition(angles.size() == complex.number_of_halfedges());
  const std::vector<int> corners = numbers_of_corners(complex);
  for (Vertex_index v : complex.vertices()) {
    const Halfedge_index h = complex.halfedge(v);
    if (h.is_valid() && !complex.is_border(h) && corners[v.idx()] < 3)
      throw Invalid_surface_error(Invalid_surface_error::Defect::WRONG_TOPOLOGY, v.idx(), 1,
                                  "inner vertex " + std::to_string(v.idx()) + " has " +
                                    counted(std::size_t(corners[v.idx()]), "corner", "corners") +
                                    ", too few to be flattened: angles are less than pi each and would have to sum to "
                                    "2 pi; remove the vertex, or cut the surface open there");
  }
  Coherent_angles result;
  const std::vector<double> margins = internal::margins(corners, margin);
  result.angles = Angle_optimizer(complex, angles, margins).run(progress);
  for (Edge_index e : complex.edges()) {
    const Halfedge_index h = complex.halfedge(e);
    if (!complex.is_border(e) && angles[h.idx()] + angles[complex.opposite(h).idx()] >
                                   boost::math::constants::pi<double>() - edge_margin(complex, margins, e))
      ++result.number_of_clipped_edges;
  }
  for (std::size_t h = 0; h < angles.size(); ++h)
    result.largest_change = (std::max)(result.largest_change, std::abs(result.angles[h] - angles[h]));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_PARAMETERIZATION_COHERENT_ANGLES_H

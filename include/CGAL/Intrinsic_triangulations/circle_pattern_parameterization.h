// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Discrete conformal maps of disks to the plane by circle patterns.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CIRCLE_PATTERN_PARAMETERIZATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CIRCLE_PATTERN_PARAMETERIZATION_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/parameterization/coherent_angles.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <boost/math/constants/constants.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief a map by a circle pattern, and information on its computation.
struct Circle_pattern
{
  Planar_points uv; ///< the position of each vertex; the image has the area of the surface
  /// the angles of the circle pattern: for each halfedge, the angle opposite to it in its face; 0 for a border halfedge
  std::vector<double> angles;
  std::size_t number_of_clipped_edges = 0; ///< interior edges whose opposite angles on the surface have too large a sum
  double largest_change = 0;               ///< the largest change of an angle, in radians
  double gradient = 0;                     ///< the largest component of the energy's gradient at the end
  int iterations = 0;                      ///< the number of steps of Newton's method
};

namespace internal {

// The energy of Kharevych, Springborn and Schröder (2006), section 2, as a function of the
// logarithms of the radii: one circle for each face. The angle φ of a face opposite to an edge
// follows from the radii on both sides and the angle θ at which their circles meet; the
// pattern closes where the angles of each face sum to π.
class Circle_pattern_energy
{
public:
  // θ is π minus the sum of the angles opposite to the edge. A border edge keeps its angle.
  Circle_pattern_energy(const Delta_complex& complex, const std::vector<double>& angles)
    : complex_(complex), angles_(angles)
  {}

  // The angle opposite to h.
  double angle(Halfedge_index h, const Eigen::VectorXd& rho) const
  {
    const Halfedge_index g = complex_.opposite(h);
    if (complex_.is_border(g))
      return angles_[h.idx()];
    const double theta = intersection_angle(h);
    return std::atan2(std::sin(theta), std::exp(difference(h, rho)) - std::cos(theta));
  }

  // 2π minus twice the sum of the angles, for each face.
  Eigen::VectorXd gradient(const Eigen::VectorXd& rho) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(rho.size(), boost::math::constants::two_pi<double>());
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h))
        result[complex_.face(h).idx()] -= 2 * angle(h, rho);
    return result;
  }

  // The second derivatives: a weighted graph Laplacian of the faces. Scaling all radii changes nothing, so the row and
  // the column of face 0 are omitted.
  Eigen::SparseMatrix<double> hessian(const Eigen::VectorXd& rho) const
  {
    return Laplacian([&](Halfedge_index h) { return weight(h, difference(h, rho)); });
  }

  // The logarithms of radii for which the given angles fit best along each edge. Two faces fit exactly if their
  // difference is that of the logarithms of the sines; since that is not consistent around vertices, least squares with
  // the weights of the Hessian distribute the rest.
  Eigen::VectorXd first_guess() const
  {
    const auto wanted = [&](Halfedge_index h) {
      return std::log(std::sin(angles_[complex_.opposite(h).idx()]) / std::sin(angles_[h.idx()]));
    };
    const Eigen::Index n = complex_.number_of_faces();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n), rho = Eigen::VectorXd::Zero(n);
    for (Edge_index e : complex_.edges()) {
      if (complex_.is_border(e))
        continue;
      const Halfedge_index h = complex_.halfedge(e);
      const double x = wanted(h), pull = weight(h, x) * x;
      right[complex_.face(h).idx()] += pull;
      right[complex_.face(complex_.opposite(h)).idx()] -= pull;
    }
    const Sparse_Cholesky<> cholesky(Laplacian([&](Halfedge_index h) { return weight(h, wanted(h)); }),
                                     "the system for the first radii");
    rho.tail(n - 1) = cholesky.solve(Eigen::VectorXd(right.tail(n - 1)));
    return rho;
  }

  // The largest difference of two neighbouring faces.
  double largest_difference(const Eigen::VectorXd& rho) const
  {
    double result = 0;
    for (Edge_index e : complex_.edges())
      if (!complex_.is_border(e))
        result = (std::max)(result, std::abs(difference(complex_.halfedge(e), rho)));
    return result;
  }

private:
  double intersection_angle(Halfedge_index h) const
  {
    return boost::math::constants::pi<double>() - angles_[h.idx()] - angles_[complex_.opposite(h).idx()];
  }
  double weight(Halfedge_index h, double difference) const
  {
    const double theta = intersection_angle(h);
    return std::sin(theta) / (std::cosh(difference) - std::cos(theta));
  }

  template <class Weight>
  Eigen::SparseMatrix<double> Laplacian(const Weight& weight) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (Edge_index e : complex_.edges()) {
      if (complex_.is_border(e))
        continue;
      const Halfedge_index h = complex_.halfedge(e);
      const int k = int(complex_.face(h).idx()) - 1, l = int(complex_.face(complex_.opposite(h)).idx()) - 1;
      const double w = weight(h);
      if (k >= 0)
        entries.emplace_back(k, k, w);
      if (l >= 0)
        entries.emplace_back(l, l, w);
      if (k >= 0 && l >= 0) {
        entries.emplace_back(k, l, -w);
        entries.emplace_back(l, k, -w);
      }
    }
    const Eigen::Index n = Eigen::Index(complex_.number_of_faces()) - 1;
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  double difference(Halfedge_index h, const Eigen::VectorXd& rho) const
  {
    return rho[complex_.face(h).idx()] - rho[complex_.face(complex_.opposite(h)).idx()];
  }

  const Delta_complex& complex_;
  const std::vector<double>& angles_;
};

constexpr double circle_pattern_tolerance = 1e-10;

// Newton's method. If radii differ much, the energy is almost linear and its Hessian useless, so no step may change
// their ratios too much. The energy is convex, so its slope along the direction grows: a step is short enough as soon
// as the upward slope at its end is at most half as steep as the downward slope at its start.
inline void minimize(const Circle_pattern_energy& energy, Eigen::VectorXd& rho, Circle_pattern& result,
                     const Progress_function& progress)
{
  Eigen::VectorXd gradient = energy.gradient(rho);
  result.gradient = gradient.cwiseAbs().maxCoeff();
  if (rho.size() == 1)
    return;
  const Eigen::Index n = rho.size() - 1;
  Sparse_Cholesky<> cholesky(energy.hessian(rho), "the Hessian of the circle pattern energy");
  const double first_gradient = result.gradient;
  for (; result.gradient > circle_pattern_tolerance; ++result.iterations) {
    report_progress(progress, fraction_of_digits(first_gradient, result.gradient, circle_pattern_tolerance),
                    "the search for radii");
    if (result.iterations == 50)
      throw Numerical_error("the circle pattern does not converge: rounding, of angles that are "
                            "too small, keeps the gradient of its energy above 1e-10");
    if (result.iterations > 0)
      cholesky.factorize(energy.hessian(rho));
    Eigen::VectorXd direction = Eigen::VectorXd::Zero(n + 1);
    direction.tail(n) = cholesky.solve(Eigen::VectorXd(-gradient.tail(n)));
    const double slope = direction.dot(gradient);
    double step = (std::min)(1., 1.5 / energy.largest_difference(direction));
    Eigen::VectorXd next = rho + step * direction, next_gradient = energy.gradient(next);
    while (!(direction.dot(next_gradient) <= -0.5 * slope) && step > 1e-10) {
      step /= 2;
      next = rho + step * direction;
      next_gradient = energy.gradient(next);
    }
    rho = next;
    gradient = next_gradient;
    result.gradient = gradient.cwiseAbs().maxCoeff();
  }
}

// Lays the triangles out side by side, face by face, breadth first. Sides are passed on as vectors, not as differences
// of positions, so that small triangles among large ones keep their digits.
inline Planar_points lay_out(const Delta_complex& complex, const Circle_pattern_energy& energy,
                             const Eigen::VectorXd& rho)
{
  using Vector = std::complex<double>;
  std::vector<Vector> position(complex.number_of_vertices(), 0);
  std::vector<bool> is_placed(complex.number_of_vertices(), false), is_reached(complex.number_of_faces(), false);
  std::vector<std::pair<Halfedge_index, Vector>> queue;
  const auto reach = [&](Halfedge_index h, const Vector& side) {
    if (!complex.is_border(h) && !is_reached[complex.face(h).idx()]) {
      is_reached[complex.face(h).idx()] = true;
      queue.emplace_back(h, side);
    }
  };
  const auto place = [&](Vertex_index v, const Vector& p) {
    if (!is_placed[v.idx()]) {
      is_placed[v.idx()] = true;
      position[v.idx()] = p;
    }
  };
  const Halfedge_index first = complex.halfedge(Face_index(0));
  const Vector first_side = 2 * std::exp(rho[0]) * std::sin(energy.angle(first, rho));
  place(complex.source(first), 0);
  place(complex.target(first), first_side);
  reach(first, first_side);
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const auto [ij, side] = queue[next];
    const Halfedge_index jk = complex.next(ij), ki = complex.prev(ij);
    const double at_i = energy.angle(jk, rho), at_j = energy.angle(ki, rho), at_k = energy.angle(ij, rho);
    const Vector ik = side * std::polar(std::sin(at_j) / std::sin(at_k), at_i);
    place(complex.target(jk), position[complex.source(ij).idx()] + ik);
    reach(complex.opposite(ij), -side);
    reach(complex.opposite(jk), side - ik); // from k to j
    reach(complex.opposite(ki), ik);
  }
  Planar_points uv;
  uv.reserve(position.size());
  for (const Vector& p : position)
    uv.push_back({p.real(), p.imag()});
  return uv;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// \brief returns the discrete conformal map of a disk by a circle pattern: it preserves the intersection angles of the
/// circumcircles of adjacent triangles as well as flatness allows.
///
/// First the angles are replaced by the nearest ones, in the least-squares sense, of a flat Delaunay triangulation: a
/// convex quadratic program, solved by an interior-point method. Then the radii for which the circles fit together are
/// found as the minimum of a convex energy, by Newton's method with sparse Cholesky factorizations, until no component
/// of the gradient exceeds 1e-10. The boundary is free. The map preserves the orientation of each triangle, but the
/// image can overlap itself. If circles differ in size by more than the spacing of doubles in the image allows,
/// rounding collapses small triangles or turns them over; `check_parameterization()` reports them.
///
/// An intrinsic Delaunay triangulation has no angles to clip, and so less distortion than its
/// input.
///
/// \param complex the triangles of a disk
/// \param lengths the length of each edge
/// \param areas the area of each face
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is asked before each iteration of the two minimizations, each of which counts as half, and can
///     cancel}
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error if the surface is not a disk, or has an interior vertex with fewer
///   than three corners
/// \exception Numerical_error if there are no coherent angles, or rounding prevents one of the
///   minimizations from succeeding
/// \exception Cancelled_error if the visitor asks for it
///
/// Sources: L. Kharevych, B. Springborn, P. Schröder, "Discrete conformal mappings via circle
/// patterns", 2006; Fisher, Springborn, Schroeder, Bobenko (2006), section 3.3.
template <class NamedParameters = parameters::Default_named_parameters>
Circle_pattern circle_pattern_parameterization(const Delta_complex& complex, const std::vector<double>& lengths,
                                               const std::vector<double>& areas,
                                               const NamedParameters& np = parameters::default_values())
{
  const Progress_function progress = internal::progress_function_of(np);
  const std::vector<Halfedge_index> boundary = disk_boundary(complex);
  Circle_pattern result;
  const internal::Coherent_angles coherent = internal::find_coherent_angles(
    complex, internal::opposite_angles(complex, lengths, areas), 1e-3, internal::part_of_progress(progress, 0, 0.5));
  result.angles = coherent.angles;
  result.number_of_clipped_edges = coherent.number_of_clipped_edges;
  result.largest_change = coherent.largest_change;
  const internal::Circle_pattern_energy energy(complex, result.angles);

  Eigen::VectorXd rho = energy.first_guess();
  internal::minimize(energy, rho, result, internal::part_of_progress(progress, 0.5, 1));
  result.uv = internal::lay_out(complex, energy, rho);
  internal::scale_to_area(complex, boundary, areas, result.uv,
                          "the circle pattern cannot be laid out: its circles differ in size by more than double can "
                          "hold");
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsParameterization
/// as above, for a triangulation; named parameters as for `circle_pattern_parameterization()` of a complex, exceptions
/// also as for `face_areas()`.
/// \param triangulation the triangulation
/// \param np as for a complex
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Circle_pattern circle_pattern_parameterization(const Intrinsic_triangulation<Traits>& triangulation,
                                               const NamedParameters& np = parameters::default_values())
{
  return circle_pattern_parameterization(triangulation.connectivity(), edge_lengths(triangulation),
                                         face_areas(triangulation), np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CIRCLE_PATTERN_PARAMETERIZATION_H

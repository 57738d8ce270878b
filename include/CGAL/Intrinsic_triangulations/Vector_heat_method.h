// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Tangent vectors carried over a surface, and logarithmic maps, by the vector heat method.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_METHOD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_METHOD_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_diffusion.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Places.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A copy with enough vertices on the border that no angle opposite it is obtuse; nothing if none is obtuse already. A
// needle on the border needs as many as it is times longer than wide: beyond some for each vertex, its angles stay
// obtuse.
// \exception Cancelled_error
template <class Traits>
std::optional<Intrinsic_triangulation<Traits>>
without_obtuse_border(const Intrinsic_triangulation<Traits>& triangulation, const Interruption& interruption)
{
  if (!has_obtuse_border(triangulation))
    return std::nullopt;
  std::optional<Intrinsic_triangulation<Traits>> result(triangulation);
  const auto ask = [&interruption] {
    interruption.check();
    return true;
  };
  const std::uint64_t most = 10 * std::uint64_t(triangulation.connectivity().number_of_vertices()) + 1000;
  refine_Delaunay(*result,
                  parameters::minimum_angle(0.).splits_encroached_edges(true).maximum_number(most).visitor(ask));
  return result;
}

// An edge between two rows, over which heat flows.
struct Heat_edge
{
  std::uint32_t i, j;
  double weight;
  std::complex<double> ij, ji; // as vectors at i and at j, in the unit of the heat surface
};

// Vectors after a squared unit of time: (M + L) u = 0 except at their sources, for the connection Laplacian L.
class Vector_diffusion
{
  using Scalar = std::complex<double>;
  using Matrix = Eigen::SparseMatrix<Scalar>;
  using Vector = Eigen::VectorXcd;

public:
  // \param vectors the result of `halfedge_vectors_in_vertex()`
  // \param interruption is asked before the factorization and each solution; must outlive this
  Vector_diffusion(const Delta_complex& complex, const std::vector<std::complex<double>>& vectors,
                   const Heat_surface& surface, const Interruption& interruption)
    : interruption_(interruption),
      matrix_(with_masses(assemble_connection_Laplacian(
                            complex, vectors, [&](Edge_index e) { return (std::max)(surface.weights[e.idx()], 0.); }),
                          surface)),
      solver_(after(interruption_, matrix_), "the matrix of tangent vectors")
  {
    for (Edge_index e : complex.edges()) {
      if (surface.weights[e.idx()] == 0)
        continue;
      const Halfedge_index h = complex.halfedge(e), g = complex.opposite(h);
      const auto in_units = [&](Halfedge_index side) {
        const std::complex<double>& v = vectors[side.idx()];
        const std::size_t row = complex.source(side).idx();
        return Scalar(surface.from_input_unit(v.real(), row), surface.from_input_unit(v.imag(), row));
      };
      edges_.push_back({std::uint32_t(complex.source(h).idx()), std::uint32_t(complex.source(g).idx()),
                        surface.weights[e.idx()], in_units(h), in_units(g)});
    }
  }

  // Vectors that are passed on together with the heat of the same sources, which they never exceed.
  std::vector<Vector> spread_likewise(const Vector& vectors, const Layered_heat& heat) const
  {
    return internal::spread_likewise(
      vectors, heat, matrix_, [this](const Vector& b) { return solver_.solve(after(interruption_, b)); },
      [](Vector&, std::size_t) {});
  }

  const std::vector<Heat_edge>& edges() const { return edges_; }

private:
  const Interruption& interruption_;
  Matrix matrix_;
  Sparse_Cholesky<Scalar> solver_;
  std::vector<Heat_edge> edges_;
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
///
/// \brief parallel-transports tangent vectors from some vertices to all others along shortest paths, and computes
/// logarithmic maps.
///
///     Vector_heat_method heat(triangulation);
///     const auto parallel = heat.transport_tangent_vectors({{v, {1, 0}}});
///     const auto coordinates = heat.log_map(v);
///
/// A vector at a vertex belongs to the tangent plane of `halfedge_vectors_in_vertex()`, whose axes depend on the input
/// alone, so that results before and after flips can be compared. `vertex_frames()` gives these axes in space.
///
/// The matrices are factorized once, by the constructor. Each function then solves two or three linear systems. All are
/// const: any number of threads may call them at once.
///
/// The matrix for vectors is positive definite if no weight is negative. An intrinsic Delaunay triangulation guarantees
/// that except for border edges opposite obtuse angles. If there are any, new vertices on the border of a copy make
/// these angles smaller; results are for the vertices of the given triangulation. A weight that remains negative,
/// because doubles are too coarse for such a vertex or more than ten for each vertex would be needed, counts as zero.
///
/// Source: N. Sharp, Y. Soliman, K. Crane, "The vector heat method", 2019.
class Vector_heat_method
{
public:
  /// a tangent vector
  using Vector = std::complex<double>;

  /// \brief factorizes the matrices.
  ///
  /// The triangulation is not needed afterwards.
  /// \param triangulation a Delaunay triangulation; its traits have to use exact geometry
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{time_coefficient}
  ///     \cgalParamDescription{the time for which heat spreads, in units of the squared mean length of the edges of
  ///       each component: for longer times, the paths of the heat deviate more from the shortest ones; for shorter
  ///       times, it prefers paths along edges}
  ///     \cgalParamType{`double` or `std::optional<double>`}
  ///     \cgalParamDefault{0.05 times the cube root of the number of vertices of the component, and at least 0.5}
  ///   \cgalParamNEnd
  ///   \cgalParamVisitor{is asked before each matrix is factorized or linear system is solved, by the constructor and
  ///     by all functions, and can cancel; if several threads call member functions, any of them may call it}
  /// \cgalNamedParamsEnd
  ///
  /// \exception Invalid_argument_error if the time coefficient is not positive and finite
  /// \exception Invalid_surface_error if a length or weight is beyond the range of `double`
  /// \exception Numerical_error if a matrix cannot be factorized
  /// \exception Undecided_error as `angle()`
  /// \exception Cancelled_error if the visitor asks for it, as from all member functions
  template <class Traits, class NamedParameters = parameters::Default_named_parameters>
  explicit Vector_heat_method(const Intrinsic_triangulation<Traits>& triangulation,
                              const NamedParameters& np = parameters::default_values())
    : number_of_vertices_(triangulation.connectivity().number_of_vertices()),
      interruption_(std::make_unique<internal::Interruption>(internal::go_further_function_of(np)))
  {
    static_assert(Intrinsic_triangulation<Traits>::uses_exact_geometry,
                  "Vector_heat_method needs traits with exact geometry, as Filtered_edge_length_traits");
    const auto time_coefficient =
      internal::value_of<internal::Parameter::TIME_COEFFICIENT>(np, std::optional<double>());
    if (time_coefficient)
      internal::require_time_coefficient(*time_coefficient);
    const auto by_place = internal::with_ties_by_place(
      triangulation, internal::Row_of_vertex(triangulation.connectivity()), *interruption_);
    const Intrinsic_triangulation<Traits>& chosen = by_place ? *by_place : triangulation;
    if (const auto refined = internal::without_obtuse_border(chosen, *interruption_))
      build(*refined, time_coefficient);
    else
      build(chosen, time_coefficient);
  }

  /// returns how many vertices were inserted on the border of a copy because its opposite angles were obtuse.
  std::size_t number_of_border_vertices() const { return surface_->size() - number_of_vertices_; }

  /// \brief returns at each vertex the vector of the nearest source, parallel-transported along the shortest path.
  ///
  /// If the paths to several sources are about equally long, direction and length are averages. The field is smooth
  /// elsewhere, and vanishes where there is no mean direction.
  /// \param sources vertices, and vectors there; a vertex may not appear twice
  /// \return a vector for each vertex: the given one at the sources, and (0, 0) where no source is connected
  /// \exception Invalid_argument_error if there is no such vertex, or a coordinate is not finite
  /// \exception Numerical_error if a linear system cannot be solved
  std::vector<Vector> transport_tangent_vectors(const std::vector<std::pair<Vertex_index, Vector>>& sources) const
  {
    Eigen::VectorXcd directions = Eigen::VectorXcd::Zero(rows());
    Eigen::VectorXd heat = Eigen::VectorXd::Zero(rows()), lengths = heat;
    std::vector<std::pair<std::uint32_t, double>> from; // rows, and the lengths of the vectors there
    for (const auto& [v, vector] : sources) {
      internal::require_vertex(v, number_of_vertices_);
      const Complex z = vector;
      if (!std::isfinite(z.real()) || !std::isfinite(z.imag()))
        throw Invalid_argument_error("the vector at vertex " + std::to_string(v.idx()) + " is not finite");
      const double length = std::hypot(z.real(), z.imag());
      from.emplace_back(v.idx(), length);
      heat[v.idx()] += 1;
      lengths[v.idx()] += length;
      if (length > 0)
        directions[v.idx()] += Complex(z.real() / length, z.imag() / length);
    }
    const std::vector<bool> is_reachable = surface_->connected_with(from);
    const internal::Layered_heat spread = scalars_->spread(heat, is_reachable);
    const std::vector<Eigen::VectorXcd> vectors = vectors_->spread_likewise(directions, spread);
    // If all have the same length, as a single vector does, there is no mean to find.
    const bool are_equal =
      std::all_of(from.begin(), from.end(), [&](const auto& f) { return f.second == from.front().second; });
    const std::vector<double> length =
      are_equal ? std::vector<double>(std::size_t(rows()), from.empty() ? 0 : from.front().second)
                : scalars_->quotients(spread, lengths);
    std::vector<Vector> result;
    result.reserve(number_of_vertices_);
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      const Complex z = vectors[spread.layer_of[v]][Eigen::Index(v)];
      const double norm = std::abs(z);
      if (is_reachable[v] && norm > 0)
        result.push_back({z.real() / norm * length[v], z.imag() / norm * length[v]});
      else
        result.push_back({0, 0});
    }
    for (const auto& [v, vector] : sources)
      result[v.idx()] = vector;
    return result;
  }

  /// \brief returns a function with given values at some vertices, and elsewhere approximately the value at the nearest
  /// of these; 0 where none of them can be reached. \exception as `transport_tangent_vectors()`
  std::vector<double> extend(const std::vector<std::pair<Vertex_index, double>>& values) const
  {
    std::vector<std::pair<std::uint32_t, double>> of_rows;
    for (const auto& [v, value] : values) {
      internal::require_vertex(v, number_of_vertices_);
      of_rows.emplace_back(v.idx(), value);
    }
    std::vector<double> result = scalars_->extend(of_rows, surface_->connected_with(of_rows));
    for (const auto& [v, value] : values)
      result[v.idx()] = value;
    result.resize(number_of_vertices_);
    return result;
  }

  /// \brief returns the logarithmic map at a vertex: for each vertex, the vector in the tangent plane of `source` with
  /// the direction and the length of the shortest path to it.
  ///
  /// If the surface is flat, and all paths between two vertices give the same vector, the result is exact up to
  /// rounding. Otherwise it is an average over the paths that are about as short as the shortest one.
  /// \return a vector for each vertex, in the unit of the input: (0, 0) at the source, infinite where it is not
  ///   connected
  /// \exception Invalid_argument_error if there is no such vertex
  /// \exception Numerical_error if a linear system cannot be solved, or the time is so short that no heat arrives
  ///
  /// Source: Y. Soliman, N. Sharp, "The affine heat method", 2025. Their matrix with three rows for each vertex is
  /// triangular by blocks if positions are seen from the source: the factors for vectors and for numbers suffice.
  std::vector<Vector> log_map(Vertex_index source) const
  {
    internal::require_vertex(source, number_of_vertices_);
    const auto row = std::uint32_t(source.idx());
    const std::vector<bool> is_reachable = surface_->connected_with(internal::Pins{{row, 0}});
    Eigen::VectorXcd direction = Eigen::VectorXcd::Zero(rows());
    Eigen::VectorXd heat = Eigen::VectorXd::Zero(rows());
    direction[row] = 1;
    heat[row] = 1;
    const internal::Layered_heat spread = scalars_->spread(heat, is_reachable);
    const std::vector<Eigen::VectorXcd> axis = vectors_->spread_likewise(direction, spread);
    // Heat that crosses an edge has gone further by that edge, rotated back along the ways from the source.
    const auto add_steps = [&](Positions& right, std::size_t layer) {
      const auto turned_back = [&](const Complex& step, std::size_t l, std::uint32_t v) {
        return step * std::conj(axis[l][v]);
      };
      for (const auto& edge : vectors_->edges()) {
        const auto add = [&](std::uint32_t to, std::uint32_t from, const Complex& vector) {
          Complex step = turned_back(vector, layer, from);
          if (layer > 0 && spread.behind[layer - 1][from] && !spread.behind[layer - 1][to]) {
            const Complex before = turned_back(vector, layer - 1, from);
            step += Complex(std::ldexp(before.real(), spread.factor(layer - 1)),
                            std::ldexp(before.imag(), spread.factor(layer - 1)));
          }
          right(to, 0) += edge.weight * step.real();
          right(to, 1) += edge.weight * step.imag();
        };
        add(edge.j, edge.i, edge.ij);
        add(edge.i, edge.j, edge.ji);
      }
    };
    const std::vector<Positions> positions =
      scalars_->spread_likewise(Positions(Positions::Zero(rows(), 2)), spread, add_steps);
    std::vector<Vector> result;
    result.reserve(number_of_vertices_);
    for (std::size_t v = 0; v < number_of_vertices_; ++v) {
      const double infinite = std::numeric_limits<double>::infinity();
      if (!is_reachable[v]) {
        result.push_back({infinite, infinite});
        continue;
      }
      const Positions& p = positions[spread.layer_of[v]];
      const double x = p(Eigen::Index(v), 0) / spread[v], y = p(Eigen::Index(v), 1) / spread[v];
      if (!std::isfinite(x) || !std::isfinite(y))
        throw Numerical_error("at vertex " + std::to_string(v) + ", too little heat arrives: the time is too short");
      result.push_back({surface_->in_input_unit(x, v), surface_->in_input_unit(y, v)});
    }
    result[source.idx()] = {0, 0};
    return result;
  }

private:
  using Complex = std::complex<double>;
  using Positions = Eigen::MatrixX2d;

  template <class Traits>
  void build(const Intrinsic_triangulation<Traits>& triangulation, const std::optional<double>& time_coefficient)
  {
    internal::Heat_surface surface =
      internal::make_heat_surface(triangulation, internal::Row_of_vertex(triangulation.connectivity()));
    surface.lengthen_units(square_roots_of_times(surface.component, time_coefficient));
    surface_ = std::make_unique<const internal::Heat_surface>(std::move(surface));
    scalars_ = std::make_unique<internal::Heat_diffusion<internal::Sparse_Cholesky<>>>(*surface_, 1, *interruption_);
    vectors_ = std::make_unique<internal::Vector_diffusion>(
      triangulation.connectivity(), halfedge_vectors_in_vertex(triangulation), *surface_, *interruption_);
  }

  // Let edges be h long, on a surface of size 1, and t = c h². Spreading over a width of about √√t causes an error of
  // about √t = √c h, and the directions of edges cause one of about 1/c. Their sum is least for c proportional to
  // h^(-2/3). The factor was measured.
  static std::vector<double> square_roots_of_times(const std::vector<std::uint32_t>& component,
                                                   const std::optional<double>& coefficient)
  {
    if (coefficient)
      return std::vector<double>(component.size(), std::sqrt(*coefficient));
    std::vector<double> sizes(component.size(), 0), result;
    for (std::uint32_t c : component)
      ++sizes[c];
    result.reserve(component.size());
    for (std::uint32_t c : component)
      result.push_back(std::sqrt((std::max)(0.5, 0.05 * std::cbrt(sizes[c]))));
    return result;
  }

  Eigen::Index rows() const { return Eigen::Index(surface_->size()); }

  std::size_t number_of_vertices_;
  std::unique_ptr<const internal::Interruption> interruption_; // the solvers refer to it
  std::unique_ptr<const internal::Heat_surface> surface_;      // moving a matrix would copy it
  std::unique_ptr<const internal::Heat_diffusion<internal::Sparse_Cholesky<>>> scalars_;
  std::unique_ptr<const internal::Vector_diffusion> vectors_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_VECTOR_HEAT_METHOD_H

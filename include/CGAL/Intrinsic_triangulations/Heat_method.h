// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances on a surface, by the heat method.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_HEAT_METHOD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_HEAT_METHOD_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_bounds.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Distance_search.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_diffusion.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Pinned_system.h>
#include <CGAL/Intrinsic_triangulations/internal/distances/Places.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Ridge_keeper.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/assemble_symmetric_matrix.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Interruption.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/internal/numbers/Accurate_shapes.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <CGAL/Default.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the condition for heat at the border of a surface.
enum class Heat_boundary {
  NEUMANN,   ///< no heat leaves: isolines of the distance meet the border at right angles
  DIRICHLET, ///< the border is kept cold: isolines tend to run along it
  AVERAGED   ///< the mean of both, often the most accurate
};

namespace internal {

struct Source_corner
{
  Vertex_index vertex;
  double coordinate;
  double distance; // from the point, in the plane of the face and in the unit of the input
};

template <class Traits>
std::array<Source_corner, 3> corners_of_point(const Intrinsic_triangulation<Traits>& triangulation,
                                              const Surface_point& point)
{
  const Delta_complex& complex = triangulation.connectivity();
  const Halfedge_index h = point.halfedge;
  double sum = 0;
  bool is_valid = h.is_valid() && h.idx() < complex.number_of_halfedges() && !complex.is_border(h);
  for (double x : point.coordinates) {
    is_valid = is_valid && x >= 0 && std::isfinite(x);
    sum += x;
  }
  if (!is_valid || !(sum > 0 && std::isfinite(sum)))
    throw Invalid_point_error("a source is not a point of a face: its halfedge needs a face, and its coordinates have "
                              "to be positive or zero, and not all zero");
  const Accurate_shapes<Traits> shapes(triangulation);
  const std::array<Halfedge_index, 3> sides{h, complex.next(h), complex.prev(h)};
  std::array<double, 3> x, length; // of the side from corner i on
  for (int i = 0; i < 3; ++i) {
    x[i] = point.coordinates[i] / sum;
    length[i] = std::ldexp(shapes.length(complex.edge(sides[i])), shapes.exponent());
  }
  std::array<Source_corner, 3> result;
  for (int i = 0; i < 3; ++i) {
    // The vector from the corner is y v + z w for the sides v and w that start there.
    const double y = x[(i + 1) % 3], z = x[(i + 2) % 3], v = length[i], w = length[(i + 2) % 3],
                 opposite = length[(i + 1) % 3];
    result[i] = {complex.source(sides[i]), x[i], 0};
    const double largest = (std::max)({v, w, opposite});
    // |y v + z w|² = (y + z) (y v² + z w²) - y z (v - w)²
    const auto square = [largest](double l) { return l / largest * (l / largest); };
    result[i].distance =
      largest * std::sqrt((std::max)(0., (y + z) * (y * square(v) + z * square(w)) - y * z * square(opposite)));
  }
  return result;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
///
/// \brief distances from sources to all vertices of a surface, by the heat method.
///
///     Heat_method<> heat(triangulation);
///     heat.add_source(v);
///     std::vector<double> distances = heat.distances();
///
/// Heat spreads from the sources for a short time. Away from them its gradient has the direction of the gradient of the
/// distance. The distance is the function whose gradient fits this direction best. Where it is too flat, it is raised
/// to the smallest value that is consistent with its neighbors. It is exactly zero at each source and positive
/// elsewhere. It never exceeds the shortest path along edges and, for a surface in space, is never shorter than the
/// straight line. It is infinite in parts of the surface without a source and at vertices without faces.
///
/// The matrices are factorized once. A set of sources then costs two solutions of linear systems. Several sources in
/// one component cost a third one, and one more for each new source. Beyond 32 sources, one more factorization is
/// cheaper.
///
/// These are not exact geodesic distances: the chapter on distances in the manual gives the errors. Faces of zero area
/// are ignored. Edges by which Delaunay triangulations of one surface differ are chosen as by `geodesic_distances()`, so
/// that the numbers of vertices and faces matter only by rounding.
///
/// \tparam LinearSolver factorizes symmetric positive definite matrices; with a constructor and a member function
///   `factorize()` from an `Eigen::SparseMatrix<double>`, and `solve()` from and to an `Eigen::VectorXd`. By default
///   the sparse Cholesky factorization of Eigen, or that of CHOLMOD if `CGAL_INTRINSIC_TRIANGULATIONS_USE_CHOLMOD` is
///   defined
///
/// Source: K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat", 2013.
template <class LinearSolver = Default>
class Heat_method
{
  using Solver = typename Default::Get<LinearSolver, internal::Sparse_Cholesky<>>::type;

public:
  /// \brief factorizes the matrix of the heat equation.
  ///
  /// The triangulation is not needed afterwards. It should be Delaunay, and the angles opposite to border edges should
  /// not be obtuse: otherwise heat can be negative, and distances very inaccurate. The tufted cover has neither
  /// problem.
  /// \param triangulation the triangulation
  /// \param np an optional sequence of named parameters
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{heat_boundary}
  ///     \cgalParamDescription{the condition at the border}
  ///     \cgalParamType{`Heat_boundary`}
  ///     \cgalParamDefault{`Heat_boundary::NEUMANN`}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{time_coefficient}
  ///     \cgalParamDescription{the time for which heat spreads, in units of the squared mean length of the edges: the
  ///       larger, the smoother}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{1}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{keeps_ridges}
  ///     \cgalParamDescription{whether to raise a distance to the smallest value that is consistent with its neighbors.
  ///       Otherwise the method rounds off ridges, where fronts from several sides meet: the distance is smoother
  ///       there, and too small}
  ///     \cgalParamType{`bool`}
  ///     \cgalParamDefault{`true`}
  ///   \cgalParamNEnd
  ///   \cgalParamVisitor{is asked before each factorization or solution, by the constructor and by all functions; if it
  ///     returns `false`, they throw `Cancelled_error`. It cannot interrupt a factorization, which takes some ten
  ///     seconds with a million faces}
  /// \cgalNamedParamsEnd
  ///
  /// \exception Invalid_argument_error if the time coefficient is not positive and finite
  /// \exception Invalid_surface_error if a length or weight is beyond the range of `double`
  /// \exception Numerical_error if a matrix cannot be factorized
  /// \exception Cancelled_error if the visitor asks for it
  template <class Traits, class NamedParameters = parameters::Default_named_parameters>
  explicit Heat_method(const Intrinsic_triangulation<Traits>& triangulation,
                       const NamedParameters& np = parameters::default_values())
    : Heat_method(triangulation, internal::Row_of_vertex(triangulation.connectivity()), np)
  {}

  /// \brief as above, for any triangles. The vertices are those of the input; merged vertices have the same distance.
  ///
  /// A closed cover has no border, so all boundary conditions are the same there.
  /// \pre the cover was made Delaunay by `flip_to_Delaunay(cover.triangulation)`
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Heat_method(const Tufted_cover& cover, const NamedParameters& np = parameters::default_values())
    : Heat_method(cover.triangulation, internal::Row_of_cover_vertex(cover), np)
  {
    representative_ = cover.representative;
  }

  /// \name Sources
  /// @{

  /// makes `v` a source; returns true if it was not yet a source. \exception Invalid_argument_error if there is no such
  /// vertex
  bool add_source(Vertex_index v)
  {
    const bool is_new = vertex_sources_.insert({v, row_of(v)}).second;
    is_changed_ |= is_new;
    return is_new;
  }
  /// \brief makes a point of a face a source.
  ///
  /// Heat starts at the corners of the face, in proportion to the coordinates, and the corners get their distances in
  /// the plane of the face.
  /// \param triangulation the argument of the constructor
  /// \param point a point in a face of it; see `Point_location` for a point of the input
  /// \exception Invalid_point_error if this is not a point of a face with positive area
  template <class Traits>
  void add_source(const Intrinsic_triangulation<Traits>& triangulation, const Surface_point& point)
  {
    const auto corners = internal::corners_of_point(triangulation, point);
    for (const internal::Source_corner& corner : corners)
      row_of(corner.vertex);
    point_sources_.push_back(corners);
    is_changed_ = true;
  }
  /// \brief makes points, curves and regions of the input sources, as for `geodesic_distances_from()`.
  ///
  /// Heat starts at the corners of the faces in which they lie. These get their exact distances, and as much less heat
  /// as they are farther away. Directions are therefore less accurate near sources whose offsets differ by many edges.
  /// \param triangulation the argument of the constructor, which keeps its input
  /// \param sources the sources
  /// \exception Invalid_argument_error, Invalid_point_error, Cancelled_error, Undecided_error as
  ///   `geodesic_distances_from()`; also Invalid_argument_error by `distances()` if offsets differ so much that the heat
  ///   of some source vanishes
  template <class Traits>
  void add_sources(const Intrinsic_triangulation<Traits>& triangulation, const std::vector<Geodesic_source>& sources)
  {
    place(triangulation, internal::Row_of_vertex(triangulation.connectivity()), sources);
  }
  /// \brief as above, on a cover. \param cover the argument of the constructor
  /// \param sources points of `cover.triangulation.input()`, as given by `sources_on_cover()`
  void add_sources(const Tufted_cover& cover, const std::vector<Geodesic_source>& sources)
  {
    place(cover.triangulation, internal::Row_of_cover_vertex(cover), sources);
  }
  /// removes the source `v`; returns true if it was a source.
  bool remove_source(Vertex_index v)
  {
    const bool was_source = vertex_sources_.erase(v) > 0;
    is_changed_ |= was_source;
    return was_source;
  }
  /// removes all sources.
  void clear_sources()
  {
    vertex_sources_.clear();
    point_sources_.clear();
    placed_ = {};
    number_of_placed_ = 0;
    is_changed_ = true;
  }
  /// returns the number of sources.
  std::size_t number_of_sources() const { return vertex_sources_.size() + point_sources_.size() + number_of_placed_; }
  /// @}

  /// \brief returns the distance of each vertex from the nearest source.
  ///
  /// The result is kept until the sources change.
  /// \exception Numerical_error if a linear system cannot be solved
  /// \exception Cancelled_error if the visitor asks for it. The next call starts again
  const std::vector<double>& distances()
  {
    if (is_changed_)
      find_distances();
    is_changed_ = false;
    return distances_;
  }

  /// \brief returns a function with given values at some vertices, and elsewhere approximately the value at the nearest
  /// of these.
  ///
  /// The sources have no influence. \param values pairs of a vertex and its value
  /// \param elsewhere the value where none of the vertices can be reached
  /// Source: N. Sharp, Y. Soliman, K. Crane, "The vector heat method", 2019, section 4.
  std::vector<double> extend(const std::vector<std::pair<Vertex_index, double>>& values, double elsewhere = 0) const
  {
    std::vector<std::pair<std::uint32_t, double>> of_rows;
    for (const auto& [v, value] : values)
      of_rows.emplace_back(row_of(v), value);
    const std::vector<bool> is_reachable = surface_->connected_with(of_rows);
    const std::vector<double> quotients = diffusion_->extend(of_rows, is_reachable);
    std::vector<double> result(surface_->size(), elsewhere);
    for (std::size_t v = 0; v < result.size(); ++v)
      if (is_reachable[row_of_input(v)])
        result[v] = quotients[row_of_input(v)];
    for (const auto& [v, value] : values)
      result[v.idx()] = value;
    return result;
  }

  /// returns the number of factorizations so far.
  std::size_t number_of_factorizations() const
  {
    return diffusion_->number_of_factorizations() + (cold_border_ ? cold_border_->number_of_factorizations() : 0) +
           (poisson_ ? poisson_->number_of_factorizations() : 0);
  }
  /// \brief returns how many of the last `distances()` had to be changed by more than five percent to satisfy the
  /// bounds.
  ///
  /// If there are more than a few, the heat method is inaccurate on this surface: use `geodesic_distances()`.
  std::size_t number_of_bounded_distances() const { return number_of_bounded_distances_; }
  /// returns the mean length of the edges, in the unit of the input: how fine the triangulation is.
  double mean_edge_length() const { return std::ldexp(surface_->mean_length, surface_->exponent); }

private:
  using Diffusion = internal::Heat_diffusion<Solver>;
  using Poisson = internal::Pinned_system<Solver>;

  template <class Traits, class Row, class NamedParameters>
  Heat_method(const Intrinsic_triangulation<Traits>& triangulation, const Row& row, const NamedParameters& np)
    : boundary_(internal::value_of<internal::Parameter::HEAT_BOUNDARY>(np, Heat_boundary::NEUMANN)),
      time_coefficient_(internal::value_of<internal::Parameter::TIME_COEFFICIENT>(np, 1.)),
      keeps_ridges_(internal::value_of<internal::Parameter::KEEPS_RIDGES>(np, true)),
      interruption_(std::make_unique<internal::Interruption>(internal::go_further_function_of(np)))
  {
    internal::require_time_coefficient(time_coefficient_);
    const auto by_place = internal::with_ties_by_place(triangulation, row, *interruption_);
    const Intrinsic_triangulation<Traits>& chosen = by_place ? *by_place : triangulation;
    surface_ = std::make_unique<const internal::Heat_surface>(internal::make_heat_surface(chosen, row));
    diffusion_ = std::make_unique<Diffusion>(*surface_, time_coefficient_, *interruption_);
    bounds_.emplace(chosen, row);
  }

  std::uint32_t row_of_input(std::size_t v) const
  {
    return representative_.empty() ? std::uint32_t(v) : representative_[v];
  }
  std::uint32_t row_of(Vertex_index v) const
  {
    internal::require_vertex(v, surface_->size());
    return row_of_input(v.idx());
  }

  template <class Traits, class Row>
  void place(const Intrinsic_triangulation<Traits>& triangulation, const Row& row,
             const std::vector<Geodesic_source>& sources)
  {
    const auto go_further = [this] {
      interruption_->check();
      return true;
    };
    const internal::Distance_search<Traits, Row> search(triangulation, row,
                                                        CGAL::parameters::tolerance(0.).visitor(go_further));
    const internal::Distances_near_sources near = search.near(search.at_points(sources));
    for (const auto& [near_row, distance] : near.of_rows) {
      const auto [known, is_new] = placed_.of_rows.insert({near_row, distance});
      known->second = (std::min)(known->second, distance);
    }
    placed_.farther = (std::max)(placed_.farther, near.farther);
    number_of_placed_ += sources.size();
    is_changed_ = true;
  }

  Eigen::VectorXd zero_heat() const { return Eigen::VectorXd::Zero(Eigen::Index(surface_->size())); }

  // The distances at the sources: zero, and for points the distances of the corners of their faces.
  internal::Pins find_pins() const
  {
    internal::Pins result;
    for (const auto& source : vertex_sources_)
      result[source.second] = 0;
    const auto add = [&](std::uint32_t row, double distance) {
      const auto [pin, is_new] = result.insert({row, surface_->from_input_unit(distance, row)});
      if (!is_new)
        pin->second = (std::min)(pin->second, surface_->from_input_unit(distance, row));
    };
    for (const auto& corners : point_sources_)
      for (const internal::Source_corner& corner : corners)
        add(row_of(corner.vertex), corner.distance);
    for (const auto& [row, distance] : placed_.of_rows)
      add(row, distance);
    return result;
  }

  void find_distances()
  {
    const internal::Pins pins = find_pins();
    std::vector<bool> is_reachable(surface_->size());
    Eigen::VectorXd phi = zero_heat();
    if (!pins.empty()) {
      if (!poisson_)
        poisson_ = std::make_unique<Poisson>(surface_->stiffness, surface_->component,
                                             "the stiffness matrix with a fixed vertex in each part", *interruption_);
      is_reachable = surface_->connected_with(pins);
      phi = poisson_->solve(flux(pins, is_reachable), pins).cwiseMax(0.);
      for (const auto& [row, distance] : pins)
        phi[row] = distance;
      if (keeps_ridges_)
        internal::Ridge_keeper(*surface_, pins, is_reachable).raise(phi);
    }
    const std::vector<double> of_rows = within_bounds(phi, pins, is_reachable);
    const int half = surface_->exponent / 2;
    const double one_part = std::ldexp(1., half), other_part = std::ldexp(1., surface_->exponent - half);
    distances_.resize(surface_->size());
    for (std::size_t v = 0; v < distances_.size(); ++v)
      distances_[v] = of_rows[row_of_input(v)] * one_part * other_part;
  }

  // In the common unit of all components. What only edges of faces of zero area reach has the distance along edges.
  std::vector<double> within_bounds(const Eigen::VectorXd& phi, internal::Pins pins,
                                    const std::vector<bool>& is_reachable)
  {
    const Eigen::VectorXd before =
      phi.cwiseProduct(Eigen::Map<const Eigen::VectorXd>(surface_->units.data(), phi.size()));
    std::vector<double> result(before.begin(), before.end());
    for (std::size_t row = 0; row < result.size(); ++row)
      if (!is_reachable[row])
        result[row] = std::numeric_limits<double>::infinity();
    for (auto& pin : pins)
      pin.second *= surface_->units[pin.first];
    bounds_->apply(result, pins, std::ldexp(placed_.farther, -surface_->exponent));
    number_of_bounded_distances_ = 0;
    for (std::size_t row = 0; row < result.size(); ++row)
      number_of_bounded_distances_ +=
        is_reachable[row] && std::abs(result[row] - before[Eigen::Index(row)]) > 0.05 * result[row];
    return result;
  }

  // Heat of the sources: 1, and less at corners of a source inside a face, as it decreases with the distance. The rate
  // is that of a row of edges of mean length, where cosh(rate) = 1 + 1 / (2 t): for short times heat on a mesh
  // decreases far less than on a smooth surface, where the rate is 1 / sqrt(t), and corners with too little heat would
  // draw it from their neighbors.
  internal::Pins heat_of_sources(const internal::Pins& pins) const
  {
    std::map<std::uint32_t, double> nearest; // of each component
    for (const auto& [row, distance] : pins) {
      const auto [known, is_new] = nearest.insert({surface_->component[row], distance});
      known->second = (std::min)(known->second, distance);
    }
    const double rate = 2 * std::asinh(1 / (2 * std::sqrt(time_coefficient_)));
    internal::Pins result;
    for (const auto& [row, distance] : pins) {
      result[row] = std::exp((nearest.at(surface_->component[row]) - distance) * rate);
      if (!(result[row] > 0))
        throw Invalid_argument_error("the offsets of the sources differ by more than " +
                                     std::to_string(int(700 / rate)) +
                                     " mean edge lengths, too much for heat: use geodesic_distances_from()");
    }
    return result;
  }

  // The direction away from the sources, as its flux to each row.
  Eigen::VectorXd flux(const internal::Pins& pins, const std::vector<bool>& is_reachable)
  {
    internal::Layered_heat spread = warm_spread(pins, is_reachable);
    if (boundary_ == Heat_boundary::NEUMANN || !has_border())
      return internal::flux_of_unit_gradient(*surface_, spread, spread);
    if (!cold_border_)
      cold_border_ = std::make_unique<Diffusion>(*surface_, time_coefficient_, *interruption_, surface_->is_border);
    const internal::Layered_heat cold = cold_border_->spread(heat_of_sources(pins), is_reachable);
    if (boundary_ == Heat_boundary::DIRICHLET)
      return internal::flux_of_unit_gradient(*surface_, cold, spread);
    spread.average_with(cold);
    return internal::flux_of_unit_gradient(*surface_, spread, spread);
  }

  // The amount of heat of a single source does not matter.
  internal::Layered_heat warm_spread(const internal::Pins& pins, const std::vector<bool>& is_reachable)
  {
    if (pins.size() > 1 || boundary_ == Heat_boundary::AVERAGED)
      return diffusion_->spread(heat_of_sources(pins), is_reachable);
    Eigen::VectorXd heat = zero_heat();
    heat[pins.begin()->first] = 1;
    return diffusion_->spread(heat, is_reachable);
  }

  bool has_border() const
  {
    return std::find(surface_->is_border.begin(), surface_->is_border.end(), true) != surface_->is_border.end();
  }

  Heat_boundary boundary_;
  double time_coefficient_;
  bool keeps_ridges_;
  std::unique_ptr<const internal::Interruption> interruption_; // the solvers refer to it
  std::unique_ptr<const internal::Heat_surface> surface_;      // moving a matrix would copy it
  std::unique_ptr<Diffusion> diffusion_;
  std::unique_ptr<Diffusion> cold_border_;
  std::unique_ptr<Poisson> poisson_;
  std::optional<internal::Distance_bounds> bounds_;
  std::vector<std::uint32_t> representative_;
  std::map<Vertex_index, std::uint32_t> vertex_sources_; // with their rows
  std::vector<std::array<internal::Source_corner, 3>> point_sources_;
  internal::Distances_near_sources placed_; // in the unit of the input
  std::size_t number_of_placed_ = 0;
  bool is_changed_ = true;
  std::vector<double> distances_;
  std::size_t number_of_bounded_distances_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_HEAT_METHOD_H

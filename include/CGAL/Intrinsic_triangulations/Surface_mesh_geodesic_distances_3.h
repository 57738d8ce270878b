// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The interface of CGAL's package Heat_method_3, with the same names and parameters.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_GEODESIC_DISTANCES_3_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_GEODESIC_DISTANCES_3_H

#include <CGAL/Intrinsic_triangulations/internal/require_Eigen.h>
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/copy_face_graph.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/heat/Heat_surface.h>
#include <CGAL/Intrinsic_triangulations/internal/matrices/Sparse_Cholesky.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// A solver of CGAL, with the interface that Heat_method calls.
// \tparam LA a model of SparseLinearAlgebraWithFactorTraits_d
template <class LA>
class Solver_traits_adaptor
{
  using Matrix = Eigen::SparseMatrix<double>;
  using Index = typename LA::Index;

public:
  Solver_traits_adaptor(const Matrix& matrix, const char* what) : what_(what) { factorize(matrix); }

  void factorize(const Matrix& matrix)
  {
    matrix_ =
      std::make_unique<typename LA::Matrix>(int(matrix.rows()), int(matrix.cols())); // the solver may refer to it
    for (Eigen::Index c = 0; c < matrix.outerSize(); ++c)
      for (Matrix::InnerIterator i(matrix, c); i; ++i)
        matrix_->set_coef(Index(i.row()), Index(c), i.value(), true);
    double denominator = 1;
    if (!solver_.factor(*matrix_, denominator))
      throw Numerical_error(std::string(what_) + " cannot be factorized");
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const
  {
    typename LA::Vector b(Index(right.size())), x(Index(right.size()));
    for (Eigen::Index i = 0; i < right.size(); ++i)
      b[Index(i)] = right[i];
    if (!solver_.linear_solver(b, x))
      throw Numerical_error(std::string("a linear system cannot be solved: that of ") + what_);
    Eigen::VectorXd result(right.size());
    for (Eigen::Index i = 0; i < right.size(); ++i)
      result[i] = x[Index(i)];
    if (!result.allFinite())
      throw Numerical_error(std::string("a linear system cannot be solved: ") + what_ + " is too badly conditioned");
    return result;
  }

private:
  const char* what_;
  std::unique_ptr<typename LA::Matrix> matrix_;
  mutable LA solver_; // CGAL's solvers have no const function
};

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief the interface of CGAL's package `Heat_method_3`, on exact intrinsic Delaunay triangulations: to port a
/// program, change the include and the namespace.
namespace Heat_method_3 {

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief tag: the triangles of the mesh are used as they are.
struct Direct
{};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief tag: the intrinsic Delaunay triangulation of the mesh is used.
struct Intrinsic_Delaunay
{};

namespace internal {

// The mesh as it is: from its points, or from their distances if their coordinates are not accessible.
template <class Traits, class TriangleMesh, class VertexPointMap>
auto copy_mesh(const TriangleMesh& mesh, const VertexPointMap& map)
{
  using Point = typename boost::property_traits<VertexPointMap>::value_type;
  if constexpr (Intrinsic_triangulations::internal::Has_coordinates<Point>::value) {
    return intrinsic_triangulation(mesh, parameters::vertex_point_map(map));
  } else {
    const auto squared_distance = Traits().compute_squared_distance_3_object();
    std::vector<double> lengths;
    for (auto e : edges(mesh))
      lengths.push_back(std::sqrt(to_double(squared_distance(get(map, source(e, mesh)), get(map, target(e, mesh))))));
    return Intrinsic_triangulation<Filtered_edge_length_traits>::from_lengths(
      Intrinsic_triangulations::internal::copy_face_graph<Sequential_tag>(mesh), std::move(lengths));
  }
}

// The Delaunay triangulation of the cover of the triangles of the mesh. The ends of an edge of length zero are one
// vertex there.
template <class TriangleMesh, class VertexPointMap, class Numbers>
Tufted_cover make_Delaunay_cover(const TriangleMesh& mesh, const VertexPointMap& map, const Numbers& numbers)
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto v : vertices(mesh)) {
    const auto& p = get(map, v);
    points.push_back({to_double(p.x()), to_double(p.y()), to_double(p.z())});
  }
  for (auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    triangles.push_back(
      {get(numbers, source(h, mesh)), get(numbers, target(h, mesh)), get(numbers, target(next(h, mesh), mesh))});
  }
  Tufted_cover cover = make_tufted_cover(points, triangles);
  flip_to_Delaunay(cover.triangulation);
  return cover;
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsHeat
///
/// \brief distances of all vertices of a mesh from source vertices, with the interface of
/// `CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3`.
///
/// See `Heat_method` for the algorithm. Unlike in CGAL's class, each of several sources has distance zero,
/// distances near them are not folded, they are infinite instead of NaN where no source is connected, both modes accept
/// faces of zero area, and flips always end. Errors are exceptions. In the mode `Intrinsic_Delaunay`, the tufted cover
/// is used where there are edges of length zero, whose ends are merged, and where an angle opposite to a border edge is
/// obtuse.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Mode `Direct` or `Intrinsic_Delaunay`
/// \tparam VertexPointMap a model of `ReadablePropertyMap` from vertices to points
/// \tparam LA a model of `SparseLinearAlgebraWithFactorTraits_d`; by default, the solver of `Heat_method`
/// \tparam Traits computes distances of points that do not belong to a kernel; not needed otherwise
template <class TriangleMesh, class Mode = Direct, class VertexPointMap = Default, class LA = Default,
          class Traits = Default>
class Surface_mesh_geodesic_distances_3
{
  static_assert(std::is_same<Mode, Direct>::value || std::is_same<Mode, Intrinsic_Delaunay>::value,
                "the mode is Direct or Intrinsic_Delaunay");
  using Solver =
    std::conditional_t<std::is_same<LA, Default>::value, Intrinsic_triangulations::internal::Sparse_Cholesky<>,
                       Intrinsic_triangulations::internal::Solver_traits_adaptor<LA>>;
  using Numbers = typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<std::size_t>>::const_type;

public:
  /// a vertex of the mesh
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
  /// the sources
  using Vertex_const_range = std::set<vertex_descriptor>;
  /// the points of the vertices
  using Vertex_point_map =
    typename Default::Get<VertexPointMap, typename boost::property_map<TriangleMesh, vertex_point_t>::const_type>::type;

  /// \brief copies the mesh, flips it in the mode `Intrinsic_Delaunay`, and factorizes the matrices.
  /// \exception Invalid_surface_error, Numerical_error as `intrinsic_Delaunay_triangulation()` and `Heat_method`
  explicit Surface_mesh_geodesic_distances_3(const TriangleMesh& tm)
    : Surface_mesh_geodesic_distances_3(tm, get(vertex_point, tm))
  {}
  /// as above, with other points.
  Surface_mesh_geodesic_distances_3(const TriangleMesh& tm, Vertex_point_map vpm)
    : mesh_(tm), numbers_(get(CGAL::dynamic_vertex_property_t<std::size_t>(), tm))
  {
    std::size_t number = 0;
    for (vertex_descriptor v : vertices(mesh_))
      put(numbers_, v, number++);
    if (number == 0)
      return;
    if (std::is_same<Mode, Direct>::value)
      heat_ = std::make_unique<Heat_method<Solver>>(internal::copy_mesh<Traits>(mesh_, vpm));
    else if constexpr (has_coordinates)
      use_Delaunay_triangulation(vpm);
    else
      heat_ = std::make_unique<Heat_method<Solver>>(Delaunay_triangulation(vpm));
  }

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return mesh_; }

  /// makes `vd` a source; returns true if it was not yet a source.
  bool add_source(vertex_descriptor vd) { return sources_.insert(vd).second; }
  /// makes all vertices of a range sources.
  template <class VertexConstRange>
  void add_sources(const VertexConstRange& vrange)
  {
    for (vertex_descriptor v : vrange)
      sources_.insert(v);
  }
  /// removes the source `vd`; returns true if it was a source.
  bool remove_source(vertex_descriptor vd) { return sources_.erase(vd) == 1; }
  /// removes all sources.
  void clear_sources() { sources_.clear(); }
  /// returns the sources.
  const Vertex_const_range& sources() const { return sources_; }

  /// \brief writes the distance of each vertex from the nearest source; without sources, from the first vertex.
  /// \param vdm a model of `WritablePropertyMap` from vertices to `double`
  template <class VertexDistanceMap>
  void estimate_geodesic_distances(VertexDistanceMap vdm)
  {
    if (!heat_)
      return;
    std::set<std::size_t> wanted;
    for (vertex_descriptor v : sources_)
      wanted.insert(get(numbers_, v));
    if (wanted.empty())
      wanted.insert(0);
    if (wanted != given_) {
      heat_->clear_sources();
      for (std::size_t v : wanted)
        heat_->add_source(Vertex_index(Vertex_index::size_type(v)));
      given_ = std::move(wanted);
    }
    const std::vector<double>& distances = heat_->distances();
    for (vertex_descriptor v : vertices(mesh_))
      put(vdm, v, distances[get(numbers_, v)]);
  }

private:
  static constexpr bool has_coordinates = Intrinsic_triangulations::internal::Has_coordinates<
    typename boost::property_traits<Vertex_point_map>::value_type>::value;

  auto Delaunay_triangulation(const Vertex_point_map& vpm) const
  {
    auto result = internal::copy_mesh<Traits>(mesh_, vpm);
    flip_to_Delaunay(result);
    return result;
  }

  // Or the cover, if that triangulation does not exist or heat would be negative on it.
  void use_Delaunay_triangulation(const Vertex_point_map& vpm)
  {
    try {
      const auto triangulation = Delaunay_triangulation(vpm);
      if (!Intrinsic_triangulations::internal::has_obtuse_border(triangulation)) {
        heat_ = std::make_unique<Heat_method<Solver>>(triangulation);
        return;
      }
    } catch (const Invalid_surface_error& error) {
      if (error.defect() != Invalid_surface_error::Defect::ZERO_LENGTH_EDGE)
        throw;
    }
    heat_ = std::make_unique<Heat_method<Solver>>(internal::make_Delaunay_cover(mesh_, vpm, numbers_));
  }

  const TriangleMesh& mesh_;
  Numbers numbers_;
  std::unique_ptr<Heat_method<Solver>> heat_;
  Vertex_const_range sources_;
  std::set<std::size_t> given_; // the numbers of the sources that heat_ has
};

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief writes the distance of each vertex from a source, as `CGAL::Heat_method_3::estimate_geodesic_distances()`.
/// \param tm a triangle mesh
/// \param vdm a model of `WritablePropertyMap` from vertices to `double`
/// \param source a vertex
template <class TriangleMesh, class VertexDistanceMap, class Mode = Intrinsic_Delaunay>
void estimate_geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vdm,
                                 typename boost::graph_traits<TriangleMesh>::vertex_descriptor source, Mode = Mode())
{
  Surface_mesh_geodesic_distances_3<TriangleMesh, Mode> distances(tm);
  distances.add_source(source);
  distances.estimate_geodesic_distances(vdm);
}

/// \ingroup PkgIntrinsicTriangulationsHeat
/// \brief as above, for a range of sources.
template <class TriangleMesh, class VertexDistanceMap, class VertexConstRange, class Mode = Intrinsic_Delaunay,
          class = std::enable_if_t<boost::has_range_const_iterator<VertexConstRange>::value>>
void estimate_geodesic_distances(const TriangleMesh& tm, VertexDistanceMap vdm, const VertexConstRange& sources,
                                 Mode = Mode())
{
  Surface_mesh_geodesic_distances_3<TriangleMesh, Mode> distances(tm);
  distances.add_sources(sources);
  distances.estimate_geodesic_distances(vdm);
}

} // namespace Heat_method_3
} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SURFACE_MESH_GEODESIC_DISTANCES_3_H

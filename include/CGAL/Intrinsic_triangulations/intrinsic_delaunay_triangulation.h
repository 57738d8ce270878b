// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The front door: from a mesh to its intrinsic Delaunay triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <utility>
#include <vector>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief an intrinsic triangulation together with the report of how it was made Delaunay.
/// \tparam Traits a model of `IntrinsicTriangulationTraits`
template <class Traits>
class Intrinsic_delaunay_triangulation : public Intrinsic_triangulation<Traits>
{
public:
  using Base = Intrinsic_triangulation<Traits>;

  /// flips the edges of `triangulation` until it is Delaunay; `np` as for `flip_to_Delaunay()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  explicit Intrinsic_delaunay_triangulation(Base triangulation,
                                            const NamedParameters& np = parameters::default_values())
    : Base(std::move(triangulation)),
      report_(flip_to_Delaunay(static_cast<Base&>(*this), np))
  {}

  /// returns how the run of `flip_to_Delaunay()` went.
  const Flip_report& report() const { return report_; }

private:
  Flip_report report_;
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief copies a triangle mesh as an intrinsic triangulation, without flipping anything.
///
/// The i-th vertex, edge and face of the result are the i-th of the mesh's ranges. Named
/// parameters `vertex_point_map` and `geom_traits` as for
/// `intrinsic_delaunay_triangulation()`.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto intrinsic_triangulation(const TriangleMesh& mesh,
                             const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits = typename internal_np::Lookup_named_param_def<
    internal_np::geom_traits_t, NamedParameters, Edge_length_traits<double>>::type;
  using FT = typename Traits::FT;

  const Traits traits = choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits));
  const auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                          get_const_property_map(vertex_point, mesh));
  Delta_complex connectivity = make_Delta_complex(mesh);
  typename Intrinsic_triangulation<Traits>::Point_vector points(connectivity.number_of_vertices(),
                                                                internal::default_init);
  auto* point = points.data();
  for (typename boost::graph_traits<TriangleMesh>::vertex_descriptor v : vertices(mesh)) {
    const auto& p = get(point_map, v);
    *point++ = {internal::convert_number<FT>(p.x()), internal::convert_number<FT>(p.y()),
                internal::convert_number<FT>(p.z())};
  }
  return Intrinsic_triangulation<Traits>(std::move(connectivity), std::move(points), traits);
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief constructs the intrinsic Delaunay triangulation of a triangle mesh.
///
/// The i-th vertex, edge and face of the result are the i-th of the mesh's ranges; a flip
/// changes what an edge joins, but not its descriptor. Expected time O(size) plus O(1) a
/// flip; the number of flips is about linear in practice.
///
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam NamedParameters a sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices, of any kernel}
///     \cgalParamType{a model of `ReadablePropertyMap` from vertex descriptors to points with `x()`, `y()`, `z()`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{the traits, which fix number type and formulas}
///     \cgalParamType{a model of `IntrinsicTriangulationTraits`}
///     \cgalParamDefault{`Edge_length_traits<double>`}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map, visitor, maximum_number}
///     \cgalParamDescription{as for `flip_to_Delaunay()`; edges are given by `Edge_index`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the triangulation, whose `report()` says how the algorithm ended
///
/// \exception Invalid_surface_error if a face is not a triangle, a coordinate is not
///   finite, or an edge has length zero
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.2.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto intrinsic_delaunay_triangulation(const TriangleMesh& mesh,
                                      const NamedParameters& np = parameters::default_values())
{
  auto triangulation = intrinsic_triangulation(mesh, np);
  using Traits = typename decltype(triangulation)::Traits;
  return Intrinsic_delaunay_triangulation<Traits>(std::move(triangulation), np);
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H

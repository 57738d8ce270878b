// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// From a mesh, or from points and triangles, to the intrinsic Delaunay triangulation.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_conversion.h>
#include <CGAL/Intrinsic_triangulations/internal/arithmetic/number_kinds.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/Delta_complex_builder.h>
#include <CGAL/Intrinsic_triangulations/internal/connectivity/copy_face_graph.h>
#include <CGAL/Intrinsic_triangulations/internal/engine/metric/Rational_points.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>
#include <CGAL/Intrinsic_triangulations/internal/system/for_each_block.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/range/has_range_iterator.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief an intrinsic triangulation, and the report of the flips.
///
///     const auto [idt, report] = intrinsic_Delaunay_triangulation(mesh);
///
/// \tparam Traits a model of `IntrinsicTriangulationTraits`
template <class Traits>
struct Triangulation_and_report
{
  Intrinsic_triangulation<Traits> triangulation; ///< the triangulation, valid whatever the report says
  Flip_report report;                            ///< the report of `flip_to_Delaunay()`
};

namespace internal {

// Points and triangles are ranges; a mesh and named parameters are not.
template <class... Ranges>
using If_ranges = std::enable_if_t<(boost::has_range_const_iterator<Ranges>::value && ...)>;
template <class T>
using If_no_range = std::enable_if_t<!boost::has_range_const_iterator<T>::value>;

// The metric exactly, or nothing if all coordinates are doubles, or not all finite.
// \param elements the elements that have points
// \param coordinates_of returns three numbers for each
template <class ElementRange, class CoordinatesOf>
std::optional<Input_metric> rational_metric(const ElementRange& elements, const CoordinatesOf& coordinates_of,
                                            const Delta_complex& connectivity)
{
  Rational_points points;
  for (const auto& element : elements) {
    const auto& p = coordinates_of(element);
    if (!CGAL::is_finite(p[0]) || !CGAL::is_finite(p[1]) || !CGAL::is_finite(p[2]))
      return std::nullopt;
    for (int i = 0; i < 3; ++i)
      points.add(p[i]);
  }
  if (points.are_doubles())
    return std::nullopt;
  return points.metric(connectivity);
}

// The number type of the coordinates p[0], p[1] and p[2], in place of a kernel.
template <class PointRange>
struct Kernel_of_coordinates
{
  using FT = std::decay_t<decltype((*std::begin(std::declval<const PointRange&>()))[0])>;
};

// A flag for each edge, as a property map.
struct Edge_flags
{
  using key_type = Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  friend bool get(const Edge_flags& map, Edge_index e) { return map.flags[e.idx()]; }

  std::vector<bool> flags;
};

template <class T, class = void>
struct Has_coordinates : std::false_type
{};
template <class T>
struct Has_coordinates<
  T, std::void_t<decltype(std::declval<const T&>().x(), std::declval<const T&>().y(), std::declval<const T&>().z())>>
  : std::true_type
{};

// The constraints on the edges of a mesh, for the edges of its copy.
template <class TriangleMesh, class NamedParameters>
auto constraints_of_copy(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr (!has_edge_constraints<NamedParameters>) {
    return Static_boolean_property_map<Edge_index, false>();
  } else {
    const auto& is_constrained = parameters::get_parameter(np, internal_np::edge_is_constrained);
    using Map = std::decay_t<decltype(is_constrained)>;
    using Edge = typename boost::graph_traits<TriangleMesh>::edge_descriptor;
    static_assert(std::is_convertible<Edge, typename boost::property_traits<Map>::key_type>::value,
                  "edge_is_constrained_map: its keys have to be the edges of the mesh, not those of the triangulation");
    Edge_flags result;
    result.flags.reserve(num_edges(mesh));
    for (Edge e : edges(mesh))
      result.flags.push_back(get(is_constrained, e));
    return result;
  }
}

// A triangulation after its flips.
template <class ConcurrencyTag, class Traits, class ConstraintMap, class NamedParameters>
Triangulation_and_report<Traits> flipped(Intrinsic_triangulation<Traits> triangulation,
                                         const ConstraintMap& is_constrained, const NamedParameters& np)
{
  const Flip_report report = flip_to_Delaunay_with<ConcurrencyTag>(triangulation, is_constrained, np);
  return {std::move(triangulation), report};
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the default traits for points of a kernel:
/// `Filtered_edge_length_traits`, which requires rational coordinates, or `Edge_length_traits` over
/// the number type of the kernel if that is exact and has square roots.
template <class Kernel>
using Default_intrinsic_triangulation_traits =
  std::conditional_t<Algebraic_structure_traits<typename Kernel::FT>::Is_exact::value &&
                       std::is_convertible<typename Algebraic_structure_traits<typename Kernel::FT>::Algebraic_category,
                                           Field_with_sqrt_tag>::value,
                     Edge_length_traits<typename Kernel::FT>, Filtered_edge_length_traits>;

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief copies a triangle mesh as an intrinsic triangulation, without flipping anything.
///
/// The i-th vertex, edge and face of the result are the i-th of the mesh's ranges. `ConcurrencyTag` and the
/// named parameters `vertex_point_map` and `geom_traits` are as for
/// `intrinsic_Delaunay_triangulation()`. O(size).
/// \param mesh the mesh
/// \param np an optional sequence of named parameters
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters, class = internal::If_no_range<NamedParameters>>
auto intrinsic_triangulation(const TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const auto point_map =
    choose_parameter(get_parameter(np, internal_np::vertex_point), get_const_property_map(vertex_point, mesh));
  using Point = typename boost::property_traits<std::decay_t<decltype(point_map)>>::value_type;
  static_assert(internal::Has_coordinates<Point>::value,
                "vertex_point_map: its values have to be points of CGAL, with x(), y() and z()");
  using Kernel = typename Kernel_traits<Point>::Kernel;
  using Traits = typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                              Default_intrinsic_triangulation_traits<Kernel>>::type;
  using Triangulation = Intrinsic_triangulation<Traits>;
  const Traits traits = choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits));

  if constexpr (Triangulation::uses_exact_geometry && !internal::is_machine_number<typename Kernel::FT>) {
    static_assert(
      !std::is_same<Default_intrinsic_triangulation_traits<Kernel>, Edge_length_traits<typename Kernel::FT>>::value,
      "exact geometry needs points with rational coordinates");
    Delta_complex connectivity = internal::copy_face_graph<ConcurrencyTag>(mesh);
    const auto coordinates_of = [&point_map](auto v) {
      const auto& p = get(point_map, v);
      using FT = typename Kernel::FT;
      return std::array<FT, 3>{FT(p.x()), FT(p.y()), FT(p.z())};
    };
    std::optional<Input_metric> metric = internal::rational_metric(vertices(mesh), coordinates_of, connectivity);
    if (metric) { // some coordinate is not a double
      internal::check_triangles(connectivity);
      return Triangulation::from_metric(std::move(connectivity), std::move(*metric), traits);
    }
  }
  internal::Face_graph_copier<TriangleMesh> copier(mesh);
  Delta_complex connectivity = copier.template copy_vertices<ConcurrencyTag>();
  typename Triangulation::Point_vector points(connectivity.number_of_vertices(), internal::default_init);
  internal::for_each_element<ConcurrencyTag>(
    vertices(mesh), points.size(), [&](std::size_t first, std::size_t, auto v, auto end) {
      for (auto* point = points.data() + first; v != end; ++v, ++point) {
        const auto vertex = *v; // lives as long as p, which may refer to it
        const auto& p = get(point_map, vertex);
        using FT = typename Traits::FT;
        *point = {internal::convert_number<FT>(p.x()), internal::convert_number<FT>(p.y()),
                  internal::convert_number<FT>(p.z())};
      }
      return true;
    });
  return Triangulation(std::move(connectivity), std::move(points), traits, ConcurrencyTag(), copier);
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief constructs the intrinsic Delaunay triangulation of a triangle mesh.
///
/// The i-th vertex, edge and face of the result are the i-th of the mesh's ranges; a flip
/// changes the end vertices of an edge, but not its descriptor. Expected time: O(size) plus O(1) per
/// flip; in practice the number of flips is about linear.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`: as for
///   `flip_to_Delaunay()`; the mesh is copied by several threads if its iterators have random access
/// \tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param mesh the mesh, which is not changed
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices, of any kernel}
///     \cgalParamType{a model of `ReadablePropertyMap` from vertex descriptors to points with `x()`, `y()`, `z()`}
///     \cgalParamDefault{`get_const_property_map(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{the traits, which determine number type and formulas}
///     \cgalParamType{a model of `IntrinsicTriangulationTraits`}
///     \cgalParamDefault{`Default_intrinsic_triangulation_traits`: exact decisions}
///   \cgalParamNEnd
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges of the mesh must not be flipped}
///     \cgalParamType{a model of `ReadablePropertyMap` with `boost::graph_traits<TriangleMesh>::%edge_descriptor` as
///       key type and `bool` as value type}
///     \cgalParamDefault{no edge is constrained}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor, tie_proof, maximum_number}
///     \cgalParamDescription{as for `flip_to_Delaunay()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the triangulation, and the report, whose `status` is `Flip_status::DELAUNAY` if the triangulation is
///   Delaunay. With the default traits it is, unless the flip budget ended the algorithm
///
/// \exception Invalid_surface_error if a face is not a triangle, a coordinate is not
///   finite, or an edge has length zero
///
/// Source: Fisher, Springborn, Schroeder, Bobenko (2006), section 2.2.
template <class ConcurrencyTag = Sequential_tag, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters, class = internal::If_no_range<NamedParameters>>
auto intrinsic_Delaunay_triangulation(const TriangleMesh& mesh,
                                      const NamedParameters& np = parameters::default_values())
{
  return internal::flipped<ConcurrencyTag>(intrinsic_triangulation<ConcurrencyTag>(mesh, np),
                                           internal::constraints_of_copy(mesh, np), np);
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief builds an intrinsic triangulation from points and triangles, without flipping anything.
///
/// Vertices, edges and faces are numbered as by `make_Delta_complex_from_triangles()`. `ConcurrencyTag`, points,
/// triangles, the named parameter `geom_traits` and the exceptions are as for `intrinsic_Delaunay_triangulation()`.
/// O(size).
/// \param points, triangles, np as for `intrinsic_Delaunay_triangulation()`
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          class = internal::If_ranges<PointRange, TriangleRange>>
auto intrinsic_triangulation(const PointRange& points, const TriangleRange& triangles,
                             const NamedParameters& np = parameters::default_values())
{
  using Kernel = internal::Kernel_of_coordinates<PointRange>;
  using Traits = typename internal_np::Lookup_named_param_def<internal_np::geom_traits_t, NamedParameters,
                                                              Default_intrinsic_triangulation_traits<Kernel>>::type;
  using Triangulation = Intrinsic_triangulation<Traits>;
  const Traits traits = parameters::choose_parameter<Traits>(parameters::get_parameter(np, internal_np::geom_traits));

  const std::size_t number_of_vertices = std::size_t(std::distance(std::begin(points), std::end(points)));
  Delta_complex connectivity = internal::Delta_complex_builder::from_triangles(number_of_vertices, triangles);
  if constexpr (Triangulation::uses_exact_geometry && !internal::is_machine_number<typename Kernel::FT>) {
    const auto coordinates_of = [](const auto& p) -> const auto& { return p; };
    std::optional<Input_metric> metric = internal::rational_metric(points, coordinates_of, connectivity);
    if (metric) // some coordinate is not a double
      return Triangulation::from_metric(std::move(connectivity), std::move(*metric), traits);
  }
  return Triangulation(std::move(connectivity), points, traits, ConcurrencyTag());
}

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief constructs the intrinsic Delaunay triangulation of a surface given by points and triangles.
///
/// No mesh is built in between. Vertices and faces keep their numbers; edges are numbered by their first appearance
/// around the faces, see `make_Delta_complex_from_triangles()`. Time as for a mesh, plus the search for the two faces
/// at each edge, which is linear as well.
///
/// \tparam ConcurrencyTag as for a mesh; the connectivity is built by one thread
/// \tparam PointRange a model of `ForwardRange`, of points whose coordinates are `p[0]`, `p[1]` and `p[2]`: points of a
///   kernel, or arrays of numbers
/// \tparam TriangleRange a model of `ForwardRange`, of random access ranges of three integers each
///
/// \param points the vertices; vertices without triangles become isolated vertices
/// \param triangles the faces, as indices into `points`
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{the traits, which determine number type and formulas}
///     \cgalParamType{a model of `IntrinsicTriangulationTraits`}
///     \cgalParamDefault{`Default_intrinsic_triangulation_traits` for the number type of the coordinates: exact
///       decisions}
///   \cgalParamNEnd
///   \cgalParamConstraints{which edges must not be flipped}
///   \cgalParamNBegin{visitor, tie_proof, maximum_number}
///     \cgalParamDescription{as for `flip_to_Delaunay()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return as for a mesh
///
/// \exception Invalid_surface_error if the triangles are not an oriented surface, with the face, edge or vertex at
///   fault, as `make_Delta_complex_from_triangles()` does; if a coordinate is not finite, or an edge has length zero.
///   `examine_polygons()` lists all defects, and `repair_polygons()` repairs them
template <class ConcurrencyTag = Sequential_tag, class PointRange, class TriangleRange,
          class NamedParameters = parameters::Default_named_parameters,
          class = internal::If_ranges<PointRange, TriangleRange>>
auto intrinsic_Delaunay_triangulation(const PointRange& points, const TriangleRange& triangles,
                                      const NamedParameters& np = parameters::default_values())
{
  return internal::flipped<ConcurrencyTag>(intrinsic_triangulation<ConcurrencyTag>(points, triangles, np),
                                           internal::edge_constraints_of(np), np);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTRINSIC_DELAUNAY_TRIANGULATION_H

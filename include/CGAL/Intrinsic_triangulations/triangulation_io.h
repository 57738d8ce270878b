// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Files that hold a triangulation with its input.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_IO_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_IO_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/internal/saving/Saved_file.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/tags.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <functional>
#include <istream>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief as `write_triangulation()`, but keeps the order in which the corners of the input faces were given, because
/// flips may have changed `input().halfedge(f)`.
/// \param os, triangulation, np as for `write_triangulation()`
/// \param first_sides for each input face, the halfedge from its first to its second corner; empty for
///   `input().halfedge(f)`
/// \pre `input().face(first_sides[f]) == f`
template <class NamedParameters = parameters::Default_named_parameters>
void write_triangulation(std::ostream& os, const Intrinsic_triangulation<Filtered_edge_length_traits>& triangulation,
                         const std::vector<Halfedge_index>& first_sides,
                         const NamedParameters& np = parameters::default_values())
{
  using parameters::get_parameter;
  std::vector<bool> is_constrained;
  if constexpr (internal::has_edge_constraints<NamedParameters>) {
    const auto map = internal::edge_constraints_of(np);
    for (Edge_index e : triangulation.connectivity().edges())
      is_constrained.push_back(get(map, e));
  }
  const internal::Stored_numbers numbers{first_sides, [&](Edge_index e) { return triangulation.edge_data(e); },
                                         [&](Face_index f) {
                                           const Bounded_area& area = triangulation.face_data(f);
                                           return std::array<double, 2>{area.value, area.error};
                                         }};
  internal::write_saved_file(os, internal::engine(triangulation), triangulation.stage_counts(), numbers, is_constrained,
                             internal::go_further_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsIO
///
/// \brief writes a triangulation and its input, from which `read_triangulation()` restores the same triangulation.
///
/// The file is a binary PLY file of the input, with additional elements for the triangulation. If the input has points,
/// other programs read it as a mesh. The page "Saved triangulations" describes each byte.
///
/// \tparam NamedParameters a sequence of named parameters
/// \param os a stream opened in binary mode; check its state afterwards
/// \param triangulation the triangulation
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that tells which edges are constrained, to be written, too}
///     \cgalParamType{a model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{no constraints are written}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is asked from time to time whether to continue}
///     \cgalParamType{a model of `IntrinsicTriangulationVisitor`, or a function that returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Undecided_error if an edge crosses more than 2<sup>20</sup> input edges: no reader could lay it out
/// \exception Cancelled_error if the visitor asks for it
/// \exception Integer_overflow_error if an edge crosses more than 2<sup>60</sup> input edges. O(size).
template <class NamedParameters = parameters::Default_named_parameters>
void write_triangulation(std::ostream& os, const Intrinsic_triangulation<Filtered_edge_length_traits>& triangulation,
                         const NamedParameters& np = parameters::default_values())
{
  write_triangulation(os, triangulation, std::vector<Halfedge_index>(), np);
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief as above, for the triangulation of a common subdivision, from which the same subdivision can be built. Stored
/// numbers are not written; the reader computes the true ones.
/// \param os, first_sides, np as above
/// \param subdivision the subdivision
template <class NamedParameters = parameters::Default_named_parameters>
void write_triangulation(std::ostream& os, const Common_subdivision& subdivision,
                         const std::vector<Halfedge_index>& first_sides = {},
                         const NamedParameters& np = parameters::default_values())
{
  const internal::Exact_engine& engine = internal::engine(subdivision);
  // A subdivision keeps no numbers of the traits: without bounds, a reader replaces them by true ones.
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const internal::Stored_numbers numbers{
    first_sides, [](Edge_index) { return unknown; },
    [](Face_index) {
      return std::array<double, 2>{unknown, std::numeric_limits<double>::infinity()};
    },
    false};
  internal::write_saved_file(os, engine, engine.decisions().counts, numbers, {}, internal::go_further_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsIO
///
/// \brief reads a triangulation written by `write_triangulation()`.
///
/// The result has the same descriptors, and every query returns the same bits. You can continue to flip, insert and
/// remove.
///
/// The file is not trusted. Connectivity, integers, inserted vertices and numbers are checked against each other and
/// against the input, by exact layouts. So whatever the bytes are, the result is a triangulation of the input surface.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` (with TBB) or `Parallel_if_available_tag`, for the checks
/// \tparam NamedParameters a sequence of named parameters
/// \param is a stream opened in binary mode. Nothing is read beyond the triangulation
/// \param np an optional sequence of named parameters among those listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_is_constrained_map}
///     \cgalParamDescription{a property map that receives whether each edge is constrained, if the file says so}
///     \cgalParamType{a model of `WritablePropertyMap` with `Edge_index` as key type and `bool` as value type}
///     \cgalParamDefault{constraints in the file are ignored}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is asked from time to time whether to continue}
///     \cgalParamType{a model of `IntrinsicTriangulationVisitor`, or a function that returns `bool`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \exception Invalid_surface_error with the defect `UNREADABLE` and the byte or element at fault, or with another one
///   if the input is not a surface
/// \exception Cancelled_error if the visitor asks for it
///
/// Time: O(size + number of crossings). Memory: proportional to the bytes read, whatever the header says.
template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
Intrinsic_triangulation<Filtered_edge_length_traits>
read_triangulation(std::istream& is, const NamedParameters& np = parameters::default_values())
{
  using Triangulation = Intrinsic_triangulation<Filtered_edge_length_traits>;
  using parameters::get_parameter;
  const std::function<bool()> go_further = internal::go_further_function_of(np);
  internal::Saved_file file = internal::read_saved_file(is, go_further);
  using internal::Metric_kind;
  Triangulation result =
    file.metric_kind == Metric_kind::POINTS
      ? Triangulation(std::move(file.input), std::move(file.points), Filtered_edge_length_traits(), ConcurrencyTag())
    : file.metric_kind == Metric_kind::LENGTHS
      ? Triangulation::from_lengths(std::move(file.input), std::move(file.lengths))
      : Triangulation::from_metric(std::move(file.input), std::move(file.metric));
  {
    const internal::Interruption_scope<Triangulation> scope(result, go_further);
    internal::Whole_triangulation<Filtered_edge_length_traits> whole(result);
    whole.restore<ConcurrencyTag>(std::move(file.triangulation));
    whole.count_as_tested(file.counts[Stage::FILTER]);
    file.counts.decided[std::size_t(Stage::FILTER)] = 0;
    whole.engine().decisions().counts = file.counts;
    whole.engine().decisions().tie_proof = file.tie_proof;
  }
  if constexpr (internal::has_edge_constraints<NamedParameters>) {
    const auto map = get_parameter(np, internal_np::edge_is_constrained);
    for (std::uint32_t e = 0; e < file.is_constrained.size(); ++e)
      put(map, Edge_index(e), bool(file.is_constrained[e]));
  }
  return result;
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief as `write_triangulation()`, for the name of a file.
/// \param file_name the name of the file
/// \param triangulation, np as for a stream
/// \exception Error if it cannot be written; an incomplete file is not removed
template <class NamedParameters = parameters::Default_named_parameters>
void write_triangulation(const std::string& file_name,
                         const Intrinsic_triangulation<Filtered_edge_length_traits>& triangulation,
                         const NamedParameters& np = parameters::default_values())
{
  std::ofstream os(file_name, std::ios::binary);
  write_triangulation(os, triangulation, np);
  if (!os.flush())
    throw Error(file_name + ": cannot be written");
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief as `read_triangulation()`, for the name of a file, with which messages begin. Nothing may follow the
/// triangulation.
/// \param file_name the name of the file
/// \param np as for a stream
template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
Intrinsic_triangulation<Filtered_edge_length_traits>
read_triangulation(const std::string& file_name, const NamedParameters& np = parameters::default_values())
{
  using Defect = Invalid_surface_error::Defect;
  try {
    std::ifstream is(file_name, std::ios::binary);
    if (!is)
      throw Invalid_surface_error(Defect::UNREADABLE, 0, 1, "cannot be opened");
    Intrinsic_triangulation<Filtered_edge_length_traits> result = read_triangulation<ConcurrencyTag>(is, np);
    if (is.peek() != std::ifstream::traits_type::eof())
      throw Invalid_surface_error(Defect::UNREADABLE, 0, 1, "there are bytes behind the triangulation");
    return result;
  } catch (const Invalid_surface_error& e) {
    throw Invalid_surface_error(e.defect(), e.element(), e.count(), file_name + ": " + e.what());
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_IO_H

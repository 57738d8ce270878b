// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Delaunay refinement.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Delaunay_refiner.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/bent_parts.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Measured_faces.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/Segments_by_size.h>
#include <CGAL/Intrinsic_triangulations/internal/insertion/point_on_input.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Standard_arithmetic.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/tags.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Asks the observer of a refinement during the flips before it.
template <class Observer>
struct Flips_before_refinement
{
  using Is_silent = typename Observer::Is_silent;
  Observer& observer;

  bool go_further(std::uint64_t tests, std::uint64_t flips) { return observer.go_further(tests, flips); }
  void after_flip(Edge_index) {}
};

// Runs with a smallest size.
template <class Traits, class Observer>
struct Refinement_run
{
  struct Result
  {
    Refinement_report report;
    std::uint64_t number_of_close_vertices;
    double cost; // the new vertices, and ten for each face that is left
  };

  Intrinsic_triangulation<Traits>& triangulation;
  Refinement_criteria criteria;
  const Segments_by_size& segments;
  Observer& observer;
  const std::uint64_t maximum_number;
  const std::vector<bool>& is_whole;
  const std::uint64_t most_estimated; // vertices
  std::vector<bool> is_segment = {};
  std::uint64_t flips_before = 0;

  // Makes the triangulation Delaunay but for the segments.
  void flip()
  {
    is_segment = segments(engine(triangulation), criteria.minimum_size);
    Flips_before_refinement<Observer> before{observer};
    const auto is_constrained =
      boost::make_function_property_map<Edge_index, bool>([this](Edge_index e) { return bool(is_segment[e.idx()]); });
    flips_before = flip_all<Sequential_tag>(Whole_triangulation<Traits>(triangulation), is_constrained, before,
                                            (std::numeric_limits<std::uint64_t>::max)())
                     .flips;
  }

  Result operator()(const Refinement_trial& trial)
  {
    Delaunay_refiner<Traits, Observer> refiner(triangulation, criteria, is_segment, is_whole, observer, maximum_number,
                                               trial);
    std::optional<Interruption_scope<Intrinsic_triangulation<Traits>>> scope;
    if constexpr (!Observer::Is_silent::value)
      scope.emplace(triangulation, [&refiner] { return refiner.asks_further(); });
    Result result{refiner(most_estimated), refiner.number_of_close_vertices(),
                  (std::numeric_limits<double>::infinity)()};
    Refinement_report& report = result.report;
    report.flips += flips_before;
    if (!refiner.is_given_up() && report.status == Refinement_status::REFINED)
      result.cost = double(report.insertions + report.segment_splits) + 10. * double(report.unrefined.size());
    return result;
  }
};

template <class Traits>
bool has_faces_below(Intrinsic_triangulation<Traits>& triangulation, double height)
{
  Measured_faces<Traits> faces(triangulation);
  faces.measure_all();
  const auto all = triangulation.connectivity().faces();
  return std::any_of(all.begin(), all.end(), [&](Face_index f) { return faces.smallest_height(f) < height; });
}

// Chooses the smallest size, as `refine_Delaunay()` says.
// \param start before the first flips, if the segments depend on the size
template <class Traits, class Observer>
Refinement_report refine_by_trial(Refinement_run<Traits, Observer>& run,
                                  std::optional<Intrinsic_triangulation<Traits>> start)
{
  using Triangulation = Intrinsic_triangulation<Traits>;
  // The first is 8 units in the last place of a float as large as the extent.
  Triangulation& triangulation = run.triangulation;
  const double unit = extent(engine(triangulation));
  std::vector<int> levels = {-21, -20, -17, -14};
  // Triangles that follow a curve, or are wanted, may be that small.
  const auto& criteria = run.criteria;
  double smallest =
    (std::min)({criteria.maximum_deviation, criteria.maximum_edge_length, criteria.maximum_circumradius});
  for (double size : criteria.sizes)
    smallest = (std::min)(smallest, size);
  while (!levels.empty() && std::ldexp(unit, levels.back()) > smallest / 16)
    levels.pop_back();
  if (levels.empty())
    return run({}).report;
  const std::uint32_t n = triangulation.connectivity().number_of_vertices();
  Refinement_trial trial{std::ldexp(unit, levels.back()), 10000 + std::uint64_t(n)};
  if (!has_faces_below(triangulation, 8 * trial.size)) // so such vertices are unlikely
    return run({}).report;
  if (!start)
    start = triangulation;
  // The function that can interrupt a decision stays.
  const auto replace = [&](Triangulation other) {
    std::function<bool()> interruption = triangulation.set_interruption({});
    Triangulation before = std::exchange(triangulation, std::move(other));
    triangulation.set_interruption(std::move(interruption));
    return before;
  };
  const auto tell_insertions = [&] {
    for (std::uint32_t v = n; v < triangulation.connectivity().number_of_vertices(); ++v)
      run.observer.after_insertion(Vertex_index(v));
  };
  try {
    std::optional<Triangulation> best;
    std::optional<typename Refinement_run<Traits, Observer>::Result> best_result;
    for (std::size_t i = 0;; ++i) {
      if (i == levels.size())
        trial.maximum_number = (std::numeric_limits<std::uint64_t>::max)();
      auto result = run(trial);
      const std::uint64_t points = result.report.insertions + result.report.segment_splits;
      // Without a size, only what takes unusually many vertices leaves faces instead.
      const bool is_last = i == levels.size() || result.number_of_close_vertices <= 100 + (n + points) / 50 ||
                           (i == 0 && std::isfinite(result.cost) && points <= 4 * std::uint64_t(n));
      if (!best_result || result.cost < best_result->cost || !std::isfinite(best_result->cost)) {
        best_result = std::move(result);
        if (!is_last)
          best = replace(*start);
      } else {
        replace(is_last ? std::move(*best) : *start);
      }
      if (is_last)
        break;
      run.criteria.minimum_size = std::ldexp(unit, levels[i]);
      if (run.segments.depend_on_size())
        run.flip();
    }
    tell_insertions();
    return std::move(best_result->report);
  } catch (...) {
    tell_insertions();
    throw;
  }
}

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsInsertion
/// \brief flips edges until the triangulation is Delaunay, and inserts vertices until no triangle is too thin or too
/// large.
///
/// A triangle that is too large gets a vertex at its circumcenter. For one with a small angle, twelve points that see
/// its shortest side at a large enough angle are tried, and the one that leaves the fewest bad triangles is taken; a
/// straight walk over the triangles finds its place. Small angles at the shortest sides come first, then the largest
/// triangles. A border edge or constrained edge that is in the way, or that the vertex would encroach on, is split
/// instead. The positions of the new vertices are chosen in doubles; all consequences are exact, as in
/// `insert_vertex()`: the metric does not change, and after each insertion all edges that are not constrained are
/// Delaunay.
///
/// No vertex is inserted for a face with a side shorter than the smallest size, nor for a lower one unless it is too
/// long. If none is given, refinement begins with 0. CAD programs leave slivers, sheets and tubes by mistake that need
/// many vertices: if more than four for each vertex are needed, and many come closer to each other than 2^-14 of the
/// longest side of the bounding box (or of the longest edge of a surface without points), refinement begins anew with
/// 2^-21, 2^-20, 2^-17 and 2^-14 of it in turn. The result is the run with the fewest vertices and the fewest faces
/// left; the report has its size.
///
/// A vertex inside the surface whose angles sum to less than 60 degrees gets one neighbor close to it, and the triangle
/// between them is kept. Two edges that are not flipped and form a corner of less than 60 degrees are split at powers
/// of two.
///
/// \tparam Traits traits with exact geometry
/// \param triangulation a triangulation that keeps its input
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamConstraints{which edges must not be flipped. They have to coincide with input edges. It is read only at
///     the beginning; the parts of a split edge are constrained, too}
///   \cgalParamNBegin{sharp_edge_angle}
///     \cgalParamDescription{edges of the input at which the directions of the faces differ by more than this angle in
///       degrees must not be flipped, either: see `sharp_edges()`, with the smallest size. The surface has to have
///       points}
///     \cgalParamType{`double` from 0 to 180, or `std::optional<double>`}
///     \cgalParamDefault{no such edges}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_angle}
///     \cgalParamDescription{the minimum angle of all corners, in degrees}
///     \cgalParamType{`double`, at most 30}
///     \cgalParamDefault{25}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_circumradius, maximum_edge_length}
///     \cgalParamDescription{the maximum circumradius and the maximum edge length, in the unit of the input}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_deviation}
///     \cgalParamDescription{how far the straight triangle between the corners of a face may be from the surface, in
///       the unit of the input: see `straight_mesh()`. Folds that few triangles could follow otherwise are kept, as if
///       they were constrained, except near small corners between them. Faces whose straight triangles have an angle
///       below 15 degrees are refined, too, unless they are smaller than that distance}
///     \cgalParamType{`double`}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{whole_edges_map}
///     \cgalParamDescription{which edges must neither be flipped nor split, of the border or inside. Vertices may come
///       closer to them than to others, but not so close that a triangle there gets a smaller angle than
///       `minimum_angle` and than before. Faces that would need a vertex on such an edge are listed}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `Edge_index` as key type and `bool` as value type,
///       which is read only at the beginning}
///     \cgalParamDefault{no such edges}
///   \cgalParamNEnd
///   \cgalParamNBegin{size_map}
///     \cgalParamDescription{how long edges may be at each vertex of the input, in its unit. Sizes are linear on the
///       faces of the input, and an edge may be as long as the mean of those at its ends}
///     \cgalParamType{a class model of `ReadablePropertyMap` with `Vertex_index` as key type and `double` as value
///       type; positive, or infinite}
///     \cgalParamDefault{infinity}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_normal_angle}
///     \cgalParamDescription{edges may be as long as the way on which the normal of the surface turns by this angle in
///       degrees, but 2^-12 of the extent at least. This adds to `size_map`. Edges say how much the surface is bent
///       unless they are not flipped, or sharper than `sharp_edge_angle`. The surface has to have points}
///     \cgalParamType{`double`, positive, or `std::optional<double>`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{size_gradation}
///     \cgalParamDescription{by how much sizes may grow along edges of the input, as a part of their lengths; larger
///       ones are lowered}
///     \cgalParamType{`double`, positive}
///     \cgalParamDefault{0.3}
///   \cgalParamNEnd
///   \cgalParamNBegin{splits_encroached_edges}
///     \cgalParamDescription{whether to first split edges that are not flipped until no angle opposite to them is
///       obtuse, even if no face needs it. Then no cotangent weight of the border is negative}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_size}
///     \cgalParamDescription{no vertex is inserted for a face with a side or a height shorter than this, in the unit of
///       the input, so refinement ends early at irrelevantly thin sheets, tubes or slivers}
///     \cgalParamType{`double`, not negative, or `std::optional<double>`}
///     \cgalParamDefault{chosen as above}
///   \cgalParamNEnd
///   \cgalParamVisitor{is called before each step and within long ones, with the numbers of new vertices and of flips
///     so far. (Before the first new vertex, edges are flipped until the triangulation is Delaunay.) `before_step()` is
///     called for each step, and `after_insertion()` for each new vertex; pass `std::ref()` to keep its state. Where
///     refinement may begin anew, `after_insertion()` is called at its end, for the vertices of the result}
///   \cgalParamNBegin{maximum_number}
///     \cgalParamDescription{the maximum number of new vertices}
///     \cgalParamType{`std::uint64_t`}
///     \cgalParamDefault{ten for each vertex, and a million. Then refinement does not begin if lengths of edges need
///       more, judged by areas}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return the report. The triangulation is Delaunay
/// \exception Invalid_argument_error if the minimum angle is more than 30 degrees, the minimum size is negative, or the
///   angle of sharp edges is out of range, the surface has no points for them, or one was flipped before; or if the
///   maximum deviation, a size or a gradation is not positive, or the surface has no points for it
/// \exception Too_many_vertices_error as the default of `maximum_number` says
/// \exception Cancelled_error if the visitor asks for it, or as `insert_vertex()`
/// \exception Integer_overflow_error, Undecided_error as `insert_vertex()`. The triangulation is valid after any
///   exception, and another call continues
///
/// Source: J. Ruppert, "A Delaunay refinement algorithm for quality 2-dimensional mesh generation" (1995); A. Ungor,
/// "Off-centers: a new type of Steiner points for computing size-optimal quality-guaranteed Delaunay triangulations"
/// (2009); H. Erten, A. Ungor, "Quality triangulations with locally optimal Steiner points" (2009); on surfaces,
/// N. Sharp, Y. Soliman, K. Crane, "Navigating intrinsic triangulations" (2019).
template <class Traits, class NamedParameters = parameters::Default_named_parameters>
Refinement_report refine_Delaunay(Intrinsic_triangulation<Traits>& triangulation,
                                  const NamedParameters& np = parameters::default_values())
{
  using internal::Parameter;
  using internal::value_of;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  internal::Refinement_criteria criteria;
  criteria.minimum_angle = value_of<Parameter::MINIMUM_ANGLE>(np, criteria.minimum_angle);
  criteria.maximum_circumradius = value_of<Parameter::MAXIMUM_CIRCUMRADIUS>(np, criteria.maximum_circumradius);
  criteria.maximum_edge_length = value_of<Parameter::MAXIMUM_EDGE_LENGTH>(np, criteria.maximum_edge_length);
  criteria.maximum_deviation = value_of<Parameter::MAXIMUM_DEVIATION>(np, criteria.maximum_deviation);
  criteria.splits_encroached_edges = value_of<Parameter::SPLITS_ENCROACHED_EDGES>(np, criteria.splits_encroached_edges);
  const auto minimum_size = value_of<Parameter::MINIMUM_SIZE>(np, std::optional<double>());
  criteria.minimum_size = minimum_size.value_or(0);
  if (!(criteria.minimum_angle <= 30 && criteria.minimum_size >= 0 && criteria.maximum_deviation > 0))
    throw Invalid_argument_error("the minimum angle of a refinement has to be at most 30 degrees, the minimum size at "
                                 "least 0, and the maximum deviation larger than 0");
  const auto is_constrained = internal::edge_constraints_of(np);
  const auto is_whole_edge = internal::marked_edges_of(np, internal::Parameter_tag<Parameter::WHOLE_EDGES_MAP>());
  const internal::Standard_arithmetic arithmetic;
  const Delta_complex& complex = triangulation.connectivity();
  std::vector<bool> is_segment(complex.number_of_edges());
  std::vector<bool> is_whole(complex.number_of_edges());
  for (Edge_index e : complex.edges()) {
    is_whole[e.idx()] = get(is_whole_edge, e);
    is_segment[e.idx()] = complex.is_border(e) || is_whole[e.idx()] || get(is_constrained, e);
  }
  internal::Wanted_sizes sizes;
  if constexpr (!parameters::is_default_parameter<NamedParameters,
                                                  internal::Parameter_tag<Parameter::SIZE_MAP>>::value) {
    const auto size_map = get_parameter(np, internal::Parameter_tag<Parameter::SIZE_MAP>());
    for (Vertex_index v : triangulation.input().vertices())
      sizes.given.push_back(get(size_map, v));
  }
  sizes.normal_angle = value_of<Parameter::MAXIMUM_NORMAL_ANGLE>(np, sizes.normal_angle);
  sizes.gradation = value_of<Parameter::SIZE_GRADATION>(np, sizes.gradation);
  sizes.sharp_edge_angle =
    value_of<Parameter::SHARP_EDGE_ANGLE>(np, std::optional<double>()).value_or(sizes.sharp_edge_angle);
  criteria.sizes = internal::sizes_of_input(internal::engine(triangulation), std::move(sizes), is_segment);
  auto observer = internal::observer_of(np);
  const std::uint32_t number_of_given_vertices = complex.number_of_vertices();
  const auto given_maximum = std::optional<std::uint64_t>(
    choose_parameter(get_parameter(np, internal_np::maximum_number), std::optional<std::uint64_t>()));
  const std::uint64_t default_maximum = 10 * std::uint64_t(number_of_given_vertices) + 1000000;
  std::uint64_t maximum = given_maximum.value_or(default_maximum);
  if (std::isfinite(criteria.maximum_deviation))
    internal::keep_bent_parts(triangulation, criteria.maximum_deviation, maximum, is_segment);
  for (std::uint32_t v = number_of_given_vertices; v < complex.number_of_vertices(); ++v)
    observer.after_insertion(Vertex_index(v));
  const std::uint32_t number_of_vertices_on_folds = complex.number_of_vertices() - number_of_given_vertices;
  maximum -= number_of_vertices_on_folds;
  const internal::Segments_by_size segments(internal::engine(triangulation), std::move(is_segment),
                                            value_of<Parameter::SHARP_EDGE_ANGLE>(np, std::optional<double>()));
  internal::Refinement_run<Traits, decltype(observer)> run{triangulation,
                                                           criteria,
                                                           segments,
                                                           observer,
                                                           maximum,
                                                           is_whole,
                                                           given_maximum ? (std::numeric_limits<std::uint64_t>::max)()
                                                                         : default_maximum};
  std::optional<Intrinsic_triangulation<Traits>> start;
  if (segments.depend_on_size() && !minimum_size)
    start = triangulation;
  run.flip();
  Refinement_report report = minimum_size ? run({}).report : internal::refine_by_trial(run, std::move(start));
  report.segment_splits += number_of_vertices_on_folds;
  return report;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_REFINE_DELAUNAY_H

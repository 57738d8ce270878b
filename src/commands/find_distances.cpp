// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/find_distances.h"

#include "commands/commands.h"
#include "commands/distance_sources.h"
#include "commands/distance_ways.h"
#include "input/Surface.h"
#include "input/Triangle_soup.h"
#include "input/gluing_file.h"
#include "input/repair.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"
#include "number_types/make_triangulation.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "view/View.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace idt {
namespace {

using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;

struct Refinement_watch
{
  bool go_further(const IT::Progress& done)
  {
    progress.show_points(done.insertions, refinement.waiting_faces, refinement.size);
    return !is_interrupted();
  }
  void before_step(const IT::Refinement_progress& step) { refinement = step; }
  Progress& progress;
  IT::Refinement_progress refinement = {};
};

void set_number_of_vertices(const Distance_options& options, std::size_t n, Distance_result& result)
{
  const auto require_vertices = [n](const char* option, const std::vector<std::uint64_t>& vertices) {
    for (std::uint64_t v : vertices)
      if (v >= n)
        throw Usage_error(option + std::string(": there is no vertex ") + std::to_string(v) + ": the input has " +
                          std::to_string(n) + ", counted from 0");
  };
  require_vertices("--source", options.sources.vertices);
  require_vertices("--target", options.targets);
  result.number_of_vertices = n;
}

std::vector<IT::Vertex_index> to_vertices(const std::vector<std::uint64_t>& numbers)
{
  std::vector<IT::Vertex_index> result;
  for (std::uint64_t v : numbers)
    result.push_back(IT::Vertex_index(IT::Vertex_index::size_type(v)));
  return result;
}

// Takes the sources, and remembers for the report and the view where they lie.
std::vector<IT::Geodesic_source> keep_places(Placed_sources placed, Distance_result& result)
{
  result.largest_snap = placed.largest_snap;
  result.source_points = std::move(placed.points);
  result.source_curves = std::move(placed.curves);
  return std::move(placed.sources);
}

// What needs no more than ways: the vertices of the labels and samples are those of the input.
template <class Any_surface>
void find_by_ways(const Distance_options& options, const Any_surface& surface, const Ways_from& from,
                  Progress& progress, Distance_result& result)
{
  Distance_finder<Any_surface> finder(options, surface, from, progress, result);
  if (!options.is_by_heat() && !options.maximum_change)
    finder.follow_ways();
  if (options.is_compared)
    finder.compare();
  if (!options.samples_path.empty()) {
    progress.begin("choosing vertices");
    result.samples =
      IT::farthest_vertices(surface, from.places, options.number_of_samples, geodesic_options(options.tolerance()));
  }
}

// The first axis of the tangent plane of each source, transported to the vertices nearest to it; and for a single
// source the logarithmic map.
// \param points of the vertices of its input; empty if there are only lengths
void find_vectors(const std::vector<IT::Vertex_index>& sources, const Triangulation& triangulation,
                  const Points& points, Distance_result& result)
{
  const std::size_t n = triangulation.input().number_of_vertices();
  const IT::Vector_heat_method heat(triangulation, CGAL::parameters::visitor([] { return !is_interrupted(); }));
  std::vector<std::pair<IT::Vertex_index, std::complex<double>>> axes;
  for (IT::Vertex_index v : std::set<IT::Vertex_index>(sources.begin(), sources.end()))
    axes.push_back({v, {1, 0}});
  const auto transported = heat.transport_tangent_vectors(axes);
  Named_values axis{"axis", {}, points.empty() ? std::size_t(2) : std::size_t(3)};
  const auto frames = points.empty() ? std::vector<IT::Vertex_frame>() : IT::vertex_frames(triangulation, points);
  for (std::size_t v = 0; v < n; ++v) {
    const std::complex<double>& z = transported[v];
    const std::array<double, 3> vector =
      points.empty() ? std::array<double, 3>{z.real(), z.imag(), 0} : frames[v].in_space(z);
    axis.values.insert(axis.values.end(), vector.begin(), vector.begin() + std::ptrdiff_t(axis.components));
  }
  result.vectors.push_back(std::move(axis));
  if (axes.size() > 1)
    return;
  Named_values log{"log", {}, 2};
  const auto map = heat.log_map(axes.front().first);
  for (std::size_t v = 0; v < n; ++v)
    log.values.insert(log.values.end(), {map[v].real(), map[v].imag()});
  result.vectors.push_back(std::move(log));
}

// Any triangles: heat on their tufted cover, straight ways on sheets of them.
// \param make_cover makes a cover of the given kind
// \param place_on places the sources on it
template <class Make_cover, class Place_on>
void find_on_cover(const Distance_options& options, const Make_cover& make_cover, const Place_on& place_on,
                   Progress& progress, Distance_result& result)
{
  const auto with = [&](IT::Surface_cover kind, const auto& find) {
    progress.begin("covering");
    Stopwatch stopwatch;
    IT::Tufted_cover cover = make_cover(kind);
    result.nonmanifold_edges = cover.report.nonmanifold_edges;
    result.flips += IT::flip_to_Delaunay(cover.triangulation, CGAL::parameters::visitor(std::ref(progress))).flips;
    result.triangulation_seconds += stopwatch.restart();
    Ways_from from{to_vertices(options.sources.vertices), {}};
    if (options.has_places()) {
      progress.begin("placing the sources");
      from.places = keep_places(place_on(cover), result);
    }
    find(cover, from);
    result.distance_seconds += stopwatch.seconds();
  };
  if (options.is_by_heat())
    with(IT::Surface_cover::TUFTED, [&](const IT::Tufted_cover& cover, const Ways_from& from) {
      Distance_finder<IT::Tufted_cover>(options, cover, from, progress, result).find_by_heat();
    });
  if (!options.is_by_heat() || options.is_compared)
    with(IT::Surface_cover::SHEETS, [&](const IT::Tufted_cover& cover, const Ways_from& from) {
      if (options.matrix_path.empty())
        find_by_ways(options, cover, from, progress, result);
      else
        result.distances = Distance_finder<IT::Tufted_cover>(options, cover, from, progress, result)
                             .find_matrix(to_vertices(options.targets));
    });
}

void find_on_cover(const Distance_options& options, Distance_result& result)
{
  const Stopwatch stopwatch;
  if (is_gluing_file(options.input)) {
    Progress progress(options.input, "reading");
    const IT::Exact_gluing gluing = read_gluing_file(options.input, std::ref(progress));
    set_number_of_vertices(options, gluing.complex.number_of_vertices(), result);
    result.read_seconds = stopwatch.seconds();
    find_on_cover(
      options,
      [&gluing](IT::Surface_cover kind) {
        return IT::make_tufted_cover(gluing.complex, gluing.lengths, CGAL::parameters::surface_cover(kind));
      },
      [&](const IT::Tufted_cover& cover) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        for (IT::Face_index f : gluing.complex.faces()) {
          const IT::Halfedge_index h = gluing.complex.halfedge(f);
          triangles.push_back({gluing.complex.source(h).idx(), gluing.complex.target(h).idx(),
                               gluing.complex.target(gluing.complex.next(h)).idx()});
        }
        return place_sources(options.sources, cover, {}, triangles);
      },
      progress, result);
  } else {
    Triangle_soup soup = read_triangle_soup(options.input);
    check_view(options.view_path, soup.triangles.size());
    set_number_of_vertices(options, soup.points.size(), result);
    result.read_seconds = stopwatch.seconds();
    Progress progress(options.input, "covering");
    find_on_cover(
      options,
      [&soup](IT::Surface_cover kind) {
        return IT::make_tufted_cover(soup.points, soup.triangles, CGAL::parameters::surface_cover(kind));
      },
      [&](const IT::Tufted_cover& cover) { return place_sources(options.sources, cover, soup.points, soup.triangles); },
      progress, result);
    result.points = std::move(soup.points);
    result.triangles = std::move(soup.triangles);
    result.warnings = std::move(soup.warnings);
  }
}

// An oriented surface, which is cut open along the barriers if there are any.
class Surface_finder
{
public:
  // \param options, result must outlive this
  Surface_finder(const Distance_options& options, Distance_result& result)
    : options_(options), result_(result), surface_(loaded(options, result)), progress_(options.input, "triangulating"),
      triangulation_(first_triangulation<Triangulation::Traits>(surface_)), input_(triangulation_.input())
  {}

  void find()
  {
    triangulate();
    result_.triangulation_seconds = stopwatch_.restart();
    if (options_.matrix_path.empty())
      find_distances();
    else
      find_matrix();
    result_.distance_seconds = stopwatch_.seconds();
    for (IT::Face_index f : surface_.connectivity.faces()) {
      const IT::Halfedge_index h = surface_.connectivity.halfedge(f);
      result_.triangles.push_back({surface_.connectivity.source(h).idx(), surface_.connectivity.target(h).idx(),
                                   surface_.connectivity.target(surface_.connectivity.next(h)).idx()});
    }
    result_.points = std::move(surface_.points);
    result_.warnings = std::move(surface_.warnings);
    result_.cuts = cuts_text(repairs(surface_));
  }

private:
  static Surface loaded(const Distance_options& options, Distance_result& result)
  {
    const Stopwatch stopwatch;
    Surface surface = load_surface(options.input, options.repair);
    set_number_of_vertices(options, surface.connectivity.number_of_vertices(), result);
    check_view(options.view_path, surface.connectivity.number_of_faces());
    result.read_seconds = stopwatch.seconds();
    return surface;
  }

  // Makes the triangulation on which ways are followed, and places the sources.
  void triangulate()
  {
    const bool has_view = !options_.view_path.empty();
    if (has_view && !options_.has_barriers())
      result_.input_numbers = surface_.saved ? IT::element_numbers(make_triangulation<Triangulation::Traits>(surface_))
                                             : IT::element_numbers(triangulation_);
    flip();
    if (options_.has_barriers()) {
      cut_open();
      if (has_view)
        result_.input_numbers = IT::element_numbers(triangulation_);
      flip();
    }
    if (options_.is_refined)
      refine();
    if (has_view)
      result_.numbers = IT::element_numbers(triangulation_);
    if (has_view || !options_.overlay_path.empty()) {
      progress_.begin("overlay");
      result_.subdivision.emplace(triangulation_);
    }
    from_.vertices = with_copies(to_vertices(options_.sources.vertices));
    if (options_.has_places() && !cut_) {
      progress_.begin("placing the sources");
      of_input_ = keep_places(place_sources(options_.sources, triangulation_, surface_.points), result_);
      from_.places = of_input_;
    }
  }

  void flip()
  {
    result_.flips += IT::flip_to_Delaunay(triangulation_, CGAL::parameters::visitor(std::ref(progress_))).flips;
  }

  void cut_open()
  {
    progress_.begin("placing the sources and the barriers");
    of_input_ = keep_places(place_sources(options_.sources, triangulation_, surface_.points), result_);
    cut_.emplace(place_barriers(options_.barriers, triangulation_, surface_.points, result_.largest_snap));
    for (std::uint64_t v : options_.sources.vertices)
      if (options_.has_vectors && with_copies(to_vertices({v})).size() > 1)
        throw Usage_error("--vectors: vertex " + std::to_string(v) +
                          " lies on a barrier, where each side has its own tangent plane: choose another source");
    triangulation_ = Triangulation(cut_->connectivity(), cut_->points());
    from_.places = cut_->sources(of_input_);
    result_.cut_points = cut_->points();
  }

  void refine()
  {
    triangulation_.set_interruption([] { return !is_interrupted(); }); // a single decision can take long
    const IT::Refinement_report refinement =
      IT::refine_Delaunay(triangulation_, CGAL::parameters::visitor(Refinement_watch{progress_}));
    result_.flips += refinement.flips;
    result_.number_of_inserted_vertices =
      triangulation_.connectivity().number_of_vertices() - triangulation_.input().number_of_vertices();
  }

  // With the vertices on the other sides of barriers.
  std::vector<IT::Vertex_index> with_copies(const std::vector<IT::Vertex_index>& vertices) const
  {
    if (!cut_)
      return vertices;
    std::vector<IT::Vertex_index> result;
    for (IT::Vertex_index v : vertices)
      for (IT::Vertex_index copy : cut_->copies(v))
        result.push_back(copy);
    return result;
  }

  void find_distances()
  {
    if (options_.is_by_heat())
      Distance_finder<Triangulation>(options_, triangulation_, from_, progress_, result_).find_by_heat();
    if (options_.maximum_change)
      find_by_simplification();
    find_by_ways(options_, triangulation_, from_, progress_, result_);
    if (options_.is_signed)
      set_signs();
    if (options_.lines.are_wanted())
      find_lines_on_input();
    if (result_.subdivision)
      result_.overlay_distances.values = IT::interpolate_intrinsic_values(*result_.subdivision, result_.distances);
    if (options_.has_vectors) {
      progress_.begin("factoring and solving for vectors");
      find_vectors(from_.vertices, triangulation_, cut_ ? cut_->points() : surface_.points, result_);
    }
    keep_vertices_of_input();
  }

  // The distances with their intervals, by way of fewer vertices.
  void find_by_simplification()
  {
    progress_.begin("simplifying");
    const IT::Simplified_surface simplified = IT::simplify_surface(
      triangulation_,
      CGAL::parameters::maximum_change(*options_.maximum_change).visitor([&](double done) { return progress_(done); }));
    result_.change = IT::Metric_change{simplified.shrink, simplified.stretch};
    result_.number_of_simplified_vertices = simplified.kept.size();
    progress_.begin("following all straight ways");
    IT::Distance_intervals found =
      IT::Simplified_distances(simplified).from(from_.vertices, CGAL::parameters::visitor([] {
                                                  return !is_interrupted();
                                                }));
    result_.distances = std::move(found.distances);
    result_.vectors.push_back({"lower", std::move(found.lower)});
    result_.vectors.push_back({"upper", std::move(found.upper)});
  }

  // Its parts.
  std::vector<std::vector<IT::Surface_point>> curve() const
  {
    std::vector<std::vector<IT::Surface_point>> result;
    for (const IT::Geodesic_source& source : of_input_)
      result.push_back(source.parts.front());
    return result;
  }

  std::vector<CGAL::Sign> sides_of_curve() const
  {
    try {
      return IT::sides_of_curve(input_, curve());
    } catch (const IT::Invalid_argument_error& error) {
      throw IT::Invalid_argument_error(options_.sources.curve_path + ": " + error.what());
    } catch (const IT::Invalid_point_error& error) {
      throw IT::Invalid_point_error(options_.sources.curve_path + ": " + error.what());
    }
  }

  // Distances become positive to the left of the curve, and negative to its right.
  void set_signs()
  {
    std::vector<CGAL::Sign> signs = sides_of_curve();
    if (cut_) {
      std::vector<IT::Surface_point> points;
      for (std::size_t v = signs.size(); v < cut_->points().size(); ++v)
        points.push_back(IT::source_at_vertex(cut_->connectivity(), IT::Vertex_index(IT::Vertex_index::size_type(v)))
                           .parts.front()
                           .front());
      const std::vector<CGAL::Sign> others = IT::sides_of_curve(input_, curve(), cut_->on_input(points));
      signs.insert(signs.end(), others.begin(), others.end());
    }
    for (std::size_t v = 0; v < signs.size(); ++v)
      if (signs[v] == CGAL::NEGATIVE && result_.distances[v] > 0)
        result_.distances[v] = -result_.distances[v];
  }

  void find_lines_on_input()
  {
    progress_.begin("following lines");
    const double largest = result_.largest_distance();
    result_.lines = find_lines(options_.lines, triangulation_, from_.places, options_.tolerance(), largest);
    result_.lines.input = input_;
    if (cut_)
      for (std::optional<IT::Surface_lines>* found : {&result_.lines.isolines, &result_.lines.borders})
        if (*found)
          for (IT::Surface_line& line : (*found)->lines)
            line.points = cut_->on_input(line.points);
    if (options_.is_signed)
      result_.lines.set_signs(curve());
    result_.lines.keep_wanted(options_.lines, options_.is_signed, result_.distances);
  }

  // A vertex on a barrier has what is found on its nearer side.
  void keep_vertices_of_input()
  {
    std::vector<std::size_t> kept(input_.number_of_vertices());
    std::iota(kept.begin(), kept.end(), std::size_t(0));
    if (cut_)
      for (std::size_t& v : kept)
        for (IT::Vertex_index copy : cut_->copies(IT::Vertex_index(IT::Vertex_index::size_type(v))))
          if (std::abs(result_.distances[copy.idx()]) < std::abs(result_.distances[v]))
            v = copy.idx();
    const auto keep = [&kept](auto& values, std::size_t components) {
      std::remove_reference_t<decltype(values)> of_input;
      for (std::size_t v : kept)
        for (std::size_t i = 0; i < components; ++i)
          of_input.push_back(values[components * v + i]);
      values = std::move(of_input);
    };
    keep(result_.distances, 1);
    if (!result_.nearest_sources.empty())
      keep(result_.nearest_sources, 1);
    for (Named_values& vectors : result_.vectors)
      keep(vectors.values, vectors.components);
  }

  // Between the nearer sides of vertices on barriers.
  void find_matrix()
  {
    const std::vector<IT::Vertex_index> rows = to_vertices(options_.sources.vertices),
                                        columns = to_vertices(options_.targets);
    const std::vector<double> found =
      Distance_finder<Triangulation>(options_, triangulation_, from_, progress_, result_)
        .find_matrix(with_copies(columns));
    result_.distances.assign(rows.size() * columns.size(), std::numeric_limits<double>::infinity());
    auto next = found.begin();
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t k = with_copies({rows[r]}).size(); k > 0; --k)
        for (std::size_t c = 0; c < columns.size(); ++c)
          for (std::size_t i = with_copies({columns[c]}).size(); i > 0; --i, ++next) {
            double& known = result_.distances[r * columns.size() + c];
            known = (std::min)(known, *next);
          }
  }

  const Distance_options& options_;
  Distance_result& result_;
  Surface surface_;
  Stopwatch stopwatch_;
  Progress progress_;
  Triangulation triangulation_; // on which ways are followed
  IT::Delta_complex input_;
  std::optional<IT::Surface_with_barriers> cut_; // with barriers, the input of the triangulation
  std::vector<IT::Geodesic_source> of_input_;    // with places, the sources before the input was cut
  Ways_from from_;
};

} // namespace

Distance_result find_distances(const Distance_options& options)
{
  Distance_result result;
  if (options.cover == "tufted" && !is_saved_triangulation(readable_file(options.input)))
    find_on_cover(options, result);
  else
    Surface_finder(options, result).find();
  return result;
}

} // namespace idt

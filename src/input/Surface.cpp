// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/Surface.h"

#include "system/Exit_status.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"
#include "system/text.h"
#include "input/Triangle_soup.h"
#include "input/gluing_file.h"
#include "input/read_surface.h"
#include "input/repair.h"
#include "input/saved_triangulation.h"
#include "input/standard_input.h"

#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/system/Disjoint_sets.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/repair_polygons.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// The remedy for gaps.
std::string stitching_advice(const IT::Surface_report& report, const Repair_options& options)
{
  if (options.stitching_tolerance && *options.stitching_tolerance >= report.stitching_tolerance)
    return "it was left so";
  return "--repair --stitch " + in_short(report.stitching_tolerance) + " joins them";
}

// \exception Invalid_surface_error that names the defect, and the option that would help unless it was given
[[noreturn]] void refuse(const IT::Surface_report& report, const std::string& path, bool is_repaired)
{
  const IT::Finding& finding = *report.first_fatal();
  std::optional<std::string> advice;
  if (!is_repaired && IT::is_repairable(finding.defect))
    advice = "use --repair to fix what can be fixed";
  const std::string text = IT::message(report, path, advice);
  throw IT::Invalid_surface_error(finding.defect, finding.elements.empty() ? 0 : finding.elements.front(),
                                  finding.count, text);
}

// \param soup as of load_surface()
void load_mesh(Surface& surface, const Repair_options& repair_options, std::optional<Triangle_soup>* soup)
{
  Stopwatch stopwatch;
  Surface_input input = read_and_warn(surface.path);
  surface.warnings = input.warnings;
  surface.read_seconds = stopwatch.restart();
  const bool is_repaired = repair_options.is_wanted;
  if (is_repaired)
    surface.repair = repair(input, repair_options.stitching_tolerance);

  // Building already examines the faces. The full examination is needed only if there is something to report.
  const auto build = [&] {
    surface.connectivity = IT::make_Delta_complex_from_triangles(input.points.size(), input.triangles);
  };
  bool is_built = false;
  try {
    if (input.is_triangulated()) {
      const Progress progress(surface.path, "checking");
      build();
      is_built = true;
    }
  } catch (const IT::Invalid_surface_error&) {
  }
  if (!is_built || !IT::is_clean(surface.connectivity, input.points)) {
    const IT::Surface_report report = [&] {
      const Progress progress(surface.path, "checking");
      return examine(input);
    }();
    if (const IT::Finding* fatal = report.first_fatal()) {
      if (soup == nullptr || is_repaired || !IT::is_repairable(fatal->defect))
        refuse(report, surface.path, is_repaired);
      *soup = to_triangle_soup(std::move(input));
      surface.warnings = (*soup)->warnings;
      return;
    }
    using Defect = IT::Invalid_surface_error::Defect;
    for (Defect defect : {Defect::DEGENERATE_FACE, Defect::UNREFERENCED_VERTEX})
      if (const IT::Finding* finding = report.find(defect))
        surface.notes.push_back(IT::message(*finding));
    surface.warnings.insert(surface.warnings.end(), surface.notes.begin(), surface.notes.end());
    for (std::string& warning : gap_warnings(report, surface.path, stitching_advice(report, repair_options)))
      surface.warnings.push_back(std::move(warning));
    if (!is_built)
      build();
  }
  surface.points = std::move(input.points);
  surface.build_seconds = stopwatch.restart();
}

void load_gluing(Surface& surface)
{
  const Stopwatch stopwatch;
  Progress progress(surface.path, "reading");
  IT::Exact_gluing gluing = read_gluing_file(surface.path, std::ref(progress));
  surface.connectivity = std::move(gluing.complex);
  surface.squared_lengths = std::move(gluing.squared_lengths);
  surface.lengths = std::move(gluing.lengths);
  surface.read_seconds = stopwatch.seconds();
  if (surface.connectivity.number_of_faces() == 0)
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::EMPTY, 0, 1,
                                    surface.path + ": there is no face");
}

std::vector<double> lengths_of(const Surface& surface)
{
  if (!surface.has_points())
    return surface.lengths;
  std::vector<double> lengths;
  lengths.reserve(surface.connectivity.number_of_edges());
  for (IT::Edge_index e : surface.connectivity.edges()) {
    const IT::Halfedge_index h = surface.connectivity.halfedge(e);
    const auto &p = surface.points[surface.connectivity.source(h).idx()],
               &q = surface.points[surface.connectivity.target(h).idx()];
    lengths.push_back(std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]));
  }
  return lengths;
}

} // namespace

std::vector<std::string> gap_warnings(const IT::Surface_report& report, const std::string& path,
                                      const std::string& advice)
{
  std::vector<std::string> warnings;
  for (const IT::Gap& gap : report.gaps) {
    warnings.push_back(IT::message(gap, advice));
    std::cerr << "idt: " << path << ": warning: " << warnings.back() << std::endl;
  }
  return warnings;
}

Surface load_surface(const std::string& path, const Repair_options& repair_options,
                     const std::optional<Mollification_options>& mollification, std::optional<Triangle_soup>* soup)
{
  Surface surface;
  surface.path = path;
  const bool is_repaired = repair_options.is_wanted;
  if (is_gluing_file(path) && is_repaired)
    throw Usage_error(path + ": --repair is for meshes; there is nothing to repair in a gluing");
  const bool is_saved = is_saved_triangulation(readable_file(path));
  if (is_saved && (is_repaired || mollification))
    throw Usage_error(path + ": --repair and --mollify are for meshes; a saved triangulation has a surface already");
  if (is_saved)
    load_saved_triangulation(surface);
  else if (is_gluing_file(path))
    load_gluing(surface);
  else
    load_mesh(surface, repair_options, soup);
  if (!mollification)
    return surface;

  const Stopwatch stopwatch;
  std::vector<double> lengths = lengths_of(surface);
  try {
    surface.mollification = (mollification->is_local ? IT::mollify_lengths_locally : IT::mollify_lengths)(
      surface.connectivity, lengths, mollification->delta);
  } catch (const IT::Invalid_surface_error& error) {
    throw IT::Invalid_surface_error(error.defect(), error.element(), error.count(), path + ": " + error.what());
  }
  // Points contain more than rounded lengths, so they are kept as long as they are valid.
  if (surface.mollification->number_of_changed_edges > 0) {
    surface.lengths = std::move(lengths);
    surface.squared_lengths.clear();
    surface.points.clear();
  }
  surface.build_seconds += stopwatch.seconds();
  return surface;
}

void untwist(Surface& surface)
{
  if (surface.has_points())
    throw Usage_error(surface.path +
                      ": --fast-forward is for gluings; no edge of a surface in space winds around it very often");
  if (surface.saved)
    throw Usage_error(surface.path + ": --fast-forward is for gluings; this triangulation was made of one already");
  const Stopwatch stopwatch;
  if (surface.squared_lengths.empty())
    surface.squared_lengths = IT::squared_lengths(surface.lengths);
  surface.untwisting = IT::untwist(surface.connectivity, surface.squared_lengths,
                                   CGAL::parameters::visitor([] { return !is_interrupted(); }));
  surface.lengths = rounded_lengths(surface.squared_lengths);
  surface.untwist_seconds = stopwatch.seconds();
}

Surface_counts count_elements(const IT::Delta_complex& complex)
{
  Surface_counts counts;
  counts.vertices = complex.number_of_vertices();
  counts.edges = complex.number_of_edges();
  counts.faces = complex.number_of_faces();

  IT::internal::Disjoint_sets pieces(counts.vertices);
  // The larger ends of edges, grouped by their smaller ends.
  std::vector<std::uint32_t> ends(counts.edges), last(counts.vertices + 1, 0);
  const auto for_each_edge_of_two_vertices = [&](const auto& function) {
    for (IT::Edge_index e : complex.edges()) {
      const IT::Halfedge_index h = complex.halfedge(e);
      const std::uint32_t v = complex.source(h).idx(), w = complex.target(h).idx();
      if (v != w)
        function((std::min)(v, w), (std::max)(v, w));
    }
  };
  for_each_edge_of_two_vertices([&](std::uint32_t v, std::uint32_t w) {
    pieces.unite(v, w);
    ++last[v + 1];
  });
  std::partial_sum(last.begin(), last.end(), last.begin());
  counts.loops = counts.edges - last.back();
  for_each_edge_of_two_vertices([&](std::uint32_t v, std::uint32_t w) { ends[last[v]++] = w; });
  for (std::size_t v = 0, first = 0; v < counts.vertices; first = last[v++]) {
    std::sort(ends.begin() + static_cast<std::ptrdiff_t>(first), ends.begin() + last[v]);
    for (std::size_t i = first; i < last[v];) {
      const std::size_t begin = i;
      while (i < last[v] && ends[i] == ends[begin])
        ++i;
      if (i - begin > 1)
        counts.multiple_edges += i - begin;
    }
  }
  for (IT::Edge_index e : complex.edges())
    counts.boundary_edges += complex.is_border(e);

  std::size_t used_vertices = 0;
  for (IT::Vertex_index v : complex.vertices())
    if (complex.halfedge(v).is_valid()) {
      ++used_vertices;
      counts.components += pieces.find(v.idx()) == v.idx();
    }
  counts.euler_characteristic =
    static_cast<long long>(used_vertices) - static_cast<long long>(counts.edges) + static_cast<long long>(counts.faces);
  return counts;
}

} // namespace idt

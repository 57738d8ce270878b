// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/saved_triangulation.h"

#include "input/gluing_file.h"
#include "input/standard_input.h"
#include "system/Interruption.h"
#include "system/Progress.h"
#include "system/Stopwatch.h"

#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>

#include <boost/property_map/vector_property_map.hpp>

#include <cmath>
#include <filesystem>
#include <memory>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// Flags of the edges of a triangulation.
struct Marks
{
  using key_type = IT::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::writable_property_map_tag;

  std::vector<bool>* marks;
  friend void put(const Marks& map, IT::Edge_index e, bool value)
  {
    map.marks->resize(e.idx() + std::size_t(1));
    (*map.marks)[e.idx()] = value;
  }
};

void set_metric(const IT::Input_metric& metric, Surface& surface)
{
  const int unit = metric.unit_exponent();
  for (const auto& p : metric.points())
    surface.points.push_back({std::ldexp(p[0], unit), std::ldexp(p[1], unit), std::ldexp(p[2], unit)});
  for (double l : metric.lengths())
    surface.lengths.push_back(std::ldexp(l, unit));
  if (!metric.points().empty() || !metric.lengths().empty())
    return;
  const IT::Rational scale = IT::Rational(std::ldexp(1., unit)) * IT::Rational(std::ldexp(1., unit));
  for (IT::Edge_index e : surface.connectivity.edges())
    surface.squared_lengths.push_back(IT::squared_length(metric, surface.connectivity, e) * scale);
  surface.lengths = rounded_lengths(surface.squared_lengths);
}

} // namespace

bool is_saved_triangulation(const std::string& path) { return std::filesystem::path(path).extension() == ".idt"; }

void load_saved_triangulation(Surface& surface)
{
  const Stopwatch stopwatch;
  Progress progress(surface.path, "reading");
  std::vector<bool> marks;
  const auto saved = std::make_shared<Saved_triangulation>(Saved_triangulation{
    IT::read_triangulation<CGAL::Parallel_if_available_tag>(
      readable_file(surface.path),
      CGAL::parameters::edge_is_constrained_map(Marks{&marks}).visitor([] { return !is_interrupted(); })),
    {}});
  const auto& triangulation = saved->triangulation;
  surface.connectivity = triangulation.input();
  set_metric(triangulation.input_metric(), surface);
  if (!marks.empty()) {
    saved->is_constrained.resize(surface.connectivity.number_of_edges());
    for (IT::Edge_index e : triangulation.connectivity().edges())
      if (marks[e.idx()] && triangulation.is_input_edge(e))
        saved->is_constrained
          [surface.connectivity.edge(triangulation.input_halfedge(triangulation.connectivity().halfedge(e))).idx()] =
          true;
  }
  surface.saved = saved;
  surface.read_seconds = stopwatch.seconds();
}

} // namespace idt

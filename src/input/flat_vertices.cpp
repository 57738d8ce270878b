// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/flat_vertices.h"

#include "system/Exit_status.h"
#include "system/Progress.h"

#include <CGAL/Intrinsic_triangulations/surface_features.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

double remove_flat_vertices(Surface& surface, std::optional<double> tolerance)
{
  if (surface.saved)
    throw Usage_error(surface.path +
                      ": --remove-flat-vertices is for meshes, as a saved triangulation keeps its input");
  if (!surface.has_points())
    throw Usage_error(surface.path +
                      ": --remove-flat-vertices needs a surface in space, but this one has only edge lengths");
  Progress progress(surface.path, "removing flat vertices");
  const std::size_t number_before = surface.points.size();
  const IT::Flat_vertex_removal removal = IT::remove_nearly_flat_vertices(
    surface.connectivity, surface.points, tolerance.value_or(0), CGAL::parameters::visitor(std::ref(progress)));
  surface.number_of_removed_vertices = number_before - removal.vertices.size();
  surface.input_vertices.emplace();
  for (IT::Vertex_index v : removal.vertices)
    surface.input_vertices->push_back(surface.repair ? surface.repair->input_vertices[v.idx()] : v.idx());
  return removal.deviation;
}

void write_vertex_map(std::ostream& os, const Surface& surface)
{
  os << "vertex,input\n";
  for (std::size_t v = 0; v < surface.input_vertices->size(); ++v)
    os << v << ',' << (*surface.input_vertices)[v] << '\n';
}

} // namespace idt

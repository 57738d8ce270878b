// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Conformal maps.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/conformal_parameterization.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

// The images of three corners.
std::array<double, 6> flattened(const std::array<IT::Conformal_map::Point, 3>& t)
{
  return {t[0][0], t[0][1], t[1][0], t[1][1], t[2][0], t[2][1]};
}

// \param boundary the number of a value of `Conformal_boundary`
py::tuple conformal_map(Surface& surface, const Indices& cones, const Doubles& cone_angles, const Indices& border,
                        const Doubles& border_angles, std::optional<std::size_t> number_of_cones, int boundary)
{
  const auto angles = [](const Indices& vertices, const Doubles& values) {
    std::vector<std::pair<IT::Vertex_index, double>> result;
    for (const auto& [v, angle] : values_at(vertices, values))
      result.emplace_back(v, angle);
    return result;
  };
  const auto options = CGAL::parameters::cone_angles(angles(cones, cone_angles))
                         .boundary_angles(angles(border, border_angles))
                         .number_of_cones(number_of_cones)
                         .conformal_boundary(IT::Conformal_boundary(boundary))
                         .visitor([](double) { return Signal_watch::goes_on(); });
  IT::Conformal_map map =
    surface.use([&](const Triangulation& t) { return IT::conformal_parameterization(t, options); });

  Point_table places;
  for (const IT::Surface_point& p : map.places)
    if (p.halfedge.is_valid())
      places.append(map.input, p, surface.input_sides()[map.input.face(p.halfedge).idx()]);
    else // without a face
      places.append(map.input, {surface.input_sides().front(), {0, 0, 0}}, surface.input_sides().front());
  std::vector<std::array<double, 6>> uv, input_uv;
  for (const auto& t : map.uv)
    uv.push_back(flattened(t));
  for (IT::Halfedge_index h : surface.input_sides())
    input_uv.push_back(
      flattened({map.input_uv[h.idx()], map.input_uv[map.input.next(h).idx()], map.input_uv[map.input.prev(h).idx()]}));
  const auto numbers = [](const auto& descriptors) {
    std::vector<std::int64_t> result;
    for (auto x : descriptors)
      result.push_back(x.idx());
    return to_array(std::move(result));
  };
  std::vector<std::array<bool, 3>> is_cut = std::move(map.is_cut);
  return py::make_tuple(
    places.to_arrays(), to_numbers(map.triangles), to_array(std::move(uv)), numbers(map.input_faces),
    to_array(std::move(is_cut)), to_array(std::move(input_uv)), to_array(std::move(map.weights)),
    to_array(std::move(map.stretch)), to_array(std::move(map.metric.u)), numbers(map.metric.cones),
    to_array(std::move(map.metric.cone_angles)), map.metric.residual, map.metric.range_of_u, map.metric.steps, map.seam,
    map.is_certified, map.overlaps, to_numbers(map.turned), numbers(map.turned_input), numbers(map.divided_input));
}

} // namespace

void add_conformal_maps(py::module_& module)
{
  module.def("conformal_map", &conformal_map, py::arg("surface"), py::arg("cones").noconvert(),
             py::arg("cone_angles").noconvert(), py::arg("border").noconvert(), py::arg("border_angles").noconvert(),
             py::arg("number_of_cones"), py::arg("boundary"));
}

} // namespace idt_python

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Simplified surfaces, and distances by way of them.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

namespace parameters = CGAL::parameters;

// Marks of vertices or edges as a property map. \param marks must outlive the map
template <class Descriptor>
auto as_map(const std::optional<std::vector<bool>>& marks)
{
  return boost::make_function_property_map<Descriptor, bool>([&](Descriptor d) { return marks && (*marks)[d.idx()]; });
}

// \pre there are as many marks as vertices and as edges
py::tuple simplify(Surface& surface, const std::optional<double>& maximum_change, std::size_t number_of_vertices,
                   const std::optional<std::vector<bool>>& is_kept,
                   const std::optional<std::vector<bool>>& is_constrained, double sharp_angle)
{
  IT::Simplified_surface s = surface.use([&](Triangulation& t) {
    return IT::simplify_surface(t, parameters::maximum_change(maximum_change)
                                     .number_of_vertices(number_of_vertices)
                                     .vertex_is_constrained_map(as_map<IT::Vertex_index>(is_kept))
                                     .edge_is_constrained_map(as_map<IT::Edge_index>(is_constrained))
                                     .sharp_angle(sharp_angle)
                                     .visitor(&Signal_watch::goes_on));
  });
  const IT::Delta_complex& coarse = s.map.coarse();
  std::vector<IT::Halfedge_index> first_sides;
  for (IT::Face_index f : coarse.faces())
    first_sides.push_back(coarse.halfedge(f));
  std::vector<std::int64_t> kept, faces;
  for (IT::Vertex_index v : s.kept)
    kept.push_back(v.idx());
  std::vector<std::array<double, 3>> coordinates;
  for (const IT::Surface_point& place : s.places) {
    const bool is_somewhere = place.halfedge.is_valid();
    const IT::Face_index f = is_somewhere ? coarse.face(place.halfedge) : IT::Face_index();
    faces.push_back(is_somewhere ? std::int64_t(f.idx()) : -1);
    coordinates.push_back(is_somewhere ? IT::coordinates_from(coarse, place, coarse.halfedge(f))
                                       : std::array<double, 3>{0, 0, 0});
  }
  auto prolongation = without_lock([&] { return IT::prolongation_matrix(s.triangulation, s.places); });
  return py::make_tuple(std::make_unique<Surface>(std::move(s.triangulation), std::move(first_sides)),
                        to_array(std::move(kept)), to_array(std::move(faces)), to_array(std::move(coordinates)),
                        s.shrink, s.stretch, to_sparse(std::move(prolongation)),
                        py::dict(py::arg("by_bound") = s.reasons.by_bound, py::arg("by_request") = s.reasons.by_request,
                                 py::arg("as_corners") = s.reasons.as_corners,
                                 py::arg("for_gluing") = s.reasons.for_gluing,
                                 py::arg("by_number") = s.reasons.by_number, py::arg("isolated") = s.reasons.isolated));
}

std::unique_ptr<IT::Simplified_distances> simplified_distances(const Doubles& points, const Indices& triangles,
                                                               const std::optional<double>& maximum_change)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  return without_lock([&] {
    Triangulation t(IT::make_Delta_complex_from_triangles(rows.size(), faces), rows);
    t.set_interruption(&Signal_watch::goes_on);
    return std::make_unique<IT::Simplified_distances>(
      IT::simplify_surface(t, parameters::maximum_change(maximum_change).visitor(&Signal_watch::goes_on)));
  });
}

py::tuple distances_from(const IT::Simplified_distances& distances, const Indices& sources)
{
  std::vector<IT::Vertex_index> vertices;
  for (std::uint32_t v : copied(sources))
    vertices.push_back(IT::Vertex_index(v));
  IT::Distance_intervals found =
    without_lock([&] { return distances.from(vertices, parameters::visitor(&Signal_watch::goes_on)); });
  return py::make_tuple(to_array(std::move(found.distances)), to_array(std::move(found.lower)),
                        to_array(std::move(found.upper)));
}

} // namespace

void add_simplification(py::module_& module)
{
  module.def("simplify", &simplify, py::arg("surface"), py::arg("maximum_change"), py::arg("number_of_vertices"),
             py::arg("is_kept"), py::arg("is_constrained"), py::arg("sharp_angle"));
  py::class_<IT::Simplified_distances>(module, "SimplifiedDistances")
    .def(py::init(&simplified_distances), py::arg("points").noconvert(), py::arg("triangles").noconvert(),
         py::arg("maximum_change"))
    .def("distances", &distances_from, py::arg("sources").noconvert());
}

} // namespace idt_python

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Parallel transport of tangent vectors, and logarithmic maps.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <pybind11/stl.h>

#include <complex>
#include <memory>
#include <optional>

namespace idt_python {

namespace {

// It never changes, and several threads may call its const member functions at once.
using Vector_heat = IT::Vector_heat_method;

std::unique_ptr<Vector_heat> vector_heat(Surface& surface, const std::optional<double>& time_coefficient)
{
  return surface.use([&](const Triangulation& t) {
    return std::make_unique<Vector_heat>(
      t, CGAL::parameters::time_coefficient(time_coefficient).visitor(&Signal_watch::goes_on));
  });
}

py::array to_rows(const std::vector<Vector_heat::Vector>& vectors)
{
  std::vector<std::array<double, 2>> result;
  for (const Vector_heat::Vector& v : vectors)
    result.push_back({v.real(), v.imag()});
  return to_array(std::move(result));
}

py::array transport(const Vector_heat& heat, const Indices& vertices, const Doubles& x, const Doubles& y)
{
  const auto v = copied(vertices);
  const auto first = copied(x), second = copied(y);
  require(v.size() == first.size() && v.size() == second.size(), "there are not as many vectors as vertices");
  std::vector<std::pair<IT::Vertex_index, Vector_heat::Vector>> sources;
  for (std::size_t i = 0; i < v.size(); ++i)
    sources.emplace_back(IT::Vertex_index(v[i]), Vector_heat::Vector(first[i], second[i]));
  return to_rows(without_lock([&] { return heat.transport_tangent_vectors(sources); }));
}

py::array log_map(const Vector_heat& heat, std::uint32_t v)
{
  return to_rows(without_lock([&] { return heat.log_map(IT::Vertex_index(v)); }));
}

py::array extend_by_vector_heat(const Vector_heat& heat, const Indices& vertices, const Doubles& values)
{
  const auto pairs = values_at(vertices, values);
  return to_array(without_lock([&] { return heat.extend(pairs); }));
}

// The axes of the tangent planes in space, and their normals.
py::tuple frames(Surface& surface, const Doubles& points)
{
  const auto p = copied_rows(points);
  const std::vector<IT::Vertex_frame> found = surface.use([&](const Triangulation& t) {
    if (p.size() != t.input().number_of_vertices())
      throw IT::Invalid_argument_error("there is not a point for each vertex");
    return IT::vertex_frames(t, p);
  });
  std::vector<std::array<double, 3>> x, y, normal;
  for (const IT::Vertex_frame& f : found) {
    x.push_back(f.x);
    y.push_back(f.y);
    normal.push_back(f.normal);
  }
  return py::make_tuple(to_array(std::move(x)), to_array(std::move(y)), to_array(std::move(normal)));
}

py::tuple connection_Laplacian(Surface& surface)
{
  return to_sparse(surface.use([](const Triangulation& t) { return IT::connection_Laplacian(t); }));
}

} // namespace

void add_vectors(py::module_& module)
{
  module.def("vector_heat", &vector_heat, py::arg("surface"), py::arg("time_coefficient"));
  module.def("tangent_frames", &frames, py::arg("surface"), py::arg("points").noconvert());
  module.def("connection_laplacian", &connection_Laplacian, py::arg("surface"));
  py::class_<Vector_heat>(module, "VectorHeat")
    .def("transport", &transport, py::arg("vertices").noconvert(), py::arg("x").noconvert(), py::arg("y").noconvert())
    .def("log_map", &log_map, py::arg("vertex"))
    .def("extend", &extend_by_vector_heat, py::arg("vertices").noconvert(), py::arg("values").noconvert());
}

} // namespace idt_python

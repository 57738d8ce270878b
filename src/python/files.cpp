// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Meshes from files, and consistent orientation of faces.

#include "python/Signal_watch.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

// Points, corners of all faces, and where those of each face begin (empty if all are triangles); and warnings.
py::tuple read_mesh(const std::string& file_name)
{
  const auto goes_on = [](double) { return Signal_watch::goes_on(); };
  IT::Polygon_soup soup =
    without_lock([&] { return IT::read_polygon_soup(file_name, CGAL::parameters::visitor(goes_on)); });
  std::vector<std::int64_t> corners;
  for (std::size_t f = 0; f < soup.number_of_faces(); ++f)
    corners.insert(corners.end(), soup.polygon(f).begin(), soup.polygon(f).end());
  return py::make_tuple(to_array(std::move(soup.points)), to_array(std::move(corners)), to_numbers(soup.first_corner),
                        py::cast(soup.warnings));
}

// The triangles that are turned so that all agree.
py::array turned_faces(const Doubles& points, const Indices& triangles)
{
  const auto rows = copied_rows(points);
  const auto faces = copied_rows(triangles);
  return to_numbers(without_lock([&] { return IT::turned_triangles(rows, faces); }));
}

} // namespace

void add_files(py::module_& module)
{
  module.def("read_mesh", &read_mesh, py::arg("file_name"));
  module.def("turned_faces", &turned_faces, py::arg("points").noconvert(), py::arg("triangles").noconvert());
}

} // namespace idt_python

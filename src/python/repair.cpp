// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The repair of polygons: an extension module of its own, because it includes a GPL header.

#include "python/Signal_watch.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/repair_polygons.h>

#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

// \param first_corner where the corners of each face begin, and where those of the last face end
py::tuple repair(const Doubles& points, const Indices& corners, const std::vector<std::size_t>& first_corner,
                 const std::optional<double>& stitching_tolerance)
{
  const std::vector<std::array<double, 3>> rows = copied_rows(points);
  const std::vector<std::uint32_t> all = copied(corners);
  std::vector<std::vector<std::size_t>> polygons;
  for (std::size_t f = 0; f + 1 < first_corner.size(); ++f) {
    require(first_corner[f] <= first_corner[f + 1] && first_corner[f + 1] <= all.size(), "a face has no corners");
    polygons.emplace_back(all.begin() + std::ptrdiff_t(first_corner[f]),
                          all.begin() + std::ptrdiff_t(first_corner[f + 1]));
  }
  IT::Repaired_polygons repaired = without_lock([&] {
    return IT::repair_polygons(rows, polygons,
                               CGAL::parameters::stitching_tolerance(stitching_tolerance).visitor([](double) {
                                 return Signal_watch::goes_on();
                               }));
  });
  py::list repairs;
  for (const IT::Repair& r : repaired.repairs)
    repairs.append(py::make_tuple(IT::name(r.kind), r.count, r.elements, IT::message(r)));
  return py::make_tuple(to_array(std::move(repaired.points)), to_numbers(repaired.triangles),
                        to_numbers(repaired.input_vertices), to_numbers(repaired.input_faces), repairs);
}

} // namespace

} // namespace idt_python

PYBIND11_MODULE(_repair, module)
{
  module.doc() = "Mesh repair for the package intrinsic_triangulations, under the GPL.";
  idt_python::register_errors();
  module.def("repair", &idt_python::repair, pybind11::arg("points").noconvert(), pybind11::arg("corners").noconvert(),
             pybind11::arg("first_corner"), pybind11::arg("stitching_tolerance"));
}

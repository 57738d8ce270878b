// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lines at a distance, the sides of curves, and the borders of cells.

#include "python/Placed_rows.h"
#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>

#include <limits>

namespace idt_python {

namespace {

// Points of all lines, one after the other.
struct Line_tables
{
  std::vector<std::array<double, 3>> positions;
  Point_table points;
  std::vector<std::int64_t> ends; // where each line ends
  std::vector<double> distances;
  std::vector<std::int64_t> sources; // two for each line
};

enum Line_kind {
  ISOLINES,
  OFFSET_CURVES,
  BORDERS
};

// \param numbers, coordinates, first, offsets as for geodesic_distances_from()
py::tuple surface_lines(const Doubles& points, const Indices& triangles, const Indices& numbers,
                        const Doubles& coordinates, const Indices& first, const Doubles& offsets, int kind,
                        const Doubles& distances, double tolerance, double chord_tolerance)
{
  const auto positions = copied_rows(points);
  const auto faces = copied_rows(triangles);
  const Placed_rows placed(numbers, coordinates, first, offsets);
  const auto levels = copied(distances);
  const auto options =
    CGAL::parameters::tolerance(tolerance).maximum_deviation(chord_tolerance).visitor(&Signal_watch::goes_on);
  Line_tables result = without_lock([&] {
    Surface surface(Triangulation(IT::make_Delta_complex_from_triangles(positions.size(), faces), positions));
    return surface.use([&](Triangulation& t) {
      const std::vector<IT::Geodesic_source> sources = placed.sources(placed.on(t.input(), faces));
      IT::flip_to_Delaunay(t, CGAL::parameters::visitor(Signal_visitor()));
      const IT::Surface_lines found = kind == ISOLINES ? IT::isolines(t, sources, levels, options)
                                      : kind == OFFSET_CURVES
                                        ? IT::offset_curves(t, placed.on(t.input(), faces), levels, options)
                                        : IT::borders_of_cells(t, sources, options);
      Line_tables tables;
      for (const IT::Surface_line& line : found.lines) {
        for (const IT::Surface_point& p : line.points) {
          tables.positions.push_back(IT::point_in_space(t.input(), positions, p));
          tables.points.append(t.input(), p, surface.input_sides()[t.input().face(p.halfedge).idx()]);
        }
        tables.ends.push_back(std::int64_t(tables.positions.size()));
        tables.distances.push_back(line.distance);
        tables.sources.insert(tables.sources.end(), line.sources.begin(), line.sources.end());
      }
      return tables;
    });
  });
  return py::make_tuple(to_array(std::move(result.positions)), result.points.to_arrays(),
                        to_array(std::move(result.ends)), to_array(std::move(result.distances)),
                        to_array(std::move(result.sources)));
}

// 1 for each vertex to the left of the curve, -1 to its right, 0 on it.
py::array sides_of_curve(const Doubles& points, const Indices& triangles, const Indices& numbers,
                         const Doubles& coordinates, const Indices& first, const Doubles& offsets)
{
  const auto number_of_points = copied_rows(points).size();
  const auto faces = copied_rows(triangles);
  const Placed_rows placed(numbers, coordinates, first, offsets);
  return to_array(without_lock([&] {
    const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(number_of_points, faces);
    std::vector<std::int64_t> result;
    for (CGAL::Sign side : IT::sides_of_curve(complex, placed.on(complex, faces)))
      result.push_back(side);
    return result;
  }));
}

} // namespace

void add_lines(py::module_& module)
{
  module.def("surface_lines", &surface_lines, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("numbers").noconvert(), py::arg("coordinates").noconvert(), py::arg("first").noconvert(),
             py::arg("offsets").noconvert(), py::arg("kind"), py::arg("distances").noconvert(), py::arg("tolerance"),
             py::arg("chord_tolerance"));
  module.def("sides_of_curve", &sides_of_curve, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("numbers").noconvert(), py::arg("coordinates").noconvert(), py::arg("first").noconvert(),
             py::arg("offsets").noconvert());
}

} // namespace idt_python

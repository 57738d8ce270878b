// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Distances by the heat method, and functions extended from vertices.

#include "python/Placed_rows.h"
#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"

#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

namespace idt_python {

namespace {

auto heat_options(double time_coefficient, int boundary, bool keeps_ridges)
{
  return CGAL::parameters::time_coefficient(time_coefficient)
    .heat_boundary(boundary == 0   ? IT::Heat_boundary::NEUMANN
                   : boundary == 1 ? IT::Heat_boundary::DIRICHLET
                                   : IT::Heat_boundary::AVERAGED)
    .keeps_ridges(keeps_ridges)
    .visitor(&Signal_watch::goes_on);
}

// Calls from several Python threads wait for each other.
class Heat
{
public:
  explicit Heat(IT::Heat_method<> method) : method_(std::move(method)) {}

  std::vector<double> distances(const std::vector<std::uint32_t>& sources)
  {
    return distances_from([&sources](IT::Heat_method<>& method) {
      for (std::uint32_t v : sources)
        method.add_source(IT::Vertex_index(v));
    });
  }
  // \param add adds the sources
  template <class Add>
  std::vector<double> distances_from(const Add& add)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    method_.clear_sources();
    add(method_);
    return method_.distances();
  }
  std::vector<double> extend(const std::vector<std::pair<IT::Vertex_index, double>>& values, double elsewhere)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return method_.extend(values, elsewhere);
  }

private:
  IT::Heat_method<> method_;
  std::mutex mutex_;
};

IT::Tufted_cover Delaunay_cover(const Rows<double>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                IT::Surface_cover kind)
{
  IT::Tufted_cover cover =
    IT::make_tufted_cover(points, triangles, CGAL::parameters::surface_cover(kind).visitor(&Signal_watch::goes_on));
  cover.triangulation.set_interruption(&Signal_watch::goes_on);
  IT::flip_to_Delaunay(cover.triangulation, CGAL::parameters::visitor(Signal_visitor()));
  return cover;
}

std::unique_ptr<Heat> heat_on_any_triangles(const Doubles& points, const Indices& triangles, double time_coefficient,
                                            int boundary, bool keeps_ridges)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const auto options = heat_options(time_coefficient, boundary, keeps_ridges);
  return without_lock([&] {
    return std::make_unique<Heat>(IT::Heat_method<>(Delaunay_cover(rows, faces, IT::Surface_cover::TUFTED), options));
  });
}

std::unique_ptr<Heat> heat_on_surface(Surface& surface, double time_coefficient, int boundary, bool keeps_ridges)
{
  const auto options = heat_options(time_coefficient, boundary, keeps_ridges);
  return surface.use([&](const Triangulation& t) { return std::make_unique<Heat>(IT::Heat_method<>(t, options)); });
}

py::array distances(Heat& heat, const Indices& sources)
{
  const auto vertices = copied(sources);
  return to_array(without_lock([&] { return heat.distances(vertices); }));
}

py::array geodesic_distances(const Doubles& points, const Indices& triangles, const Indices& sources, double tolerance)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  std::vector<IT::Vertex_index> vertices;
  for (std::uint32_t v : copied(sources))
    vertices.push_back(IT::Vertex_index(v));
  const auto options = CGAL::parameters::tolerance(tolerance).visitor(&Signal_watch::goes_on);
  return to_array(without_lock([&] {
    return IT::geodesic_distances(Delaunay_cover(rows, faces, IT::Surface_cover::SHEETS), vertices, options).distances;
  }));
}

// \param ends two vertices, or none and stops
// \return positions, triangles, coordinates, the length, the distance, and whether it was found
py::tuple shortest_path(const Doubles& points, const Indices& triangles, const Indices& ends, const Indices& numbers,
                        const Doubles& coordinates)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const auto vertices = copied(ends), in_triangles = copied(numbers);
  const auto in_triangle = copied_rows(coordinates);
  std::vector<IT::Point_in_triangle> stops;
  for (std::size_t i = 0; i < in_triangles.size(); ++i)
    stops.push_back({in_triangles[i], in_triangle[i]});
  IT::Path_on_triangles path = without_lock([&] {
    const auto options = CGAL::parameters::visitor(&Signal_watch::goes_on);
    return vertices.empty() ? IT::shortest_path_on_triangles(rows, faces, stops, options)
                            : IT::shortest_path_on_triangles(rows, faces, vertices[0], vertices[1], options);
  });
  std::vector<std::int64_t> path_triangles;
  std::vector<std::array<double, 3>> path_coordinates;
  for (const IT::Point_in_triangle& p : path.points) {
    path_triangles.push_back(std::int64_t(p.triangle));
    path_coordinates.push_back(p.coordinates);
  }
  return py::make_tuple(to_array(std::move(path.positions)), to_array(std::move(path_triangles)),
                        to_array(std::move(path_coordinates)), path.length, path.distance, path.is_complete);
}

// \param is_on_cover how the heat was made
py::array heat_distances_from(Heat& heat, const Doubles& points, const Indices& triangles, bool is_on_cover,
                              const Indices& numbers, const Doubles& coordinates, const Indices& first,
                              const Doubles& offsets)
{
  const Rows<double> rows(points);
  const auto corners = copied_rows(points);
  const auto faces = copied_rows(triangles);
  const Placed_rows placed(numbers, coordinates, first, offsets);
  return to_array(without_lock([&] {
    return heat.distances_from([&](IT::Heat_method<>& method) {
      if (is_on_cover) {
        const IT::Tufted_cover cover = Delaunay_cover(rows, faces, IT::Surface_cover::TUFTED);
        return method.add_sources(cover, placed.sources(cover, faces));
      }
      const Triangulation triangulation(IT::make_Delta_complex_from_triangles(corners.size(), faces), corners);
      method.add_sources(triangulation, placed.sources(placed.on(triangulation.input(), faces)));
    });
  }));
}

// \param number_of_barriers how many of the last ones are barriers instead
// \return the distances, and the numbers of the nearest sources
std::pair<py::array, py::array> geodesic_distances_from(const Doubles& points, const Indices& triangles,
                                                        const Indices& numbers, const Doubles& coordinates,
                                                        const Indices& first, const Doubles& offsets, double tolerance,
                                                        std::size_t number_of_barriers)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const Placed_rows placed(numbers, coordinates, first, offsets);
  const auto options = CGAL::parameters::tolerance(tolerance).visitor(&Signal_watch::goes_on);
  const auto corners = copied_rows(points);
  IT::Geodesic_distances found = without_lock([&] {
    if (number_of_barriers == 0) {
      const IT::Tufted_cover cover = Delaunay_cover(rows, faces, IT::Surface_cover::SHEETS);
      return IT::geodesic_distances_from(cover, placed.sources(cover, faces), options);
    }
    const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(corners.size(), faces);
    const auto parts = placed.on(complex, faces);
    const IT::Surface_with_barriers surface(complex, corners,
                                            {parts.end() - std::ptrdiff_t(number_of_barriers), parts.end()});
    return IT::geodesic_distances_from(surface, placed.sources(parts), options);
  });
  std::vector<std::int64_t> nearest;
  for (std::uint32_t source : found.nearest_sources)
    nearest.push_back(source == IT::Geodesic_distances::no_source ? -1 : std::int64_t(source));
  return {to_array(std::move(found.distances)), to_array(std::move(nearest))};
}

// The vertices, and their distances. \param sources vertices
std::pair<py::array, py::array> farthest_vertices(const Doubles& points, const Indices& triangles,
                                                  const Indices& sources, std::uint32_t number, double tolerance)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  const auto starts = copied(sources);
  const auto options = CGAL::parameters::tolerance(tolerance).visitor(&Signal_watch::goes_on);
  std::vector<std::int64_t> vertices;
  std::vector<double> distances;
  without_lock([&] {
    const IT::Tufted_cover cover = Delaunay_cover(rows, faces, IT::Surface_cover::SHEETS);
    std::vector<IT::Geodesic_source> from;
    for (std::uint32_t v : starts) {
      const auto at = std::find(cover.vertex_of.begin(), cover.vertex_of.end(), cover.representative[v]);
      if (at == cover.vertex_of.end())
        throw IT::Invalid_argument_error("vertex " + std::to_string(v) + " has no face with area");
      from.push_back(IT::source_at_vertex(cover.triangulation.input(),
                                          IT::Vertex_index(std::uint32_t(at - cover.vertex_of.begin()))));
    }
    for (const IT::Farthest_vertex& v : IT::farthest_vertices(cover, from, number, options)) {
      vertices.push_back(v.vertex.idx());
      distances.push_back(v.distance);
    }
    return 0;
  });
  return {to_array(std::move(vertices)), to_array(std::move(distances))};
}

py::array geodesic_distance_matrix(const Doubles& points, const Indices& triangles, const Indices& sources,
                                   const Indices& targets, double tolerance)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  std::vector<IT::Vertex_index> from, to;
  for (std::uint32_t v : copied(sources))
    from.push_back(IT::Vertex_index(v));
  for (std::uint32_t v : copied(targets))
    to.push_back(IT::Vertex_index(v));
  std::atomic<bool> goes_on{true}; // only this thread receives signals
  const auto options = CGAL::parameters::tolerance(tolerance).visitor([&goes_on] {
    if (!Signal_watch::goes_on())
      goes_on = false;
    return goes_on.load();
  });
  return to_array(without_lock([&] {
    std::vector<double> result;
    for (const std::vector<double>& row : IT::geodesic_distance_matrix<CGAL::Parallel_if_available_tag>(
                                            Delaunay_cover(rows, faces, IT::Surface_cover::SHEETS), from, to, options)
                                            .distances)
      result.insert(result.end(), row.begin(), row.end());
    return result;
  }));
}

py::array extend(Heat& heat, const Indices& vertices, const Doubles& values, double elsewhere)
{
  const auto pairs = values_at(vertices, values);
  return to_array(without_lock([&] { return heat.extend(pairs, elsewhere); }));
}

} // namespace

void add_heat(py::module_& module)
{
  module.def("heat_on_any_triangles", &heat_on_any_triangles, py::arg("points").noconvert(),
             py::arg("triangles").noconvert(), py::arg("time_coefficient"), py::arg("boundary"),
             py::arg("keeps_ridges"));
  module.def("heat_on_surface", &heat_on_surface, py::arg("surface"), py::arg("time_coefficient"), py::arg("boundary"),
             py::arg("keeps_ridges"));
  module.def("geodesic_distances", &geodesic_distances, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("sources").noconvert(), py::arg("tolerance"));
  module.def("shortest_path", &shortest_path, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("ends").noconvert(), py::arg("numbers").noconvert(), py::arg("coordinates").noconvert());
  module.def("geodesic_distances_from", &geodesic_distances_from, py::arg("points").noconvert(),
             py::arg("triangles").noconvert(), py::arg("numbers").noconvert(), py::arg("coordinates").noconvert(),
             py::arg("first").noconvert(), py::arg("offsets").noconvert(), py::arg("tolerance"),
             py::arg("number_of_barriers"));
  module.def("farthest_vertices", &farthest_vertices, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
             py::arg("sources").noconvert(), py::arg("number"), py::arg("tolerance"));
  module.def("geodesic_distance_matrix", &geodesic_distance_matrix, py::arg("points").noconvert(),
             py::arg("triangles").noconvert(), py::arg("sources").noconvert(), py::arg("targets").noconvert(),
             py::arg("tolerance"));
  py::class_<Heat>(module, "Heat")
    .def("distances", &distances, py::arg("sources").noconvert())
    .def("distances_from", &heat_distances_from, py::arg("points").noconvert(), py::arg("triangles").noconvert(),
         py::arg("is_on_cover"), py::arg("numbers").noconvert(), py::arg("coordinates").noconvert(),
         py::arg("first").noconvert(), py::arg("offsets").noconvert())
    .def("extend", &extend, py::arg("vertices").noconvert(), py::arg("values").noconvert(), py::arg("elsewhere"));
}

} // namespace idt_python

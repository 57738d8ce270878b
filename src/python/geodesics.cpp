// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Straight lines: paths that are shortened by flips, and lines in a direction.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/tangent_direction.h"

#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/Named_function_parameters.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace idt_python {

namespace {

using Points = Tangent_directions::Points;

// A path, while no Python object may be touched.
struct Path
{
  Points positions;
  Point_table points;
  double initial_length = 0, length = 0;
  bool is_geodesic = false;
  const char* status = "";
  std::uint64_t flips = 0;
  std::optional<double> distance; // if the shortest was asked for
};

// A vertex, or a point in space.
struct Stop
{
  static constexpr std::uint32_t no_vertex = std::uint32_t(-1);

  std::uint32_t vertex;
  std::array<double, 3> point;
};

py::tuple to_tuple(Path&& path)
{
  return py::make_tuple(to_array(std::move(path.positions)), path.points.to_arrays(), path.length, path.initial_length,
                        path.is_geodesic, path.status, path.flips, path.distance);
}

const char* name_of(IT::Geodesic_status status)
{
  using Status = IT::Geodesic_status;
  return status == Status::GEODESIC         ? "geodesic"
         : status == Status::CONTRACTIBLE   ? "contractible"
         : status == Status::BLOCKED        ? "blocked"
         : status == Status::NOT_IMPROVABLE ? "not_improvable"
                                            : "unfinished";
}

// A surface in space, and lines on it. It never changes: paths between vertices flip a common copy, where they are
// undone; any other path flips a copy of its own, as does one that would have to wait for another thread.
class Surface_in_space
{
public:
  Surface_in_space(Points points, const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : points_(std::move(points)),
      surface_(Triangulation(IT::make_Delta_complex_from_triangles(points_.size(), triangles), points_))
  {
    surface_.use([](const Triangulation& t) { return &t.input(); }); // prepared, for all copies
  }

  // From stop to stop.
  Path path(const std::vector<Stop>& stops, bool is_closed, bool is_shortest, std::uint64_t maximum_number)
  {
    const bool are_vertices =
      std::all_of(stops.begin(), stops.end(), [](const Stop& stop) { return stop.vertex != Stop::no_vertex; });
    if (const std::unique_lock<std::mutex> turn(network_mutex_, std::try_to_lock);
        turn && are_vertices && !is_shortest) {
      if (!flipped_)
        flipped_ = std::make_unique<Surface>(surface_);
      return flipped_->use([&](Triangulation& t) {
        if (!network_)
          network_.emplace(t);
        return to_path(
          t, shortened(t, *network_, edge_path(t, vertices_at(t, stops, is_closed)), is_closed, maximum_number));
      });
    }
    Surface copy = surface_;
    return copy.use([&](Triangulation& t) {
      const std::vector<IT::Vertex_index> vertices = vertices_at(t, stops, is_closed);
      if (is_shortest)
        return shortest(t, vertices, maximum_number);
      Network network(t); // of the triangulation with all vertices
      return to_path(t, shortened(t, network, edge_path(t, vertices), is_closed, maximum_number));
    });
  }

  // A face, and coordinates there.
  py::tuple locate(const std::array<double, 3>& p)
  {
    Point_table table = surface_.use([&](const Triangulation& t) {
      Point_table result;
      append(t, nearest(t, p), result);
      return result;
    });
    return table.to_arrays();
  }

  // Cuts the surface open along a path given by faces and coordinates: points, triangles, their faces, and where new
  // vertices lie.
  py::tuple cut_along_path(const Indices& path_faces, const Doubles& path_coordinates)
  {
    const auto faces = copied(path_faces);
    const auto coordinates = copied_rows(path_coordinates);
    require(faces.size() == coordinates.size(), "there are not as many coordinates as faces");
    Point_table locations;
    IT::Cut_surface cut = surface_.use([&](const Triangulation& t) {
      std::vector<IT::Surface_point> path;
      for (std::size_t i = 0; i < faces.size(); ++i)
        path.push_back({surface_.input_sides()[faces[i]], coordinates[i]});
      IT::Cut_surface result = IT::cut_along_path(t.input(), points_, path);
      for (const IT::Surface_point& p : result.locations)
        append(t, p, locations);
      return result;
    });
    return py::make_tuple(to_array(std::move(cut.points)), to_numbers(cut.triangles), to_numbers(cut.input_faces),
                          locations.to_arrays());
  }

  py::tuple trace_from_vertex(std::uint32_t v, const std::array<double, 3>& vector,
                              const std::optional<std::uint64_t>& maximum_number)
  {
    return to_tuple(surface_.use([&](const Triangulation& t) {
      const IT::Delta_complex& complex = t.connectivity();
      if (v >= complex.number_of_vertices() || !complex.halfedge(IT::Vertex_index(v)).is_valid())
        throw IT::Invalid_argument_error("there is no vertex " + std::to_string(v) + " with faces: there are " +
                                         std::to_string(complex.number_of_vertices()) + " vertices, counted from 0");
      return trace(t,
                   Tangent_directions(complex, points_, t.unit_exponent())
                     .at_vertex(IT::Vertex_index(v), Eigen::Vector3d(vector.data())),
                   maximum_number);
    }));
  }

  py::tuple trace_from_face(std::uint32_t f, const std::array<double, 3>& coordinates,
                            const std::array<double, 3>& vector, const std::optional<std::uint64_t>& maximum_number)
  {
    return to_tuple(surface_.use([&](const Triangulation& t) {
      const IT::Delta_complex& complex = t.connectivity();
      if (f >= complex.number_of_faces())
        throw IT::Invalid_argument_error("there is no face " + std::to_string(f) + ": there are " +
                                         std::to_string(complex.number_of_faces()) + ", counted from 0");
      const IT::Surface_point start = {complex.halfedge(IT::Face_index(f)), coordinates};
      return trace(
        t, Tangent_directions(complex, points_, t.unit_exponent()).in_face(start, Eigen::Vector3d(vector.data())),
        maximum_number);
    }));
  }

private:
  using Network = IT::Geodesic_path_network<IT::Filtered_edge_length_traits>;
  struct Rewinding
  {
    Network& network;
    ~Rewinding() { network.rewind(); }
  };

  using Line = IT::internal::Path_over_stops;

  // Stops that are not vertices are inserted.
  std::vector<IT::Vertex_index> vertices_at(Triangulation& t, const std::vector<Stop>& stops, bool is_closed) const
  {
    std::vector<IT::Vertex_index> result;
    for (const Stop& stop : stops)
      result.push_back(stop.vertex != Stop::no_vertex ? IT::Vertex_index(stop.vertex)
                                                      : IT::vertex_at_point(t, nearest(t, stop.point)));
    if (is_closed)
      result.push_back(result.front());
    return result;
  }

  // Calls a function; if there is no path from one stop to the next, the message counts them, as some were no vertices.
  template <class Function>
  static auto from_stop(std::size_t i, const Function& find)
  {
    try {
      return find();
    } catch (const IT::Invalid_argument_error&) {
      throw IT::Invalid_argument_error("no path leads from stop " + std::to_string(i) +
                                       " to the next one: choose stops "
                                       "of one component");
    }
  }

  static std::vector<IT::Halfedge_index> edge_path(const Triangulation& t,
                                                   const std::vector<IT::Vertex_index>& vertices)
  {
    std::vector<IT::Halfedge_index> result;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
      const std::vector<IT::Halfedge_index> part =
        from_stop(i, [&] { return IT::shortest_edge_path(t, vertices[i], vertices[i + 1]); });
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  // From each vertex to the next one.
  Path shortest(Triangulation& t, const std::vector<IT::Vertex_index>& vertices, std::uint64_t maximum_number) const
  {
    const auto np = CGAL::parameters::visitor(&Signal_watch::goes_on);
    IT::flip_to_Delaunay(t, CGAL::parameters::visitor(Signal_visitor()));
    Signal_watch::check();
    Network network(t);
    Line line;
    line.maximum_number_of_flips = maximum_number;
    for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
      from_stop(i, [&] { line.append_shortest(t, network, vertices[i], vertices[i + 1], np); });
    Path result = to_path(t, line);
    result.distance = line.distance;
    return result;
  }

  // Afterwards, the triangulation is as before.
  static Line shortened(const Triangulation& t, Network& network, const std::vector<IT::Halfedge_index>& start,
                        bool is_closed, std::uint64_t maximum_number)
  {
    if (is_closed && start.empty())
      throw IT::Invalid_argument_error("a closed curve needs two different vertices");
    const Rewinding rewinding{network};
    const std::size_t p = is_closed ? network.add_closed_path(start) : network.add_path(start);
    Line result;
    result.maximum_number_of_flips = maximum_number;
    result.append(t, network, p, CGAL::parameters::visitor(&Signal_watch::goes_on));
    if (network.status(p) == IT::Geodesic_status::CONTRACTIBLE)
      result.points.push_back(at_input_vertex(t, network.contraction(p)));
    return result;
  }

  Path to_path(const Triangulation& t, const Line& line) const
  {
    Path result;
    for (const IT::Surface_point& point : line.points)
      append(t, point, result);
    result.initial_length = line.initial_length;
    result.length = line.length;
    result.is_geodesic = line.is_geodesic;
    result.status = name_of(line.status);
    result.flips = line.flips;
    return result;
  }

  IT::Surface_point nearest(const Triangulation& t, const std::array<double, 3>& p) const
  {
    return IT::locate(t.input(), points_, p);
  }

  // A border halfedge may point to the vertex, but its opposite has a face.
  static IT::Surface_point at_input_vertex(const Triangulation& t, IT::Vertex_index v)
  {
    const IT::Delta_complex& input = t.input();
    return {input.opposite(input.halfedge(v)), {1, 0, 0}};
  }

  // \param maximum_number the number of faces after which the line is cut off; without it, too many faces are an error
  Path trace(const Triangulation& t, const Tangent_direction& start,
             const std::optional<std::uint64_t>& maximum_number) const
  {
    const IT::Traced_geodesic line = IT::trace_geodesic(
      t, start.direction, start.length, CGAL::parameters::maximum_number(maximum_number.value_or(most_faces)));
    if (line.status == IT::Trace_status::BUDGET_EXHAUSTED && !maximum_number)
      throw IT::Invalid_point_error("the line crosses more than a million faces within " + std::to_string(line.length) +
                                    " of its length " + std::to_string(start.length) +
                                    ": give a shorter vector, or max_iterations");
    Path result;
    for (const IT::Surface_point& point : line.points)
      append(t, point, result);
    result.length = line.length;
    result.is_geodesic = true;
    result.status = line.status == IT::Trace_status::AT_LENGTH   ? "at_length"
                    : line.status == IT::Trace_status::AT_BORDER ? "at_border"
                    : line.status == IT::Trace_status::AT_VERTEX ? "at_vertex"
                                                                 : "unfinished";
    return result;
  }

  void append(const Triangulation& t, const IT::Surface_point& point, Path& path) const
  {
    path.positions.push_back(IT::point_in_space(t.input(), points_, point));
    append(t, point, path.points);
  }
  void append(const Triangulation& t, const IT::Surface_point& point, Point_table& table) const
  {
    const IT::Delta_complex& input = t.input();
    table.append(input, point, surface_.input_sides()[input.face(point.halfedge).idx()]);
  }

  // Otherwise a typing error in the length would fill the memory.
  static constexpr std::uint64_t most_faces = 1000000;

  Points points_;
  Surface surface_;
  std::mutex network_mutex_;
  std::unique_ptr<Surface> flipped_; // from the first path on
  std::optional<Network> network_;   // on it
};

std::unique_ptr<Surface_in_space> surface_in_space(const Doubles& points, const Indices& triangles)
{
  Points p = copied_rows(points);
  const auto faces = copied_rows(triangles);
  return without_lock([&] { return std::make_unique<Surface_in_space>(std::move(p), faces); });
}

} // namespace

void add_geodesics(py::module_& module)
{
  py::class_<Surface_in_space>(module, "SurfaceInSpace")
    .def(py::init(&surface_in_space), py::arg("points").noconvert(), py::arg("triangles").noconvert())
    .def(
      "path",
      [](Surface_in_space& s, const Indices& vertices, const Doubles& points, bool is_closed, bool is_shortest,
         std::uint64_t maximum_number) {
        const auto v = copied(vertices);
        const auto p = copied_rows(points);
        require(v.size() == p.size(), "there are not as many points as vertices");
        std::vector<Stop> stops;
        for (std::size_t i = 0; i < v.size(); ++i)
          stops.push_back({v[i], p[i]});
        return to_tuple(without_lock([&] { return s.path(stops, is_closed, is_shortest, maximum_number); }));
      },
      py::arg("vertices").noconvert(), py::arg("points").noconvert(), py::arg("is_closed"), py::arg("is_shortest"),
      py::arg("maximum_number"))
    .def("locate", &Surface_in_space::locate)
    .def("cut_along_path", &Surface_in_space::cut_along_path)
    .def("trace_from_vertex", &Surface_in_space::trace_from_vertex)
    .def("trace_from_face", &Surface_in_space::trace_from_face);
}

} // namespace idt_python

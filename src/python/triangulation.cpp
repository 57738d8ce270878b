// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The triangulation: construction, flips, refinement, checks and queries.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/saved_state.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/property_map/function_property_map.hpp>

#include <pybind11/stl.h>

#include <cmath>
#include <fstream>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

namespace parameters = CGAL::parameters;

using Numbers = std::vector<std::int64_t>;

// ------------------------------------------------------------- construction

std::unique_ptr<Surface> from_points(const Doubles& points, const Indices& triangles)
{
  const Rows<double> rows(points);
  const auto faces = copied_rows(triangles);
  return without_lock([&] {
    return std::make_unique<Surface>(Triangulation(IT::make_Delta_complex_from_triangles(rows.size(), faces), rows));
  });
}

// The length of each edge. \param lengths the lengths of the sides of the faces
std::vector<double> edge_lengths(const IT::Delta_complex& complex, const std::vector<std::array<double, 3>>& lengths)
{
  std::vector<double> result(complex.number_of_edges(), -1);
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex.next(h)) {
      double& length = result[complex.edge(h).idx()];
      const double given = lengths[f.idx()][std::size_t(i)];
      // Does not fail if either is NaN: the library names that edge.
      if (length >= 0 && given >= 0 && length != given)
        throw IT::Invalid_surface_error(
          IT::Invalid_surface_error::Defect::INVALID_GLUING, f.idx(), 1,
          "side " + std::to_string(i) + " of face " + std::to_string(f.idx()) + " has length " + std::to_string(given) +
            ", but the side of another face that it is glued to has length " + std::to_string(length));
      length = given;
    }
  }
  return result;
}

std::unique_ptr<Surface> from_lengths_of(IT::Delta_complex complex, const std::vector<std::array<double, 3>>& lengths)
{
  std::vector<double> of_edges = edge_lengths(complex, lengths);
  return std::make_unique<Surface>(Triangulation::from_lengths(std::move(complex), std::move(of_edges)));
}

std::unique_ptr<Surface> from_lengths(const Indices& triangles, const Doubles& lengths, std::size_t number_of_vertices)
{
  const auto faces = copied_rows(triangles);
  const auto sides = copied_rows(lengths);
  require(faces.size() == sides.size(), "there are not as many rows of lengths as faces");
  return without_lock(
    [&] { return from_lengths_of(IT::make_Delta_complex_from_triangles(number_of_vertices, faces), sides); });
}

std::unique_ptr<Surface> from_gluing(const Indices& first, const Indices& second, const Doubles& lengths)
{
  const auto one = copied(first), two = copied(second);
  const auto sides = copied_rows(lengths);
  require(one.size() == two.size(), "the sides are no pairs");
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::size_t i = 0; i < one.size(); ++i)
    pairs.push_back({one[i], two[i]});
  return without_lock([&] { return from_lengths_of(IT::make_Delta_complex_from_gluing(sides.size(), pairs), sides); });
}

// ------------------------------------------------------------- files and other processes

py::bytes state_of_surface(Surface& surface)
{
  const std::size_t number_of_faces = surface.use([](const Triangulation& t) {
    return std::size_t(t.input().number_of_faces()) + t.connectivity().number_of_faces();
  });
  return written_bytes(number_of_faces, [&](std::ostream& os) {
    surface.use([&](const Triangulation& t) {
      IT::write_triangulation(os, t, surface.input_sides(), while_no_signal);
      return true;
    });
  });
}

void save(Surface& surface, const std::string& path)
{
  surface.use([&](const Triangulation& t) {
    std::ofstream os(path, std::ios::binary);
    IT::write_triangulation(os, t, surface.input_sides(), while_no_signal);
    if (!os.flush())
      throw IT::Error(path + ": cannot be written");
    return true;
  });
}

std::unique_ptr<Surface> load(const std::string& path)
{
  return without_lock([&] {
    return std::make_unique<Surface>(IT::read_triangulation<CGAL::Parallel_if_available_tag>(path, while_no_signal),
                                     true);
  });
}

// ------------------------------------------------------------------ numbers

// The points of the input, or none if it is given by lengths.
std::vector<std::array<double, 3>> input_points(const Triangulation& t)
{
  const int unit = t.input_metric().unit_exponent();
  std::vector<std::array<double, 3>> result;
  for (const auto& p : t.input_metric().points())
    result.push_back({std::ldexp(p[0], unit), std::ldexp(p[1], unit), std::ldexp(p[2], unit)});
  return result;
}

// A row for each face: the values of `of_side(h)` for its three sides.
template <class Of_side>
auto rows_of_faces(const IT::Delta_complex& complex, const Of_side& of_side)
{
  std::vector<std::array<decltype(of_side(IT::Halfedge_index())), 3>> result;
  result.reserve(complex.number_of_faces());
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f);
    result.push_back({of_side(h), of_side(complex.next(h)), of_side(complex.prev(h))});
  }
  return result;
}

auto faces(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  return rows_of_faces(complex, [&](IT::Halfedge_index h) { return std::int64_t(complex.source(h).idx()); });
}

auto edges_of_faces(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  return rows_of_faces(complex, [&](IT::Halfedge_index h) { return std::int64_t(complex.edge(h).idx()); });
}

auto corner_angles(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  const std::vector<double> angles = IT::opposite_angles(t);
  return rows_of_faces(complex, [&](IT::Halfedge_index h) { return angles[complex.next(h).idx()]; });
}

std::vector<std::array<std::int64_t, 2>> edges(const Triangulation& t)
{
  const IT::Delta_complex& complex = t.connectivity();
  std::vector<std::array<std::int64_t, 2>> result;
  for (IT::Edge_index e : complex.edges())
    result.push_back({complex.source(complex.halfedge(e)).idx(), complex.target(complex.halfedge(e)).idx()});
  return result;
}

std::vector<double> weights(const Triangulation& t)
{
  std::vector<double> result = IT::cotangent_weights(t);
  for (double& w : result)
    w /= 2;
  return result;
}

// --------------------------------------------------------------- algorithms

// The constrained edges as a property map. \param is_constrained a value for each edge, or none; must outlive the map
auto constrained_edges(const std::vector<bool>& is_constrained)
{
  return boost::make_function_property_map<IT::Edge_index, bool>(
    [&](IT::Edge_index e) { return !is_constrained.empty() && is_constrained[e.idx()]; });
}

std::vector<bool> copied_marks(const std::optional<Booleans>& marks)
{
  if (!marks)
    return {};
  require(marks->ndim() == 1, "marks of edges have one dimension");
  const auto items = marks->unchecked<1>();
  std::vector<bool> result;
  for (py::ssize_t i = 0; i < items.shape(0); ++i)
    result.push_back(items(i));
  return result;
}

// Only from here on is the number of edges fixed.
void check_marks(const Triangulation& t, const std::vector<bool>& is_constrained)
{
  const std::size_t n = t.connectivity().number_of_edges();
  if (!is_constrained.empty() && is_constrained.size() != n)
    throw IT::Invalid_argument_error("there are " + std::to_string(is_constrained.size()) +
                                     " marks of constrained edges for " + std::to_string(n) + " edges");
}

py::tuple flip_to_Delaunay(Surface& surface, const std::optional<Booleans>& constrained, std::uint64_t maximum_number)
{
  const std::vector<bool> is_constrained = copied_marks(constrained);
  const IT::Flip_report report = surface.use([&](Triangulation& t) {
    check_marks(t, is_constrained);
    return IT::flip_to_Delaunay(t, parameters::edge_is_constrained_map(constrained_edges(is_constrained))
                                     .visitor(Signal_visitor())
                                     .maximum_number(maximum_number));
  });
  return py::make_tuple(report.status == IT::Flip_status::DELAUNAY, report.flips, report.tests);
}

py::tuple verify(Surface& surface, const std::optional<Booleans>& constrained)
{
  const std::vector<bool> is_constrained = copied_marks(constrained);
  const IT::Delaunay_verification found = surface.use([&](const Triangulation& t) {
    check_marks(t, is_constrained);
    return IT::verify_Delaunay(t, parameters::edge_is_constrained_map(constrained_edges(is_constrained)));
  });
  Numbers not_Delaunay, inverted;
  for (IT::Edge_index e : found.not_Delaunay)
    not_Delaunay.push_back(e.idx());
  for (IT::Face_index f : found.inverted)
    inverted.push_back(f.idx());
  return py::make_tuple(found.is_Delaunay(), found.tests, found.ties, to_array(std::move(not_Delaunay)),
                        to_array(std::move(inverted)));
}

const char* name_of(IT::Refinement_obstacle obstacle)
{
  using Obstacle = IT::Refinement_obstacle;
  return obstacle == Obstacle::CONE                       ? "cone"
         : obstacle == Obstacle::SMALL_INPUT_ANGLE        ? "small_input_angle"
         : obstacle == Obstacle::BESIDE_SMALL_INPUT_ANGLE ? "beside_small_input_angle"
         : obstacle == Obstacle::UNREPRESENTABLE          ? "unrepresentable"
         : obstacle == Obstacle::TOO_SMALL                ? "too_small"
         : obstacle == Obstacle::WHOLE_EDGE               ? "whole_edge"
                                                          : "budget";
}

py::tuple refine(Surface& surface, double minimum_angle, double maximum_circumradius, double maximum_edge_length,
                 const std::optional<Booleans>& constrained, const std::optional<std::uint64_t>& maximum_number,
                 double maximum_deviation, const std::optional<double>& minimum_size,
                 const std::optional<double>& sharp_edge_angle, const std::optional<Booleans>& whole,
                 const std::optional<Doubles>& given_sizes, const std::optional<double>& normal_angle, double gradation)
{
  require(!minimum_size || *minimum_size >= 0, "minimum_size has to be at least 0");
  require(minimum_angle >= 0 && minimum_angle <= 30, "minimum_angle has to be from 0 to 30 degrees");
  require(maximum_circumradius > 0 && maximum_edge_length > 0 && maximum_deviation > 0,
          "maximum_circumradius, maximum_edge_length and maximum_deviation have to be positive");
  const std::vector<bool> is_constrained = copied_marks(constrained), is_whole = copied_marks(whole);
  const std::vector<double> sizes = given_sizes ? copied(*given_sizes) : std::vector<double>();
  const IT::Refinement_report report = surface.use([&](Triangulation& t) {
    check_marks(t, is_constrained);
    check_marks(t, is_whole);
    for (IT::Edge_index e : t.connectivity().edges())
      if (!is_constrained.empty() && is_constrained[e.idx()] && !t.is_input_edge(e))
        throw IT::Invalid_argument_error("edge " + std::to_string(e.idx()) +
                                         " is constrained, but is no edge of the input: constrain edges before they "
                                         "are flipped");
    const std::size_t n = t.input().number_of_vertices();
    require(sizes.empty() || sizes.size() == n, "there is not one size for each vertex of the input");
    const auto size = [&](IT::Vertex_index v) { return sizes.empty() ? HUGE_VAL : sizes[v.idx()]; };
    return IT::refine_Delaunay(t, parameters::minimum_angle(minimum_angle)
                                    .maximum_circumradius(maximum_circumradius)
                                    .maximum_edge_length(maximum_edge_length)
                                    .maximum_deviation(maximum_deviation)
                                    .minimum_size(minimum_size)
                                    .sharp_edge_angle(sharp_edge_angle)
                                    .maximum_normal_angle(normal_angle)
                                    .size_gradation(gradation)
                                    .size_map(boost::make_function_property_map<IT::Vertex_index, double>(size))
                                    .edge_is_constrained_map(constrained_edges(is_constrained))
                                    .whole_edges_map(constrained_edges(is_whole))
                                    .visitor(Signal_visitor())
                                    .maximum_number(maximum_number));
  });
  Numbers unrefined;
  py::dict number_of_faces;
  std::vector<std::int8_t> reasons;
  for (const IT::Unrefined_face& f : report.unrefined) {
    unrefined.push_back(f.face.idx());
    reasons.push_back(std::int8_t(f.reason));
  }
  const auto numbers = report.numbers_by_reason();
  for (std::size_t reason = 0; reason < numbers.size(); ++reason)
    number_of_faces[name_of(IT::Refinement_obstacle(reason))] = numbers[reason];
  return py::make_tuple(report.is_refined(), report.insertions, report.segment_splits, report.flips,
                        to_array(std::move(unrefined)), to_array(std::move(reasons)), number_of_faces,
                        report.minimum_size, report.status == IT::Refinement_status::REFINED);
}

py::array sharp_edges(Surface& surface, const Doubles& points, double degrees, double minimum_size)
{
  require(degrees >= 0 && degrees <= 180, "degrees has to be from 0 to 180");
  require(minimum_size >= 0, "minimum_size has to be at least 0");
  const std::vector<std::array<double, 3>> places = copied_rows(points);
  return to_array(surface.use([&](const Triangulation& t) {
    Numbers result;
    for (bool is_sharp : IT::sharp_edges(t.input(), places, degrees, minimum_size))
      result.push_back(is_sharp);
    return result;
  }));
}

// ----------------------------------------------------------------- matrices

py::tuple mass(Surface& surface, bool is_lumped)
{
  return to_sparse(surface.use(
    [&](const Triangulation& t) { return is_lumped ? IT::lumped_mass_matrix(t) : IT::Galerkin_mass_matrix(t); }));
}

// Where the inserted vertices lie in the input.
py::tuple inserted_vertices(Surface& surface)
{
  return surface
    .use([&](const Triangulation& t) {
      const IT::Delta_complex& input = t.input();
      Point_table result;
      for (auto v = input.number_of_vertices(); v < t.connectivity().number_of_vertices(); ++v) {
        IT::Surface_point point = t.location(IT::Vertex_index(v));
        const double sum = point.coordinates[0] + point.coordinates[1] + point.coordinates[2];
        for (double& x : point.coordinates)
          x /= sum;
        result.append(input, point, surface.input_sides()[input.face(point.halfedge).idx()]);
      }
      return result;
    })
    .to_arrays();
}

template <class Count>
auto count(const Count& of_complex)
{
  return [of_complex](Surface& surface) {
    return surface.use([&](const Triangulation& t) { return std::size_t((t.connectivity().*of_complex)()); });
  };
}

template <class Function>
auto array_of(const Function& function)
{
  return [function](Surface& surface) { return to_array(surface.use(function)); };
}

} // namespace

void add_triangulation(py::module_& module)
{
  py::class_<Surface>(module, "Surface")
    .def_static("from_points", &from_points, py::arg("points").noconvert(), py::arg("triangles").noconvert())
    .def_static("from_lengths", &from_lengths, py::arg("triangles").noconvert(), py::arg("lengths").noconvert(),
                py::arg("number_of_vertices"))
    .def_static("from_gluing", &from_gluing, py::arg("first").noconvert(), py::arg("second").noconvert(),
                py::arg("lengths").noconvert())
    .def_static("load", &load, py::arg("path"))
    .def("save", &save, py::arg("path"))
    .def("input_points", array_of(&input_points))
    .def(py::pickle(&state_of_surface, &surface_of_bytes))
    .def("copy",
         [](const Surface& surface) { return without_lock([&] { return std::make_unique<Surface>(surface); }); })
    .def("number_of_vertices", count(&IT::Delta_complex::number_of_vertices))
    .def("number_of_edges", count(&IT::Delta_complex::number_of_edges))
    .def("number_of_faces", count(&IT::Delta_complex::number_of_faces))
    .def("faces", array_of(&faces))
    .def("edges_of_faces", array_of(&edges_of_faces))
    .def("edges", array_of(&edges))
    .def("lengths", array_of([](const Triangulation& t) { return IT::edge_lengths(t); }))
    .def("weights", array_of(&weights))
    .def("areas", array_of([](const Triangulation& t) { return IT::face_areas(t); }))
    .def("corner_angles", array_of(&corner_angles))
    .def("flip_to_delaunay", &flip_to_Delaunay, py::arg("constrained").noconvert(), py::arg("maximum_number"))
    .def("verify", &verify, py::arg("constrained").noconvert())
    .def("refine", &refine, py::arg("minimum_angle"), py::arg("maximum_circumradius"), py::arg("maximum_edge_length"),
         py::arg("constrained").noconvert(), py::arg("maximum_number"), py::arg("maximum_deviation"),
         py::arg("minimum_size"), py::arg("sharp_edge_angle"), py::arg("whole").noconvert(),
         py::arg("sizes").noconvert(), py::arg("normal_angle"), py::arg("gradation"))
    .def("sharp_edges", &sharp_edges, py::arg("points").noconvert(), py::arg("degrees"), py::arg("minimum_size"))
    .def("stiffness",
         [](Surface& surface) {
           return to_sparse(surface.use([](const Triangulation& t) { return IT::stiffness_matrix(t); }));
         })
    .def("mass", &mass, py::arg("is_lumped"))
    .def("inserted_vertices", &inserted_vertices);
}

} // namespace idt_python

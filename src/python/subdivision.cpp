// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The common subdivision of the input and the current triangulation: its arrays, transfer of values, and points.

#include "python/Surface.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/saved_state.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace idt_python {

namespace {

using Numbers = std::vector<std::int64_t>;

// It never changes, and several threads may call its const member functions at once.
class Subdivision
{
public:
  Subdivision(const Triangulation& triangulation, std::vector<IT::Halfedge_index> input_sides)
    : subdivision_(triangulation, CGAL::parameters::visitor([] { return Signal_watch::goes_on(); })),
      location_(subdivision_), input_sides_(std::move(input_sides))
  {}

  const IT::Common_subdivision& get() const { return subdivision_; }
  const IT::Overlay& overlay() const { return subdivision_.overlay(); }
  const IT::Point_location& location() const { return location_; }
  const std::vector<IT::Halfedge_index>& input_sides() const { return input_sides_; }
  IT::Halfedge_index input_side(IT::Face_index f) const { return input_sides_[f.idx()]; }
  IT::Halfedge_index intrinsic_side(IT::Face_index f) const { return subdivision_.intrinsic().halfedge(f); }

  // Calls a function with each corner of each face, given by the halfedge to its vertex.
  template <class Visit>
  void for_each_corner(const Visit& visit) const
  {
    for (IT::Overlay::Face f : overlay().faces()) {
      const IT::Overlay::Halfedge first = overlay().halfedge(f);
      IT::Overlay::Halfedge h = first;
      do {
        visit(h);
        h = overlay().next(h);
      } while (h != first);
    }
  }

private:
  IT::Common_subdivision subdivision_;
  IT::Point_location location_; // refers to the subdivision
  std::vector<IT::Halfedge_index> input_sides_;
};

std::unique_ptr<Subdivision> subdivision_of(Surface& surface)
{
  return surface.use([&](const Triangulation& t) { return std::make_unique<Subdivision>(t, surface.input_sides()); });
}

py::bytes state_of_subdivision(const Subdivision& s)
{
  const std::size_t number_of_faces =
    std::size_t(s.get().input().number_of_faces()) + s.get().intrinsic().number_of_faces();
  return written_bytes(number_of_faces, [&](std::ostream& os) {
    without_lock([&] {
      IT::write_triangulation(os, s.get(), s.input_sides(), while_no_signal);
      return true;
    });
  });
}

std::unique_ptr<Subdivision> subdivision_of_state(const py::bytes& state)
{
  return subdivision_of(*surface_of_bytes(state));
}

// ---------------------------------------------------------------- the graph

py::tuple polygons(const Subdivision& s)
{
  auto [offsets, corners] = without_lock([&] {
    Numbers offsets, corners;
    s.for_each_corner([&](IT::Overlay::Halfedge h) {
      if (h == s.overlay().halfedge(s.overlay().face(h)))
        offsets.push_back(std::int64_t(corners.size()));
      corners.push_back(s.overlay().target(h).idx());
    });
    offsets.push_back(std::int64_t(corners.size()));
    return std::make_pair(std::move(offsets), std::move(corners));
  });
  return py::make_tuple(to_array(std::move(offsets)), to_array(std::move(corners)));
}

py::tuple faces_of_polygons(const Subdivision& s)
{
  Numbers input, intrinsic;
  for (IT::Overlay::Face f : s.overlay().faces()) {
    input.push_back(s.overlay().input_face(f).idx());
    intrinsic.push_back(s.overlay().intrinsic_face(f).idx());
  }
  return py::make_tuple(to_array(std::move(input)), to_array(std::move(intrinsic)));
}

std::int64_t edge_or_none(IT::Halfedge_index h) { return h.is_valid() ? std::int64_t(h.idx() >> 1) : -1; }

py::tuple segments(const Subdivision& s)
{
  std::vector<std::array<std::int64_t, 2>> ends;
  Numbers input, intrinsic;
  for (IT::Overlay::Segment segment : s.overlay().segments()) {
    const IT::Overlay::Halfedge h = s.overlay().halfedge(segment);
    ends.push_back({s.overlay().source(h).idx(), s.overlay().target(h).idx()});
    input.push_back(edge_or_none(s.overlay().input_halfedge(h)));
    intrinsic.push_back(edge_or_none(s.overlay().intrinsic_halfedge(h)));
  }
  return py::make_tuple(to_array(std::move(ends)), to_array(std::move(input)), to_array(std::move(intrinsic)));
}

// ------------------------------------------------------------------- values

// \param values for each corner of each input face in order
// \return for each corner of each polygon in order
std::vector<double> at_corners(const Subdivision& s, const std::vector<double>& values)
{
  const IT::Delta_complex& input = s.get().input();
  std::vector<double> at_targets(input.number_of_halfedges());
  for (IT::Face_index f : input.faces()) {
    IT::Halfedge_index h = input.prev(s.input_side(f)); // to the first corner
    for (std::size_t i = 0; i < 3; ++i, h = input.next(h))
      at_targets[h.idx()] = values[3 * std::size_t(f.idx()) + i];
  }
  const std::vector<double> found = IT::interpolate_input_corner_values(s.get(), at_targets);
  std::vector<double> result;
  s.for_each_corner([&](IT::Overlay::Halfedge h) { result.push_back(found[h.idx()]); });
  return result;
}

py::array interpolate_corners(const Subdivision& s, const Doubles& values)
{
  std::vector<double> given = copied(values);
  require(given.size() == 3 * std::size_t(s.get().input().number_of_faces()), "there is not one value for each corner");
  return to_array(without_lock([&] { return at_corners(s, given); }));
}

py::tuple mass_matrices(const Subdivision& s)
{
  IT::Transfer_mass_matrices result = without_lock([&] { return IT::transfer_mass_matrices(s.get()); });
  return py::make_tuple(to_sparse(std::move(result.input)), to_sparse(std::move(result.intrinsic)),
                        to_sparse(std::move(result.mixed)));
}

// -------------------------------------------------------- straight triangles

template <class Range>
Numbers numbers_of(const Range& elements)
{
  Numbers result;
  for (const auto& element : elements)
    if constexpr (std::is_integral_v<std::decay_t<decltype(element)>>)
      result.push_back(element);
    else
      result.push_back(element.idx());
  return result;
}

py::tuple straight_mesh(const Subdivision& s, const Doubles& points, const std::optional<Booleans>& marked,
                        double thin_angle, double maximum_deviation, const std::optional<Booleans>& fixed)
{
  const std::vector<std::array<double, 3>> places = copied_rows(points);
  const auto copied_marks = [](const std::optional<Booleans>& marks) {
    std::vector<bool> result;
    if (marks)
      for (py::ssize_t i = 0; i < marks->shape(0); ++i)
        result.push_back(marks->at(i));
    return result;
  };
  const std::vector<bool> is_marked = copied_marks(marked), is_fixed = copied_marks(fixed);
  IT::Straight_mesh mesh = without_lock([&] {
    return IT::straight_mesh(s.get(), places, is_marked, thin_angle, maximum_deviation, is_fixed, while_no_signal);
  });
  std::vector<std::array<std::int64_t, 2>> edges;
  for (const auto& [a, b] : mesh.marked_edges)
    edges.push_back({a, b});
  std::vector<std::array<std::int64_t, 2>> crossing;
  for (const auto& [s, t] : mesh.crossing_triangles)
    crossing.push_back({s, t});
  std::vector<std::array<std::int64_t, 2>> folded;
  for (const auto& [v, w] : mesh.folded_edges)
    folded.push_back({v, w});
  py::array triangles = to_numbers(mesh.triangles);
  const bool can_be_filled = mesh.can_be_filled();
  const std::string defects = message(mesh); // which needs the points
  return py::make_tuple(to_array(std::move(mesh.points)), to_array(numbers_of(mesh.points_of_vertices)),
                        to_array(numbers_of(mesh.merged_vertices)), triangles, to_array(numbers_of(mesh.faces)),
                        to_array(numbers_of(mesh.input_faces)), to_array(numbers_of(mesh.regions)),
                        to_array(std::move(edges)), to_array(numbers_of(mesh.lines)), mesh.deviation,
                        to_array(std::vector<double>(mesh.deviation_place.begin(), mesh.deviation_place.end())),
                        mesh.minimum_angle, to_array(numbers_of(mesh.thin_triangles)), mesh.number_of_sharp_corners,
                        mesh.sufficient_deviation, to_array(numbers_of(mesh.loops)),
                        to_array(numbers_of(mesh.multiple_edges)), mesh.is_surface(), defects,
                        mesh.number_of_removed_pieces, mesh.number_of_rods, mesh.number_of_new_components,
                        to_array(std::move(crossing)), mesh.number_of_new_crossings, mesh.area_of_films,
                        mesh.minimum_dihedral_angle, to_array(std::move(folded)), can_be_filled);
}

// ------------------------------------------------------------------- points

void check_face(const IT::Delta_complex& complex, std::uint32_t f)
{
  if (f >= complex.number_of_faces())
    throw IT::Invalid_argument_error("there is no face " + std::to_string(f) + ": there are " +
                                     std::to_string(complex.number_of_faces()));
}

template <class Locate>
py::tuple locate(const IT::Delta_complex& from, const Indices& faces, const Doubles& coordinates,
                 const Locate& locate_point)
{
  const auto of_faces = copied(faces);
  const auto rows = copied_rows(coordinates);
  require(of_faces.size() == rows.size(), "there are not as many faces as coordinates");
  return without_lock([&] {
           Point_table result;
           for (std::size_t i = 0; i < rows.size(); ++i) {
             if (i % 64 == 0)
               Signal_watch::check();
             check_face(from, of_faces[i]);
             locate_point(IT::Face_index(of_faces[i]), rows[i], result);
           }
           return result;
         })
    .to_arrays();
}

py::tuple to_intrinsic(const Subdivision& s, const Indices& faces, const Doubles& coordinates)
{
  return locate(s.get().input(), faces, coordinates, [&](IT::Face_index f, const auto& row, Point_table& result) {
    const IT::Delta_complex& complex = s.get().intrinsic();
    const IT::Surface_point point = s.location().input_to_intrinsic({s.input_side(f), row});
    result.append(complex, point, s.intrinsic_side(complex.face(point.halfedge)));
  });
}

py::tuple to_input(const Subdivision& s, const Indices& faces, const Doubles& coordinates)
{
  return locate(s.get().intrinsic(), faces, coordinates, [&](IT::Face_index f, const auto& row, Point_table& result) {
    const IT::Delta_complex& complex = s.get().input();
    const IT::Surface_point point = s.location().intrinsic_to_input({s.intrinsic_side(f), row});
    result.append(complex, point, s.input_side(complex.face(point.halfedge)));
  });
}

} // namespace

void add_subdivision(py::module_& module)
{
  module.def("subdivision", &subdivision_of);
  py::class_<Subdivision>(module, "Subdivision")
    .def(py::pickle(&state_of_subdivision, &subdivision_of_state))
    .def("number_of_input_vertices", [](const Subdivision& s) { return s.overlay().number_of_input_vertices(); })
    .def("number_of_original_vertices", [](const Subdivision& s) { return s.overlay().number_of_original_vertices(); })
    .def("number_of_vertices", [](const Subdivision& s) { return s.overlay().number_of_vertices(); })
    .def("polygons", &polygons)
    .def("faces_of_polygons", &faces_of_polygons)
    .def("segments", &segments)
    .def("input_matrix",
         [](const Subdivision& s) {
           return to_sparse(without_lock([&] { return IT::input_interpolation_matrix(s.get()); }));
         })
    .def("intrinsic_matrix",
         [](const Subdivision& s) {
           return to_sparse(without_lock([&] { return IT::intrinsic_interpolation_matrix(s.get()); }));
         })
    .def("interpolate_corners", &interpolate_corners, py::arg("values").noconvert())
    .def("mass_matrices", &mass_matrices)
    .def("number_of_input_edges", [](const Subdivision& s) { return s.overlay().number_of_input_edges(); })
    .def("straight_mesh", &straight_mesh, py::arg("points").noconvert(), py::arg("marked"), py::arg("thin_angle"),
         py::arg("maximum_deviation"), py::arg("fixed"))
    .def("to_intrinsic", &to_intrinsic, py::arg("faces").noconvert(), py::arg("coordinates").noconvert())
    .def("to_input", &to_input, py::arg("faces").noconvert(), py::arg("coordinates").noconvert());
}

} // namespace idt_python

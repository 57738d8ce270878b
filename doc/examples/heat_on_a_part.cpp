// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stationary heat in a bracket as a CAD program exports it: one end is kept cold, heat flows in at the other one, the
// rest of the border is insulated. Its triangles are long and thin, and a sliver runs along the bend.
//
//   heat_on_a_part [FILE.vtk]      # for ParaView

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <Eigen/SparseCholesky>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Points = std::vector<std::array<double, 3>>;

namespace {

// The position of a vertex of the refined triangulation.
std::array<double, 3> place(const Triangulation& t, const Points& points, IT::Vertex_index v)
{
  return t.is_inserted(v) ? IT::point_in_space(t.input(), points, t.location(v)) : points[v.idx()];
}

// The overlay shows the part as it is, with the values of the intrinsic triangulation.
void write_vtk(const char* path, const IT::Common_subdivision& subdivision, const Points& points,
               const std::vector<double>& values)
{
  const IT::Overlay& overlay = subdivision.overlay();
  std::ofstream os(path);
  os.precision(17);
  os << "# vtk DataFile Version 3.0\ntemperature\nASCII\nDATASET POLYDATA\nPOINTS " << overlay.number_of_vertices()
     << " double\n";
  for (IT::Overlay::Vertex v : overlay.vertices()) {
    const auto [x, y, z] = subdivision.point(v, points);
    os << x << ' ' << y << ' ' << z << '\n';
  }
  std::vector<std::vector<std::uint32_t>> polygons;
  std::size_t size = 0;
  for (IT::Overlay::Face f : overlay.faces()) {
    polygons.emplace_back();
    const IT::Overlay::Halfedge first = overlay.halfedge(f);
    IT::Overlay::Halfedge h = first;
    do {
      polygons.back().push_back(overlay.target(h).idx());
      h = overlay.next(h);
    } while (h != first);
    size += polygons.back().size() + 1;
  }
  os << "POLYGONS " << polygons.size() << ' ' << size << '\n';
  for (const auto& polygon : polygons) {
    os << polygon.size();
    for (std::uint32_t v : polygon)
      os << ' ' << v;
    os << '\n';
  }
  os << "POINT_DATA " << values.size() << "\nSCALARS temperature double 1\nLOOKUP_TABLE default\n";
  for (double value : values)
    os << value << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  // Four rows of vertices: the heated end, both sides of the sliver, the cold end.
  const double width = 1e-7;
  Points points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::uint32_t n = 7;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double x = 3. * i / (n - 1), y = 3. * i * i / ((n - 1) * (n - 1));
    for (const std::array<double, 3>& p : {std::array{y, -1., 0.}, {x, 0., 0.}, {x, 0., width}, {y, 0., 1.}})
      points.push_back(p);
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i)
    for (std::uint32_t row = 0; row < 3; ++row) {
      const std::uint32_t a = 4 * i + row, b = a + 4;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }

  // The bend is kept as one line of edges. Nothing is refined for the sliver's sake.
  Triangulation t(IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  const double smallest = 1e-3;
  const std::vector<bool> is_sharp = IT::sharp_edges(t.connectivity(), points, 30, smallest);
  const IT::Refinement_report report =
    IT::refine_Delaunay(t, CGAL::parameters::maximum_edge_length(0.2).minimum_size(smallest).edge_is_constrained_map(
                             boost::make_function_property_map<IT::Edge_index, bool>(
                               [&](IT::Edge_index e) { return bool(is_sharp[e.idx()]); })));
  const IT::Delta_complex& complex = t.connectivity();
  std::cout << std::count(is_sharp.begin(), is_sharp.end(), true) << " sharp edges, "
            << report.insertions + report.segment_splits << " new vertices, " << report.unrefined.size()
            << " faces left\n";

  // The matrix has natural borders, which are insulated by default. Heat flows in at 1 for each unit of length.
  const Eigen::SparseMatrix<double> stiffness = IT::stiffness_matrix(t);
  const Eigen::Index size = stiffness.rows();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
  std::vector<bool> is_cold(std::size_t(size), false);
  for (IT::Edge_index e : complex.edges()) {
    if (!complex.is_border(e))
      continue;
    const std::array<IT::Vertex_index, 2> ends = {complex.source(complex.halfedge(e)),
                                                  complex.target(complex.halfedge(e))};
    const auto p = place(t, points, ends[0]), q = place(t, points, ends[1]);
    for (IT::Vertex_index v : ends) {
      if (p[1] == -1 && q[1] == -1)
        load[v.idx()] += t.length(e) / 2;
      if (p[2] == 1 && q[2] == 1)
        is_cold[v.idx()] = true;
    }
  }
  // Cold vertices have the temperature 0: their rows and columns become those of the unit matrix.
  Eigen::SparseMatrix<double> matrix = stiffness;
  for (Eigen::Index column = 0; column < size; ++column) {
    if (is_cold[std::size_t(column)])
      load[column] = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
      if (is_cold[std::size_t(entry.row())] || is_cold[std::size_t(column)])
        entry.valueRef() = entry.row() == column ? 1 : 0;
  }
  const Eigen::VectorXd temperature = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(load);

  // Laid flat, the bracket is a strip: the temperature is the distance from the cold end, and linear elements find it
  // up to rounding.
  double error = 0;
  for (IT::Vertex_index v : complex.vertices()) {
    const auto p = place(t, points, v);
    error = std::max(error, std::abs(temperature[v.idx()] - (1 - p[2] - p[1])));
  }
  std::cout << "largest temperature " << temperature.maxCoeff() << ", error " << error << '\n';
  if (argc > 1) {
    const IT::Common_subdivision subdivision(t);
    write_vtk(argv[1], subdivision, points, IT::interpolate_intrinsic_values(subdivision, temperature));
  }
  return report.status == IT::Refinement_status::REFINED && error < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}

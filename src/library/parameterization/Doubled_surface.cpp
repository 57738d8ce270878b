// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of Doubled_surface.h.

#include <CGAL/Intrinsic_triangulations/internal/parameterization/Doubled_surface.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

Doubled_surface::Doubled_surface(const Triangulation& surface, const Progress_function& progress)
  : triangulation(Delta_complex(), Triangulation::Point_vector())
{
  if (surface.connectivity().number_of_faces() == 0)
    throw Invalid_surface_error(Invalid_surface_error::Defect::EMPTY, 0, 1, "there is no face");
  const auto edges = surface.connectivity().edges();
  is_doubled =
    std::any_of(edges.begin(), edges.end(), [&](Edge_index e) { return surface.connectivity().is_border(e); });
  if (is_doubled) {
    glue(surface);
  } else {
    triangulation = surface;
    vertices.assign(surface.connectivity().vertices().begin(), surface.connectivity().vertices().end());
    images = vertices;
    halfedges.assign(surface.input().halfedges().begin(), surface.input().halfedges().end());
  }
  flip_to_Delaunay(triangulation, parameters::visitor([&] { return !progress || progress(0); }));
  lengths = exact_edge_lengths(triangulation);
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  if (!std::isfinite(longest))
    throw Numerical_error("lengths leave the range of double");
  const int exponent = std::ilogb(longest);
  for (double& l : lengths)
    l = std::ldexp(l, -exponent);
  unit = exponent + (is_doubled ? surface.unit_exponent() : 0); // a double is made in the internal unit
}

void Doubled_surface::glue(const Triangulation& surface)
{
  const Delta_complex& input = surface.input();
  if (input.number_of_vertices() != surface.connectivity().number_of_vertices())
    throw Invalid_argument_error(
      "vertices were inserted into a surface with a border: make a mesh of its triangles first, "
      "or map the surface without them");
  const std::size_t n = input.number_of_faces();
  std::vector<std::size_t> side_of(input.number_of_halfedges());
  for (Face_index f : input.faces()) {
    Halfedge_index h = input.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = input.next(h))
      side_of[h.idx()] = 3 * f.idx() + i;
  }
  // The corners of an image come in the opposite order.
  const auto mirrored = [n](std::size_t side) { return 3 * (n + side / 3) + 2 - side % 3; };
  std::vector<std::array<std::size_t, 2>> glued;
  for (Edge_index e : input.edges()) {
    const Halfedge_index h = input.halfedge(e), g = input.opposite(h);
    if (input.is_border(e)) {
      const std::size_t side = side_of[(input.is_border(h) ? g : h).idx()];
      glued.push_back({side, mirrored(side)});
    } else {
      glued.push_back({side_of[h.idx()], side_of[g.idx()]});
      glued.push_back({mirrored(side_of[h.idx()]), mirrored(side_of[g.idx()])});
    }
  }
  Delta_complex complex = make_Delta_complex_from_gluing(2 * n, glued);

  const Input_metric& metric = surface.input_metric();
  Triangulation::Point_vector points(metric.points().empty() ? 0 : complex.number_of_vertices(), {0, 0, 0});
  std::vector<double> lengths(metric.points().empty() ? complex.number_of_edges() : 0);
  vertices.resize(complex.number_of_vertices());
  images.resize(input.number_of_vertices());
  halfedges.resize(input.number_of_halfedges());
  for (Face_index f : input.faces()) {
    Halfedge_index h = input.halfedge(f), copy = complex.halfedge(f),
                   image = complex.prev(complex.halfedge(Face_index(std::uint32_t(n + f.idx()))));
    for (int i = 0; i < 3; ++i, h = input.next(h), copy = complex.next(copy), image = complex.prev(image)) {
      const Vertex_index v = input.source(h), in_copy = complex.source(copy), in_image = complex.target(image);
      halfedges[h.idx()] = copy;
      vertices[in_copy.idx()] = vertices[in_image.idx()] = v;
      images[v.idx()] = in_copy;
      if (!points.empty())
        points[in_copy.idx()] = points[in_image.idx()] = metric.points()[v.idx()];
      else
        lengths[complex.edge(copy).idx()] = lengths[complex.edge(image).idx()] =
          metric.lengths().empty() ? std::sqrt(metric.squared_length_double_double(input, input.edge(h)).hi())
                                   : metric.lengths()[input.edge(h).idx()];
    }
  }
  triangulation = points.empty() ? Triangulation::from_lengths(std::move(complex), std::move(lengths))
                                 : Triangulation(std::move(complex), std::move(points));
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A vector transported over a fold, and the folded sheet laid out around a corner.

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  // Two sides of a box: a sheet of squares, folded up by a right angle behind the sixth column.
  const int columns = 12, rows = 6;
  Mesh mesh;
  std::vector<std::array<double, 3>> points;
  std::vector<Mesh::Vertex_index> v;
  for (int y = 0; y <= rows; ++y)
    for (int x = 0; x <= columns; ++x) {
      points.push_back({x <= 6 ? double(x) : 6., double(y), x <= 6 ? 0. : double(x - 6)});
      v.push_back(mesh.add_vertex({points.back()[0], points.back()[1], points.back()[2]}));
    }
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const std::size_t a = std::size_t(y * (columns + 1) + x), b = a + 1, c = a + columns + 2, d = c - 1;
      mesh.add_face(v[a], v[b], v[c]);
      mesh.add_face(v[a], v[c], v[d]);
    }
  const auto [triangulation, report] = IT::intrinsic_Delaunay_triangulation(mesh);

  const IT::Vector_heat_method heat(triangulation);
  const IT::Vertex_index source(0), behind_the_fold(12);
  const auto field = heat.transport_tangent_vectors({{source, {1, 0}}});
  const auto frames = IT::vertex_frames(triangulation, points);
  const auto print = [&](const char* text, IT::Vertex_index w) {
    const auto vector = frames[w.idx()].in_space(field[w.idx()]);
    std::cout << text << std::round(vector[0] * 1e6) / 1e6 + 0. << ' ' << std::round(vector[1] * 1e6) / 1e6 + 0. << ' '
              << std::round(vector[2] * 1e6) / 1e6 + 0. << '\n';
  };
  print("a vector at a corner:        ", source);
  print("carried over the fold:       ", behind_the_fold);

  // The sheet can be laid out, so distances in the logarithmic map are those of a rectangle.
  const auto map = heat.log_map(source);
  const std::complex<double> opposite = map.back();
  std::cout << "to the opposite corner:      " << std::hypot(opposite.real(), opposite.imag()) << ", exactly "
            << std::hypot(columns, rows) << '\n';
  return EXIT_SUCCESS;
}

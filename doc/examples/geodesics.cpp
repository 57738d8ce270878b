// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A path over a folded sheet, a closed curve round a tube, and a line in a direction.

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main()
{
  // A square tube of side 1: rings of four vertices each.
  const int rings = 6;
  Mesh tube;
  std::vector<Mesh::Vertex_index> v;
  for (int z = 0; z < rings; ++z)
    for (const auto& [x, y] : {std::array<double, 2>{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      v.push_back(tube.add_vertex({x, y, double(z)}));
  for (int z = 0; z + 1 < rings; ++z)
    for (int i = 0; i < 4; ++i) {
      const int a = 4 * z + i, b = 4 * z + (i + 1) % 4;
      tube.add_face(v[a], v[b], v[b + 4]);
      tube.add_face(v[a], v[b + 4], v[a + 4]);
    }

  // From a corner of the first ring to the opposite one of the last: two sides wide and five long.
  const IT::Geodesic_path path = IT::geodesic_path(tube, v[0], v[4 * 5 + 2]);
  std::cout << "path: " << path.initial_length << " along edges, " << path.length << " after " << path.report.flips
            << " flips, " << (path.is_geodesic ? "proven" : "not") << " locally shortest\n";
  for (const auto& [x, y, z] : path.positions)
    std::cout << "  " << x << ' ' << y << ' ' << z << '\n';

  // A zigzag round the tube.
  auto triangulation = IT::intrinsic_triangulation(tube);
  std::vector<IT::Halfedge_index> loop;
  const int stops[] = {8, 13, 10, 15, 8};
  for (int i = 0; i < 4; ++i)
    for (IT::Halfedge_index h :
         IT::shortest_edge_path(triangulation, IT::Vertex_index(stops[i]), IT::Vertex_index(stops[i + 1])))
      loop.push_back(h);
  IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(triangulation);
  network.add_closed_path(loop);
  std::cout << "loop: " << network.length(0);
  network.shorten();
  std::cout << ", then " << network.length(0) << '\n';

  // From a vertex in the middle, 0.3 radians above its horizontal edge.
  const IT::Delta_complex& complex = triangulation.input();
  IT::Halfedge_index horizontal;
  for (IT::Halfedge_index h : complex.halfedges())
    if (complex.source(h).idx() == 8 && complex.target(h).idx() == 9)
      horizontal = h;
  const IT::Traced_geodesic line =
    IT::trace_geodesic(triangulation, IT::direction_at_vertex(triangulation, horizontal, 0.3), 100);
  std::cout << "line: ends at the border after " << line.length << ", through " << line.points.size() - 1 << " faces\n";

  const bool is_right = path.is_geodesic && std::abs(path.length - std::sqrt(29.)) < 1e-14 && network.is_geodesic() &&
                        std::abs(network.length(0) - 4) < 1e-14 && line.status == IT::Trace_status::AT_BORDER &&
                        std::abs(line.length - 3 / std::sin(0.3)) < 1e-13;
  return is_right ? EXIT_SUCCESS : EXIT_FAILURE;
}

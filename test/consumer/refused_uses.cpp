// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Must not compile, whichever of the macros is defined.

#if defined(WITHOUT_EIGEN)
#include <CGAL/Intrinsic_triangulations/Heat_method.h>
#else

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

#ifdef NUMBERS_WITHOUT_ROOTS
bool use()
{
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}};
  const std::vector<std::array<int, 3>> triangles{{0, 1, 2}, {1, 0, 3}};
  IT::Intrinsic_triangulation<IT::NUMBERS_WITHOUT_ROOTS<CGAL::Gmpq>> triangulation(
    IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(triangulation);
  const auto length = triangulation.length(IT::Edge_index(0));
  return length > length;
}
#endif

#ifdef POINTS_WITHOUT_COORDINATES
void use(Mesh& mesh)
{
  const auto numbers = mesh.add_property_map<Mesh::Vertex_index, int>("v:number").first;
  IT::intrinsic_Delaunay_triangulation(mesh, CGAL::parameters::vertex_point_map(numbers));
}
#endif

#ifdef CONSTRAINTS_OF_VERTICES
void use(Mesh& mesh)
{
  const auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed").first;
  IT::intrinsic_Delaunay_triangulation(mesh, CGAL::parameters::edge_is_constrained_map(is_fixed));
}
#endif

#ifdef VALUES_THAT_ARE_TEXTS
auto use(const IT::Common_subdivision& subdivision, const std::vector<std::string>& values)
{
  return IT::interpolate_input_corner_values(subdivision, values);
}
#endif

#endif

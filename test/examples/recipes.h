// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Declarations that the code in doc/recipes.md assumes.

#ifndef RECIPES_H
#define RECIPES_H

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/repair_polygons.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/transfer_matrices.h>
#include <CGAL/Intrinsic_triangulations/tufted_Laplacian.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A tetrahedron.
const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0}, {2, 1, 0}, {2, 0, 1}};
const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

const Mesh mesh = [] {
  Mesh result;
  for (const auto& [x, y, z] : points)
    result.add_vertex({x, y, z});
  for (const auto& [i, j, k] : triangles)
    result.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(j), Mesh::Vertex_index(k));
  return result;
}();

// Two triangles with opposite orientations.
const std::string file = [] {
  const std::string name = "recipes.off";
  std::ofstream(name) << "OFF\n4 2 0\n0 0 0\n4 0 0\n2 1 0\n2 0 1\n3 0 1 2\n3 0 1 3\n";
  return name;
}();

#endif // RECIPES_H

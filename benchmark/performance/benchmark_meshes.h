// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Meshes and memory for the benchmarks.

#ifndef IDT_BENCHMARK_MESHES_H
#define IDT_BENCHMARK_MESHES_H

#include "samples/sample_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

// Freed memory stays with the process, so that a run reuses the pages of the previous one. Otherwise the kernel would
// clear new pages each time, which takes a good part of the time, varies a lot, and has nothing to do with the
// algorithm.
inline void keep_freed_memory()
{
#ifdef __GLIBC__
  // (M_MMAP_THRESHOLD would not do: it is refused above 32 MB.)
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

inline Mesh mesh_of(const samples::Indexed_triangles& triangles)
{
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(triangles.points, triangles.triangles, mesh);
  return mesh;
}

inline Mesh read_mesh(const std::string& path)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(path, mesh) || mesh.is_empty() || !CGAL::is_triangle_mesh(mesh)) {
    std::cerr << path << ": not a triangle mesh that can be read\n";
    std::exit(2);
  }
  return mesh;
}

// table1/horse.off in the folder that the environment variable IDT_DATA_DIR names, or in
// shared/data beside the checkout; an empty path, and a note, if it is not there.
inline std::string horse_path()
{
  const char* const variable = std::getenv("IDT_DATA_DIR");
  const std::filesystem::path data =
    variable ? std::filesystem::path(variable)
             : std::filesystem::path(__FILE__).parent_path() / ".." / ".." / ".." / "shared" / "data";
  const std::filesystem::path horse = data / "table1" / "horse.off";
  if (std::filesystem::exists(horse))
    return horse.string();
  std::cerr << "without table1/horse.off: set IDT_DATA_DIR\n";
  return std::string();
}

inline std::optional<Mesh> read_horse()
{
  const std::string path = horse_path();
  return path.empty() ? std::nullopt : std::make_optional(read_mesh(path));
}

#endif // IDT_BENCHMARK_MESHES_H

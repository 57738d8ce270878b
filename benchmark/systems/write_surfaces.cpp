// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the surfaces that all systems get, as files of the folder, and prints name and number of faces of each.
//
//   write_system_surfaces FOLDER [MESH...]
//
// Meshes that this package cannot take either, and those with more than 100,000 faces, are omitted.

#include "input/Surface.h"
#include "surfaces.h"

#include <exception>
#include <filesystem>
#include <iostream>

namespace {

using namespace systems;

constexpr std::size_t most_faces = 100000;

void write(const std::filesystem::path& folder, const Named_surface& named)
{
  write_surface((folder / (named.name + ".surface")).string(), named.surface);
  std::cout << named.name << ' ' << named.surface.triangles.corners.size() << '\n';
}

} // namespace

int main(int argc, char** argv)
{
  if (argc < 2) {
    std::cerr << "expected: FOLDER [MESH...]\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  try {
    for (const Named_surface& named : generated_surfaces())
      write(folder, named);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  for (int i = 2; i < argc; ++i) {
    try {
      const idt::Surface file = idt::load_surface(argv[i]);
      if (file.connectivity.number_of_faces() > most_faces || !file.has_points())
        continue;
      Surface surface;
      surface.number_of_vertices = file.points.size();
      surface.points = file.points;
      surface.triangles = triangles_of(file.connectivity);
      write(folder, {std::filesystem::path(argv[i]).filename().string(), surface});
    } catch (const std::exception& error) {
      std::cerr << error.what() << '\n';
    }
  }
  return 0;
}

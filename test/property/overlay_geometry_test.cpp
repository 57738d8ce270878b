// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay laid out in the faces of both triangulations: convex polygons of the same shape, that
// fill both, on meshes and on surfaces that are hard for rounded numbers.

#include "evaluation_data.h"
#include "property/overlay_geometry.h"

#include "samples/sample_surfaces.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using overlay_geometry::check_overlay;
using overlay_geometry::Overlay_numbers;

samples::Indexed_triangles read_off(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  EXPECT_TRUE(CGAL::IO::read_OFF(file, points, polygons)) << path;
  samples::Indexed_triangles surface;
  for (const auto& p : points)
    surface.points.push_back({p.x(), p.y(), p.z()});
  for (const std::vector<std::size_t>& p : polygons)
    surface.triangles.push_back({std::uint32_t(p.at(0)), std::uint32_t(p.at(1)), std::uint32_t(p.at(2))});
  return surface;
}

std::vector<std::filesystem::path> meshes(const char* folder)
{
  std::vector<std::filesystem::path> paths;
  if (!evaluation_data().empty())
    for (const auto& entry : std::filesystem::directory_iterator(evaluation_data() / folder))
      if (entry.path().extension() == ".off")
        paths.push_back(entry.path());
  return paths;
}

struct Row
{
  const char* name;
  std::uint32_t simple, longest, crossings; // no crossings: the paper does not tell
};

} // namespace

// The overlay's own numbers, whatever the order of the flips.
TEST(Overlay_geometry, OfTable1)
{
  if (evaluation_data().empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  for (const Row& row : {Row{"cathead", 40, 3, 0}, Row{"bunnyhead", 275, 6, 0}, Row{"beautiful_freak", 364, 12, 0},
                         Row{"hygeia", 2862, 6, 0}, Row{"horse", 3124, 7, 4026}}) {
    SCOPED_TRACE(row.name);
    const Overlay_numbers numbers =
      check_overlay(read_off(evaluation_data() / "table1" / (std::string(row.name) + ".off")));
    EXPECT_EQ(numbers.simple, row.simple);
    EXPECT_EQ(numbers.longest, row.longest);
    if (row.crossings > 0) {
      EXPECT_EQ(numbers.crossings, row.crossings);
    }
  }
}

TEST(Overlay_geometry, OfManyMeshes)
{
  const auto paths = meshes("good");
  if (paths.empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  for (const std::filesystem::path& path : paths) {
    SCOPED_TRACE(path.filename().string());
    check_overlay(read_off(path));
  }
}

TEST(Overlay_geometry, OfPrisms)
{
  for (std::size_t n : {3, 4, 5, 12, 31, 80, 240, 960})
    for (std::uint64_t seed : {0, 1}) {
      SCOPED_TRACE(n);
      check_overlay(samples::prism(n, seed));
    }
}

TEST(Overlay_geometry, OfCaps)
{
  for (std::uint64_t seed : {0, 1}) {
    for (int k = 1; k <= 17; ++k) {
      SCOPED_TRACE(k);
      check_overlay(samples::cap(std::pow(10., -k), seed));
    }
    check_overlay(samples::cap(0, seed));
  }
}

TEST(Overlay_geometry, OfSliverSheets)
{
  for (double x : {1e-3, 1e-6, 1e-9, 1e-12})
    for (double z : {0., 1e-3, 1e-9, 1e-12}) {
      SCOPED_TRACE(std::to_string(std::log10(x)) + " " + std::to_string(std::log10(z)));
      check_overlay(samples::sliver_sheet(14, x, z));
    }
}

TEST(Overlay_geometry, OfHelicalTubes)
{
  for (double pitch : {1e-3, 1., 30., 1e3, 1e5, 1e7})
    for (std::size_t n : {4, 5, 60}) {
      SCOPED_TRACE(std::to_string(n) + " " + std::to_string(pitch));
      check_overlay(samples::helical_tube(n, pitch));
    }
}

TEST(Overlay_geometry, OfGridsOfTies)
{
  for (std::uint64_t seed : {0, 1, 2})
    check_overlay(samples::random_diagonal_grid(20, 20, seed + 1, seed));
  for (double shear : {1., 5., 7.7, 100.})
    check_overlay(samples::sheared_grid(10, 10, shear));
  check_overlay(samples::strip(500, 60));
  check_overlay(samples::strip(100, 40, 1e-5));
  check_overlay(samples::pillow(100));
}

TEST(Overlay_geometry, OfRoundSurfaces)
{
  for (std::size_t rows : {1, 4, 16, 64, 256}) {
    SCOPED_TRACE(rows);
    check_overlay(samples::Schwarz_lantern(16, rows));
  }
  check_overlay(samples::latitude_longitude_sphere(3, 2));
  check_overlay(samples::latitude_longitude_sphere());
  check_overlay(samples::torus());
  check_overlay(samples::bad_torus(60, 60));
  check_overlay(samples::bumpy_sphere());
  check_overlay(samples::disk_with_spike());
}

TEST(Overlay_geometry, OfGluings)
{
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const std::size_t n = 1 + seed % 41;
    check_overlay(samples::random_gluing(n, seed, n % 2 == 1 || seed % 3 == 0, seed % 2 == 0));
  }
  check_overlay(samples::one_vertex_torus());
  check_overlay(samples::self_glued_triangle());
  check_overlay(samples::self_glued_sphere());
  check_overlay(samples::self_glued_sphere(1, 1e4, 1));
  for (double shear : {10., 123.456, 1000.})
    check_overlay(samples::sheared_one_vertex_torus(shear));
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole models that are exactly symmetric, as modellers make them: across the plane there are ties
// with many independent square roots. Each is decided, also where random flips before make long strips.

#include "evaluation_data.h"
#include "mirrored_surface.h"

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <variant>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Counts
{
  std::size_t surfaces = 0, ties = 0, by_symmetry = 0;
};

void flip_at_random(Triangulation& t, std::size_t number)
{
  std::mt19937 random(1);
  const auto n = t.connectivity().number_of_edges();
  for (std::size_t i = 0; i < number; ++i) {
    const IT::Edge_index e(random() % n);
    if (t.connectivity().is_flippable(e))
      t.flip(e);
  }
}

void check(const samples::Indexed_triangles& surface, std::size_t flips_before, Counts& counts)
{
  Triangulation t(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
  flip_at_random(t, flips_before);
  EXPECT_EQ(IT::flip_to_Delaunay(t).status, IT::Flip_status::DELAUNAY);
  const IT::Delaunay_verification verification = IT::verify_Delaunay(t);
  EXPECT_TRUE(verification.is_Delaunay());
  ++counts.surfaces;
  counts.ties += verification.ties;
  counts.by_symmetry += t.stage_counts()[IT::Stage::CONGRUENCE];
}

// The surface, cut and mirrored across each axis, as far as that makes a manifold.
void check_mirrored(const samples::Indexed_triangles& surface, Counts& counts)
{
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const samples::Indexed_triangles mirrored = mirrored_surface::mirrored(surface, axis);
    try {
      check(mirrored, 0, counts);
    } catch (const IT::Invalid_surface_error&) {
      continue;
    }
    check(mirrored, 3 * mirrored.triangles.size(), counts);
  }
}

TEST(Mirrored_surface, ties_of_samples_are_decided)
{
  Counts counts;
  for (const char* name : {"bumpy-sphere", "bumpy-dome", "bad-torus", "latitude-longitude-sphere", "disk-with-spike"}) {
    SCOPED_TRACE(name);
    check_mirrored(std::get<samples::Indexed_triangles>(samples::make_sample(name)), counts);
  }
  EXPECT_GE(counts.surfaces, 20u);
  EXPECT_GT(counts.ties, 20u);
  EXPECT_GT(counts.by_symmetry, 20u);
}

samples::Indexed_triangles read(const std::filesystem::path& path)
{
  samples::Indexed_triangles surface;
  std::ifstream file(path);
  std::string word;
  std::size_t vertices = 0, faces = 0, edges = 0, corners = 0;
  file >> word >> vertices >> faces >> edges;
  surface.points.resize(vertices);
  for (auto& p : surface.points)
    file >> p[0] >> p[1] >> p[2];
  surface.triangles.resize(faces);
  for (auto& t : surface.triangles) {
    file >> corners >> t[0] >> t[1] >> t[2];
    if (corners != 3)
      file.setstate(std::ios::failbit);
  }
  EXPECT_TRUE(file) << path;
  return surface;
}

TEST(Mirrored_surface, ties_of_evaluation_meshes_are_decided)
{
  if (evaluation_data().empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  Counts counts;
  for (const char* name : {"cgal_bull",   "oded_spot",   "oded_fish",     "psb_65",     "psb_85",
                           "psb_95",      "psb_130",     "psb_175",       "psb_210",    "psb_240",
                           "cgal_handle", "cgal_oblong", "cgal_pipe",     "cgal_rotor", "gc_bob_small",
                           "molli_43394", "molli_71709", "optcuts_duck1", "segm_sword", "oded_cow_low_resolution"}) {
    SCOPED_TRACE(name);
    check_mirrored(read(evaluation_data() / "good" / (std::string(name) + ".off")), counts);
  }
  EXPECT_GE(counts.surfaces, 60u);
  EXPECT_GT(counts.by_symmetry, 20u);
  EXPECT_GT(counts.ties, 60u);
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All functions with a concurrency tag accept Parallel_if_available_tag, with the results of one thread. This program
// is built with and without TBB.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Tag = CGAL::Parallel_if_available_tag;
using CGAL::Sequential_tag;

#ifdef CGAL_LINKED_WITH_TBB
static_assert(std::is_same<Tag, CGAL::Parallel_tag>::value, "");
#else
static_assert(std::is_same<Tag, Sequential_tag>::value, "");
#endif

// Large enough for several blocks of edges.
Mesh torus()
{
  const samples::Indexed_triangles triangles = samples::bad_torus(200, 200);
  Mesh mesh;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(triangles.points, triangles.triangles, mesh);
  return mesh;
}

template <class Triangulation>
std::vector<double> sorted_lengths(const Triangulation& t)
{
  std::vector<double> result;
  for (IT::Edge_index e : t.connectivity().edges())
    result.push_back(t.length(e));
  std::sort(result.begin(), result.end());
  return result;
}

bool are_equal(const Eigen::SparseMatrix<double>& a, const Eigen::SparseMatrix<double>& b)
{
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() && (a - b).norm() == 0;
}

TEST(Parallel_if_available, triangulations)
{
  const Mesh mesh = torus();
  EXPECT_TRUE(IT::make_Delta_complex<Tag>(mesh) == IT::make_Delta_complex<Sequential_tag>(mesh));
  const auto [t, report] = IT::intrinsic_Delaunay_triangulation<Tag>(mesh);
  const auto expected = IT::intrinsic_Delaunay_triangulation<Sequential_tag>(mesh).triangulation;
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  EXPECT_GT(report.flips, 10000u);
  EXPECT_EQ(sorted_lengths(t), sorted_lengths(expected));
  auto flipped = IT::intrinsic_triangulation<Tag>(mesh);
  EXPECT_EQ(IT::flip_to_Delaunay<Tag>(flipped).flips, report.flips);
  EXPECT_TRUE(flipped.connectivity() == t.connectivity());
}

TEST(Parallel_if_available, overlays)
{
  const auto t = IT::intrinsic_Delaunay_triangulation(torus()).triangulation;
  const IT::Common_subdivision expected(t), s(t, {}, Tag());
  const IT::Overlay overlay(t, {}, Tag());
  const IT::Overlay_positions positions(IT::internal::engine(t), overlay, {}, Tag());
  EXPECT_EQ(overlay.number_of_segments(), expected.overlay().number_of_segments());
  ASSERT_EQ(overlay.number_of_crossings(), expected.overlay().number_of_crossings());
  for (IT::Overlay::Vertex x : overlay.crossings()) {
    ASSERT_EQ(positions.on_input_edge(x), expected.positions().on_input_edge(x));
    ASSERT_EQ(s.positions().on_input_edge(x), expected.positions().on_input_edge(x));
  }
}

TEST(Parallel_if_available, operators)
{
  const Mesh mesh = torus();
  const auto t = IT::intrinsic_Delaunay_triangulation(mesh).triangulation;
  EXPECT_EQ(IT::cotangent_weights<Tag>(t), IT::cotangent_weights(t));
  EXPECT_EQ(IT::face_areas<Tag>(t), IT::face_areas(t));
  EXPECT_TRUE(are_equal(IT::stiffness_matrix<Tag>(t), IT::stiffness_matrix(t)));
  EXPECT_TRUE(are_equal(IT::Galerkin_mass_matrix<Tag>(t), IT::Galerkin_mass_matrix(t)));
  EXPECT_TRUE(are_equal(IT::lumped_mass_matrix<Tag>(t), IT::lumped_mass_matrix(t)));
  EXPECT_EQ(IT::intrinsic_Delaunay_Laplacian<Tag>(mesh).stiffness.nonZeros(),
            IT::intrinsic_Delaunay_Laplacian(mesh).stiffness.nonZeros());
  EXPECT_TRUE(are_equal(IT::extrinsic_Laplacian<Tag>(mesh).stiffness, IT::extrinsic_Laplacian(mesh).stiffness));
}

} // namespace

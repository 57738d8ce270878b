// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances by way of a simplified surface: against those of vertices inserted there, and against exact ones.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>

#include <CGAL/tags.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <mutex>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace np = CGAL::parameters;
constexpr double infinity = std::numeric_limits<double>::infinity();
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation triangulation_of(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}

std::vector<samples::Indexed_triangles> surfaces()
{
  return {samples::bumpy_sphere(18, 12, 0.1), samples::bumpy_dome(14, 9, 0.05), samples::torus(20, 10),
          samples::disk_with_spike(12, 8, 0.5), samples::Schwarz_lantern(8, 12)};
}

std::vector<double> exact_distances(const Triangulation& triangulation, IT::Vertex_index v)
{
  return IT::geodesic_distances(triangulation, std::vector<IT::Vertex_index>{v}, np::tolerance(0.)).distances;
}

TEST(Simplified_distances, are_those_of_vertices_at_the_places)
{
  for (const samples::Indexed_triangles& surface : surfaces()) {
    Triangulation fine = triangulation_of(surface);
    const IT::Simplified_surface simplified = IT::simplify_surface(fine, np::maximum_change(0.3));
    const IT::Simplified_distances distances(simplified);
    ASSERT_EQ(distances.number_of_vertices(), surface.points.size());
    Triangulation coarse = simplified.triangulation;
    std::vector<IT::Vertex_index> image(surface.points.size());
    for (std::size_t v = 0; v < simplified.kept.size(); ++v)
      image[simplified.kept[v].idx()] = IT::Vertex_index(IT::Vertex_index::size_type(v));
    std::size_t inserted = 0;
    for (std::size_t v = 0; v < image.size(); ++v)
      if (!image[v].is_valid() && simplified.places[v].dimension() == 2) {
        image[v] = IT::insert_vertex(coarse, simplified.places[v]);
        ++inserted;
      }
    ASSERT_GT(inserted, 10u);
    for (std::size_t v = 0; v < image.size(); v += 3) {
      if (!image[v].is_valid())
        continue;
      const std::vector<double> expected = exact_distances(coarse, image[v]);
      const IT::Distance_intervals found = distances.from({IT::Vertex_index(IT::Vertex_index::size_type(v))});
      for (std::size_t w = 0; w < image.size(); ++w)
        if (image[w].is_valid()) {
          const double d = expected[image[w].idx()];
          ASSERT_NEAR(found.distances[w], d, 1e-11 * d) << v << " " << w;
        }
    }
  }
}

TEST(Simplified_distances, intervals_contain_the_exact_distances)
{
  for (const samples::Indexed_triangles& surface : surfaces())
    for (double change : {0.02, 0.5}) {
      Triangulation fine = triangulation_of(surface);
      const IT::Simplified_distances distances(IT::simplify_surface(fine, np::maximum_change(change)));
      for (std::size_t i = 0; i < surface.points.size(); i += 7) {
        const IT::Vertex_index v(static_cast<IT::Vertex_index::size_type>(i));
        const std::vector<double> exact = exact_distances(fine, v);
        const IT::Distance_intervals found = distances.from({v});
        EXPECT_EQ(found.distances[i], 0);
        for (std::size_t w = 0; w < exact.size(); ++w) {
          ASSERT_LE(found.lower[w], exact[w] * (1 + 1e-9)) << v << " " << w;
          ASSERT_GE(found.upper[w], exact[w] * (1 - 1e-9)) << v << " " << w;
          ASSERT_LE(found.upper[w], found.lower[w] * (1 + change) * (1 + change) * (1 + 1e-9));
        }
      }
    }
}

TEST(Simplified_distances, from_each_vertex_are_the_same_on_many_threads)
{
  Triangulation fine = triangulation_of(samples::bumpy_sphere(18, 12, 0.1));
  const IT::Simplified_distances distances(IT::simplify_surface(fine));
  const std::size_t n = distances.number_of_vertices();
  std::vector<std::vector<double>> all(n);
  double last = 0;
  distances.from_each<CGAL::Parallel_if_available_tag>(
    [&](IT::Vertex_index v, const IT::Distance_intervals& found) { all[v.idx()] = found.distances; },
    np::visitor([&](double done) {
      last = done;
      return true;
    }));
  EXPECT_EQ(last, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const IT::Vertex_index v(static_cast<IT::Vertex_index::size_type>(i));
    EXPECT_EQ(all[i], distances.from({v}).distances);
    for (std::size_t w = 0; w < n; ++w)
      EXPECT_NEAR(all[i][w], all[w][i], 1e-11);
  }
  EXPECT_THROW(distances.from_each([](IT::Vertex_index, const IT::Distance_intervals&) {},
                                   np::visitor([](double done) { return done < 0.1; })),
               IT::Cancelled_error);
}

// The nearest of several sources counts, and each component has an interval of its own.
TEST(Simplified_distances, of_several_sources_and_components)
{
  samples::Indexed_triangles surface = samples::bumpy_sphere(18, 12, 0.1);
  const auto n = std::uint32_t(surface.points.size());
  const samples::Indexed_triangles flat = samples::random_diagonal_grid(6, 5);
  surface.points.insert(surface.points.end(), flat.points.begin(), flat.points.end());
  for (const auto& t : flat.triangles)
    surface.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  surface.points.push_back({5, 5, 5}); // isolated
  Triangulation fine = triangulation_of(surface);
  const IT::Simplified_distances distances(IT::simplify_surface(fine, np::maximum_change(0.2)));
  const IT::Vertex_index on_sphere(0), also_there(n - 1), on_grid(n);
  const IT::Distance_intervals one = distances.from({on_sphere}), two = distances.from({also_there}),
                               both = distances.from({on_sphere, also_there, on_grid});
  for (std::uint32_t v = 0; v < n; ++v)
    EXPECT_EQ(both.distances[v], (std::min)(one.distances[v], two.distances[v]));
  for (std::uint32_t v = n; v + 1 < surface.points.size(); ++v) {
    EXPECT_EQ(one.distances[v], infinity);
    EXPECT_NEAR(both.upper[v], both.lower[v], 1e-10 * both.upper[v]);
  }
  EXPECT_EQ(both.lower.back(), infinity);
  EXPECT_GT(both.upper[1], 1.1 * both.lower[1]);
  EXPECT_THROW(distances.from({IT::Vertex_index(100000)}), IT::Invalid_argument_error);
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines at random distances from random curves, on the evaluation meshes.

#include "evaluation_data.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Those whose files are small.
std::vector<std::filesystem::path> small_meshes()
{
  std::vector<std::filesystem::path> result;
  if (!evaluation_data().empty())
    for (const auto& entry : std::filesystem::directory_iterator(evaluation_data() / "good"))
      if (entry.path().extension() == ".off" && entry.file_size() <= 60000)
        result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

bool is_same(const IT::Surface_point& p, const IT::Surface_point& q)
{
  return p.halfedge == q.halfedge && p.coordinates == q.coordinates;
}

// The side on which a point of dimension 1 lies.
IT::Halfedge_index side_of(const IT::Delta_complex& input, const IT::Surface_point& p)
{
  IT::Halfedge_index h = p.halfedge;
  for (std::size_t i = 0; p.coordinates[(i + 2) % 3] > 0; ++i)
    h = input.next(h);
  return h;
}

} // namespace

TEST(Isolines_on_data, AreClosedAndComplete)
{
  const auto paths = small_meshes();
  if (paths.empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  std::mt19937 random(5);
  std::size_t number_of_lines = 0, number_of_points = 0;
  for (const std::filesystem::path& path : paths) {
    Mesh mesh;
    std::ifstream file(path);
    ASSERT_TRUE(file >> mesh) << path;
    Triangulation t = IT::intrinsic_triangulation(mesh);
    IT::flip_to_Delaunay(t);
    const IT::Delta_complex& input = t.input();
    const IT::Vertex_index vertex(random() % input.number_of_vertices());
    const IT::Surface_direction start{{input.halfedge(IT::Face_index(random() % input.number_of_faces())), {1, 2, 3}},
                                      {1, -0.3}};
    const auto exact = CGAL::parameters::tolerance(0);
    const std::vector<IT::Geodesic_source> vertices{IT::source_at_vertex(input, vertex)};
    double largest = 0;
    for (double d : IT::geodesic_distances_from(t, vertices, exact).distances)
      largest = std::isfinite(d) ? (std::max)(largest, d) : largest;
    std::vector<double> levels;
    for (int i = 0; i < 3; ++i)
      levels.push_back(largest * double(330 * i + 1 + int(random() % 330)) / 1003);
    for (bool is_curve : {false, true}) {
      const std::vector<IT::Geodesic_source> sources =
        is_curve ? std::vector<IT::Geodesic_source>{{{IT::trace_geodesic(t, start, largest / 3).points}}} : vertices;
      const std::vector<double> distances = IT::geodesic_distances_from(t, sources, exact).distances;
      for (double tolerance : {0., 0.001}) {
        const auto found =
          IT::isolines(t, sources, levels, CGAL::parameters::tolerance(tolerance).maximum_deviation(largest / 1000));
        std::vector<std::vector<int>> crossings(levels.size(), std::vector<int>(input.number_of_edges(), 0));
        for (const IT::Surface_line& line : found.lines) {
          const std::size_t level =
            std::size_t(std::find(levels.begin(), levels.end(), line.distance) - levels.begin());
          const bool is_closed = is_same(line.points.front(), line.points.back());
          for (std::size_t i = 0; i + (is_closed ? 1 : 0) < line.points.size(); ++i)
            if (line.points[i].dimension() == 1)
              ++crossings[level][input.edge(side_of(input, line.points[i])).idx()];
          for (const IT::Surface_point& end : {line.points.front(), line.points.back()})
            if (!is_closed) {
              EXPECT_TRUE(end.dimension() == 0 || input.is_border(input.opposite(side_of(input, end))))
                << path << ' ' << tolerance << ' ' << line.distance << ' ' << line.points.size() << ' '
                << input.face(end.halfedge) << ' ' << end.coordinates[0] << ' ' << end.coordinates[1] << ' '
                << end.coordinates[2];
            }
          ++number_of_lines;
          number_of_points += line.points.size();
        }
        if (tolerance > 0)
          continue;
        // On each edge lie as many points as its ends tell.
        for (std::size_t i = 0; i < levels.size(); ++i)
          for (IT::Edge_index e : input.edges()) {
            const IT::Halfedge_index h = input.halfedge(e);
            const double a = distances[input.source(h).idx()] - levels[i],
                         b = distances[input.target(h).idx()] - levels[i];
            if (std::abs(a) > 1e-12 * largest && std::abs(b) > 1e-12 * largest) {
              EXPECT_EQ(crossings[i][e.idx()] % 2, (a < 0) != (b < 0) ? 1 : 0) << path << ' ' << e.idx();
            }
          }
        // The distance from a point back to the vertex is the same.
        if (!is_curve)
          for (const IT::Surface_line& line : found.lines)
            EXPECT_NEAR(IT::geodesic_distances_from(t, {{{{line.points[random() % line.points.size()]}}}}, exact)
                          .distances[vertex.idx()],
                        line.distance, 1e-12 * largest)
              << path;
      }
    }
  }
  RecordProperty("lines", int(number_of_lines));
  RecordProperty("points", int(number_of_points));
  EXPECT_GE(paths.size(), 20u);
}

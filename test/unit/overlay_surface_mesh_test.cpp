// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The overlay as a Surface_mesh: its elements, its property maps, and its faces as triangles.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/overlay/Carried_properties.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/surface_mesh_adaptors.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

namespace {

Mesh mesh_of(const samples::Indexed_triangles& triangles)
{
  Mesh mesh;
  for (const auto& [x, y, z] : triangles.points)
    mesh.add_vertex(Point(x, y, z));
  for (const auto& [i, j, k] : triangles.triangles)
    mesh.add_face(Mesh::Vertex_index(i), Mesh::Vertex_index(j), Mesh::Vertex_index(k));
  return mesh;
}

// Two triangles, with an obtuse corner each on both sides of an edge that is flipped: the new
// edge from (2, -1, 0) to (3, 2, 0) meets the old one at a third of its own length.
Mesh kite() { return mesh_of({{{0, 0, 0}, {8, 0, 0}, {3, 2, 0}, {2, -1, 0}}, {{0, 1, 2}, {1, 0, 3}}}); }

Vector normal(const Mesh& mesh, Mesh::Face_index f)
{
  Vector sum(0, 0, 0);
  const Point p = mesh.point(mesh.target(mesh.halfedge(f)));
  for (auto h : halfedges_around_face(mesh.halfedge(f), mesh))
    sum = sum + CGAL::cross_product(mesh.point(mesh.source(h)) - p, mesh.point(mesh.target(h)) - p);
  return sum / 2;
}

double area(const Mesh& mesh, Mesh::Face_index f) { return std::sqrt(normal(mesh, f).squared_length()); }

struct Maps
{
  explicit Maps(const Mesh& mesh)
    : kind(IT::internal::find_property_map<Mesh::Vertex_index, std::uint8_t>(mesh, "v:kind")),
      label(IT::internal::find_property_map<Mesh::Edge_index, std::uint8_t>(mesh, "e:label")),
      input_face(IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(mesh, "f:input_face")),
      intrinsic_face(IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(mesh, "f:intrinsic_face")),
      input_point(IT::internal::find_property_map<Mesh::Halfedge_index, IT::Surface_point>(mesh, "h:input_point")),
      intrinsic_point(
        IT::internal::find_property_map<Mesh::Halfedge_index, IT::Surface_point>(mesh, "h:intrinsic_point"))
  {}
  Mesh::Property_map<Mesh::Vertex_index, std::uint8_t> kind;
  Mesh::Property_map<Mesh::Edge_index, std::uint8_t> label;
  Mesh::Property_map<Mesh::Face_index, std::uint32_t> input_face, intrinsic_face;
  Mesh::Property_map<Mesh::Halfedge_index, IT::Surface_point> input_point, intrinsic_point;
};

// Each corner lies in the faces that its face names, where the barycentric coordinates say; each
// input face is covered once.
void expect_right_places(const Mesh& overlay, const Mesh& input, const Triangulation& t)
{
  const Maps maps(overlay);
  const IT::Delta_complex& input_complex = t.input();
  std::vector<double> covered(input.number_of_faces(), 0);
  for (auto f : overlay.faces()) {
    covered[maps.input_face[f]] += area(overlay, f);
    for (auto h : halfedges_around_face(overlay.halfedge(f), overlay)) {
      const IT::Surface_point &p = maps.input_point[h], &q = maps.intrinsic_point[h];
      EXPECT_EQ(input_complex.face(p.halfedge).idx(), maps.input_face[f]);
      EXPECT_EQ(t.connectivity().face(q.halfedge).idx(), maps.intrinsic_face[f]);
      const auto point_of = [&](IT::Vertex_index v) { return input.point(Mesh::Vertex_index(v.idx())); };
      const Point a = point_of(input_complex.source(p.halfedge)), b = point_of(input_complex.target(p.halfedge)),
                  c = point_of(input_complex.target(input_complex.next(p.halfedge)));
      const Point x = CGAL::barycenter(a, p.coordinates[0], b, p.coordinates[1], c, p.coordinates[2]);
      EXPECT_LT(CGAL::squared_distance(x, overlay.point(overlay.target(h))),
                1e-30 * (CGAL::squared_distance(a, b) + CGAL::squared_distance(a, Point(0, 0, 0))));
      const auto vertex = overlay.target(h);
      if (maps.kind[vertex] == 0) {
        EXPECT_EQ(t.connectivity().source(q.halfedge).idx(), std::uint32_t(vertex));
        EXPECT_EQ(q.coordinates, (std::array<double, 3>{1, 0, 0}));
      } else {
        EXPECT_GT(q.coordinates[0], 0);
        EXPECT_GT(q.coordinates[1], 0);
      }
    }
  }
  for (auto f : input.faces())
    EXPECT_NEAR(covered[f], area(input, f), 1e-12 * area(input, f));
  for (auto h : overlay.halfedges())
    if (overlay.is_border(h)) {
      EXPECT_FALSE(maps.input_point[h].halfedge.is_valid());
    }
}

std::array<int, 4> count_labels(const Mesh& mesh)
{
  std::array<int, 4> counts{0, 0, 0, 0};
  for (auto e : mesh.edges())
    ++counts[Maps(mesh).label[e]];
  return counts;
}

} // namespace

TEST(Overlay_to_surface_mesh, kite)
{
  const Mesh input = kite();
  const auto [t, report] = IT::intrinsic_Delaunay_triangulation(input);
  ASSERT_EQ(report.flips, 1u);
  Mesh mesh = IT::overlay_to_surface_mesh(IT::Common_subdivision(t), input);
  ASSERT_TRUE(mesh.is_valid());
  EXPECT_EQ(mesh.number_of_vertices(), 5u);
  EXPECT_EQ(mesh.number_of_edges(), 8u);
  EXPECT_EQ(mesh.number_of_faces(), 4u);
  for (std::uint32_t v = 0; v < 4; ++v)
    EXPECT_EQ(mesh.point(Mesh::Vertex_index(v)), input.point(Mesh::Vertex_index(v)));
  EXPECT_LT(CGAL::squared_distance(mesh.point(Mesh::Vertex_index(4)), Point(7. / 3, 0, 0)), 1e-30);
  const Maps maps(mesh);
  for (std::uint32_t v = 0; v < 5; ++v)
    EXPECT_EQ(maps.kind[Mesh::Vertex_index(v)], v == 4 ? 1 : 0);
  EXPECT_EQ(count_labels(mesh), (std::array<int, 4>{2, 2, 4, 0}));
  // The four faces are the four pairs of an input face and an intrinsic one.
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;
  for (auto f : mesh.faces())
    areas[{maps.input_face[f], maps.intrinsic_face[f]}] += area(mesh, f);
  EXPECT_EQ(areas.size(), 4u);
  std::vector<double> sorted;
  for (const auto& [faces, face_area] : areas)
    sorted.push_back(face_area);
  // From the upper triangle, of base 8 and height 2, the part to the left is cut off at x = 7/3,
  // and so it is from the lower one.
  EXPECT_NEAR(std::min(sorted[0], sorted[1]), 7. / 3, 1e-14);
  EXPECT_NEAR(std::max(sorted[0], sorted[1]), 17. / 3, 1e-14);
  EXPECT_NEAR(std::min(sorted[2], sorted[3]), 7. / 6, 1e-14);
  EXPECT_NEAR(std::max(sorted[2], sorted[3]), 17. / 6, 1e-14);
  expect_right_places(mesh, input, t);
}

TEST(Overlay_to_surface_mesh, sample_surfaces)
{
  for (const samples::Indexed_triangles& sample :
       {samples::prism(12, 1), samples::helical_tube(), samples::bad_torus(12, 12),
        samples::latitude_longitude_sphere(10, 8)}) {
    const Mesh input = mesh_of(sample);
    const auto t = IT::intrinsic_Delaunay_triangulation(input).triangulation;
    Mesh mesh = IT::overlay_to_surface_mesh(IT::Common_subdivision(t), input);
    ASSERT_TRUE(mesh.is_valid());
    const auto euler = [](const Mesh& m) {
      return int(m.number_of_vertices()) - int(m.number_of_edges()) + int(m.number_of_faces());
    };
    EXPECT_EQ(euler(mesh), euler(input));
    expect_right_places(mesh, input, t);

    const std::array<int, 4> before = count_labels(mesh);
    const std::size_t number_of_edges = mesh.number_of_edges();
    IT::triangulate_overlay_faces(mesh);
    ASSERT_TRUE(mesh.is_valid());
    EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
    EXPECT_EQ(euler(mesh), euler(input));
    std::array<int, 4> after = count_labels(mesh);
    EXPECT_EQ(after[IT::diagonal_label], int(mesh.number_of_edges() - number_of_edges));
    after[IT::diagonal_label] = 0;
    EXPECT_EQ(after, before);
    expect_right_places(mesh, input, t);
    for (auto f : mesh.faces())
      EXPECT_GT(area(mesh, f), 0);
  }
}

TEST(Overlay_to_surface_mesh, exact_kernel_and_point_map)
{
  using Exact_point = CGAL::Exact_predicates_exact_constructions_kernel::Point_3;
  CGAL::Surface_mesh<Exact_point> input;
  for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{{0, 0, 0}, {8, 0, 0}, {3, 2, 0}, {2, -1, 0}})
    input.add_vertex(Exact_point(x, y, z));
  using V = CGAL::SM_Vertex_index;
  input.add_face(V(0), V(1), V(2));
  input.add_face(V(1), V(0), V(3));
  const auto t = IT::intrinsic_Delaunay_triangulation(input).triangulation;
  auto moved = input.add_property_map<V, Exact_point>("v:moved").first;
  for (V v : input.vertices())
    moved[v] = input.point(v) + CGAL::Exact_predicates_exact_constructions_kernel::Vector_3(0, 0, 5);
  const auto mesh =
    IT::overlay_to_surface_mesh(IT::Common_subdivision(t), input, CGAL::parameters::vertex_point_map(moved));
  EXPECT_NEAR(CGAL::to_double(mesh.point(V(4)).x()), 7. / 3, 1e-15);
  EXPECT_EQ(mesh.point(V(4)).z(), 5);
}

TEST(Overlay_to_surface_mesh, keeps_loops_and_multiple_edges_apart)
{
  // A tetrahedron whose vertex 3 ends up inside of a loop.
  const samples::Indexed_triangles sample{{{0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 1, 8}},
                                          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const Mesh input = mesh_of(sample);
  Triangulation t = IT::intrinsic_triangulation(input);
  for (int flips = 0; flips < 2; ++flips) {
    const IT::Delta_complex& c = t.connectivity();
    ASSERT_EQ(t.flip(c.edge(c.halfedge(IT::Vertex_index(3)))), Triangulation::Flip_outcome::FLIPPED);
  }
  ASSERT_TRUE(t.connectivity().is_loop(
    IT::Edge_index(t.connectivity().edge(t.connectivity().prev(t.connectivity().halfedge(IT::Vertex_index(3)))))));
  Mesh mesh = IT::overlay_to_surface_mesh(IT::Common_subdivision(t), input);
  ASSERT_TRUE(mesh.is_valid());
  expect_right_places(mesh, input, t);
  IT::triangulate_overlay_faces(mesh);
  ASSERT_TRUE(mesh.is_valid());
  expect_right_places(mesh, input, t);
}

TEST(Overlay_to_surface_mesh, refuses_a_wrong_number_of_points)
{
  const Mesh input = kite();
  const auto t = IT::intrinsic_Delaunay_triangulation(input).triangulation;
  Mesh more = input;
  more.add_vertex(Point(1, 1, 1));
  EXPECT_THROW(IT::overlay_to_surface_mesh(IT::Common_subdivision(t), more), IT::Invalid_surface_error);
}

// A chart for each input face, with its own coordinates at each corner: on the diagonals, too, the corners are those of
// the face.
TEST(Triangulate_overlay_faces, keeps_the_properties_of_corners_and_faces)
{
  const samples::Indexed_triangles sample = samples::helical_tube();
  const Mesh input = mesh_of(sample);
  const auto t = IT::intrinsic_Delaunay_triangulation(input).triangulation;
  Mesh mesh = IT::overlay_to_surface_mesh(IT::Common_subdivision(t), input);
  const Maps maps(mesh);
  struct Material
  {
    std::uint32_t number = 0;
  };
  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv", Kernel::Point_2(9, 9)).first;
  auto words = mesh.add_property_map<Mesh::Face_index, std::string>("f:word").first;
  auto materials = mesh.add_property_map<Mesh::Face_index, Material>("f:material").first;
  const IT::Delta_complex& complex = t.input();
  for (auto f : mesh.faces()) {
    words[f] = std::to_string(maps.input_face[f]);
    materials[f].number = maps.input_face[f];
    const IT::Halfedge_index first = complex.halfedge(IT::Face_index(maps.input_face[f]));
    for (auto h : halfedges_around_face(mesh.halfedge(f), mesh)) {
      const auto [a, b, c] = IT::coordinates_from(complex, maps.input_point[h], first);
      uv[h] = Kernel::Point_2(2 * maps.input_face[f] + b / (a + b + c), c / (a + b + c));
    }
  }
  const std::size_t number_of_faces = mesh.number_of_faces();
  EXPECT_THROW(IT::triangulate_overlay_faces(mesh), std::invalid_argument); // what is a Material?
  EXPECT_EQ(mesh.number_of_faces(), number_of_faces);
  IT::triangulate_overlay_faces<Material>(mesh);
  EXPECT_GT(mesh.number_of_faces(), number_of_faces);
  double sum = 0;
  for (auto f : mesh.faces()) {
    EXPECT_EQ(words[f], std::to_string(maps.input_face[f]));
    EXPECT_EQ(materials[f].number, maps.input_face[f]);
    const auto h = mesh.halfedge(f);
    const double image = CGAL::area(uv[h], uv[mesh.next(h)], uv[mesh.prev(h)]);
    EXPECT_GT(image, -1e-14) << f;
    sum += image;
  }
  EXPECT_NEAR(sum, input.number_of_faces() / 2., 1e-9 * sum);
}

TEST(Triangulate_convex_polygon, covers_it_without_flat_triangles)
{
  // The middle of a side is a corner, too.
  const std::vector<std::array<double, 3>> polygon{{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {2, 1, 1}, {0, 1, 1}};
  const auto triangles = IT::triangulate_convex_polygon(polygon);
  ASSERT_EQ(triangles.size(), 3u);
  double sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto& p = polygon[a];
    const double area =
      ((polygon[b][0] - p[0]) * (polygon[c][1] - p[1]) - (polygon[b][1] - p[1]) * (polygon[c][0] - p[0])) / 2;
    EXPECT_GE(area, 0.5);
    sum += area;
  }
  EXPECT_EQ(sum, 2);
  EXPECT_EQ(IT::triangulate_convex_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 1u);
}

TEST(Triangulate_overlay_faces, makes_no_triangle_of_zero_area_where_it_can)
{
  using Polygon = std::vector<std::array<double, 3>>;
  const auto smallest_area = [](const Polygon& polygon) {
    std::vector<std::pair<std::size_t, std::size_t>> diagonals;
    IT::internal::for_each_diagonal(polygon, [&](std::size_t a, std::size_t b) {
      EXPECT_LT(a + 1, b);
      diagonals.emplace_back(a, b);
    });
    EXPECT_EQ(diagonals.size() + 3, polygon.size());
    // Each diagonal cuts off a chain of corners; the rest of a chain is a triangle.
    const std::size_t n = polygon.size();
    std::vector<std::vector<std::size_t>> pieces(1);
    for (std::size_t i = 0; i < n; ++i)
      pieces[0].push_back(i);
    for (const auto& [a, b] : diagonals)
      for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto first = std::find(pieces[i].begin(), pieces[i].end(), a),
                   last = std::find(pieces[i].begin(), pieces[i].end(), b);
        if (first == pieces[i].end() || last == pieces[i].end() || last - first < 2 || pieces[i].size() == 3)
          continue;
        std::vector<std::size_t> piece(first, last + 1);
        pieces[i].erase(first + 1, last);
        pieces.push_back(piece);
        break;
      }
    double smallest = 1e300;
    for (const auto& piece : pieces) {
      EXPECT_EQ(piece.size(), 3u);
      const auto at = [&](std::size_t i) {
        return Point(polygon[piece[i]][0], polygon[piece[i]][1], polygon[piece[i]][2]);
      };
      smallest = std::min(smallest, std::sqrt(CGAL::squared_area(at(0), at(1), at(2))));
    }
    return smallest;
  };
  // Three corners in a line, wherever the polygon begins: one fan would have a flat triangle.
  Polygon polygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(smallest_area(polygon), 1, 1e-12);
    std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
  }
  // The same so small or large that areas leave the range of double, in another plane.
  for (double scale : {1e-150, 1e120}) {
    Polygon scaled;
    for (const auto& [x, y, z] : polygon)
      scaled.push_back({scale * z, scale * x, scale * y});
    std::size_t cuts = 0;
    IT::internal::for_each_diagonal(scaled, [&](std::size_t a, std::size_t b) {
      ++cuts;
      // Corners 0, 1, 2 are in a line: no diagonal may cut corner 1 off.
      EXPECT_FALSE(a == 0 && b == 2);
    });
    EXPECT_EQ(cuts, 2u);
  }
  // All corners in a line leave no choice.
  EXPECT_EQ(smallest_area({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), 0);
}

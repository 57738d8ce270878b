// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geodesics on the evaluation meshes: the points of paths and lines are measured in space, independently of the
// triangulation, and paths are compared with CGAL's globally shortest paths.

#include "evaluation_data.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Vector = std::array<long double, 3>;

namespace {

const long double pi = std::acos(-1.0L);
const double infinity = std::numeric_limits<double>::infinity();

Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

long double norm(const Vector& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

long double angle_between(const Vector& u, const Vector& v)
{
  const Vector w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return std::atan2(norm(w), u[0] * v[0] + u[1] * v[1] + u[2] * v[2]);
}

// Measures polylines on a surface in space.
class Ruler
{
public:
  explicit Ruler(const Mesh& mesh) : input_(IT::make_Delta_complex(mesh))
  {
    for (auto v : mesh.vertices()) {
      const auto& p = mesh.point(v);
      points_.push_back({p.x(), p.y(), p.z()});
      for (double x : points_.back())
        largest_ = (std::max)(largest_, std::abs(x));
      for (std::size_t i = 0; i < 3; ++i) {
        low_[i] = (std::min)(low_[i], points_.back()[i]);
        high_[i] = (std::max)(high_[i], points_.back()[i]);
      }
    }
  }

  const IT::Delta_complex& input() const { return input_; }
  double size() const { return std::hypot(high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]); }

  long double length(const std::vector<IT::Surface_point>& line) const
  {
    long double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
      sum += norm(at(line[i + 1]) - at(line[i]));
    return sum;
  }

  // By how much the smaller angle beside an inner point is less than π, reduced by the rotation of short segments due
  // to rounded coordinates.
  long double bend(const std::vector<IT::Surface_point>& line, std::size_t i) const
  {
    const Vector p = at(line[i]), to = at(line[i + 1]) - p, from = at(line[i - 1]) - p;
    long double inverse = 1 / norm(to) + 1 / norm(from);
    if (line[i].dimension() == 1) { // the direction of the edge is seen from the point, too
      const IT::Halfedge_index h = IT::internal::side_of(input_, line[i]);
      inverse += 1 / norm(at(input_.source(h)) - p) + 1 / norm(at(input_.target(h)) - p);
    }
    const long double blur = 16 * largest_ * 0x1p-53L * inverse;
    return pi - (std::min)(side(line, i, to, from, true), side(line, i, to, from, false)) - blur;
  }

private:
  Vector at(const IT::Surface_point& p) const
  {
    const auto x = IT::point_in_space(input_, points_, p);
    return {x[0], x[1], x[2]};
  }
  Vector at(IT::Vertex_index v) const { return {points_[v.idx()][0], points_[v.idx()][1], points_[v.idx()][2]}; }

  // The angle on one side: of the part of each face there, from the one that the line enters to the one that it came
  // through.
  long double side(const std::vector<IT::Surface_point>& line, std::size_t i, const Vector& to, const Vector& from,
                   bool is_left) const
  {
    const IT::Surface_point& point = line[i];
    const Vector p = at(point);
    const IT::Face_index last = input_.face(line[i - 1].halfedge);
    IT::Halfedge_index h = point.halfedge; // a side of the face that ends at the point or contains it
    while (!ends(h, point))
      h = input_.next(h);
    // `h` is the side to the right, looking into the face from the point; the next one, or the same edge, is the side
    // to the left.
    long double sum = 0;
    Vector edge = to;
    for (std::size_t turn = 0; turn <= input_.number_of_halfedges(); ++turn) {
      const bool is_edge = point.dimension() == 1;
      const IT::Halfedge_index exit = is_left ? h : (is_edge ? h : input_.next(h));
      const Vector along = is_edge ? at(is_left ? input_.source(h) : input_.target(h)) - p
                                   : at(is_left ? input_.source(exit) : input_.target(exit)) - p;
      if (input_.face(h) == last && (turn > 0 || angle_is_ahead(edge, from, along)))
        return sum + angle_between(edge, from);
      sum += angle_between(edge, along);
      const IT::Halfedge_index across = input_.opposite(exit);
      if (input_.is_border(across))
        return std::numeric_limits<long double>::infinity();
      edge = along;
      h = is_edge ? across : is_left ? input_.prev(across) : across;
    }
    ADD_FAILURE() << "a line that goes round its point";
    return 0;
  }

  // Whether `from` lies between two directions of the same face.
  static bool angle_is_ahead(const Vector& edge, const Vector& from, const Vector& along)
  {
    return angle_between(edge, from) + angle_between(from, along) <= angle_between(edge, along) + 1e-9L;
  }

  bool ends(IT::Halfedge_index h, const IT::Surface_point& point) const
  {
    IT::Halfedge_index g = point.halfedge;
    for (std::size_t i = 0; i < 3; ++i, g = input_.next(g)) {
      if (point.dimension() == 1 && g == h)
        return point.coordinates[(i + 2) % 3] == 0;
      if (point.dimension() == 0 && g == h)
        return point.coordinates[(i + 1) % 3] > 0;
    }
    return true;
  }

  IT::Delta_complex input_;
  std::vector<std::array<double, 3>> points_;
  double largest_ = 0;
  std::array<double, 3> low_{infinity, infinity, infinity}, high_{-infinity, -infinity, -infinity};
};

// Those whose files are not larger.
std::vector<std::filesystem::path> meshes(std::uintmax_t largest_size)
{
  const std::filesystem::path folder = evaluation_data();
  std::vector<std::filesystem::path> result;
  if (folder.empty())
    return result;
  for (const char* part : {"good", "table1"})
    for (const auto& entry : std::filesystem::directory_iterator(folder / part))
      if (entry.path().extension() == ".off" && entry.file_size() <= largest_size)
        result.push_back(entry.path());
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

TEST(Geodesics_on_data, PathsAreStraightAndOftenTheShortest)
{
  const auto paths = meshes(90000); // the comparison takes minutes for larger ones
  if (paths.empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  std::mt19937 random(7);
  int used = 0, pairs = 0, equal = 0, shorter = 0;
  for (const std::filesystem::path& path : paths) {
    Mesh mesh;
    std::ifstream file(path);
    ASSERT_TRUE(file >> mesh) << path;
    const Triangulation t = IT::intrinsic_triangulation(mesh);
    const Ruler ruler(mesh);
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> shortest(mesh);
    const std::uint32_t n = t.connectivity().number_of_vertices(), source = random() % n;
    shortest.add_source_point(Mesh::Vertex_index(source));
    ++used;
    for (int i = 0; i < 40; ++i) {
      const std::uint32_t target = random() % n;
      const auto [least, location] = shortest.shortest_distance_to_source_points(Mesh::Vertex_index(target));
      if (target == source || least < 0) // in another component
        continue;
      Triangulation copy = t;
      IT::Geodesic_path_network<IT::Filtered_edge_length_traits> network(copy);
      network.add_path(IT::shortest_edge_path(copy, IT::Vertex_index(source), IT::Vertex_index(target)));
      ASSERT_EQ(network.shorten().status, IT::Geodesic_status::GEODESIC) << path << ' ' << source << ' ' << target;
      ASSERT_TRUE(network.is_geodesic());
      const auto points = IT::geodesic_points(copy, network.halfedges(0));
      const double length = network.length(0);
      EXPECT_NEAR(double(ruler.length(points) / length), 1, 1e-12) << path;
      shorter += length < least * (1 - 1e-9) ? 1 : 0;
      equal += std::abs(length / least - 1) <= 1e-9 ? 1 : 0;
      ++pairs;
      for (std::size_t k = 1; k + 1 < points.size(); ++k)
        EXPECT_LT(double(ruler.bend(points, k)), 1e-9) << path << ' ' << source << ' ' << target << ", point " << k;
    }
  }
  RecordProperty("pairs", pairs);
  RecordProperty("shortest", equal);
  RecordProperty("shorter", shorter);
  EXPECT_GE(used, 20);
  EXPECT_GE(pairs, 1000);
  EXPECT_GE(equal, 0.6 * pairs);
  EXPECT_LE(shorter, 0.01 * pairs); // CGAL's rounded distances: the length of each path was measured above
}

TEST(Geodesics_on_data, NoLineIsLost)
{
  const auto paths = meshes((std::numeric_limits<std::uintmax_t>::max)());
  if (paths.empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  std::mt19937 random(11);
  for (const std::filesystem::path& path : paths) {
    Mesh mesh;
    std::ifstream file(path);
    ASSERT_TRUE(file >> mesh) << path;
    const Triangulation t = IT::intrinsic_triangulation(mesh);
    const Ruler ruler(mesh);
    Triangulation flipped = t;
    IT::flip_to_Delaunay(flipped);
    const int number_of_lines = std::filesystem::file_size(path) <= 90000 ? 10000 : 100;
    for (int i = 0; i < number_of_lines; ++i) {
      const IT::Halfedge_index h = ruler.input().halfedge(IT::Face_index(random() % ruler.input().number_of_faces()));
      const auto number = [&] { return 1. + random() % 1000; };
      const IT::Surface_direction start{{h, {number(), number(), number()}}, {number() - 500.5, number() - 500.5}};
      const double wanted = ruler.size();
      const IT::Traced_geodesic line = IT::trace_geodesic(t, start, wanted);
      if (line.status == IT::Trace_status::AT_LENGTH) {
        EXPECT_EQ(line.length, wanted);
      } else {
        EXPECT_LE(line.length, wanted);
      }
      EXPECT_NEAR(double(ruler.length(line.points)), line.length, 1e-12 * wanted) << path;
      if (i < 20) {
        const IT::Traced_geodesic same = IT::trace_geodesic_in_triangulation(flipped, start, wanted);
        EXPECT_EQ(same.status, line.status) << path << ", line " << i;
        EXPECT_EQ(same.vertex, line.vertex);
        EXPECT_NEAR(same.length, line.length, 1e-12 * wanted);
      }
      for (std::size_t k = 1; k + 1 < line.points.size(); ++k)
        EXPECT_LT(double(ruler.bend(line.points, k)), 1e-9) << path << ", line " << i << ", point " << k;
    }
  }
}

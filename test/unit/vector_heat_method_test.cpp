// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tangent vectors transported by heat, and logarithmic maps, against known results on planes, cones and spheres.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>
#include <CGAL/Intrinsic_triangulations/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Delta_complex;
using IT::Edge_index;
using IT::Halfedge_index;
using IT::Vertex_index;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Vector = std::complex<double>;
using Complex = std::complex<double>;
using Points = std::vector<std::array<double, 3>>;

const double pi = std::acos(-1.);

Complex complex_number(const Vector& v) { return {v.real(), v.imag()}; }

Triangulation make_triangulation(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}
Triangulation Delaunay(const samples::Indexed_triangles& surface)
{
  Triangulation result = make_triangulation(surface);
  IT::flip_to_Delaunay(result);
  return result;
}

// Rings of vertices around an apex at the origin, and one triangle after the other between them; flat inside for an
// angle of 2π.
Triangulation cone(double angle, std::size_t sides, std::size_t rings, double radius = 1)
{
  const auto vertex = [&](std::size_t ring, std::size_t i) {
    return std::uint32_t(ring == 0 ? 0 : 1 + (ring - 1) * sides + i % sides);
  };
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t r = 0; r < rings; ++r)
    for (std::size_t i = 0; i < sides; ++i) {
      triangles.push_back({vertex(r, i), vertex(r + 1, i), vertex(r + 1, i + 1)});
      if (r > 0)
        triangles.push_back({vertex(r, i), vertex(r + 1, i + 1), vertex(r, i + 1)});
    }
  const Delta_complex complex = IT::make_Delta_complex_from_triangles(1 + rings * sides, triangles);
  const auto place = [&](Vertex_index v) {
    const std::size_t n = v.idx();
    return n == 0 ? Complex(0)
                  : std::polar(radius * double(1 + (n - 1) / sides) / double(rings),
                               angle / double(sides) * double((n - 1) % sides));
  };
  std::vector<double> lengths;
  for (Edge_index e : complex.edges()) {
    const Halfedge_index h = complex.halfedge(e);
    const Complex a = place(complex.source(h)), b = place(complex.target(h));
    // Vertices on different rings are in one direction or in neighboring ones, whatever their numbers where the ring
    // closes.
    const bool is_radial =
      std::abs(a) == 0 || std::abs(b) == 0 ||
      (complex.source(h).idx() + sides - 1) % sides == (complex.target(h).idx() + sides - 1) % sides;
    const double turn = is_radial ? 0 : angle / double(sides);
    lengths.push_back(std::abs(std::abs(a) - std::polar(std::abs(b), turn)));
  }
  Triangulation result = Triangulation::from_lengths(complex, lengths);
  IT::flip_to_Delaunay(result);
  return result;
}

void project_to_unit_sphere(std::array<double, 3>& p)
{
  const double length = std::hypot(p[0], p[1], p[2]);
  for (double& x : p)
    x /= length;
}

// Triangles subdivided into four this many times, with their vertices on the unit sphere.
samples::Indexed_triangles cut_on_sphere(samples::Indexed_triangles result, int cuts)
{
  for (auto& p : result.points)
    project_to_unit_sphere(p);
  for (; cuts > 0; --cuts) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [position, is_new] =
        middles.insert({{std::min(a, b), std::max(a, b)}, std::uint32_t(result.points.size())});
      if (is_new) {
        const auto &p = result.points[a], &q = result.points[b];
        result.points.push_back({p[0] + q[0], p[1] + q[1], p[2] + q[2]});
        project_to_unit_sphere(result.points.back());
      }
      return position->second;
    };
    std::vector<std::array<std::uint32_t, 3>> quarters;
    for (const auto& [a, b, c] : result.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      quarters.insert(quarters.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    result.triangles = quarters;
  }
  return result;
}

// An icosahedron that is cut.
samples::Indexed_triangles sphere(int cuts)
{
  const double g = (1 + std::sqrt(5.)) / 2;
  samples::Indexed_triangles result;
  for (double a : {-1., 1.})
    for (double b : {-g, g})
      result.points.insert(result.points.end(), {{a, b, 0}, {0, a, b}, {b, 0, a}});
  const auto point = [&](std::uint32_t v) { return Eigen::Vector3d(result.points[v].data()); };
  for (std::uint32_t i = 0; i < 12; ++i)
    for (std::uint32_t j = i + 1; j < 12; ++j)
      for (std::uint32_t k = j + 1; k < 12; ++k)
        if (std::max({(point(i) - point(j)).norm(), (point(j) - point(k)).norm(), (point(k) - point(i)).norm()}) <
            2.1) {
          const bool is_outside = (point(j) - point(i)).cross(point(k) - point(i)).dot(point(i)) > 0;
          result.triangles.push_back({i, is_outside ? j : k, is_outside ? k : j});
        }
  return cut_on_sphere(result, cuts);
}

// An octahedron that is cut: nearly all of its edges run in four directions.
samples::Indexed_triangles sphere_of_octahedron(int cuts)
{
  samples::Indexed_triangles result;
  result.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  result.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return cut_on_sphere(result, cuts);
}

// The rotation of a vector transported around a loop of halfedges.
Complex turn_around(const Delta_complex& complex, const std::vector<Vector>& vectors,
                    const std::vector<Halfedge_index>& loop)
{
  Complex result = 1;
  for (Halfedge_index h : loop)
    result *= IT::internal::transport_to_source(complex, vectors, h);
  return result;
}

// The halfedges around the faces at v, counterclockwise.
std::vector<Halfedge_index> link_of(const Delta_complex& complex, Vertex_index v)
{
  std::vector<Halfedge_index> result;
  IT::internal::for_each_halfedge_from(complex, v, [&](Halfedge_index h) {
    if (!complex.is_border(h))
      result.push_back(complex.next(h));
  });
  return result;
}

TEST(Connection, turns_by_the_angle_defect_around_a_cone)
{
  for (double angle : {0.7, 2., 3.3, 5.5, 2 * pi, 7.1, 11.}) {
    const Triangulation t = cone(angle, 12, 4);
    const Delta_complex& c = t.connectivity();
    const auto vectors = IT::halfedge_vectors_in_vertex(t);
    std::vector<Halfedge_index> loop = link_of(c, Vertex_index(0));
    ASSERT_GE(loop.size(), 3u);
    EXPECT_LT(std::abs(turn_around(c, vectors, loop) - std::polar(1., -(2 * pi - angle))), 1e-10) << angle;
    // Around a flat vertex nothing turns.
    for (std::uint32_t v = 13; v <= 24; ++v) {
      if (std::abs(IT::angle_defect(t, Vertex_index(v))) > 1e-9)
        continue;
      const auto link = link_of(c, Vertex_index(v));
      if (std::all_of(link.begin(), link.end(), [&](Halfedge_index h) { return c.source(h).idx() != 0; })) {
        EXPECT_LT(std::abs(turn_around(c, vectors, link) - Complex(1)), 1e-10) << angle << ' ' << v;
      }
    }
  }
}

TEST(Connection_Laplacian, is_that_of_numbers_where_the_surface_is_flat)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(8, 8);
  const Triangulation t = Delaunay(surface);
  const auto L = IT::connection_Laplacian(t);
  EXPECT_LT((Eigen::MatrixXcd(L) - Eigen::MatrixXcd(L).adjoint()).norm(), 1e-12);
  // The parallel field along the first axis of the plane, in the frames of the vertices.
  const Delta_complex& c = t.connectivity();
  const auto vectors = IT::halfedge_vectors_in_vertex(t);
  Eigen::VectorXcd field(L.rows());
  for (Vertex_index v : c.vertices()) {
    const Halfedge_index h = c.opposite(c.halfedge(v));
    const auto &p = surface.points[v.idx()], &q = surface.points[c.target(h).idx()];
    const Complex direction = Complex(q[0] - p[0], q[1] - p[1]) / t.length(c.edge(h));
    field[v.idx()] = complex_number(vectors[h.idx()]) / t.length(c.edge(h)) / direction;
  }
  EXPECT_LT((L * field).norm(), 1e-11 * field.norm());
}

// The smallest eigenvalue, in units of the norm.
double smallest_eigenvalue(const Triangulation& t)
{
  const Eigen::MatrixXcd L = IT::connection_Laplacian(t);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(L).eigenvalues()[0] / L.norm();
}

TEST(Connection_Laplacian, is_positive_semidefinite_on_closed_Delaunay_surfaces)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(12, 8), samples::bad_torus(9, 9), samples::Schwarz_lantern(6, 12), samples::pillow(20)})
    EXPECT_GT(smallest_eigenvalue(Delaunay(surface)), -1e-15);
  EXPECT_LT(smallest_eigenvalue(make_triangulation(samples::pillow(20))), -1e-4);
}

// The frame of a vertex in a plane: the factor that turns coordinates in the plane into those of the frame.
Complex turn_of_frame(const Triangulation& t, const Points& points, Vertex_index v)
{
  const Delta_complex& c = t.connectivity();
  const Halfedge_index h = c.opposite(c.halfedge(v));
  const auto vectors = IT::halfedge_vectors_in_vertex(t);
  const auto &p = points[v.idx()], &q = points[c.target(h).idx()];
  return complex_number(vectors[h.idx()]) / Complex(q[0] - p[0], q[1] - p[1]);
}

void expect_identity(const samples::Indexed_triangles& surface, Vertex_index source, double tolerance)
{
  const Triangulation t = Delaunay(surface);
  const IT::Vector_heat_method heat(t);
  const auto map = heat.log_map(source);
  ASSERT_EQ(map.size(), surface.points.size());
  const Complex turn = turn_of_frame(t, surface.points, source);
  const auto& p = surface.points[source.idx()];
  double radius = 0, error = 0;
  for (std::size_t v = 0; v < map.size(); ++v) {
    const Complex wanted(surface.points[v][0] - p[0], surface.points[v][1] - p[1]);
    radius = std::max(radius, std::abs(wanted));
    error = std::max(error, std::abs(complex_number(map[v]) - turn * wanted));
  }
  EXPECT_LT(error, tolerance * radius);
}

TEST(Log_map, of_a_flat_disk_is_the_identity)
{
  expect_identity(samples::random_diagonal_grid(20, 30), Vertex_index(100), 1e-12);
  expect_identity(samples::random_diagonal_grid(20, 30), Vertex_index(0), 1e-12);
  expect_identity(samples::sheared_grid(20, 20, 5), Vertex_index(100), 1e-10);
  expect_identity(samples::strip(400, 60, 1), Vertex_index(7), 1e-10);
}

// Heat decreases below the range of double some 700 edges away.
TEST(Log_map, reaches_the_end_of_a_long_strip)
{
  expect_identity(samples::strip(5000, 3, 1), Vertex_index(0), 1e-10);
  const samples::Indexed_triangles surface = samples::strip(5000, 3, 1);
  const Triangulation t = Delaunay(surface);
  const auto field = IT::Vector_heat_method(t).transport_tangent_vectors({{Vertex_index(0), {0, 2}}});
  const Complex at_source = Complex(0, 2) / turn_of_frame(t, surface.points, Vertex_index(0));
  const Vertex_index last(std::uint32_t(surface.points.size() - 1));
  EXPECT_LT(std::abs(complex_number(field[last.idx()]) - at_source * turn_of_frame(t, surface.points, last)), 1e-10);
}

struct Errors
{
  double mean, largest;
};

// Of the logarithmic map on the unit sphere, up to a distance of 2.5.
Errors errors_on_sphere(const samples::Indexed_triangles& surface, Vertex_index source)
{
  const Triangulation t = Delaunay(surface);
  const Delta_complex& c = t.connectivity();
  const auto map = IT::Vector_heat_method(t).log_map(source);
  using Space = Eigen::Vector3d;
  const auto point = [&](Vertex_index v) {
    const auto& p = surface.points[v.idx()];
    return Space(p[0], p[1], p[2]);
  };
  const auto exact = [&](Vertex_index v) -> Space {
    const Space p = point(source), q = point(v), along = q - p.dot(q) * p;
    return along.norm() > 0 ? Space(along / along.norm() * std::atan2(along.norm(), p.dot(q))) : Space(0, 0, 0);
  };
  const Halfedge_index h = c.opposite(c.halfedge(source));
  const Space x = exact(c.target(h)).normalized(), y = point(source).cross(x);
  const Complex h_in_frame = complex_number(IT::halfedge_vectors_in_vertex(t)[h.idx()]);
  const Complex turn = h_in_frame / std::abs(h_in_frame);
  double sum = 0, largest = 0;
  std::size_t n = 0;
  for (Vertex_index v : c.vertices()) {
    const Space wanted = exact(v);
    if (wanted.norm() > 2.5)
      continue;
    const double error = std::abs(complex_number(map[v.idx()]) - turn * Complex(wanted.dot(x), wanted.dot(y)));
    sum += error;
    largest = std::max(largest, error);
    ++n;
  }
  return {sum / double(n), largest};
}

TEST(Log_map, of_a_sphere_is_as_near_as_the_triangles_allow)
{
  const Errors errors = errors_on_sphere(sphere(4), Vertex_index(100));
  EXPECT_LT(errors.mean, 0.0075);
  EXPECT_LT(errors.largest, 0.05);
}

// With a time that is the squared length of an edge times a constant, ways along edges would be preferred however fine
// the triangles are.
TEST(Log_map, gets_nearer_under_refinement_whatever_the_directions_of_edges)
{
  double before = 1;
  for (int cuts : {3, 4, 5, 6}) {
    const double error = errors_on_sphere(sphere_of_octahedron(cuts), Vertex_index(50)).mean;
    EXPECT_LT(error, 0.75 * before) << cuts;
    before = error;
  }
}

// The other component has another number of vertices, and a time of its own.
TEST(Log_map, is_the_same_with_other_components)
{
  const samples::Indexed_triangles surface = sphere(2), other = sphere_of_octahedron(6);
  samples::Indexed_triangles both = surface;
  both.points.insert(both.points.end(), other.points.begin(), other.points.end());
  for (auto [a, b, c] : other.triangles) {
    const std::uint32_t n = std::uint32_t(surface.points.size());
    both.triangles.push_back({a + n, b + n, c + n});
  }
  const auto alone = IT::Vector_heat_method(Delaunay(surface)).log_map(Vertex_index(3));
  const auto beside = IT::Vector_heat_method(Delaunay(both)).log_map(Vertex_index(3));
  for (std::size_t v = 0; v < alone.size(); ++v)
    EXPECT_LT(std::abs(complex_number(alone[v]) - complex_number(beside[v])), 1e-12) << v;
}

TEST(Transport, on_a_cone_depends_on_the_side_of_the_apex)
{
  const double angle = 1.5 * pi;
  const std::size_t sides = 48, rings = 12;
  const Triangulation t = cone(angle, sides, rings);
  const auto vectors = IT::halfedge_vectors_in_vertex(t);
  const Delta_complex& c = t.connectivity();
  const auto vertex = [&](std::size_t ring, std::size_t i) {
    return Vertex_index(std::uint32_t(1 + (ring - 1) * sides + i % sides));
  };
  // The direction away from the apex, in the frame of a vertex: opposite to that of the edge inwards.
  const auto outwards = [&](std::size_t ring, std::size_t i) {
    Complex result = 0;
    IT::internal::for_each_halfedge_from(c, vertex(ring, i), [&](Halfedge_index h) {
      if (c.target(h) == vertex(ring - 1, i))
        result = -complex_number(vectors[h.idx()]) / t.length(c.edge(h));
    });
    return result;
  };
  const Complex source = outwards(8, 0);
  ASSERT_NEAR(std::abs(source), 1, 1e-12);
  const auto field =
    IT::Vector_heat_method(t).transport_tangent_vectors({{vertex(8, 0), {3 * source.real(), 3 * source.imag()}}});
  for (std::size_t i : {6u, 12u, 16u, 32u, 36u, 42u}) {
    // In the plane of the cone cut open opposite to the source, the field is constant.
    const double turn = angle / double(sides) * (i <= sides / 2 ? double(i) : double(i) - double(sides));
    const Complex found = complex_number(field[vertex(8, i).idx()]) / outwards(8, i);
    EXPECT_LT(std::abs(found - 3. * std::polar(1., -turn)), 0.05) << i;
  }
}

TEST(Transport, averages_between_sources_and_keeps_their_vectors)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(60, 6);
  const Triangulation t = Delaunay(surface);
  const IT::Vector_heat_method heat(t);
  const auto nearest = [&](double x, double y) {
    std::size_t result = 0;
    for (std::size_t v = 0; v < surface.points.size(); ++v)
      if (std::hypot(surface.points[v][0] - x, surface.points[v][1] - y) <
          std::hypot(surface.points[result][0] - x, surface.points[result][1] - y))
        result = v;
    return Vertex_index(std::uint32_t(result));
  };
  double width = 0, height = 0;
  for (const auto& p : surface.points) {
    width = std::max(width, p[0]);
    height = std::max(height, p[1]);
  }
  const Vertex_index left = nearest(0.1 * width, height / 2), right = nearest(0.9 * width, height / 2);
  const auto in_frame = [&](Vertex_index v, Complex z) {
    const Complex result = z * turn_of_frame(t, surface.points, v);
    return Vector(result.real(), result.imag());
  };
  const Complex a(1, 0), b(0, 5);
  const auto field = heat.transport_tangent_vectors({{left, in_frame(left, a)}, {right, in_frame(right, b)}});
  const auto in_plane = [&](Vertex_index v) {
    return complex_number(field[v.idx()]) / turn_of_frame(t, surface.points, v);
  };
  EXPECT_LT(std::abs(in_plane(left) - a), 1e-14);
  EXPECT_LT(std::abs(in_plane(right) - b), 1e-14);
  EXPECT_LT(std::abs(in_plane(nearest(0.3 * width, height / 2)) - a), 1e-3);
  EXPECT_LT(std::abs(in_plane(nearest(0.7 * width, height / 2)) - b), 1e-3);
  for (const Vector& v : field)
    EXPECT_TRUE(std::abs(complex_number(v)) >= 1 - 1e-9 && std::abs(complex_number(v)) <= 5 + 1e-9);
}

// A fan of needles over one long border edge: every angle opposite to the border is obtuse.
TEST(Transport, keeps_a_length_that_all_sources_have)
{
  const Triangulation triangulation = Delaunay(sphere(3));
  const IT::Vector_heat_method heat(triangulation);
  const Vertex_index v(0), w(100);
  for (const auto& sources : {std::vector<std::pair<Vertex_index, Vector>>{{v, {3, 4}}},
                              std::vector<std::pair<Vertex_index, Vector>>{{v, {3, 4}}, {w, {0, -5}}}})
    for (const Vector& vector : heat.transport_tangent_vectors(sources))
      EXPECT_NEAR(std::abs(complex_number(vector)), 5, 1e-14);
  // Nearly equal ones go the long way.
  const auto parallel = heat.transport_tangent_vectors({{v, {3, 4}}, {w, {0, -5 - 1e-12}}});
  for (const Vector& vector : parallel)
    EXPECT_NEAR(std::abs(complex_number(vector)), 5, 1e-10);
}

TEST(Vector_heat_method, inserts_vertices_where_the_border_has_obtuse_angles)
{
  samples::Indexed_triangles surface;
  surface.points = {{0, 0, 0}, {40, 0, 0}, {20, 1, 0}, {20, 12, 0}};
  surface.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}};
  const Triangulation t = Delaunay(surface);
  const IT::Vector_heat_method heat(t);
  EXPECT_GT(heat.number_of_border_vertices(), 0u);
  EXPECT_EQ(heat.log_map(Vertex_index(0)).size(), 4u);
  expect_identity(surface, Vertex_index(2), 1e-10);
  expect_identity(surface, Vertex_index(0), 1e-10);
  EXPECT_EQ(IT::Vector_heat_method(Delaunay(samples::random_diagonal_grid(5, 5))).number_of_border_vertices(), 0u);
}

TEST(Vector_heat_method, can_be_cancelled)
{
  for (const Triangulation& t : {Delaunay(samples::random_diagonal_grid(5, 5)), cone(5, 6, 3)}) {
    bool goes_on = false;
    const auto go_further = [&] { return goes_on; };
    EXPECT_THROW(IT::Vector_heat_method(t, CGAL::parameters::visitor(go_further)), IT::Cancelled_error);
    goes_on = true;
    const IT::Vector_heat_method heat(t, CGAL::parameters::visitor(go_further));
    std::this_thread::sleep_for(std::chrono::milliseconds(20)); // it asks a hundred times a second
    goes_on = false;
    EXPECT_THROW(heat.log_map(Vertex_index(0)), IT::Cancelled_error);
    EXPECT_THROW(heat.transport_tangent_vectors({{Vertex_index(0), {1, 0}}}), IT::Cancelled_error);
    goes_on = true;
    EXPECT_EQ(heat.log_map(Vertex_index(0)).size(), t.connectivity().number_of_vertices());
  }
}

// A strip that is a hundred thousand times as long as it is wide would ask for as many.
TEST(Vector_heat_method, inserts_no_more_than_some_vertices_for_each)
{
  const std::vector<std::array<double, 3>> points = {{0, 0, 0},    {1, 0, 0},    {2, 0, 0},
                                                     {0, 1e-5, 0}, {1, 1e-5, 0}, {2, 1e-5, 0},
                                                     {0, 2e-5, 0}, {7, 2e-5, 0}, {2, 2e-5, 0}};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 4}, {1, 2, 5}, {3, 4, 7}, {4, 5, 8},
                                                     {0, 4, 3}, {1, 5, 4}, {3, 7, 6}, {4, 8, 7}};
  IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits> triangulation(
    IT::make_Delta_complex_from_triangles(points.size(), triangles), points);
  IT::flip_to_Delaunay(triangulation);
  const IT::Vector_heat_method heat(triangulation);
  EXPECT_GT(heat.number_of_border_vertices(), 0u);
  EXPECT_LE(heat.number_of_border_vertices(), 10 * points.size() + 1000);
}

TEST(Vector_heat_method, gives_numbers_or_infinity_everywhere)
{
  samples::Indexed_triangles surface = samples::random_diagonal_grid(3, 3);
  const std::uint32_t n = std::uint32_t(surface.points.size());
  surface.points.insert(surface.points.end(),
                        {{9, 9, 9}, {20, 0, 0}, {21, 0, 0}, {20, 1, 0}, {30, 0, 0}, {31, 0, 0}, {30.25, 0, 0}});
  surface.triangles.push_back({n + 1, n + 2, n + 3});
  surface.triangles.push_back({n + 4, n + 5, n + 6}); // of zero area
  const Triangulation t = Delaunay(surface);
  const IT::Vector_heat_method heat(t);
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::uint32_t source = 0; source < surface.points.size(); ++source) {
    const auto map = heat.log_map(Vertex_index(source));
    const auto field = heat.transport_tangent_vectors({{Vertex_index(source), {0, -3}}});
    EXPECT_EQ(map[source].real(), 0);
    EXPECT_EQ(map[source].imag(), 0);
    EXPECT_EQ(field[source].imag(), -3);
    for (std::size_t v = 0; v < map.size(); ++v) {
      EXPECT_FALSE(std::isnan(map[v].real()) || std::isnan(map[v].imag())) << source << ' ' << v;
      EXPECT_EQ(std::isinf(map[v].real()), std::isinf(map[v].imag()));
      EXPECT_TRUE(std::isfinite(field[v].real()) && std::isfinite(field[v].imag()));
      if (source < n && v >= n) {
        EXPECT_EQ(map[v].real(), infinity);
        EXPECT_EQ(field[v].real(), 0);
        EXPECT_EQ(field[v].imag(), 0);
      }
    }
  }
  for (const auto& v : heat.transport_tangent_vectors({}))
    EXPECT_TRUE(v.real() == 0 && v.imag() == 0);
  for (const auto& v : heat.transport_tangent_vectors({{Vertex_index(0), {0, 0}}}))
    EXPECT_TRUE(v.real() == 0 && v.imag() == 0);
}

TEST(Vector_heat_method, does_not_depend_on_the_scale)
{
  const samples::Indexed_triangles surface = samples::bumpy_dome(12, 9);
  const auto before = IT::Vector_heat_method(Delaunay(surface)).log_map(Vertex_index(5));
  for (int exponent : {-330, 330}) {
    samples::Indexed_triangles scaled = surface;
    for (auto& p : scaled.points)
      for (double& x : p)
        x = std::ldexp(x, exponent);
    const auto map = IT::Vector_heat_method(Delaunay(scaled)).log_map(Vertex_index(5));
    for (std::size_t v = 0; v < map.size(); ++v)
      EXPECT_LT(std::abs(std::ldexp(1., -exponent) * complex_number(map[v]) - complex_number(before[v])), 1e-9);
  }
}

TEST(Vector_heat_method, extends_values_to_those_who_are_near)
{
  const samples::Indexed_triangles surface = samples::random_diagonal_grid(60, 4);
  const Triangulation t = Delaunay(surface);
  double width = 0;
  for (const auto& p : surface.points)
    width = std::max(width, p[0]);
  const Vertex_index last(std::uint32_t(surface.points.size() - 1));
  const std::vector<double> values = IT::Vector_heat_method(t).extend({{Vertex_index(0), -1}, {last, 3}});
  ASSERT_EQ(values.size(), surface.points.size());
  EXPECT_EQ(values[0], -1);
  EXPECT_EQ(values[last.idx()], 3);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (surface.points[v][0] < 0.3 * width) {
      EXPECT_NEAR(values[v], -1, 1e-3) << v;
    }
    EXPECT_TRUE(values[v] >= -1 - 1e-9 && values[v] <= 3 + 1e-9) << v;
  }
}

TEST(Vector_heat_method, refuses_what_it_cannot_use)
{
  const Triangulation t = Delaunay(samples::random_diagonal_grid(3, 3));
  EXPECT_THROW(IT::Vector_heat_method(t, CGAL::parameters::time_coefficient(0)), IT::Invalid_argument_error);
  EXPECT_THROW(IT::Vector_heat_method(t, CGAL::parameters::time_coefficient(std::nan(""))), IT::Invalid_argument_error);
  const IT::Vector_heat_method heat(t);
  EXPECT_THROW(heat.log_map(Vertex_index(16)), IT::Invalid_argument_error);
  EXPECT_THROW(heat.log_map(Vertex_index()), IT::Invalid_argument_error);
  EXPECT_THROW(heat.transport_tangent_vectors({{Vertex_index(16), {1, 0}}}), IT::Invalid_argument_error);
  EXPECT_THROW(heat.transport_tangent_vectors({{Vertex_index(0), {std::nan(""), 0}}}), IT::Invalid_argument_error);
}

} // namespace

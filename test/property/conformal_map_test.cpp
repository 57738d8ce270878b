// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conformal maps: what they claim, checked in rational numbers, and against known maps.

#include "conformal_claims.h"

#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/harmonic_parameterization.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <ctime>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace conformal_claims;
using IT::Vertex_index;
using samples::Indexed_triangles;

TEST(Conformal_map, claims_are_true_in_rational_numbers)
{
  Indexed_triangles shaken_torus = samples::torus(20, 12);
  std::mt19937 random(2);
  for (auto& p : shaken_torus.points)
    for (double& x : p)
      x += 0.04 * (double(random()) / 0x1p31 - 1);
  Indexed_triangles with_isolated_vertex = samples::bumpy_dome(8, 6, 0.2);
  with_isolated_vertex.points.push_back({9, 9, 9});
  for (const Indexed_triangles& surface :
       {samples::bumpy_sphere(20, 15, 0.3), with_isolated_vertex, samples::torus(20, 12), shaken_torus,
        samples::bumpy_dome(14, 10, 0.2), samples::disk_with_spike(12, 8, 3), samples::sheared_grid(9, 7, 3),
        samples::latitude_longitude_sphere(16, 9), samples::prism(20), samples::cap(1e-3),
        samples::random_diagonal_grid(8, 8)}) {
    const Triangulation t = triangulation_of(surface);
    const Conformal_map map = IT::conformal_parameterization(t);
    EXPECT_EQ(defect(map, t), "") << surface.points.size();
    EXPECT_LT(map.metric.residual, 1e-10);
    EXPECT_LT(map.seam, 1e-9);
    const IT::Delta_complex& c = t.connectivity();
    const auto edges = c.edges();
    const bool has_border = std::any_of(edges.begin(), edges.end(), [&](IT::Edge_index e) { return c.is_border(e); });
    if (has_border && map.metric.cones.empty() &&
        c.number_of_vertices() + c.number_of_faces() == c.number_of_edges() + 1)
      for (const auto& sides : map.is_cut)
        EXPECT_FALSE(sides[0] || sides[1] || sides[2]) << "a disk has to be cut nowhere";
    Conformal_map moved = map;
    const std::size_t i = moved.uv.size() / 2;
    moved.uv[i][0][0] = moved.uv[i][1][0];
    moved.uv[i][0][1] = moved.uv[i][1][1];
    EXPECT_NE(defect(moved, t), "");
    // By the last bit, so that it does not fit together, unless it is on the border.
    moved = map;
    for (std::size_t k = 0; k < 3; ++k)
      moved.uv[i][k][0] = std::nextafter(moved.uv[i][k][0], 1e9);
    EXPECT_NE(defect(moved, t), "");
  }
}

// Faces of the Delaunay triangulation that hundreds of edges of the other two cross.
TEST(Conformal_map, divides_faces_in_time_for_their_pieces_not_for_pairs_of_chords)
{
  for (const Indexed_triangles& surface :
       {samples::strip(300, 60), samples::Schwarz_lantern(8, 60), samples::bad_torus(30, 30)}) {
    const Triangulation t = triangulation_of(surface);
    const std::clock_t start = std::clock();
    const Conformal_map map = IT::conformal_parameterization(t);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    EXPECT_EQ(defect(map, t), "") << surface.points.size();
    EXPECT_LT(seconds, 10) << map.triangles.size(); // all pairs: minutes
  }
}

TEST(Conformal_map, moves_points_there_and_back)
{
  const Triangulation t = triangulation_of(samples::bumpy_sphere(16, 11, 0.3));
  const Conformal_map map = IT::conformal_parameterization(t);
  std::mt19937 random(4);
  int same = 0, hits = 0, checked = 0;
  for (int i = 0; i < 200; ++i) {
    const IT::Face_index f(std::uint32_t(random() % t.input().number_of_faces()));
    const double a = double(random()) + 1, b = double(random()) + 1, c = double(random()) + 1;
    const IT::Surface_point p{t.input().halfedge(f), {a, b, c}};
    const Conformal_map::Point x = map.to_plane(p);
    const IT::Surface_point q = map.to_surface(x);
    const Conformal_map::Point y = map.to_plane(q);
    EXPECT_NEAR(x[0], y[0], 1e-12);
    EXPECT_NEAR(x[1], y[1], 1e-12);
    if (t.input().face(q.halfedge) == f) {
      ++same;
      const std::array<double, 3> coordinates = IT::coordinates_from(t.input(), q, p.halfedge);
      EXPECT_NEAR(coordinates[0], a / (a + b + c), 1e-9);
    }
  }
  EXPECT_TRUE(same == 200 || map.overlaps) << same;
  for (IT::Halfedge_index h : t.input().halfedges()) // a vertex that is cut has several images
    if (std::find(map.metric.cones.begin(), map.metric.cones.end(), t.input().source(h)) == map.metric.cones.end() &&
        std::find(map.divided_input.begin(), map.divided_input.end(), t.input().face(h)) == map.divided_input.end())
      ++checked, hits += map.to_plane({h, {1, 0, 0}}) == map.input_uv[h.idx()];
  EXPECT_GT(hits, 0.9 * checked);
  const IT::Halfedge_index h = t.input().halfedge(IT::Face_index(0));
  EXPECT_EQ(map.to_plane({h, {0x1p1023, 0x1p1023, 0x1p1022}}), map.to_plane({h, {2, 2, 1}}));
  EXPECT_THROW(map.to_plane({h, {1, -1, 1}}), IT::Invalid_point_error);
  EXPECT_THROW(map.to_plane({IT::Halfedge_index(), {1, 1, 1}}), IT::Invalid_point_error);
}

// Around an axis, with n rings: `profile` gives the distance from the axis, and the height, for 0 at the axis to 1.
template <class Profile>
Indexed_triangles rings(std::uint32_t n, const Profile& profile)
{
  Indexed_triangles result;
  result.points.push_back({0, 0, profile(0).second});
  std::vector<std::uint32_t> first{0};
  for (std::uint32_t r = 1; r <= n; ++r) {
    first.push_back(std::uint32_t(result.points.size()));
    for (std::uint32_t i = 0; i < 6 * r; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.2 * (r % 3)) / (6 * r);
      const auto [radius, height] = profile(double(r) / n);
      result.points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  }
  for (std::uint32_t r = 0; r < n; ++r) {
    const std::uint32_t inner = (std::max)(1u, 6 * r), outer = 6 * (r + 1);
    for (std::uint32_t i = 0, j = 0; i < (r == 0 ? 0 : inner) || j < outer;) {
      const auto in = [&](std::uint32_t k) { return first[r] + k % inner; };
      const auto out = [&](std::uint32_t k) { return first[r + 1] + k % outer; };
      if (r == 0 || (j < outer && (j + 0.5) / outer <= (i + 0.5) / inner) || i == inner) {
        result.triangles.push_back({in(i), out(j), out(j + 1)});
        ++j;
      } else {
        result.triangles.push_back({in(i), out(j), in(i + 1)});
        ++i;
      }
    }
  }
  return result;
}

// The largest distance of images of vertices from known ones, after the similarity that fits best.
template <class Known>
double distance_from(const std::vector<Conformal_map::Point>& images, const Indexed_triangles& surface,
                     const Known& known)
{
  using C = std::complex<double>;
  std::vector<C> z, w;
  for (std::size_t v = 0; v < surface.points.size(); ++v) {
    z.push_back(known(surface.points[v]));
    w.emplace_back(images[v][0], images[v][1]);
  }
  C mean_z = 0, mean_w = 0, product = 0;
  double squares = 0, result = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    mean_z += z[i] / double(z.size());
    mean_w += w[i] / double(z.size());
  }
  for (std::size_t i = 0; i < z.size(); ++i) {
    product += (z[i] - mean_z) * std::conj(w[i] - mean_w);
    squares += std::norm(w[i] - mean_w);
  }
  for (std::size_t i = 0; i < z.size(); ++i)
    result = (std::max)(result, std::abs(product / squares * (w[i] - mean_w) - (z[i] - mean_z)));
  return result;
}
template <class Known>
double distance_from(const Conformal_map& map, const Indexed_triangles& surface, const Known& known)
{
  std::vector<Conformal_map::Point> images;
  for (std::size_t v = 0; v < surface.points.size(); ++v)
    images.push_back(map.to_plane(map.places[v]));
  return distance_from(images, surface, known);
}

Indexed_triangles hemisphere(std::uint32_t n)
{
  return rings(n, [](double t) { return std::make_pair(std::sin(CGAL_PI / 2 * t), std::cos(CGAL_PI / 2 * t)); });
}
std::complex<double> stereographic(const std::array<double, 3>& p) { return {p[0] / (1 + p[2]), p[1] / (1 + p[2])}; }

// All conformal maps of a hemisphere with its symmetry are similar.
TEST(Conformal_map, of_a_hemisphere_is_as_good_as_other_maps_of_disks)
{
  const Indexed_triangles surface = hemisphere(16);
  Triangulation t = triangulation_of(surface);
  const double free = distance_from(IT::conformal_parameterization(t), surface, stereographic);
  IT::flip_to_Delaunay(t);
  const double harmonic = distance_from(IT::harmonic_parameterization(t), surface, stereographic),
               natural = distance_from(IT::natural_parameterization(t), surface, stereographic);
  EXPECT_LT(10 * free, harmonic);
  EXPECT_LT(100 * free, natural);
}

TEST(Conformal_map, of_a_hemisphere_tends_to_stereographic_projection)
{
  std::vector<double> errors;
  for (std::uint32_t n : {4u, 8u, 16u, 32u}) {
    const Indexed_triangles cap =
      rings(n, [](double t) { return std::make_pair(std::sin(CGAL_PI / 2 * t), std::cos(CGAL_PI / 2 * t)); });
    const Triangulation t = triangulation_of(cap);
    const Conformal_map map = IT::conformal_parameterization(t);
    EXPECT_EQ(defect(map, t), "");
    EXPECT_FALSE(map.overlaps);
    errors.push_back(distance_from(map, cap, stereographic));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_GT(std::log2(errors[i - 1] / errors[i]), 1.4) << errors[i - 1] << " then " << errors[i];
    RecordProperty("exponent_" + std::to_string(i), std::to_string(std::log2(errors[i - 1] / errors[i])));
  }
}

TEST(Conformal_map, flattens_a_cone_by_a_power)
{
  // A cone with the angle 2 pi / a becomes a disk by z^a. With r from its apex, lengths are multiplied by r^(a - 1), if
  // the border keeps its scale.
  const double a = 1.25, slope = std::sqrt(a * a - 1);
  std::vector<double> errors, errors_of_u;
  for (std::uint32_t n : {10u, 20u, 40u}) {
    const Indexed_triangles cone = rings(n, [&](double t) { return std::make_pair(t / a, -slope * t / a); });
    const Triangulation t = triangulation_of(cone);
    const Conformal_map map = IT::conformal_parameterization(t, CGAL::parameters::number_of_cones(0));
    EXPECT_EQ(defect(map, t), "");
    const auto from_apex = [&](const std::array<double, 3>& p) { return std::hypot(p[0], p[1], p[2]); };
    errors.push_back(distance_from(map, cone, [&](const std::array<double, 3>& p) {
      return std::polar(std::pow(from_apex(p), a), std::atan2(p[1], p[0]));
    }));
    errors_of_u.push_back(0);
    for (std::size_t v = 0; v < cone.points.size(); ++v)
      if (const double r = from_apex(cone.points[v]); r > 0.3)
        errors_of_u.back() = (std::max)(errors_of_u.back(), std::abs(map.metric.u[v] - (a - 1) * std::log(r)));
  }
  for (std::size_t i = 1; i < errors.size(); ++i) {
    EXPECT_LT(errors[i], errors[i - 1] / 2) << "after " << i;
    EXPECT_LT(errors_of_u[i], errors_of_u[i - 1] / 3) << "after " << i;
  }
  EXPECT_LT(errors.back(), 2e-3);
  EXPECT_LT(errors_of_u.back(), 2e-3);
}

// A piece with four corners is two triangles: one projective map, which is known from three corners. Neighbors on both
// sides of a line of the ideal triangulation have different ones.
TEST(Conformal_map, is_projective_in_homogeneous_coordinates)
{
  const Triangulation t = triangulation_of(samples::bumpy_dome(24, 20, 0.6));
  const Conformal_map map = IT::conformal_parameterization(t, CGAL::parameters::number_of_cones(0));
  ASSERT_EQ(map.weights.size(), map.places.size());
  int projective = 0, linear = 0;
  for (std::size_t i = 0; i + 1 < map.triangles.size(); ++i)
    for (std::size_t j = i + 1; j < map.triangles.size() && map.input_faces[j] == map.input_faces[i]; ++j) {
      const auto &first = map.triangles[i], &second = map.triangles[j];
      const auto is_common = [&](std::uint32_t v) { return std::find(first.begin(), first.end(), v) != first.end(); };
      const auto other = std::find_if_not(second.begin(), second.end(), is_common);
      if (std::count_if(second.begin(), second.end(), is_common) != 2)
        continue;
      const auto place = [&](std::uint32_t v) { return map.coordinates_in_face(map.places[v], map.input_faces[i]); };
      const auto determinant = [](const auto& a, const auto& b, const auto& c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
      };
      const auto p = place(first[0]), q = place(first[1]), r = place(first[2]), x = place(*other);
      const double all = determinant(p, q, r);
      const std::array<double, 3> at{determinant(x, q, r) / all, determinant(p, x, r) / all,
                                     determinant(p, q, x) / all};
      const Conformal_map::Point& expected = map.uv[j][std::size_t(other - second.begin())];
      const auto error = [&](const std::array<double, 3>& weights, double weight) {
        double sum = 0, u = 0, v = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          sum += at[k] * weights[k];
          u += at[k] * weights[k] * map.uv[i][k][0];
          v += at[k] * weights[k] * map.uv[i][k][1];
        }
        return (std::max)(std::abs(sum / weight - 1), std::hypot(u / sum - expected[0], v / sum - expected[1]));
      };
      projective +=
        error({map.weights[first[0]], map.weights[first[1]], map.weights[first[2]]}, map.weights[*other]) < 1e-10;
      linear += error({1, 1, 1}, 1) < 1e-10;
    }
  EXPECT_GT(projective, 400);
  EXPECT_LT(linear, projective / 10);
}

TEST(Conformal_map, can_be_interrupted)
{
  const Triangulation t = triangulation_of(samples::bumpy_sphere(20, 15, 0.3));
  int calls = 0;
  double last = 0;
  IT::conformal_parameterization(t, CGAL::parameters::visitor([&](double fraction) {
                                   EXPECT_TRUE(fraction >= 0 && fraction <= 1);
                                   last = fraction;
                                   return ++calls > 0;
                                 }));
  EXPECT_GT(last, 0.7);
  const int all = calls;
  for (const int last_call : {1, all / 2, all - 1}) {
    calls = 0;
    EXPECT_THROW(
      IT::conformal_parameterization(t, CGAL::parameters::visitor([&](double) { return ++calls <= last_call; })),
      IT::Cancelled_error);
  }
}

TEST(Conformal_map, needs_a_face)
{
  const Triangulation t(IT::make_Delta_complex_from_triangles(3, std::vector<std::array<std::uint32_t, 3>>()),
                        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  EXPECT_THROW(IT::conformal_parameterization(t), IT::Invalid_surface_error);
}

// Triangles that a cut crosses have images like those of their neighbors: each is as conformal as the map.
TEST(Conformal_map, gives_images_to_input_triangles_that_a_cut_crosses)
{
  const Indexed_triangles surface = samples::bumpy_sphere(40, 30, 0.2);
  const Triangulation t = triangulation_of(surface);
  const Conformal_map map = IT::conformal_parameterization(t);
  EXPECT_GT(map.divided_input.size(), 10u);
  EXPECT_LT(map.turned_input.size(), t.input().number_of_faces() / 50);
  std::vector<double> of_divided, of_others;
  for (IT::Face_index f : t.input().faces()) {
    const IT::Halfedge_index h = t.input().halfedge(f);
    double least = 1e9, most = 0; // the change of a side's length
    for (IT::Halfedge_index side : {h, t.input().next(h), t.input().prev(h)}) {
      const auto &p = map.input_uv[side.idx()], &q = map.input_uv[t.input().next(side).idx()];
      const double change =
        std::hypot(p[0] - q[0], p[1] - q[1]) /
        std::sqrt(t.input_metric().squared_length_double_double(t.input(), t.input().edge(side)).hi());
      least = (std::min)(least, change);
      most = (std::max)(most, change);
    }
    const bool is_divided = std::find(map.divided_input.begin(), map.divided_input.end(), f) != map.divided_input.end();
    (is_divided ? of_divided : of_others).push_back(most / least);
  }
  std::sort(of_divided.begin(), of_divided.end());
  std::sort(of_others.begin(), of_others.end());
  EXPECT_LT(of_divided[of_divided.size() * 9 / 10], of_others[of_others.size() * 99 / 100]);
}

// The factors are those of the areas, and 1 on a plane.
TEST(Conformal_map, knows_how_much_it_stretches)
{
  const Conformal_map flat = IT::conformal_parameterization(triangulation_of(samples::sheared_grid(9, 7, 1)));
  for (const auto& [most, least] : flat.stretch) {
    EXPECT_NEAR(most, 1, 1e-9);
    EXPECT_NEAR(least, 1, 1e-9);
  }
  const Triangulation t = triangulation_of(samples::bumpy_dome(14, 10, 0.2));
  const Conformal_map map = IT::conformal_parameterization(t);
  ASSERT_EQ(map.stretch.size(), map.triangles.size());
  double on_surface = 0, in_faces = 0;
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const auto& [p, q, r] = map.uv[i];
    on_surface +=
      ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])) / 2 / (map.stretch[i][0] * map.stretch[i][1]);
    EXPECT_GE(map.stretch[i][0], map.stretch[i][1]);
  }
  for (double area : IT::face_areas(t))
    in_faces += area;
  EXPECT_NEAR(on_surface / in_faces, 1, 1e-9);
}

// (n + 1)^2 vertices, mirrored at x = 0: vertex (i, j) has the number i (n + 1) + j, and the mirror image (n - i, j).
template <class Height>
Indexed_triangles symmetric_roof(std::uint32_t n, const Height& height)
{
  Indexed_triangles roof;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double x = (double(i) - n / 2.) / 6, y = (double(j) - n / 2.) / 6;
      roof.points.push_back({x, y, height(std::abs(x), y)});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t v = i * (n + 1) + j;
      if (i < n / 2) {
        roof.triangles.push_back({v, v + n + 1, v + n + 2});
        roof.triangles.push_back({v, v + n + 2, v + 1});
      } else {
        roof.triangles.push_back({v, v + n + 1, v + 1});
        roof.triangles.push_back({v + 1, v + n + 1, v + n + 2});
      }
    }
  return roof;
}

TEST(Conformal_map, of_a_symmetric_surface_is_symmetric)
{
  const std::uint32_t n = 12;
  const Indexed_triangles roof =
    symmetric_roof(n, [](double x, double y) { return 0.8 * std::exp(-3 * x * x - 2 * y * y); });
  const Triangulation t = triangulation_of(roof);
  const Conformal_map map = IT::conformal_parameterization(t);
  EXPECT_EQ(defect(map, t), "");
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const auto vertex = [&](std::uint32_t k) { return k * (n + 1) + j; };
      EXPECT_NEAR(map.metric.u[vertex(i)], map.metric.u[vertex(n - i)], 1e-12);
      // All distances in the plane are the same as those of the mirror images.
      const auto distance = [&](std::uint32_t a, std::uint32_t b) {
        const auto p = map.to_plane(map.places[a]), q = map.to_plane(map.places[b]);
        return std::hypot(p[0] - q[0], p[1] - q[1]);
      };
      EXPECT_NEAR(distance(vertex(i), 0), distance(vertex(n - i), n * (n + 1)), 1e-11);
    }
}

TEST(Conformal_map, has_symmetric_cones_on_a_symmetric_surface)
{
  const std::uint32_t n = 12;
  const Triangulation t = triangulation_of(symmetric_roof(n, [](double x, double y) {
    return std::exp(-8 * ((x - 0.5) * (x - 0.5) + y * y)) - 0.5 * std::exp(-8 * (x * x + (y - 0.7) * (y - 0.7)));
  }));
  std::size_t most = 0;
  for (double range = 0.9; range > 0.1; range *= 0.95) {
    const IT::Discrete_conformal_metric metric =
      IT::discrete_conformal_metric(t, CGAL::parameters::maximum_range(range));
    most = (std::max)(most, metric.cones.size());
    for (Vertex_index v : metric.cones) {
      const Vertex_index mirrored((n - v.idx() / (n + 1)) * (n + 1) + v.idx() % (n + 1));
      EXPECT_EQ(std::count(metric.cones.begin(), metric.cones.end(), mirrored), 1) << v.idx() << " at " << range;
    }
    for (std::uint32_t v = 0; v < metric.u.size(); ++v)
      EXPECT_NEAR(metric.u[v], metric.u[(n - v / (n + 1)) * (n + 1) + v % (n + 1)], 1e-9);
  }
  EXPECT_GT(most, 3u);
}

TEST(Conformal_map, lays_components_out_side_by_side_and_keeps_inserted_vertices)
{
  Indexed_triangles all = samples::bumpy_sphere(12, 9, 0.3);
  const std::uint32_t first = std::uint32_t(all.points.size());
  const Indexed_triangles torus = samples::torus(12, 8);
  all.points.insert(all.points.end(), torus.points.begin(), torus.points.end());
  for (const auto& t : torus.triangles)
    all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  Triangulation t = triangulation_of(all);
  IT::insert_vertex(t, {t.input().halfedge(IT::Face_index(3)), {0.3, 0.3, 0.4}});
  const Conformal_map map = IT::conformal_parameterization(t);
  EXPECT_EQ(defect(map, t), "");
  EXPECT_EQ(map.metric.u.size(), all.points.size() + 1);
  std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
  for (std::size_t i = 0; i < map.uv.size(); ++i)
    for (const auto& p : map.uv[i]) {
      const std::size_t part = t.input().source(t.input().halfedge(map.input_faces[i])).idx() >= first;
      low[part] = (std::min)(low[part], p[0]);
      high[part] = (std::max)(high[part], p[0]);
    }
  EXPECT_TRUE(high[0] < low[1] || high[1] < low[0]);
}

} // namespace

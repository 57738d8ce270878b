// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sample surfaces keep their promises: oriented manifolds of the stated counts and topology, with a metric and the
// stated defects.

#include "samples/sample_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace {

using samples::Glued_triangles;
using samples::Indexed_triangles;

constexpr std::size_t none = static_cast<std::size_t>(-1);

std::size_t next_side(std::size_t side) { return side - side % 3 + (side + 1) % 3; }

struct Counts
{
  std::size_t vertices = 0, edges = 0, faces = 0, boundary_edges = 0, components = 0;
  long Euler_characteristic() const
  {
    return static_cast<long>(vertices) - static_cast<long>(edges) + static_cast<long>(faces);
  }
};

// Counts the classes that merging makes of 0, ..., size - 1.
class Classes
{
public:
  explicit Classes(std::size_t size) : parent_(size), count_(size) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t element)
  {
    while (parent_[element] != element)
      element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void merge(std::size_t a, std::size_t b)
  {
    a = find(a);
    b = find(b);
    if (a != b) {
      parent_[a] = b;
      --count_;
    }
  }
  std::size_t count() const { return count_; }

private:
  std::vector<std::size_t> parent_;
  std::size_t count_;
};

// A vertex is a class of corners here, so a point where two fans meet counts twice.
Counts count(const std::vector<std::size_t>& twins)
{
  Counts counts;
  Classes corners(twins.size()), faces(twins.size() / 3);
  for (std::size_t side = 0; side < twins.size(); ++side) {
    if (twins[side] == none) {
      ++counts.edges;
      ++counts.boundary_edges;
      continue;
    }
    counts.edges += side < twins[side];
    corners.merge(side, next_side(twins[side]));
    faces.merge(side / 3, twins[side] / 3);
  }
  counts.vertices = corners.count();
  counts.faces = twins.size() / 3;
  counts.components = faces.count();
  return counts;
}

// The twin of each side; none on the boundary.
std::vector<std::size_t> twins_of(const Indexed_triangles& surface)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> sides;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& corners = surface.triangles[face];
      const bool is_new = sides.insert({{corners[i], corners[(i + 1) % 3]}, 3 * face + i}).second;
      EXPECT_TRUE(is_new) << "directed edge " << corners[i] << " " << corners[(i + 1) % 3] << " occurs twice";
    }
  std::vector<std::size_t> twins(3 * surface.triangles.size(), none);
  for (const auto& [ends, side] : sides) {
    const auto opposite = sides.find({ends.second, ends.first});
    if (opposite != sides.end())
      twins[side] = opposite->second;
  }
  return twins;
}

std::vector<std::size_t> twins_of(const Glued_triangles& gluing)
{
  std::vector<std::size_t> twins(3 * gluing.number_of_faces, none);
  for (const auto& [first, second] : gluing.glued_sides) {
    EXPECT_LT(first, twins.size());
    EXPECT_LT(second, twins.size());
    EXPECT_NE(first, second);
    EXPECT_EQ(twins[first], none);
    EXPECT_EQ(twins[second], none);
    twins[first] = second;
    twins[second] = first;
  }
  return twins;
}

std::array<double, 3> difference(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
}

double dot(const std::array<double, 3>& u, const std::array<double, 3>& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

std::array<double, 3> cross(const std::array<double, 3>& u, const std::array<double, 3>& v)
{
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

std::array<double, 3> area_vector(const Indexed_triangles& surface, std::size_t face)
{
  const auto& [a, b, c] = surface.triangles[face];
  return cross(difference(surface.points[a], surface.points[b]), difference(surface.points[a], surface.points[c]));
}

std::size_t degenerate_faces(const Indexed_triangles& surface)
{
  std::size_t count = 0;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face) {
    const auto normal = area_vector(surface, face);
    count += normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
  }
  return count;
}

double volume(const Indexed_triangles& surface)
{
  double sum = 0;
  for (std::size_t face = 0; face < surface.triangles.size(); ++face)
    sum += dot(surface.points[surface.triangles[face][0]], area_vector(surface, face)) / 6;
  return sum;
}

// The requirements on every triangle sample, and the stated counts.
void check(const Indexed_triangles& surface, std::size_t vertices, std::size_t faces, long Euler_characteristic,
           std::size_t boundary_edges)
{
  for (const auto& point : surface.points)
    for (double coordinate : point)
      ASSERT_TRUE(std::isfinite(coordinate));
  for (const auto& [a, b, c] : surface.triangles) {
    ASSERT_LT(std::max({a, b, c}), surface.points.size());
    ASSERT_TRUE(a != b && b != c && c != a) << "a corner is repeated";
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      const auto edge = difference(surface.points[p], surface.points[q]);
      ASSERT_GT(dot(edge, edge), 0) << "edge " << p << " " << q << " has no length";
    }
  }
  const Counts counts = count(twins_of(surface));
  EXPECT_EQ(surface.points.size(), vertices);
  EXPECT_EQ(counts.vertices, vertices) << "a vertex is unused or has several fans";
  EXPECT_EQ(counts.faces, faces);
  EXPECT_EQ(counts.Euler_characteristic(), Euler_characteristic);
  EXPECT_EQ(counts.boundary_edges, boundary_edges);
  EXPECT_EQ(counts.components, 1u);
}

Counts check(const Glued_triangles& gluing)
{
  const std::vector<std::size_t> twins = twins_of(gluing);
  EXPECT_EQ(gluing.side_lengths.size(), twins.size());
  for (std::size_t side = 0; side < twins.size(); ++side) {
    const double length = gluing.side_lengths[side];
    EXPECT_GT(length, 0);
    EXPECT_LT(length, gluing.side_lengths[next_side(side)] + gluing.side_lengths[next_side(next_side(side))]);
    if (twins[side] != none) {
      EXPECT_EQ(length, gluing.side_lengths[twins[side]]);
    }
  }
  return count(twins);
}

bool same(const Indexed_triangles& a, const Indexed_triangles& b)
{
  return a.points == b.points && a.triangles == b.triangles;
}

struct Flip_result
{
  std::size_t flips, loops, self_glued_edges;
};

// Flips to Delaunay with squared lengths and areas in double precision.
Flip_result flip_to_Delaunay(const Indexed_triangles& surface, bool newest_first, std::size_t most_flips)
{
  std::vector<std::size_t> twin = twins_of(surface), next(twin.size()), source(twin.size()), face(twin.size());
  std::vector<double> squared_length(twin.size()), area(surface.triangles.size());
  for (std::size_t side = 0; side < twin.size(); ++side) {
    next[side] = next_side(side);
    face[side] = side / 3;
    source[side] = surface.triangles[side / 3][side % 3];
    const std::size_t target = surface.triangles[side / 3][(side + 1) % 3];
    const auto edge = difference(surface.points[source[side]], surface.points[target]);
    squared_length[side] = dot(edge, edge);
  }
  for (std::size_t f = 0; f < area.size(); ++f) {
    const auto normal = area_vector(surface, f);
    area[f] = 2 * std::sqrt(dot(normal, normal));
  }
  std::deque<std::size_t> queue;
  for (std::size_t side = 0; side < twin.size(); ++side)
    if (twin[side] != none && side < twin[side])
      queue.push_back(side);
  Flip_result result{0, 0, 0};
  while (!queue.empty() && result.flips < most_flips) {
    const std::size_t h = newest_first ? queue.back() : queue.front();
    newest_first ? queue.pop_back() : queue.pop_front();
    const std::size_t g = twin[h];
    if (g == none || face[h] == face[g])
      continue;
    const std::size_t jk = next[h], ki = next[jk], il = next[g], lj = next[il];
    const double s = squared_length[h], first_area = area[face[h]], second_area = area[face[g]];
    if ((squared_length[jk] + squared_length[ki] - s) * second_area +
          (squared_length[il] + squared_length[lj] - s) * first_area >=
        0)
      continue;
    const double x_k = squared_length[ki] + s - squared_length[jk], x_l = squared_length[il] + s - squared_length[lj];
    squared_length[h] = squared_length[g] =
      squared_length[ki] + squared_length[il] - (x_k * x_l - first_area * second_area) / (2 * s);
    area[face[h]] = (x_k * second_area + x_l * first_area) / (2 * s);
    area[face[g]] = first_area + second_area - area[face[h]];
    source[h] = source[lj];
    source[g] = source[ki];
    next[il] = h;
    next[h] = ki;
    next[ki] = il;
    next[lj] = jk;
    next[jk] = g;
    next[g] = lj;
    face[il] = face[h];
    face[jk] = face[g];
    ++result.flips;
    queue.insert(queue.end(), {jk, ki, il, lj});
  }
  for (std::size_t side = 0; side < twin.size(); ++side)
    if (twin[side] == none || side < twin[side]) {
      result.loops += source[side] == source[next[side]];
      result.self_glued_edges += twin[side] != none && face[side] == face[twin[side]];
    }
  return result;
}

TEST(Sample_surfaces, closed_surfaces)
{
  check(samples::bumpy_sphere(), 5002, 10000, 2, 0);
  check(samples::bumpy_sphere(3, 2), 5, 6, 2, 0);
  check(samples::latitude_longitude_sphere(12, 7), 74, 144, 2, 0);
  check(samples::latitude_longitude_sphere(3, 2), 5, 6, 2, 0);
  check(samples::torus(7, 5), 35, 70, 0, 0);
  check(samples::torus(3, 3), 9, 18, 0, 0);
  check(samples::bad_torus(50, 40, 7), 2000, 4000, 0, 0);
  for (std::size_t n : {3u, 4u, 80u, 185u})
    check(samples::prism(n), 2 * n, 4 * n - 4, 2, 0);
  check(samples::helical_tube(), 60, 116, 2, 0);
  check(samples::helical_tube(4), 4, 4, 2, 0);
  check(samples::helical_tube(60, 1e7), 60, 116, 2, 0);
  check(samples::pillow(), 300, 596, 2, 0);
  check(samples::pillow(6), 6, 8, 2, 0);
}

TEST(Sample_surfaces, surfaces_with_boundary)
{
  check(samples::disk_with_spike(), 1001, 1960, 1, 40);
  check(samples::disk_with_spike(3, 1), 4, 3, 1, 3);
  check(samples::bumpy_dome(), 433, 840, 1, 24);
  check(samples::bumpy_dome(3, 1), 4, 3, 1, 3);
  check(samples::Schwarz_lantern(9, 4), 45, 72, 0, 18);
  check(samples::Schwarz_lantern(3, 1), 6, 6, 0, 6);
  for (double bulge : {0.0, 1e-17, 1e-10, 1e-3})
    for (std::uint64_t rotation_seed : {0u, 5u})
      check(samples::cap(bulge, rotation_seed), 23, 40, 1, 4);
  for (double scale : {1e-3, 1e-9, 1e-12})
    check(samples::sliver_sheet(40, scale, scale), 1600, 3042, 1, 156);
  check(samples::sliver_sheet(2), 4, 2, 1, 4);
  check(samples::random_diagonal_grid(8, 5, 2, 3), 54, 80, 1, 26);
  check(samples::sheared_grid(8, 5, -3.5), 54, 80, 1, 26);
  check(samples::strip(), 10000, 9998, 1, 10000);
  check(samples::strip(2, 1), 4, 2, 1, 4);
  check(samples::strip(50, 0), 100, 98, 1, 100);
  check(samples::strip(50, 49), 100, 98, 1, 100);
}

TEST(Sample_surfaces, faces_are_degenerate_only_where_stated)
{
  for (const samples::Sample& sample : samples::sample_names()) {
    const auto surface = samples::make_sample(sample.name);
    if (const auto* triangles = std::get_if<Indexed_triangles>(&surface)) {
      EXPECT_EQ(degenerate_faces(*triangles), 0u) << sample.name;
    }
  }
  EXPECT_EQ(degenerate_faces(samples::cap(0)), 19u);
  EXPECT_EQ(degenerate_faces(samples::sliver_sheet(40, 1e-12, 1e-12)), 0u);
  EXPECT_EQ(degenerate_faces(samples::helical_tube(60, 1e7)), 0u);
}

TEST(Sample_surfaces, faces_are_counterclockwise)
{
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(volume(samples::latitude_longitude_sphere(100, 100)), 4 * pi / 3, 0.01);
  EXPECT_GT(volume(samples::bumpy_sphere()), 3);
  EXPECT_GT(volume(samples::bumpy_dome()), 3); // of the cone over it from the centre
  EXPECT_NEAR(volume(samples::torus(100, 100)), 2 * pi * pi * 0.16, 0.01);
  EXPECT_NEAR(volume(samples::bad_torus()), 2 * pi * pi * 0.32 * 0.32, 0.02);
  EXPECT_NEAR(volume(samples::prism(1000)), 5 * pi, 0.001);
  EXPECT_NEAR(volume(samples::prism(1000, 3)), 5 * pi, 0.001);
  EXPECT_GT(volume(samples::helical_tube()), 0);
  EXPECT_EQ(volume(samples::pillow()), 0);
  for (const auto& flat : {samples::cap(0.1), samples::random_diagonal_grid(), samples::sheared_grid(),
                           samples::strip(), samples::disk_with_spike(), samples::sliver_sheet(40, 1, 0)})
    for (std::size_t face = 0; face < flat.triangles.size(); ++face)
      ASSERT_GT(area_vector(flat, face)[2], 0) << "face " << face;
}

TEST(Sample_surfaces, rotation_is_rigid)
{
  const Indexed_triangles still = samples::prism(20), turned = samples::prism(20, 9);
  EXPECT_FALSE(same(still, turned));
  EXPECT_EQ(still.triangles, turned.triangles);
  for (std::size_t i = 0; i < still.points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const auto u = difference(still.points[i], still.points[j]), v = difference(turned.points[i], turned.points[j]);
      EXPECT_NEAR(dot(u, u), dot(v, v), 1e-12);
    }
}

TEST(Sample_surfaces, seeds_decide_everything)
{
  EXPECT_TRUE(same(samples::bumpy_sphere(), samples::bumpy_sphere()));
  EXPECT_FALSE(same(samples::bad_torus(9, 9, 1), samples::bad_torus(9, 9, 2)));
  EXPECT_TRUE(same(samples::bad_torus(9, 9, 2), samples::bad_torus(9, 9, 2)));
  EXPECT_EQ(samples::random_gluing(20, 3).glued_sides, samples::random_gluing(20, 3).glued_sides);
  EXPECT_EQ(samples::random_gluing(20, 3).side_lengths, samples::random_gluing(20, 3).side_lengths);
  EXPECT_NE(samples::random_gluing(20, 3).glued_sides, samples::random_gluing(20, 4).glued_sides);
  // The standard states the 10,000th number of the default seed: the conversion must not vary.
  samples::Sample_random random(std::mt19937_64::default_seed);
  for (int i = 1; i < 10000; ++i)
    random.uniform();
  EXPECT_EQ(random.uniform(), static_cast<double>(9981545732273789042ull >> 11) / 9007199254740992.0);
}

TEST(Sample_surfaces, small_gluings)
{
  const Counts torus = check(samples::one_vertex_torus());
  EXPECT_EQ(torus.vertices, 1u);
  EXPECT_EQ(torus.edges, 3u);
  EXPECT_EQ(torus.boundary_edges, 0u);
  for (double shear : {0.0, 0.5, -7.0, 100.0, 1e5})
    EXPECT_EQ(check(samples::sheared_one_vertex_torus(shear)).vertices, 1u);
  const Counts cone = check(samples::self_glued_triangle());
  EXPECT_EQ(cone.vertices, 2u);
  EXPECT_EQ(cone.edges, 2u);
  EXPECT_EQ(cone.boundary_edges, 1u);
  EXPECT_EQ(cone.Euler_characteristic(), 1);
  const Counts sphere = check(samples::self_glued_sphere());
  EXPECT_EQ(sphere.vertices, 3u);
  EXPECT_EQ(sphere.edges, 3u);
  EXPECT_EQ(sphere.boundary_edges, 0u);
  EXPECT_EQ(sphere.Euler_characteristic(), 2);
}

TEST(Sample_surfaces, random_gluings)
{
  std::size_t self_glued = 0, several_components = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    for (std::size_t faces : {1u, 2u, 3u, 8u, 50u})
      for (bool with_boundary : {false, true})
        for (bool connected : {false, true}) {
          if (!with_boundary && faces % 2 == 1) {
            EXPECT_THROW(samples::random_gluing(faces, seed, with_boundary, connected), std::invalid_argument);
            continue;
          }
          const Glued_triangles gluing = samples::random_gluing(faces, seed, with_boundary, connected);
          EXPECT_EQ(gluing.number_of_faces, faces);
          const Counts counts = check(gluing);
          EXPECT_EQ(counts.boundary_edges > 0, with_boundary);
          if (connected) {
            EXPECT_EQ(counts.components, 1u);
          }
          if (!with_boundary) {
            EXPECT_EQ(counts.Euler_characteristic() % 2, 0);
          }
          several_components += counts.components > 1;
          for (const auto& [first, second] : gluing.glued_sides)
            self_glued += first / 3 == second / 3;
        }
  EXPECT_GT(self_glued, 0u);
  EXPECT_GT(several_components, 0u);
}

TEST(Sample_surfaces, flips_are_as_many_as_stated)
{
  for (bool newest_first : {false, true}) {
    EXPECT_EQ(flip_to_Delaunay(samples::strip(), newest_first, 1000000).flips, 298110u);
    const std::size_t pillow_flips = flip_to_Delaunay(samples::pillow(), newest_first, 1000000).flips;
    EXPECT_GE(pillow_flips, 45000u);
    EXPECT_LE(pillow_flips, 50000u);
    const std::size_t torus_flips = flip_to_Delaunay(samples::bad_torus(200, 200), newest_first, 1000000).flips;
    EXPECT_NEAR(static_cast<double>(torus_flips), 0.37 * 120000, 0.01 * 120000);
    for (double pitch : {30.0, 1e7}) {
      const Flip_result tube = flip_to_Delaunay(samples::helical_tube(60, pitch), newest_first, 1000000);
      EXPECT_EQ(tube.loops, 58u);
      EXPECT_EQ(tube.self_glued_edges, 2u);
    }
    EXPECT_EQ(flip_to_Delaunay(samples::random_diagonal_grid(), newest_first, 1000000).flips, 0u);
  }
}

TEST(Sample_surfaces, names)
{
  const std::vector<samples::Sample> samples = samples::sample_names();
  std::set<std::string> names;
  for (const samples::Sample& sample : samples) {
    SCOPED_TRACE(sample.name);
    EXPECT_FALSE(sample.description.empty());
    EXPECT_TRUE(names.insert(sample.name).second);
    const auto surface = samples::make_sample(sample.name);
    EXPECT_EQ(std::holds_alternative<Glued_triangles>(surface), sample.name == "one-vertex-torus");
  }
  EXPECT_EQ(names.size(), 16u);
  try {
    samples::make_sample("klein-bottle");
    ADD_FAILURE() << "an unknown name was accepted";
  } catch (const std::invalid_argument& error) {
    for (const std::string& name : names)
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
  }
}

TEST(Sample_surfaces, bad_arguments_are_refused)
{
  EXPECT_THROW(samples::torus(2, 3), std::invalid_argument);
  EXPECT_THROW(samples::bad_torus(3, 2), std::invalid_argument);
  EXPECT_THROW(samples::prism(2), std::invalid_argument);
  EXPECT_THROW(samples::cap(-1e-3), std::invalid_argument);
  EXPECT_THROW(samples::sliver_sheet(1), std::invalid_argument);
  EXPECT_THROW(samples::helical_tube(3), std::invalid_argument);
  EXPECT_THROW(samples::helical_tube(60, std::nan("")), std::invalid_argument);
  EXPECT_THROW(samples::pillow(7), std::invalid_argument);
  EXPECT_THROW(samples::strip(10, 10), std::invalid_argument);
  EXPECT_THROW(samples::one_vertex_torus(1, 1, 2), std::invalid_argument);
  EXPECT_THROW(samples::sheared_one_vertex_torus(1e9), std::invalid_argument);
  EXPECT_THROW(samples::self_glued_triangle(1, 2), std::invalid_argument);
  EXPECT_THROW(samples::random_gluing(0, 1, true), std::invalid_argument);
}

} // namespace

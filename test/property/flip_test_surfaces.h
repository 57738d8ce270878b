// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small surfaces for every number type, and their invariants under flips.

#ifndef IDT_TEST_PROPERTY_FLIP_TEST_SURFACES_H
#define IDT_TEST_PROPERTY_FLIP_TEST_SURFACES_H

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <CGAL/Uncertain.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace test_surfaces {

namespace IT = CGAL::Intrinsic_triangulations;

// A surface by points or by lengths. All numbers are floats, so that each number type
// sees the same surface.
struct Surface
{
  std::string name;
  IT::Delta_complex connectivity;
  std::vector<std::array<float, 3>> points; // empty if the lengths define the surface
  std::vector<float> lengths;               // one for each edge
};

inline Surface from_triangles(const std::string& name, const samples::Indexed_triangles& triangles)
{
  Surface surface{name, IT::make_Delta_complex_from_triangles(triangles.points.size(), triangles.triangles), {}, {}};
  for (const std::array<double, 3>& p : triangles.points)
    surface.points.push_back({float(p[0]), float(p[1]), float(p[2])});
  return surface;
}

// Moves each point at random, so that no tie is left.
inline Surface shaken(const std::string& name, samples::Indexed_triangles triangles, double distance)
{
  std::mt19937 random(1);
  for (std::array<double, 3>& p : triangles.points)
    for (double& x : p)
      x += distance * (double(random()) / 0x1p31 - 1);
  return from_triangles(name, triangles);
}

// The length of each edge of the complex that make_Delta_complex_from_gluing() builds.
inline std::vector<double> edge_lengths(const samples::Glued_triangles& gluing, const IT::Delta_complex& complex)
{
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (int i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = gluing.side_lengths[3 * f.idx() + i];
  }
  return lengths;
}

inline Surface from_gluing(const std::string& name, const samples::Glued_triangles& gluing)
{
  Surface surface{name, IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides), {}, {}};
  for (double l : edge_lengths(gluing, surface.connectivity))
    surface.lengths.push_back(float(l));
  return surface;
}

// Surfaces without ties and near ties.
inline std::vector<Surface> generic_surfaces(bool small)
{
  std::vector<Surface> surfaces{
    from_triangles("helical tube", samples::helical_tube(small ? 8 : 60)),
    from_triangles("bumpy sphere", small ? samples::bumpy_sphere(5, 4) : samples::bumpy_sphere(12, 8)),
    from_triangles("bad torus", small ? samples::bad_torus(4, 4) : samples::bad_torus(9, 8)),
    shaken("Schwarz lantern", small ? samples::Schwarz_lantern(4, 5) : samples::Schwarz_lantern(6, 20), 0.01),
    shaken("disk with spike", small ? samples::disk_with_spike(5, 3) : samples::disk_with_spike(9, 8), 0.01),
    from_gluing("one-vertex torus", samples::one_vertex_torus(1, 1.25, 2)),
    from_gluing("sheared torus", samples::sheared_one_vertex_torus(small ? 3.3 : 8.3)),
    from_gluing("self-glued triangle", samples::self_glued_triangle(1, 1.5)),
    from_gluing("self-glued sphere", samples::self_glued_sphere(1, 0.7, 1.3))};
  for (std::uint64_t seed = 1; seed <= (small ? 2 : 10); ++seed) {
    const std::string number = std::to_string(seed);
    surfaces.push_back(from_gluing("closed gluing " + number, samples::random_gluing(small ? 8 : 40, seed)));
    surfaces.push_back(from_gluing("open gluing " + number, samples::random_gluing(small ? 9 : 41, seed, true, true)));
  }
  return surfaces;
}

template <class Traits>
IT::Intrinsic_triangulation<Traits> triangulation(const Surface& surface)
{
  using FT = typename Traits::FT;
  if (surface.points.empty())
    return IT::Intrinsic_triangulation<Traits>::from_lengths(
      surface.connectivity, std::vector<FT>(surface.lengths.begin(), surface.lengths.end()));
  std::vector<std::array<FT, 3>> points;
  for (const std::array<float, 3>& p : surface.points)
    points.push_back({FT(p[0]), FT(p[1]), FT(p[2])});
  return IT::Intrinsic_triangulation<Traits>(surface.connectivity, points);
}

// Invariants of a flip, in double: comparing sums of exact numbers with so many roots would take forever.
struct Invariants
{
  int euler_characteristic = 0;
  int border_halfedges = 0;
  double area = 0;
  std::vector<double> cone_angles; // by vertex
};

template <class Triangulation>
Invariants invariants(const Triangulation& t)
{
  const IT::Delta_complex& c = t.connectivity();
  Invariants result;
  result.euler_characteristic = int(c.number_of_vertices()) - int(c.number_of_edges()) + int(c.number_of_faces());
  result.cone_angles.resize(c.number_of_vertices());
  for (IT::Face_index f : c.faces())
    result.area += CGAL::to_double(t.area(f));
  for (IT::Halfedge_index h : c.halfedges()) {
    if (c.is_border(h))
      ++result.border_halfedges;
    else
      result.cone_angles[c.target(c.next(h)).idx()] += std::atan2(1., CGAL::to_double(t.cotangent(h)));
  }
  return result;
}

// Whether the same halfedges form the same faces. Which halfedge a vertex or a face names
// may differ: flips change it.
inline bool are_same_links(const IT::Delta_complex& a, const IT::Delta_complex& b)
{
  return std::equal(a.halfedges().begin(), a.halfedges().end(), b.halfedges().begin(), b.halfedges().end(),
                    [&](IT::Halfedge_index x, IT::Halfedge_index y) {
                      return a.next(x) == b.next(y) && a.prev(x) == b.prev(y) && a.target(x) == b.target(y) &&
                             a.face(x) == b.face(y);
                    });
}

// The edges by end vertices and length, in an order that does not depend on descriptors.
using Edge_record = std::tuple<std::uint32_t, std::uint32_t, double>;

template <class Triangulation>
std::vector<Edge_record> edge_records(const Triangulation& t)
{
  std::vector<Edge_record> records;
  for (IT::Edge_index e : t.connectivity().edges()) {
    const IT::Halfedge_index h = t.connectivity().halfedge(e);
    const auto ends = std::minmax({t.connectivity().source(h).idx(), t.connectivity().target(h).idx()});
    records.emplace_back(ends.first, ends.second, CGAL::to_double(t.length(e)));
  }
  std::sort(records.begin(), records.end());
  return records;
}

// Whether both are the same edges, with lengths that agree up to a relative tolerance.
inline bool are_same_edges(const std::vector<Edge_record>& a, const std::vector<Edge_record>& b, double tolerance)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const Edge_record& x, const Edge_record& y) {
    return std::get<0>(x) == std::get<0>(y) && std::get<1>(x) == std::get<1>(y) &&
           std::abs(std::get<2>(x) - std::get<2>(y)) <= tolerance * std::get<2>(y);
  });
}

} // namespace test_surfaces

#endif // IDT_TEST_PROPERTY_FLIP_TEST_SURFACES_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fuzz_target.h"
#include "insert_random_vertices.h"
#include "property/flip_test_surfaces.h"
#include "samples/sample_surfaces.h"
#include "saved_files.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <cstdint>
#include <array>
#include <random>
#include <sstream>
#include <utility>

namespace fuzz {

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

Triangulation in_space(const samples::Indexed_triangles& surface)
{
  return Triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles), surface.points);
}
Triangulation by_lengths(const samples::Glued_triangles& surface)
{
  IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(surface.number_of_faces, surface.glued_sides);
  std::vector<double> lengths = test_surfaces::edge_lengths(surface, complex);
  return Triangulation::from_lengths(std::move(complex), std::move(lengths));
}
// A plane square of four triangles around a point, by squares of lengths that are not doubles.
Triangulation by_squared_lengths()
{
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(5, triangles);
  std::vector<IT::Rational> squared;
  for (IT::Edge_index e : complex.edges())
    squared.push_back(complex.is_border(e) ? IT::Rational(2, 3) : IT::Rational(1, 3));
  return Triangulation::from_metric(std::move(complex), IT::metric_from_squared_lengths(std::move(squared)));
}

void flip_at_random(Triangulation& t, std::mt19937& random)
{
  for (int i = 0; i < 20; ++i) {
    const IT::Edge_index e(std::uint32_t(random() % t.connectivity().number_of_edges()));
    if (t.connectivity().is_flippable(e))
      t.flip(e);
  }
}

std::string file(const Triangulation& t, bool has_constraints = false)
{
  std::ostringstream os;
  if (has_constraints)
    IT::write_triangulation(
      os, t, CGAL::parameters::edge_is_constrained_map(CGAL::Static_boolean_property_map<IT::Edge_index, true>()));
  else
    IT::write_triangulation(os, t);
  return os.str();
}

} // namespace

std::vector<std::string> saved_files()
{
  std::vector<std::string> result;
  std::mt19937 random(3);
  const auto add = [&](Triangulation t) {
    result.push_back(file(t));
    flip_at_random(t, random);
    result.push_back(file(t, result.size() % 4 == 1));
    IT::insert_random_vertices(t, 3, 4, random);
    flip_at_random(t, random);
    result.push_back(file(t));
  };
  add(in_space(samples::torus(4, 3)));
  add(in_space(samples::bumpy_dome(3, 2)));
  add(in_space(samples::prism(5)));
  add(in_space(samples::sheared_grid(3, 2)));
  add(in_space(samples::cap()));
  add(by_lengths(samples::one_vertex_torus()));
  add(by_lengths(samples::self_glued_sphere()));
  add(by_lengths(samples::random_gluing(6, 1)));
  add(by_lengths(samples::random_gluing(6, 2, true)));
  add(by_squared_lengths());
  return result;
}

std::vector<std::string> seed_inputs()
{
  std::vector<std::string> result;
  for (std::size_t i = 0; i < saved_files().size(); ++i) {
    result.push_back({char(i)});
    std::string changes(15, '\0');
    for (std::size_t j = 0; j < changes.size(); ++j)
      changes[j] = char(37 * i + 11 * j);
    result.push_back(char(i) + changes);
  }
  result.push_back(char(255) + saved_files()[0]);
  return result;
}

} // namespace fuzz

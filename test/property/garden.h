// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A garden of small, bad surfaces, and the public algorithms that are tried on them.

#ifndef IDT_TEST_PROPERTY_GARDEN_H
#define IDT_TEST_PROPERTY_GARDEN_H

#include "samples/sample_surface_types.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace garden {

namespace IT = CGAL::Intrinsic_triangulations;
using Surface = std::variant<samples::Indexed_triangles, samples::Glued_triangles>;
using Triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

// Runs one algorithm on a surface and checks its result; throws if there is none.
struct Algorithm
{
  std::string name;
  void (*run)(const Surface&);
};

// Thrown if an algorithm does not take surfaces of that kind, such as those without points.
struct Not_applicable
{};

std::vector<Algorithm> cover_algorithms();
std::vector<Algorithm> metric_algorithms();
std::vector<Algorithm> operator_algorithms();

inline const samples::Indexed_triangles& in_space(const Surface& surface)
{
  if (const auto* triangles = std::get_if<samples::Indexed_triangles>(&surface))
    return *triangles;
  throw Not_applicable();
}

inline IT::Delta_complex connectivity(const Surface& surface)
{
  if (const auto* s = std::get_if<samples::Indexed_triangles>(&surface))
    return IT::make_Delta_complex_from_triangles(s->points.size(), s->triangles);
  const auto& s = std::get<samples::Glued_triangles>(surface);
  return IT::make_Delta_complex_from_gluing(s.number_of_faces, s.glued_sides);
}

inline std::vector<double> edge_lengths(const samples::Glued_triangles& surface, const IT::Delta_complex& complex)
{
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = surface.side_lengths[3 * f.idx() + i];
  }
  return lengths;
}

template <class Traits>
IT::Intrinsic_triangulation<Traits> triangulation(const Surface& surface)
{
  using Result = IT::Intrinsic_triangulation<Traits>;
  IT::Delta_complex complex = connectivity(surface);
  if (const auto* s = std::get_if<samples::Indexed_triangles>(&surface))
    return Result(std::move(complex), s->points);
  std::vector<double> lengths = edge_lengths(std::get<samples::Glued_triangles>(surface), complex);
  return Result::from_lengths(std::move(complex), std::move(lengths));
}

// The intrinsic Delaunay triangulation, by exact decisions.
inline Triangulation Delaunay_triangulation(const Surface& surface)
{
  Triangulation result = triangulation<IT::Filtered_edge_length_traits>(surface);
  EXPECT_EQ(IT::flip_to_Delaunay(result).status, IT::Flip_status::DELAUNAY);
  return result;
}

inline double sum(const std::vector<double>& numbers)
{
  double result = 0;
  for (double x : numbers)
    result += x;
  return result;
}

// Also fails for NaN.
inline void expect_near(double value, double expected, double tolerance, const char* what)
{
  EXPECT_LE(std::abs(value - expected), tolerance) << what << ": " << value << " for " << expected;
}

} // namespace garden

#endif // IDT_TEST_PROPERTY_GARDEN_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The quantities of doc/termination.md, flip by flip: the exact algorithm says which edges
// it flips, and the test follows with 256 bits, by the flip formulas alone.

#include "samples/sample_surfaces.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/hinge_formulas.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Number = IT::Mpfr_float;
using Exact = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;
using Multiprecision_traits = IT::Edge_length_traits<Number>;
using Multiprecision = IT::Intrinsic_triangulation<Multiprecision_traits>;

struct Recorder
{
  std::vector<IT::Edge_index> edges;
  bool go_further(const IT::Progress&) { return true; }
  void after_flip(IT::Edge_index e) { edges.push_back(e); }
};

struct Counts
{
  std::size_t between_positive = 0; // flips by the areas of the two faces before
  std::size_t with_one_degenerate = 0;
  std::size_t between_degenerate = 0;
};

// Squared lengths and areas that follow flips.
class Follower
{
public:
  explicit Follower(const Multiprecision& start) : complex_(start.connectivity())
  {
    for (IT::Edge_index e : complex_.edges())
      s_.push_back(start.edge_data(e));
    for (IT::Face_index f : complex_.faces())
      a_.push_back(start.face_data(f));
    longest_ = s_.front();
    for (const Number& s : s_)
      if (s > longest_)
        longest_ = s;
  }

  // Four times the sum of area times sum of squared lengths.
  Number potential() const
  {
    Number sum = 0;
    for (IT::Face_index f : complex_.faces())
      sum += potential(f);
    return sum;
  }

  void flip(IT::Edge_index e, Counts& counts)
  {
    const Number rounding = Number(1) / Number(std::uint64_t(1) << 62) / Number(std::uint64_t(1) << 62);
    const IT::Halfedge_index h = complex_.halfedge(e), g = complex_.opposite(h);
    const IT::Face_index f_k = complex_.face(h), f_l = complex_.face(g);
    const Number s_ij = s_[e.idx()], s_jk = s(complex_.next(h)), s_ki = s(complex_.prev(h)), s_il = s(complex_.next(g)),
                 s_lj = s(complex_.prev(g));
    const Number a_k = a_[f_k.idx()], a_l = a_[f_l.idx()];
    const Number value = IT::Delaunay_value(IT::twice_scalar_product(s_jk, s_ki, s_ij), a_k,
                                            IT::twice_scalar_product(s_il, s_lj, s_ij), a_l);
    const Number before = potential(f_k) + potential(f_l);
    Number s_kl, a_ilk, a_jkl;
    IT::flip_hinge(s_ij, s_jk, s_ki, s_il, s_lj, a_k, a_l, s_kl, a_ilk, a_jkl);
    complex_.flip(e);
    s_[e.idx()] = s_kl;
    a_[f_k.idx()] = a_ilk;
    a_[f_l.idx()] = a_jkl;
    const Number after = potential(f_k) + potential(f_l);

    EXPECT_GT(s_kl, 0);
    // No edge is ever longer than 2/√3 times the longest edge of the input.
    EXPECT_LE(3 * s_kl, 4 * longest_ * (1 + rounding));
    if (a_k == 0 && a_l == 0) {
      ++counts.between_degenerate;
      EXPECT_TRUE(a_ilk == 0 && a_jkl == 0);
      EXPECT_LT(s_kl, s_ij);
      return;
    }
    ++(a_k > 0 && a_l > 0 ? counts.between_positive : counts.with_one_degenerate);
    EXPECT_TRUE(a_ilk > 0 && a_jkl > 0);
    EXPECT_LT(value, 0);
    EXPECT_LT(after, before);
    // With four times the areas, the potential falls by twice the value of the Delaunay test.
    EXPECT_LE(abs(after - before - 2 * value), rounding * before);
  }

private:
  const Number& s(IT::Halfedge_index h) const { return s_[complex_.edge(h).idx()]; }
  Number potential(IT::Face_index f) const
  {
    const IT::Halfedge_index h = complex_.halfedge(f);
    return a_[f.idx()] * (s(h) + s(complex_.next(h)) + s(complex_.prev(h)));
  }

  IT::Delta_complex complex_;
  std::vector<Number> s_, a_;
  Number longest_;
};

Counts follow(Exact exact, const Multiprecision& start)
{
  Recorder recorder;
  const IT::Flip_report report = IT::flip_to_Delaunay(exact, CGAL::parameters::visitor(std::ref(recorder)));
  EXPECT_EQ(report.status, IT::Flip_status::DELAUNAY);
  Follower follower(start);
  const Number before = follower.potential();
  Counts counts;
  for (IT::Edge_index e : recorder.edges)
    follower.flip(e, counts);
  if (counts.between_positive + counts.with_one_degenerate > 0) {
    EXPECT_LT(follower.potential(), before);
  }
  return counts;
}

Counts follow(const samples::Indexed_triangles& surface)
{
  const IT::Mpfr_precision precision(256);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles);
  std::vector<Multiprecision_traits::Point_data> points;
  for (const std::array<double, 3>& p : surface.points)
    points.push_back({Number(p[0]), Number(p[1]), Number(p[2])});
  return follow(Exact(complex, surface.points), Multiprecision(complex, points));
}

Counts follow(const samples::Glued_triangles& surface)
{
  const IT::Mpfr_precision precision(256);
  const IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(surface.number_of_faces, surface.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index h = complex.halfedge(f);
    for (std::size_t i = 0; i < 3; ++i, h = complex.next(h))
      lengths[complex.edge(h).idx()] = surface.side_lengths[3 * f.idx() + i];
  }
  const std::vector<Number> numbers(lengths.begin(), lengths.end());
  return follow(Exact::from_lengths(complex, lengths), Multiprecision::from_lengths(complex, numbers));
}

// A fan over points of the first axis, in this order.
samples::Indexed_triangles collinear_fan(const std::vector<double>& positions)
{
  samples::Indexed_triangles fan;
  for (double x : positions)
    fan.points.push_back({x, 0, 0});
  for (std::uint32_t k = 1; k + 1 < positions.size(); ++k)
    fan.triangles.push_back({0, k, k + 1});
  return fan;
}

TEST(Termination, PotentialFallsOnSurfacesInSpace)
{
  for (const samples::Indexed_triangles& surface :
       {samples::bumpy_sphere(30, 15), samples::bad_torus(20, 10), samples::sheared_grid(8, 8), samples::pillow(30),
        samples::strip(60, 8), samples::prism(16, 1), samples::cap(1e-10), samples::cap(1e-17, 1),
        samples::sliver_sheet(10), samples::disk_with_spike(12, 6), samples::latitude_longitude_sphere(16, 9)}) {
    const Counts counts = follow(surface);
    EXPECT_GT(counts.between_positive, 0u);
    EXPECT_EQ(counts.between_degenerate, 0u);
  }
}

TEST(Termination, PotentialFallsOnGluings)
{
  EXPECT_GT(follow(samples::sheared_one_vertex_torus(50)).between_positive, 40u);
  std::size_t flips = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed)
    flips += follow(samples::random_gluing(8, seed)).between_positive +
             follow(samples::random_gluing(7, seed, true)).between_positive;
  EXPECT_GT(flips, 20u);
}

TEST(Termination, PotentialFallsWhereOneFaceHasNoArea)
{
  const Counts counts = follow(samples::cap(0));
  EXPECT_EQ(counts.with_one_degenerate, 19u); // each flip takes one of the 19 such faces away
  EXPECT_EQ(counts.between_degenerate, 0u);
}

TEST(Termination, EdgesBetweenFacesWithoutAreaGetShorter)
{
  EXPECT_EQ(follow(collinear_fan({0, 3, 10, 6})).between_degenerate, 1u); // from length 10 to 3
  EXPECT_GT(follow(collinear_fan({0, 3, 10, 6, 12, 5, 14, 1, 13, 2, 9, 4, 11, 8})).between_degenerate, 3u);
}

// Faces without area only: the flips are subtractions, and run Euclid's algorithm on the
// lengths. With rational ones it ends, in an edge of length zero.
TEST(Termination, ATorusWithoutAreaIsRefused)
{
  const std::vector<std::array<std::size_t, 2>> glued_sides = {{0, 3}, {1, 4}, {2, 5}};
  Exact torus = Exact::from_lengths(IT::make_Delta_complex_from_gluing(2, glued_sides), {21, 34, 55});
  try {
    IT::flip_to_Delaunay(torus);
    FAIL() << "no exception";
  } catch (const IT::Invalid_surface_error& error) {
    EXPECT_EQ(error.defect(), IT::Invalid_surface_error::Defect::ZERO_LENGTH_EDGE);
  }
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of benchmark/systems calls a right result right, with any diagonals of ties, and a wrong one wrong.

#include "judge.h"
#include "surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace systems;

Own_triangulation Delaunay_triangulation(const Surface& surface)
{
  Own_triangulation result = make_own_triangulation(surface);
  IT::flip_to_Delaunay(result);
  return result;
}

Result result_of(const Own_triangulation& t)
{
  Result result;
  result.triangles = triangles_of(t.connectivity());
  for (IT::Halfedge_index h : halfedges_of_sides(t.connectivity())) {
    const IT::Edge_index e = t.connectivity().edge(h);
    result.triangles.lengths.push_back(t.length(e));
    result.crossings.push_back(t.number_of_crossings(e));
  }
  const Eigen::SparseMatrix<double> matrix = IT::stiffness_matrix(t);
  for (int k = 0; k < matrix.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, k); it; ++it)
      result.Laplacian.push_back({std::uint32_t(it.row()), std::uint32_t(it.col()), it.value()});
  return result;
}

// Other diagonals wherever the cotangents cancel up to `tolerance`. \return how many
std::size_t flip_ties(Own_triangulation& t, double tolerance)
{
  std::mt19937 random(1);
  std::size_t flips = 0;
  for (std::size_t i = 0; i < 3 * t.connectivity().number_of_edges(); ++i) {
    const IT::Edge_index e(random() % t.connectivity().number_of_edges());
    if (t.connectivity().is_flippable(e) && std::abs(t.cotangent_weight(e)) <= tolerance)
      flips += t.flip(e) == Own_triangulation::Flip_outcome::FLIPPED;
  }
  return flips;
}

const std::vector<std::string> tasks = {"triangulation", "overlay", "Laplacian"};

// Loops, multiple edges, faces that are glued to themselves, few vertices, ties, zero areas.
TEST(SystemJudge, CallsTheExactResultRight)
{
  std::vector<Surface> surfaces = {surface_of(samples::bumpy_sphere(12, 8)),
                                   surface_of(samples::helical_tube(20)),
                                   surface_of(samples::prism(12)),
                                   surface_of(samples::cap(0)),
                                   surface_of(samples::one_vertex_torus()),
                                   surface_of(samples::sheared_one_vertex_torus(20)),
                                   surface_of(samples::sheared_one_vertex_torus(10)),
                                   surface_of(samples::self_glued_sphere()),
                                   surface_of(samples::pillow(12)),
                                   surface_of(samples::random_diagonal_grid(5, 5, 1, 1))};
  for (std::uint64_t seed = 1; seed < 10; ++seed)
    surfaces.push_back(surface_of(samples::random_gluing(20, seed, seed % 2 == 0, seed % 3 == 0)));
  for (const Surface& surface : surfaces) {
    const Result result = result_of(Delaunay_triangulation(surface));
    for (const std::string& task : tasks) {
      const Judgement judgement = judge(task, surface, result);
      EXPECT_EQ(judgement.verdict, Verdict::RIGHT) << task << " " << judgement.why;
    }
  }
}

// Vertices and faces in another order, and each face begins at another corner.
TEST(SystemJudge, DoesNotDependOnTheOrderOfFaces)
{
  for (const Surface& surface : {surface_of(samples::prism(12)), surface_of(samples::random_gluing(20, 3, false, true)),
                                 surface_of(samples::helical_tube(20))}) {
    const Result result = result_of(Delaunay_triangulation(surface));
    const std::size_t n = result.triangles.number_of_sides();
    const auto moved = [n](std::size_t side) { return n - 3 - side / 3 * 3 + (side + 1) % 3; };
    Result other = result;
    for (std::size_t side = 0; side < n; ++side) {
      const std::size_t to = moved(side);
      other.triangles.corners[to / 3][to % 3] = result.triangles.source(side);
      const std::int64_t opposite = result.triangles.opposite[side];
      other.triangles.opposite[to] = opposite < 0 ? -1 : std::int64_t(moved(std::size_t(opposite)));
      other.triangles.lengths[to] = result.triangles.lengths[side];
      other.crossings[to] = result.crossings[side];
    }
    const Judgement judgement = judge("overlay", surface, other);
    EXPECT_EQ(judgement.verdict, Verdict::RIGHT) << judgement.why;
  }
}

TEST(SystemJudge, LeavesTheChoiceOfDiagonalsInTiesFree)
{
  for (const Surface& surface : {surface_of(samples::prism(40)), surface_of(samples::random_diagonal_grid(8, 8)),
                                 surface_of(internal::box(4, 1)), surface_of(samples::pillow(20)),
                                 surface_of(samples::one_vertex_torus(3, 4, 5))}) {
    Own_triangulation t = Delaunay_triangulation(surface);
    ASSERT_GT(flip_ties(t, 0), 0u);
    for (const std::string& task : tasks) {
      const Judgement judgement = judge(task, surface, result_of(t));
      EXPECT_EQ(judgement.verdict, Verdict::RIGHT) << task << " " << judgement.why;
    }
  }
}

TEST(SystemJudge, CallsBrokenTiesClose)
{
  const Surface surface = surface_of(samples::random_diagonal_grid(8, 8, 1, 1));
  Own_triangulation t = Delaunay_triangulation(surface);
  ASSERT_GT(flip_ties(t, 1e-12), 20u);
  const Judgement judgement = judge("triangulation", surface, result_of(t));
  EXPECT_EQ(judgement.verdict, Verdict::CLOSE) << judgement.why;
  EXPECT_GT(judgement.wrong_edges, 0u);
  EXPECT_LT(judgement.largest_error, 1e-14);
}

TEST(SystemJudge, CallsAMissingFlipWrong)
{
  const Surface surface = surface_of(samples::bumpy_sphere(12, 8));
  EXPECT_EQ(judge("triangulation", surface, result_of(make_own_triangulation(surface))).verdict, Verdict::WRONG);

  const Own_triangulation exact = Delaunay_triangulation(surface);
  std::size_t tried = 0;
  for (IT::Edge_index e : exact.connectivity().edges()) {
    Own_triangulation t = exact;
    if (!t.connectivity().is_flippable(e) || t.cotangent_weight(e) < 0.1 ||
        t.flip(e) != Own_triangulation::Flip_outcome::FLIPPED)
      continue;
    ++tried;
    const Judgement judgement = judge("triangulation", surface, result_of(t));
    EXPECT_EQ(judgement.verdict, Verdict::WRONG);
    EXPECT_EQ(judgement.wrong_faces, 2u);
    EXPECT_EQ(judge("Laplacian", surface, result_of(t)).verdict, Verdict::WRONG);
    if (tried == 5)
      break;
  }
  EXPECT_EQ(tried, 5u);
}

TEST(SystemJudge, CallsALengthThatIsALieWrong)
{
  for (const Surface& surface : {surface_of(samples::prism(12)), surface_of(samples::random_gluing(20, 3, false, true)),
                                 surface_of(samples::helical_tube(20))}) {
    const Result right = result_of(Delaunay_triangulation(surface));
    for (std::size_t side = 0; side < right.triangles.number_of_sides(); side += 7) {
      const auto with_length = [&](double length) {
        Result result = right;
        result.triangles.lengths[side] = length;
        return judge("triangulation", surface, result).verdict;
      };
      const double length = right.triangles.lengths[side];
      EXPECT_EQ(with_length(length * (1 + 1e-9)), Verdict::RIGHT);
      EXPECT_EQ(with_length(length * (1 + 1e-4)), Verdict::CLOSE);
      EXPECT_EQ(with_length(length * 1.01), Verdict::WRONG);
      EXPECT_EQ(with_length(0), Verdict::WRONG);
      EXPECT_EQ(with_length(std::numeric_limits<double>::quiet_NaN()), Verdict::WRONG);
      EXPECT_EQ(with_length(std::numeric_limits<double>::infinity()), Verdict::WRONG);
    }
  }
}

TEST(SystemJudge, CallsWhatIsNoTriangulationWrong)
{
  const Surface surface = surface_of(samples::bumpy_sphere(12, 8));
  const Result right = result_of(Delaunay_triangulation(surface));
  Result cut = right;
  cut.triangles.opposite[std::size_t(cut.triangles.opposite[5])] = -1;
  cut.triangles.opposite[5] = -1;
  EXPECT_EQ(judge("triangulation", surface, cut).verdict, Verdict::WRONG);
  Result one_sided = right;
  one_sided.triangles.opposite[5] = -1;
  EXPECT_EQ(judge("triangulation", surface, one_sided).verdict, Verdict::WRONG);
  Result other_corner = right;
  other_corner.triangles.corners[0][0] = std::uint32_t(surface.number_of_vertices);
  EXPECT_EQ(judge("triangulation", surface, other_corner).verdict, Verdict::WRONG);
  Result fewer = right;
  fewer.triangles.corners.pop_back();
  EXPECT_EQ(judge("triangulation", surface, fewer).verdict, Verdict::WRONG);
  EXPECT_EQ(judge("triangulation", surface, Result()).verdict, Verdict::WRONG);
  EXPECT_EQ(judge("Laplacian", surface, Result()).verdict, Verdict::WRONG);
}

TEST(SystemJudge, CallsAnotherNumberOfCrossingsWrong)
{
  const Surface surface = surface_of(samples::helical_tube(20));
  Result result = result_of(Delaunay_triangulation(surface));
  ++result.crossings[7];
  EXPECT_EQ(judge("overlay", surface, result).verdict, Verdict::WRONG);
  EXPECT_EQ(judge("triangulation", surface, result).verdict, Verdict::RIGHT);
}

TEST(SystemJudge, ComparesEachEntryOfTheLaplacian)
{
  const Surface surface = surface_of(samples::bumpy_sphere(12, 8));
  const Result right = result_of(Delaunay_triangulation(surface));
  for (std::size_t i = 0; i < right.Laplacian.size(); i += 11) {
    const auto with_change = [&](double relative) {
      Result result = right;
      // Entries in the same place add up.
      const Matrix_entry& entry = right.Laplacian[i];
      double diagonal = 0;
      for (const Matrix_entry& other : right.Laplacian)
        if (other.row == other.column && (other.row == entry.row || other.row == entry.column))
          diagonal = (std::max)(diagonal, other.value);
      result.Laplacian.push_back({entry.row, entry.column, relative * diagonal});
      return judge("Laplacian", surface, result).verdict;
    };
    EXPECT_EQ(with_change(1e-9), Verdict::RIGHT);
    EXPECT_EQ(with_change(1e-4), Verdict::CLOSE);
    EXPECT_EQ(with_change(1e-2), Verdict::WRONG);
    EXPECT_EQ(with_change(std::numeric_limits<double>::quiet_NaN()), Verdict::WRONG);
  }
}

// There are as many surfaces as the manual says, and each can be made.
TEST(SystemSurfaces, AreMany)
{
  std::vector<std::string> names;
  for (const Named_surface& named : generated_surfaces()) {
    names.push_back(named.name);
    EXPECT_EQ(triangles_of(make_own_triangulation(named.surface).connectivity()).corners,
              named.surface.triangles.corners);
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
  EXPECT_GE(names.size(), 60u);
}

} // namespace

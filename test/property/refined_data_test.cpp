// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Refinement of real meshes: only listed faces have angles below the bound, and the lengths alone confirm their
// reasons.

#include "evaluation_data.h"
#include "refined_surface.h"
#include "input/Surface.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>

#include <CGAL/number_type_config.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = Refined_triangulation;

constexpr double bound = 25;

double degrees(double radians) { return radians * (180 / CGAL_PI); }

std::vector<std::string> mesh_paths()
{
  std::vector<std::string> result;
  const std::filesystem::path folder = evaluation_data();
  if (folder.empty())
    return {""};
  for (const char* name : {"good", "table1"})
    for (const auto& entry : std::filesystem::directory_iterator(folder / name)) {
      const std::string stem = entry.path().stem().string();
      // The one takes two minutes, since most of its edges are ties; the other needs more than a million vertices.
      if (entry.path().extension() == ".off" && stem != "manifoldlib_Generic_Twin_7081_1_t0_right" &&
          stem != "synth_grid_stretch_1e6")
        result.push_back(entry.path().string());
    }
  std::sort(result.begin(), result.end());
  return result;
}

// Reads the lengths of the result alone.
class Obstacle_reader
{
public:
  Obstacle_reader(const Triangulation& t, std::size_t number_of_input_vertices)
    : t_(t), complex_(t.connectivity()), number_of_input_vertices_(number_of_input_vertices)
  {}

  double angle_at_source(IT::Halfedge_index h) const { return IT::angle(t_, complex_.next(h)); }

  // Whether the border turns at a corner of the input by less than 60 degrees, and the small angle at the source of h,
  // a halfedge of a face, is there, or opposite to an edge between two points of the border at the same distance from
  // there.
  bool is_small_input_angle(IT::Halfedge_index h) const
  {
    if (complex_.is_border(complex_.edge(h)) && complex_.is_border(complex_.edge(complex_.prev(h))))
      return true;
    const IT::Halfedge_index opposite = complex_.next(h);
    for (const auto& [v, d] : corners_beside(complex_.source(opposite)))
      for (const auto& [w, e] : corners_beside(complex_.target(opposite)))
        if (v == w && std::abs(d - e) <= 1e-9 * d && IT::cone_angle(t_, v) < CGAL_PI / 3)
          return true;
    return false;
  }

  bool is_at_cone(IT::Halfedge_index h) const
  {
    return is_input_vertex(complex_.source(h)) && degrees(IT::cone_angle(t_, complex_.source(h))) < 60;
  }

  double circumradius(IT::Halfedge_index h) const
  {
    return t_.length(complex_.edge(complex_.next(h))) / (2 * std::sin(angle_at_source(h)));
  }

private:
  bool is_input_vertex(IT::Vertex_index v) const { return v.idx() < number_of_input_vertices_; }

  // The input vertices next to v along the border to both sides, with their distances along it, without v itself.
  std::vector<std::pair<IT::Vertex_index, double>> corners_beside(IT::Vertex_index v) const
  {
    std::vector<std::pair<IT::Vertex_index, double>> result;
    const IT::Halfedge_index in = complex_.halfedge(v);
    if (!complex_.is_border(in) || is_input_vertex(v))
      return result;
    double distance = 0;
    IT::Halfedge_index h = in;
    for (;; h = complex_.prev(h)) {
      distance += t_.length(complex_.edge(h));
      if (is_input_vertex(complex_.source(h)))
        break;
    }
    result.emplace_back(complex_.source(h), distance);
    distance = 0;
    for (h = complex_.next(in);; h = complex_.next(h)) {
      distance += t_.length(complex_.edge(h));
      if (is_input_vertex(complex_.target(h)))
        break;
    }
    result.emplace_back(complex_.target(h), distance);
    return result;
  }

  const Triangulation& t_;
  const IT::Delta_complex& complex_;
  std::size_t number_of_input_vertices_;
};

class Refined_data : public testing::TestWithParam<std::string>
{};

TEST_P(Refined_data, has_no_small_angle_without_a_reason)
{
  if (GetParam().empty())
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  const idt::Surface surface = idt::load_surface(GetParam());
  Triangulation t(surface.connectivity, surface.points);
  const double area = total_area(t);
  double size = 0;
  for (IT::Edge_index e : t.connectivity().edges())
    size = std::max(size, double(t.length(e)));
  const IT::Delta_complex& complex = t.connectivity();
  const std::size_t number_of_input_vertices = complex.number_of_vertices();
  const IT::Refinement_report report = IT::refine_Delaunay(t, CGAL::parameters::minimum_angle(bound).minimum_size(0.));

  EXPECT_EQ(report.status, IT::Refinement_status::REFINED);
  EXPECT_EQ(complex.number_of_vertices(), number_of_input_vertices + report.insertions + report.segment_splits);
  ASSERT_TRUE(complex.is_valid());
  for (IT::Edge_index e : complex.edges()) {
    if (complex.is_flippable(e)) {
      ASSERT_NE(IT::internal::engine(t).test(e, IT::internal::Exact_engine::Means::UNFOLDING)->sign, CGAL::NEGATIVE)
        << e.idx();
    }
  }
  EXPECT_NEAR(total_area(t) / area, 1, 1e-14);
  for (std::size_t v = number_of_input_vertices; v < complex.number_of_vertices(); ++v) {
    ASSERT_NEAR(IT::angle_defect(t, IT::Vertex_index(v)), 0, 1e-12) << v;
  }
  const std::size_t step = 1 + (complex.number_of_vertices() - number_of_input_vertices) / 50;
  for (std::size_t v = number_of_input_vertices; v < complex.number_of_vertices(); v += step) {
    ASSERT_TRUE(is_exactly_flat(t, IT::Vertex_index(v))) << v;
  }

  const Obstacle_reader read(t, number_of_input_vertices);
  std::vector<std::optional<IT::Refinement_obstacle>> reasons(complex.number_of_faces());
  for (const IT::Unrefined_face& f : report.unrefined)
    reasons[f.face.idx()] = f.reason;
  for (IT::Face_index f : complex.faces()) {
    IT::Halfedge_index sharpest = complex.halfedge(f);
    for (IT::Halfedge_index h : {complex.next(sharpest), complex.prev(sharpest)})
      if (read.angle_at_source(h) < read.angle_at_source(sharpest))
        sharpest = h;
    const double angle = degrees(read.angle_at_source(sharpest));
    if (!reasons[f.idx()]) {
      ASSERT_GE(angle, bound * (1 - 1e-12)) << f.idx();
      continue;
    }
    EXPECT_LT(angle, bound * (1 + 1e-12)) << "a face is listed that meets the bound: " << f.idx();
    switch (*reasons[f.idx()]) {
    case IT::Refinement_obstacle::SMALL_INPUT_ANGLE:
    case IT::Refinement_obstacle::BESIDE_SMALL_INPUT_ANGLE:
      EXPECT_TRUE(read.is_small_input_angle(sharpest)) << f.idx() << ": " << angle << " degrees";
      break;
    case IT::Refinement_obstacle::CONE:
      EXPECT_TRUE(read.is_at_cone(sharpest)) << f.idx() << ": " << angle << " degrees";
      break;
    case IT::Refinement_obstacle::UNREPRESENTABLE:
      EXPECT_LT(read.circumradius(sharpest), std::ldexp(size, -46)) << f.idx() << ": " << angle << " degrees";
      break;
    case IT::Refinement_obstacle::TOO_SMALL:
    case IT::Refinement_obstacle::BUDGET:
    case IT::Refinement_obstacle::WHOLE_EDGE:
      ADD_FAILURE() << "the budget suffices, and no edge has to stay whole";
    }
  }
}

std::string name_of_mesh(const testing::TestParamInfo<std::string>& info)
{
  std::string name = info.param.empty() ? "none" : std::filesystem::path(info.param).stem().string();
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0)
      c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Meshes, Refined_data, testing::ValuesIn(mesh_paths()), name_of_mesh);

} // namespace

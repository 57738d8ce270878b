// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt laplacian`

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <sstream>
#include <utility>

namespace {

using nlohmann::json;

class Laplacian_command : public Command_test
{
protected:
  // Three triangles at an edge.
  void write_fan(const std::string& name) const
  {
    write(name, "OFF\n6 3 0\n0 0 0\n0 0 1\n1 0 0.5\n-1 2 0.5\n-1 -2 0.5\n7 7 7\n3 0 1 2\n3 0 1 3\n3 1 0 4\n");
  }
  // The entries of a Matrix Market file, both triangles.
  std::map<std::pair<int, int>, double> matrix(const std::string& name, int size) const
  {
    const std::vector<std::string> text = lines(content(folder_ / name));
    EXPECT_EQ(text.at(0), "%%MatrixMarket matrix coordinate real symmetric");
    std::istringstream head(text.at(2));
    std::size_t rows, columns, entries;
    head >> rows >> columns >> entries;
    EXPECT_EQ(rows, std::size_t(size));
    EXPECT_EQ(columns, std::size_t(size));
    EXPECT_EQ(text.size(), entries + 3);
    std::map<std::pair<int, int>, double> result;
    for (std::size_t i = 3; i < text.size(); ++i) {
      std::istringstream line(text[i]);
      int row, column;
      double value;
      line >> row >> column >> value;
      result[{row, column}] = result[{column, row}] = value;
    }
    return result;
  }
};

TEST_F(Laplacian_command, writes_the_operator_of_three_triangles_at_an_edge)
{
  write_fan("fan.off");
  const Command_run run = idt("laplacian fan.off --stiffness L.mtx --mass M.mtx --stats s.json --eigenvalues 3");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "1 edge, 0 vertices; 6 border edges")) << run.out;
  auto L = matrix("L.mtx", 6);
  for (int row = 1; row <= 6; ++row) {
    double sum = 0;
    for (int column = 1; column <= 6; ++column) {
      sum += L[{row, column}];
      if (row != column) {
        EXPECT_LE((L[{row, column}]), 0);
      }
    }
    EXPECT_NEAR(sum, 0, 1e-15);
  }
  auto M = matrix("M.mtx", 6);
  double area = 0;
  for (int row = 1; row <= 6; ++row)
    area += M[{row, row}];
  EXPECT_NEAR(area, 0.5 + std::sqrt(5.), 1e-14);
  EXPECT_EQ((M[{6, 6}]), 0);

  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["vertices"], 6);
  EXPECT_EQ(stats["faces"], 3);
  EXPECT_EQ(stats["nonmanifold_edges"], 1);
  EXPECT_EQ(stats["nonmanifold_vertices"], 0);
  EXPECT_EQ(stats["border_edges"], 6);
  EXPECT_EQ(stats["orientable"], true);
  EXPECT_EQ(stats["dropped_faces"], 0);
  EXPECT_EQ(stats["merged_vertices"], 0);
  EXPECT_EQ(stats["unreferenced_vertices"], 1);
  EXPECT_TRUE(stats["mollification"].is_null());
  EXPECT_GE(stats["minimum_weight"].get<double>(), 0);
  EXPECT_EQ(stats["eigenvalues"].size(), 3u);
  EXPECT_EQ(stats["status"], "done");
  EXPECT_TRUE(stats.contains("flips"));
}

TEST_F(Laplacian_command, Galerkin_mass_has_the_same_sum)
{
  write_fan("fan.off");
  ASSERT_EQ(idt("laplacian fan.off --mass M.mtx --mass-type galerkin").status, 0);
  double area = 0;
  for (const auto& entry : matrix("M.mtx", 6))
    area += entry.second;
  EXPECT_NEAR(area, 0.5 + std::sqrt(5.), 1e-14);
}

TEST_F(Laplacian_command, without_a_cover_the_input_has_to_be_a_surface)
{
  write_fan("fan.off");
  const Command_run run = idt("laplacian fan.off --cover none --stiffness L.mtx");
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "idt: fan.off: edge 0-1 of face 0 has more than two faces; the tufted cover "
                     "(Surface_cover::TUFTED, --cover tufted) takes it\n");
  EXPECT_FALSE(fs::exists(folder_ / "L.mtx"));
  // An obtuse corner opposite to the border: only a cover can be flipped there.
  write("cap.off", "OFF\n3 1 0\n0 0 0\n10 0 0\n2 1 0\n3 0 1 2\n");
  EXPECT_EQ(idt("laplacian cap.off --cover none --stiffness none.mtx").status, 0);
  EXPECT_EQ(idt("laplacian cap.off --stiffness tufted.mtx").status, 0);
  EXPECT_NEAR((matrix("none.mtx", 3)[{1, 2}]), 0.75, 1e-15); // the cotangent is (2 · -8 + 1)/10
  EXPECT_EQ((matrix("tufted.mtx", 3)[{1, 2}]), 0);
}

TEST_F(Laplacian_command, coincident_vertices_have_a_policy)
{
  write("slit.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 0 0\n0 1 0\n3 0 1 3\n3 1 2 3\n");
  Command_run run = idt("laplacian slit.off --coincident-vertices error");
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err, "idt: slit.off: vertices 1 and 2 of face 1 are at the same place; merge them, or drop the face\n");
  run = idt("laplacian slit.off --stats s.json");
  EXPECT_EQ(run.status, 0);
  json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["merged_vertices"], 1);
  EXPECT_EQ(stats["dropped_faces"], 1);
  ASSERT_EQ(idt("laplacian slit.off --coincident-vertices drop --stats s.json").status, 0);
  stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["merged_vertices"], 0);
  EXPECT_EQ(stats["dropped_faces"], 1);
  EXPECT_EQ(stats["unreferenced_vertices"], 1);
}

TEST_F(Laplacian_command, reads_soups_polygons_and_gluings)
{
  write("soup.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 4 5\n");
  ASSERT_EQ(idt("laplacian soup.off --weld --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["border_edges"], 4);
  ASSERT_EQ(idt("laplacian soup.off --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["border_edges"], 6);

  ASSERT_EQ(idt("triangulate soup.off --repair --save saved.idt").status, 0);
  ASSERT_EQ(idt("laplacian saved.idt --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["border_edges"], 4);

  write("polygon.obj", "v 0 0 0\nv 1 0 0\nv 1.5 1 0\nv 0.5 2 0\nv -0.5 1 0\nf 1 2 3 4 5\n");
  ASSERT_EQ(idt("laplacian polygon.obj --stats s.json").status, 0);
  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["faces"], 1);
  EXPECT_EQ(stats["triangulated_faces"], 1);
  EXPECT_EQ(stats["border_edges"], 5);

  ASSERT_EQ(idt("sample one-vertex-torus -o torus").status, 0);
  ASSERT_EQ(idt("laplacian torus.gluing --stats s.json --mass M.mtx").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["vertices"], 1);
}

TEST_F(Laplacian_command, counts_the_tips_of_flat_spikes)
{
  write("spike.off",
        "OFF\n5 6 0\n0 0 0\n2 0 0\n1 0 0\n-1 0 0\n1 1 1\n3 0 2 3\n3 2 1 3\n3 1 0 3\n3 0 1 4\n3 2 0 4\n3 1 2 4\n");
  const Command_run run = idt("laplacian spike.off --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "without faces     1 vertex: rows of zeros")) << run.out;
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["unreferenced_vertices"], 1);
}

TEST_F(Laplacian_command, warns_of_gaps)
{
  write("gap.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0.5 0 0\n0.5 -1 0\n3 0 1 2\n3 0 4 3\n3 3 4 1\n");
  const Command_run run = idt("laplacian gap.off --stats s.json");
  ASSERT_EQ(run.status, 0);
  const std::string warning = "vertex 3 lies within edge 0-1 of face 0, which does not end there; --repair --stitch 0 "
                              "--save joined.idt of triangulate joins them: read joined.idt instead";
  EXPECT_EQ(run.err, "idt: gap.off: warning: " + warning + "\n");
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["warnings"], json({warning}));
  ASSERT_EQ(idt("triangulate gap.off --repair --stitch 0 --save joined.idt").status, 0);
  EXPECT_EQ(idt("laplacian joined.idt").err, "");
}

TEST_F(Laplacian_command, mollification_is_reported)
{
  write("cap.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0.5 1e-9 0\n3 0 1 2\n");
  ASSERT_EQ(idt("laplacian cap.off --mollify 1e-3 --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["mollification"]["changed_edges"], 3);
}

TEST_F(Laplacian_command, refuses_a_wrong_command_line)
{
  write_fan("fan.off");
  EXPECT_EQ(idt("laplacian").status, 2);
  EXPECT_EQ(idt("laplacian fan.off --cover tuft").status, 2);
  EXPECT_EQ(idt("laplacian fan.off --eigenvalues 0").status, 2);
  EXPECT_EQ(idt("laplacian fan.off --mollify -1").status, 2);
  EXPECT_EQ(idt("laplacian fan.off --stiffness fan.off").status, 2);
  EXPECT_EQ(idt("laplacian fan.off --stiffness A --mass A").status, 2);
  EXPECT_EQ(idt("laplacian absent.off").status, 3);
}

} // namespace

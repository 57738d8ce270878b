// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt simplify`: what it writes, and what it refuses.

#include "Tables_test.h"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

class Simplify_command : public Tables_test
{};

TEST_F(Simplify_command, writes_the_surface_and_where_all_vertices_went)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o m").status, 0);
  const Command_run run = idt("simplify m.off --maximum-change 0.1 -o c.idt --vertex-map v.csv --places p.csv "
                              "--prolongation P.mtx --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "times what they were, proven")) << run.out;
  const Json json = stats();
  const std::size_t before = json["input_vertices"], after = json["vertices"];
  EXPECT_LT(after, before);
  EXPECT_GE(json["shrink"], 1 / 1.1);
  EXPECT_LE(json["stretch"], 1.1);
  EXPECT_EQ(json["components"].size(), 1u);
  EXPECT_EQ(json["kept"]["by_bound"].get<std::size_t>() + json["kept"]["for_gluing"].get<std::size_t>(), after);
  EXPECT_EQ(rows("v.csv").size(), after);
  EXPECT_EQ(rows("p.csv").size(), before);
  for (const std::vector<double>& row : rows("p.csv")) {
    EXPECT_LT(row[1], json["faces"]);
    EXPECT_NEAR(row[2] + row[3] + row[4], 1, 1e-12);
  }
  const std::vector<std::string> matrix = lines(content(folder_ / "P.mtx"));
  EXPECT_EQ(matrix[0], "%%MatrixMarket matrix coordinate real general");
  std::map<std::size_t, double> sums;
  for (std::size_t i = 3; i < matrix.size(); ++i) {
    std::istringstream in(matrix[i]);
    std::size_t row = 0, column = 0;
    double value = 0;
    in >> row >> column >> value;
    sums[row] += value;
  }
  EXPECT_EQ(sums.size(), before);
  for (const auto& [row, sum] : sums)
    EXPECT_NEAR(sum, 1, 1e-12) << row;
  // Other subcommands read it.
  EXPECT_EQ(idt("triangulate c.idt --verify --stats t.json").status, 0);
  EXPECT_EQ(Json::parse(content(folder_ / "t.json"))["vertices"], after);
  EXPECT_EQ(idt("refine c.idt").status, 0);
  EXPECT_EQ(idt("distance c.idt --source 0 --cover none -o d.csv").status, 0);
  EXPECT_EQ(rows("d.csv").size(), after);
}

TEST_F(Simplify_command, keeps_what_it_is_told_to_keep)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o m").status, 0);
  ASSERT_EQ(idt("simplify m.off --vertices 200 --stats s.json").status, 0);
  EXPECT_EQ(stats()["vertices"], 200);
  std::ofstream(folder_ / "k.csv") << "vertex,keep\n5,1\n6,0\n7,1\n";
  ASSERT_EQ(idt("simplify m.off --maximum-change 1 --keep k.csv --vertex-map v.csv --stats s.json").status, 0);
  EXPECT_EQ(stats()["kept"]["by_request"], 2);
  std::size_t found = 0;
  for (const std::vector<double>& row : rows("v.csv"))
    found += row[1] == 5 || row[1] == 7;
  EXPECT_EQ(found, 2u);
  for (const char* table : {"vertex,keep\n5,nan\n", "vertex,keep,also\n5,1,1\n", "vertex,keep\n", ""}) {
    write("k.csv", table);
    const Command_run run = idt("simplify m.off --keep k.csv");
    EXPECT_NE(run.status, 0) << table;
    EXPECT_TRUE(contains(run.err, "k.csv, line ")) << run.err;
  }
}

TEST_F(Simplify_command, refuses_triangles_in_space)
{
  write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const Command_run run = idt("simplify t.off -o c.off");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.err, "edge lengths, but no points")) << run.err;
  EXPECT_EQ(idt("simplify t.off -o c.txt").status, 2);
  EXPECT_EQ(idt("simplify t.off --maximum-change -1").status, 2);
  EXPECT_EQ(idt("simplify t.off --constrain-angle 200").status, 2);
}

TEST_F(Simplify_command, distances_come_with_intervals_that_contain_the_exact_ones)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o m").status, 0);
  const Command_run run = idt("distance m.off --source 3 --maximum-change 0.1 -o a.csv --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "proven up to rounding: at most")) << run.out;
  EXPECT_EQ(lines(content(folder_ / "a.csv"))[0], "vertex,distance,lower,upper");
  ASSERT_EQ(idt("distance m.off --source 3 --method exact -o b.csv").status, 0);
  const auto found = rows("a.csv"), exact = rows("b.csv");
  ASSERT_EQ(found.size(), exact.size());
  bool is_simplified = false;
  for (std::size_t v = 0; v < exact.size(); ++v) {
    EXPECT_LE(found[v][2], exact[v][1] * (1 + 1e-9)) << v;
    EXPECT_GE(found[v][3], exact[v][1] * (1 - 1e-9)) << v;
    EXPECT_LE(found[v][3], 1.21 * found[v][2] * (1 + 1e-9)) << v;
    is_simplified = is_simplified || found[v][1] != exact[v][1];
  }
  EXPECT_TRUE(is_simplified);
  EXPECT_LT(stats()["simplification"]["vertices"], exact.size());
  const std::string both = idt("distance m.off --source 3 --maximum-change 0.1 --compare-exact").out;
  EXPECT_TRUE(contains(both, "proven up to rounding: at most") && contains(both, "; mean error ")) << both;
  EXPECT_EQ(idt("distance m.off --source 3 --maximum-change -1").status, 2);
  EXPECT_EQ(idt("distance m.off --source 3 --maximum-change 0.1 --method heat").status, 2);
}

TEST_F(Simplify_command, shows_its_edges_on_the_input)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o m").status, 0);
  EXPECT_EQ(idt("simplify m.off --view p.html").status, 0);
  EXPECT_TRUE(contains(content(folder_ / "p.html"), "before the simplification"));
  EXPECT_TRUE(contains(content(folder_ / "p.html"), "edges of the result, which has "));
  EXPECT_TRUE(contains(content(folder_ / "p.html"), "% by which lengths beside the edges may have changed"));
}

// The printed bounds are rounded outward, also where they are near 1.
TEST_F(Simplify_command, prints_bounds_that_are_proven)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o m").status, 0);
  for (const char* change : {"0.05", "0.02", "0.003", "1e-13", "2"}) {
    const Command_run run = idt(std::string("simplify m.off --stats s.json --maximum-change ") + change);
    ASSERT_EQ(run.status, 0) << run.err;
    std::istringstream words(run.out.substr(run.out.find("between ") + 8));
    const auto next = [&words] {
      std::string word, sign;
      words >> word >> sign;
      double difference = 0;
      if (sign == "+" || sign == "-")
        words >> difference >> word; // then "and" or "times"
      return sign == "+" ? 1 + difference : sign == "-" ? 1 - difference : std::stod(word);
    };
    const double shrink = next(), stretch = next();
    EXPECT_LE(shrink, double(stats()["shrink"])) << run.out;
    EXPECT_GE(stretch, double(stats()["stretch"])) << run.out;
    EXPECT_NEAR(shrink, double(stats()["shrink"]), 1e-3 * shrink) << run.out;
    EXPECT_NEAR(stretch, double(stats()["stretch"]), 1e-3 * stretch) << run.out;
  }
  const Command_run run = idt("simplify m.off --vertices 1");
  EXPECT_TRUE(contains(run.out, "as nothing could be proven without them")) << run.out;
  EXPECT_EQ(idt("simplify m.off --vertices 0").status, 2);
}

} // namespace

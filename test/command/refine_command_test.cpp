// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt refine`: what it writes, what it counts, and how it ends.

#include "Tables_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

class Refine_command : public Tables_test
{
protected:
  // A roof of two squares that meet at a ridge of 90 degrees, each cut into two triangles, above the unit square.
  void write_roof(const std::string& name) const
  {
    write(name, "OFF\n6 4 0\n0 0 0\n0 1 0\n1 0 1\n1 1 1\n2 0 0\n2 1 0\n3 0 2 1\n3 1 2 3\n3 2 4 3\n3 3 4 5\n");
  }
};

TEST_F(Refine_command, removes_flat_vertices_first)
{
  // A box of 1 x 2 x 1: a vertex in the middle of one side, one in the middle of each long edge.
  write("box.off", "OFF\n13 22 0\n"
                   "0 0 0\n1 0 0\n1 0 1\n0 0 1\n0 2 0\n1 2 0\n1 2 1\n0 2 1\n"
                   "0 1 0\n1 1 0\n1 1 1\n0 1 1\n0.5 0 0.5\n"
                   "3 0 1 12\n3 1 2 12\n3 2 3 12\n3 3 0 12\n"
                   "3 0 8 9\n3 0 9 1\n3 1 9 10\n3 1 10 2\n3 2 10 11\n3 2 11 3\n3 3 11 8\n3 3 8 0\n"
                   "3 8 4 5\n3 8 5 9\n3 9 5 6\n3 9 6 10\n3 10 6 7\n3 10 7 11\n3 11 7 4\n3 11 4 8\n"
                   "3 4 7 6\n3 4 6 5\n");
  const Command_run run = idt("refine box.off --minimum-angle 0 --remove-flat-vertices --vertex-map m.csv --verify "
                              "--stats s.json --overlay o.off");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "flat sides      5 vertices removed")) << run.out;
  EXPECT_EQ(stats()["removed"], 5);
  EXPECT_EQ(stats()["vertices"], 8);
  EXPECT_EQ(stats()["faces"], 12);
  std::vector<double> inputs;
  for (const std::vector<double>& row : rows("m.csv"))
    inputs.push_back(row[1]);
  std::sort(inputs.begin(), inputs.end());
  EXPECT_EQ(inputs, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
  ASSERT_EQ(idt("refine box.off --minimum-angle 0 --stats s.json").status, 0);
  EXPECT_EQ(stats()["removed"], 0);
  EXPECT_EQ(idt("refine box.off --vertex-map m.csv").status, 2);
  EXPECT_EQ(idt("refine box.off --remove-flat-vertices --repair --repair-map m.csv").status, 2);
  ASSERT_EQ(idt("sample one-vertex-torus -o t").status, 0);
  EXPECT_EQ(idt("refine t.gluing --remove-flat-vertices").status, 2);
}

TEST_F(Refine_command, removes_nearly_flat_vertices_where_it_may)
{
  // A pyramid whose base has a vertex in the middle, off by 1e-5.
  write("p.off", "OFF\n6 8 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n0.5 0.5 -1e-5\n"
                 "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n3 1 0 5\n3 2 1 5\n3 3 2 5\n3 0 3 5\n");
  EXPECT_TRUE(contains(idt("refine p.off --remove-flat-vertices").out, "flat sides      0 vertices removed\n"));
  EXPECT_TRUE(contains(idt("refine p.off --remove-flat-vertices --flat-tolerance 1e-6").out,
                       "flat sides      0 vertices removed; the surface has moved by at most 0, of 1e-06 allowed"));
  const Command_run run = idt("refine p.off --remove-flat-vertices --flat-tolerance 1e-4 --stats s.json");
  EXPECT_TRUE(
    contains(run.out, "flat sides      1 vertex removed; the surface has moved by at most 1e-05, of 0.0001 allowed"))
    << run.out;
  EXPECT_EQ(stats()["removed"], 1);
  EXPECT_NEAR(stats()["flat_deviation"], 1e-5, 1e-15);
  EXPECT_EQ(idt("refine p.off --flat-tolerance 1e-4").status, 2);
  EXPECT_EQ(idt("refine p.off --remove-flat-vertices --flat-tolerance -1").status, 2);
}

TEST_F(Refine_command, counts_what_it_inserts)
{
  ASSERT_EQ(idt("sample bad-torus -o t.off").status, 0);
  const Command_run run =
    idt("refine t.off --verify --stats s.json --points p.csv --edges e.csv --laplacian L.mtx --mass M.mtx");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_TRUE(contains(run.out, "status          refined, Delaunay, verified"));
  const Json json = stats();
  for (const char* key : {"vertices", "inserted", "segment_splits", "removed", "flips", "minimum_angle_degrees",
                          "maximum_circumradius", "unrefined", "status", "seconds"})
    EXPECT_TRUE(json.contains(key)) << key;
  const std::size_t vertices = json["vertices"], inserted = json["inserted"];
  std::istringstream off(content(folder_ / "t.off").substr(4));
  std::size_t input_vertices = 0;
  off >> input_vertices;
  EXPECT_EQ(vertices, input_vertices + inserted);
  EXPECT_GT(inserted, 0u);
  EXPECT_EQ(json["segment_splits"], 0);
  EXPECT_EQ(json["removed"], 0);
  EXPECT_GE(json["minimum_angle_degrees"], 25 * (1 - 1e-12));
  EXPECT_LT(json["minimum_angle_degrees"], 26);
  EXPECT_EQ(json["unrefined"], Json::object());
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["verification"]["not_delaunay"], 0);
  EXPECT_EQ(json["verification"]["tests"], json["edges"]);
  EXPECT_EQ(rows("p.csv").size(), inserted);
  EXPECT_EQ(rows("e.csv").size(), json["edges"]);
  for (const char* name : {"L.mtx", "M.mtx"}) {
    const std::vector<std::string> text = lines(content(folder_ / name));
    const auto sizes = std::find_if(text.begin(), text.end(), [](const std::string& line) { return line[0] != '%'; });
    ASSERT_NE(sizes, text.end());
    EXPECT_EQ(sizes->find(std::to_string(vertices) + " " + std::to_string(vertices) + " "), 0u) << name;
  }
}

// The lengths of the edges between two vertices in one input face are those of the points.
TEST_F(Refine_command, says_where_the_points_lie)
{
  write("plane.off", "OFF\n4 2 0\n0 0 1\n4 0 1\n4 3 1\n0 3 1\n3 0 1 2\n3 0 2 3\n");
  ASSERT_EQ(idt("refine plane.off --maximum-edge-length 0.5 --points p.csv --edges e.csv --stats s.json").status, 0);
  EXPECT_GT(stats()["segment_splits"], 20);
  std::vector<std::array<double, 2>> places = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const std::array<std::array<std::size_t, 3>, 2> faces = {{{0, 1, 2}, {0, 2, 3}}};
  for (const std::vector<double>& row : rows("p.csv")) {
    ASSERT_EQ(row.size(), 8u);
    EXPECT_EQ(row[0], places.size());
    const auto& corners = faces[static_cast<std::size_t>(row[1])];
    EXPECT_NEAR(row[2] + row[3] + row[4], 1, 1e-15);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      double x = 0;
      for (std::size_t i = 0; i < 3; ++i)
        x += row[2 + i] * places[corners[i]][axis];
      EXPECT_NEAR(x, row[5 + axis], 1e-14);
    }
    EXPECT_EQ(row[7], 1);
    places.push_back({row[5], row[6]});
  }
  for (const std::vector<double>& row : rows("e.csv")) {
    const auto &a = places[static_cast<std::size_t>(row[0])], &b = places[static_cast<std::size_t>(row[1])];
    EXPECT_NEAR(row[2], std::hypot(a[0] - b[0], a[1] - b[1]), 1e-13);
    EXPECT_LE(row[2], 0.5);
  }
}

TEST_F(Refine_command, keeps_sharp_edges)
{
  write_roof("roof.off");
  // Along the ridge, from vertex 2 to vertex 3, its parts are edges of the result.
  const auto length_of_ridge = [&](const std::string& options) {
    EXPECT_EQ(
      idt("refine roof.off --maximum-edge-length 0.3 --verify --points p.csv --edges e.csv --stats s.json " + options)
        .status,
      0);
    std::map<double, bool> on_ridge = {{2, true}, {3, true}};
    for (const std::vector<double>& row : rows("p.csv"))
      on_ridge[row[0]] = row[5] == 1 && row[7] == 1;
    double sum = 0;
    for (const std::vector<double>& row : rows("e.csv"))
      if (on_ridge[row[0]] && on_ridge[row[1]])
        sum += row[2];
    return sum;
  };
  EXPECT_NEAR(length_of_ridge("--constrain-angle 80"), 1, 1e-14);
  const Json constrained = stats();
  EXPECT_LT(length_of_ridge("--constrain-angle 100"), 0.9);
  EXPECT_LT(stats()["segment_splits"], constrained["segment_splits"]);
}

// Which edges are sharp depends on the smallest size, which is chosen: here, a sliver along the ridge is ignored.
TEST_F(Refine_command, keeps_sharp_edges_for_the_size_that_it_chooses)
{
  write("roof.off", "OFF\n8 6 0\n0 -1 0\n4 -1 0\n0 0 1\n4 0 1\n0 1e-6 1\n4 1e-6 1\n0 1 0\n4 1 0\n"
                    "3 0 1 3\n3 0 3 2\n3 2 3 5\n3 2 5 4\n3 4 5 7\n3 4 7 6\n");
  const Command_run run =
    idt("refine roof.off --constrain-angle 30 --verify --edges e.csv --kept-edges k.csv --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(stats()["minimum_size"], 1e-6);
  const std::string size = stats()["minimum_size"].dump();
  EXPECT_EQ(stats()["kept_edges"], 1);
  EXPECT_EQ(stats()["verification"]["not_delaunay"], 0);
  const auto edges = rows("e.csv");
  ASSERT_EQ(idt("refine roof.off --constraints k.csv --edges e.csv --minimum-size " + size).status, 0);
  EXPECT_EQ(rows("e.csv"), edges);
  ASSERT_EQ(idt("refine roof.off --constrain-angle 30 --minimum-size 0 --maximum-points 9 --kept-edges k.csv").status,
            4);
  EXPECT_EQ(rows("k.csv").size(), 2u);
}

TEST_F(Refine_command, keeps_the_edges_that_it_is_told)
{
  write_roof("roof.off");
  write("pairs.csv", "# the ridge\n\n3,2\n");
  ASSERT_EQ(idt("refine roof.off --maximum-edge-length 0.3 --constrain-angle 80 --edges e.csv").status, 0);
  const auto sharp = rows("e.csv");
  const Command_run run = idt("refine roof.off --maximum-edge-length 0.3 --constraints pairs.csv --verify --edges "
                              "e.csv --kept-edges k.csv --stats s.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "kept edges      1\n")) << run.out;
  EXPECT_EQ(stats()["kept_edges"], 1);
  EXPECT_EQ(rows("e.csv"), sharp);
  EXPECT_EQ(rows("k.csv"), (std::vector<std::vector<double>>{{2, 3}}));
  // The command reads its own output; in ParaView's format, the output is a line.
  ASSERT_EQ(
    idt("refine roof.off --maximum-edge-length 0.3 --constraints k.csv --edges e.csv --kept-edges k.vtp").status, 0);
  EXPECT_EQ(rows("e.csv"), sharp);
  EXPECT_TRUE(contains(content(folder_ / "k.vtp"), "NumberOfLines=\"1\"")) << content(folder_ / "k.vtp");
}

// A line between vertices, and one that ends inside a face: the result has edges along both.
TEST_F(Refine_command, keeps_straight_lines_across_faces)
{
  write_roof("roof.off");
  for (const char* line :
       {"--from 0 --to 5", "--from 0 --direction 0.2 --length 1.9", "--from 0 --direction 0.2 --length 0.5",
        "--from 1 --to 4", "--from 2 --direction 1 --length 1"}) {
    ASSERT_EQ(idt(std::string("geodesic roof.off -o g.csv --stats s.json ") + line).status, 0) << line;
    const double length = stats()["length"];
    const Command_run run = idt(
      "refine roof.off --minimum-angle 0 --constraints g.csv --verify --edges e.csv --kept-edges k.csv --stats s.json");
    ASSERT_EQ(run.status, 0) << line << run.err;
    std::map<std::pair<double, double>, double> lengths;
    for (const std::vector<double>& row : rows("e.csv"))
      lengths[std::minmax(row[0], row[1])] = row[2];
    double sum = 0;
    for (const std::vector<double>& row : rows("k.csv"))
      sum += lengths.at(std::minmax(row[0], row[1]));
    EXPECT_NEAR(sum, length, 1e-14) << line;
    EXPECT_EQ(idt("refine roof.off --constraints g.csv --verify").status, 0) << line;
  }
}

TEST_F(Refine_command, names_constraints_that_do_not_fit)
{
  write_roof("roof.off");
  const std::vector<std::pair<std::string, std::string>> files = {
    {"0 2\n0 5\n", "c.csv, line 2: no edge joins vertex 0 and vertex 5"},
    {"0 6\n", "line 1: there is no vertex 6: the surface has 6"},
    {"0 0.5\n", "line 1: there is no vertex 0.5"},
    {"-1 0\n", "there is no vertex -1"},
    {"0\n", "expected are two vertices"},
    {"0 1 2\n", "expected are two vertices, and nothing behind them"},
    {"zero one\n", "expected are two vertices"},
    {"face,vertex_0\n0,1\n", "line 2: expected are a face, three vertices"},
    {"face,vertex_0\n0,0,2,1,0,0,0\n", "the coordinates are not positive"},
    {"face,vertex_0\n0,0,2,1,0.5,0.2,0.3\n0,3,2,4,0.2,0.3,0.5\n", "do not lie in one face"},
    {"face,vertex_0\n0,0,5,1,0.5,0.5,0\n", "no edge joins vertex 0 and vertex 5"}};
  for (const auto& [text, message] : files) {
    write("c.csv", text);
    const Command_run run = idt("refine roof.off --constraints c.csv");
    EXPECT_EQ(run.status, 3) << text;
    EXPECT_TRUE(contains(run.err, message)) << text << run.err;
  }
  EXPECT_TRUE(contains(idt("refine roof.off --constraints none.csv").err, "none.csv: the file cannot be opened"));
  EXPECT_EQ(idt("refine roof.off --constraints c.csv --kept-edges c.csv").status, 2);
  EXPECT_EQ(idt("refine roof.off --constraints c.csv --remove-flat-vertices").status, 2);
  ASSERT_EQ(idt("sample one-vertex-torus -o t.gluing").status, 0);
  EXPECT_TRUE(contains(idt("refine t.gluing --constraints c.csv").err, "--constraints needs a surface in space"));
}

// The tip of a needle: a face below the bound, and listed. The smallest angle is taken over all faces.
TEST_F(Refine_command, tells_what_it_left)
{
  write("needle.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1.1 0.09 0\n1 0.17 0\n3 0 1 3\n3 1 2 3\n");
  const Command_run run = idt("refine needle.off --stats s.json");
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.out, "small input angle"));
  const Json json = stats();
  EXPECT_EQ(json["status"], "done");
  EXPECT_EQ(json["unrefined"]["small input angle"], 1);
  EXPECT_EQ(json["unrefined"].size(), json["unrefined"].contains("beside small input angle") ? 2u : 1u);
  EXPECT_NEAR(json["minimum_angle_degrees"], std::atan2(0.17, 1) * 180 / 3.14159265358979, 1e-9);
  EXPECT_GE(json["minimum_angle_degrees_of_refined_faces"], 25 * (1 - 1e-12));
}

// Below the smallest size nothing is inserted, which is not a failure.
TEST_F(Refine_command, leaves_what_is_smaller_than_matters)
{
  write("sliver.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1e-9 0\n0 1e-9 0\n3 0 1 2\n3 0 2 3\n");
  const Command_run run = idt("refine sliver.off --minimum-size 0.001 --stats s.json");
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.out, "too small"));
  EXPECT_EQ(stats()["unrefined"]["too small"], 2);
  EXPECT_EQ(stats()["inserted"], 0);
  for (const char* bad : {"-1", "nan"})
    EXPECT_EQ(idt(std::string("refine sliver.off --minimum-size ") + bad).status, 2);
}

// A closed tube, 1 long and 1e-6 around, beside a tetrahedron.
constexpr const char* tube =
  "OFF\n14 20 0\n0 0 0\n1e-7 0 0\n1e-7 1e-7 0\n0 2e-7 0\n-1e-7 1e-7 0\n0 0 1\n1e-7 0 1\n1e-7 1e-7 1\n0 2e-7 1\n-1e-7 "
  "1e-7 1\n"
  "1 1 1\n2 1 1\n1 2 1\n1 1 2\n"
  "3 0 1 6\n3 0 6 5\n3 1 2 7\n3 1 7 6\n3 2 3 8\n3 2 8 7\n3 3 4 9\n3 3 9 8\n3 4 0 5\n3 4 5 9\n"
  "3 2 1 0\n3 3 2 0\n3 4 3 0\n3 5 6 7\n3 5 7 8\n3 5 8 9\n3 10 12 11\n3 10 11 13\n3 11 12 13\n3 12 10 13\n";

TEST_F(Refine_command, chooses_a_smallest_size_where_it_needs_one)
{
  write("tube.off", tube);
  const Command_run run = idt("refine tube.off --verify --stats s.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "smallest size   9.537e-07, chosen: smaller faces need many vertices")) << run.out;
  EXPECT_TRUE(contains(run.out, "shortest left   a side of 1e-07 at (")) << run.out;
  EXPECT_NEAR(stats()["minimum_size"], std::ldexp(2., -21), 1e-12);
  EXPECT_NEAR(stats()["shortest_left"]["length"], 1e-7, 1e-20);
  EXPECT_EQ(stats()["shortest_left"]["place"].size(), 3u);
  EXPECT_GT(stats()["unrefined"]["too small"], 0);
  EXPECT_LT(stats()["inserted"], 100);
}

TEST_F(Refine_command, says_early_that_the_budget_will_not_suffice)
{
  write("tube.off", tube);
  const Command_run run = idt("refine tube.off --minimum-size 0 --maximum-points 3000 --stats s.json");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "the budget of 3,000 may not suffice")) << run.err;
  EXPECT_TRUE(contains(run.err, "the budget of 3,000 new vertices is spent")) << run.err;
  EXPECT_EQ(stats()["minimum_size"], 0);
  // Its advice is sufficient.
  const std::size_t advice = run.err.find("or --minimum-size ");
  ASSERT_NE(advice, std::string::npos) << run.err;
  const std::string size = run.err.substr(advice + 18, run.err.find(')', advice) - advice - 18);
  const Command_run again = idt("refine tube.off --maximum-points 3000 --minimum-size " + size);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_EQ(again.err, "");
}

// The first estimate takes its thin faces for strips that have to be filled evenly.
TEST_F(Refine_command, does_not_warn_of_a_budget_that_suffices)
{
  constexpr int n = 10'000;
  std::ostringstream wheel;
  wheel.precision(17);
  wheel << "OFF\n" << n + 1 << ' ' << n << " 0\n0 0 1\n";
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::acos(-1.) * i / n;
    wheel << std::cos(angle) << ' ' << std::sin(angle) << ' ' << 0.3 * std::sin(3 * angle) << '\n';
  }
  for (int i = 0; i < n; ++i)
    wheel << "3 0 " << 1 + i << ' ' << 1 + (i + 1) % n << '\n';
  write("wheel.off", wheel.str());
  const Command_run run = idt("refine wheel.off --stats s.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_GT(stats()["inserted"], 2048);
  EXPECT_EQ(run.err, "");
}

// Features of 1e-4 of the box are refined, and scans, of course.
TEST_F(Refine_command, chooses_no_size_where_none_is_needed)
{
  ASSERT_EQ(idt("sample bad-torus -o t.off").status, 0);
  write("feature.off",
        "OFF\n8 12 0\n0 0 0\n1 0 0\n1 1e-4 0\n0 1e-4 0\n0 0 1e-4\n1 0 1e-4\n1 1e-4 1e-4\n0 1e-4 1e-4\n"
        "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n3 3 0 4\n3 3 4 7\n");
  for (const char* name : {"t.off", "feature.off"}) {
    ASSERT_EQ(idt(std::string("refine ") + name + " --minimum-size 0 --stats s.json").status, 0);
    const Json without = stats();
    const Command_run run = idt(std::string("refine ") + name + " --stats s.json");
    EXPECT_EQ(run.status, 0);
    EXPECT_TRUE(contains(run.out, "smallest size   0: no place needs one")) << run.out;
    EXPECT_EQ(stats()["inserted"], without["inserted"]);
    EXPECT_EQ(stats()["unrefined"], without["unrefined"]);
  }
}

TEST_F(Refine_command, stops_at_the_budget)
{
  ASSERT_EQ(idt("sample bad-torus -o t.off").status, 0);
  const Command_run run = idt("refine t.off --maximum-points 7 --verify --stats s.json --edges e.csv");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "budget of 7 new vertices"));
  const Json json = stats();
  EXPECT_EQ(json["inserted"], 7);
  EXPECT_EQ(json["status"], "point budget");
  EXPECT_GT(json["unrefined"]["budget"], 0);
  EXPECT_LT(json["minimum_angle_degrees"], 25);
  EXPECT_EQ(json["verification"]["not_delaunay"], 0);
}

// Faces without area that flips cannot remove leave no weights. All other files and the report are written.
TEST_F(Refine_command, does_without_a_Laplacian)
{
  // Two next to each other at the border, and one at a constrained edge.
  write("border.off",
        "OFF\n5 5 0\n0 0 0\n1 0 0\n0.3 0 0\n0.6 0 0\n0.5 1 0\n3 0 2 4\n3 2 3 4\n3 3 1 4\n3 2 0 1\n3 3 2 1\n");
  write("inner.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0.5 0 0\n0.5 1 0\n0.5 -1 0\n3 0 2 3\n3 2 1 3\n3 0 1 2\n3 0 4 1\n");
  write("kept.csv", "0,1\n");
  for (const auto& [input, message] :
       {std::pair("border.off", "face 3 (corners 2, 0, 1) has zero area and lies on the border"),
        std::pair("inner.off --constraints kept.csv", "beside others at a border or kept edge")}) {
    const Command_run run = idt(std::string("refine ") + input + " --laplacian l.mtx --mass m.mtx --stats s.json");
    EXPECT_EQ(run.status, 3);
    EXPECT_TRUE(contains(run.err, message)) << run.err;
    EXPECT_TRUE(contains(run.out, "status")) << run.out;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "l.mtx"));
    EXPECT_TRUE(std::filesystem::remove(folder_ / "m.mtx"));
    EXPECT_EQ(stats()["status"], "done");
    EXPECT_TRUE(contains(stats()["warnings"].back(), message));
  }
  EXPECT_EQ(idt("laplacian inner.off --stiffness l.mtx").status, 0);
}

// Straight triangles: a roof without its ridge is another surface. The distance runs from the middle of the ridge to an
// edge below it.
TEST_F(Refine_command, says_that_a_plate_is_thinner_than_the_deviation)
{
  write("plate.off", "OFF\n8 12 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1e-5\n1 0 1e-5\n0 1 1e-5\n1 1 1e-5\n"
                     "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n"
                     "3 1 3 7\n3 1 7 5\n");
  const Command_run run = idt("refine plate.off --maximum-deviation 0.1% --flatten f.off");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "lie on each other")) << run.err;
  EXPECT_TRUE(contains(run.err, "--maximum-deviation has to be smaller than they are apart")) << run.err;
  // Deviations that are as large as the plate suffice for anything.
  EXPECT_FALSE(contains(idt("refine plate.off --maximum-deviation 5%").err, "suffices"));
}

TEST_F(Refine_command, flattens)
{
  write("roof.off", "OFF\n4 2 0\n0 -1 0\n2 0 1\n0 1 0\n-2 0 1\n3 0 1 3\n3 1 2 3\n"); // a long ridge, which is flipped
  Command_run run = idt("refine roof.off --minimum-angle 0 --flatten f.off --stats s.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "flattened       another surface, of 2 straight triangles, up to 1 away")) << run.out;
  EXPECT_NEAR(stats()["flattened"]["deviation"].get<double>(), 1, 1e-13);
  EXPECT_EQ(stats()["flattened"]["triangles"], 2);
  EXPECT_EQ(stats()["flattened"]["non_manifold_edges"], 0);
  EXPECT_NEAR(stats()["flattened"]["minimum_angle_degrees"].get<double>(), std::acos(2 / 3.) * 180 / std::acos(-1.),
              1e-12);
  std::istringstream off(content(folder_ / "f.off").substr(4));
  std::size_t vertices = 0, faces = 0;
  off >> vertices >> faces;
  EXPECT_EQ(vertices, 4u);
  EXPECT_EQ(faces, 2u);
  // With the ridge kept, nothing moves.
  run = idt("refine roof.off --constrain-angle 30 --maximum-edge-length 0.3 --flatten f.vtp --stats s.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_LT(stats()["flattened"]["deviation"], 1e-13);
  EXPECT_EQ(stats()["flattened"]["regions"], 2);
  EXPECT_EQ(stats()["flattened"]["lines"], 3);
  EXPECT_EQ(stats()["flattened"]["triangles"], stats()["faces"]);
  EXPECT_TRUE(contains(content(folder_ / "f.vtp"), "<VTKFile"));
  // A ridge that is kept for the deviation is no defect.
  run = idt("refine roof.off --maximum-deviation 1% --verify");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "Delaunay but for folds that are kept, verified")) << run.out;
  EXPECT_EQ(idt("refine roof.off --flatten f.txt").status, 2);
  EXPECT_EQ(idt("refine roof.off --flatten roof.off").status, 2);
  ASSERT_EQ(idt("sample one-vertex-torus -o t.gluing").status, 0);
  EXPECT_EQ(idt("refine t.gluing --flatten f.off").status, 2);
  // Around a thin box, faces have two equal corners, and several triangles the same side.
  write("box.off", "OFF\n8 12 0\n0 0 0\n1 0 0\n0 .1 0\n1 .1 0\n0 0 .1\n1 0 .1\n0 .1 .1\n1 .1 .1\n"
                   "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n"
                   "3 1 3 7\n3 1 7 5\n");
  run = idt("refine box.off --flatten f.off --stats s.json");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "the straight triangles are no surface: ")) << run.err;
  EXPECT_FALSE(contains(run.out + run.err, "refined")) << run.out;
  EXPECT_EQ(stats()["status"], "no surface");
  std::istringstream box(content(folder_ / "f.off").substr(4));
  box >> vertices >> faces;
  std::map<std::pair<int, int>, int> triangles_at;
  for (std::string line; std::getline(box, line);)
    if (int a, b, c; std::sscanf(line.c_str(), "3 %d %d %d", &a, &b, &c) == 3 && line[1] == ' ')
      for (const auto& [v, w] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
        ++triangles_at[std::minmax(v, w)];
  const auto crowded =
    std::count_if(triangles_at.begin(), triangles_at.end(), [](const auto& side) { return side.second > 2; });
  EXPECT_GT(crowded, 0);
  EXPECT_EQ(stats()["flattened"]["non_manifold_edges"], crowded);
  EXPECT_GT(stats()["flattened"]["loops"], 0);
  EXPECT_FALSE(stats()["flattened"]["is_surface"].get<bool>());
}

TEST_F(Refine_command, keeps_straight_triangles_near_the_surface)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o bumpy.off").status, 0);
  ASSERT_EQ(idt("refine bumpy.off --maximum-deviation 1% --flatten f.ply --stats s.json").status, 0);
  const double first = stats()["flattened"]["deviation"];
  ASSERT_EQ(idt("refine bumpy.off --maximum-deviation 0.005 --flatten f.ply --stats s.json").status, 0);
  EXPECT_LE(stats()["flattened"]["deviation"].get<double>(), 0.005);
  EXPECT_GT(first, 0.005);
  EXPECT_TRUE(stats()["flattened"]["is_surface"].get<bool>());
  for (const char* wrong : {"0", "-1", "x", "nan", "1%%", "%"})
    EXPECT_EQ(idt(std::string("refine bumpy.off --maximum-deviation=") + wrong).status, 2) << wrong;
  ASSERT_EQ(idt("sample one-vertex-torus -o t.gluing").status, 0);
  EXPECT_EQ(idt("refine t.gluing --maximum-deviation 1").status, 2);
}

// Around a splinter, four triangles meet at many edges: where it is cut, no vertex joins two fans afterwards.
TEST_F(Refine_command, makes_a_surface_of_a_splinter)
{
  write("splinter.off", "OFF\n5 6 0\n0.347 0.001 0.001\n0.011 0 0\n1.011 0 0\n0.922 0.001 0\n0.381 0.001 0\n"
                        "3 1 2 0\n3 4 2 1\n3 1 0 4\n3 3 0 2\n3 2 4 3\n3 3 4 0\n");
  for (const char* deviation : {"0.02", "0.03", "0.05"}) {
    const Command_run run = idt(std::string("refine splinter.off --flatten f.off --maximum-deviation ") + deviation);
    EXPECT_EQ(run.status, 0) << run.err;
  }
}

// The border of a flattened cone is narrower than the deviation.
TEST_F(Refine_command, names_a_deviation_that_suffices)
{
  std::ostringstream cone;
  cone << "OFF\n13 12 0\n";
  for (int i = 0; i < 12; ++i)
    cone << std::setprecision(17) << std::cos(std::acos(-1.) * i / 6) << ' ' << 0.02 * std::sin(std::acos(-1.) * i / 6)
         << " 0\n";
  cone << "0 0 0.3877\n";
  for (int i = 0; i < 12; ++i)
    cone << "3 " << i << ' ' << (i + 1) % 12 << " 12\n";
  write("cone.off", cone.str());
  Command_run run = idt("refine cone.off --maximum-deviation 0.1 --stats s.json");
  ASSERT_EQ(run.status, 4);
  const double named = stats()["flattened"]["sufficient_deviation"];
  EXPECT_TRUE(contains(run.err, " suffices, as was tried")) << run.err;
  run = idt("refine cone.off --maximum-deviation " + std::to_string(named));
  EXPECT_EQ(run.status, 0) << run.err;
}

// With names in Gmsh's and Abaqus' files, which other programs read back.
TEST_F(Refine_command, writes_meshes_for_solvers)
{
  write("roof.off", "OFF\n4 2 0\n0 -1 0\n2 0 1\n0 1 0\n-2 0 1\n3 0 1 3\n3 1 2 3\n");
  const std::string options =
    "refine roof.off --constrain-angle 30 --maximum-edge-length 0.3 --stats s.json --flatten ";
  ASSERT_EQ(idt(options + "f.msh").status, 0);
  const std::size_t triangles = stats()["flattened"]["triangles"];
  std::map<std::string, std::size_t> elements; // by type and tag
  std::istringstream msh(content(folder_ / "f.msh"));
  for (std::string line; std::getline(msh, line);)
    if (int number, type, tags, tag;
        std::sscanf(line.c_str(), "%d %d %d %d", &number, &type, &tags, &tag) == 4 && tags == 2)
      ++elements[std::to_string(type) + ' ' + std::to_string(tag)];
  EXPECT_EQ(elements.size(), 5u); // two regions and three lines
  EXPECT_EQ(elements["2 1"] + elements["2 2"], triangles);
  for (const char* name : {"2 1 \"region_0\"", "2 2 \"region_1\"", "1 3 \"line_0\"", "1 5 \"line_2\""})
    EXPECT_TRUE(contains(content(folder_ / "f.msh"), name)) << name;
  ASSERT_EQ(idt(options + "f.INP").status, 0);
  for (const char* name : {"*NODE\n1, ", "*ELEMENT, TYPE=S3, ELSET=REGION_1\n", "*NSET, NSET=LINE_2\n"})
    EXPECT_TRUE(contains(content(folder_ / "f.INP"), name)) << name;
  // A number has at most 20 characters.
  write("tiny.off", "OFF\n3 1 0\n-1.2345678901234567e-100 0 0\n1 0 0\n1.234567890123456e-05 1 0\n3 0 1 2\n");
  ASSERT_EQ(idt("refine tiny.off --maximum-edge-length 2 --flatten t.inp").status, 0);
  EXPECT_TRUE(contains(content(folder_ / "t.inp"), "\n1, -1.234567890123e-100, 0, 0\n"));
  EXPECT_TRUE(contains(content(folder_ / "t.inp"), "\n3, 1.23456789012346e-05, 1, 0\n"));
  ASSERT_EQ(idt(options + "f.vtp").status, 0);
  EXPECT_TRUE(contains(content(folder_ / "f.vtp"), "Name=\"region\""));
  for (const char* file : {"f.off", "f.ply", "f.stl"}) { // which the command reads itself
    ASSERT_EQ(idt(options + file).status, 0);
    ASSERT_EQ(idt(std::string("triangulate ") + file + " --stats s.json").status, 0);
    EXPECT_EQ(stats()["faces"], triangles);
  }
}

TEST_F(Refine_command, refines_surfaces_that_have_lengths_alone)
{
  ASSERT_EQ(idt("sample one-vertex-torus -o t.gluing").status, 0);
  ASSERT_EQ(idt("refine t.gluing --maximum-circumradius 0.1 --points p.csv --stats s.json").status, 0);
  EXPECT_LE(stats()["maximum_circumradius"], 0.1);
  ASSERT_FALSE(rows("p.csv").empty());
  EXPECT_TRUE(std::isnan(rows("p.csv")[0][7]));
  const Command_run run = idt("refine t.gluing --constrain-angle 30");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "--constrain-angle needs a surface in space"));
}

// A square of n² unit squares in the plane.
std::string sheet(int n)
{
  std::ostringstream off;
  off << "OFF\n" << (n + 1) * (n + 1) << ' ' << 2 * n * n << " 0\n";
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      off << i << ' ' << j << " 0\n";
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int v = i * (n + 1) + j, w = v + n + 1;
      off << "3 " << v << ' ' << w << ' ' << w + 1 << "\n3 " << v << ' ' << w + 1 << ' ' << v + 1 << '\n';
    }
  return off.str();
}

TEST_F(Refine_command, keeps_edges_whole)
{
  write("sheet.off", sheet(4));
  Command_run run = idt("refine sheet.off --maximum-edge-length 0.4 --keep-whole border --verify --stats s.json "
                        "--points p.csv --flatten f.off --maximum-deviation 1e-3");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(stats()["segment_splits"], 0);
  EXPECT_GT(stats()["inserted"], 20);
  for (const std::vector<double>& row : rows("p.csv"))
    EXPECT_TRUE(row[5] > 0 && row[5] < 4 && row[6] > 0 && row[6] < 4);
  for (const auto& [reason, number] : stats()["unrefined"].items())
    EXPECT_EQ(reason, "whole edge");
  EXPECT_TRUE(contains(run.out, "faces: whole edge")) << run.out;
  // Two edges inside, one of which is split otherwise.
  write("w.csv", "6,7\n12,7\n");
  const std::string options = "refine sheet.off --maximum-edge-length 0.4 --edges e.csv --stats s.json ";
  const auto has_edge = [&] {
    const auto edges = rows("e.csv");
    return std::any_of(edges.begin(), edges.end(), [](const std::vector<double>& row) {
      return std::minmax(row[0], row[1]) == std::minmax(6., 7.);
    });
  };
  write("w.csv", "\xef\xbb\xbf" + content(folder_ / "w.csv")); // a byte order mark
  ASSERT_EQ(idt(options + "--keep-whole w.csv").status, 0);
  EXPECT_TRUE(has_edge());
  EXPECT_EQ(stats()["kept_edges"], 2);
  EXPECT_GT(stats()["segment_splits"], 0);
  ASSERT_EQ(idt(options + "--constraints w.csv").status, 0);
  EXPECT_FALSE(has_edge());
  write("bad.csv", "0,24\n");
  run = idt(options + "--keep-whole bad.csv");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "bad.csv, line 1: no edge joins vertex 0 and vertex 24")) << run.err;
  EXPECT_EQ(idt(options + "--keep-whole w.csv --remove-flat-vertices").status, 2);
  EXPECT_EQ(idt(options + "--keep-whole border --remove-flat-vertices").status, 0);
}

// A narrow strip has small angles between whole edges, for any deviation.
TEST_F(Refine_command, says_that_whole_edges_are_the_reason)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 0.3 0\n0 0.3 0\n3 0 1 2\n3 0 2 3\n");
  const Command_run run = idt("refine strip.off --keep-whole border --maximum-deviation 1e-3");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "fewer --keep-whole edges leave more room")) << run.err;
}

// A link to a file that does not exist yet.
TEST_F(Refine_command, does_not_write_two_results_to_one_file)
{
  write_kite("kite.off");
  std::filesystem::create_symlink("new.csv", folder_ / "link.csv");
  EXPECT_EQ(idt("refine kite.off --points new.csv --edges link.csv").status, 2);
  EXPECT_EQ(idt("refine kite.off --points new.csv --edges other.csv").status, 0);
}

// Folds are kept before the first flip: otherwise many vertices are needed beside them.
TEST_F(Refine_command, follows_folds_of_spiky_cones)
{
  std::ostringstream cone;
  cone << "OFF\n13 12 0\n" << std::setprecision(17);
  for (int i = 0; i < 12; ++i)
    cone << std::cos(std::acos(-1.) * i / 6) << ' ' << 0.02 * std::sin(std::acos(-1.) * i / 6) << " 0\n";
  cone << "0 0 4\n";
  for (int i = 0; i < 12; ++i)
    cone << "3 " << i << ' ' << (i + 1) % 12 << " 12\n";
  write("cone.off", cone.str());
  for (const char* deviation : {"0.05", "1e-3", "1e-6"}) {
    const Command_run run = idt(std::string("refine cone.off --stats s.json --maximum-deviation ") + deviation);
    EXPECT_EQ(run.status, 0) << deviation << run.err;
    EXPECT_LT(stats()["inserted"].get<int>(), 3000) << deviation;
  }
}

// A thin sheet of material stands on a block, and is left out. Two blocks cross. A sheet has a border.
TEST_F(Refine_command, says_whether_triangles_can_be_filled)
{
  std::ostringstream block;
  block << "OFF\n16 28 0\n";
  for (int z : {0, 1})
    for (const char* p : {"0 0", "1 0", "1 0.5", "2 0.5", "2 0.5000001", "1 0.5000001", "1 1", "0 1"})
      block << p << ' ' << z << '\n';
  for (int v = 0; v < 8; ++v)
    block << "3 " << v << ' ' << (v + 1) % 8 << ' ' << (v + 1) % 8 + 8 << "\n3 " << v << ' ' << (v + 1) % 8 + 8 << ' '
          << v + 8 << '\n';
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 5}, {0, 5, 7}, {5, 6, 7}, {2, 3, 4}, {2, 4, 5}})
    block << "3 " << a << ' ' << c << ' ' << b << "\n3 " << a + 8 << ' ' << b + 8 << ' ' << c + 8 << '\n';
  write("block.off", block.str());
  const std::string options = " --constrain-angle 30 --maximum-deviation 0.01 --stats s.json";
  Command_run run = idt("refine block.off" + options);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "can be filled with tetrahedra\n") && contains(run.out, "films of area 1")) << run.out;
  auto straight = stats()["flattened"];
  EXPECT_EQ(straight["can_be_filled"], true);
  EXPECT_EQ(straight["folded_edges"], 0);
  EXPECT_NEAR(straight["minimum_dihedral_angle_degrees"], 90, 1);
  EXPECT_NEAR(straight["area_of_films"], 1, 0.01);
  double area = 0;
  int triangles = 0;
  for (const auto& region : straight["region_table"]) {
    area += double(region["area"]);
    triangles += int(region["triangles"]);
    EXPECT_LT(region["high"][0], 1.01);
  }
  EXPECT_EQ(straight["region_table"].size(), straight["regions"]);
  EXPECT_EQ(triangles, straight["triangles"]);
  EXPECT_NEAR(area, 6, 0.1);
  write("sheet.off", sheet(2));
  run = idt("refine sheet.off" + options);
  EXPECT_TRUE(contains(run.out, "cannot be filled: ") && contains(run.out, " edges on the border")) << run.out;
  EXPECT_EQ(run.status, 0) << run.err;
  write("crossing.off", "OFF\n8 8 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0.1 0.1 0.1\n2 0.1 0.1\n0.1 2 0.1\n0.1 0.1 2\n"
                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n3 4 6 5\n3 4 5 7\n3 5 6 7\n3 6 4 7\n");
  run = idt("refine crossing.off" + options);
  EXPECT_TRUE(contains(run.out, "cannot be filled: ") && contains(run.out, "(unite its parts before)")) << run.out;
  EXPECT_EQ(run.status, 0) << run.err;
}

// As coordinates are rounded, nothing is as near as that.
TEST_F(Refine_command, names_a_deviation_above_rounding)
{
  write("cone.off", "OFF\n4 3 0\n1 0 0\n-0.4 0.8 0\n-0.4 -0.9 0\n0 0 40\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  for (const char* deviation : {"1e-15", "1e-20"}) {
    Command_run run = idt(std::string("refine cone.off --stats s.json --maximum-deviation ") + deviation);
    ASSERT_EQ(run.status, 4);
    const double named = stats()["flattened"]["sufficient_deviation"];
    EXPECT_GT(named, 0);
    EXPECT_LT(named, 1e-8);
    std::ostringstream text;
    text << std::setprecision(17) << named;
    run = idt("refine cone.off --maximum-deviation " + text.str());
    EXPECT_EQ(run.status, 0) << run.err;
  }
}

TEST_F(Refine_command, takes_sizes_from_a_table)
{
  write("sheet.off", sheet(4));
  write("sizes.csv", "vertex,size\n0,0.05\n");
  ASSERT_EQ(idt("refine sheet.off --size-map sizes.csv --edges e.csv --stats s.json").status, 0);
  const int vertices = stats()["vertices"];
  EXPECT_GT(vertices, 60);
  double at_corner = 0;
  for (const std::vector<double>& row : rows("e.csv"))
    if (row[0] == 0 || row[1] == 0)
      at_corner = (std::max)(at_corner, row[2]);
  EXPECT_LT(at_corner, 0.06);
  write("sizes_by_spreadsheet.csv", "\xef\xbb\xbfvertex,size\n0,0.05\n");
  ASSERT_EQ(idt("refine sheet.off --size-map sizes_by_spreadsheet.csv --stats s.json").status, 0);
  EXPECT_EQ(stats()["vertices"], vertices);
  ASSERT_EQ(idt("refine sheet.off --size-map sizes.csv --size-gradation 1 --stats s.json").status, 0);
  EXPECT_LT(stats()["vertices"], vertices);
  for (const auto& [table, message] :
       {std::pair("vertex,size\n3,0\n", "the size at vertex 3 is not positive"),
        std::pair("vertex,size\n25,1\n", "there is no vertex 25"),
        std::pair("vertex,size,other\n2,1,1\n", "line 1: the first line of this table is vertex,NAME")}) {
    write("bad.csv", table);
    const Command_run run = idt("refine sheet.off --size-map bad.csv");
    EXPECT_EQ(run.status, 3) << table;
    EXPECT_TRUE(contains(run.err, message)) << run.err;
  }
  ASSERT_EQ(idt("sample bumpy-sphere -o b.off").status, 0);
  ASSERT_EQ(idt("refine b.off --maximum-normal-angle 40 --stats s.json").status, 0);
  const int fine = stats()["vertices"];
  ASSERT_EQ(idt("refine b.off --maximum-normal-angle 80 --stats s.json").status, 0);
  EXPECT_LT(stats()["vertices"], fine / 2);
}

// At once, rather than after a million vertices.
TEST_F(Refine_command, estimates_the_vertices_first)
{
  write("sheet.off", sheet(1));
  const Command_run run = idt("refine sheet.off --maximum-edge-length 0.0001 --stats s.json");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "need about 2")) << run.err;
  EXPECT_TRUE(contains(run.err, "new vertices: allow longer ones, or set --maximum-points N")) << run.err;
  EXPECT_EQ(idt("refine sheet.off --maximum-edge-length 0.0001 --maximum-points 50 --stats s.json").status, 4);
  EXPECT_EQ(stats()["inserted"], 50);
}

TEST_F(Refine_command, refuses_senseless_bounds)
{
  write_kite("kite.off");
  for (const char* const options :
       {"--minimum-angle 30.1", "--minimum-angle -1", "--minimum-angle nan", "--maximum-circumradius 0",
        "--maximum-circumradius nan", "--maximum-edge-length -2", "--constrain-angle 181", "--constrain-angle nan",
        "--maximum-points -1", "--points kite.off", "--size-gradation 0", "--size-gradation inf",
        "--maximum-normal-angle 0"}) {
    const Command_run run = idt(std::string("refine kite.off ") + options);
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_NE(run.err, "") << options;
  }
}

TEST_F(Refine_command, writes_the_overlay)
{
  ASSERT_EQ(idt("sample bumpy-dome -o d.off").status, 0);
  ASSERT_EQ(idt("refine d.off --overlay o.off --crossings c.csv --stats s.json").status, 0);
  std::istringstream off(content(folder_ / "o.off").substr(4));
  std::size_t vertices = 0;
  off >> vertices;
  EXPECT_EQ(vertices, stats()["vertices"].get<std::size_t>() + rows("c.csv").size());
}

} // namespace

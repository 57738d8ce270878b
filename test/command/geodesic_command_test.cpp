// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt geodesic`

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace {

using nlohmann::json;

class Geodesic_command : public Command_test
{
protected:
  // Squares of side 1 with a diagonal each, 4 by 4, vertex 5 y + x.
  void write_sheet(const std::string& name) const
  {
    std::ostringstream text;
    text << "OFF\n25 32 0\n";
    for (int v = 0; v < 25; ++v)
      text << v % 5 << ' ' << v / 5 << " 0\n";
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x) {
        const int v = 5 * y + x;
        text << "3 " << v << ' ' << v + 1 << ' ' << v + 6 << "\n3 " << v << ' ' << v + 6 << ' ' << v + 5 << '\n';
      }
    write(name, text.str());
  }
};

TEST_F(Geodesic_command, writes_a_path)
{
  write_sheet("sheet.off");
  const Command_run run = idt("geodesic sheet.off --from 0 --to 19 -o path.obj --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats.at("status"), "geodesic");
  EXPECT_TRUE(stats.at("is_geodesic").get<bool>());
  EXPECT_NEAR(stats.at("length").get<double>(), 5, 1e-14);
  EXPECT_NEAR(stats.at("initial_length").get<double>(), 3 * std::sqrt(2.) + 1, 1e-14);
  const std::vector<std::string> text = lines(content(folder_ / "path.obj"));
  ASSERT_EQ(text.size(), stats.at("segments").get<std::size_t>() + 2);
  EXPECT_EQ(text.front(), "v 0 0 0");
  EXPECT_EQ(text.at(text.size() - 2), "v 4 3 0");
  EXPECT_EQ(text.back().substr(0, 6), "l 1 2 ");

  // The same points with their faces: barycentric coordinates give the points.
  ASSERT_EQ(idt("geodesic sheet.off --from 0 --to 19 -o path.csv").status, 0);
  const std::vector<std::string> table = lines(content(folder_ / "path.csv"));
  EXPECT_EQ(table.size(), text.size());
  for (std::size_t i = 1; i < table.size(); ++i) {
    std::string line = table[i];
    for (char& c : line)
      if (c == ',')
        c = ' ';
    std::istringstream row(line);
    int face, v[3];
    double b[3], x, y, z;
    row >> face >> v[0] >> v[1] >> v[2] >> b[0] >> b[1] >> b[2] >> x >> y >> z;
    ASSERT_FALSE(row.fail()) << table[i];
    EXPECT_NEAR(b[0] * (v[0] % 5) + b[1] * (v[1] % 5) + b[2] * (v[2] % 5), x, 1e-14);
    EXPECT_NEAR(b[0] * (v[0] / 5) + b[1] * (v[1] / 5) + b[2] * (v[2] / 5), y, 1e-14);
    EXPECT_NEAR(3 * x, 4 * y, 1e-13);
  }
}

TEST_F(Geodesic_command, passes_through_vertices_and_shrinks_loops)
{
  write_sheet("sheet.off");
  ASSERT_EQ(idt("geodesic sheet.off --from 0 --via 4 --to 24 --stats s.json -o p.ply").status, 0);
  EXPECT_NEAR(json::parse(content(folder_ / "s.json")).at("length").get<double>(), 8, 1e-14);
  EXPECT_TRUE(contains(content(folder_ / "p.ply"), "element edge 8"));
  const Command_run run = idt("geodesic sheet.off --from 0 --via 4 --to 24 --closed --stats s.json -o p.csv");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "sheet.off: the curve shrinks to vertex ")) << run.err;
  EXPECT_EQ(lines(content(folder_ / "p.csv")).size(), 1u); // a header
  EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("status"), "contractible");
}

TEST_F(Geodesic_command, follows_a_line)
{
  write_sheet("sheet.off");
  ASSERT_EQ(idt("geodesic sheet.off --from 0 --direction 0.4 --length 3 --stats s.json -o line.obj").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("status"), "at_length");
  const std::vector<std::string> text = lines(content(folder_ / "line.obj"));
  std::istringstream end(text.at(text.size() - 2).substr(2));
  double x, y;
  end >> x >> y;
  EXPECT_NEAR(x, 3 * std::cos(0.4), 1e-14);
  EXPECT_NEAR(y, 3 * std::sin(0.4), 1e-14);
  ASSERT_EQ(idt("geodesic sheet.off --from 0 --direction 0.4 --length 300 --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("status"), "at_border");
  EXPECT_NEAR(json::parse(content(folder_ / "s.json")).at("length").get<double>(), 4 / std::cos(0.4), 1e-14);
  ASSERT_EQ(idt("geodesic sheet.off --from 0 --direction 0.4 --length 300 --maximum-faces 3 --stats s.json").status, 4);
  EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("status"), "unfinished");
  EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("segments"), 3);
}

TEST_F(Geodesic_command, goes_between_points_and_finds_the_shortest_path)
{
  write_sheet("sheet.off");
  for (const char* option : {"", " --shortest"}) {
    ASSERT_EQ(
      idt(std::string("geodesic sheet.off --from=-1,-2,5 --to 3.5,0.25,1 -o p.obj --stats s.json") + option).status, 0);
    const std::vector<std::string> text = lines(content(folder_ / "p.obj"));
    EXPECT_EQ(text.front(), "v 0 0 0");
    EXPECT_EQ(text.at(text.size() - 2), "v 3.5 0.25 0");
    EXPECT_NEAR(json::parse(content(folder_ / "s.json")).at("length").get<double>(), std::hypot(3.5, 0.25), 1e-14);
  }
  const json stats_of_points = json::parse(content(folder_ / "s.json"));
  EXPECT_TRUE(stats_of_points.at("is_shortest").get<bool>());
  EXPECT_EQ(stats_of_points.at("snaps").at(0).at("option"), "--from");
  EXPECT_NEAR(stats_of_points.at("snaps").at(0).at("distance").get<double>(), std::sqrt(30.), 1e-14);
  EXPECT_NEAR(stats_of_points.at("snaps").at(1).at("distance").get<double>(), 1, 1e-14);
  EXPECT_TRUE(contains(idt("geodesic sheet.off --from 0 --to 3.5,0.25,1").out,
                       "  --to      the nearest point of the surface, 1 from the given one\n"));
  // A pyramid with its peak near the front; the path along edges runs over its back.
  write("pyramid.off", "OFF\n5 4 0\n-5 0 0\n5 0 0\n0 1 6\n0 -4 0\n0 4.5 0\n3 0 2 4\n3 2 1 4\n3 0 3 2\n3 3 1 2\n");
  ASSERT_EQ(idt("geodesic pyramid.off --from 0 --to 1 --shortest --stats s.json").status, 0);
  ASSERT_EQ(idt("distance pyramid.off --source 0 --method exact --cover none -o d.csv").status, 0);
  const std::string distance = lines(content(folder_ / "d.csv")).at(2);
  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_NEAR(stats.at("length").get<double>(), std::stod(distance.substr(2)), 1e-12);
  EXPECT_NEAR(stats.at("distance").get<double>(), std::stod(distance.substr(2)), 1e-12);
}

TEST_F(Geodesic_command, says_where_a_repair_cut_the_surface)
{
  write("fan.off", "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0.5\n-1 2 0.5\n-1 -2 0.5\n3 0 1 2\n3 0 1 3\n3 1 0 4\n");
  const Command_run run = idt("geodesic fan.off --repair --shortest --from 0 --to 1 --stats s.json");
  EXPECT_TRUE(contains(run.out, "; the path is shortest, on the repaired surface, which was cut (3 new border edges"))
    << run.out << run.err;
  EXPECT_FALSE(json::parse(content(folder_ / "s.json")).at("repair").empty());
}

TEST_F(Geodesic_command, goes_over_triangles_that_are_no_surface)
{
  // Three pages at a spine of length 1.
  write("fan.off", "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0.5\n-1 2 0.5\n-1 -2 0.5\n3 0 1 2\n3 0 1 3\n3 1 0 4\n");
  const Command_run run = idt("geodesic fan.off --from 2 --via 4 --to 3 -o path.csv --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "taken as they are"));
  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_TRUE(stats.at("is_on_any_triangles").get<bool>() && stats.at("is_shortest").get<bool>());
  EXPECT_NEAR(stats.at("length").get<double>(), 1 + 3 * std::sqrt(5.), 1e-14);
  EXPECT_EQ(stats.at("segments"), 4);
  const std::vector<std::string> table = lines(content(folder_ / "path.csv"));
  ASSERT_EQ(table.size(), 6u);
  EXPECT_EQ(table[2].substr(0, 8), "2,1,0,4,"); // into the third page
  ASSERT_EQ(idt("geodesic fan.off --from 2 --to 3 -o path.obj").status, 0);
  EXPECT_EQ(lines(content(folder_ / "path.obj")).size(), 4u);
  // From a point beside the first page to one on the edge of the second.
  const Command_run points = idt("geodesic fan.off --from 0.5,0.1,0.5 --to=-0.5,1,0.25 -o path.csv --stats s.json");
  ASSERT_EQ(points.status, 0) << points.err;
  const json found = json::parse(content(folder_ / "s.json"));
  const double x = 0.5 + std::hypot(0.5, 1); // in the plane of both
  EXPECT_NEAR(found.at("length").get<double>(), std::hypot(x, 0.25), 1e-14);
  EXPECT_NEAR(found.at("snaps").at(0).at("distance").get<double>(), 0.1, 1e-15);
  EXPECT_EQ(lines(content(folder_ / "path.csv")).size(), 4u);
  for (const char* options :
       {"--from 2 --to 3 --via 4 --closed", "--from 2 --to 3 --cut c.off", "--from 2 --direction 1 --length 1"}) {
    const Command_run refused = idt(std::string("geodesic fan.off ") + options);
    EXPECT_TRUE(refused.status == 3 && contains(refused.err, "--repair")) << options << refused.err;
  }
}

TEST_F(Geodesic_command, names_the_ends_in_their_order)
{
  write("two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  for (const char* option : {"", " --shortest"})
    EXPECT_TRUE(
      contains(idt(std::string("geodesic two.off --from 0 --to 4") + option).err, "from vertex 0 to vertex 4"))
      << option;
  EXPECT_TRUE(contains(idt("geodesic two.off --from 0.2,0.2,0 --to 4").err, "from the point 0.2,0.2,0 to vertex 4"));
}

// A part flips edges of those before.
TEST_F(Geodesic_command, is_shortest_from_stop_to_stop)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o sphere.off").status, 0);
  double sum = 0;
  const std::vector<std::string> stops{"3", "90", "41", "12", "77", "60"};
  const auto length = [&](const std::string& options) {
    const Command_run run = idt("geodesic sphere.off --shortest --stats s.json " + options);
    EXPECT_EQ(run.status, 0) << run.err;
    const json stats = json::parse(content(folder_ / "s.json"));
    EXPECT_TRUE(stats.at("is_shortest").get<bool>());
    return stats.at("length").get<double>();
  };
  std::string all = "--from " + stops[0];
  for (std::size_t i = 1; i < stops.size(); ++i) {
    sum += length("--from " + stops[i - 1] + " --to " + stops[i]);
    all += (i + 1 < stops.size() ? " --via " : " --to ") + stops[i];
  }
  EXPECT_NEAR(length(all), sum, 1e-12 * sum);
}

TEST_F(Geodesic_command, cuts_the_surface_open)
{
  write_sheet("sheet.off");
  ASSERT_EQ(idt("geodesic sheet.off --from 1 --to 23 --cut opened.off").status, 0);
  ASSERT_EQ(idt("triangulate opened.off --verify").status, 0);
  const std::vector<std::string> text = lines(content(folder_ / "opened.off"));
  std::istringstream counts(text.at(1));
  std::size_t vertices, faces;
  counts >> vertices >> faces;
  // Two sheets, with twice the vertices on the path.
  ASSERT_EQ(idt("geodesic sheet.off --from 1 --to 23 --stats s.json").status, 0);
  const std::size_t segments = json::parse(content(folder_ / "s.json")).at("segments").get<std::size_t>();
  EXPECT_GT(faces, 32u);
  EXPECT_EQ(vertices, 25 + 2 * (segments + 1) - 3); // three vertices of the sheet lie on it
  EXPECT_NE(idt("geodesic opened.off --from 0 --to 24").status, 0);
}

TEST_F(Geodesic_command, needs_no_squares_of_lengths)
{
  write("large.off", "OFF\n4 2 0\n0 0 0\n1e300 0 0\n1e300 1e300 0\n0 1e300 0\n3 0 1 2\n3 0 2 3\n");
  for (const char* option : {"", " --shortest"}) {
    ASSERT_EQ(idt(std::string("geodesic large.off --from 1 --to 3 --stats s.json") + option).status, 0);
    EXPECT_NEAR(json::parse(content(folder_ / "s.json")).at("length").get<double>() / 1e300, std::sqrt(2.), 1e-14);
  }
}

TEST_F(Geodesic_command, to_itself_is_an_empty_path)
{
  write_sheet("sheet.off");
  for (const char* option : {"", " --shortest"}) {
    ASSERT_EQ(idt(std::string("geodesic sheet.off --from 7 --to 7 -o p.csv --stats s.json") + option).status, 0);
    EXPECT_EQ(json::parse(content(folder_ / "s.json")).at("length"), 0);
    EXPECT_EQ(lines(content(folder_ / "p.csv")).size(), 1u);
  }
}

TEST_F(Geodesic_command, has_coordinates_in_triangles_of_zero_area)
{
  // The first triangle is flat: on its longest side, and within rounding of it.
  write("flat.off", "OFF\n6 4 0\n0 0 0\n2 0 0\n1 0 0\n1 1 0\n1 -1 0\n1.5 2 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n3 2 1 5\n");
  write("thin.off", "OFF\n5 3 0\n0 0 0\n.9 .3 0\n.3 .1 0\n.1 3 0\n.7 -2 0\n3 0 1 2\n3 0 1 3\n3 2 1 4\n");
  const std::vector<std::vector<std::array<double, 3>>> corners{
    {{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}, {1.5, 2, 0}},
    {{0, 0, 0}, {.9, .3, 0}, {.3, .1, 0}, {.1, 3, 0}, {.7, -2, 0}}};
  for (const std::size_t mesh : {0u, 1u}) {
    ASSERT_EQ(
      idt(mesh == 0 ? "geodesic flat.off --from 2 --to 0 -o p.csv" : "geodesic thin.off --from 3 --to 4 -o p.csv")
        .status,
      0);
    const std::vector<std::string> rows = lines(content(folder_ / "p.csv"));
    ASSERT_GT(rows.size(), 2u);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      std::vector<double> numbers;
      std::istringstream cells(rows[i]);
      for (std::string cell; std::getline(cells, cell, ',');)
        numbers.push_back(std::stod(cell));
      ASSERT_EQ(numbers.size(), 10u);
      for (std::size_t k = 0; k < 3; ++k) {
        double x = 0;
        for (std::size_t c = 0; c < 3; ++c)
          x += numbers[4 + c] * corners[mesh][std::size_t(numbers[1 + c])][k];
        EXPECT_NEAR(x, numbers[7 + k], 1e-14) << rows[i];
      }
    }
  }
}

TEST_F(Geodesic_command, goes_where_faces_of_zero_area_join_vertices)
{
  // A double pyramid: faces without area join its vertices 2 and 6, which are at the same place. In the other file, all
  // faces at vertex 0 have none.
  write("joined.off", "OFF\n8 12 0\n4 0 0\n0 0 0\n1 0 0\n2 0 0\n1 0 0\n2 0 1\n1 0 0\n1 0 1\n"
                      "3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 5\n3 0 5 6\n3 0 6 1\n"
                      "3 7 2 1\n3 7 3 2\n3 7 4 3\n3 7 5 4\n3 7 6 5\n3 7 1 6\n");
  write("wire.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n2 0 0\n1 1 0\n2 1 0\n3 2 0 1\n3 1 3 4\n");
  for (const bool is_joined : {true, false}) {
    const Command_run run = idt(std::string("geodesic --stats s.json ") +
                                (is_joined ? "joined.off --shortest --from 1 --to 4" : "wire.off --from 0 --to 1"));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(json::parse(content(folder_ / "s.json")).at("length").get<double>(), is_joined ? std::sqrt(5.) : 1,
                1e-14);
    EXPECT_TRUE(contains(run.out, "taken as they are")) << run.out;
  }
}

TEST_F(Geodesic_command, has_coordinates_in_triangles_of_every_size)
{
  for (const char* unit : {"e-170", "e0", "e160"}) {
    std::string file = "OFF\n5 3 0\n";
    for (const char* row : {"0 0 0", "0 0 1", "1 0 1", "-1 2 1", "-1 -2 1"}) {
      std::istringstream numbers(row);
      for (std::string x; numbers >> x;)
        file += x + unit + ' ';
      file += '\n';
    }
    write("fan.off", file + "3 0 1 2\n3 0 1 3\n3 1 0 4\n");
    ASSERT_EQ(idt("geodesic fan.off --from 2 --to 3 -o p.csv").status, 0) << unit;
    EXPECT_FALSE(contains(content(folder_ / "p.csv"), "nan") || contains(content(folder_ / "p.csv"), "inf")) << unit;
  }
}

TEST_F(Geodesic_command, refuses_what_makes_no_sense)
{
  write_sheet("sheet.off");
  for (const char* options :
       {"--from 0", "--from 0 --to 25", "--from 99 --to 1", "--from 0 --to 1 --direction 1 --length 1",
        "--from 0 --direction 1", "--from 0 --length 1", "--from 0 --direction nan --length 1",
        "--from 0 --direction 1 --length -1", "--from 0 --to 1 --closed", "--from 0,1 --to 1", "--from 0,1,x --to 1",
        "--from 0,1,2,3 --to 1", "--from 0 --via 3 --to 5 --closed --shortest", "--from 0,0,0 --direction 1 --length 1",
        "--from 0 --to 1 --cut c.stl", "--from 0 --to 1 -o path.txt", "--from 0 --to 1 -o sheet.off", "--to 1",
        "--from -1 --to 1"})
    EXPECT_EQ(idt(std::string("geodesic sheet.off ") + options).status, 2) << options;
  EXPECT_EQ(idt("geodesic missing.off --from 0 --to 1").status, 3);
  // The whole fan at a corner of the sheet is π/2.
  EXPECT_EQ(idt("geodesic sheet.off --from 0 --direction 1.6 --length 1").status, 3);
}

TEST_F(Geodesic_command, ends_on_a_curve)
{
  write("strip.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n");
  write("curve.csv", "x,y,z\n1.5,0,0\n1.25,1,0\n");
  const double distance = 1.5 / std::hypot(1, 0.25);
  for (const std::string from : {"0", "0,0,0"}) {
    const Command_run run = idt("geodesic strip.off --from " + from + " --to-curve curve.csv -o p.csv --stats s.json");
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "the path is shortest")) << run.out;
    EXPECT_NEAR(json::parse(content(folder_ / "s.json"))["length"].get<double>(), distance, 1e-12);
  }
  // Around a wall, to a corner of the curve, and to a vertex of the input.
  write("wall.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n");
  write("slit.csv", "x,y,z\n1.5,0,0\n1.5,0.25,0\n");
  ASSERT_EQ(idt("geodesic strip.off --from 0 --to-curve slit.csv --barrier wall.csv --stats s.json").status, 0);
  EXPECT_NEAR(json::parse(content(folder_ / "s.json"))["length"].get<double>(),
              std::hypot(0.75, 0.5) + std::hypot(0.75, 0.25), 1e-12);
  write("edge.csv", "x,y,z\n1,0,0\n2,0,0\n");
  ASSERT_EQ(idt("geodesic strip.off --from 0 --to-curve edge.csv --stats s.json").status, 0);
  EXPECT_NEAR(json::parse(content(folder_ / "s.json"))["length"].get<double>(), 1, 1e-12);
  ASSERT_EQ(idt("geodesic strip.off --from 1 --to-curve edge.csv --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["length"], 0);
  for (const std::string options : {"--to 1", "--via 1 --closed", "--direction 1 --length 1"})
    EXPECT_EQ(idt("geodesic strip.off --from 0 --to-curve edge.csv " + options).status, 2) << options;
  EXPECT_NE(idt("geodesic strip.off --from 0 --to-curve missing.csv").status, 0);
}

TEST_F(Geodesic_command, walks_around_barriers)
{
  write("strip.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n");
  write("wall.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n");
  write("edge.csv", "1,4\n");
  for (const std::string options : {"", " --shortest"}) {
    const Command_run run =
      idt("geodesic strip.off --from 0 --to 2 --barrier wall.csv -o path.csv --stats s.json" + options);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(json::parse(content(folder_ / "s.json"))["length"].get<double>(),
                std::hypot(0.75, 0.5) + std::hypot(1.25, 0.5), 1e-12);
    EXPECT_TRUE(contains(content(folder_ / "path.csv"), ",0.75,0.5,0\n"));
  }
  ASSERT_EQ(idt("distance strip.off --source-curve path.csv -o d.csv").status, 0); // it lies on the input
  const Command_run cut = idt("geodesic strip.off --from 0 --to 2 --barrier-edges edge.csv");
  EXPECT_NE(cut.status, 0);
  const Command_run on_edge = idt("geodesic strip.off --from 0 --to 1 --barrier-edges edge.csv");
  EXPECT_EQ(on_edge.status, 2);
  EXPECT_TRUE(contains(on_edge.err, "vertex 1 lies on a barrier")) << on_edge.err;
  EXPECT_EQ(idt("geodesic strip.off --from 0 --direction 1 --length 1 --barrier wall.csv").status, 2);
}

} // namespace

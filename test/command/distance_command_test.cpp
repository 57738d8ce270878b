// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt distance`

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <cstring>
#include <limits>
#include <sstream>

namespace {

using nlohmann::json;

class Distance_command : public Command_test
{
protected:
  std::vector<double> distances(const std::string& name) const
  {
    const std::vector<std::string> rows = lines(content(folder_ / name));
    EXPECT_EQ(rows.at(0), "vertex,distance");
    std::vector<double> result;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      EXPECT_EQ(rows[i].substr(0, rows[i].find(',')), std::to_string(i - 1));
      result.push_back(std::stod(rows[i].substr(rows[i].find(',') + 1)));
    }
    return result;
  }
};

TEST_F(Distance_command, writes_a_table_and_statistics)
{
  write_kite("kite.off");
  const Command_run run = idt("distance kite.off --source 0,2 -o d.csv --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<double> d = distances("d.csv");
  ASSERT_EQ(d.size(), 4u);
  EXPECT_EQ(d[0], 0);
  EXPECT_EQ(d[2], 0);
  EXPECT_NEAR(d[1], std::hypot(1, 0.25), 0.1);
  EXPECT_NEAR(d[3], d[1], 1e-12);
  const json stats = json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["input"], "kite.off");
  EXPECT_EQ(stats["vertices"], 4);
  EXPECT_EQ(stats["sources"], json({0, 2}));
  EXPECT_EQ(stats["inserted"], 0);
  EXPECT_EQ(stats["unreachable"], 0);
  EXPECT_DOUBLE_EQ(stats["largest_distance"].get<double>(), std::max(d[1], d[3]));
  EXPECT_EQ(stats["status"], "done");
  EXPECT_TRUE(stats["time"].contains("distances"));
}

TEST_F(Distance_command, goes_along_the_edges_of_a_flat_spike)
{
  // All faces at vertex 3 lie on the x-axis, from its point -1 to 2.
  write("spike.off",
        "OFF\n5 6 0\n0 0 0\n2 0 0\n1 0 0\n-1 0 0\n1 1 1\n3 0 2 3\n3 2 1 3\n3 1 0 3\n3 0 1 4\n3 2 0 4\n3 1 2 4\n");
  for (const std::string method : {"", " --method exact"}) {
    ASSERT_EQ(idt("distance spike.off --source 4 -o d.csv" + method).status, 0);
    const std::vector<double> from_above = {std::sqrt(3.), std::sqrt(3.), std::sqrt(2.), 1 + std::sqrt(3.), 0};
    for (std::size_t v = 0; v < 5; ++v)
      EXPECT_NEAR(distances("d.csv")[v], from_above[v], 1e-12) << v;
    ASSERT_EQ(idt("distance spike.off --source 3 -o d.csv" + method).status, 0);
    const std::vector<double> from_tip = {1, 3, 2, 0, 1 + std::sqrt(3.)};
    for (std::size_t v = 0; v < 5; ++v)
      EXPECT_NEAR(distances("d.csv")[v], from_tip[v], 1e-12) << v;
    ASSERT_EQ(idt("distance spike.off --source 1,3 -o d.csv" + method).status, 0);
    const std::vector<double> from_both = {1, 0, 1, 0, std::sqrt(3.)};
    for (std::size_t v = 0; v < 5; ++v)
      EXPECT_NEAR(distances("d.csv")[v], from_both[v], 1e-12) << v;
  }
  // A wire between two triangles, of faces without area.
  write("wire.off", "OFF\n8 4 0\n0 0 0\n0 1 0\n-1 0 0\n1 0 0\n3 0 0\n3 1 0\n4 0 0\n2 0 0\n"
                    "3 0 1 2\n3 4 5 6\n3 0 3 7\n3 3 7 4\n");
  ASSERT_EQ(idt("distance wire.off --source 2 -o d.csv").status, 0);
  EXPECT_NEAR(distances("d.csv")[6], 5, 1e-12);
}

TEST_F(Distance_command, takes_the_mesh_behind_its_options)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("distance --source 0 --source 2,3 kite.off --stats s.json").status, 0);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["sources"], json({0, 2, 3}));
}

TEST_F(Distance_command, writes_meshes_with_values)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("distance kite.off --source 0 -o d.csv").status, 0);
  ASSERT_EQ(idt("distance kite.off --source 0 -o d.ply").status, 0);
  ASSERT_EQ(idt("distance kite.off --source 0 -o d.vtp").status, 0);
  const std::vector<double> d = distances("d.csv");
  const std::string ply = content(folder_ / "d.ply");
  EXPECT_TRUE(contains(ply, "property double z\nproperty double distance\nelement face 2\n"));
  const std::size_t first = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), first + 4 * 32 + 2 * 13);
  for (std::size_t v = 0; v < 4; ++v) {
    double value;
    std::memcpy(&value, &ply[first + 32 * v + 24], sizeof value);
    EXPECT_EQ(value, d[v]);
  }
  const Command_run again = idt("triangulate d.ply");
  EXPECT_EQ(again.status, 0) << again.err;
  const std::vector<std::string> vtp = lines(content(folder_ / "d.vtp"));
  EXPECT_EQ(vtp.at(4), "<PointData Scalars=\"distance\">");
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_EQ(std::stod(vtp.at(6 + v)), d[v]);
}

// The kite is flat: the logarithmic map is a rotation, and a transported axis stays the same in the plane.
TEST_F(Distance_command, writes_vectors)
{
  write_kite("kite.off");
  for (const char* name : {"d.csv", "d.ply", "d.vtp"}) {
    const Command_run run = idt(std::string("distance kite.off --source 1 --cover none --vectors -o ") + name);
    ASSERT_EQ(run.status, 0) << run.err;
  }
  ASSERT_EQ(idt("distance kite.off --source 1,3 --cover none --vectors -o two.csv").status, 0);
  std::vector<std::array<double, 5>> rows;
  const std::vector<std::string> csv = lines(content(folder_ / "d.csv"));
  ASSERT_EQ(csv.at(0), "vertex,distance,axis_x,axis_y,axis_z,log_x,log_y");
  for (std::size_t v = 0; v < 4; ++v) {
    std::istringstream row(csv.at(1 + v));
    std::string cell;
    std::getline(row, cell, ',');
    std::getline(row, cell, ',');
    rows.emplace_back();
    for (double& x : rows.back()) {
      std::getline(row, cell, ',');
      x = std::stod(cell);
    }
  }
  const std::array<std::array<double, 2>, 4> points = {{{0, 0}, {1, -0.25}, {2, 0}, {1, 0.25}}};
  const std::complex<double> axis(rows[1][0], rows[1][1]);
  EXPECT_NEAR(std::abs(axis), 1, 1e-14);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_NEAR(rows[v][0], axis.real(), 1e-12);
    EXPECT_NEAR(rows[v][1], axis.imag(), 1e-12);
    EXPECT_EQ(rows[v][2], 0);
    const std::complex<double> log(rows[v][3], rows[v][4]),
      wanted(points[v][0] - points[1][0], points[v][1] - points[1][1]);
    EXPECT_LT(std::abs(log * axis - wanted), 1e-12) << v;
  }
  EXPECT_EQ(lines(content(folder_ / "two.csv")).at(0), "vertex,distance,axis_x,axis_y,axis_z");
  const std::string ply = content(folder_ / "d.ply");
  EXPECT_TRUE(
    contains(ply, "property double distance\nproperty double axis_x\nproperty double axis_y\nproperty double axis_z\n"
                  "property double log_x\nproperty double log_y\nelement face 2\n"));
  ASSERT_EQ(ply.size(), ply.find("end_header\n") + 11 + 4 * 72 + 2 * 13);
  for (std::size_t v = 0; v < 4; ++v) {
    double value;
    std::memcpy(&value, &ply[ply.find("end_header\n") + 11 + 72 * v + 56], sizeof value);
    EXPECT_EQ(value, rows[v][3]);
  }
  EXPECT_EQ(idt("triangulate d.ply").status, 0);
  const std::string vtp = content(folder_ / "d.vtp");
  EXPECT_TRUE(contains(vtp, "Name=\"axis\" NumberOfComponents=\"3\""));
  EXPECT_TRUE(contains(vtp, "Name=\"log\" NumberOfComponents=\"2\""));
  ASSERT_EQ(idt("sample one-vertex-torus -o t").status, 0);
  ASSERT_EQ(idt("distance t.gluing --source 0 --cover none --vectors -o t.csv").status, 0);
  EXPECT_EQ(lines(content(folder_ / "t.csv")).at(0), "vertex,distance,axis_x,axis_y,log_x,log_y");
}

// A strip of 10 by 1, cut in two: the sources are its lower side, or a point.
TEST_F(Distance_command, begins_at_points_edges_and_curves)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  write("edges.csv", "vertex,vertex\n1,0\n");
  write("curve.csv", "x,y,z\n0,0,0.5\n5,0,-0.25\n10,-3,0\n");
  write("points.csv", "input_face,b0,b1,b2\n0,0.5,0.5,0\n1,0,0,1\n");
  for (const std::string options : {"", " --cover none", " --method exact", " --cover none --method exact"}) {
    for (const std::string sources : {"--source-edges edges.csv", "--source-curve curve.csv"}) {
      const Command_run run = idt("distance strip.off " + sources + " -o d.csv --stats s.json" + options);
      ASSERT_EQ(run.status, 0) << run.err;
      const std::vector<double> d = distances("d.csv"), expected{0, 0, 1, 1};
      for (std::size_t v = 0; v < 4; ++v)
        EXPECT_NEAR(d[v], expected[v], 1e-14) << sources << options << v;
      EXPECT_EQ(contains(run.out, "up to 3 from the surface"), sources == "--source-curve curve.csv");
    }
    EXPECT_EQ(json::parse(content(folder_ / "s.json"))["largest_snap"], 3);
    ASSERT_EQ(idt("distance strip.off --source 2 --source-points points.csv --labels l.csv -o d.csv" + options).status,
              0);
    const std::vector<double> d = distances("d.csv");
    EXPECT_NEAR(d[0], 1, 1e-14);
    EXPECT_NEAR(d[1], 1, 1e-14);
    EXPECT_EQ(d[2], 0);
    EXPECT_EQ(d[3], 0);
    EXPECT_EQ(content(folder_ / "l.csv"), "vertex,source\n0,2\n1,0\n2,0\n3,2\n");
  }
  // The output of idt geodesic, from corner to corner.
  ASSERT_EQ(idt("geodesic strip.off --from 1 --to 3 -o path.csv").status, 0);
  ASSERT_EQ(idt("distance strip.off --source-curve path.csv -o d.csv --method exact").status, 0);
  EXPECT_NEAR(distances("d.csv")[0], 10 / std::sqrt(101.), 1e-14);
  EXPECT_NEAR(distances("d.csv")[1], 0, 1e-14);
  // Bad input.
  EXPECT_EQ(idt("distance strip.off").status, 2);
  EXPECT_EQ(idt("distance strip.off --source-edges edges.csv --method heat").status, 2);
  write("bad.csv", "0,2,1\n");
  const Command_run edges = idt("distance strip.off --source-edges bad.csv");
  EXPECT_NE(edges.status, 0);
  EXPECT_TRUE(contains(edges.err, "bad.csv, line 1: expected are two vertices")) << edges.err;
  write("bad.csv", "1,3\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-edges bad.csv").err, "no edge joins vertex 1 and vertex 3"));
  write("bad.csv", "1,2,3\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-points bad.csv").err, "the first line of such a table is"));
  write("bad.csv", "x,y,z\n1,2,nan\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-points bad.csv").err, "bad.csv, line 2: \"nan\" is no finite"));
  write("bad.csv", "input_face,b0,b1,b2\n7,1,0,0\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-points bad.csv").err, "there is no triangle 7"));
  EXPECT_TRUE(contains(idt("distance strip.off --cover none --source-points bad.csv").err, "there is no face 7"));
  EXPECT_NE(idt("distance strip.off --source-points missing.csv").status, 0);
}

TEST_F(Distance_command, has_a_sign_beside_a_curve_that_cuts_something_off)
{
  write("strip.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n");
  write("up.csv", "x,y,z\n0.75,0,0\n0.75,1,0\n");
  write("down.csv", "x,y,z\n0.75,1,0\n0.75,0,0\n");
  write("slit.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n");
  for (const std::string method : {"", " --method exact"}) {
    ASSERT_EQ(idt("distance strip.off --cover none --signed --source-curve up.csv -o left.csv" + method).status, 0);
    ASSERT_EQ(idt("distance strip.off --cover none --signed --source-curve down.csv -o right.csv" + method).status, 0);
    const std::vector<double> left = distances("left.csv"), right = distances("right.csv");
    for (std::size_t v = 0; v < 6; ++v) {
      EXPECT_NEAR(left[v], 0.75 - double(v % 3), 1e-14) << v;
      EXPECT_NEAR(right[v], double(v % 3) - 0.75, 1e-14) << v;
    }
  }
  const Command_run slit = idt("distance strip.off --cover none --signed --source-curve slit.csv");
  EXPECT_NE(slit.status, 0);
  EXPECT_TRUE(contains(slit.err, "does not separate")) << slit.err;
  EXPECT_EQ(idt("distance strip.off --signed --source-curve up.csv").status, 2);
  EXPECT_EQ(idt("distance strip.off --cover none --signed --source 0").status, 2);
}

TEST_F(Distance_command, is_infinite_where_no_source_is_connected)
{
  write("two.off", "OFF\n7 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n9 9 9\n3 0 1 2\n3 3 4 5\n");
  for (const char* cover : {"tufted", "none"}) {
    const Command_run run = idt(std::string("distance two.off --source 4 -o d.csv --stats s.json --cover ") + cover);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "unreachable       4 vertices")) << run.out;
    const std::vector<double> d = distances("d.csv");
    for (std::size_t v = 0; v < 7; ++v)
      EXPECT_EQ(d[v] < std::numeric_limits<double>::infinity(), v >= 3 && v < 6) << v;
    EXPECT_EQ(json::parse(content(folder_ / "s.json"))["unreachable"], 4);
  }
  ASSERT_EQ(idt("distance two.off --source 4 -o d.vtp").status, 0);
  EXPECT_FALSE(contains(content(folder_ / "d.vtp"), "inf"));
}

TEST_F(Distance_command, takes_any_triangles)
{
  write("fan.off", "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0.5\n-1 2 0.5\n-1 -2 0.5\n3 0 1 2\n3 0 1 3\n3 1 0 4\n");
  ASSERT_EQ(idt("distance fan.off --source 2 -o d.csv").status, 0);
  const std::vector<double> d = distances("d.csv");
  EXPECT_EQ(d[2], 0);
  EXPECT_NEAR(d[3], d[4], 1e-9);
  EXPECT_GT(d[3], d[0]);
  EXPECT_EQ(idt("distance fan.off --source 2 --cover none").status, 3);
  const Command_run repaired = idt("distance fan.off --source 2 --cover none --repair -o r.csv");
  EXPECT_EQ(repaired.status, 0) << repaired.err;
  EXPECT_GT(distances("r.csv").size(), d.size()); // cut where three faces meet
  EXPECT_TRUE(contains(repaired.out, ", on the repaired surface, which was cut (3 new border edges")) << repaired.out;
}

TEST_F(Distance_command, leads_from_each_page_of_a_book_to_each)
{
  write("book.off", "OFF\n6 4 0\n0 0 0\n0 0 1\n1 0 0.5\n0 1 0.5\n-1 0 0.5\n0 -1 0.5\n"
                    "3 0 1 2\n3 0 1 3\n3 0 1 4\n3 0 1 5\n");
  for (const char* const method : {"", " --method exact"}) {
    ASSERT_EQ(idt(std::string("distance book.off --source 2 -o d.csv") + method).status, 0);
    for (std::size_t v : {3, 4, 5})
      EXPECT_NEAR(distances("d.csv")[v], 2, 1e-15) << method;
  }
  const Command_run by_heat = idt("distance book.off --source 2 --method heat -o d.csv --compare-exact --stats s.json");
  ASSERT_EQ(by_heat.status, 0) << by_heat.err;
  EXPECT_NEAR(json::parse(content(folder_ / "s.json"))["error"]["largest"].get<double>(), distances("d.csv")[4] / 2 - 1,
              1e-12);
  EXPECT_TRUE(
    contains(idt("distance book.off --source 2 --method heat").out, "too long across 1 edge with more than two faces"));
}

TEST_F(Distance_command, refinement_gives_more_accurate_distances_at_the_vertices_of_the_input)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n20 0 0\n20 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  ASSERT_EQ(idt("distance strip.off --source 0 --cover none --refine -o d.csv --stats s.json").status, 0);
  const std::vector<double> d = distances("d.csv");
  ASSERT_EQ(d.size(), 4u);
  EXPECT_NEAR(d[2], std::hypot(20, 1), 0.02 * 20);
  EXPECT_GT(json::parse(content(folder_ / "s.json"))["inserted"], 0);
}

TEST_F(Distance_command, boundary_conditions_differ)
{
  ASSERT_EQ(idt("sample disk-with-spike -o disk").status, 0);
  std::vector<std::vector<double>> results;
  for (const std::string boundary : {"neumann", "dirichlet", "average"}) {
    ASSERT_EQ(idt("distance disk.off --source 7 --cover none -o d.csv --boundary " + boundary).status, 0);
    results.push_back(distances("d.csv"));
  }
  EXPECT_NE(results[0], results[1]);
  EXPECT_NE(results[0], results[2]);
  EXPECT_NE(results[1], results[2]);
}

// A plane polygon without inner vertices, the worst mesh for heat.
TEST_F(Distance_command, methods_and_their_errors)
{
  std::ostringstream off;
  off.precision(17);
  off << "OFF\n64 62 0\n";
  for (int i = 0; i < 64; ++i)
    off << std::cos(i * std::acos(-1.) / 32) << ' ' << std::sin(i * std::acos(-1.) / 32) << " 0\n";
  for (int i = 1; i < 63; ++i)
    off << "3 0 " << i << ' ' << i + 1 << '\n';
  write("polygon.off", off.str());
  const auto largest_error = [&](const std::string& options) {
    const Command_run run = idt("distance polygon.off --source 0 -o d.csv --compare-exact --stats s.json " + options);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "accuracy          mean error ")) << run.out;
    const json error = json::parse(content(folder_ / "s.json"))["error"];
    EXPECT_LE(error["mean"], error["largest"]);
    const std::vector<double> d = distances("d.csv");
    double result = 0;
    for (int i = 1; i < 64; ++i) {
      const double exact = 2 * std::sin(i * std::acos(-1.) / 64);
      result = std::max(result, std::abs(d[std::size_t(i)] / exact - 1));
    }
    EXPECT_NEAR(error["largest"].get<double>(), result, 1e-10);
    return result;
  };
  EXPECT_LT(largest_error("--method exact"), 1e-12);
  EXPECT_LT(largest_error(""), 0.01);
  EXPECT_LT(largest_error("--method approximate"), 0.01);
  // Heat is far off, but in a convex plane the bounds of all distances are exact.
  EXPECT_LT(largest_error("--method heat"), 1e-10);
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["warnings"].size(), 1u);
  EXPECT_GT(json::parse(content(folder_ / "s.json"))["bounded"], 3);
  const Command_run by_heat = idt("distance polygon.off --source 0 --method heat");
  EXPECT_TRUE(contains(by_heat.out, "poor: see the warning") && contains(by_heat.err, "omit --method heat"))
    << by_heat.err;
  EXPECT_TRUE(
    contains(idt("distance polygon.off --source 0 --method exact").out, "accuracy          exact up to rounding\n"));
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["method"], "heat");
}

TEST_F(Distance_command, refuses_what_makes_no_sense)
{
  write_kite("kite.off");
  for (const char* const options :
       {"", "--source 4", "--source -1", "--source 0 --boundary average", "--source 0 --method exact --time 1",
        "--source 0 --cover none --method exact --boundary average", "--source 0 --method best", "--source 0 --refine",
        "--source 0 --repair", "--source 0 --time 0", "--source 0 --time nan", "--source 0 -o d.txt",
        "--source 0 -o d.csv --vectors", "--source 0 --cover none --vectors", "--source 0 -o kite.off",
        "--source 0 --cover two"}) {
    const Command_run run = idt(std::string("distance kite.off ") + options);
    EXPECT_EQ(run.status, 2) << options;
    EXPECT_NE(run.err, "") << options;
    EXPECT_EQ(run.out, "") << options;
  }
  write("empty.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n");
  const Command_run run = idt("distance empty.off --source 0");
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.err.substr(0, 16), "idt: empty.off: ");
  ASSERT_EQ(idt("sample one-vertex-torus -o t").status, 0);
  EXPECT_EQ(idt("distance t.gluing --source 0 -o t.ply").status, 2);
  EXPECT_EQ(idt("distance t.gluing --source 0 -o t.csv").status, 0);
}

} // namespace

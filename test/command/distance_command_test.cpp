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
  EXPECT_EQ(idt("distance strip.off --source-edges edges.csv --method heat --labels l.csv").status, 2);
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
  const Command_run no_face = idt("distance strip.off --source-points bad.csv");
  EXPECT_EQ(no_face.status, 3);
  EXPECT_TRUE(contains(no_face.err, "there is no triangle 7")) << no_face.err;
  EXPECT_TRUE(contains(idt("distance strip.off --cover none --source-points bad.csv").err, "there is no face 7"));
  EXPECT_EQ(idt("distance strip.off --source-points missing.csv").status, 3);
  write("bad.csv", "x,y,z\n1,2,3,4\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-points bad.csv").err, "line 2: there are 3 names and 4 cells"));
  for (const char* text : {"", "x,y,z\n", "x,y,z\n1,0,0\nx,y,z\n"}) {
    write("bad.csv", text);
    EXPECT_EQ(idt("distance strip.off --source-points bad.csv").status, 3) << text;
    EXPECT_NE(idt("distance strip.off --source-curve bad.csv").status, 0) << text;
  }
  write("bad.csv", "vertex,vertex\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source-edges bad.csv").err, "no pair of vertices"));
}

TEST_F(Distance_command, has_a_sign_beside_a_curve_that_cuts_something_off)
{
  write("strip.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n");
  write("up.csv", "x,y,z\n0.75,0,0\n0.75,1,0\n");
  write("down.csv", "x,y,z\n0.75,1,0\n0.75,0,0\n");
  write("slit.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n");
  for (const std::string method : {"", " --method exact", " --method heat"}) {
    ASSERT_EQ(idt("distance strip.off --signed --source-curve up.csv -o left.csv" + method).status, 0);
    ASSERT_EQ(idt("distance strip.off --signed --source-curve down.csv -o right.csv" + method).status, 0);
    const std::vector<double> left = distances("left.csv"), right = distances("right.csv");
    for (std::size_t v = 0; v < 6; ++v) {
      EXPECT_NEAR(left[v], 0.75 - double(v % 3), 1e-14) << v;
      EXPECT_NEAR(right[v], double(v % 3) - 0.75, 1e-14) << v;
    }
  }
  const Command_run slit = idt("distance strip.off --signed --source-curve slit.csv");
  EXPECT_NE(slit.status, 0);
  EXPECT_TRUE(contains(slit.err, "does not separate")) << slit.err;
  write("rim.csv", "x,y,z\n0,0,0\n2,0,0\n");
  write("point.csv", "x,y,z\n0.75,0.5,0\n0.75,0.5,0\n");
  EXPECT_EQ(idt("distance strip.off --signed --source-curve rim.csv").err,
            "idt: strip.off: rim.csv: nothing lies to the right of the curve, which follows the border: distances have "
            "no sign\n");
  EXPECT_EQ(idt("distance strip.off --signed --source-curve point.csv").err,
            "idt: strip.off: point.csv: the curve has no length, and therefore no sides, so distances have no sign\n");
  // Several curves.
  write("two.csv", "x,y,z\n0.75,0,0\n0.75,1,0\nx,y,z\n1.5,1,0\n1.5,0,0\n");
  ASSERT_EQ(idt("distance strip.off --signed --source-curve two.csv -o outside.csv").status, 0);
  const std::vector<double> outside = distances("outside.csv");
  for (std::size_t v = 0; v < 6; ++v)
    EXPECT_NEAR(outside[v], std::abs(double(v % 3) - 1.125) - 0.375, 1e-14) << v;
  write("same.csv", "x,y,z\n0.75,0,0\n0.75,1,0\nx,y,z\n1.5,0,0\n1.5,1,0\n");
  EXPECT_EQ(idt("distance strip.off --signed --source-curve same.csv").err,
            "idt: strip.off: same.csv: the same points lie to the left of curve 1 and to the right of curve 0 (counted "
            "from 0), so distances have no sign: reverse one of the curves\n");
  write("slits.csv", "x,y,z\n0.75,0,0\n0.75,1,0\nx,y,z\n1.5,0,0\n1.5,0.5,0\n");
  EXPECT_EQ(
    idt("distance strip.off --signed --source-curve slits.csv").err,
    "idt: strip.off: slits.csv: curve 1 (counted from 0) does not separate left sides from right ones, so distances "
    "have no sign: curves have to be closed, or to lead from border to border, and to cut something off together\n");
  EXPECT_EQ(idt("distance strip.off --signed --refine --source-curve up.csv").status, 2);
  EXPECT_EQ(idt("distance strip.off --signed --source 0").status, 2);
  // Beside a barrier, whose vertices lie on either side of the curve.
  write("across.csv", "x,y,z\n0.5,0.5,0\n1.5,0.5,0\n");
  write("ends.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n0.75,1,0\n");
  const std::string beside = "distance strip.off --signed --source-curve ends.csv --barrier across.csv ";
  ASSERT_EQ(idt(beside + "-o left.csv --overlay o.ply --isolines 0.125,-0.125,-0.5 --lines l.csv").status, 0);
  for (std::size_t v = 0; v < 6; ++v)
    EXPECT_NEAR(distances("left.csv")[v], 0.75 - double(v % 3), 1e-12) << v;
  for (const std::string& row : lines(content(folder_ / "l.csv")))
    if (row.substr(0, 4) != "line") {
      std::vector<double> cells;
      std::istringstream text(row);
      for (std::string cell; std::getline(text, cell, ',');)
        cells.push_back(std::stod(cell));
      EXPECT_NEAR(0.75 - cells.at(8), cells.at(11), 1e-3) << row;
    }
}

// A path over triangles, one of which has zero area and cuts its neighbor.
TEST_F(Distance_command, takes_curves_and_points_where_triangles_have_no_area)
{
  write(
    "soup.off",
    "OFF\n7 6 0\n0 0 0\n2 0 0\n1 2 0\n1 0 0\n1 -2 0\n-1 1 0\n3 1 0\n3 0 1 2\n3 0 3 1\n3 0 4 3\n3 3 4 1\n3 0 2 5\n3 2 1 "
    "6\n");
  ASSERT_EQ(idt("geodesic soup.off --from 5 --to 6 -o path.csv").status, 0);
  write("flat.csv", "input_face,b0,b1,b2\n1,0.5,0.25,0.25\n");
  for (const std::string method : {"", " --method heat"}) {
    ASSERT_EQ(idt("distance soup.off --source-curve path.csv -o path_distances.csv" + method).status, 0);
    EXPECT_NEAR(distances("path_distances.csv").at(3), 1, method.empty() ? 1e-12 : 0.1);
    ASSERT_EQ(idt("distance soup.off --source-points flat.csv -o flat_distances.csv" + method).status, 0);
    EXPECT_NEAR(distances("flat_distances.csv").at(0), 0.75, 1e-12); // a corner of its face
  }
}

// Three pages at a spine.
TEST_F(Distance_command, leads_a_curve_from_page_to_page)
{
  write("book.off", "OFF\n5 3 0\n0 0 0\n0 0 1\n1 0 0.5\n-1 2 0.5\n-1 -2 0.5\n3 0 1 2\n3 0 1 3\n3 1 0 4\n");
  write("stops.csv", "x,y,z\n0.5,0,0.5\n-0.25,0.5,0.5\n");
  write("in_faces.csv", "input_face,b0,b1,b2\n0,0.25,0.25,0.5\n1,0.375,0.375,0.25\n");
  for (const std::string curve : {"stops.csv", "in_faces.csv"})
    for (const std::string method : {"", " --method exact", " --method heat"}) {
      const Command_run run = idt("distance book.off -o d.csv --source-curve " + curve + method);
      ASSERT_EQ(run.status, 0) << run.err;
      const std::vector<double> d = distances("d.csv"), expected{0.5, 0.5, 0.5, 0.75 * std::sqrt(5.), std::sqrt(5.)};
      for (std::size_t v = 0; v < 5 && method != " --method heat"; ++v)
        EXPECT_NEAR(d[v], expected[v], 1e-12) << curve << method << v;
    }
  // The path that idt geodesic writes.
  ASSERT_EQ(idt("geodesic book.off --from 2 --to 3 -o path.csv").status, 0);
  ASSERT_EQ(idt("distance book.off --source-curve path.csv --method exact -o d.csv").status, 0);
  EXPECT_NEAR(distances("d.csv")[0], 0.5, 1e-14);
  EXPECT_NEAR(distances("d.csv")[4], std::sqrt(5.), 1e-14);
  write("two.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n3 0 1 2\n3 3 4 5\n");
  write("apart.csv", "x,y,z\n0,0,0\n0.5,0.2,0\n5.2,0.2,0\n");
  for (const std::string options : {"", " --cover none"})
    EXPECT_EQ(idt("distance two.off --source-curve apart.csv" + options).err,
              "idt: two.off: apart.csv, line 4: no path leads here from the point before: the curve leaves its "
              "component\n");
}

TEST_F(Distance_command, writes_a_matrix_between_two_sets)
{
  write("two.off", "OFF\n7 3 0\n0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n1 1 0\n3 0 1 2\n3 3 4 5\n3 1 6 2\n");
  write("from.csv", "vertex\n3\n0\n");
  write("to.csv", "6\n5\n");
  for (const std::string options : {"", " --cover none", " --method exact"}) {
    const Command_run run = idt("distance two.off --source 2 --source-vertices from.csv --target 1 --target-vertices "
                                "to.csv --matrix m.csv --stats s.json" +
                                options);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(run.out, "unreachable       4 pairs")) << run.out;
    const std::vector<std::string> rows = lines(content(folder_ / "m.csv"));
    ASSERT_EQ(rows.size(), 4u);
    EXPECT_EQ(rows[0], "source,1,6,5");
    EXPECT_EQ(rows[1].substr(0, 9), "2,1.41421");
    EXPECT_EQ(rows[2], "3,inf,inf,1");
    EXPECT_EQ(rows[3].substr(0, 11), "0,1,1.41421");
    const json stats = json::parse(content(folder_ / "s.json"));
    EXPECT_EQ(stats["sources"], json({2, 3, 0}));
    EXPECT_EQ(stats["targets"], json({1, 6, 5}));
  }
  ASSERT_EQ(idt("distance two.off --source 3,0 --target 4,1,0 --matrix m.mtx").status, 0);
  EXPECT_EQ(content(folder_ / "m.mtx"), "%%MatrixMarket matrix array real general\n% lengths of shortest paths\n2 3\n"
                                        "1\ninf\ninf\n1\ninf\n0\n");
  for (const std::string options : {"--matrix m.csv", "--target 1", "--target 1 --matrix m.off",
                                    "--target 1 --matrix m.csv -o d.csv", "--target 1 --matrix m.csv --method heat",
                                    "--target 1 --matrix m.csv --source-edges to.csv", "--target 7 --matrix m.csv"})
    EXPECT_EQ(idt("distance two.off --source 0 " + options).status, 2) << options;
  write("bad.csv", "1\n2,3\n");
  EXPECT_TRUE(
    contains(idt("distance two.off --source-vertices bad.csv").err, "bad.csv, line 2: expected is one vertex"));
}

// A wall across most of a strip of squares.
TEST_F(Distance_command, walks_around_barriers)
{
  write("strip.off", "OFF\n6 4 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n3 0 1 4\n3 0 4 3\n3 1 2 5\n3 1 5 4\n");
  write("wall.csv", "x,y,z\n0.75,0,0\n0.75,0.5,0\n");
  write("edge.csv", "1,4\n");
  const double around = std::hypot(0.75, 0.5) + std::hypot(1.25, 0.5);
  for (const std::string options : {"", " --method exact"}) {
    const Command_run run = idt("distance strip.off --source 0 --barrier wall.csv -o d.csv --stats s.json" + options);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NEAR(distances("d.csv")[2], around, 1e-12);
    EXPECT_NEAR(distances("d.csv")[3], 1, 1e-12);
    EXPECT_EQ(json::parse(content(folder_ / "s.json"))["barriers"], json({"wall.csv", ""}));
    ASSERT_EQ(idt("distance strip.off --source 0,5 --barrier-edges edge.csv --labels l.csv -o d.csv" + options).status,
              0);
    EXPECT_EQ(distances("d.csv")[1], 1);
    EXPECT_EQ(content(folder_ / "l.csv"), "vertex,source\n0,0\n1,0\n2,1\n3,0\n4,1\n5,1\n");
  }
  write("edge.csv", "1\t 4\n"); // as for --constraints
  ASSERT_EQ(idt("distance strip.off --source 0 --barrier-edges edge.csv -o d.csv").status, 0);
  EXPECT_EQ(distances("d.csv")[2], std::numeric_limits<double>::infinity());
  ASSERT_EQ(idt("distance strip.off --source 1 --barrier-edges edge.csv -o d.csv --method heat").status, 0);
  EXPECT_EQ(distances("d.csv")[1], 0);
  EXPECT_TRUE(std::isfinite(distances("d.csv")[2]) && std::isfinite(distances("d.csv")[0]));
  // What else there is, on the cut surface.
  for (const std::string options :
       {"--refine", "--maximum-change 0.01", "--overlay o.ply --view p.html", "--vectors"}) {
    const Command_run run = idt("distance strip.off --source 0 --barrier wall.csv -o d.csv " + options);
    ASSERT_EQ(run.status, 0) << run.err;
    const std::vector<std::string> rows = lines(content(folder_ / "d.csv"));
    ASSERT_EQ(rows.size(), 7u);
    EXPECT_NEAR(std::stod(rows[3].substr(2)), around, 1e-12) << options;
  }
  EXPECT_TRUE(contains(content(folder_ / "o.ply"), "element vertex 15")) << content(folder_ / "o.ply");
  ASSERT_EQ(idt("distance strip.off --source 1,0 --target 2,1,3 --barrier-edges edge.csv --matrix m.csv").status, 0);
  EXPECT_EQ(content(folder_ / "m.csv").substr(0, 27), "source,2,1,3\n1,1,0,1.414213");
  EXPECT_TRUE(contains(content(folder_ / "m.csv"), "\n0,inf,1,1\n")) << content(folder_ / "m.csv");
  const Command_run vectors = idt("distance strip.off --source 1 --barrier-edges edge.csv --vectors -o v.csv");
  EXPECT_EQ(vectors.status, 2);
  EXPECT_TRUE(contains(vectors.err, "vertex 1 lies on a barrier")) << vectors.err;
  const Command_run far = idt("distance strip.off --source 0 --barrier wall.csv --farthest 2 --samples s.csv");
  EXPECT_EQ(far.status, 2);
  EXPECT_TRUE(contains(far.err, "has a distance on each of its sides")) << far.err;
  write("cross.csv", "x,y,z\n0.55,0.25,0\n1,0.25,0\n\nx,y,z\n0.75,0,0\n0.75,1,0\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source 0 --barrier cross.csv").err, "cross"));
  write("bad.csv", "0,5\n");
  EXPECT_TRUE(contains(idt("distance strip.off --source 0 --barrier-edges bad.csv").err, "no edge joins"));
}

// A strip of 10 by 1, cut in two.
TEST_F(Distance_command, writes_lines_at_distances_and_between_cells)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  write("edges.csv", "1,0\n");
  const std::string edges = "distance strip.off --source-edges edges.csv --method exact ";
  const Command_run run = idt(edges + "--isolines 0.5,0.25 --lines l.csv --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.out, "lines             2 isolines")) << run.out;
  EXPECT_EQ(json::parse(content(folder_ / "s.json"))["isolines"]["lines"], 2);
  std::vector<std::string> rows = lines(content(folder_ / "l.csv"));
  EXPECT_EQ(rows.at(0), "line,face,vertex_0,vertex_1,vertex_2,coordinate_0,coordinate_1,coordinate_2,x,y,z,distance");
  ASSERT_GE(rows.size(), 5u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    std::vector<double> cells;
    std::istringstream row(rows[i]);
    for (std::string cell; std::getline(row, cell, ',');)
      cells.push_back(std::stod(cell));
    ASSERT_EQ(cells.size(), 12u);
    EXPECT_EQ(cells[11], cells[0] == 0 ? 0.25 : 0.5);
    EXPECT_NEAR(cells[9], cells[11], 1e-14);
  }
  // Each line of the table is a curve, from which distances can be measured.
  ASSERT_EQ(idt("distance strip.off --source-curve l.csv --labels n.csv -o d.csv --method exact").status, 0);
  EXPECT_EQ(content(folder_ / "n.csv"), "vertex,source\n0,0\n1,0\n2,1\n3,1\n");
  EXPECT_NEAR(distances("d.csv")[0], 0.25, 1e-14);
  EXPECT_NEAR(distances("d.csv")[2], 0.5, 1e-14);
  // On either side of a curve.
  write("up.csv", "x,y,z\n4,0,0\n4,1,0\n");
  ASSERT_EQ(idt("distance strip.off --signed --source-curve up.csv --isolines -2,1 --lines l.obj").status, 0);
  const std::string obj = content(folder_ / "l.obj");
  EXPECT_TRUE(contains(obj, "g distance_-2\nv ")) << obj;
  EXPECT_TRUE(contains(obj, "g distance_1\nv ")) << obj;
  ASSERT_EQ(idt("distance strip.off --signed --source-curve up.csv --isoline-step 2 --lines l.csv").status, 0);
  EXPECT_TRUE(contains(content(folder_ / "l.csv"), ",-6\n"));
  EXPECT_FALSE(contains(content(folder_ / "l.csv"), ",-8\n"));
  // Between cells.
  ASSERT_EQ(idt("distance strip.off --source 0,1 --borders b.csv --method exact").status, 0);
  rows = lines(content(folder_ / "b.csv"));
  EXPECT_EQ(rows.at(0).substr(rows[0].size() - 24), ",x,y,z,source_0,source_1");
  EXPECT_TRUE(contains(rows.at(1), ",5,")) << rows[1];
  EXPECT_EQ(rows[1].substr(rows[1].size() - 4), ",0,1");
  ASSERT_EQ(idt("distance strip.off --source 0,1 --borders b.vtp --isolines 1 --view page.html").status, 0);
  EXPECT_TRUE(contains(content(folder_ / "b.vtp"), "Name=\"source_1\""));
  EXPECT_TRUE(contains(content(folder_ / "page.html"), "the isolines and borders"));
  // No line crosses a barrier.
  write("wall.csv", "x,y,z\n5,0,0\n5,1,0\n");
  const std::string walled = "distance strip.off --source 0 --barrier wall.csv --method exact --lines l.csv ";
  ASSERT_EQ(idt(walled + "--isolines 3").status, 0);
  EXPECT_TRUE(contains(lines(content(folder_ / "l.csv")).at(1), ",3")) << content(folder_ / "l.csv");
  EXPECT_TRUE(contains(idt(walled + "--isolines 9").err, "no line has the distance 9: the vertex farthest from"));
  const std::string beside = "distance strip.off --signed --source-curve up.csv --lines l.csv --isolines ";
  EXPECT_TRUE(contains(idt(beside + "7").err,
                       "no line has the distance 7: the vertex farthest to the left of the curve "
                       "has 4"));
  EXPECT_TRUE(contains(idt(beside + "1,-7").err, "no line has the distance -7: the vertex farthest to the right of the "
                                                 "curve has -6"));
  // However near.
  for (const std::string d : {"1e-9", "1e-13", "1e-17"}) {
    ASSERT_EQ(idt("distance strip.off --source 1 --method exact --lines l.csv --isolines " + d).status, 0);
    EXPECT_GE(lines(content(folder_ / "l.csv")).size(), 3u) << d;
  }
  // Bad input.
  const auto message = [&](const std::string& options, int status) {
    const Command_run bad = idt(edges + options);
    EXPECT_EQ(bad.status, status) << options;
    return bad.err;
  };
  EXPECT_TRUE(contains(message("--isolines 0.5", 2), "--isolines needs --lines or --view"));
  EXPECT_TRUE(contains(message("--isolines 0 --lines l.csv", 2), "0 is the distance of the sources themselves"));
  EXPECT_TRUE(contains(message("--isolines nan --lines l.csv", 2), "nan is no finite distance"));
  EXPECT_TRUE(contains(message("--isolines=-1 --lines l.csv", 2), "the right side of a curve needs --signed"));
  EXPECT_TRUE(contains(message("--isolines 7 --lines l.csv", 2), "no line has the distance 7"));
  EXPECT_TRUE(contains(message("--isolines 0.5 --lines l.stl", 2), "ends in .csv, .vtp or .obj"));
  EXPECT_TRUE(contains(message("--isoline-step 0 --lines l.csv", 2), "S is a positive number"));
  EXPECT_TRUE(
    contains(message("--isoline-step 1e-9 --lines l.csv", 2), "give a larger one, 10,000 steps are the most"));
  EXPECT_TRUE(contains(idt("distance strip.off --source 0 --isoline-step 4e-3 --lines l.csv --method exact "
                           "--chord-tolerance 1e-9")
                         .err,
                       "of the distances would do, or a chord tolerance"));
  EXPECT_TRUE(contains(message("--isolines 0.5 --lines l.csv --chord-tolerance 0", 2), "T is a positive number"));
  EXPECT_TRUE(
    contains(idt("distance strip.off --source 0 --isolines 1 --lines l.csv --method heat").err, "omit --method heat"));
  EXPECT_TRUE(contains(message("--isolines 0.5 --lines l.csv -o l.csv", 2), "l.csv"));
}

TEST_F(Distance_command, chooses_vertices_far_from_each_other)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  for (const std::string cover : {"", " --cover none"}) {
    const Command_run run = idt("distance strip.off --source 3 --farthest 9 --samples s.csv" + cover);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_TRUE(contains(content(folder_ / "s.csv"), "vertex,distance\n1,10.0498756")) << content(folder_ / "s.csv");
    EXPECT_TRUE(contains(content(folder_ / "s.csv"), "\n0,1\n2,1\n"));
  }
  EXPECT_EQ(idt("distance strip.off --source 3 --farthest 9").status, 2);
  EXPECT_EQ(idt("distance strip.off --source 3 --farthest 0 --samples s.csv").status, 2);
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

TEST_F(Distance_command, names_the_line_of_a_bad_place)
{
  write("strip.off", "OFF\n4 2 0\n0 0 0\n10 0 0\n10 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n");
  const std::string in_face = "input_face,b0,b1,b2\n0,1,0,0\n",
                    on_path = "face,vertex_0,vertex_1,vertex_2,coordinate_0,coordinate_1,coordinate_2\n"
                              "0,0,1,2,0.2,0.3,0.5\n";
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
         {in_face + "0,-1,1,1\n", "barycentric coordinates are not negative, and their sum is positive"},
         {in_face + "0,0,0,0\n", "barycentric coordinates are not negative, and their sum is positive"},
         {in_face + "7,1,0,0\n", "there is no "},
         {on_path + "7,0,1,2,1,0,0\n", "there is no "},
         {on_path + "1,0,2,1,1,0,0\n", "face 1 has other vertices"},
         {on_path + "1,0,2,3,0.2,0.3,0.5\n", "the point does not lie in the face of the point before, face 0"}}) {
    write("bad.csv", text);
    for (const std::string cover : {"", " --cover none"}) {
      const std::string err = idt("distance strip.off --source-curve bad.csv" + cover).err;
      EXPECT_TRUE(contains(err, "idt: strip.off: bad.csv, line 3: " + expected)) << text << err;
    }
  }
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

// The second point lies on an edge that a flip gives, up to rounding: the face beside it is a sliver, through which the
// path was not found, and the curve went along edges, by way of a vertex.
TEST_F(Distance_command, joins_points_in_space_by_straight_lines)
{
  write("square.off",
        "OFF\n9 8 0\n0 0 0\n0 .5 0\n0 1 0\n.5 0 0\n0.3693434757117272 0.618195863432808 0\n.5 1 0\n1 0 0\n1 .5 0\n"
        "1 1 0\n3 0 3 4\n3 0 4 1\n3 1 4 5\n3 1 5 2\n3 3 6 7\n3 3 7 4\n3 4 7 8\n3 4 8 5\n");
  for (const char* curve : {"x,y,z\n.5,.125,0\n.125,.375,0\n", "x,y,z\n.125,.375,0\n.5,.125,0\n"}) {
    write("curve.csv", curve);
    ASSERT_EQ(idt("distance square.off --method exact --source-curve curve.csv -o d.csv").status, 0);
    EXPECT_NEAR(distances("d.csv")[3], 0.125, 1e-12);
    EXPECT_NEAR(distances("d.csv")[6], std::hypot(0.5, 0.125), 1e-12);
  }
  // On an edge of the input that is flipped.
  write("kite.off", "OFF\n4 2 0\n0 0 0\n2 0 0\n1 .3 0\n1 -.3 0\n3 0 1 2\n3 0 3 1\n");
  write("curve.csv", "x,y,z\n.5,0,0\n1.5,0,0\n");
  ASSERT_EQ(idt("distance kite.off --method exact --source-curve curve.csv -o d.csv").status, 0);
  EXPECT_NEAR(distances("d.csv")[1], 0.5, 1e-12);
  EXPECT_NEAR(distances("d.csv")[2], 0.3, 1e-12);
  // Several curves, each as if it were alone.
  write("curve.csv", "x,y,z\n.5,0,0\n1.5,0,0\nx,y,z\n1,-.3,0\n0,0,0\nx,y,z\n1,.1,0\n1,.3,0\n");
  ASSERT_EQ(idt("distance kite.off --method exact --source-curve curve.csv --labels n.csv -o d.csv").status, 0);
  EXPECT_NEAR(distances("d.csv")[1], 0.5, 1e-12);
  EXPECT_EQ(content(folder_ / "n.csv"), "vertex,source\n0,1\n1,0\n2,2\n3,1\n");
}

} // namespace

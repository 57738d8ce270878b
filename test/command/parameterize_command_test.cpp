// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt parameterize`, and the matrices that `idt triangulate` writes.

#include "Command_test.h"

#include <Eigen/Dense>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

class Parameterize_command : public Command_test
{
protected:
  void write_disk(const std::string& sample = "disk-with-spike") const
  {
    ASSERT_EQ(idt("sample " + sample + " -o disk").status, 0);
  }

  Json run(const std::string& options) const
  {
    const Command_run result = idt("parameterize disk.off --json p.json " + options);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(content(folder_ / "p.json"));
  }
};

// The contents of an OBJ file.
struct Textured_mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<double, 2>> uv;
  // The corners of each face: point and position in the texture, from 0.
  std::vector<std::vector<std::array<std::size_t, 2>>> faces;
};

Textured_mesh read_obj(const std::string& text)
{
  Textured_mesh mesh;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      auto& [x, y, z] = mesh.points.emplace_back();
      words >> x >> y >> z;
    } else if (word == "vt") {
      auto& [u, v] = mesh.uv.emplace_back();
      words >> u >> v;
    } else if (word == "f") {
      auto& corners = mesh.faces.emplace_back();
      std::size_t point = 0, uv = 0;
      char slash = 0;
      while (words >> point >> slash >> uv)
        corners.push_back({point - 1, uv - 1});
      EXPECT_TRUE(words.eof()) << line;
    }
  }
  return mesh;
}

// The largest triangle in the fan of a face: its sides from the first corner in space and in the texture, as columns.
struct Sides
{
  Eigen::Matrix<double, 3, 2> in_space;
  Eigen::Matrix2d in_texture;
};

Sides largest_sides(const Textured_mesh& mesh, std::size_t face)
{
  const auto& corners = mesh.faces[face];
  const auto point = [&](std::size_t i) { return Eigen::Vector3d(mesh.points[corners[i][0]].data()); };
  const auto uv = [&](std::size_t i) { return Eigen::Vector2d(mesh.uv[corners[i][1]].data()); };
  Sides best{Eigen::Matrix<double, 3, 2>::Zero(), Eigen::Matrix2d::Zero()};
  double largest = -1;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    Sides sides;
    sides.in_space << point(i - 1) - point(0), point(i) - point(0);
    sides.in_texture << uv(i - 1) - uv(0), uv(i) - uv(0);
    const double area = sides.in_space.col(0).cross(sides.in_space.col(1)).norm();
    if (area > largest) {
      largest = area;
      best = sides;
    }
  }
  return best;
}

// The ratio of the singular values of the map from one triangle to the other.
double distortion(const Sides& sides)
{
  const Eigen::Matrix<double, 3, 2> q =
    sides.in_space.householderQr().householderQ() * Eigen::Matrix<double, 3, 2>::Identity();
  const Eigen::Matrix2d in_plane = q.transpose() * sides.in_space;
  const Eigen::Vector2d values =
    Eigen::JacobiSVD<Eigen::Matrix2d>(sides.in_texture * in_plane.inverse()).singularValues();
  return values[0] / values[1];
}

// The area of the image, where flipped triangles count as negative.
double image_area(const Textured_mesh& mesh)
{
  double area = 0;
  for (const auto& corners : mesh.faces)
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto &p = mesh.uv[corners[i][1]], &q = mesh.uv[corners[(i + 1) % corners.size()][1]];
      area += (p[0] * q[1] - q[0] * p[1]) / 2;
    }
  return area;
}

std::size_t flipped_faces(const Textured_mesh& mesh)
{
  std::size_t flipped = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    flipped += largest_sides(mesh, f).in_texture.determinant() < 0;
  return flipped;
}

using Matrix_command = Command_test;

struct Matrix
{
  std::size_t rows = 0;
  std::map<std::pair<std::size_t, std::size_t>, double> entries; // from 1, both triangles
};

Matrix read_matrix(const std::string& text)
{
  Matrix matrix;
  std::istringstream in(text);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "%%MatrixMarket matrix coordinate real symmetric");
  while (in.peek() == '%')
    std::getline(in, line);
  std::size_t columns = 0, number = 0;
  in >> matrix.rows >> columns >> number;
  EXPECT_EQ(columns, matrix.rows);
  for (std::size_t k = 0; k < number; ++k) {
    std::size_t i = 0, j = 0;
    double value = 0;
    in >> i >> j >> value;
    EXPECT_GE(i, j);
    matrix.entries[{i, j}] = matrix.entries[{j, i}] = value;
  }
  EXPECT_TRUE(bool(in));
  return matrix;
}

TEST_F(Parameterize_command, ConformalMapsAreCertifiedAndWritten)
{
  write_disk("bumpy-dome");
  for (const std::string boundary : {"free", "disk", "angles"}) {
    const std::string cones = boundary == "angles" ? " --cones 3" : "";
    const Json json =
      run("--method conformal --uv uv.obj --uv-input in.obj --distortion d.csv --boundary " + boundary + cones);
    EXPECT_EQ(json["certified"], true);
    EXPECT_EQ(json["turned"], 0);
    EXPECT_LT(double(json["residual"]), 1e-10);
    EXPECT_EQ(json["cones"].size(), boundary == "angles" ? 3u : 0u);
    const Textured_mesh mesh = read_obj(content(folder_ / "uv.obj"));
    EXPECT_EQ(mesh.faces.size(), std::size_t(json["triangles"]));
    for (const auto& face : mesh.faces) {
      const auto uv = [&](std::size_t i, std::size_t k) { return (long double)(mesh.uv[face[i][1]][k]); };
      EXPECT_GT((uv(1, 0) - uv(0, 0)) * (uv(2, 1) - uv(0, 1)) - (uv(1, 1) - uv(0, 1)) * (uv(2, 0) - uv(0, 0)), 0);
    }
    const Textured_mesh on_input = read_obj(content(folder_ / "in.obj"));
    EXPECT_EQ(on_input.faces.size(), std::size_t(json["faces"]));
    EXPECT_LT(on_input.uv.size(), on_input.faces.size()) << "triangles that fit together refer to the same points";
    // The distortion of the triangles in the file, from their corners; of tiny ones, only rounding is seen.
    const std::vector<std::string> rows = lines(content(folder_ / "d.csv"));
    ASSERT_EQ(rows.size(), mesh.faces.size() + 1);
    EXPECT_EQ(rows[0], "input_face,distortion,area_scale");
    double size = 0;
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      size = (std::max)(size, std::abs(largest_sides(mesh, f).in_texture.determinant()));
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      if (std::abs(largest_sides(mesh, f).in_texture.determinant()) > 1e-3 * size) {
        std::istringstream row(rows[f + 1].substr(rows[f + 1].find(',') + 1));
        double ratio = 0;
        row >> ratio;
        EXPECT_NEAR(ratio, distortion(largest_sides(mesh, f)), 1e-6 * ratio) << f;
      }
    EXPECT_LT(double(json["mean_distortion"]), 1.3);
    EXPECT_GE(double(json["mean_distortion"]), 1);
    EXPECT_GE(double(json["percentile_99_area_scale"]), double(json["mean_area_scale"]));
  }
  std::ofstream(folder_ / "corners.csv") << "vertex,angle\n409,1.5707963267948966\n415,1.5707963267948966\n"
                                            "421,1.5707963267948966\n427,1.5707963267948966\n";
  const Json square = run("--method conformal --boundary-angles corners.csv");
  EXPECT_EQ(square["boundary"], "angles");
  EXPECT_EQ(square["certified"], true);
  EXPECT_EQ(square["cones"].size(), 0u) << "the angles of a square need no cone";
  EXPECT_NE(idt("parameterize disk.off --method conformal --cone-angles corners.csv").err.find("is on the border"),
            std::string::npos);
  EXPECT_EQ(idt("sample bumpy-sphere -o sphere.off").status, 0);
  std::ofstream(folder_ / "cones.csv")
    << "vertex,angle\n3,3.141592653589793\n40,3.141592653589793\n900,3.141592653589793\n"
       "2000,3.141592653589793\n";
  ASSERT_EQ(idt("parameterize sphere.off --method conformal --cone-angles cones.csv --stats s.json").status, 0);
  EXPECT_EQ(Json::parse(content(folder_ / "s.json"))["cones"].size(), 4u);
  std::ofstream(folder_ / "cones.csv") << "vertex,angle\n3,3\n";
  const Command_run refused = idt("parameterize sphere.off --method conformal --cone-angles cones.csv");
  EXPECT_NE(refused.status, 0);
  EXPECT_NE(refused.err.find("Gauss and Bonnet"), std::string::npos) << refused.err;
  const Command_run too_few = idt("parameterize sphere.off --method conformal --cones 1");
  EXPECT_NE(too_few.status, 0);
  EXPECT_TRUE(contains(too_few.err, "choose 3 cones or more")) << too_few.err;
  std::ofstream(folder_ / "cones.csv") << "vertex,angle\n3,nan\n";
  EXPECT_NE(idt("parameterize sphere.off --method conformal --cone-angles cones.csv").err.find("no finite number"),
            std::string::npos);
  ASSERT_EQ(idt("refine disk.off --minimum-angle 25 --save refined.idt").status, 0);
  EXPECT_TRUE(
    contains(idt("parameterize refined.idt --method conformal").err, "inserted into a surface with a border"));
  for (const char* wrong :
       {"--cones 3", "--method conformal --cones 3 --cone-angles cones.csv", "--method conformal --laplacian extrinsic",
        "--boundary free", "--method conformal --boundary natural", "--boundary-angles corners.csv",
        "--method conformal --boundary disk --boundary-angles corners.csv"})
    EXPECT_EQ(idt("parameterize sphere.off " + std::string(wrong)).status, 2) << wrong;
}

} // namespace

TEST_F(Parameterize_command, maps_a_disk_in_each_way)
{
  write_disk();
  const Json intrinsic = run("--laplacian intrinsic --boundary disk"),
             extrinsic = run("--laplacian extrinsic --boundary disk"), natural = run("--boundary natural");
  for (const Json& json : {intrinsic, natural}) {
    EXPECT_EQ(json["over_intrinsic"]["flipped"], 0);
    EXPECT_EQ(json["over_intrinsic"]["collapsed"], 0);
    EXPECT_EQ(json["weights_after"]["negative_weights"], 0);
    EXPECT_GT(json["weights_before"]["negative_weights"], 0);
    EXPECT_GE(json["over_intrinsic"]["mean_distortion"], 1);
  }
  EXPECT_NE(intrinsic["over_input"], extrinsic["over_input"]);
  EXPECT_EQ(extrinsic["laplacian"], "extrinsic");
  EXPECT_EQ(natural["boundary"], "natural");
}

// On the dome the extrinsic operator has large negative weights.
TEST_F(Parameterize_command, only_the_extrinsic_operator_flips_triangles_of_the_dome)
{
  write_disk("bumpy-dome");
  for (const char* boundary : {"--boundary disk", "--boundary natural"}) {
    const Json extrinsic = run(std::string("--laplacian extrinsic ") + boundary),
               intrinsic = run(std::string("--laplacian intrinsic ") + boundary);
    EXPECT_GT(extrinsic["over_input"]["flipped"], 0);
    EXPECT_EQ(intrinsic["over_intrinsic"]["flipped"], 0);
    EXPECT_EQ(intrinsic["over_intrinsic"]["collapsed"], 0);
    EXPECT_LT(intrinsic["over_intrinsic"]["mean_distortion"], 1.5);
    EXPECT_GT(extrinsic["over_input"]["mean_distortion"], 2);
  }
}

// The distortion of each face, measured in the files, is that of the promised map.
TEST_F(Parameterize_command, writes_the_map_over_both_triangulations)
{
  write_disk("bumpy-dome");
  const Json json = run("--uv overlay.obj --uv-input input.obj --distortion d.csv");
  ASSERT_EQ(idt("triangulate disk.off --stats s.json").status, 0);
  const Json counts = Json::parse(content(folder_ / "s.json"));
  const Textured_mesh overlay = read_obj(content(folder_ / "overlay.obj")),
                      input = read_obj(content(folder_ / "input.obj"));
  EXPECT_EQ(input.points.size(), 433u);
  EXPECT_EQ(input.faces.size(), 840u);
  EXPECT_EQ(overlay.points.size(), 433u + counts["crossings"].get<std::size_t>());
  EXPECT_TRUE(std::equal(input.points.begin(), input.points.end(), overlay.points.begin()));
  EXPECT_TRUE(std::equal(input.uv.begin(), input.uv.end(), overlay.uv.begin()));
  for (const auto& [u, v] : overlay.uv)
    EXPECT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1) << u << ' ' << v;

  // Both cover the same disk, and only one covers it once.
  EXPECT_NEAR(image_area(overlay), image_area(input), 1e-12);
  EXPECT_EQ(flipped_faces(overlay), 0u);
  EXPECT_EQ(flipped_faces(input), json["over_input"]["flipped"].get<std::size_t>());
  EXPECT_GT(flipped_faces(input), 0u);

  const std::vector<std::string> rows = lines(content(folder_ / "d.csv"));
  ASSERT_EQ(rows.at(0), "input_face,intrinsic_face,over_input,over_intrinsic");
  ASSERT_EQ(rows.size(), 1 + overlay.faces.size());
  std::size_t measured = 0;
  for (std::size_t f = 0; f < overlay.faces.size(); ++f) {
    std::size_t input_face = 0, intrinsic_face = 0;
    double over_input = 0, over_intrinsic = 0;
    ASSERT_EQ(
      std::sscanf(rows[1 + f].c_str(), "%zu,%zu,%lf,%lf", &input_face, &intrinsic_face, &over_input, &over_intrinsic),
      4)
      << rows[1 + f];
    const Sides sides = largest_sides(overlay, f);
    if (sides.in_space.col(0).cross(sides.in_space.col(1)).norm() < 1e-6)
      continue; // too small to be measured
    ++measured;
    EXPECT_NEAR(distortion(sides), over_intrinsic, 1e-6 * over_intrinsic) << rows[1 + f];
    EXPECT_NEAR(distortion(largest_sides(input, input_face)), over_input, 1e-6 * over_input) << rows[1 + f];
  }
  EXPECT_GT(measured, 0.9 * double(overlay.faces.size()));

  for (const std::string name : {"overlay", "input"}) {
    EXPECT_TRUE(contains(content(folder_ / (name + ".obj")), "mtllib " + name + ".mtl"));
    EXPECT_TRUE(contains(content(folder_ / (name + ".mtl")), "map_Kd " + name + ".png"));
    EXPECT_EQ(content(folder_ / (name + ".png")).substr(1, 3), "PNG");
  }
}

TEST_F(Parameterize_command, says_what_is_wrong)
{
  ASSERT_EQ(idt("sample torus -o torus").status, 0);
  const Command_run closed = idt("parameterize torus.off");
  EXPECT_EQ(closed.status, 3);
  EXPECT_TRUE(contains(closed.err, "torus.off: a map to the plane needs a disk")) << closed.err;
  EXPECT_TRUE(contains(closed.err, "; --method conformal takes any surface")) << closed.err;
  EXPECT_EQ(closed.out, "");
  write_disk();
  for (const char* options :
       {"--boundary square", "--laplacian both", "--method none", "--uv x.obj --json x.mtl", "--uv disk.off",
        "--uv x.ply", "--uv x.obj --uv-input x.obj", "--uv x.obj --distortion x.png"})
    EXPECT_EQ(idt(std::string("parameterize disk.off ") + options).status, 2) << options;
  EXPECT_EQ(idt("parameterize disk.off --uv missing/x.obj").status, 1);
  EXPECT_EQ(files().size(), 2u); // the inputs
}

TEST_F(Parameterize_command, of_lengths_alone_has_distortion_but_no_picture)
{
  write("kite.gluing", "INTRINSIC_GLUING 1\n4 5 2\n0 1 2\n0 2 3\n0 -1 1\n1 -1 1\n2 3 1.8\n4 -1 1\n5 -1 1\n");
  for (const char* option : {"--uv", "--uv-input"}) {
    const Command_run run = idt(std::string("parameterize kite.gluing ") + option + " k.obj");
    EXPECT_EQ(run.status, 2);
    EXPECT_TRUE(contains(run.err, "kite.gluing has only lengths")) << run.err;
  }
  EXPECT_EQ(files(), std::vector<std::string>{"kite.gluing"});
  ASSERT_EQ(idt("parameterize kite.gluing --distortion d.csv").status, 0);
  EXPECT_EQ(lines(content(folder_ / "d.csv")).size(), 1u + 4u); // the diagonals cross
}

TEST_F(Matrix_command, stiffness_and_mass)
{
  write_kite("kite.off"); // corners (0,0), (1,-1/4), (2,0), (1,1/4): the edge 0-2 is flipped to 1-3
  ASSERT_EQ(idt("triangulate kite.off --laplacian l.mtx --mass m.mtx").status, 0);
  const Matrix l = read_matrix(content(folder_ / "l.mtx")), m = read_matrix(content(folder_ / "m.mtx"));
  EXPECT_EQ(l.rows, 4u);
  EXPECT_EQ(l.entries.count({1, 3}), 0u);
  // Opposite to 1-3 are angles with cotangent (1 - 1/16) / (1/2) at both ends.
  EXPECT_NEAR(l.entries.at({2, 4}), -1.875, 1e-14);
  for (std::size_t i = 1; i <= 4; ++i) {
    double sum = 0;
    for (std::size_t j = 1; j <= 4; ++j)
      sum += l.entries.count({i, j}) ? l.entries.at({i, j}) : 0;
    EXPECT_NEAR(sum, 0, 1e-14);
  }
  EXPECT_EQ(m.entries.size(), 4u);
  EXPECT_NEAR(m.entries.at({1, 1}), 0.25 / 3, 1e-15); // one face of area 1/4
  EXPECT_NEAR(m.entries.at({2, 2}), 0.5 / 3, 1e-15);  // two of them
}

TEST_F(Matrix_command, a_face_without_area_has_no_Laplacian)
{
  write("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n1 -1 0\n3 0 1 2\n3 1 0 3\n");
  const Command_run run = idt("triangulate flat.off --laplacian l.mtx");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "has zero area")) << run.err;
  EXPECT_EQ(files(), std::vector<std::string>{"flat.off"});
}

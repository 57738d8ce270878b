// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt parameterize`, and the matrices that `idt triangulate` writes.

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
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
  // A disk of 1,000 vertices.
  void write_disk() const { ASSERT_EQ(idt("sample disk-with-spike -o disk").status, 0); }

  Json run(const std::string& options) const
  {
    const Command_run result = idt("parameterize disk.off --json p.json " + options);
    EXPECT_EQ(result.status, 0) << result.err;
    return Json::parse(content(folder_ / "p.json"));
  }
};

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

} // namespace

TEST_F(Parameterize_command, maps_a_disk_in_each_way)
{
  write_disk();
  const Json intrinsic = run("--laplacian intrinsic --boundary disk"),
             extrinsic = run("--laplacian extrinsic --boundary disk"), natural = run("--boundary natural"),
             pattern = run("--method circle-pattern");
  for (const Json& json : {intrinsic, natural, pattern}) {
    EXPECT_EQ(json["over_intrinsic"]["flipped"], 0);
    EXPECT_EQ(json["over_intrinsic"]["collapsed"], 0);
    EXPECT_EQ(json["weights_after"]["negative_weights"], 0);
    EXPECT_GT(json["weights_before"]["negative_weights"], 0);
    EXPECT_GE(json["over_intrinsic"]["mean_distortion"], 1);
  }
  EXPECT_NE(intrinsic["over_input"], extrinsic["over_input"]);
  EXPECT_EQ(extrinsic["laplacian"], "extrinsic");
  EXPECT_EQ(natural["boundary"], "natural");
  EXPECT_TRUE(natural["circle_pattern"].is_null());
  EXPECT_LE(pattern["circle_pattern"]["gradient"], 1e-10);
}

TEST_F(Parameterize_command, writes_a_textured_mesh)
{
  write_disk();
  run("--uv out.obj");
  std::size_t points = 0, textures = 0, faces = 0;
  std::istringstream in(content(folder_ / "out.obj"));
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    points += word == "v";
    faces += word == "f";
    if (word == "vt") {
      double u = -1, v = -1;
      words >> u >> v;
      EXPECT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1) << line;
      ++textures;
    }
  }
  EXPECT_EQ(points, 1001u);
  EXPECT_EQ(textures, 1001u);
  EXPECT_EQ(faces, 1960u);
  EXPECT_TRUE(contains(content(folder_ / "out.obj"), "mtllib out.mtl"));
  EXPECT_TRUE(contains(content(folder_ / "out.mtl"), "map_Kd out.png"));
  EXPECT_EQ(content(folder_ / "out.png").substr(1, 3), "PNG");
}

TEST_F(Parameterize_command, says_what_is_wrong)
{
  ASSERT_EQ(idt("sample torus -o torus").status, 0);
  const Command_run closed = idt("parameterize torus.off");
  EXPECT_EQ(closed.status, 3);
  EXPECT_TRUE(contains(closed.err, "torus.off: a map to the plane needs a disk")) << closed.err;
  EXPECT_EQ(closed.out, "");
  write_disk();
  for (const char* options :
       {"--method circle-pattern --boundary disk", "--boundary square", "--laplacian both",
        "--method none", "--uv x.obj --json x.mtl", "--uv disk.off"})
    EXPECT_EQ(idt(std::string("parameterize disk.off ") + options).status, 2) << options;
  EXPECT_EQ(idt("parameterize disk.off --uv missing/x.obj").status, 1);
  EXPECT_EQ(files().size(), 2u); // the inputs
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

TEST_F(Matrix_command, a_face_without_area_has_no_laplacian)
{
  write("flat.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n2 0 0\n1 -1 0\n3 0 1 2\n3 1 0 3\n");
  const Command_run run = idt("triangulate flat.off --laplacian l.mtx");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "has no area")) << run.err;
  EXPECT_EQ(files(), std::vector<std::string>{"flat.off"});
}

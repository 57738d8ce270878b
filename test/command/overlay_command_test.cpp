// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of `idt triangulate --overlay` and `--crossings`, read back.

#include "Command_test.h"

#include <CGAL/Intrinsic_triangulations/internal/overlay/Carried_properties.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/Surface_mesh/IO/PLY.h>
#include <CGAL/boost/graph/IO/OBJ.h>
#include <CGAL/squared_distance_3.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

using Json = nlohmann::json;

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

std::vector<std::string> fields(const std::string& line)
{
  std::vector<std::string> result;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, ',');)
    result.push_back(field);
  return result;
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

class Overlay_command : public Command_test
{
protected:
  // Two triangles whose long common edge is flipped: the new one meets it at x = 7/3.
  void write_oblique_kite() const { write("kite.off", "OFF\n4 2 0\n0 0 0\n8 0 0\n3 2 0\n2 -1 0\n3 0 1 2\n3 1 0 3\n"); }

  Mesh read(const std::string& name) const
  {
    Mesh mesh;
    const std::string path = (folder_ / name).string();
    std::ifstream in(path, std::ios::binary);
    const std::string extension = fs::path(path).extension().string();
    const bool is_read = extension == ".ply"   ? CGAL::IO::read_PLY(in, mesh)
                         : extension == ".off" ? CGAL::IO::read_OFF(in, mesh)
                                               : CGAL::IO::read_OBJ(in, mesh);
    EXPECT_TRUE(is_read) << name;
    return mesh;
  }

  std::vector<std::vector<std::string>> rows(const std::string& name) const
  {
    std::vector<std::vector<std::string>> result;
    for (const std::string& line : lines(content(folder_ / name)))
      result.push_back(fields(line));
    return result;
  }

  // The files of one run, compared with each other and with the input.
  void expect_consistent_files(const std::string& input_name) const
  {
    ASSERT_EQ(
      idt("triangulate " + input_name + " --overlay o.ply --crossings c.csv --edges e.csv --stats s.json").status, 0);
    const Mesh input = read(input_name), mesh = read("o.ply");
    const Json stats = Json::parse(content(folder_ / "s.json"));
    const std::size_t number_of_crossings = stats["crossings"];
    EXPECT_GE(stats["seconds"]["overlay"], 0);

    EXPECT_EQ(mesh.number_of_vertices(), input.number_of_vertices() + number_of_crossings);
    EXPECT_EQ(std::size_t(stats["euler_characteristic"].get<int>()),
              mesh.number_of_vertices() + mesh.number_of_faces() - mesh.number_of_edges());
    const auto kind = IT::internal::find_property_map<Mesh::Vertex_index, std::uint8_t>(mesh, "v:kind");
    const auto input_edge = IT::internal::find_property_map<Mesh::Vertex_index, std::int32_t>(mesh, "v:input_edge");
    const auto intrinsic_edge =
      IT::internal::find_property_map<Mesh::Vertex_index, std::int32_t>(mesh, "v:intrinsic_edge");
    ASSERT_TRUE(input_edge && intrinsic_edge);
    const auto crossings = rows("c.csv");
    // Edges are numbered as the faces of the file name them first.
    std::vector<std::set<std::size_t>> edges_of_input;
    std::istringstream file(content(folder_ / input_name));
    std::string skipped;
    for (std::size_t i = 0; i < 4 + 3 * input.number_of_vertices(); ++i)
      file >> skipped;
    for (std::size_t size, a, b, c; file >> size >> a >> b >> c;)
      for (const std::set<std::size_t>& edge : {std::set<std::size_t>{a, b}, {b, c}, {c, a}})
        if (std::find(edges_of_input.begin(), edges_of_input.end(), edge) == edges_of_input.end())
          edges_of_input.push_back(edge);
    const auto label = IT::internal::find_property_map<Mesh::Edge_index, std::uint8_t>(mesh, "e:label");
    const auto input_face = IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(mesh, "f:input_face");
    const auto intrinsic_face =
      IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(mesh, "f:intrinsic_face");
    ASSERT_TRUE(kind && label && input_face && intrinsic_face);
    for (auto v : mesh.vertices()) {
      EXPECT_EQ(kind[v] == 0, std::size_t(v) < input.number_of_vertices());
      if (kind[v] == 0) {
        EXPECT_EQ(mesh.point(v), input.point(v));
        EXPECT_EQ(input_edge[v], -1);
        EXPECT_EQ(intrinsic_edge[v], -1);
        continue;
      }
      // Its row of `--crossings`.
      const std::vector<std::string>& row = crossings.at(std::size_t(v) - input.number_of_vertices() + 1);
      EXPECT_EQ(std::to_string(intrinsic_edge[v]), row.at(2));
      EXPECT_EQ(edges_of_input.at(std::size_t(input_edge[v])),
                (std::set<std::size_t>{std::stoul(row.at(4)), std::stoul(row.at(5))}));
      std::string labels; // around a crossing, input and intrinsic edges take turns
      for (auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh))
        labels += char('0' + label[mesh.edge(h)]);
      EXPECT_TRUE(labels == "0101" || labels == "1010") << labels;
    }
    std::vector<double> covered(input.number_of_faces(), 0);
    std::set<std::uint32_t> intrinsic_faces;
    for (auto f : mesh.faces()) {
      covered.at(input_face[f]) += area(mesh, f);
      intrinsic_faces.insert(intrinsic_face[f]);
    }
    for (auto f : input.faces())
      EXPECT_NEAR(covered[f], area(input, f), 1e-12 * area(input, f));
    EXPECT_EQ(intrinsic_faces.size(), stats["faces"]);

    expect_right_crossings(input, mesh, number_of_crossings);
  }

  // The rows are the crossings in the order of the mesh. u is compared with the points, and t with
  // lengths: an intrinsic edge is as long as its segments, which are straight in space.
  void expect_right_crossings(const Mesh& input, const Mesh& mesh, std::size_t number_of_crossings) const
  {
    const auto edges = rows("e.csv"), crossings = rows("c.csv");
    EXPECT_EQ(lines(content(folder_ / "c.csv"))[0], "source,target,edge,position,input_source,input_target,t,u");
    ASSERT_EQ(crossings.size(), number_of_crossings + 1);
    std::map<std::size_t, std::size_t> count;
    double so_far = 0;
    for (std::size_t i = 1; i < crossings.size(); ++i) {
      const std::vector<std::string>& row = crossings[i];
      const std::size_t edge = std::stoul(row[2]), position = std::stoul(row[3]);
      EXPECT_EQ(row[0], edges.at(edge + 1)[0]);
      EXPECT_EQ(row[1], edges.at(edge + 1)[1]);
      EXPECT_EQ(position, count[edge]++);
      const double t = std::stod(row[6]), u = std::stod(row[7]);
      const auto point = [&](const std::string& v) { return input.point(Mesh::Vertex_index(std::stoul(v))); };
      const Point x = mesh.point(Mesh::Vertex_index(input.number_of_vertices() + i - 1));
      const Point p = point(row[4]), q = point(row[5]);
      EXPECT_LT(distance(x, CGAL::barycenter(p, 1 - u, q, u)), 1e-14 * (distance(p, q) + distance(p, Point(0, 0, 0))));
      const Point last =
        position == 0 ? point(row[0]) : mesh.point(Mesh::Vertex_index(input.number_of_vertices() + i - 2));
      so_far = (position == 0 ? 0 : so_far) + distance(last, x);
      const double length = std::stod(edges[edge + 1][2]);
      EXPECT_NEAR(so_far, t * length, 1e-11 * length);
    }
    for (std::size_t e = 0; e + 1 < edges.size(); ++e)
      EXPECT_EQ(std::to_string(count[e]), edges[e + 1][4]);
  }

  static double area(const Mesh& mesh, Mesh::Face_index f)
  {
    CGAL::Simple_cartesian<double>::Vector_3 sum(0, 0, 0);
    const Point p = mesh.point(mesh.target(mesh.halfedge(f)));
    for (auto h : CGAL::halfedges_around_face(mesh.halfedge(f), mesh))
      sum = sum + CGAL::cross_product(mesh.point(mesh.source(h)) - p, mesh.point(mesh.target(h)) - p);
    return std::sqrt(sum.squared_length()) / 2;
  }
};

} // namespace

TEST_F(Overlay_command, writes_the_kite)
{
  write_oblique_kite();
  for (const char* name : {"k.ply", "k.off", "k.obj"}) {
    ASSERT_EQ(idt(std::string("triangulate kite.off --crossings c.csv --overlay ") + name).status, 0);
    const Mesh mesh = read(name);
    EXPECT_EQ(mesh.number_of_vertices(), 5u);
    EXPECT_EQ(mesh.number_of_edges(), 8u);
    EXPECT_EQ(mesh.number_of_faces(), 4u);
    EXPECT_LT(distance(mesh.point(Mesh::Vertex_index(4)), Point(7. / 3, 0, 0)), 1e-15);
  }
  const auto crossings = rows("c.csv");
  ASSERT_EQ(crossings.size(), 2u);
  // From (2, -1) to (3, 2), which meets the old edge after a third.
  EXPECT_EQ(std::vector<std::string>(crossings[1].begin(), crossings[1].begin() + 6),
            (std::vector<std::string>{"3", "2", "0", "0", "0", "1"}));
  EXPECT_NEAR(std::stod(crossings[1][6]), 1. / 3, 1e-16);
  EXPECT_NEAR(std::stod(crossings[1][7]), 7. / 24, 1e-16);
  const Mesh mesh = read("k.ply");
  const auto label = IT::internal::find_property_map<Mesh::Edge_index, std::uint8_t>(mesh, "e:label");
  std::map<int, int> count;
  for (auto e : mesh.edges())
    ++count[label[e]];
  EXPECT_EQ(count, (std::map<int, int>{{0, 2}, {1, 2}, {2, 4}}));
}

TEST_F(Overlay_command, writes_files_that_agree)
{
  for (const std::string sample : {"bad-torus", "helical-tube", "disk-with-spike", "Schwarz-lantern"}) {
    ASSERT_EQ(idt("sample " + sample + " -o in.off").status, 0);
    expect_consistent_files("in.off");
  }
}

TEST_F(Overlay_command, writes_the_same_mesh_in_each_format)
{
  ASSERT_EQ(idt("sample bumpy-sphere -o in.off").status, 0);
  for (const char* name : {"o.ply", "o.off", "o.OBJ"})
    ASSERT_EQ(idt(std::string("triangulate in.off --overlay ") + name).status, 0);
  fs::rename(folder_ / "o.OBJ", folder_ / "o.obj");
  const Mesh ply = read("o.ply");
  for (const Mesh& mesh : {read("o.off"), read("o.obj")}) {
    ASSERT_EQ(mesh.number_of_faces(), ply.number_of_faces());
    for (auto v : ply.vertices())
      EXPECT_EQ(mesh.point(v), ply.point(v)); // bit for bit
    for (auto f : ply.faces()) {
      std::set<std::size_t> corners, same;
      for (auto v : CGAL::vertices_around_face(ply.halfedge(f), ply))
        corners.insert(v);
      for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
        same.insert(v);
      EXPECT_EQ(corners, same);
    }
  }
}

TEST_F(Overlay_command, cuts_its_faces_into_triangles)
{
  ASSERT_EQ(idt("sample helical-tube -o in.off").status, 0);
  for (const char* name : {"o.ply", "o.off", "o.obj", "o.stl", "o.ts"})
    ASSERT_EQ(idt(std::string("triangulate in.off --overlay-triangles --overlay ") + name).status, 0) << name;
  ASSERT_EQ(idt("triangulate in.off --overlay polygons.ply").status, 0);
  const Mesh mesh = read("o.ply"), polygons = read("polygons.ply");
  EXPECT_TRUE(CGAL::is_triangle_mesh(mesh));
  EXPECT_EQ(mesh.number_of_vertices(), polygons.number_of_vertices());
  std::size_t number_of_diagonals = 0;
  for (auto f : polygons.faces())
    number_of_diagonals += CGAL::halfedges_around_face(polygons.halfedge(f), polygons).size() - 3;
  EXPECT_GT(number_of_diagonals, 0u);
  EXPECT_EQ(mesh.number_of_faces(), polygons.number_of_faces() + number_of_diagonals);
  // Each pair of an input face and an intrinsic one covers as much as before.
  const auto areas = [](const Mesh& m) {
    const auto input_face = IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(m, "f:input_face");
    const auto intrinsic_face = IT::internal::find_property_map<Mesh::Face_index, std::uint32_t>(m, "f:intrinsic_face");
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> result;
    for (auto f : m.faces())
      result[{input_face[f], intrinsic_face[f]}] += area(m, f);
    return result;
  };
  const auto before = areas(polygons), after = areas(mesh);
  ASSERT_EQ(after.size(), before.size());
  for (const auto& [faces, size] : before)
    EXPECT_NEAR(after.at(faces), size, 1e-12 * size);
  for (const char* name : {"o.off", "o.obj"})
    EXPECT_EQ(read(name).number_of_faces(), mesh.number_of_faces()) << name;
  for (const char* name : {"o.stl", "o.ts"}) {
    const Command_run run = idt(std::string("laplacian --stats s.json ") + name);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(Json::parse(content(folder_ / "s.json"))["faces"], mesh.number_of_faces()) << name;
  }
  EXPECT_EQ(idt("triangulate in.off --overlay-triangles").status, 2);
}

TEST_F(Overlay_command, tells_inserted_vertices_from_those_of_the_input)
{
  ASSERT_EQ(idt("sample helical-tube -o in.off").status, 0);
  ASSERT_EQ(idt("refine in.off --overlay o.ply --stats s.json").status, 0);
  const Json stats = Json::parse(content(folder_ / "s.json"));
  const Mesh mesh = read("o.ply");
  const auto kind = IT::internal::find_property_map<Mesh::Vertex_index, std::uint8_t>(mesh, "v:kind");
  std::map<int, std::size_t> count;
  for (auto v : mesh.vertices())
    ++count[kind[v]];
  EXPECT_GT(count[2], 0u);
  EXPECT_EQ(count[2], stats["inserted"]);
  EXPECT_EQ(count[0], read("in.off").number_of_vertices());
}

TEST_F(Overlay_command, finds_the_crossings_of_Table_1)
{
  const fs::path horse = data_folder() / "table1" / "horse.off";
  if (!fs::exists(horse))
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  ASSERT_EQ(idt("triangulate '" + horse.string() + "' --crossings c.csv --overlay o.ply --stats s.json").status, 0);
  const Json stats = Json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["simple"], 3124);
  EXPECT_EQ(stats["longest"], 7);
  EXPECT_EQ(stats["crossings"], 4026);
  EXPECT_EQ(rows("c.csv").size(), 4027u);
  const Mesh mesh = read("o.ply");
  EXPECT_EQ(mesh.number_of_vertices() + mesh.number_of_faces(), mesh.number_of_edges() + 2);
}

TEST_F(Overlay_command, needs_points_for_a_mesh_but_not_for_crossings)
{
  ASSERT_EQ(idt("sample one-vertex-torus -o torus.gluing").status, 0);
  const Command_run run = idt("triangulate torus.gluing --overlay o.ply --edges e.csv");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "torus.gluing: --overlay needs a surface in space")) << run.err;
  EXPECT_EQ(files(), std::vector<std::string>{"torus.gluing"});
  ASSERT_EQ(idt("triangulate torus.gluing --crossings c.csv --stats s.json").status, 0);
  EXPECT_EQ(rows("c.csv").size(), 1 + Json::parse(content(folder_ / "s.json"))["crossings"].get<std::size_t>());
  EXPECT_GT(rows("c.csv").size(), 1u);

  write_oblique_kite();
  const Command_run mollified = idt("triangulate kite.off --mollify 0.9 --overlay o.ply");
  EXPECT_EQ(mollified.status, 3);
  EXPECT_TRUE(contains(mollified.err, "--mollify changed")) << mollified.err;
  // Parts that need no change keep their place.
  EXPECT_EQ(idt("triangulate kite.off --mollify 1e-9 --overlay o.ply").status, 0);
}

TEST_F(Overlay_command, refuses_a_wrong_command_line)
{
  write_oblique_kite();
  for (const char* arguments :
       {"kite.off --overlay o.stl", "kite.off --overlay o", "kite.off --overlay kite.off",
        "kite.off kite.off --overlay o.ply", "kite.off kite.off --crossings c.csv",
        "kite.off --overlay o.ply --crossings ./o.ply", "kite.off --edges c.csv --crossings c.csv",
        "kite.off --overlay ''", "kite.off --overlay o.ply --stats ''"}) {
    const Command_run run = idt(std::string("triangulate ") + arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_TRUE(contains(run.err, "--overlay") || contains(run.err, "kite.off") || contains(run.err, "same file") ||
                contains(run.err, "must not be empty"))
      << run.err;
  }
  EXPECT_EQ(files(), std::vector<std::string>{"kite.off"});
}

TEST_F(Overlay_command, works_with_number_types_that_are_not_exact)
{
  // Near ties, rounded decisions are wrong, but the result is a triangulation.
  ASSERT_EQ(idt("sample torus -o torus.off").status, 0);
  const Command_run run =
    idt("triangulate torus.off --number-type float --crossings c.csv --overlay o.ply --stats s.json");
  EXPECT_EQ(run.status, 4);
  EXPECT_FALSE(contains(run.err, "overlay")) << run.err;
  const Json stats = Json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(rows("c.csv").size(), 1 + stats["crossings"].get<std::size_t>());
  const Mesh mesh = read("o.ply");
  EXPECT_EQ(mesh.number_of_vertices() + mesh.number_of_faces(), mesh.number_of_edges());

  // Here a float takes a reflex corner for a convex one: no straight line is left in the hinge.
  write("reflex.off", "OFF\n4 2 0\n-0.801344 0 0\n1000000 0 0\n-0.89 1.87 0\n-0.77 -0.69 0\n"
                      "3 0 1 2\n3 1 0 3\n");
  const Command_run none = idt("triangulate reflex.off --number-type float --crossings d.csv --overlay p.ply");
  EXPECT_EQ(none.status, 4);
  EXPECT_TRUE(contains(none.err, "there is no overlay: edge 0")) << none.err;
  EXPECT_FALSE(fs::exists(folder_ / "d.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "p.ply"));
}

TEST_F(Overlay_command, leaves_nothing_behind_when_the_space_ends)
{
  ASSERT_EQ(idt("sample bad-torus -o torus.off").status, 0);
  for (const char* option : {"--overlay o.ply", "--overlay o.off", "--overlay o.obj", "--crossings c.csv"}) {
    const Command_run run = shell("ulimit -f 8; '" + command_path() + "' triangulate torus.off " + option);
    EXPECT_EQ(run.status, 1) << option;
    EXPECT_EQ(files(), std::vector<std::string>{"torus.off"});
  }
}

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `--repair`: without it, the message says that it would help; with it, the repairs are reported and the results belong
// to the repaired surface.

#include "Command_test.h"

#include <nlohmann/json.hpp>

namespace {

using Command_repair = Command_test;
using Json = nlohmann::json;

// A square pyramid: its base is a polygon, one face is turned over, one occurs twice, and vertex 5 is unused.
const char* const pyramid = "OFF\n6 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n7 7 7\n"
                            "4 3 2 1 0\n3 0 1 4\n3 1 4 2\n3 2 3 4\n3 3 0 4\n3 0 1 4\n";

} // namespace

TEST_F(Command_repair, is_offered_where_it_helps)
{
  write("pyramid.off", pyramid);
  const Command_run refused = idt("triangulate pyramid.off");
  EXPECT_EQ(refused.status, 3);
  EXPECT_TRUE(contains(refused.err, "face 0 (corners 3, 2, 1, 0) has 4 corners")) << refused.err;
  EXPECT_TRUE(contains(refused.err, "--repair")) << refused.err;
  write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n");
  EXPECT_FALSE(contains(idt("triangulate index.off").err, "--repair"));
  EXPECT_EQ(idt("triangulate index.off --repair").status, 3);
}

TEST_F(Command_repair, says_what_was_done_and_where_things_come_from)
{
  write("pyramid.off", pyramid);
  const Command_run run =
    idt("triangulate pyramid.off --repair --verify --repair-map m.csv --stats s.json --overlay o.ply");
  ASSERT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> said = lines(run.err);
  ASSERT_EQ(said.size(), 4u) << run.err;
  EXPECT_EQ(said[0], "idt: pyramid.off: repaired: face 5 was removed, as another face has the same corners");
  EXPECT_EQ(said[1], "idt: pyramid.off: repaired: face 0 (4 corners) was cut into triangles");
  EXPECT_EQ(said[2], "idt: pyramid.off: repaired: face 2 was turned over");
  EXPECT_EQ(said[3], "idt: pyramid.off: repaired: vertex 5 was dropped, as no face names it");

  const Json stats = Json::parse(content(folder_ / "s.json"));
  EXPECT_EQ(stats["status"], "done");
  EXPECT_EQ(stats["vertices"], 5);
  EXPECT_EQ(stats["boundary_edges"], 0);
  EXPECT_EQ(stats["repair"], Json::parse(R"([{"kind": "duplicate faces", "count": 1, "first": [5]},
    {"kind": "triangulated faces", "count": 1, "first": [0]},
    {"kind": "reversed faces", "count": 1, "first": [2]},
    {"kind": "dropped vertices", "count": 1, "first": [5]}])"));
  EXPECT_EQ(
    lines(content(folder_ / "m.csv")),
    (std::vector<std::string>{"element,index,input", "vertex,0,0", "vertex,1,1", "vertex,2,2", "vertex,3,3",
                              "vertex,4,4", "face,0,0", "face,1,0", "face,2,1", "face,3,2", "face,4,3", "face,5,4"}));

  ASSERT_EQ(idt("triangulate o.ply --repair --verify").status, 0);
}

TEST_F(Command_repair, is_an_option_of_each_command_that_reads)
{
  write("pyramid.off", pyramid);
  EXPECT_EQ(idt("table pyramid.off --repair").status, 0);
  EXPECT_EQ(idt("compare pyramid.off --repair --number-types double").status, 0);
  // Without its base, which nothing triangulates, the pyramid is a disk.
  write("disk.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n4 0 1 2 3\n3 2 1 4\n");
  EXPECT_EQ(idt("parameterize disk.off").status, 3);
  EXPECT_EQ(idt("parameterize disk.off --repair --uv uv.obj").status, 0);
}

TEST_F(Command_repair, stands_in_the_file_of_each_command_in_the_same_form)
{
  const auto json = [&] { return Json::parse(content(folder_ / "j.json")); };
  write("disk.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n4 0 1 2 3\n3 2 1 4\n");
  ASSERT_EQ(idt("triangulate disk.off --repair --stats j.json").status, 0);
  const Json expected = json()["repair"];
  ASSERT_EQ(expected, Json::parse(R"([{"kind": "triangulated faces", "count": 1, "first": [0]}])"));
  ASSERT_EQ(idt("parameterize disk.off --repair --json j.json").status, 0);
  EXPECT_EQ(json()["repair"], expected);
  ASSERT_EQ(idt("compare disk.off --repair --number-types double --json j.json").status, 0);
  EXPECT_EQ(json()["surfaces"][0]["repair"], expected);
  ASSERT_EQ(idt("table disk.off --repair --json j.json").status, 0);
  EXPECT_EQ(json()[0]["repair"], expected);

  write_kite("kite.off");
  for (const std::string option : {"", " --repair"}) {
    const Json nothing = option.empty() ? Json(nullptr) : Json::array();
    ASSERT_EQ(idt("parameterize kite.off --json j.json" + option).status, 0);
    EXPECT_EQ(json().at("repair"), nothing);
    ASSERT_EQ(idt("compare kite.off --number-types double --json j.json" + option).status, 0);
    EXPECT_EQ(json()["surfaces"][0].at("repair"), nothing);
    ASSERT_EQ(idt("table kite.off --json j.json" + option).status, 0);
    EXPECT_EQ(json()[0].at("repair"), nothing);
  }
}

// Warnings of a reader appear beside the repair.
TEST_F(Command_repair, stands_beside_the_warnings_of_the_reader)
{
  write("cut.stl", "solid\nfacet\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 2 0\nendfacet\n"
                   "facet\nvertex 2 0 0\nvertex 2 2 0\nvertex 0 2 0\nendfacet\n"
                   "facet\nvertex 0 0 0\nvertex 0 2 0\nvertex -2 1 0\nendfacet\n"
                   "facet\nvertex 0 0 0\nvertex -2 1 0\nvertex 0 -2 0\nendfacet\n"
                   "facet\nvertex 0 0 0\nvertex 0 -2 0\nvertex 2 0 0\nendfacet\n");
  const Json expected = {"the file ends without a line endsolid, behind facet 4: it may have been cut off"};
  const auto warnings = [&](const std::string& command, const char* place) {
    fs::remove(folder_ / "j.json");
    EXPECT_EQ(idt(command + " j.json").status, 0) << command;
    return Json::parse(content(folder_ / "j.json")).at(Json::json_pointer(place));
  };
  for (const char* const command :
       {"triangulate cut.stl --stats", "refine cut.stl --stats", "laplacian cut.stl --stats",
        "distance cut.stl --source 0 --stats", "distance cut.stl --source 0 --cover none --stats",
        "geodesic cut.stl --from 0 --to 3 --stats", "parameterize cut.stl --json"})
    EXPECT_EQ(warnings(command, "/warnings"), expected) << command;
  EXPECT_EQ(warnings("compare cut.stl --number-types double --json", "/surfaces/0/warnings"), expected);
  EXPECT_EQ(warnings("table cut.stl --without-condition --json", "/0/warnings"), expected);
  write_kite("kite.off");
  EXPECT_EQ(warnings("triangulate kite.off --stats", "/warnings"), Json::array());
}

TEST_F(Command_repair, says_what_is_lost_of_faces_that_were_cut)
{
  for (const char* triangle : {"1 2 3", "0 1 2"}) {
    write("q.off", std::string("OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 ") + triangle + "\n4 0 1 2 3\n");
    const Command_run run = idt("triangulate q.off --repair --stats s.json");
    ASSERT_EQ(run.status, 0) << run.err;
    const Json stats = Json::parse(content(folder_ / "s.json"));
    // One of the two diagonals makes the existing triangle.
    EXPECT_EQ(contains(run.err, "face 1 was removed in part"), stats["faces"] == 2) << run.err;
    EXPECT_EQ(contains(content(folder_ / "s.json"), "duplicate parts of faces"), stats["faces"] == 2);
  }
}

TEST_F(Command_repair, says_what_became_border)
{
  write("sheets.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 1 0 3\n3 0 1 4\n");
  const Command_run run = idt("triangulate sheets.off --repair --stats s.json");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(contains(run.err,
                       "edge 0-1 of face 0 became border: of its 3 faces, no other one was left that fits, and 2 more "
                       "edges like it"))
    << run.err;
  const Json repairs = Json::parse(content(folder_ / "s.json"))["repair"];
  EXPECT_EQ(repairs.back(), Json::parse(R"({"kind": "opened edges", "count": 3, "first": [0, 1, 2]})")) << repairs;
}

TEST_F(Command_repair, has_nothing_to_say_about_a_surface)
{
  write_kite("kite.off");
  const Command_run run = idt("triangulate kite.off --repair --stats s.json");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(Json::parse(content(folder_ / "s.json"))["repair"], Json::array());
  ASSERT_EQ(idt("triangulate kite.off --stats s.json").status, 0);
  EXPECT_EQ(Json::parse(content(folder_ / "s.json"))["repair"], nullptr);
}

TEST_F(Command_repair, needs_a_mesh)
{
  write("a.gluing", "INTRINSIC_GLUING 1\n3 3 1\n0 1 2\n0 -1 1\n1 -1 1\n2 -1 1\n");
  ASSERT_EQ(idt("triangulate a.gluing").status, 0);
  const Command_run run = idt("triangulate a.gluing --repair");
  EXPECT_EQ(run.status, 2);
  EXPECT_TRUE(contains(run.err, "a.gluing"));
  write_kite("kite.off");
  EXPECT_EQ(idt("triangulate kite.off --repair-map m.csv").status, 2);
}

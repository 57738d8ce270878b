// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Saved triangulations, and work that continues from them.

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <string>

namespace {

using Json = nlohmann::ordered_json;

class Saved_command : public Command_test
{
protected:
  Json json(const std::string& name) const { return Json::parse(content(folder_ / name)); }
};

// The files that a command writes for a saved triangulation equal those for its mesh.
TEST_F(Saved_command, is_as_good_as_the_mesh)
{
  for (const char* sample : {"prism", "bad-torus", "one-vertex-torus", "cap"}) {
    SCOPED_TRACE(sample);
    const std::string mesh = std::string(sample) == "one-vertex-torus" ? "m.gluing" : "m.off";
    ASSERT_EQ(idt("sample " + std::string(sample) + " -o " + mesh).status, 0);
    ASSERT_EQ(
      idt("triangulate " + mesh + " --save t.idt --edges e.csv --laplacian l.mtx --mass m.mtx --crossings c.csv")
        .status,
      0);
    const Command_run run = idt("triangulate t.idt --save again.idt --edges e2.csv --laplacian l2.mtx --mass m2.mtx "
                                "--crossings c2.csv --verify --stats s.json");
    ASSERT_EQ(run.status, 0) << run.err;
    for (const auto& [one, two] : {std::pair("e.csv", "e2.csv"), std::pair("l.mtx", "l2.mtx"),
                                   std::pair("m.mtx", "m2.mtx"), std::pair("c.csv", "c2.csv")})
      EXPECT_EQ(content(folder_ / one), content(folder_ / two)) << one;
    EXPECT_EQ(json("s.json")["flips"], 0);
    for (const char* command : {"laplacian t.idt --stiffness k.mtx", "distance t.idt --source 0 -o d.csv",
                                "table t.idt", "compare t.idt --number-types filtered,double"})
      if (mesh == "m.off" || std::string(command).find("distance") == std::string::npos) {
        EXPECT_EQ(idt(command).status, 0) << command;
      }
  }
}

TEST_F(Saved_command, is_read_from_the_standard_input)
{
  ASSERT_EQ(idt("sample torus -o m.off").status, 0);
  ASSERT_EQ(idt("triangulate m.off --save t.idt --edges e.csv").status, 0);
  const Command_run run = shell("'" + command_path() + "' triangulate - --edges e2.csv < t.idt");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(content(folder_ / "e.csv"), content(folder_ / "e2.csv"));
}

// A refinement continues: with another bound it does not begin anew, and constrained edges stay.
TEST_F(Saved_command, is_refined_further)
{
  ASSERT_EQ(idt("sample prism -o m.off").status, 0);
  ASSERT_EQ(idt("refine m.off --minimum-angle 15 --constrain-angle 30 --save t.idt --stats s.json").status, 0);
  const auto points = json("s.json")["inserted"].get<int>();
  const Command_run run = idt("refine t.idt --minimum-angle 25 --verify --stats s2.json --points p.csv --save u.idt");
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_GT(json("s2.json")["inserted"].get<int>(), points);
  EXPECT_EQ(json("s2.json")["kept_edges"], json("s.json")["kept_edges"]);
  EXPECT_EQ(idt("refine u.idt --minimum-angle 25 --stats s3.json").status, 0);
  EXPECT_EQ(json("s3.json")["inserted"], json("s2.json")["inserted"]) << "nothing is left to be done";
}

TEST_F(Saved_command, refuses_what_cannot_be)
{
  ASSERT_EQ(idt("sample prism -o m.off").status, 0);
  ASSERT_EQ(idt("triangulate m.off --save t.idt").status, 0);
  EXPECT_EQ(idt("triangulate m.off --save t.ply").status, 2);
  EXPECT_EQ(idt("triangulate m.off --number-type double --save t.idt").status, 2);
  EXPECT_EQ(idt("triangulate t.idt --repair").status, 2);
  EXPECT_EQ(idt("triangulate t.idt --mollify 0.1").status, 2);
  EXPECT_EQ(idt("triangulate t.idt --save t.idt").status, 2) << "the output would replace the input";
  EXPECT_EQ(idt("refine t.idt --remove-flat-vertices").status, 2);
  const std::string file = content(folder_ / "t.idt");
  write("cut.idt", file.substr(0, file.size() / 2));
  const Command_run cut = idt("triangulate cut.idt");
  EXPECT_EQ(cut.status, 3);
  EXPECT_NE(cut.err.find("cut.idt: byte "), std::string::npos) << cut.err;
}

} // namespace

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt sample` and `idt table`.

#include "Command_test.h"

#include <nlohmann/json.hpp>

namespace {
using Json = nlohmann::ordered_json;
using Sample_command = Command_test;
using Table_command = Command_test;
} // namespace

TEST_F(Sample_command, writes_each_name_that_it_lists_and_reads_it_back)
{
  const Command_run list = idt("sample --list");
  ASSERT_EQ(list.status, 0);
  ASSERT_GE(lines(list.out).size(), 15u);
  for (const std::string& name : lines(list.out)) {
    const Command_run to_file = idt("sample " + name + " -o " + name);
    EXPECT_EQ(to_file.status, 0) << name;
    const std::vector<std::string> printed = lines(to_file.out);
    ASSERT_EQ(printed.size(), 1u) << name;
    EXPECT_TRUE(printed[0] == name + ".off" || printed[0] == name + ".gluing") << printed[0];
    // The same text on the standard output.
    EXPECT_EQ(idt("sample " + name).out, content(folder_ / printed[0])) << name;
    const Command_run run = idt("triangulate " + printed[0] + " --stats s.json --edges e.csv");
    EXPECT_EQ(run.status, 0) << name << run.err;
    EXPECT_FALSE(contains(content(folder_ / "e.csv"), "nan")) << name;
    const Json json = Json::parse(content(folder_ / "s.json"));
    EXPECT_EQ(lines(content(folder_ / "e.csv")).size(), json["edges"].get<std::size_t>() + 1);
    EXPECT_GE(json["min_weight_after"], 0) << name;
    EXPECT_EQ(json["negative_weights_after"], 0) << name;
  }
}

TEST_F(Sample_command, chooses_the_extension)
{
  EXPECT_EQ(idt("sample one-vertex-torus -o t").out, "t.gluing\n");
  EXPECT_EQ(idt("sample one-vertex-torus -o u.gluing").out, "u.gluing\n");
  EXPECT_EQ(idt("sample prism -o p").out, "p.off\n");
  EXPECT_EQ(idt("sample prism -o p.obj").out, "p.obj\n");
  EXPECT_EQ(idt("sample prism -o p.xyz").status, 2);
  EXPECT_EQ(idt("sample one-vertex-torus -o t.off").status, 2);
  EXPECT_EQ(files().size(), 4u);
}

TEST_F(Sample_command, refuses_what_makes_no_sense)
{
  for (const char* arguments : {"sample", "sample nonsense", "sample prism --list", "sample --list -o x"}) {
    const Command_run run = idt(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_NE(run.err, "") << arguments;
    EXPECT_EQ(run.out, "") << arguments;
  }
  EXPECT_EQ(idt("sample prism -o missing/p").status, 1);
}

TEST_F(Table_command, has_a_row_for_each_input)
{
  write_kite("a.off");
  write_kite("longer-name.off", true);
  const Command_run run = idt("table a.off longer-name.off --json t.json");
  EXPECT_EQ(run.status, 0) << run.err;
  const std::vector<std::string> rows = lines(run.out);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].substr(0, 5), "model");
  EXPECT_EQ(rows[1].substr(0, 12), "a           ");
  for (const std::string& row : rows)
    EXPECT_EQ(row.size(), rows[0].size());

  const Json json = Json::parse(content(folder_ / "t.json"));
  ASSERT_EQ(json.size(), 2u);
  std::vector<std::string> keys;
  for (const auto& item : json[0].items())
    keys.push_back(item.key());
  EXPECT_EQ(keys, (std::vector<std::string>{"model", "vertices", "flips", "simple", "longest", "condition_ratio",
                                            "crossings", "minimum_angle_degrees", "seconds", "repair", "warnings",
                                            "paper", "extrinsic", "intrinsic"}));
  EXPECT_EQ(json[0]["model"], "a");
  EXPECT_EQ(json[0]["vertices"], 4);
  EXPECT_EQ(json[0]["flips"], 1);
  EXPECT_EQ(json[1]["flips"], 0);
  EXPECT_EQ(json[0]["simple"], 1);
  EXPECT_EQ(json[0]["longest"], 2);
  EXPECT_EQ(json[0]["crossings"], 1);
  EXPECT_EQ(json[1]["longest"], 1);
  EXPECT_NEAR(json[0]["minimum_angle_degrees"].get<double>(), 28.072486935852957, 1e-12); // 2 atan(1/4)
}

TEST_F(Table_command, has_condition_numbers_where_there_are_inner_vertices)
{
  ASSERT_EQ(idt("sample disk-with-spike -o d").status, 0);
  write_kite("kite.off"); // all vertices on the boundary
  const Command_run run = idt("table d.off kite.off --json t.json");
  EXPECT_EQ(run.status, 0);
  EXPECT_TRUE(contains(run.err, "kite.off: no condition number")) << run.err;
  const Json json = Json::parse(content(folder_ / "t.json"));
  const Json &extrinsic = json[0]["extrinsic"], &intrinsic = json[0]["intrinsic"];
  EXPECT_DOUBLE_EQ(json[0]["condition_ratio"].get<double>(),
                   intrinsic["condition_number"].get<double>() / extrinsic["condition_number"].get<double>());
  EXPECT_GT(extrinsic["negative_weights"], 0);
  EXPECT_LT(extrinsic["min_weight"], 0);
  EXPECT_EQ(intrinsic["negative_weights"], 0);
  EXPECT_GE(intrinsic["min_weight"], 0);
  std::size_t counted = intrinsic["weight_histogram"]["below"].get<std::size_t>() +
                        intrinsic["weight_histogram"]["above"].get<std::size_t>();
  for (const Json& count : intrinsic["weight_histogram"]["counts"])
    counted += count.get<std::size_t>();
  EXPECT_EQ(counted, 2960u - 40u); // the inner edges of the sample
  EXPECT_TRUE(json[1]["condition_ratio"].is_null());
  EXPECT_TRUE(json[0]["paper"].is_null());
  EXPECT_TRUE(Json::parse(content(folder_ / "t.json")).is_array());
  EXPECT_EQ(idt("table d.off --without-condition").err, "");
}

TEST_F(Table_command, shows_the_figures_of_the_paper_beside_its_models)
{
  const fs::path cathead = data_folder() / "table1" / "cathead.off";
  if (!fs::exists(cathead))
    GTEST_SKIP() << "no evaluation meshes: set IDT_DATA_DIR";
  const Command_run run = idt("table '" + fs::absolute(cathead).string() + "' --json t.json");
  ASSERT_EQ(lines(run.out).size(), 3u);
  EXPECT_EQ(lines(run.out)[2].substr(0, 7), "  paper");
  const Json row = Json::parse(content(folder_ / "t.json"))[0];
  EXPECT_EQ(row["paper"]["condition_ratio"], 0.8114);
  EXPECT_NEAR(row["condition_ratio"].get<double>(), 0.8114, 0.008);
}

TEST_F(Table_command, keeps_the_rows_beside_an_input_that_fails)
{
  write_kite("a.off");
  const Command_run run = idt("table missing.off a.off --json t.json");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "missing.off"));
  ASSERT_EQ(lines(run.out).size(), 3u);
  const Json json = Json::parse(content(folder_ / "t.json"));
  ASSERT_EQ(json.size(), 2u);
  EXPECT_TRUE(json[0]["flips"].is_null());
  EXPECT_EQ(json[1]["flips"], 1);
}

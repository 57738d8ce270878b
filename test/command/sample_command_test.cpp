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
  EXPECT_EQ(idt("sample prism -o p.obj").status, 2);
  EXPECT_EQ(idt("sample one-vertex-torus -o t.off").status, 2);
  EXPECT_EQ(files().size(), 3u);
}

TEST_F(Sample_command, refuses_what_makes_no_sense)
{
  for (const char* arguments :
       {"sample", "sample nonsense", "sample prism --list", "sample --list -o x"}) {
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
  EXPECT_EQ(keys,
            (std::vector<std::string>{"model", "vertices", "flips", "simple", "longest",
                                      "condition_ratio", "crossings", "seconds"}));
  EXPECT_EQ(json[0]["model"], "a");
  EXPECT_EQ(json[0]["vertices"], 4);
  EXPECT_EQ(json[0]["flips"], 1);
  EXPECT_EQ(json[1]["flips"], 0);
  EXPECT_EQ(json[0]["simple"], 1);
  EXPECT_EQ(json[0]["longest"], 2);
  EXPECT_EQ(json[0]["crossings"], 1);
  EXPECT_EQ(json[1]["longest"], 1);
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

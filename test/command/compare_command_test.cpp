// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `idt compare`

#include "Command_test.h"

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::ordered_json;
using Compare_command = Command_test;

std::vector<std::string> keys(const Json& json)
{
  std::vector<std::string> result;
  for (const auto& item : json.items())
    result.push_back(item.key());
  return result;
}

// The row of a number type; the precision is that of mpfr.
Json row(const Json& rows, const std::string& number_type, int precision = 0)
{
  for (const Json& row : rows)
    if (row["number_type"] == number_type && (precision == 0 || row["precision"] == precision))
      return row;
  return nullptr;
}

} // namespace

TEST_F(Compare_command, has_a_row_for_each_number_type)
{
  write_kite("kite.off");
  const Command_run run = idt("compare kite.off --json c.json");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.err, "");
  const std::vector<std::string> text = lines(run.out);
  ASSERT_EQ(text.size(), 16u); // two lines, the titles, thirteen number types
  for (std::size_t i = 3; i < text.size(); ++i)
    EXPECT_EQ(text[i].size(), text[2].size()) << text[i];

  const Json json = Json::parse(content(folder_ / "c.json"));
  EXPECT_EQ(keys(json), (std::vector<std::string>{"surfaces", "totals"}));
  ASSERT_EQ(json["surfaces"].size(), 1u);
  const Json& surface = json["surfaces"][0];
  EXPECT_EQ(keys(surface), (std::vector<std::string>{"surface", "vertices", "edges", "faces", "ties", "repair",
                                                     "warnings", "number_types"}));
  EXPECT_EQ(surface["surface"], "kite.off");
  EXPECT_EQ(surface["edges"], 5);
  EXPECT_EQ(surface["ties"], 0);
  EXPECT_EQ(surface["number_types"].size(), 13u);
  EXPECT_FALSE(row(surface["number_types"], "mpfr", 256).is_null());
  for (const Json& row : surface["number_types"]) {
    EXPECT_EQ(keys(row), (std::vector<std::string>{"number_type", "precision", "status", "ended", "flips", "tests",
                                                   "wrong_decisions", "not_delaunay", "inverted_faces", "missing_edges",
                                                   "length_error", "seconds", "ratio_to_double"}));
    EXPECT_EQ(row["status"], "done") << row;
    EXPECT_EQ(row["flips"], 1) << row;
    for (const char* key : {"wrong_decisions", "not_delaunay", "inverted_faces", "missing_edges"})
      EXPECT_EQ(row[key], 0) << row;
    EXPECT_GT(row["ratio_to_double"], 0) << row;
    EXPECT_LT(row["length_error"], row["number_type"] == "float" ? 1e-6 : 1e-15) << row;
  }
  ASSERT_EQ(json["totals"].size(), 13u);
  EXPECT_EQ(keys(json["totals"][0]),
            (std::vector<std::string>{"number_type", "precision", "surfaces", "refused", "not_ended", "wrong",
                                      "unnoticed", "wrong_decisions", "not_delaunay", "inverted_faces", "missing_edges",
                                      "length_error", "ratio_to_double"}));
}

TEST_F(Compare_command, finds_what_rounding_gets_wrong)
{
  ASSERT_EQ(idt("sample torus -o torus.off").status, 0);
  const std::string command = "compare torus.off --json c.json --number-types "
                              "float,double,interval,mpfr,filtered --precisions 512 ";
  ASSERT_EQ(idt(command).status, 0);
  const Json rows = Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"];
  ASSERT_EQ(rows.size(), 5u);
  for (const char* number_type : {"float", "double"}) {
    const Json wrong = row(rows, number_type);
    EXPECT_GT(wrong["wrong_decisions"], 0) << number_type;
    EXPECT_GT(wrong["not_delaunay"], 0) << number_type;
    EXPECT_GT(wrong["missing_edges"], 0) << number_type;
    EXPECT_EQ(wrong["ended"], true) << number_type;
  }
  EXPECT_EQ(row(rows, "interval")["status"], "undecided");
  EXPECT_EQ(row(rows, "interval")["wrong_decisions"], 0);
  // Except for ties, 512 bits are enough here; ties cost no edge.
  EXPECT_EQ(row(rows, "mpfr")["missing_edges"], 0);
  const Json filtered = row(rows, "filtered");
  EXPECT_EQ(filtered["status"], "done");
  for (const char* key : {"wrong_decisions", "not_delaunay", "inverted_faces", "missing_edges"})
    EXPECT_EQ(filtered[key], 0) << key;
  EXPECT_LT(filtered["length_error"], 4.5e-16);

  ASSERT_EQ(idt(command + "--no-count-decisions").status, 0);
  const Json fewer = Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"];
  EXPECT_TRUE(fewer[0]["wrong_decisions"].is_null());
  EXPECT_EQ(fewer[0]["not_delaunay"], rows[0]["not_delaunay"]);
}

TEST_F(Compare_command, tells_loops_and_multiple_edges_apart)
{
  for (const char* name : {"one-vertex-torus", "helical-tube"}) {
    const std::string file = lines(idt(std::string("sample ") + name + " -o " + name).out).at(0);
    ASSERT_EQ(idt("compare " + file + " --json c.json --number-types double,filtered").status, 0);
    const Json rows = Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"];
    for (const Json& row : rows)
      EXPECT_EQ(row["missing_edges"], 0) << name << row;
  }
}

TEST_F(Compare_command, ends_what_does_not_end)
{
  ASSERT_EQ(idt("sample strip -o strip.off").status, 0);
  const Command_run run = idt("compare strip.off --json c.json --time-limit 1 "
                              "--number-types double,core,half-angle-core,filtered");
  EXPECT_EQ(run.status, 0) << run.err;
  const Json rows = Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"];
  for (const char* number_type : {"core", "half-angle-core"}) {
    EXPECT_EQ(row(rows, number_type)["status"], "time limit");
    EXPECT_EQ(row(rows, number_type)["ended"], false);
    EXPECT_TRUE(row(rows, number_type)["ratio_to_double"].is_null());
  }
  EXPECT_EQ(row(rows, "filtered")["status"], "done");
  EXPECT_EQ(files().size(), 2u); // core may write more here
}

TEST_F(Compare_command, says_who_refuses_a_surface)
{
  write("flat.off", "OFF\n5 3 0\n0 0 0\n2 0 0\n1 2 0\n1 0 0\n1 -1 0\n"
                    "3 0 1 2\n3 0 3 1\n3 0 4 3\n");
  ASSERT_EQ(idt("compare flat.off --json c.json --number-types half-angle-double,filtered").status, 0);
  const Json rows = Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"];
  EXPECT_EQ(rows[0]["status"], "refused");
  EXPECT_EQ(rows[1]["status"], "done");
}

TEST_F(Compare_command, adds_several_surfaces_up)
{
  ASSERT_EQ(idt("sample prism -o prism.off").status, 0);
  write_kite("kite.off");
  const Command_run run = idt("compare missing.off kite.off prism.off --json c.json --number-types double,filtered");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.err, "missing.off"));
  EXPECT_TRUE(contains(run.out, "all together"));
  const Json json = Json::parse(content(folder_ / "c.json"));
  EXPECT_EQ(json["surfaces"].size(), 2u);
  EXPECT_EQ(json["totals"][0]["surfaces"], 2);
  EXPECT_EQ(json["totals"][0]["wrong"], 1);
  EXPECT_EQ(json["totals"][0]["not_delaunay"], json["surfaces"][1]["number_types"][0]["not_delaunay"]);
  EXPECT_EQ(json["totals"][1]["wrong"], 0);
}

TEST_F(Compare_command, refuses_a_wrong_command_line)
{
  write_kite("kite.off");
  for (const char* arguments :
       {"compare", "compare kite.off --number-types decimal", "compare kite.off --precisions 1",
        "compare kite.off --time-limit 0", "compare kite.off --repetitions 0",
        "compare kite.off --count-decisions --no-count-decisions", "compare kite.off --json kite.off"}) {
    const Command_run run = idt(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_NE(run.err, "") << arguments;
  }
  EXPECT_EQ(idt("compare --help").status, 0);
}

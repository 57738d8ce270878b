// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number types that may end the process, and how the command reports that.

#include "Command_test.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using Json = nlohmann::json;

class Command_core : public Command_test
{
protected:
  // Two triangles in space, one edge to flip, of about this size.
  void write_hinge(const std::string& name, const std::string& exponent) const
  {
    const std::string e = "e" + exponent + " ";
    write(name, "OFF\n4 2 0\n0 0 0\n1" + e + "0 0\n1.3" + e + "1.1" + e + "0\n0 0.9" + e + "0.37" + e +
                  "\n3 0 1 2\n3 0 2 3\n");
  }
  // The lengths and the weights in the order of the edges.
  std::vector<double> numbers(const std::string& csv) const
  {
    std::vector<double> result;
    for (const std::string& line : lines(content(folder_ / csv))) {
      std::istringstream in(line);
      std::string field;
      for (int i = 0; std::getline(in, field, ','); ++i)
        if ((i == 2 || i == 3) && field != "length" && field != "cotan_weight")
          result.push_back(std::stod(field));
    }
    return result;
  }
};

} // namespace

TEST_F(Command_core, takes_surfaces_of_any_size)
{
  for (const char* exponent : {"-150", "-30", "0", "7", "22", "25", "100", "150"}) {
    write_hinge("c.off", exponent);
    ASSERT_EQ(idt("triangulate c.off --edges filtered.csv").status, 0);
    const std::vector<double> expected = numbers("filtered.csv");
    ASSERT_EQ(expected.size(), 10u);
    for (const char* number_type : {"core", "half-angle-core"}) {
      SCOPED_TRACE(std::string(number_type) + " at 1e" + exponent);
      const Command_run run =
        idt(std::string("triangulate c.off --edges core.csv --verify --number-type ") + number_type);
      ASSERT_EQ(run.status, 0) << run.err;
      const std::vector<double> found = numbers("core.csv");
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t i = 0; i < found.size(); ++i)
        EXPECT_NEAR(found[i] / expected[i], 1, 1e-14) << i;
    }
  }
}

TEST_F(Command_core, takes_lengths_of_any_size)
{
  for (const char* exponent : {"-30", "25", "100"}) {
    const std::string e = std::string("e") + exponent + "\n";
    write("c.gluing", "INTRINSIC_GLUING 1\n4 5 2\n0 1 2\n1 0 3\n0 3 3" + e + "1 -1 2" + e + "2 -1 2" + e + "4 -1 2" +
                        e + "5 -1 2" + e);
    ASSERT_EQ(idt("triangulate c.gluing --edges filtered.csv").status, 0) << idt("triangulate c.gluing").err;
    ASSERT_EQ(idt("triangulate c.gluing --edges core.csv --number-type core").status, 0);
    const std::vector<double> expected = numbers("filtered.csv"), found = numbers("core.csv");
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i] / expected[i], 1, 1e-14) << i;
  }
}

TEST_F(Command_core, goes_on_with_other_inputs_where_one_ends_the_process)
{
  ASSERT_EQ(idt("sample strip -o strip.off").status, 0); // takes long
  write_hinge("a.off", "0");
  fs::create_directory(folder_ / "tmp");
  const Command_run run = shell("TMPDIR=\"$PWD/tmp\" '" + command_path() +
                                "' triangulate a.off strip.off a.off --number-type core & process=$!; sleep 1.5; "
                                "kill -KILL $(cat /proc/$process/task/$process/children); wait $process");
  EXPECT_EQ(run.status, 4);
  EXPECT_TRUE(contains(run.err, "strip.off: as core: ")) << run.err;
  EXPECT_TRUE(contains(run.err, "filtered")) << run.err;
  EXPECT_FALSE(contains(run.out, "strip.off")) << run.out;
  EXPECT_TRUE(contains(run.out, "\n\na.off\n")) << run.out;
  EXPECT_TRUE(fs::is_empty(folder_ / "tmp"));
}

TEST_F(Command_core, is_compared_without_errors_of_its_own)
{
  write_hinge("c.off", "25");
  ASSERT_EQ(idt("compare c.off --number-types core,half-angle-core --json c.json").status, 0);
  for (const Json& row : Json::parse(content(folder_ / "c.json"))["surfaces"][0]["number_types"]) {
    EXPECT_EQ(row["status"], "done");
    EXPECT_LT(row["length_error"], 1e-14);
  }
}

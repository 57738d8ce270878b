// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A command line that is wrong is refused by the name of what is wrong, before anything is done.

#include "Command_test.h"

namespace {

class Command_usage : public Command_test
{
protected:
  // Expects a refusal that names this.
  void expect_refused(const std::string& arguments, const std::string& named) const
  {
    const Command_run run = idt(arguments);
    EXPECT_EQ(run.status, 2) << arguments << '\n'
                             << run.err;
    EXPECT_TRUE(contains(run.err, named)) << arguments << '\n'
                                          << run.err;
    EXPECT_LT(run.err.size(), 300u) << run.err;
  }
};

} // namespace

TEST_F(Command_usage, an_option_is_no_value)
{
  write_kite("kite.off");
  expect_refused("triangulate kite.off --edges --verify", "--edges");
  expect_refused("triangulate --edges --stats s.json kite.off", "--edges");
  expect_refused("sample torus -o --list", "-o");
  expect_refused("compare kite.off --number-types , --time-limit 1", "--number-types");
  expect_refused("compare kite.off --number-types --time-limit 1", "--number-types");
  EXPECT_EQ(files(), std::vector<std::string>{"kite.off"});

  EXPECT_EQ(idt("triangulate kite.off --edges=--verify").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "--verify"));
  EXPECT_EQ(idt("triangulate kite.off --edges ./--stats").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "--stats"));
  write_kite("--edges");
  EXPECT_EQ(idt("triangulate -- --edges --verify").status, 3); // two inputs, the second of which is no mesh
}

TEST_F(Command_usage, the_wrong_word_is_named)
{
  expect_refused("foo", "foo");
  expect_refused("--foo", "--foo");
  expect_refused("triangulate --foo", "--foo");
  expect_refused("", "subcommand");
  expect_refused("triangulate", "INPUT");
}

TEST_F(Command_usage, numbers_are_taken_as_they_are_written)
{
  ASSERT_EQ(idt("sample helical-tube -o tube.off").status, 0);
  for (const char* number : {"-1", "99999999999999999999", "1e3", "0x10", "x"})
    expect_refused(std::string("triangulate tube.off --maximum-flips ") + number, number);
  expect_refused("triangulate tube.off --maximum-flips ''", "empty");
  expect_refused("triangulate tube.off --precision ''", "empty");
  EXPECT_EQ(idt("triangulate tube.off --maximum-flips 18446744073709551615").status, 0);
  // Not eight.
  ASSERT_EQ(idt("sample pillow -o pillow.off").status, 0);
  EXPECT_TRUE(contains(idt("triangulate pillow.off --maximum-flips 010").err, "budget of 10 flips"));
}

TEST_F(Command_usage, a_name_that_breaks_the_file_is_refused)
{
  ASSERT_EQ(idt("sample bumpy-dome -o dome.off").status, 0);
  expect_refused("parameterize dome.off --uv 'a\nb.obj'", "line end");
  expect_refused("parameterize dome.off --uv-input 'a\nb.obj'", "line end");
  EXPECT_EQ(files(), std::vector<std::string>{"dome.off"});
}

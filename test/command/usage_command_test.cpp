// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wrong command line is refused, naming the mistake, before anything is done.

#include "Command_test.h"

#include <utility>

namespace {

class Command_usage : public Command_test
{
protected:
  // Expects a refusal that names this.
  void expect_refused(const std::string& arguments, const std::string& named) const
  {
    const Command_run run = idt(arguments);
    EXPECT_EQ(run.status, 2) << arguments << '\n' << run.err;
    EXPECT_TRUE(contains(run.err, named)) << arguments << '\n' << run.err;
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
  EXPECT_EQ(idt("triangulate -- --edges --verify").status, 3); // two inputs, the second of which is not a mesh
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

TEST_F(Command_usage, the_nearest_word_is_named)
{
  expect_refused("triangulat kite.off", "did you mean triangulate?");
  expect_refused("geo kite.off", "did you mean geodesic?");
  expect_refused("--versoin", "did you mean --version?");
  expect_refused("triangulate kite.off --ovrelay o.ply", "did you mean --overlay?");
  expect_refused("triangulate --edgse=e.csv", "did you mean --edges?");
  expect_refused("refine kite.off -o fine.off", "files are written by --kept-edges, ");
  expect_refused("triangulate kite.off --output=fine.off", ", --save, ");
  expect_refused("triangulate kite.off --number-type dubble", "did you mean double?");
  expect_refused("compare kite.off --number-types double,mpft", "did you mean mpfr?");
  expect_refused("distance kite.off --source 0 --cover tuffted", "did you mean tufted?");
  expect_refused("distance kite.off --source 0 --cover x", "{tufted,none}");
  expect_refused("sample bumby-dome", "did you mean bumpy-dome?");
  expect_refused("helo", "did you mean help?");
  expect_refused("view kite.off page.html", "not expected: page.html; did you mean -o page.html?");
  write("other.off", "");
  EXPECT_FALSE(contains(idt("view kite.off other.off").err, "did you mean")); // which would replace it
  expect_refused("help refin", "did you mean refine?");
  expect_refused("refin --help", "did you mean refine?");
  for (const char* arguments : {"convert", "help convert", "convert --help"}) {
    expect_refused(arguments, "There is no subcommand convert, but triangulate, refine, ");
    EXPECT_EQ(idt(arguments).out, "");
  }
  EXPECT_EQ(idt("sample x").out, "");
}

TEST_F(Command_usage, the_version_is_told)
{
  const Command_run run = idt("--version");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out.substr(0, 4), "idt ") << run.out;
  EXPECT_EQ(idt("triangulate --version").out, run.out);
  EXPECT_EQ(idt("-V").out, run.out);
}

TEST_F(Command_usage, help_is_a_word_as_well)
{
  EXPECT_EQ(idt("help").out, idt("--help").out);
  const Command_run run = idt("help view");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, idt("view --help").out);
  EXPECT_TRUE(contains(run.out, "--values")) << run.out;
}

TEST_F(Command_usage, quiet_is_without_a_report)
{
  write_kite("kite.off");
  for (const char* command :
       {"triangulate -q", "refine -q", "laplacian -q", "geodesic --from 0 --to 2 -q", "distance --source 0 -q"}) {
    const Command_run run = idt(std::string(command) + " kite.off");
    EXPECT_EQ(run.status, 0) << command;
    EXPECT_EQ(run.out + run.err, "") << command;
  }
  const Command_run failed = idt("triangulate --quiet missing.off");
  EXPECT_EQ(failed.status, 3);
  EXPECT_EQ(lines(failed.err).size(), 1u) << failed.err;
}

TEST_F(Command_usage, results_go_to_the_standard_output)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("triangulate kite.off --edges e.csv --stats s.json --overlay o.ply").status, 0);
  const Command_run edges = idt("triangulate kite.off --edges -");
  EXPECT_EQ(edges.status, 0);
  EXPECT_EQ(edges.out, content(folder_ / "e.csv"));
  EXPECT_TRUE(contains(edges.err, "status          Delaunay")) << edges.err;
  EXPECT_EQ(idt("triangulate kite.off -q --edges -").err, "");
  EXPECT_EQ(idt("triangulate kite.off --overlay -").out, content(folder_ / "o.ply"));
  EXPECT_EQ(idt("triangulate kite.off --overlay - --overlay-format off").out.substr(0, 4), "OFF\n");
  EXPECT_EQ(idt("geodesic kite.off --from 0 --to 2 -o - --format obj").out.substr(0, 2), "v ");
  EXPECT_EQ(idt("distance kite.off --source 0 -o -").out.substr(0, 16), "vertex,distance\n");
  EXPECT_EQ(idt("sample pillow -o -").out, idt("sample pillow").out);
  expect_refused("triangulate kite.off --edges - --crossings -", "both go to the standard output");
  expect_refused("triangulate kite.off --overlay - --overlay-format stl", "--overlay-triangles");
  EXPECT_EQ(idt("triangulate kite.off --edges - >&-").status, 1);
  // The old file stays.
  EXPECT_EQ(shell("echo first > log; '" + command_path() + "' triangulate kite.off -q --edges - >> log").status, 0);
  EXPECT_EQ(content(folder_ / "log"), "first\n" + edges.out);
  EXPECT_FALSE(fs::exists(folder_ / "-"));
}

TEST_F(Command_usage, the_standard_input_is_read_in_each_format)
{
  write_kite("kite.off");
  const std::string expected = idt("triangulate kite.off -q --edges -").out;
  const auto piped = [this](const std::string& name, const std::string& arguments) {
    return shell("cat " + name + " | '" + command_path() + "' " + arguments);
  };
  write("kite.obj", "# a comment\n\nv 0 0 0\nv 1 -0.25 0\nv 2 0 0\nv 1 0.25 0\nf 1 2 3\nf 1 3 4\n");
  write("kite.ts", "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 -0.25 0\nVRTX 3 2 0 0\nVRTX 4 1 0.25 0\n"
                   "TRGL 1 2 3\nTRGL 1 3 4\nEND\n");
  write("kite.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
                    "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
                    "0 0 0\n1 -0.25 0\n2 0 0\n1 0.25 0\n3 0 1 2\n3 0 2 3\n");
  for (const char* name : {"kite.off", "kite.obj", "kite.ts", "kite.ply"})
    for (const char* source : {"", "< "}) {
      const Command_run run =
        *source ? idt("triangulate - -q --edges - < " + std::string(name)) : piped(name, "triangulate - -q --edges -");
      EXPECT_EQ(run.status, 0) << name << run.err;
      EXPECT_EQ(run.out, expected) << name;
    }
  ASSERT_EQ(idt("sample one-vertex-torus -o torus.gluing").status, 0);
  EXPECT_EQ(piped("torus.gluing", "laplacian -").status, 0);
  ASSERT_EQ(idt("sample bumpy-dome -o dome.stl").status, 0);
  EXPECT_EQ(lines(piped("dome.stl", "triangulate -").out)[0], "-");
  EXPECT_EQ(piped("kite.off", "distance - --source 0").status, 0);

  write("bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 x\n3 0 1 2\n");
  const Command_run bad = piped("bad.off", "triangulate -");
  EXPECT_EQ(bad.status, 3);
  EXPECT_EQ(bad.err.find("idt: -: line 5"), 0u) << bad.err;
  write("text", "Hello\n");
  EXPECT_TRUE(contains(piped("text", "triangulate -").err, "not recognized"));
  EXPECT_TRUE(contains(idt("triangulate -").err, "empty"));
  for (const auto& [content, format] : std::vector<std::pair<std::string, std::string>>{
         {"<?xml version=\"1.0\"?>\n<!DOCTYPE GIFTI>\n<GIFTI Version=\"1.0\">", "is GIFTI, which is not read"},
         {std::string("\xff\xff\xfe\n\n\0\0\0\1", 9), "is a FreeSurfer surface"},
         {"#!ascii version of lh.pial\n4 4\n", "is FreeSurfer ASCII"},
         {"# vtk DataFile Version 3.0\nOFF\nASCII\n", "is legacy VTK"}}) {
    write("other", content);
    EXPECT_TRUE(contains(piped("other", "triangulate -").err, format)) << format;
  }
}

TEST_F(Command_usage, a_converter_is_named)
{
  for (const auto& [name, program] :
       std::vector<std::pair<std::string, std::string>>{{"a.glb", "assimp export a.glb a.obj"},
                                                        {"b c.FBX", "assimp export 'b c.FBX' 'b c.obj'"},
                                                        {"-a.mesh", "meshio convert './-a.mesh' './-a.ply'"},
                                                        {"a.vtu", "meshio convert a.vtu a.ply"},
                                                        {"a.vtk", "VTK reads it: python3 -c"},
                                                        {"a.step", "gmsh a.step -2 -o a.stl"},
                                                        {"a.ply.gz", "gunzip a.ply.gz"}}) {
    write(name, "x");
    const Command_run run = idt("triangulate -- '" + name + "'");
    EXPECT_EQ(run.status, 3) << name;
    EXPECT_TRUE(contains(run.err, program)) << run.err;
  }
}

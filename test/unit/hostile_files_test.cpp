// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that CGAL's readers would take for another surface, or never finish reading, are refused with the line and the
// remedy.

#include "Surface_file_test.h"
#include "input/gluing_file.h"
#include "input/read_surface.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <gtest/gtest.h>

#ifndef _WIN32
#include <sys/stat.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace {

class Hostile_files : public Surface_file_test
{
protected:
  void refused_gluing(const std::string& file, const std::string& text) const
  {
    try {
      idt::read_gluing_file(file);
      ADD_FAILURE() << file << " was read";
    } catch (const IT::Invalid_surface_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.compare(0, file.size() + 2, file + ": "), 0) << message;
      EXPECT_TRUE(contains(message, text)) << message.substr(0, 1000);
      EXPECT_LT(message.size(), 1000u);
    }
  }
};

struct Bad_text
{
  const char* name;
  std::string content;
  const char* message;
  Defect defect = Defect::UNREADABLE;
};

// CGAL's readers take the part of a word that looks like a number, and continue with or without the rest: each of these
// files gave a surface other than it seems to hold.
TEST_F(Hostile_files, words_that_only_begin_as_numbers)
{
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", points = "0 0 0\n1 0 0\n0 1 0\n", off = "OFF\n3 1 0\n" + points;
  const std::string stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 ";
  const std::string stl_end = "\nendloop\nendfacet\nendsolid a\n";
  const auto ply = [&](const char* real, const char* list) { return ply_header("ascii", 3, 1, real, list); };
  const Bad_text table[] = {
    {"a.obj", v + "f 1 2 3 4294967300\n", "line 4 (face 0): \"4294967300\" is beyond all numbers", Defect::BAD_INDEX},
    {"a.obj", v + "f 1 2 3 99999999999999999999/1\n", "is beyond all numbers of vertices", Defect::BAD_INDEX},
    {"a.obj", v + "f 1 2 3 a4\n", "line 4 (face 0): \"a4\" is not a corner of a face"},
    {"a.obj", v + "f 1.9 3 2\n", "line 4 (face 0): \"1.9\" is not a corner of a face"},
    {"a.obj", v + "f 1e0 3 2\n", "line 4 (face 0): \"1e0\" is not a corner of a face"},
    {"a.obj", v + "f 1 x 3 2\n", "line 4 (face 0): \"x\" is not a corner of a face"},
    {"a.obj", v + "f 1/2/3/4 3 2\n", "line 4 (face 0): \"1/2/3/4\" is not a corner of a face"},
    {"a.obj", v + "f 1 2 3#4 1\n", "line 4 (face 0): \"3#4\" is not a corner of a face"},
    {"a.obj", v + "f 1 2 \\\n3x\n", "line 4 (face 0): \"3x\" is not a corner of a face"},
    {"a.obj", v + "f 1 2 3 \\", "line 4: the file ends behind the backslash with which the line goes on"},
    {"a.obj", v + "# C:\\\nf 1 2 3\n", "line 5: \"f 1 2 3\" belongs to the line before, which ends with a backslash"},
    {"a.obj", v + "f 1 2 3\nf 0 1 2\n", "line 5 (face 1): \"0\" names vertex 0, but vertices are counted from 1",
     Defect::BAD_INDEX},
    {"a.obj", v + "f -4 1 2\n", "line 4 (face 0): the face names vertex -4, and there are 3 vertices before it",
     Defect::BAD_INDEX},
    {"a.obj", v + "f 1 2 4", "line 4 (face 0): the face names vertex 4, but there are 3 vertices", Defect::BAD_INDEX},
    {"a.obj", v + "f 1/" + std::string(300, '1') + " 2 3\n", "line 4 (face 0): \"1/1111"},
    {"a.obj", "v 0 1 0,75\n" + v, "line 1 (vertex 0): \"0,75\" is not a number: write a point for the decimal comma"},
    {"a.obj", "v 0 1 0x1p3\n" + v, "line 1 (vertex 0): \"0x1p3\" is not a number"},
    {"a.obj", "v 0 0 1abc\n" + v, "line 1 (vertex 0): \"1abc\" is not a number"},
    {"a.obj", "v 0 0 1e400\n" + v, "line 1 (vertex 0): the coordinate \"1e400\" is too large", Defect::OUT_OF_RANGE},
    {"a.obj", v + "f 1 2 3\nk 1 2\n", "line 5: \"k 1 2\" is not understood (after 3 vertices and 1 face)"},
    {"a.obj", v + "f 1 2 3\nk 1 2", "line 5: \"k 1 2\" is not understood (after 3 vertices and 1 face)"},
    {"a.off", "OFF\n3 1 0\n0 1 0,75\n1 0 0\n0 1 0\n3 0 1 2\n",
     "line 3 (vertex 0): \"0,75\" is not a number: write a point for the decimal comma"},
    {"a.off", "OFF\n3 1 0\n0 1 0x1p3\n1 0 0\n0 1 0\n3 0 1 2\n", "line 3 (vertex 0): \"0x1p3\" is not a number"},
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 0 1abc\n3 0 1 2\n", "line 5 (vertex 2): \"1abc\" is not a number"},
    {"a.off", off + "3 0 1 99999999999999999999\n", "line 6 (face 0): the face names vertex 99999999999999999999, but",
     Defect::BAD_INDEX},
    {"a.off", off + "3 0 2.7 1\n", "line 6 (face 0): \"2.7\" is not the index of a vertex"},
    {"a.off", off + "3.9 0 2 1\n", "line 6 (face 0): \"3.9\" is not a number of corners"},
    {"a.off", off + "3 0 2 1x7\n", "line 6 (face 0): \"1x7\" is not the index of a vertex"},
    {"a.off", off + "3 0 2e0 1\n", "line 6 (face 0): \"2e0\" is not the index of a vertex"},
    {"a.off", off + "18446744073709551615 0 2 1\n", "line 6 (face 0): no face has \"18446744073709551615\" corners"},
    {"a.stl", stl + "1,5" + stl_end, "line 6 (facet 0): \"1,5\" is not a number: write a point for the decimal comma"},
    {"a.stl", stl + "0x1p3" + stl_end, "line 6 (facet 0): \"0x1p3\" is not a number"},
    {"a.ply", ply("double", "uchar int") + points + "259 0 1 2\n",
     "line 13, element face 0: \"259\" is out of range for the size of the list vertex_indices, which is of type "
     "uchar"},
    {"a.ply", ply("double", "char int") + points + "-1 0 1 2\n",
     "line 13, element face 0: the list vertex_indices claims a negative number of entries"},
    {"a.ply", ply("double", "uchar int") + "0 0 0\n1 1e400 0\n0 1 0\n3 0 1 2\n",
     "line 11, element vertex 1: the coordinate \"1e400\" is too large", Defect::OUT_OF_RANGE},
    {"a.ply", ply("float", "uchar int") + "0 0 0\n1 1e40 0\n0 1 0\n3 0 1 2\n",
     "line 11, element vertex 1: y is of type float, for which \"1e40\" is too large", Defect::OUT_OF_RANGE},
    {"a.ply", ply("double", "uchar int") + points + "3 0 1.5 2\n",
     "line 13, element face 0: \"1.5\" is not an integer"},
    {"a.ply", ply("double", "uchar int") + points + "3 0 1 99999999999\n",
     "line 13, element face 0: \"99999999999\" is out of range for vertex_indices"}};
  for (const Bad_text& bad : table) {
    SCOPED_TRACE(bad.content.substr(0, 1000));
    refused(bad.name, bad.content, bad.message, bad.defect);
  }
  std::string binary = ply_header("binary_little_endian", 3, 1, "double", "char int");
  for (int i = 0; i < 9; ++i)
    append(binary, 1.0);
  refused("a.ply", binary + "\xff", "element face 0: the list vertex_indices claims a negative number of entries");
}

// A mistake after the first piece of a file is found, and pieces are joined seamlessly.
TEST_F(Hostile_files, long_files_are_looked_at_to_their_end)
{
  const std::size_t n = 60000;
  std::string points, obj, faces = "3 0 1 2\n";
  for (std::size_t i = 0; i < n; ++i) {
    const std::string numbers = std::to_string(i) + ".123456789012345 -" + std::to_string(i * i) + "e-7 0.5\n";
    points += numbers;
    obj += "v " + numbers;
  }
  ASSERT_GT(points.size(), std::size_t(2) << 20);
  const std::string counts = std::to_string(n) + " 1 0\n", last = std::to_string(n);
  EXPECT_EQ(idt::read_surface(write("a.off", "OFF\n" + counts + points + faces)).points.size(), n);
  EXPECT_EQ(idt::read_surface(write("a.obj", obj + "f 1 2 " + last)).points.size(), n);
  EXPECT_EQ(idt::read_surface(write("a.ply", ply_header("ascii", n, 1) + points + "3 0 1 2")).points.size(), n);
  refused("a.off", "OFF\n" + counts + points + "3 0 1 2x\n",
          "line " + std::to_string(n + 3) + " (face 0): \"2x\" is not the index of a vertex");
  refused("a.obj", obj + "f 1 2 3x\n", "line " + std::to_string(n + 1) + " (face 0): \"3x\" is not a corner");
  refused("a.ply", ply_header("ascii", n, 1) + points + "3 0 1 2x\n",
          "line " + std::to_string(n + 10) + ", element face 0: \"2x\" is not an integer");
}

// The numbers of its vertices are names, which count within a part of the file.
TEST_F(Hostile_files, vertices_of_ts_have_names)
{
  const std::string head = "GOCAD TSurf 1\n", v1 = "VRTX 1 0 0 0\n", v2 = "VRTX 2 1 0 0\n", v3 = "VRTX 3 0 1 0\n",
                    v4 = "VRTX 4 0 0 1\n", faces = "TRGL 1 2 3\nTRGL 1 4 2\n";
  const std::vector<std::array<double, 3>> points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{{0, 1, 2}}, {{0, 3, 1}}};
  // The corners by their positions, for any order of the vertices.
  const auto corners = [](const idt::Surface_input& input) {
    std::vector<std::array<double, 3>> result;
    for (const auto& triangle : input.triangles)
      for (const std::uint32_t corner : triangle)
        result.push_back(input.points.at(corner));
    return result;
  };
  idt::Surface_input expected;
  expected.points = points;
  expected.triangles = triangles;
  for (const std::string& good :
       {head + "TFACE\n" + v1 + v2 + v3 + v4 + faces + "END\n", head + "TFACE\n" + v1 + v3 + v2 + v4 + faces + "END\n",
        head + "TFACE\n" + v4 + v3 + v2 + v1 + faces + "END \n", head + "TFACE\n" + v1 + v2 + v3 + v4 + faces + "END",
        head + "TFACE\nVRTX 10 0 0 0\nVRTX -7 1 0 0\nPVRTX 5 0 1 0 9 9\nVRTX 99999999999 0 0 1\nTRGL 10 -7 5\n"
               "TRGL 10 99999999999 -7\nEND\n",
        head + "TFACE\r\nVRTX 1 0 0 0\r\nVRTX 2 1 0 0\r\nVRTX 3 0 1 0\r\nVRTX 4 0 0 1\r\nTRGL 1 2 3\r\nTRGL 1 4 "
               "2\r\nEND\r\n",
        head + "# GOCAD VRTX\nTFACE\n# GOCAD VRTX\n" + v1 + v2 + v3 + v4 + faces + "END\n",
        head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2 3\nTFACE\nATOM 6 1\nATOM 7 2\n" + v4 + "TRGL 6 4 7\nEND\n",
        head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2 3\nEND\n" + head + "TFACE\n" + v1 + v2 +
          "VRTX 3 0 0 1\nTRGL 1 3 2\nEND\n"}) {
    SCOPED_TRACE(good);
    EXPECT_EQ(corners(idt::read_surface(write("a.ts", good))), corners(expected));
  }
  const Bad_text table[] = {
    {"a.ts", head + "TFACE\n" + v1 + v2 + v2 + faces + "END\n", "line 5 (vertex 2): there is a vertex 2 before it"},
    {"a.ts", head + "TFACE\n" + v1 + v2 + v3 + faces + "END\n",
     "line 7 (face 1): the face names vertex 4, but its part has no vertex of this number", Defect::BAD_INDEX},
    {"a.ts", head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2.5 3\nEND\n",
     "line 6 (face 0): \"2.5\" is not the number of a"},
    {"a.ts", head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2\nEND\n", "line 6 (face 0): the number of a vertex is missing"},
    {"a.ts", head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2 3 4\nEND\n", "line 6 (face 0): there is more in the line than",
     Defect::NOT_A_TRIANGLE},
    {"a.ts", head + "TFACE\nVRTX 1 0 0 0,5\n", "line 3 (vertex 0): \"0,5\" is not a number: write a point"},
    {"a.ts", head + "TFACE\nVRTX 1 0 0\n", "line 3 (vertex 0): there are 2 numbers where 3 are needed"},
    {"a.ts", head + "TFACE\nATOM 1 7\n", "line 3 (vertex 0): the part has no vertex 7 before", Defect::BAD_INDEX},
    {"a.ts", head + "TFACE\n" + v1 + v2 + v3 + "TRGL 1 2 3\n" + head,
     "line 7: a part begins, but the previous one has no"}};
  for (const Bad_text& bad : table) {
    SCOPED_TRACE(bad.content);
    refused(bad.name, bad.content, bad.message, bad.defect);
  }
}

// Each kept CGAL's reader busy for years, or made it ask for all memory.
TEST_F(Hostile_files, elements_of_ply_fit_into_the_file)
{
  const std::string begin = "ply\nformat ascii 1.0\n", huge = " 1000000000000000000\n",
                    vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n",
                    faces = "element face 1\nproperty list int int vertex_indices\n", end = "end_header\n",
                    data = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  refused("a.ply", begin + "element foo" + huge + vertices + faces + end + data,
          "the header announces 1000000000000000000 elements \"foo\", which have no property");
  refused("a.ply", begin + vertices + faces + "element halfedge" + huge + end + data,
          "the header announces 1000000000000000000 elements \"halfedge\", which have no property");
  refused("a.ply", begin + vertices + faces + "element foo" + huge + "property uchar a\n" + end + data,
          "the header announces 1000000000000000000 elements \"foo\", more than fit into the");
  EXPECT_EQ(
    idt::read_surface(write("a.ply", begin + "element foo 0\n" + vertices + faces + end + data)).triangles.size(), 1u);
  // The last number may be the last of the file.
  EXPECT_EQ(idt::read_surface(write("a.ply", begin + vertices +
                                               "element face 1\nproperty list uchar int vertex_indices\n"
                                               "element foo 1\nproperty int a\n" +
                                               end + data + "7"))
              .triangles.size(),
            1u);
}

// A file with the size of a binary one is binary, whatever it begins with.
TEST_F(Hostile_files, beginnings_of_stl)
{
  const std::string text =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  std::string binary = binary_stl({{{0, 0, 0, 1, 0, 0, 0, 1, 0}}, {{0, 1, 0, 1, 0, 0, 0, 1, 1}}}, 2);
  binary.replace(0, 40, "solid facet vertex 0 0 1,5 facet vertex ");
  EXPECT_EQ(idt::read_surface(write("a.stl", binary)).triangles.size(), 2u);
  std::size_t asked = 0;
  EXPECT_THROW(idt::read_surface(write("a.stl", binary), [&](double) { return ++asked > 1; }), IT::Cancelled_error);
  EXPECT_EQ(idt::read_surface(write("a.stl", "solid\n" + text)).triangles.size(), 1u);
  for (const std::string begin : {"SOLID\n", "solid\tx\n", "\xef\xbb\xbfsolid x\n", "\n Solid x facet\n"})
    EXPECT_EQ(idt::read_surface(write("a.stl", begin + text)).triangles.size(), 1u) << begin;
  refused("a.stl", "solids\n" + text, "neither text STL (the first word is \"solids\" and not solid) nor binary STL");
  // The number of facets is wrong, but the file is still not a text.
  binary.resize(binary.size() - 50);
  refused("a.stl", binary,
          "the file begins as text STL does, but has bytes that are in no text; nor is it binary STL (the header"
          " announces 2 facets, the file has room for 1: it ends within facet 1, which begins at byte 134; it was cut "
          "off, or the number, of four bytes at byte 80, is wrong)");
  // Bytes of a damaged text at the place of the number.
  refused("a.stl", "solid " + std::string(74, 'x') + "\xff\xff\xff\xff" + std::string(50, '\x19'),
          "the file begins as text STL does, but has bytes that are in no text");
}

TEST_F(Hostile_files, encodings)
{
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                    ts = "GOCAD TSurf 1\nTFACE\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\nTRGL 0 1 2\nEND\n",
                    ply = ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                    gluing = "INTRINSIC_GLUING 1\n3 3 1\n0 1 2\n0 -1 1\n1 -1 1\n2 -1 1\n";
  const std::pair<const char*, std::string> files[] = {
    {"a.off", off}, {"a.obj", obj}, {"a.ts", ts}, {"a.ply", ply}, {"a.gluing", gluing}};
  for (const auto& [name, text] : files) {
    SCOPED_TRACE(name);
    std::string with_returns = text;
    std::replace(with_returns.begin(), with_returns.end(), '\n', '\r');
    const bool is_gluing = idt::is_gluing_file(name);
    const std::string utf16 = "\xff\xfe" + text;
    if (is_gluing)
      refused_gluing(write(name, utf16), "the text is in UTF-16");
    else
      refused(name, utf16, "the text is in UTF-16");
    for (const std::string& content : {"\xef\xbb\xbf" + text, with_returns}) {
      const std::string file = write(name, content);
      EXPECT_EQ(is_gluing ? idt::read_gluing_file(file).complex.number_of_faces()
                          : idt::read_surface(file).triangles.size(),
                1u);
    }
  }
}

TEST_F(Hostile_files, what_is_no_mesh)
{
  for (const char* const name : {"a.off", "a.obj", "a.ply", "a.stl", "a.ts"}) {
    refused(name, "\x1f\x8b\x08\x01 and so on", "the file is compressed: unpack it first");
    refused(name, "PK\3\4 and so on", "the file is compressed");
    refused(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n", "get it with git lfs pull");
    refused(name, "\n<!DOCTYPE html>\n<html></html>\n", "the file is a web page");
  }
}

TEST_F(Hostile_files, numbers_that_are_nearly_some)
{
  const auto with_number = [](const std::string& number) {
    return "OFF\n3 1 0\n0 0 " + number + "\n1 0 0\n0 1 0\n3 0 1 2\n";
  };
  const std::pair<const char*, const char*> table[] = {{"0,5", ": write a point for the decimal comma"},
                                                       {"0.5,", ": separate numbers by blanks alone"},
                                                       {"0.5;", ": separate numbers by blanks alone"},
                                                       {"0.5D+00", ": write e before the exponent"},
                                                       {"0.5x", ""}};
  for (const auto& [number, advice] : table)
    refused("a.off", with_number(number),
            "line 3 (vertex 0): \"" + std::string(number) + "\" is not a number" + advice);
}

TEST_F(Hostile_files, gluings_are_files)
{
  fs::create_directory(path("folder.gluing"));
  refused_gluing(path("folder.gluing"), "this is a directory, not a file");
  refused_gluing(path("absent.gluing"), "there is no such file");
  refused_gluing(write("empty.gluing", ""), "the file is empty");
#ifndef _WIN32
  // Opening a pipe would wait for a writer.
  ASSERT_EQ(::mkfifo(path("pipe.gluing").c_str(), 0600), 0);
  refused_gluing(path("pipe.gluing"), "this is not a regular file");
  fs::create_symlink("/dev/zero", path("zero.gluing"));
  refused_gluing(path("zero.gluing"), "this is not a regular file");
#endif

  EXPECT_TRUE(idt::is_gluing_file("A.GLUING"));
  EXPECT_FALSE(idt::is_gluing_file("gluing"));
  refused("name.foo", "what\n", ".gluing");

  const std::string begin = "INTRINSIC_GLUING 1\n3 3 1\n0 1 2\n0 -1 1\n1 -1 1\n2 -1 ";
  refused_gluing(write("a.gluing", begin + "\x1b[31m\n"), "line 6 has '?[31m' where a length is expected");
  refused_gluing(write("a.gluing", begin + std::string(2000000, 'x') + "\n"), "xxx...' where a length is expected");
  refused_gluing(write("a.gluing", begin + std::string(2, '\0') + "\n"),
                 "line 6 has '\?\?' where a length is expected");
}

TEST_F(Hostile_files, gluings_can_be_watched_and_stopped)
{
  std::string text = "INTRINSIC_GLUING 1\n3 3 1\n0 1 2\n0 -1 1\n";
  for (int i = 0; i < 300000; ++i)
    text += "# a comment\n";
  const std::string file = write("a.gluing", text + "1 -1 1\n2 -1 1\n");
  std::vector<double> fractions;
  const auto watch = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  EXPECT_EQ(idt::read_gluing_file(file, watch).complex.number_of_faces(), 1u);
  ASSERT_GT(fractions.size(), 3u);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  for (std::size_t stop = 1; stop <= fractions.size(); ++stop) {
    std::size_t asked = 0;
    EXPECT_THROW(idt::read_gluing_file(file, [&](double) { return ++asked < stop; }), IT::Cancelled_error) << stop;
  }
}

} // namespace

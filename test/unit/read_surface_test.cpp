// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers survive every format; each way in which a file can be unusable has its own message; the collection of bad
// files, if present.

#include "Surface_file_test.h"
#include "input/mesh_file.h"
#include "input/read_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

typedef IT::Invalid_surface_error::Defect Kind;
typedef Surface_file_test Read_surface;
typedef std::vector<std::array<double, 3>> Points;
typedef std::vector<std::array<std::uint32_t, 3>> Triangles;

std::string digits(const double number)
{
  char text[40];
  std::snprintf(text, sizeof(text), "%.17g", number);
  return text;
}

// Doubles of every size, subnormal and huge ones included.
Points hard_numbers()
{
  std::mt19937_64 random(17);
  Points points;
  while (points.size() < 300) {
    std::array<double, 3> p;
    for (double& x : p)
      do {
        const std::uint64_t bits = random();
        std::memcpy(&x, &bits, sizeof(x));
      } while (!std::isfinite(x));
    points.push_back(p);
  }
  points.push_back({{0.1, -0.0, 1.0 / 3.0}});
  points.push_back({{0x1p-1074, (std::numeric_limits<double>::max)(), -(std::numeric_limits<double>::min)()}});
  while (points.size() % 3 != 0)
    points.push_back({{1.0 * static_cast<double>(points.size()), 1, 1}});
  return points;
}

Triangles consecutive_triangles(const std::size_t n)
{
  Triangles triangles;
  for (std::uint32_t i = 0; i + 2 < n; i += 3)
    triangles.push_back({{i, i + 1, i + 2}});
  return triangles;
}

void expect_same_bits(const Points& a, const Points& b)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(std::memcmp(&a[i], &b[i], sizeof(a[i])), 0)
      << i << ": " << digits(a[i][0]) << " " << digits(a[i][1]) << " " << digits(a[i][2]) << ", " << digits(b[i][0])
      << " " << digits(b[i][1]) << " " << digits(b[i][2]);
}

TEST_F(Read_surface, seventeen_digits_come_back)
{
  const Points points = hard_numbers();
  const Triangles triangles = consecutive_triangles(points.size());
  std::string vertices, off_faces, obj = "# a comment\n", stl = "solid a name\n", ts = "GOCAD TSurf 1\nTFACE\n";
  std::size_t i = 0;
  for (const std::array<double, 3>& p : points) {
    const std::string numbers = digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
    vertices += numbers;
    obj += "v " + numbers;
    ts += "VRTX " + std::to_string(i++) + " " + numbers;
  }
  for (const std::array<std::uint32_t, 3>& t : triangles) {
    const auto corners = [&](const std::uint32_t k) {
      return std::to_string(t[0] + k) + " " + std::to_string(t[1] + k) + " " + std::to_string(t[2] + k) + "\n";
    };
    off_faces += "3 " + corners(0);
    obj += "f " + corners(1);
    ts += "TRGL " + corners(0);
    stl += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t)
      stl += "vertex " + digits(points[v][0]) + " " + digits(points[v][1]) + " " + digits(points[v][2]) + "\n";
    stl += "endloop\nendfacet\n";
  }
  std::string ply = ply_header("binary_little_endian", points.size(), triangles.size());
  for (const std::array<double, 3>& p : points)
    append(ply, p);
  for (const std::array<std::uint32_t, 3>& t : triangles) {
    ply += '\3';
    append(ply, t);
  }
  const std::string files[] = {
    write("a.off", "OFF\n" + std::to_string(points.size()) + " " + std::to_string(triangles.size()) + " 0\n" +
                     vertices + off_faces),
    write("a.OBJ", obj),
    write("a.stl", stl + "endsolid\n"),
    write("a.ts", ts + "END\n"),
    write("a.ply", ply_header("ascii", points.size(), triangles.size()) + vertices + off_faces),
    write("b.ply", ply)};
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const idt::Surface_input input = idt::read_surface(file);
    EXPECT_EQ(input.path, file);
    expect_same_bits(points, input.points);
    EXPECT_EQ(input.triangles, triangles);
    EXPECT_TRUE(input.is_triangulated());
  }
}

TEST_F(Read_surface, what_the_command_writes_comes_back)
{
  const Points points = hard_numbers();
  const Triangles triangles = consecutive_triangles(points.size());
  for (const std::string name : {"a.ply", "a.off", "a.obj", "a.STL", "a.ts"}) {
    SCOPED_TRACE(name);
    std::ofstream out(path(name), std::ios::binary);
    idt::write_mesh(out, points, triangles, idt::find_mesh_format(name).value());
    out.close();
    const idt::Surface_input input = idt::read_surface(path(name));
    // STL has no vertices: reading gives the corners, in the order of the faces.
    expect_same_bits(points, input.points);
    EXPECT_EQ(input.triangles, triangles);
    // And once more.
    const idt::Surface_input again = idt::read_surface(path(name));
    expect_same_bits(again.points, input.points);
    EXPECT_EQ(again.triangles, input.triangles);
  }
  EXPECT_FALSE(idt::find_mesh_format("a.xyz"));
  EXPECT_FALSE(idt::holds_polygons(idt::Mesh_format::STL));
}

TEST_F(Read_surface, can_be_watched_and_stopped)
{
  const std::size_t n = 200000;
  std::string off = "OFF\n" + std::to_string(n + 2) + " " + std::to_string(n) + " 0\n";
  for (std::size_t i = 0; i < n + 2; ++i)
    off += std::to_string(i) + " " + std::to_string(i % 2) + " 0\n";
  for (std::size_t i = 0; i < n; ++i)
    off += "3 " + std::to_string(i) + " " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  const std::string file = write("long.off", off);
  std::vector<double> fractions;
  const idt::Surface_input input = idt::read_surface(file, [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  EXPECT_EQ(input.triangles.size(), n);
  ASSERT_GT(fractions.size(), 3u);
  EXPECT_EQ(fractions.front(), 0);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_GT(fractions.back(), 0.9);
  EXPECT_LE(fractions.back(), 1);

  for (std::size_t stop = 1; stop <= fractions.size(); ++stop) {
    std::size_t asked = 0;
    EXPECT_THROW(idt::read_surface(file, [&](double) { return ++asked < stop; }), IT::Cancelled_error) << stop;
    EXPECT_EQ(asked, stop);
  }
}

TEST_F(Read_surface, polygons_are_kept)
{
  const idt::Surface_input input =
    idt::read_surface(write("a.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n3 0 1 4\n4 3 2 1 0\n0\n"));
  EXPECT_FALSE(input.is_triangulated());
  EXPECT_TRUE(input.triangles.empty());
  ASSERT_EQ(input.number_of_faces(), 3u);
  const idt::Surface_input::Polygon quadrangle = input.polygon(1);
  EXPECT_EQ(std::vector<std::uint32_t>(quadrangle.begin(), quadrangle.end()), (std::vector<std::uint32_t>{3, 2, 1, 0}));
  EXPECT_EQ(input.polygon(2).size(), 0u);
  const IT::Surface_report report = idt::examine(input);
  ASSERT_NE(report.find(Kind::NOT_A_TRIANGLE), nullptr);
  EXPECT_EQ(report.find(Kind::NOT_A_TRIANGLE)->elements, (std::vector<std::size_t>{1, 2}));
}

TEST_F(Read_surface, forms_that_are_read)
{
  const Triangles triangle = {{{0, 1, 2}}};
  const Points points = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}};
  const std::string files[] = {
    write("comments.off", "# one\nOFF # two\n\n3 1 0\n\n0 0 0 # three\n1 0 0\n\n#four\n0 1 0\n3 0 1 2"),
    write("windows.off", "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n"),
    write("colors.off", "COFF\n3 1 0\n0 0 0 9 9 9 9\n1 0 0 9 9 9 9\n0 1 0 9 9 9 9\n3 0 1 2\n"),
    write("some_colors.off", "COFF\n3 1 0\n0 0 0 9 9 9\n1 0 0\n0 1 0 9 9 9 9\n3 0 1 2 7\n"),
    write("indexed_colors.off", "COFF\n3 1 0\n0 0 0 500000000\n1 0 0 -500000000\n0 1 0 1e300\n3 0 1 2\n"),
    write("textures.off", "STCNOFF\n3 1 0\n0 0 0 0 0 1 5 5\n1 0 0 0 0 1 5 5\n0 1 0 0 0 1 5 5\n3 0 1 2\n"),
    write("colors_of_faces.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 0.5 0.5 0.5\n"),
    write("four.off", "4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 1 0 1\n3 0 1 2\n"),
    write("edges.off", "OFF\n3 1 1073741824\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), // twice that overflows int
    write("all_edges.off", "OFF\n3 1 99999999999\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    write("long_comment.off", "#" + std::string(100000, 'x') + "\nOFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    write("slashes.obj", "o x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 3/1\n"),
    write("negative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"),
    write("others.obj", "g x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\n  l\t1 2 \\\n  3 1\np 1 2\ncstype bezier\ndeg 2\ncurv "
                        "0 1 1 \\\r\n2 \\\r\n3\nend\nf 1 2 3\nl 2 3"),
    write("tabs.obj", "v\t0\t0\t0\nv\t1 0\t0\nv 0\t1 0\nf 1\t2\t3\n"),
    write("float.ply", ply_header("ascii", 3, 1, "float") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
    write("list.ply", ply_header("ascii", 3, 1, "float", "int uint") + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")};
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const idt::Surface_input input = idt::read_surface(file);
    EXPECT_EQ(input.points, points);
    EXPECT_EQ(input.triangles, triangle);
  }
}

// Three vertices and a triangle in every form that a binary file may have.
TEST_F(Read_surface, forms_of_binary_ply)
{
  const Points points = {{{0, 0, 0.5}}, {{1, 0, 0}}, {{0, 1, 0}}};
  const auto big = [](const auto value) {
    std::string bytes;
    append(bytes, value);
    return std::string(bytes.rbegin(), bytes.rend());
  };
  const auto little = [](const auto value) {
    std::string bytes;
    append(bytes, value);
    return bytes;
  };
  const std::string begin = "ply\nformat binary_little_endian 1.0\n", end = "end_header\n";
  std::string content = "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                        "property double z\nelement face 1\nproperty list uchar int vertex_indices\n" +
                        end;
  for (const auto& p : points)
    for (const double x : p)
      content += big(x);
  content += '\3' + big(0) + big(1) + big(2);
  idt::Surface_input input = idt::read_surface(write("big.ply", content));
  EXPECT_EQ(input.points, points);
  EXPECT_EQ(input.triangles, (Triangles{{{0, 1, 2}}}));

  // Coordinates in another order and of two types, lists and numbers of no interest, another element in between.
  content = begin +
            "element vertex 3\nproperty float z\nproperty list ushort short weights\nproperty double x\n"
            "property uchar red\nproperty float y\nelement edge 2\nproperty int a\nelement face 3\n"
            "property list uint float quality\nproperty list short uint vertex_index\nproperty char flag\n" +
            end;
  for (const auto& p : points)
    content += little(float(p[2])) + little(std::uint16_t(2)) + "abcd" + little(p[0]) + 'r' + little(float(p[1]));
  content += "12345678";
  for (const std::vector<std::uint32_t>& face : {std::vector<std::uint32_t>{0, 1, 2}, {2, 1, 0, 1}, {}}) {
    content += little(std::uint32_t(1)) + "qqqq" + little(std::uint16_t(face.size()));
    for (const std::uint32_t v : face)
      content += little(v);
    content += 'f';
  }
  input = idt::read_surface(write("mixed.ply", content));
  EXPECT_EQ(input.points, points);
  EXPECT_EQ(input.corners, (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0, 1}));
  EXPECT_EQ(input.first_corner, (std::vector<std::size_t>{0, 3, 7, 7}));
  EXPECT_EQ(idt::read_surface(write("mixed.ply", content + std::string("\n\0", 2))).warnings.size(), 1u);
  refused("mixed.ply", content + "what follows",
          "from byte " + std::to_string(content.size()) +
            " on there are 12 bytes behind the elements that the header announces (3 vertex, 2 edge, 3 face)");
  refused("mixed.ply", content.substr(0, content.size() - 1), "element face 2: the file ends within flag");
  refused("mixed.ply", content.substr(0, content.size() - 8), "element face 2: the file ends within quality");

  // Triangles, then others, then triangles again.
  content = ply_header("binary_little_endian", 3, 4);
  for (const auto& p : points)
    append(content, p);
  for (const int size : {3, 2, 3, 3}) {
    content += char(size);
    for (int i = 0; i < size; ++i)
      append(content, i);
  }
  input = idt::read_surface(write("a.ply", content));
  EXPECT_EQ(input.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 0, 1, 2, 0, 1, 2}));
  refused("a.ply", content.substr(0, content.size() - 1), "element face 3: the file ends within vertex_indices");
}

TEST_F(Read_surface, all_formats_can_be_watched_and_stopped)
{
  const std::size_t n = 150000; // more than a piece of each file
  std::string points, obj, stl = "solid\n", ts = "GOCAD TSurf 1\nTFACE\n",
                           binary = ply_header("binary_little_endian", n, 1);
  for (std::size_t i = 0; i < n; ++i) {
    const std::string place = std::to_string(i) + " " + std::to_string(i * i % 7) + " 0\n";
    points += place;
    obj += "v " + place;
    ts += "VRTX " + std::to_string(i) + " " + place;
    stl += "# " + place;
    append(binary, std::array<double, 3>{{double(i), 0, 0}});
  }
  binary += '\3';
  append(binary, std::array<std::int32_t, 3>{{0, 1, 2}});
  std::string one_line = points;
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  stl += "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endloop endfacet endsolid";
  for (const std::string& file :
       {write("a.obj", obj + "f 1 2 3\n"), write("a.ts", ts + "TRGL 0 1 2\nEND\n"), write("a.stl", stl),
        write("a.ply", binary), write("b.ply", ply_header("ascii", n, 1) + points + "3 0 1 2\n"),
        write("c.ply", ply_header("ascii", n, 1) + one_line + "3 0 1 2\n")}) {
    SCOPED_TRACE(file);
    std::vector<double> fractions;
    const idt::Surface_input input = idt::read_surface(file, [&](double fraction) {
      fractions.push_back(fraction);
      return true;
    });
    EXPECT_EQ(input.points.size(), contains(file, ".stl") ? 3u : n);
    EXPECT_EQ(input.triangles.size(), 1u);
    ASSERT_GT(fractions.size(), 1u);
    EXPECT_EQ(fractions.front(), 0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LE(fractions.back(), 1);
    for (std::size_t stop = 1; stop <= fractions.size(); ++stop) {
      std::size_t asked = 0;
      EXPECT_THROW(idt::read_surface(file, [&](double) { return ++asked < stop; }), IT::Cancelled_error) << stop;
      EXPECT_EQ(asked, stop);
    }
  }
}

// Numbers that need a closer look than the usual ones.
TEST_F(Read_surface, unusual_numbers)
{
  const Points points = {{{0.5, -0.0, 0}}, {{1, 1e-310, 0}}, {{0, 1, -0.0}}};
  const std::string numbers[] = {"+.5 -0 1e-999\n", "1. 1E-310 +0e5\n", "0 00001.000 -1e-4000\n"};
  const std::string all = numbers[0] + numbers[1] + numbers[2];
  const std::string files[] = {
    write("a.off", "OFF\n3 1 0\n" + all + "+3 +0 0000000000001 2\n"),
    write("a.obj", "v " + numbers[0] + "v " + numbers[1] + "v " + numbers[2] + "f +1 0000000000002 -1\n"),
    write("a.ply", ply_header("ascii", 3, 1) + all + "+3 +0 0000000000001 2\n"),
    write("a.ts", "GOCAD TSurf 1\nTFACE\nVRTX 0 " + numbers[0] + "VRTX 1 " + numbers[1] + "VRTX 2 " + numbers[2] +
                    "TRGL +0 00001 2\nEND\n"),
    write("a.stl", "solid\nfacet\nvertex " + numbers[0] + "vertex " + numbers[1] + "vertex " + numbers[2] +
                     "endfacet\nendsolid\n")};
  for (const std::string& file : files) {
    SCOPED_TRACE(file);
    const idt::Surface_input input = idt::read_surface(file);
    expect_same_bits(input.points, points);
    EXPECT_EQ(input.triangles, (Triangles{{{0, 1, 2}}}));
  }
  // The nearest float to a number may differ from that of the nearest double.
  const idt::Surface_input input = idt::read_surface(
    write("a.ply", ply_header("ascii", 3, 1, "float") + "1.00000005960464477540 0 0\n1 1e-60 0\n0 1 3e38\n3 0 1 2\n"));
  EXPECT_EQ(input.points[0][0], double(std::nextafter(1.f, 2.f)));
  EXPECT_EQ(input.points[1][1], 0);
  EXPECT_EQ(input.points[2][2], double(3e38f));
}

// As written by C, by Windows before 2015 (with any number of digits, and a decimal comma), AIX, Java and Fortran.
TEST_F(Read_surface, what_is_not_finite_in_any_spelling)
{
  for (const std::string word : {"nan",       "NaN",
                                 "NAN",       "-nan",
                                 "+nan",      "-nan(ind)",
                                 "nan(snan)", "nan(0x8000000000000)",
                                 "NaNQ",      "NaNS",
                                 "QNAN",      "-SNaN",
                                 "1.#QNAN",   "1.#SNAN",
                                 "-1.#IND",   "1.#INF",
                                 "-1.#INF",   "+1.#INF00e+000",
                                 "1.#J",      "-1.#R0",
                                 "1.#QNAN0",  "1,#INF",
                                 "1#INF",     "-1#IND",
                                 "inf",       "INF",
                                 "-Inf",      "+inf",
                                 "Infinity",  "-INFINITY",
                                 "+Infinity"}) {
    SCOPED_TRACE(word);
    const std::string what = "the coordinate \"" + word + "\" is not finite", face = "3 0 1 2\n",
                      points[] = {"0 0 0", "1 0 " + word, "0 1 0"},
                      all = points[0] + "\n" + points[1] + "\n" + points[2] + "\n",
                      obj = "v " + points[0] + "\nv " + points[1] + "\nv " + points[2] + "\nf 1 2 3\n",
                      stl = "solid\nfacet normal " + word + " 0 0\nouter loop\nvertex " + points[0] + "\nvertex " +
                            points[1] + "\nvertex " + points[2] + "\nendloop\nendfacet\nendsolid\n",
                      ts = "GOCAD TSurf 1\nTFACE\nVRTX 1 " + points[0] + "\nVRTX 2 " + points[1] + "\nVRTX 3 " +
                           points[2] + "\nTRGL 1 2 3\nEND\n";
    for (const auto& [name, content, where] : std::vector<std::array<std::string, 3>>{
           {"a.off", "OFF 3 1 0\n" + all + face, "line 3 (vertex 1)"},
           {"a.obj", obj, "line 2 (vertex 1)"},
           {"a.ply", ply_header("ascii", 3, 1) + all + face, "line 11, element vertex 1"},
           {"a.ply", ply_header("ascii", 3, 1, "float") + all + face, "line 11, element vertex 1"},
           {"a.stl", stl, "line 5 (facet 0)"},
           {"a.ts", ts, "line 4 (vertex 1)"}})
      refused(name, content, where + ": " + what, Defect::NOT_FINITE);

    // Elsewhere than in coordinates, such numbers are accepted.
    std::string ply = ply_header("ascii", 3, 1);
    ply.insert(ply.find("element face"), "property float nx\nproperty list uchar float more\n");
    const std::string more = ' ' + word + " 1 " + word + '\n', normal = ' ' + word + " 0 0\n";
    for (const std::string& file :
         {write("a.ply", ply + "0 0 0" + more + "1 0 0" + more + "0 1 0" + more + face),
          write("a.off", "NOFF 3 1 0\n0 0 0" + normal + "1 0 0" + normal + "0 1 0" + normal + face),
          write("b.off", "OFF 3 1 0\n0 0 0" + normal + "1 0 0" + normal + "0 1 0" + normal + "3 0 1 2 " + word + "\n"),
          write("a.obj",
                "v 0 0 0 " + word + "\nv 1 0 0\nv 0 1 0\nvn " + word + " 0 0\nvt 0 " + word + "\nf 1//1 2//1 3//1\n"),
          write("a.ts",
                "GOCAD TSurf 1\nTFACE\nPVRTX 1 0 0 0 " + word + "\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"),
          write("a.stl", "solid\nfacet normal " + word + " " + word +
                           " 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n")})
      EXPECT_EQ(idt::read_surface(file).triangles, (Triangles{{{0, 1, 2}}})) << file;
  }
  // A comment may follow a number directly.
  EXPECT_EQ(idt::read_surface(write("a.off", "OFF 3 1 0\n0 0 0#QNAN\n1 0 1# #\n0 1 0\n3 0 1 2#x\n")).points[1],
            (std::array<double, 3>{1, 0, 1}));
}

TEST_F(Read_surface, names_with_blanks_and_lists_of_reals_in_ply)
{
  const std::string header =
    "ply\nformat ascii 1.0\nelement my camera 1\nproperty float view px \nelement vertex 3\nproperty float "
    "X\nproperty float Y\nproperty float Bed Elevation\nproperty float Z\nproperty list float float a list\n"
    "element face 1\nproperty list float double vertex_indices\nend_header\n";
  const idt::Surface_input text =
    idt::read_surface(write("a.ply", header + "9\n0 0 7 0 0\n1 0 7 0 1 nan\n0 1 7 5 2 1 2\n3.0 0 1.0 2e0\n"));
  EXPECT_EQ(text.points, (Points{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 5}}}));
  EXPECT_EQ(text.triangles, (Triangles{{{0, 1, 2}}}));

  std::string binary = header;
  binary.replace(binary.find("ascii"), 5, "binary_little_endian");
  append(binary, 9.f);
  for (const auto& p : text.points)
    append(binary, std::array<float, 6>{float(p[0]), float(p[1]), 7, float(p[2]), 1, 2.5f});
  append(binary, 3.f);
  append(binary, std::array<double, 3>{0, 1, 2});
  EXPECT_EQ(idt::read_surface(write("b.ply", binary)).points, text.points);
  EXPECT_EQ(idt::read_surface(write("b.ply", binary)).triangles, text.triangles);
  binary.resize(binary.size() - 8);
  append(binary, 1.5);
  refused("b.ply", binary, "element face 0: the list vertex_indices has 1.5");
  // One property of four bytes.
  std::string floats = ply_header("binary_little_endian", 3, 1, "float", "uchar float");
  append(floats, std::array<float, 9>{0, 0, 0, 1, 0, 0, 0, 1, 0});
  floats += '\3';
  append(floats, std::array<float, 3>{0, 1, 2});
  EXPECT_EQ(idt::read_surface(write("c.ply", floats)).triangles, text.triangles);
}

TEST_F(Read_surface, other_elements_of_obj)
{
  const idt::Surface_input input =
    idt::read_surface(write("a.obj", "f 2 3 4\nmg 1 0.5\nusemtl a\nv 0 0 0 1 0.5\nv 1 0 0 # a comment\nvp 1 2 3 \\\n4\n"
                                     "vt 0 \\\n 0\nv 0 1 0\n\tv 0 0 1\nf 1/1 2//1 3/1/1 4\nf\n# f 7\n#f\n"));
  EXPECT_EQ(input.points.size(), 4u);
  EXPECT_EQ(input.first_corner, (std::vector<std::size_t>{0, 3, 7, 7}));
  EXPECT_EQ(input.corners, (std::vector<std::uint32_t>{1, 2, 3, 0, 1, 2, 3}));
}

TEST_F(Read_surface, corners_of_stl_are_merged_by_position)
{
  const float tenth = 0.1f, next = std::nextafter(0.1f, 1.0f);
  const idt::Surface_input input = idt::read_surface(write(
    "a.stl",
    binary_stl({{{0, 0, 0, tenth, 0, 0, 0, 1, 0}}, {{0, 1, 0, tenth, 0, 0, 1, 1, 0}}, {{next, 0, 0, 1, 1, 0, 2, 2, 2}}},
               3)));
  EXPECT_EQ(input.points.size(), 6u);
  EXPECT_EQ(input.triangles, (Triangles{{{0, 1, 2}}, {{2, 1, 3}}, {{4, 3, 5}}}));
  EXPECT_EQ(input.points[1][0], static_cast<double>(tenth));
}

TEST_F(Read_surface, files_that_are_none)
{
  refused(path("absent.off"), "there is no such file");
  refused(path("absent/absent.off"), "there is no such file");
  fs::create_directory(path("folder.off"));
  refused(path("folder.off"), "this is a directory");
  refused("empty.off", "", "the file is empty");
  refused("name", "what\n", "no extension");
  refused("name.foo", "what\n", "the extension \".foo\" is not known (known are .off, .obj, .ply, .stl, .ts");
  refused("name.foo", "OFF\n", "the file ends before the number of vertices");
  refused("name.foo", "INTRINSIC_GLUING\n", "the contents are those of a file whose name ends with .gluing: rename it");
  refused("name", "glTF\2", "this is binary glTF, and the name has no extension");
  refused("lh.pial", "\xff\xff\xfe", "nibabel reads it: python3 -c");
  refused("name.vtp", "<VTKFile/>", "only if the command is built with VTK");
  const std::string locked = write("locked.off", "OFF\n0 0 0\n");
  fs::permissions(locked, fs::perms::none);
  if (!std::ifstream(locked)) // root can open it anyway
    refused(locked, "cannot be opened (Permission denied)");
}

TEST_F(Read_surface, contents_tell_the_format)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n", v = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::pair<std::string, std::string> contents[] = {
    {"off", "# a comment\nOFF\n3 1 0\n" + points + "3 0 1 2\n"},
    {"obj", v},
    {"ply",
     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
     "property list uchar int vertex_indices\nend_header\n" +
       points + "3 0 1 2\n"},
    {"stl", binary_stl({{{0, 0, 0, 1, 0, 0, 0, 1, 0}}}, 1)},
    {"ts", "GOCAD TSurf 1\nHEADER {\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\nTRGL 1 2 3\nEND\n"}};
  for (const auto& [own, content] : contents) {
    for (const std::string name : {"name", "name.001", "dotted.folder.name"}) {
      const idt::Surface_input input = idt::read_surface(write(name, content));
      EXPECT_EQ(input.triangles, (Triangles{{{0, 1, 2}}})) << own << " as " << name;
      EXPECT_TRUE(input.warnings.empty());
    }
    for (const auto& [other, unused] : contents)
      if (other != own) {
        const idt::Surface_input input = idt::read_surface(write("name." + other, content));
        EXPECT_EQ(input.triangles, (Triangles{{{0, 1, 2}}})) << own << " as " << other;
        ASSERT_EQ(input.warnings.size(), 1u);
        EXPECT_NE(input.warnings[0].find("." + own), std::string::npos) << input.warnings[0];
      }
  }
}

TEST_F(Read_surface, broken_off)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n", head = "OFF\n3 1 0\n";
  refused("a.off", "\n# only this\n", "nothing but white space and comments");
  refused("a.off", "ply\n", "line 1: the file begins with \"ply\" where OFF is expected");
  refused("a.off", "OFF\n", "the file ends before the number of vertices");
  refused("a.off", "OFF\n3 1\n0.5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "line 3: \"0.5\" is not a number of edges");
  refused("a.off", "OFF\n-3 1 0\n" + points, "line 2: \"-3\" is not a number of vertices");
  refused("a.off", "OFF\n2000000000 2000000000 0\n", "more than fit into the 28 bytes of the file");
  refused("a.off", "OFF BINARY\nxxxxxxxxxxxxxxxx", "binary OFF is not read");

  IT::Invalid_surface_error error =
    refused("a.off", head + "0 0 0\n\n# x\n1 nan 0\n0 1 0\n3 0 1 2\n",
            "line 6 (vertex 1): the coordinate \"nan\" is not finite", Defect::NOT_FINITE);
  EXPECT_EQ(error.element(), 1u);
  refused("a.off", head + "0 0 0\n1 0 0\n0 1 -inf\n3 0 1 2\n",
          "line 5 (vertex 2): the coordinate \"-inf\" is not finite", Defect::NOT_FINITE);
  refused("a.off", head + "0 0 0\n1e400 0 0\n0 1 0\n3 0 1 2\n",
          "line 4 (vertex 1): the coordinate \"1e400\" is too large", Defect::OUT_OF_RANGE);
  refused("a.off", head + "0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", "line 4 (vertex 1): \"0,5\" is not a number");
  refused("a.off", head + "0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "line 4 (vertex 1): there are 2 numbers where 3 are needed");
  refused("a.off", "OFF\n7 1 0\n" + points + "3 0 1 2\n4 0 1 2 2\n",
          "line 6 (vertex 3): there are 4 numbers where the vertices before have 3; the header announces 7 vertices "
          "and 1 face on line 2");
  refused("a.off", "OFF\n7 1 0\n" + points + "3 0 1\n4 0 1\n", "the file ends after 5 of 7 vertices");
  refused("a.off", "CNOFF\n3 1 0\n" + points + "3 0 1 2\n",
          "line 3 (vertex 0): there are 3 numbers where 6 are needed");
  refused("a.off", "4OFF\n3 1 0\n0 0 0 1\n1 0 0 0\n0 1 0 1\n3 0 1 2\n",
          "line 4 (vertex 1): the fourth coordinate is zero", Defect::NOT_FINITE);

  refused("a.off", "OFF\n3 2 0\n" + points + "3 0 1 2\n", "the file ends after 1 of 2 faces");
  refused("a.off", head + points + "3 0 1\n", "line 6 (face 0): there are 2 vertices where 3 are announced");
  refused("a.off", head + points + "2000000000 0 1 2\n", "line 6 (face 0): there are 3 vertices where 2000000000");
  refused("a.off", head + points + "x 0 1 2\n", "line 6 (face 0): \"x\" is not a number of corners");
  refused("a.off", head + points + "3 0 1 x\n", "line 6 (face 0): \"x\" is not the index of a vertex");
  error = refused("a.off", "OFF\n3 4 0\n" + points + "3 0 1 2\n3 0 1 3\n3 -1 1 2\n3 7 8 9\n",
                  "line 7 (face 1): the face names vertex 3, but there are 3 vertices (counted from 0), and "
                  "2 more faces like it",
                  Defect::BAD_INDEX);
  EXPECT_EQ(error.element(), 1u);
  EXPECT_EQ(error.count(), 3u);
  refused("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 nan\n", "line 5 (vertex 2): the coordinate \"nan\" is not finite",
          Defect::NOT_FINITE);
}

TEST_F(Read_surface, broken_obj)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  refused("a.obj", points, "there is no face", Defect::EMPTY);
  refused("a.obj", "# nothing\n", "there is no vertex", Defect::EMPTY);
  refused("a.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n", "line 2 (vertex 1): the coordinate \"nan\" is not finite",
          Defect::NOT_FINITE);
  refused("a.obj", "v 0 0 0\nv\t1\t0\nv 0 1 0\nf 1 2 3\n", "line 2 (vertex 1): there are 2 numbers where 3 are needed");
  refused("a.obj", points + "f 1 2 3\nlines 1 2\n", "\"lines 1 2\" is not understood");
  refused("a.obj", points + "l 1 2 \\\n\n3 1\nf 1 2 3\n", "\"3 1\" is not understood");
  refused("a.obj", points + "f 1 2 3\nrubbish\nf 1 2 3\n",
          "line 5: \"rubbish\" is not understood (after 3 vertices and 1 face)");
  const IT::Invalid_surface_error error =
    refused("a.obj", points + "f 1 2 3\nf 1 2 9\nf 1 8 3\n",
            "line 5 (face 1): the face names vertex 9, but there are 3 vertices (counted from 1), and 1 more face"
            " like it",
            Defect::BAD_INDEX);
  EXPECT_EQ(error.element(), 1u);
  EXPECT_EQ(error.count(), 2u);
}

TEST_F(Read_surface, broken_ply)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const auto header = [](const char* real, const char* list) { return ply_header("ascii", 3, 1, real, list); };
  refused("a.ply", "OFF\n", "the file begins with \"OFF\" where ply is expected");
  refused("a.ply", "ply\nformat morse 1.0\n", "line 2 of the header: \"format morse 1.0\" is not a format");
  refused("a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", "the header has no end");
  refused("a.ply", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "a property comes before any element");
  refused("a.ply", "ply\nformat ascii 1.0\nelement vertex x\nend_header\n", "has no number of elements");
  refused("a.ply", "ply\nformat ascii 1.0\nend_header\n", "the file has no element vertex", Defect::EMPTY);
  refused("a.ply", header("half", "uchar int"), "line 4 of the header: \"property half x\" has a type");
  EXPECT_EQ(idt::read_surface(write("a.ply", header("int", "uchar int") + points + "3 0 1 2\n")).points[1],
            (std::array<double, 3>{1, 0, 0}));
  refused("a.ply", header("int", "uchar int") + "0 0 0.5\n" + points + "3 0 1 2\n",
          "line 10, element vertex 0: \"0.5\" is not an integer, which is needed for z");
  refused("a.ply", header("list uchar float", "uchar int"), "by the header the vertices have no coordinate x");
  for (const char* const number : {"1.5", "-3e9", "nan"})
    refused("a.ply", header("float", "uchar float") + points + "3 0 " + number + " 2\n",
            "line 13, element face 0: \"" + std::string(number));
  refused("a.ply", header("double", "uchar int") + "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n",
          "line 11, element vertex 1: the coordinate \"nan\" is not finite", Defect::NOT_FINITE);
  refused("a.ply", header("double", "uchar int") + points + "3 0 x 2\n",
          "line 13, element face 0: \"x\" is not an integer");
  refused("a.ply", header("double", "uchar int") + points, "the file ends too early, after 3 vertices and 0 faces");
  refused("a.ply", header("double", "int int") + points + "2000000000 0 1 2\n",
          "element face 0: the list vertex_indices claims more entries than the file has");
  refused("a.ply", header("double", "int int") + points + "-3 0 1 2\n",
          "line 13, element face 0: the list vertex_indices claims a negative number of entries");
  for (const char* const format : {"binary_little_endian", "binary_big_endian"}) {
    std::string binary = ply_header(format, 3, 1, "double", "uint int");
    for (int i = 0; i < 9; ++i)
      append(binary, 1.0);
    refused("a.ply", binary.substr(0, binary.size() - 20), "the header announces 3 elements \"vertex\", more than fit");
    refused("a.ply", binary + "\x7f\x7f\x7f\x7f", "element face 0: the list vertex_indices claims more entries");
  }
  const auto binary_with = [](const double sixth) {
    std::string binary = ply_header("binary_little_endian", 3, 1);
    for (int i = 0; i < 9; ++i)
      append(binary, i == 5 ? sixth : 1.0 * i * i);
    binary += '\3';
    append(binary, std::array<std::int32_t, 3>{{0, 1, -1}});
    return binary;
  };
  refused("a.ply", binary_with(std::numeric_limits<double>::quiet_NaN()),
          "element vertex 1: a coordinate is not finite (the element begins at byte 196)", Defect::NOT_FINITE);
  // Bad indices that the reader lets through are found afterwards.
  const IT::Surface_report report = idt::examine(idt::read_surface(write("a.ply", binary_with(25))));
  ASSERT_NE(report.find(Kind::BAD_INDEX), nullptr);
  EXPECT_TRUE(contains(report.find(Kind::BAD_INDEX)->description, "names vertex -1"));
}

TEST_F(Read_surface, broken_stl)
{
  const std::array<float, 9> good = {{0, 0, 0, 1, 0, 0, 0, 1, 0}};
  std::array<float, 9> bad = good;
  bad[4] = std::numeric_limits<float>::quiet_NaN();
  refused("a.stl", "abc", "shorter than the header of 84 bytes");
  refused("a.stl", binary_stl({good, good}, 1000000000),
          "the header announces 1000000000 facets, the file has"
          " room for 2");
  const IT::Invalid_surface_error error =
    refused("a.stl", binary_stl({good, bad}, 2), "facet 1: a coordinate is not finite", Defect::NOT_FINITE);
  EXPECT_EQ(error.element(), 1u);

  const std::string begin = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  const std::string end = "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  EXPECT_EQ(idt::read_surface(write("a.stl", begin + "vertex 1 0 0\n" + end)).triangles.size(), 1u);
  refused("a.stl", begin + "vertex 1 inf 0\n" + end, "line 5 (facet 0): the coordinate \"inf\" is not finite",
          Defect::NOT_FINITE);
  refused("a.stl", begin + "vertex 1 0\n" + end, "line 5 (facet 0): a vertex has 2 numbers");
  refused("a.stl", begin + end, "line 7 (facet 0): the facet does not have three vertices", Defect::NOT_A_TRIANGLE);
  refused("a.stl", begin + "vertex 1 0 0\n", "the file ends within facet 0");
  // A binary file may begin with the word of a text file.
  std::string binary = binary_stl({good}, 1);
  binary.replace(0, 6, "solid ");
  EXPECT_EQ(idt::read_surface(write("a.stl", binary)).triangles.size(), 1u);
}

TEST_F(Read_surface, broken_ts)
{
  const std::string begin = "GOCAD TSurf 1\nTFACE\nVRTX 0 0 0 0\n";
  const std::string end = "VRTX 2 0 1 0\nTRGL 0 1 2\n";
  refused("a.ts", begin + "VRTX 1 1 0 0\n" + end, "the file has no line END");
  refused("a.ts", begin + "VRTX 1 1 nan 0\n" + end + "END\n", "line 4 (vertex 1): the coordinate \"nan\"",
          Defect::NOT_FINITE);
  refused("a.ts", "GOCAD TSurf 1\n", "there is no vertex", Defect::EMPTY);
}

// Files cut off anywhere and files with changed bytes are either read or refused.
TEST_F(Read_surface, damaged_files)
{
  std::string binary = ply_header("binary_little_endian", 3, 1, "double", "int int");
  for (int i = 0; i < 9; ++i)
    append(binary, 1.0 * i * i);
  append(binary, std::array<std::int32_t, 4>{{3, 0, 1, 2}});
  const std::map<std::string, std::string> good = {
    {"a.off", "OFF\n3 1 0\n0 0 0\n1 0.5 0\n0 1 0\n3 0 1 2\n"},
    {"b.off", "STCN4OFF\n3 1 0\n0 0 0 1 0 0 1 1 1 1 1 0 0 1\n1 0 0 1 0 0 1 1 1 1 1 0 0 1\n"
              "0 1 0 1 0 0 1 1 1 1 1 0 0 1\n3 0 1 2 1 1 1\n"},
    {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 -1/3\n"},
    {"a.ply", ply_header("ascii", 3, 1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
    {"b.ply", binary},
    {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
              "endfacet\nendsolid a\n"},
    {"b.stl", binary_stl({{{0, 0, 0, 1, 0, 0, 0, 1, 0}}, {{0, 1, 0, 1, 0, 0, 0, 1, 1}}}, 2)},
    {"a.ts", "GOCAD TSurf 1\nTFACE\nVRTX 0 0 0 0\nVRTX 1 1 0 0\nVRTX 2 0 1 0\nTRGL 0 1 2\nEND\n"}};
  std::mt19937 random(11);
  for (const std::pair<const std::string, std::string>& file : good) {
    SCOPED_TRACE(file.first);
    const auto attempt = [&](const std::string& content) {
      const std::string name = write(file.first, content);
      try {
        IT::message(idt::examine(idt::read_surface(name)));
      } catch (const IT::Invalid_surface_error& error) {
        ASSERT_EQ(std::string(error.what()).compare(0, name.size(), name), 0);
        ASSERT_FALSE(contains(error.what(), "CGAL ERROR")) << error.what() << "\n" << content;
      }
    };
    EXPECT_NO_THROW(idt::read_surface(write(file.first, file.second)));
    for (std::size_t length = 0; length < file.second.size(); ++length)
      attempt(file.second.substr(0, length));
    for (int round = 0; round < 1000; ++round) {
      std::string content = file.second;
      for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
        const std::size_t at = random() % content.size();
        if (random() % 2 == 0)
          content[at] = static_cast<char>(random());
        else
          content[at] = " \n-.19ex#"[random() % 9];
      }
      attempt(content);
    }
  }
}

// ---- the collection of bad files --------------------------------------------

// The folder of evaluation data, or empty.
fs::path data_folder()
{
  const char* const variable = std::getenv("IDT_DATA_DIR");
  if (variable != nullptr && *variable != 0)
    return variable;
  for (fs::path checkout = fs::path(__FILE__).parent_path(); !checkout.empty(); checkout = checkout.parent_path()) {
    if (fs::exists(checkout / "include" / "CGAL" / "Intrinsic_triangulations"))
      return checkout / ".." / "shared" / "data";
    if (checkout == checkout.parent_path())
      break;
  }
  return fs::path("..") / "shared" / "data";
}

struct Manifest_row
{
  std::string name;
  std::map<std::string, std::string> fields;
};

std::vector<Manifest_row> read_manifest(const fs::path& path)
{
  std::vector<Manifest_row> rows;
  std::vector<std::string> names;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells(1);
    bool is_quoted = false;
    for (const char c : line) {
      if (c == '"')
        is_quoted = !is_quoted;
      else if (c == ',' && !is_quoted)
        cells.emplace_back();
      else if (c != '\r')
        cells.back() += c;
    }
    if (names.empty()) {
      names = cells;
      continue;
    }
    Manifest_row row;
    for (std::size_t i = 0; i < names.size() && i < cells.size(); ++i)
      row.fields[names[i]] = cells[i];
    row.name = row.fields["name"];
    rows.push_back(row);
  }
  return rows;
}

// "polygons:5 misoriented:2" as a map.
std::map<std::string, std::size_t> read_defects(const std::string& text)
{
  std::map<std::string, std::size_t> defects;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t colon = word.find(':');
    defects[word.substr(0, colon)] = colon == std::string::npos ? 1 : std::stoul(word.substr(colon + 1));
  }
  return defects;
}

TEST(Bad_files, are_refused_or_merely_ugly)
{
  const fs::path folder = data_folder();
  const fs::path manifest = folder / "MANIFEST.csv";
  if (!fs::exists(manifest))
    GTEST_SKIP() << "no evaluation data: set IDT_DATA_DIR to the folder with MANIFEST.csv and bad/";
  static const std::map<std::string, Kind> kinds = {{"no_faces", Kind::EMPTY},
                                                    {"bad_index", Kind::BAD_INDEX},
                                                    {"nonfinite", Kind::NOT_FINITE},
                                                    {"polygons", Kind::NOT_A_TRIANGLE},
                                                    {"repeated_index", Kind::REPEATED_CORNER},
                                                    {"duplicate_faces", Kind::DUPLICATE_FACE},
                                                    {"nonmanifold_edges", Kind::NON_MANIFOLD_EDGE},
                                                    {"misoriented", Kind::INCONSISTENT_ORIENTATION},
                                                    {"nonmanifold_vertices", Kind::NON_MANIFOLD_VERTEX},
                                                    {"unreferenced", Kind::UNREFERENCED_VERTEX},
                                                    {"zero_area", Kind::DEGENERATE_FACE}};
  std::size_t files = 0;
  for (const Manifest_row& row : read_manifest(manifest)) {
    if (row.fields.at("folder") != "bad")
      continue;
    SCOPED_TRACE(row.name);
    ++files;
    const std::string path = (folder / "bad" / (row.name + ".off")).string();
    std::map<std::string, std::size_t> defects = read_defects(row.fields.at("defects"));
    try {
      const idt::Surface_input input = idt::read_surface(path);
      const IT::Surface_report report = idt::examine(input);
      EXPECT_EQ(std::to_string(report.number_of_vertices), row.fields.at("V"));
      EXPECT_EQ(std::to_string(report.number_of_faces), row.fields.at("F"));
      EXPECT_EQ(std::to_string(report.number_of_edges), row.fields.at("E"));
      EXPECT_EQ(std::to_string(report.number_of_components), row.fields.at("components"));
      if (defects.count("no_faces") != 0)
        defects.erase("unreferenced"); // goes without saying
      if (defects.count("repeated_index") != 0)
        defects.erase("zero_area"); // the same face
      for (const std::pair<const std::string, Kind>& kind : kinds) {
        const IT::Finding* const finding = report.find(kind.second);
        EXPECT_EQ(finding == nullptr ? 0 : finding->count, defects.count(kind.first) == 0 ? 0 : defects[kind.first])
          << kind.first;
      }
      try {
        IT::throw_if_fatal(report, path);
        EXPECT_EQ(report.first_fatal(), nullptr);
        ADD_FAILURE() << "a file of bad/ was taken: " << IT::message(report);
      } catch (const IT::Invalid_surface_error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.compare(0, path.size() + 2, path + ": "), 0) << message;
        EXPECT_TRUE(contains(message, "face ") || contains(message, "edge ") || contains(message, "vertex ") ||
                    defects.count("no_faces") != 0)
          << message;
      }
    } catch (const IT::Invalid_surface_error& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.compare(0, path.size() + 2, path + ": "), 0) << message;
      EXPECT_TRUE(contains(message, "(face ") || contains(message, "(vertex ")) << message;
      const char* const defect = error.defect() == Defect::BAD_INDEX    ? "bad_index"
                                 : error.defect() == Defect::NOT_FINITE ? "nonfinite"
                                                                        : "another";
      ASSERT_EQ(defects.count(defect), 1u) << message;
      EXPECT_EQ(error.count(), defects[defect]) << message;
    }
  }
  EXPECT_GT(files, 0u);
}

TEST(Bad_files, good_ones_are_taken)
{
  const fs::path folder = data_folder();
  if (!fs::exists(folder / "MANIFEST.csv"))
    GTEST_SKIP() << "no evaluation data: set IDT_DATA_DIR to the folder with MANIFEST.csv and good/";
  std::size_t files = 0;
  for (const Manifest_row& row : read_manifest(folder / "MANIFEST.csv")) {
    if (row.fields.at("folder") == "bad")
      continue;
    SCOPED_TRACE(row.name);
    ++files;
    const idt::Surface_input input =
      idt::read_surface((folder / row.fields.at("folder") / (row.name + ".off")).string());
    const IT::Surface_report report = idt::examine(input);
    EXPECT_EQ(report.first_fatal(), nullptr) << IT::message(report);
    EXPECT_EQ(std::to_string(report.number_of_edges), row.fields.at("E"));
    EXPECT_EQ(std::to_string(report.number_of_border_edges), row.fields.at("boundary_edges"));
    EXPECT_EQ(std::to_string(report.number_of_components), row.fields.at("components"));
    const IT::Finding* const flat = report.find(Kind::DEGENERATE_FACE);
    EXPECT_EQ(std::to_string(flat == nullptr ? 0 : flat->count), row.fields.at("zero_area_faces"));
  }
  EXPECT_GT(files, 0u);
}

} // namespace

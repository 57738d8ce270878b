// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// VTP files: written by every build, read by one with VTK.

#include "Command_test.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <limits>
#include <sstream>

namespace {

// The parts of a VTP file with a single piece.
struct Vtp
{
  std::string points = "0 0 0  1 0 0  1 1 0  0 1 0", corners = "0 1 2  0 2 3", ends = "3 6";
  std::string number_of_points = "4", number_of_faces = "2";
  std::string cells = "Polys"; // or Lines, Strips, Verts
  std::string type = "Float64";

  std::string text() const
  {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
           number_of_points + "\" NumberOf" + cells + "=\"" + number_of_faces + "\">\n<Points>\n<DataArray type=\"" +
           type + "\" NumberOfComponents=\"3\" format=\"ascii\">\n" + points + "\n</DataArray>\n</Points>\n<" + cells +
           ">\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n" + corners +
           "\n</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n" + ends +
           "\n</DataArray>\n</" + cells + ">\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }
};

// Bytes after their number.
template <class T>
std::string block(const std::vector<T>& values)
{
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(&bytes[0], &size, sizeof size);
  std::memcpy(&bytes[sizeof size], values.data(), size);
  return bytes;
}

// Triangles with all arrays as raw bytes at the end.
std::string binary_vtp(const std::vector<double>& coordinates, const std::vector<std::int64_t>& corners)
{
  std::vector<std::int64_t> ends;
  for (std::size_t c = 3; c <= corners.size(); c += 3)
    ends.push_back(static_cast<std::int64_t>(c));
  const std::string first = block(coordinates), second = block(corners), third = block(ends);
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
          "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\""
       << coordinates.size() / 3 << "\" NumberOfPolys=\"" << ends.size()
       << "\">\n<Points>\n<DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"appended\" offset=\"0\"/>\n"
          "</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" format=\"appended\" offset=\""
       << first.size() << "\"/>\n<DataArray type=\"Int64\" Name=\"offsets\" format=\"appended\" offset=\""
       << first.size() + second.size() << "\"/>\n</Polys>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_"
       << first << second << third << "\n</AppendedData>\n</VTKFile>\n";
  return text.str();
}

class Command_vtp : public Command_test
{
protected:
  bool is_read()
  {
    write("probe.vtp", Vtp().text());
    const Command_run run = idt("triangulate probe.vtp");
    fs::remove(folder_ / "probe.vtp");
    return !contains(run.err, "built with VTK");
  }
  // Expects a refusal in a single line that names the file.
  void expect_refused(const std::string& text, const std::string& part)
  {
    write("bad.vtp", text);
    const Command_run run = idt("triangulate bad.vtp");
    EXPECT_EQ(run.status, 3) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(lines(run.err).size(), 1u) << run.err;
    EXPECT_EQ(run.err.find("idt: bad.vtp: "), 0u) << run.err;
    EXPECT_TRUE(contains(run.err, part)) << run.err;
  }
  // The numbers of the edges, with all digits.
  std::string edges(const std::string& name, const std::string& options = "")
  {
    const Command_run run = idt("triangulate " + name + " --edges edges.csv" + options);
    EXPECT_EQ(run.status, 0) << run.err;
    return content(folder_ / "edges.csv");
  }
};

} // namespace

TEST_F(Command_vtp, is_not_read_without_VTK)
{
  if (is_read())
    GTEST_SKIP() << "the command was built with VTK";
  expect_refused(Vtp().text(), "VTP files can be read only if the command is built with VTK");
}

TEST_F(Command_vtp, is_written_as_polygons)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("triangulate kite.off --overlay o.vtp").status, 0);
  const std::string text = content(folder_ / "o.vtp");
  EXPECT_TRUE(contains(text, "NumberOfPoints=\"5\"")) << text;
  EXPECT_TRUE(contains(text, "NumberOfPolys=\"4\"")) << text;
  EXPECT_TRUE(contains(text, "type=\"Float64\"")) << text;
  // The labels: eight segments as lines, and four faces.
  EXPECT_TRUE(contains(text, "NumberOfLines=\"8\"")) << text;
  EXPECT_TRUE(contains(text, "Name=\"kind\" format=\"ascii\">\n0\n0\n0\n0\n1\n</DataArray>")) << text;
  for (const char* name : {"input_edge", "intrinsic_edge", "label", "input_face", "intrinsic_face"})
    EXPECT_TRUE(contains(text, std::string("<DataArray type=\"Int32\" Name=\"") + name + '"')) << name;
}

TEST_F(Command_vtp, has_distances_on_the_overlay)
{
  write_kite("kite.off");
  ASSERT_EQ(idt("distance kite.off --source 0 --cover none -o d.csv --overlay o.vtp").status, 0);
  const std::vector<std::string> rows = lines(content(folder_ / "d.csv")), vtp = lines(content(folder_ / "o.vtp"));
  ASSERT_EQ(vtp.at(4), "<PointData Scalars=\"distance\">");
  const auto distance = [&rows](std::size_t v) { return std::stod(rows.at(v + 1).substr(2)); };
  for (std::size_t v = 0; v < 4; ++v)
    EXPECT_EQ(std::stod(vtp.at(6 + v)), distance(v));
  EXPECT_NEAR(std::stod(vtp.at(10)), (distance(1) + distance(3)) / 2,
              1e-15); // the new edge from 1 to 3 meets the old one
  ASSERT_EQ(idt("distance kite.off --source 0 --cover none --overlay o.ply").status, 0);
  EXPECT_TRUE(
    contains(content(folder_ / "o.ply"), "property int intrinsic_edge\nproperty double distance\nelement face 4\n"));
  EXPECT_EQ(idt("distance kite.off --source 0 --overlay o.ply").status, 2);
  EXPECT_EQ(idt("distance kite.off --source 0 --cover none --overlay o.off").status, 2);
}

TEST_F(Command_vtp, is_written_for_a_path)
{
  ASSERT_EQ(idt("sample bumpy-dome -o dome.off").status, 0);
  ASSERT_EQ(idt("geodesic dome.off --from 0 --to 99 -o path.vtp").status, 0);
  ASSERT_EQ(idt("geodesic dome.off --from 0 --to 99 -o path.csv").status, 0);
  const std::string text = content(folder_ / "path.vtp");
  const std::size_t points = lines(content(folder_ / "path.csv")).size() - 1;
  EXPECT_TRUE(contains(text, "NumberOfPoints=\"" + std::to_string(points) + '"')) << text;
  EXPECT_TRUE(contains(text, "NumberOfLines=\"1\"")) << text;
}

TEST_F(Command_vtp, gives_the_same_bits_as_text_and_as_bytes)
{
  if (!is_read())
    GTEST_SKIP() << "the command was built without VTK";
  const std::vector<double> coordinates = {0.1,    1 / 3., 5e-324, 1e22, std::nextafter(1., 2.), -0.7,
                                           1e-310, 2.5e21, 1e-300, 7e21, -9007199254740992.,     1.7976931348623157e22};
  std::ostringstream list;
  list << std::setprecision(17);
  for (std::size_t i = 0; i < coordinates.size(); ++i)
    list << coordinates[i] << (i % 3 == 2 ? "\n" : " ");
  Vtp vtp;
  vtp.points = list.str();
  vtp.corners = "0 1 2 1 0 3";
  write("a.off", "OFF\n4 2 0\n" + list.str() + "3 0 1 2\n3 1 0 3\n");
  write("text.vtp", vtp.text());
  write("bytes.vtp", binary_vtp(coordinates, {0, 1, 2, 1, 0, 3}));
  // The first vertices of the overlay are those of the input.
  ASSERT_EQ(idt("triangulate a.off --overlay expected.off").status, 0);
  for (const std::string name : {"text.vtp", "bytes.vtp"}) {
    EXPECT_EQ(edges(name), edges("a.off")) << name;
    ASSERT_EQ(idt("triangulate " + name + " --overlay o.off").status, 0);
    EXPECT_EQ(content(folder_ / "o.off"), content(folder_ / "expected.off")) << name;
  }
  // Written files can be read back.
  ASSERT_EQ(idt("sample bumpy-dome -o dome.off").status, 0);
  ASSERT_EQ(idt("sample bumpy-dome -o dome.vtp").status, 0);
  EXPECT_EQ(edges("dome.vtp"), edges("dome.off"));
  for (const std::string format : {"off", "vtp"})
    ASSERT_EQ(idt("triangulate dome.off --overlay overlay." + format).status, 0);
  EXPECT_EQ(edges("overlay.vtp", " --repair"), edges("overlay.off", " --repair"));
}

TEST_F(Command_vtp, may_be_of_floats_and_of_any_polygons)
{
  if (!is_read())
    GTEST_SKIP() << "the command was built without VTK";
  Vtp floats;
  floats.type = "Float32";
  write("floats.vtp", floats.text());
  EXPECT_EQ(idt("triangulate floats.vtp").status, 0);
  Vtp polygon;
  polygon.number_of_points = "5";
  polygon.points = "0 0 0 2 0 0 2 2 0 1 3 0 0 2 0";
  polygon.number_of_faces = "1";
  polygon.corners = "0 1 2 3 4";
  polygon.ends = "5";
  expect_refused(polygon.text(), "has 5 corners instead of 3; ");
  EXPECT_EQ(idt("triangulate bad.vtp --repair").status, 0);
}

TEST_F(Command_vtp, is_refused_where_it_is_broken)
{
  if (!is_read())
    GTEST_SKIP() << "the command was built without VTK";
  expect_refused("this is no XML", "the file cannot be read");
  expect_refused("<VTKFile/>", "the file cannot be read");
  expect_refused("<VTKFile type=\"UnstructuredGrid\"/>", "the file cannot be read");
  expect_refused("<VTKFile type=\"PolyData\"/>", "the file cannot be read");
  expect_refused("", "the file is empty");
  const auto changed = [](const auto& change) {
    Vtp vtp;
    change(vtp);
    return vtp.text();
  };
  expect_refused(changed([](Vtp& v) { v.cells = "Lines"; }), "2 points or lines and no polygon");
  expect_refused(changed([](Vtp& v) { v.cells = "Strips"; }), "2 triangle strips");
  expect_refused(changed([](Vtp& v) { v.corners = "0 1 2 0 2 9"; }), "names vertex 9, but there are 4 vertices");
  expect_refused(changed([](Vtp& v) { v.corners = "0 1 2 0 2 -1"; }), "names vertex -1");
  expect_refused(changed([](Vtp& v) { v.ends = "6 3"; }), "offset");
  expect_refused(changed([](Vtp& v) { v.ends = "3 7"; }), "connectivity");
  expect_refused(changed([](Vtp& v) { v.ends = "-3 6"; }), "offset");
  expect_refused(changed([](Vtp& v) { v.ends = "3"; }), "offset");
  expect_refused(changed([](Vtp& v) { v.corners = "0 1 2 0"; }), "connectivity");
  expect_refused(changed([](Vtp& v) { v.points = "0 0 0 1 0 0 1 1 0 0 1"; }), "the file cannot be read");
  expect_refused(changed([](Vtp& v) { v.points = "0 0 0 1 0 0 1 nan 0 0 1 0"; }),
                 "vertex 2 has the coordinates (1, nan, 0)");
  expect_refused(changed([](Vtp& v) { v.points = "0 0 0 1 0 0 1 x 0 0 1 0"; }), "the file cannot be read");
  expect_refused(changed([](Vtp& v) { v.number_of_points = "1000000000000"; }), "does not agree with the size");
  expect_refused(changed([](Vtp& v) { v.number_of_faces = "1000000000000"; }), "does not agree with the size");
  expect_refused(changed([](Vtp& v) { v.number_of_points = "-4"; }), "does not agree with the size");
  expect_refused(changed([](Vtp& v) { v.number_of_points = v.number_of_faces = "0"; }), "no face");
  expect_refused(binary_vtp({0, 0, 0, 1, 0, 0, 1, std::numeric_limits<double>::quiet_NaN(), 0}, {0, 1, 2}),
                 "vertex 2 has the coordinates (1, nan, 0)");
}

TEST_F(Command_vtp, is_refused_wherever_it_ends)
{
  if (!is_read())
    GTEST_SKIP() << "the command was built without VTK";
  const std::string text = Vtp().text(), bytes = binary_vtp({0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 1, 2});
  for (const std::string& whole : {text, bytes}) {
    write("bad.vtp", whole);
    EXPECT_EQ(idt("triangulate bad.vtp").status, 0);
  }
  for (std::size_t size = 1; size + 12 < text.size(); size += 37)
    expect_refused(text.substr(0, size), "the file cannot be read");
  // Nothing after the last array is required.
  const std::size_t end = bytes.find("\n</AppendedData>");
  for (std::size_t size = 1; size < end; size += 41)
    expect_refused(bytes.substr(0, size), "the file cannot be read");
  expect_refused(bytes.substr(0, end - 1), "the file cannot be read");
}

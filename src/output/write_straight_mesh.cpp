// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/write_straight_mesh.h"

#include "input/formats/vtp.h"
#include "input/mesh_file.h"
#include "system/Long_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

bool ends_in(const std::string& path, const std::string& extension)
{
  return path.size() > extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), path.rbegin(),
                    [](char a, unsigned char b) { return a == char(std::tolower(b)); });
}

// Tags are unique among regions and lines, because GetFEM keeps them in one list.
void write_msh(std::ostream& os, const IT::Straight_mesh& mesh)
{
  const std::size_t number_of_edges = mesh.marked_edges.size();
  os << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n"
     << mesh.number_of_regions + mesh.number_of_lines << '\n';
  for (std::uint32_t r = 0; r < mesh.number_of_regions; ++r)
    os << "2 " << r + 1 << " \"region_" << r << "\"\n";
  for (std::uint32_t l = 0; l < mesh.number_of_lines; ++l)
    os << "1 " << mesh.number_of_regions + l + 1 << " \"line_" << l << "\"\n";
  os << "$EndPhysicalNames\n$Nodes\n" << mesh.points.size() << '\n';
  write_elements(os, mesh.points.size(), [&](Long_text& text, std::size_t v) {
    const auto& [x, y, z] = mesh.points[v];
    text << v + 1 << ' ' << x << ' ' << y << ' ' << z << '\n';
  });
  os << "$EndNodes\n$Elements\n" << number_of_edges + mesh.triangles.size() << '\n';
  write_elements(os, number_of_edges, [&](Long_text& text, std::size_t i) {
    const std::uint32_t tag = mesh.number_of_regions + mesh.lines[i] + 1;
    text << i + 1 << " 1 2 " << tag << ' ' << tag;
    for (std::uint32_t v : mesh.marked_edges[i])
      text << ' ' << v + 1;
    text << '\n';
  });
  write_elements(os, mesh.triangles.size(), [&](Long_text& text, std::size_t t) {
    text << number_of_edges + t + 1 << " 2 2 " << mesh.regions[t] + 1 << ' ' << mesh.regions[t] + 1;
    for (std::uint32_t v : mesh.triangles[t])
      text << ' ' << v + 1;
    text << '\n';
  });
  os << "$EndElements\n";
}

// CalculiX reads 20 characters of a number, and without a word loses an exponent behind them.
std::string in_twenty_characters(double number)
{
  char text[32];
  std::to_chars_result result = std::to_chars(text, text + sizeof text, number);
  for (int digits = 17; result.ptr > text + 20; --digits)
    result = std::to_chars(text, text + sizeof text, number, std::chars_format::general, digits);
  return std::string(text, result.ptr);
}

// Shells S3, which CalculiX knows, too.
void write_inp(std::ostream& os, const IT::Straight_mesh& mesh)
{
  os << "*NODE\n";
  write_elements(os, mesh.points.size(), [&](Long_text& text, std::size_t v) {
    text << v + 1;
    for (double x : mesh.points[v])
      text << ", " << in_twenty_characters(x);
    text << '\n';
  });
  std::vector<std::vector<std::uint32_t>> triangles(mesh.number_of_regions), ends(mesh.number_of_lines);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    triangles[mesh.regions[t]].push_back(t);
  for (std::size_t i = 0; i < mesh.lines.size(); ++i)
    ends[mesh.lines[i]].insert(ends[mesh.lines[i]].end(), mesh.marked_edges[i].begin(), mesh.marked_edges[i].end());
  for (std::size_t r = 0; r < triangles.size(); ++r) {
    if (triangles[r].empty())
      continue;
    os << "*ELEMENT, TYPE=S3, ELSET=REGION_" << r << '\n';
    write_elements(os, triangles[r].size(), [&](Long_text& text, std::size_t i) {
      const std::uint32_t t = triangles[r][i];
      text << t + 1;
      for (std::uint32_t v : mesh.triangles[t])
        text << ", " << v + 1;
      text << '\n';
    });
  }
  for (std::size_t l = 0; l < ends.size(); ++l) {
    std::sort(ends[l].begin(), ends[l].end());
    ends[l].erase(std::unique(ends[l].begin(), ends[l].end()), ends[l].end());
    os << "*NSET, NSET=LINE_" << l << '\n';
    for (std::uint32_t v : ends[l])
      os << v + 1 << ",\n";
  }
}

// Cells are the lines and then the triangles; -1 where a number means nothing.
void write_vtp_with_regions(std::ostream& os, const IT::Straight_mesh& mesh)
{
  Flat_polygons lines, polygons;
  Named_values regions{"region", {}, 1, "Int32"}, line_numbers{"line", {}, 1, "Int32"},
    input_faces{"input_face", {}, 1, "Int32"};
  const auto add_cell = [&](double region, double line, double input_face) {
    regions.values.push_back(region);
    line_numbers.values.push_back(line);
    input_faces.values.push_back(input_face);
  };
  for (std::size_t i = 0; i < mesh.marked_edges.size(); ++i) {
    lines.add(mesh.marked_edges[i]);
    add_cell(-1, mesh.lines[i], -1);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    polygons.add(mesh.triangles[t]);
    add_cell(mesh.regions[t], -1, mesh.input_faces[t].idx());
  }
  write_vtp(os, mesh.points, polygons, {}, lines, {regions, line_numbers, input_faces});
}

} // namespace

std::string straight_mesh_extensions() { return ".msh, .inp, " + mesh_extensions(false); }

bool is_straight_mesh_name(const std::string& path)
{
  return ends_in(path, ".msh") || ends_in(path, ".inp") || find_mesh_format(path);
}

void write_straight_mesh(std::ostream& os, const IT::Straight_mesh& mesh, const std::string& path)
{
  if (ends_in(path, ".msh"))
    write_msh(os, mesh);
  else if (ends_in(path, ".inp"))
    write_inp(os, mesh);
  else if (const Mesh_format format = *find_mesh_format(path); format == Mesh_format::VTP)
    write_vtp_with_regions(os, mesh);
  else
    write_mesh(os, mesh.points, mesh.triangles, format);
}

} // namespace idt

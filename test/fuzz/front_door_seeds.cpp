// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Seeds of the front door: small files of every format, good and bad.

#include "fuzz_target.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace fuzz {
namespace {

struct Mesh
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<unsigned>> faces;
};

std::vector<Mesh> meshes()
{
  return {
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}},
    {{{0, 0, 0}, {4, 0.25, 0}, {8, 0, 0}, {4, -0.125, 0}}, {{0, 2, 1}, {0, 3, 2}}}, // a flip
    {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}},         // without area
    {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}},                 // no triangle
    {{{1e150, 0, 0}, {0, 1e-150, 0}, {0, 0, 1}}, {{0, 1, 2}}},
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}}}, // other orientation
    {{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}                        // coincident
  };
}

template <class Number>
std::string raw(Number x, bool is_big_endian = false)
{
  std::string bytes(sizeof(x), '\0');
  std::memcpy(&bytes[0], &x, sizeof(x));
  return is_big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string list(const std::vector<unsigned>& face, unsigned first)
{
  std::ostringstream text;
  for (unsigned v : face)
    text << ' ' << v + first;
  return text.str();
}

std::string off(const Mesh& mesh)
{
  std::ostringstream text;
  text << "OFF\n# a comment\n" << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for (const auto& p : mesh.points)
    text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for (const auto& face : mesh.faces)
    text << face.size() << list(face, 0) << '\n';
  return text.str();
}

std::string obj(const Mesh& mesh)
{
  std::ostringstream text;
  for (const auto& p : mesh.points)
    text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  text << "vn 0 0 1\ng part\n";
  for (const auto& face : mesh.faces)
    text << 'f' << list(face, 1) << '\n';
  return text.str();
}

std::string ply(const Mesh& mesh, const std::string& format)
{
  std::ostringstream text;
  text << "ply\nformat " << format << " 1.0\nelement vertex " << mesh.points.size()
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.faces.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  const bool is_big_endian = format == "binary_big_endian";
  for (const auto& p : mesh.points)
    if (format == "ascii")
      text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    else
      text << raw(p[0], is_big_endian) << raw(p[1], is_big_endian) << raw(p[2], is_big_endian);
  for (const auto& face : mesh.faces) {
    if (format == "ascii") {
      text << face.size() << list(face, 0) << '\n';
      continue;
    }
    text << char(face.size());
    for (unsigned v : face)
      text << raw(std::int32_t(v), is_big_endian);
  }
  return text.str();
}

std::string stl(const Mesh& mesh, bool is_binary)
{
  std::ostringstream text;
  text << (is_binary ? std::string(80, ' ') + raw(std::uint32_t(mesh.faces.size())) : "solid s\n");
  for (const auto& face : mesh.faces) {
    text << (is_binary ? std::string(12, '\0') : "facet normal 0 0 1\nouter loop\n");
    for (int i = 0; i < 3; ++i) {
      const std::array<double, 3>& p = mesh.points[face[i]];
      if (is_binary)
        text << raw(float(p[0])) << raw(float(p[1])) << raw(float(p[2]));
      else
        text << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    text << (is_binary ? std::string(2, '\0') : "endloop\nendfacet\n");
  }
  return text.str() + (is_binary ? "" : "endsolid s\n");
}

std::string ts(const Mesh& mesh)
{
  std::ostringstream text;
  text << "GOCAD TSurf 1\nHEADER {\nname:s\n}\nTFACE\n";
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    text << "VRTX " << i << ' ' << mesh.points[i][0] << ' ' << mesh.points[i][1] << ' ' << mesh.points[i][2] << '\n';
  for (const auto& face : mesh.faces)
    text << "TRGL" << list(face, 0) << '\n';
  return text.str() + "END\n";
}

} // namespace

std::vector<std::string> seed_inputs()
{
  std::vector<std::string> seeds;
  const auto add = [&seeds](char format, const std::string& content) { seeds.push_back(format + content); };
  for (const Mesh& mesh : meshes()) {
    add('\0', off(mesh));
    add('\1', obj(mesh));
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
      add('\2', ply(mesh, format));
    add('\3', stl(mesh, false));
    add('\3', stl(mesh, true));
    add('\4', ts(mesh));
  }
  add('\0', "CNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255\n1 0 0 0 0 1 0 0 0 0\n0 1 0 0 0 1 1 1 1 1\n3 0 1 2 7 7 7\n");
  add('\0', "4OFF\n3 1 0\n0 0 0 1\n1 0 0 2\n0 1 0 0\n3 0 1 2\n");
  add('\0', "OFF BINARY\n3 1 0\n");
  add('\0', "OFF\n4000000000 1 0\n0 0 0\n3 0 1 2\n");
  add('\0', "OFF\n3 1 1073741824\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  add('\0', "OFF\n3 1 0\nnan 0 0\ninf 0 0\n1e999 1 0\n3 0 1 2\n");
  add('\1', "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf -3/1 -2/1/ -1//1\n");
  add('\1', "v 0 0 0\nf 1 2 3\n");
  add('\2', "ply\nformat ascii 1.0\nelement vertex -1\nproperty list uchar float x\nend_header\n");
  add('\5', "INTRINSIC_GLUING 1\n1 3 2\n0 0 0\n0 0 0\n0 3 1\n1 4 1.25\n2 5 2\n");   // a torus
  add('\5', "INTRINSIC_GLUING 1\n2 2 1\n0 1 0\n0 1 1\n2 -1 1.5 # a cone\n");        // glued to itself
  add('\5', "INTRINSIC_GLUING 1\n3 3 1\n0 1 2\n0 -1 1\n1 -1 1\n2 -1 3\n");          // no triangle
  add('\5', "INTRINSIC_GLUING 1\n3 3 2\n0 1 2\n0 2 1\n0 5 1\n1 4 1e-300\n2 3 1\n"); // back to back
  return seeds;
}

} // namespace fuzz

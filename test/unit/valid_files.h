// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same surface in all forms of all formats.

#ifndef IDT_TEST_VALID_FILES_H
#define IDT_TEST_VALID_FILES_H

#include "Surface_file_test.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// A sheet of n by n squares, each cut in two, whose number of faces is 2 n n.
struct Sheet
{
  explicit Sheet(std::uint32_t n)
  {
    for (std::uint32_t i = 0; i <= n; ++i)
      for (std::uint32_t j = 0; j <= n; ++j)
        points.push_back({j + 0.5, i + 0.25, 0.125 * ((i * j) % 3)});
    for (std::uint32_t i = 0; i < n; ++i)
      for (std::uint32_t j = 0; j < n; ++j) {
        const std::uint32_t v = i * (n + 1) + j;
        triangles.push_back({v, v + 1, v + n + 2});
        triangles.push_back({v, v + n + 2, v + n + 1});
      }
  }
  std::string number_of_points() const { return std::to_string(points.size()); }
  std::string number_of_faces() const { return std::to_string(triangles.size()); }

  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

inline std::string text_of(const std::array<double, 3>& p)
{
  const auto number = [](double x) { return std::to_string(int(x * 1000)) + "e-3"; };
  return number(p[0]) + " " + number(p[1]) + " " + number(p[2]);
}
inline std::string text_of(const std::array<std::uint32_t, 3>& t, std::uint32_t first = 0,
                           const std::string& behind = "")
{
  return std::to_string(t[0] + first) + behind + " " + std::to_string(t[1] + first) + behind + " " +
         std::to_string(t[2] + first) + behind;
}

inline std::string off_text(const Sheet& sheet, const std::string& keyword = "OFF\n",
                            const std::string& behind_vertex = "", const std::string& behind_face = "")
{
  std::string text = keyword + sheet.number_of_points() + " " + sheet.number_of_faces() + " 0\n";
  for (const auto& p : sheet.points)
    text += text_of(p) + behind_vertex + "\n";
  for (const auto& t : sheet.triangles)
    text += "3 " + text_of(t) + behind_face + "\n";
  return text;
}
inline std::string obj_text(const Sheet& sheet, const std::string& behind_vertex = "",
                            const std::string& behind_corner = "")
{
  std::string text = "# a sheet\no sheet\n";
  for (const auto& p : sheet.points)
    text += "v " + text_of(p) + behind_vertex + "\n";
  text += "vt 0 0\nvn 0 0 1\ng all\nusemtl grey\ns off\n";
  for (const auto& t : sheet.triangles)
    text += "f " + text_of(t, 1, behind_corner) + "\n";
  return text;
}
inline std::string ts_text(const Sheet& sheet, const std::string& header = "", const std::string& keyword = "VRTX ",
                           const std::string& behind_vertex = "", const std::string& behind_face = "")
{
  std::string text = "GOCAD TSurf 1\nHEADER {\nname:sheet\n}\n" + header + "TFACE\n";
  std::size_t i = 0;
  for (const auto& p : sheet.points)
    text += keyword + std::to_string(++i) + " " + text_of(p) + behind_vertex + "\n";
  for (const auto& t : sheet.triangles)
    text += "TRGL " + text_of(t, 1) + behind_face + "\n";
  return text + "BSTONE 1\nBORDER 1 1 2\nEND\n";
}
inline std::string stl_text(const Sheet& sheet)
{
  std::string text = "solid sheet\n";
  for (const auto& t : sheet.triangles) {
    text += "  facet normal 0 0 1\n    outer loop\n";
    for (const std::uint32_t v : t)
      text += "      vertex " + text_of(sheet.points[v]) + "\n";
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid sheet\n";
}
// \param attribute the last two bytes of each facet
inline std::string stl_bytes(const Sheet& sheet, const std::string& header, std::uint32_t announced,
                             std::uint16_t attribute = 0)
{
  std::string text = header;
  text.resize(80, ' ');
  append(text, announced);
  for (const auto& t : sheet.triangles) {
    append(text, std::array<float, 3>{{0, 0, 1}});
    for (const std::uint32_t v : t)
      for (const double x : sheet.points[v])
        append(text, float(x));
    append(text, attribute);
  }
  return text;
}

struct Ply_form
{
  std::string format = "ascii", real = "float", size = "uchar", index = "int", extra = "", name = "vertex_indices";
};
template <class T>
void append_ply(std::string& text, const T value, const Ply_form& form)
{
  std::string bytes;
  append(bytes, value);
  text += form.format == "binary_big_endian" ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}
inline void append_ply_number(std::string& text, const double value, const std::string& type, const Ply_form& form)
{
  if (form.format == "ascii")
    text += (text.back() == '\n' ? "" : " ") +
            (value == int(value) ? std::to_string(int(value)) : std::to_string(int(value * 1000)) + "e-3");
  else if (type == "double" || type == "float64")
    append_ply(text, value, form);
  else if (type.compare(0, 5, "float") == 0)
    append_ply(text, float(value), form);
  else if (type == "int" || type == "int32" || type == "uint" || type == "uint32")
    append_ply(text, std::int32_t(value), form);
  else if (contains(type, "64"))
    append_ply(text, std::int64_t(value), form);
  else if (contains(type, "short") || contains(type, "16"))
    append_ply(text, std::int16_t(value), form);
  else
    append_ply(text, std::int8_t(value), form);
}
// \param form.extra a property of vertices and faces
inline std::string ply_text(const Sheet& sheet, const Ply_form& form)
{
  const std::string extra = form.extra.empty() ? "" : "property " + form.extra + " extra\n";
  std::string text = "ply\nformat " + form.format + " 1.0\ncomment a sheet\nobj_info made for a test\nelement vertex " +
                     sheet.number_of_points() + "\n";
  for (const std::string name : {"x", "y", "z"})
    text += "property " + form.real + " " + name + "\n";
  text += extra + "element face " + sheet.number_of_faces() + "\nproperty list " + form.size + " " + form.index + " " +
          form.name + "\n" + extra + "end_header\n";
  const auto add = [&](double value, const std::string& type) { append_ply_number(text, value, type, form); };
  const auto end = [&] {
    if (!form.extra.empty())
      add(7, form.extra);
    if (form.format == "ascii")
      text += "\n";
  };
  for (const auto& p : sheet.points) {
    for (const double x : p)
      add(x, form.real);
    end();
  }
  for (const auto& t : sheet.triangles) {
    add(3, form.size);
    for (const std::uint32_t v : t)
      add(v, form.index);
    end();
  }
  return text;
}

struct Valid_file
{
  std::string extension, name, content;
  bool is_binary = false;
};

inline std::string with_line_ends(const std::string& text, const std::string& line_end)
{
  std::string result;
  for (const char c : text)
    result += c == '\n' ? line_end : std::string(1, c);
  return result;
}

inline std::vector<Valid_file> valid_files(std::uint32_t n = 2)
{
  const Sheet sheet(n);
  const std::string stl = stl_text(sheet), one_line = with_line_ends(stl, " ");
  std::string capitals = stl;
  std::transform(capitals.begin(), capitals.end(), capitals.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' && c != 'e' ? char(c - 'a' + 'A') : c; });
  std::string many = stl + stl_text(Sheet(1));
  std::vector<Valid_file> files = {
    {"off", "plain", off_text(sheet)},
    {"off", "in one word", off_text(sheet, "OFF")},
    {"off", "colors", off_text(sheet, "COFF\n", " 255 0 0 255", " 3 0.5 0.5")},
    {"off", "normals and textures", off_text(sheet, "STNOFF # a comment\n\n", " 0 0 1 0.5 0.5")},
    {"off", "fourth coordinate", off_text(sheet, "4OFF\n", " 1")},
    {"off", "dimension", off_text(sheet, "nOFF 3\n")},
    {"off", "CR LF", with_line_ends(off_text(sheet), "\r\n")},
    {"off", "CR", with_line_ends(off_text(sheet), "\r")},
    {"off", "CR in comments", off_text(sheet, "OFF # a\r3 of 4\n", " # f of x\r12 mm", " # one\rv of 3")},
    {"obj", "plain", obj_text(sheet)},
    {"obj", "textures", obj_text(sheet, " 1 0 0", "/1/1")},
    {"obj", "goes on", with_line_ends(obj_text(sheet, " \\\n 1 # a color"), "\n")},
    {"obj", "CR LF", with_line_ends(obj_text(sheet), "\r\n")},
    {"ts", "plain", ts_text(sheet)},
    {"ts", "properties",
     ts_text(sheet, "PROPERTIES a\nTRGL_PROPERTIES b c\nTRGL_ESIZES 1 1\n", "PVRTX ", " 1.5", " 2 3")},
    {"ts", "two parts", ts_text(sheet) + ts_text(Sheet(1))},
    {"stl", "plain", stl},
    {"stl", "capitals", capitals},
    {"stl", "one line", one_line},
    {"stl", "two solids", many},
    {"stl", "CR LF", with_line_ends(stl, "\r\n")},
    {"stl", "binary", stl_bytes(sheet, "a sheet", std::uint32_t(sheet.triangles.size())), true},
    {"stl", "binary with attributes",
     stl_bytes(sheet, "solid COLOR=rgba", std::uint32_t(sheet.triangles.size()), 0x7fff), true}};
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const auto& [real, size, index, extra, name] :
         std::vector<std::array<std::string, 5>>{{"float", "uchar", "int", "", "vertex_indices"},
                                                 {"double", "uint8", "uint32", "", "vertex_index"},
                                                 {"float32", "int", "ushort", "uchar", "vertex_indices"},
                                                 {"float64", "short", "int16", "", "vertex_indices"},
                                                 {"double", "uint64", "int64", "uint64", "vertex_indices"},
                                                 {"float", "uchar", "char", "double", "vertex_index"}})
      files.push_back(
        {"ply", format + " " + index, ply_text(sheet, {format, real, size, index, extra, name}), format != "ascii"});
  for (const std::string format : {"binary_little_endian", "binary_big_endian"}) {
    std::string text = ply_text(sheet, {format, "float"});
    text.insert(text.find("end_header\n") + 11 + 12 * sheet.points.size(), 1, '\0');
    const std::string count = "element face ";
    text.replace(text.find(count), count.size() + sheet.number_of_faces().size(),
                 count + std::to_string(sheet.triangles.size() + 1));
    files.push_back({"ply", format + ", an empty face at first", text, true});
  }
  return files;
}

#endif // IDT_TEST_VALID_FILES_H

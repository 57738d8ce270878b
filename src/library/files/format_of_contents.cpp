// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The format of a file by how it begins, where its name does not tell.

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

std::string other_format(const std::string& begin)
{
  using namespace std::string_literals;
  const auto is_there = [&begin](const std::string& text) { return begin.compare(0, text.size(), text) == 0; };
  const std::pair<std::string, const char*> others[] = {{"\xff\xff\xfe"s, "a FreeSurfer surface"},
                                                        {"\xff\xff\xff"s, "a FreeSurfer surface"},
                                                        {"#!ascii"s, "FreeSurfer ASCII"},
                                                        {"# vtk DataFile"s, "legacy VTK"},
                                                        {"glTF"s, "binary glTF"},
                                                        {"Kaydara FBX"s, "FBX"},
                                                        {"ISO-10303-21"s, "STEP"},
                                                        {"$MeshFormat"s, "Gmsh"},
                                                        {"MeshVersionFormatted"s, "Medit"},
                                                        {"\x89HDF"s, "HDF5"},
                                                        {"CDF\1"s, "NetCDF"},
                                                        {"CDF\2"s, "NetCDF"},
                                                        {"#VRML"s, "VRML"},
                                                        {"xof "s, "DirectX"},
                                                        {"BLENDER"s, "Blender"}};
  for (const auto& [text, name] : others)
    if (is_there(text))
      return name;
  if (is_there("<"))
    for (const char* name : {"GIFTI", "COLLADA", "X3D", "amf", "html", "HTML"})
      if (begin.find(std::string("<") + name) != std::string::npos)
        return name;
  return "";
}

// The first word of a text that is not in a comment tells its format; only binary STL has none.
std::string extension_of_contents(const std::string& begin)
{
  std::istringstream text(begin);
  std::string word;
  while (text >> word && word[0] == '#')
    std::getline(text, word);
  if (word == "ply")
    return begin.find("\ncomment intrinsic triangulation") != std::string::npos ? ".idt" : ".ply";
  if (word == "INTRINSIC_GLUING")
    return ".gluing";
  if (word == "GOCAD")
    return ".ts";
  if (word[0] == '<' && begin.find("<VTKFile") != std::string::npos)
    return ".vtp";
  // Also as COFF, or directly followed by a number.
  if (word.substr(0, 8).find("OFF") != std::string::npos || word == "off")
    return ".off";
  for (const char* element : {"v", "vt", "vn", "vp", "f", "l", "o", "g", "s", "mtllib", "usemtl"})
    if (word == element)
      return ".obj";
  const bool is_solid = word.size() >= 5 && (word.compare(0, 5, "solid") == 0 || word.compare(0, 5, "SOLID") == 0);
  return is_solid || begin.find('\0') != std::string::npos ? ".stl" : "";
}

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/standard_input.h"

#include "system/Interruption.h"
#include "system/system_calls.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

class Standard_input
{
public:
  Standard_input() : unfinished_([this] { folder_ = make_temporary_folder(); }, [this] { remove(); })
  {
    try {
      const std::string path = folder_ + "/content";
      std::ofstream content(path, std::ios::binary);
      const std::string begin = copy_to(content);
      name_ = folder_ + "/standard-input" + extension(begin);
      content.close();
      if (folder_.empty() || !content || std::rename(path.c_str(), name_.c_str()) != 0)
        refuse();
    } catch (...) {
      remove();
      throw;
    }
  }
  Standard_input(const Standard_input&) = delete;
  Standard_input& operator=(const Standard_input&) = delete;
  ~Standard_input() { remove(); }

  const std::string& name() const { return name_; }

private:
  void remove() const
  {
    std::error_code error;
    if (!folder_.empty())
      std::filesystem::remove_all(folder_, error);
  }

  [[noreturn]] static void refuse()
  {
    refuse_file("-", std::string("the standard input cannot be stored in a temporary file: ") + std::strerror(errno));
  }

  // Waits for input; an interruption ends the wait. Returns the first bytes.
  static std::string copy_to(std::ostream& content)
  {
    std::string begin, block(std::size_t(1) << 20, '\0');
    for (;;) {
      if (is_interrupted())
        throw IT::Cancelled_error("-: cancelled while it was read");
      const long size = read_standard_input(&block[0], unsigned(block.size()));
      if (size == 0)
        return begin;
      if (size < 0 && errno != EAGAIN)
        refuse_file("-", std::string("the standard input cannot be read: ") + std::strerror(errno));
      if (size < 0)
        continue;
      if (begin.size() < 4096)
        begin.append(block, 0, std::size_t(size));
      if (!content.write(block.data(), size))
        refuse();
    }
  }

  // The name of an unsupported format, recognized by how its files begin or, in XML, by an element; empty if unknown.
  static std::string other_format(const std::string& begin)
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
  static std::string extension(const std::string& begin)
  {
    if (begin.empty())
      refuse_file("-", "the standard input is empty");
    if (const std::string other = other_format(begin); !other.empty())
      refuse_file("-", "the standard input is " + other +
                         ", which is not read: turn it into OFF, OBJ, PLY, STL or TS before");
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
    if (is_solid || begin.find('\0') != std::string::npos)
      return ".stl";
    refuse_file("-",
                "the format of the standard input is not recognized: write it to a file, whose name tells the format");
  }

  std::string folder_, name_;
  Unfinished unfinished_;
};

std::string& name_of_input()
{
  static std::string name;
  return name;
}

} // namespace

std::string readable_file(const std::string& path)
{
  if (path != "-")
    return path;
  static const Standard_input input;
  name_of_input() = input.name();
  return input.name();
}

std::string with_shown_names(std::string message)
{
  const std::string& name = name_of_input();
  if (!name.empty())
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
      message.replace(at, name.size(), "-");
  return message;
}

} // namespace idt

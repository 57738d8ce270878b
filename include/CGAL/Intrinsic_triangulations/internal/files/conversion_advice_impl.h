// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Which program makes a file that can be read of one that cannot.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/conversion_advice.h>
#include <CGAL/Intrinsic_triangulations/internal/system/shown_text.h>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::string conversion_advice(const std::string& path)
{
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos || path.find('/', dot) != std::string::npos)
    return std::string();
  std::string extension = path.substr(dot) + ' ';
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  const auto is_one_of = [&extension](const std::string& list) { return list.find(extension) != std::string::npos; };

  // As a word for the shell.
  const auto word = [](const std::string& name) {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/+,-";
    if (name.find_first_not_of(plain) == std::string::npos && name[0] != '-')
      return name;
    std::string quoted = name[0] == '-' ? "'./" : "'";
    for (char c : name)
      quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return shown_text(quoted + '\'');
  };
  const std::string stem = path.substr(0, dot), from = word(path);
  if (is_one_of(".glb .gltf .dae .fbx .3mf .3ds .amf .blend .dxf .lwo .x .x3d .ac .ase .ms3d .zae "))
    return "; Assimp reads it: assimp export " + from + ' ' + word(stem + ".obj");
  if (is_one_of(".msh .mesh .meshb .vtk .vtu .inp .med .nas .bdf .xdmf .exo .e .cgns .su2 .ugrid .avs .vol "))
    return "; meshio reads its triangles: meshio convert " + from + ' ' + word(stem + ".off");
  if (is_one_of(".step .stp .iges .igs .brep "))
    return "; Gmsh makes triangles of it: gmsh " + from + " -2 -o " + word(stem + ".stl");
  if (is_one_of(".gz "))
    return "; unpack it: gunzip " + from;
  return std::string();
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_CONVERSION_ADVICE_IMPL_H

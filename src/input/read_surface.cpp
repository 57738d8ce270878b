// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input/read_surface.h"

#ifdef IDT_READS_VTP
#include "input/formats/vtp.h"
#endif
#include "input/mesh_file.h"
#include "input/standard_input.h"
#include "system/Progress.h"
#include "system/text.h"

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <fstream>
#include <functional>
#include <iostream>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// \exception Invalid_surface_error if the extension of the name is not that of a readable format
void check_name(const std::string& path)
{
  static const std::string known = "known are .off, .obj, .ply, .stl, .ts, .gluing, .idt"
#ifdef IDT_READS_VTP
                                   ", .vtp"
#endif
    ;
  const std::string name = path.substr(path.find_last_of('/') + 1);
  const std::size_t dot = name.rfind('.');
  const std::optional<Mesh_format> format = find_mesh_format(path);
  if (!format) {
    std::string begin(4096, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(begin.data(), std::streamsize(begin.size()));
    begin.resize(std::size_t(file.gcount()));
    const std::string advice = IT::conversion_advice(path), other = IT::other_format(begin),
                      extension = other.empty() && advice.empty() ? IT::extension_of_contents(begin) : "";
    if (extension == ".vtp" || extension == ".gluing" || extension == ".idt")
      refuse_file(path, "the contents are those of a file whose name ends with " + extension + ": rename it");
    if (extension.empty())
      refuse_file(path, (other.empty() ? "" : "this is " + other + ", and ") +
                          (dot == std::string::npos
                             ? "the name has no extension that tells the format (" + known + ")"
                             : "the extension " + quoted(name.substr(dot)) + " is not known (" + known + ")" + advice));
  }
#ifndef IDT_READS_VTP
  if (format == Mesh_format::VTP)
    refuse_file(path, "VTP files can be read only if the command is built with VTK: add "
                      "-DINTRINSIC_TRIANGULATIONS_WITH_VTK=ON to the first cmake (" +
                        known + ")");
#endif
}

IT::Polygon_soup read(const std::string& path, const IT::Progress_function& progress)
{
#ifdef IDT_READS_VTP
  if (find_mesh_format(path) == Mesh_format::VTP)
    return read_vtp(path);
#endif
  return IT::read_polygon_soup(path, CGAL::parameters::visitor(std::ref(progress)));
}

} // namespace

Surface_input read_surface(const std::string& path, const IT::Progress_function& progress)
{
  const std::string file = readable_file(path);
  IT::readable_file_size(file); // which exists, or this says why not
  check_name(file);
  return {read(file, progress), path};
}

Surface_input read_and_warn(const std::string& path)
{
  Surface_input input;
  {
    Progress progress(path, "reading");
    input = read_surface(path, std::ref(progress));
  }
  for (const std::string& warning : input.warnings)
    std::cerr << "idt: " << path << ": warning: " << warning << std::endl;
  return input;
}

IT::Surface_report examine(const Surface_input& input)
{
  if (input.is_triangulated())
    return IT::examine_polygons(input.points, input.triangles);
  return IT::examine_polygons(input.points, input.polygons());
}

} // namespace idt

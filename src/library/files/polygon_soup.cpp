// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The reader for the name of a file.

#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include "read_obj.h"
#include "read_off.h"
#include "read_ply.h"
#include "read_stl.h"
#include "read_ts.h"
#include "text_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <exception>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL::Intrinsic_triangulations {
namespace internal {

// A reader for each format. It appends the contents of a file of this size to an empty soup, or refuses the file at the
// first wrong line or element.
using Soup_reader = void(const std::string& path, std::uintmax_t size, const Progress_function&, Polygon_soup&);
template <class Reader>
void read_by(const std::string& path, std::uintmax_t size, const Progress_function& progress, Polygon_soup& soup)
{
  Reader(path, size, progress, soup).read();
}

void require_triangles(const std::string& file_name, const Polygon_soup& soup)
{
  if (soup.is_triangulated())
    return;
  std::size_t first = soup.number_of_faces(), count = 0;
  for (std::size_t f = soup.number_of_faces(); f-- > 0;)
    if (soup.polygon(f).size() != 3) {
      first = f;
      ++count;
    }
  refuse_file(file_name,
              "face " + std::to_string(first) + " is not a triangle (" + std::to_string(count) +
                " such faces); triangulate the faces first",
              Defect::NOT_A_TRIANGLE, first, count);
}

// Refuses contents that are often found under the name of a mesh.
inline void check_contents(const std::string& path)
{
  const std::string head = load_file(path, 100);
  const std::size_t text = (std::min)(head.find_first_not_of(" \t\r\n"), head.size());
  const auto begins_with = [&](const char* const word, const std::size_t at) {
    return head.compare(at, std::strlen(word), word) == 0;
  };
  if (begins_with("\x1f\x8b", 0) || begins_with("PK\3\4", 0) ||
      begins_with("\xfd"
                  "7zXZ",
                  0) ||
      begins_with("7z\xbc\xaf", 0))
    refuse_file(path, "the file is compressed: unpack it first");
  if (begins_with("version https://git-lfs", 0))
    refuse_file(path, "the file is a placeholder for a file in Git LFS: get it with git lfs pull");
  if (begins_with("<!DOCTYPE", text) || begins_with("<!doctype", text) || begins_with("<html", text))
    refuse_file(path, "the file is a web page, not a mesh: it was not downloaded as a file");
}

} // namespace internal

std::uintmax_t readable_file_size(const std::string& file_name)
{
  namespace fs = std::filesystem;
  const auto refuse = [&file_name](const std::string& text) { internal::refuse_file(file_name, text); };
  std::error_code error;
  const fs::file_status status = fs::status(file_name, error);
  if (status.type() == fs::file_type::not_found)
    refuse("there is no such file");
  if (fs::is_directory(status))
    refuse("this is a directory, not a file");
  if (fs::exists(status) && !fs::is_regular_file(status))
    refuse("this is not a regular file");
  errno = 0;
  if (!std::ifstream(file_name, std::ios::binary))
    refuse(std::string("the file cannot be opened") +
           (errno == 0 ? "" : std::string(" (") + std::strerror(errno) + ")"));
  const std::uintmax_t size = fs::file_size(file_name, error);
  if (error)
    refuse("the file cannot be read (" + error.message() + ")");
  return size;
}

std::string conversion_advice(const std::string& file_name)
{
  const std::size_t dot = file_name.rfind('.');
  if (dot == std::string::npos || file_name.find('/', dot) != std::string::npos)
    return std::string();
  const std::string extension = internal::in_small_letters(file_name.substr(dot)) + ' ';
  const auto is_one_of = [&extension](const std::string& list) { return list.find(extension) != std::string::npos; };

  // As a word for the shell.
  const auto word = [](const std::string& name) {
    const std::string plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/+,-";
    if (name.find_first_not_of(plain) == std::string::npos && name[0] != '-')
      return name;
    std::string quoted = name[0] == '-' ? "'./" : "'";
    for (char c : name)
      quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return internal::shown_text(quoted + '\'');
  };
  const std::string stem = file_name.substr(0, dot), from = word(file_name);
  if (is_one_of(".glb .gltf .dae .fbx .3mf .3ds .amf .blend .dxf .lwo .x .x3d .ac .ase .ms3d .zae "))
    return "; Assimp reads it: assimp export " + from + ' ' + word(stem + ".obj");
  // It has positions and triangles as arrays of NumPy.
  const auto by_nibabel = [&](const std::string& arrays) {
    return "; nibabel reads it: python3 -c 'import nibabel as n; V, F = " + arrays +
           R"(; print(*("v %.9g %.9g %.9g" % tuple(p) for p in V), *("f %d %d %d" % tuple(t + 1) for t in F), sep="\n")' > )" +
           word(stem + ".obj");
  };
  if (is_one_of(".gii ") && from == file_name)
    return by_nibabel("n.load(\"" + from + "\").agg_data((\"pointset\", \"triangle\"))");
  if (is_one_of(".white .pial .inflated .smoothwm .orig .sphere ") && from == file_name)
    return by_nibabel("n.freesurfer.read_geometry(\"" + from + "\")");
  if (is_one_of(".vtk ") && from == file_name)
    return "; VTK reads it: python3 -c 'import vtk as k; r = k.vtkGenericDataObjectReader(); r.SetFileName(\"" + from +
           "\"); s = k.vtkDataSetSurfaceFilter(); s.SetInputConnection(r.GetOutputPort()); "
           "t = k.vtkTriangleFilter(); t.PassVertsOff(); t.PassLinesOff(); t.SetInputConnection(s.GetOutputPort()); "
           "t.Update(); p = t.GetOutput(); "
           R"(print(*("v %.17g %.17g %.17g" % p.GetPoint(i) for i in range(p.GetNumberOfPoints())), )"
           R"(*("f %d %d %d" % tuple(p.GetCell(i).GetPointId(j) + 1 for j in range(3)) for i in range(p.GetNumberOfCells())), )"
           R"(sep="\n")' > )" +
           word(stem + ".obj");
  if (is_one_of(".msh .mesh .meshb .vtu .inp .med .nas .bdf .xdmf .exo .e .cgns .su2 .ugrid .avs .vol "))
    return "; meshio reads its faces: meshio convert " + from + ' ' + word(stem + ".ply");
  if (is_one_of(".step .stp .iges .igs .brep "))
    return "; Gmsh makes triangles of it: gmsh " + from + " -2 -o " + word(stem + ".stl");
  if (is_one_of(".gz "))
    return "; unpack it: gunzip " + from;
  return std::string();
}

Polygon_soup internal::read_polygon_soup(const std::string& file_name, const Progress_function& progress)
{
  static constexpr std::pair<const char*, internal::Soup_reader*> readers[] = {
    {".off", internal::read_by<internal::Off_reader>},
    {".obj", internal::read_by<internal::Obj_reader>},
    {".ply", internal::read_ply},
    {".stl", internal::read_stl},
    {".ts", internal::read_by<internal::Ts_reader>}};
  const std::uintmax_t size = readable_file_size(file_name);
  const std::string name = internal::in_small_letters(file_name.substr(file_name.find_last_of('/') + 1));
  const std::string extension = name.substr((std::min)(name.rfind('.'), name.size()));
  const auto reader_for = [](const std::string& extension) {
    return std::find_if(std::begin(readers), std::end(readers), [&](const auto& r) { return r.first == extension; });
  };
  const std::string begin = internal::load_file(file_name, 4096);
  const auto by_name = reader_for(extension), by_contents = reader_for(extension_of_contents(begin)),
             none = std::end(readers);
  const std::string advice = conversion_advice(file_name);
  if (by_name == none && (by_contents == none || !advice.empty() || !other_format(begin).empty()))
    internal::refuse_file(file_name,
                          "neither does the name end with .off, .obj, .ply, .stl or .ts, which tells the format, nor "
                          "do the contents tell it" +
                            advice);
  if (size == 0)
    internal::refuse_file(file_name, "the file is empty");
  Polygon_soup soup;
  try {
    (by_name == none ? by_contents : by_name)->second(file_name, size, progress, soup);
  } catch (const Invalid_surface_error&) {
    internal::check_contents(file_name); // has a better reason, perhaps
    if (by_name == none || by_contents == none || by_contents == by_name)
      throw;
    Polygon_soup other;
    std::exception_ptr error_in_contents;
    try {
      by_contents->second(file_name, size, progress, other);
    } catch (const Invalid_surface_error&) {
      error_in_contents = std::current_exception();
    }
    if (other.number_of_faces() == 0)
      throw;
    if (error_in_contents)
      std::rethrow_exception(error_in_contents);
    other.warnings.push_back(std::string("the contents are those of a file whose name ends with ") +
                             by_contents->first);
    return other;
  } catch (const std::bad_alloc&) {
    soup = Polygon_soup();
    internal::refuse_file(file_name, "there is not enough memory for this file");
  }
  return soup;
}

Polygon_soup::Polygon Polygon_soup::polygon(std::size_t face) const
{
  if (is_triangulated())
    return Polygon{triangles[face].data(), triangles[face].data() + 3};
  return Polygon{corners.data() + first_corner[face], corners.data() + first_corner[face + 1]};
}

std::vector<Polygon_soup::Polygon> Polygon_soup::polygons() const
{
  std::vector<Polygon> result;
  result.reserve(number_of_faces());
  for (std::size_t f = 0; f < number_of_faces(); ++f)
    result.push_back(polygon(f));
  return result;
}

void Polygon_soup::add_face(const std::uint32_t* first, const std::uint32_t* last)
{
  if (is_triangulated()) {
    if (last - first == 3) {
      triangles.push_back({first[0], first[1], first[2]});
      return;
    }
    give_up_triangles();
  }
  corners.insert(corners.end(), first, last);
  first_corner.push_back(corners.size());
}

void Polygon_soup::give_up_triangles()
{
  corners.reserve(3 * triangles.size() + 4);
  first_corner.reserve(triangles.size() + 2);
  first_corner.push_back(0);
  for (const std::array<std::uint32_t, 3>& triangle : triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
    first_corner.push_back(corners.size());
  }
  std::vector<std::array<std::uint32_t, 3>>().swap(triangles);
}

} // namespace CGAL::Intrinsic_triangulations

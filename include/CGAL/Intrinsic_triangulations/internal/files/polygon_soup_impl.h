// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The reader that belongs to the name of a file.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/files/conversion_advice.h>
#include <CGAL/Intrinsic_triangulations/internal/files/formats.h>
#include <CGAL/Intrinsic_triangulations/internal/files/read_obj_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/read_off_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/read_ply_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/read_stl_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/read_ts_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/files/text_file.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>
#include <new>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Soup_format soup_format(const std::string& file_name)
{
  const std::string name = file_name.substr(file_name.find_last_of('/') + 1);
  const std::size_t dot = name.rfind('.');
  std::string extension = dot == std::string::npos ? std::string() : name.substr(dot + 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension == "off"   ? Soup_format::OFF
         : extension == "obj" ? Soup_format::OBJ
         : extension == "ply" ? Soup_format::PLY
         : extension == "stl" ? Soup_format::STL
         : extension == "ts"  ? Soup_format::TS
                              : Soup_format::UNKNOWN;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
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

// Refuses what is often found under the name of a mesh.
inline void check_contents(const std::string& path)
{
  const std::string head = load_file(path, 100);
  const std::size_t text = (std::min)(head.find_first_not_of(" \t\r\n"), head.size());
  const auto begins_with = [&](const char* const word, const std::size_t at) { return head.compare(at, std::strlen(word), word) == 0; };
  if (begins_with("\x1f\x8b", 0) || begins_with("PK\3\4", 0) || begins_with("\xfd"
                                                                            "7zXZ",
                                                                            0) ||
      begins_with("7z\xbc\xaf", 0))
    refuse_file(path, "the file is compressed: unpack it first");
  if (begins_with("version https://git-lfs", 0))
    refuse_file(path, "the file stands for another one, which Git LFS has: get it with git lfs pull");
  if (begins_with("<!DOCTYPE", text) || begins_with("<!doctype", text) || begins_with("<html", text))
    refuse_file(path, "the file is a page of the web and no mesh: it was not downloaded as a file");
}

} // namespace internal

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Polygon_soup read_polygon_soup(const std::string& file_name, const Progress_function& progress)
{
  using internal::Soup_format;
  const std::uintmax_t size = internal::check_file(file_name);
  const Soup_format format = internal::soup_format(file_name);
  if (format == Soup_format::UNKNOWN)
    internal::refuse_file(file_name, "the name does not end with .off, .obj, .ply, .stl or .ts, which tells the format" + internal::conversion_advice(file_name));
  if (size == 0)
    internal::refuse_file(file_name, "the file is empty");
  Polygon_soup soup;
  try {
    switch (format) {
    case Soup_format::OFF:
      internal::read_off(file_name, size, progress, soup);
      break;
    case Soup_format::OBJ:
      internal::read_obj(file_name, size, progress, soup);
      break;
    case Soup_format::PLY:
      internal::read_ply(file_name, size, progress, soup);
      break;
    case Soup_format::STL:
      internal::read_stl(file_name, size, progress, soup);
      break;
    case Soup_format::TS:
    case Soup_format::UNKNOWN:
      internal::read_ts(file_name, size, progress, soup);
      break;
    }
  } catch (const Invalid_surface_error&) {
    internal::check_contents(file_name); // has a better reason, perhaps
    throw;
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    soup = Polygon_soup();
    internal::refuse_file(file_name, "there is not enough memory for this file");
  }
  return soup;
}

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_IMPL_H

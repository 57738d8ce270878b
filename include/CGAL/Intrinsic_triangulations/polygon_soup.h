// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and polygons as arrays, and reading them from files, with messages that name the fault and its place.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_POLYGON_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_POLYGON_SOUP_H

#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief points and polygons as they are in a file, whether they are a surface or not.
///
/// Faces are in `triangles` if all of them have three corners, and in `corners` and `first_corner` otherwise. Indices
/// count from 0; any value may occur, including one of a vertex that does not exist.
struct Polygon_soup
{
  /// \brief the corners of a face, as a range.
  struct Polygon
  {
    const std::uint32_t* first;                          ///< the first corner
    const std::uint32_t* last;                           ///< past the last corner
    const std::uint32_t* begin() const { return first; } ///< returns `first`.
    const std::uint32_t* end() const { return last; }    ///< returns `last`.
    /// returns the number of corners.
    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  std::vector<std::array<double, 3>> points;           ///< the vertices
  std::vector<std::array<std::uint32_t, 3>> triangles; ///< all faces if all are triangles; empty otherwise
  std::vector<std::uint32_t> corners;                  ///< those of all faces if not all are triangles; empty otherwise
  /// face `i` has the corners from `first_corner[i]` to before `first_corner[i + 1]`; empty if all faces are triangles
  std::vector<std::size_t> first_corner;
  /// warnings about a readable file, a sentence for each
  std::vector<std::string> warnings;

  /// returns whether all faces are triangles.
  bool is_triangulated() const { return first_corner.empty(); }
  /// returns the number of faces.
  std::size_t number_of_faces() const { return is_triangulated() ? triangles.size() : first_corner.size() - 1; }
  /// returns the corners of a face. \pre `face < number_of_faces()`
  Polygon polygon(std::size_t face) const;
  /// returns all faces, as ranges into the arrays. O(number of faces).
  std::vector<Polygon> polygons() const;

  /// appends a face, of any number of corners.
  void add_face(const std::uint32_t* first, const std::uint32_t* last);

private:
  // Called for the first face that is not a triangle.
  void give_up_triangles();
};

namespace internal {

Polygon_soup read_polygon_soup(const std::string& file_name, const Progress_function& progress);
// \exception Invalid_surface_error that names the file and a face that is not a triangle
void require_triangles(const std::string& file_name, const Polygon_soup& soup);

} // namespace internal

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads the points and polygons of an OFF, OBJ, PLY, STL or TS file; its extension, in lower or upper case,
/// determines the format, or its contents if there is no such extension, or a wrong one.
///
/// Nothing is merged, turned or left out. But STL has no vertices, only corners: those at the same position become one
/// vertex. Colors, normals and textures are skipped, and in OBJ everything but vertices and faces. Anything else that
/// is not understood, missing or left over is an error, or a warning in the result if the meaning is clear.
///
/// Each coordinate becomes the nearest double; in PLY files with properties `float`, the nearest float.
///
/// \param file_name the name of a file that does not change while it is read
/// \param np an optional sequence of named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamVisitor{is called for each megabyte of the file with the fraction that was read, and can cancel}
/// \cgalNamedParamsEnd
///
/// \return the points and polygons, which need not form a surface; see `examine_polygons()`
///
/// \exception Invalid_surface_error if the file cannot be read. The message begins with the name of the file, and
///   names the line or the element at fault. Header counts are checked against the file size, so the size of the file
///   bounds the memory
/// \exception Cancelled_error if the visitor asks for it
///
/// O(size of the file); in STL files, vertices are found by hashing.
template <class NamedParameters = parameters::Default_named_parameters>
Polygon_soup read_polygon_soup(const std::string& file_name, const NamedParameters& np = parameters::default_values())
{
  return internal::read_polygon_soup(file_name, internal::progress_function_of(np));
}

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief returns the size of a regular file that can be opened, in bytes.
/// \param file_name the name of the file
/// \exception Invalid_surface_error if there is no such regular file; the message begins with the name of the file
std::uintmax_t readable_file_size(const std::string& file_name);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief returns the extension of the format that a file seems to have, with the dot; the empty string if none is
/// recognized. `.vtp`, `.gluing` and `.idt` are recognized, too, which `read_polygon_soup()` does not read.
/// \param begin its first bytes, some thousand if there are so many
std::string extension_of_contents(const std::string& begin);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief returns the name of the unsupported format that a file seems to have; the empty string if none is recognized.
/// \param begin as for `extension_of_contents()`
std::string other_format(const std::string& begin);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief returns which program converts an unsupported file to a supported format, judged by its extension.
/// \param file_name the name of the file
/// \return for example "; Assimp reads it: assimp export a.glb a.obj", with a command for the shell; the empty string
/// if no program is known
std::string conversion_advice(const std::string& file_name);

/// \ingroup PkgIntrinsicTriangulationsIO
/// \brief reads the points and triangles of a file, as `read_polygon_soup()`.
///
///     std::vector<std::array<double, 3>> points;
///     std::vector<std::array<std::uint32_t, 3>> triangles;
///     read_triangles("mesh.ply", points, triangles);
///     const auto [idt, report] = intrinsic_Delaunay_triangulation(points, triangles);
///
/// \tparam PointRange a model of `BackInsertionSequence` of points that three doubles in braces can initialize, such as
///   `std::array<double, 3>` and the points of a kernel over doubles. Vectors of the types above get the arrays of the
///   reader without a copy
/// \tparam TriangleRange a model of `BackInsertionSequence` of random access ranges of integers that three integers in
/// braces can initialize
///
/// \param file_name as for `read_polygon_soup()`
/// \param points receives the points of the file
/// \param triangles receives the triangles of the file, as indices into `points`
/// \param np as for `read_polygon_soup()`
///
/// \exception Invalid_surface_error as `read_polygon_soup()`, and if a face is not a triangle. The ranges are unchanged
/// then.
/// \exception Cancelled_error if the visitor asks for it
template <class PointRange, class TriangleRange, class NamedParameters = parameters::Default_named_parameters>
void read_triangles(const std::string& file_name, PointRange& points, TriangleRange& triangles,
                    const NamedParameters& np = parameters::default_values())
{
  Polygon_soup soup = read_polygon_soup(file_name, np);
  internal::require_triangles(file_name, soup);
  if constexpr (std::is_same<PointRange, decltype(soup.points)>::value)
    points = std::move(soup.points);
  else {
    points.clear();
    for (const auto& [x, y, z] : soup.points)
      points.push_back({x, y, z});
  }
  if constexpr (std::is_same<TriangleRange, decltype(soup.triangles)>::value)
    triangles = std::move(soup.triangles);
  else {
    using Triangle = typename TriangleRange::value_type;
    using Index = std::decay_t<decltype(std::declval<Triangle&>()[0])>;
    triangles.clear();
    for (const auto& [i, j, k] : soup.triangles)
      triangles.push_back({static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k)});
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_POLYGON_SOUP_H

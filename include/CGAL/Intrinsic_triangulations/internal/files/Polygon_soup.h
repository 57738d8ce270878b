// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Points and polygons as they are in a file.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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
  Polygon polygon(std::size_t face) const
  {
    if (is_triangulated())
      return Polygon{triangles[face].data(), triangles[face].data() + 3};
    return Polygon{corners.data() + first_corner[face], corners.data() + first_corner[face + 1]};
  }
  /// returns all faces, as ranges into the arrays. O(number of faces).
  std::vector<Polygon> polygons() const
  {
    std::vector<Polygon> result;
    result.reserve(number_of_faces());
    for (std::size_t f = 0; f < number_of_faces(); ++f)
      result.push_back(polygon(f));
    return result;
  }

  /// appends a face, of any number of corners.
  void add_face(const std::uint32_t* first, const std::uint32_t* last)
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

private:
  // Called for the first face that is not a triangle.
  void give_up_triangles()
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
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FILES_POLYGON_SOUP_H

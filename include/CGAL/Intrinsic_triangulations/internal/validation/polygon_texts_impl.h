// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of polygon_texts.h.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_IMPL_H

#include <CGAL/Intrinsic_triangulations/internal/config.h>
#include <CGAL/Intrinsic_triangulations/internal/validation/polygon_texts.h>

#include <array>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {
namespace internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string face_text(const Polygon_sides& polygons, const std::size_t face)
{
  std::ostringstream text;
  text << face << " (corners ";
  const std::size_t begin = polygons.begin_of_face(face), end = polygons.begin_of_face(face + 1);
  for (std::size_t c = begin; c < end && c < begin + 8; ++c)
    text << (c == begin ? "" : ", ") << polygons.vertex(c);
  text << (end > begin + 8 ? ", ...)" : ")");
  return text.str();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string edge_text(const Polygon_sides& polygons, const std::size_t side)
{
  const std::array<std::size_t, 2> v = polygons.ends(side);
  return "edge " + std::to_string(v[0]) + "-" + std::to_string(v[1]);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string faces_text(const Polygon_sides& polygons, const std::size_t side)
{
  std::string text;
  std::size_t written = 0;
  bool is_complete = true;
  polygons.for_each_face_of_edge(side, [&](const std::size_t face) {
    if (written == 8)
      return is_complete = false;
    text += (written++ == 0 ? "" : ", ") + std::to_string(face);
    return true;
  });
  return (written == 1 ? "face " : "faces ") + text + (is_complete ? "" : ", ...");
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::string index_text(const std::size_t value)
{
  constexpr std::size_t none = Polygon_sides::none;
  if (value > (std::numeric_limits<std::size_t>::max)() / 2)
    return "-" + std::to_string(std::size_t(0) - value);
  if (value > none / 2 && value <= none)
    return "-" + std::to_string(none + 1 - value);
  return std::to_string(value);
}

} // namespace internal
} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_VALIDATION_POLYGON_TEXTS_IMPL_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sources and barriers in arrays.

#ifndef IDT_PYTHON_PLACED_ROWS_H
#define IDT_PYTHON_PLACED_ROWS_H

#include "python/Signal_watch.h"
#include "python/arrays.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idt_python {

// For each point the number of a triangle, and barycentric coordinates.
class Placed_rows
{
public:
  // \param first where the points of each source begin, and their number: one is a point, more are a curve
  Placed_rows(const Indices& numbers, const Doubles& coordinates, const Indices& first, const Doubles& offsets)
    : offsets_(copied(offsets))
  {
    const auto begins = copied(first), in_faces = copied(numbers);
    const Rows<double> in_face(coordinates);
    places_.resize(begins.size() - 1);
    for (std::size_t k = 0; k + 1 < begins.size(); ++k)
      for (std::size_t i = begins[k]; i < begins[k + 1]; ++i)
        places_[k].push_back({in_faces[i], {in_face[i][0], in_face[i][1], in_face[i][2]}});
  }

  // \param triangles those of which the complex was made
  std::vector<std::vector<IT::Surface_point>> on(const IT::Delta_complex& complex,
                                                 const std::vector<std::array<std::uint32_t, 3>>& triangles) const
  {
    std::vector<std::vector<IT::Surface_point>> result(places_.size());
    for (std::size_t k = 0; k < places_.size(); ++k)
      for (const IT::Point_in_triangle& p : places_[k]) {
        IT::Halfedge_index h = complex.halfedge(IT::Face_index(IT::Face_index::size_type(p.triangle)));
        while (complex.source(h).idx() != triangles[p.triangle][0])
          h = complex.next(h);
        result[k].push_back({h, p.coordinates});
      }
    return result;
  }
  std::vector<IT::Geodesic_source> sources(const std::vector<std::vector<IT::Surface_point>>& placed) const
  {
    std::vector<IT::Geodesic_source> result;
    for (std::size_t i = 0; i < offsets_.size(); ++i)
      result.push_back({{placed[i]}, offsets_[i]});
    return result;
  }
  std::vector<IT::Geodesic_source> sources(const IT::Tufted_cover& cover,
                                           const std::vector<std::array<std::uint32_t, 3>>& triangles) const
  {
    std::vector<IT::Geodesic_source> result = IT::sources_on_cover(cover, triangles, places_);
    for (std::size_t i = 0; i < offsets_.size(); ++i)
      result[i].offset = offsets_[i];
    return result;
  }

private:
  std::vector<std::vector<IT::Point_in_triangle>> places_;
  std::vector<double> offsets_;
};

} // namespace idt_python

#endif // IDT_PYTHON_PLACED_ROWS_H

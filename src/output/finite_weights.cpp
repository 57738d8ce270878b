// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/finite_weights.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cmath>
#include <cstddef>
#include <string>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

std::string face_text(const IT::Delta_complex& complex, IT::Face_index f)
{
  const IT::Halfedge_index h = complex.halfedge(f), next = complex.next(h);
  return "face " + std::to_string(f.idx()) + " (corners " + std::to_string(complex.source(h).idx()) + ", " +
         std::to_string(complex.source(next).idx()) + ", " + std::to_string(complex.target(next).idx()) + ")";
}

// Border edges are not flipped, so if the face at one has no area now, the input's face there has none, either.
std::string message(const Surface& surface, const IT::Delta_complex& complex, const std::vector<double>& areas)
{
  const IT::Delta_complex& input = surface.connectivity;
  IT::Face_index flat;
  for (IT::Face_index f : complex.faces()) {
    if (areas[f.idx()] > 0)
      continue;
    flat = f;
    const IT::Halfedge_index first = complex.halfedge(f);
    for (IT::Halfedge_index h : {first, complex.next(first), complex.prev(first)})
      if (complex.is_border(complex.edge(h)) && complex.edge(h).idx() < input.number_of_edges()) {
        const IT::Halfedge_index side = input.halfedge(complex.edge(h));
        return face_text(input, input.face(input.is_border(side) ? input.opposite(side) : side)) +
               " has zero area and lies on the border, where no flip removes it, so its cotangents are infinite: "
               "remove it from the mesh";
      }
  }
  if (!flat.is_valid())
    return "a cotangent weight leaves the range of double";
  if (&complex == &input)
    return face_text(input, flat) + " has zero area, so its cotangents are infinite: the flips of the intrinsic "
                                    "Delaunay triangulation remove it";
  return face_text(complex, flat) +
         " of the triangulation has zero area, so its cotangents are infinite: the flips were not finished, or it lies "
         "beside others at a border or kept edge; `idt laplacian` leaves such faces out";
}

} // namespace

void require_finite_weights(const Surface& surface, const IT::Delta_complex& complex,
                            const IT::Element_numbers& numbers)
{
  std::size_t count = 0;
  for (double weight : numbers.cotangent_weights)
    count += !std::isfinite(weight);
  if (count > 0)
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::DEGENERATE_FACE, 0, count,
                                    surface.path + ": " + message(surface, complex, numbers.areas));
}

} // namespace idt

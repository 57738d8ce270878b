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

// Border edges are not flipped: at such an edge, the face of the input has no area if the one that is there now has
// none.
std::string message(const Surface& surface, const IT::Delta_complex& complex, const std::vector<double>& weights)
{
  const auto is_finite = [&](IT::Halfedge_index h) { return std::isfinite(weights[complex.edge(h).idx()]); };
  const IT::Delta_complex& input = surface.connectivity;
  IT::Halfedge_index inner;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index i = complex.halfedge(f), j = complex.next(i), k = complex.prev(i);
    if (is_finite(i) || is_finite(j) || is_finite(k))
      continue;
    for (IT::Halfedge_index h : {i, j, k})
      if (complex.is_border(complex.edge(h)) && complex.edge(h).idx() < input.number_of_edges()) {
        const IT::Halfedge_index side = input.halfedge(complex.edge(h));
        return face_text(input, input.face(input.is_border(side) ? input.opposite(side) : side)) +
               " has zero area and lies on the border, where no flip removes it, so its cotangents are infinite: "
               "remove it from the mesh";
      }
    inner = i;
  }
  if (inner.is_valid() && &complex == &input)
    return face_text(input, input.face(inner)) + " has zero area, so its cotangents are infinite: the flips of the "
                                                 "intrinsic Delaunay triangulation remove it";
  std::size_t e = 0;
  while (std::isfinite(weights[e]))
    ++e;
  const IT::Halfedge_index h = complex.halfedge(IT::Edge_index(e));
  return "edge " + std::to_string(e) + " of the triangulation (joins vertices " +
         std::to_string(complex.source(h).idx()) + " and " + std::to_string(complex.target(h).idx()) +
         ") lies at a face of zero area, so its weight is infinite: the flips were not finished, or the face lies with "
         "others of zero area at the border or at a kept edge; `idt laplacian` leaves such faces out";
}

} // namespace

void require_finite_weights(const Surface& surface, const IT::Delta_complex& complex,
                            const std::vector<double>& weights)
{
  std::size_t count = 0;
  for (IT::Edge_index e : complex.edges())
    count += !std::isfinite(weights[e.idx()]);
  if (count > 0)
    throw IT::Invalid_surface_error(IT::Invalid_surface_error::Defect::DEGENERATE_FACE, 0, count,
                                    surface.path + ": " + message(surface, complex, weights));
}

} // namespace idt

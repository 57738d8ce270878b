// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/finite_weights.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cmath>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

void require_finite_weights(const IT::Delta_complex& complex, const std::vector<double>& weights,
                            const std::string& path)
{
  for (IT::Edge_index e : complex.edges())
    if (!std::isfinite(weights[e.idx()])) {
      const IT::Halfedge_index h = complex.halfedge(e);
      throw IT::Invalid_surface_error(
        IT::Invalid_surface_error::Defect::DEGENERATE_FACE, e.idx(), 1,
        path + ": a face beside edge " + std::to_string(e.idx()) + " (joins vertices " +
          std::to_string(complex.source(h).idx()) + " and " +
          std::to_string(complex.target(h).idx()) +
          ") has no area, so that its cotangents are infinite: remove it, or try --mollify");
    }
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Distances to vertices that have no face in a cover, along the edges of faces without area.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FLAT_WAYS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FLAT_WAYS_H

#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/Index.h>

#include <functional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Distances of all vertices from some sources over the surface alone.
using Surface_distances = std::function<std::vector<double>(const std::vector<Vertex_index>&)>;

// Ways lead over the surface and along flat edges. Wherever flat edges reach a vertex of the surface sooner, ways begin
// there anew.
std::vector<double> distances_along_flat_edges(const Tufted_cover& cover, const Surface_distances& on_surface,
                                               const std::vector<Vertex_index>& sources);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_DISTANCES_FLAT_WAYS_H

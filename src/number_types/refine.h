// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Delaunay refinement, compiled once: it needs exact geometry.

#ifndef IDT_NUMBER_TYPES_REFINE_H
#define IDT_NUMBER_TYPES_REFINE_H

#include "number_types/run.h"

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>

#include <boost/property_map/function_property_map.hpp>

#include <cmath>
#include <vector>

namespace idt {

using Filtered_triangulation =
  CGAL::Intrinsic_triangulations::Intrinsic_triangulation<CGAL::Intrinsic_triangulations::Filtered_edge_length_traits>;

// A flag for each edge as a property map; for later edges it is not set.
// \param flags must outlive the map
inline auto edge_flags(const std::vector<bool>& flags)
{
  using CGAL::Intrinsic_triangulations::Edge_index;
  return boost::make_function_property_map<Edge_index, bool>(
    [&flags](Edge_index e) { return e.idx() < flags.size() && flags[e.idx()]; });
}

// Whether refinement itself finds edges that it does not flip.
inline bool chooses_edges(const Refinement_options& options)
{
  return options.criteria.sharp_edge_angle || std::isfinite(options.criteria.maximum_deviation);
}

// Called after the flips; refines if they found a Delaunay triangulation.
void refine(Filtered_triangulation& triangulation, const Job& job, Outcome& outcome);

// Returns for each edge of the current triangulation whether it is a part of a constrained edge of the input.
std::vector<bool> constrained_parts(const Filtered_triangulation& triangulation,
                                    const std::vector<bool>& is_constrained);

// The same before the refinement, when the triangulation is its input except for flips, or was saved.
// \exception Invalid_surface_error if one of these edges was flipped before the triangulation was saved
std::vector<bool> first_constraints(const Filtered_triangulation& triangulation, const Job& job,
                                    const std::vector<bool>& is_constrained);

} // namespace idt

#endif // IDT_NUMBER_TYPES_REFINE_H

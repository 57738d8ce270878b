// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Templates that are compiled once for the default traits.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DEFAULT_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DEFAULT_TRAITS_H

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/internal/flips/Whole_triangulation.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/triangle_formulas_3.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/metric_construction.h>
#include <CGAL/Intrinsic_triangulations/internal/measures/unit_of_length.h>
#include <CGAL/Intrinsic_triangulations/observer.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

extern template Flip_report flip_all<Sequential_tag, Whole_triangulation<Filtered_edge_length_traits>,
                                     Static_boolean_property_map<Edge_index, false>, Observer<Default_visitor>>(
  Whole_triangulation<Filtered_edge_length_traits>, const Static_boolean_property_map<Edge_index, false>&,
  Observer<Default_visitor>&, std::uint64_t);

extern template void Face_measurer<Sequential_tag, Filtered_edge_length_traits>::measure(std::size_t, std::size_t,
                                                                                         Findings&) const;

extern template int normalize_points<Sequential_tag, Points, Is_used_vertex>(Points&, const Is_used_vertex&);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_FLIPS_DEFAULT_TRAITS_H

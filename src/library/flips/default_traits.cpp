// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Construction and flips with the default traits.

#include <CGAL/Intrinsic_triangulations/internal/flips/default_traits.h>

namespace CGAL::Intrinsic_triangulations::internal {

template Flip_report flip_all<Sequential_tag, Whole_triangulation<Filtered_edge_length_traits>,
                              Static_boolean_property_map<Edge_index, false>, Observer<Default_visitor>>(
  Whole_triangulation<Filtered_edge_length_traits>, const Static_boolean_property_map<Edge_index, false>&,
  Observer<Default_visitor>&, std::uint64_t);

template void Face_measurer<Sequential_tag, Filtered_edge_length_traits>::measure(std::size_t, std::size_t,
                                                                                  Findings&) const;

template int normalize_points<Sequential_tag, Points, Is_used_vertex>(Points&, const Is_used_vertex&);

} // namespace CGAL::Intrinsic_triangulations::internal

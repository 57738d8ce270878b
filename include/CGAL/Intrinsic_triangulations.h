// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// All headers that need neither Eigen, exact numbers, nor a GPL part of CGAL. The GPL headers, for Surface_mesh and for
// the repair of polygons, are named in LICENSE.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_H

#include <CGAL/Intrinsic_triangulations/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/Conformal_map.h>
#include <CGAL/Intrinsic_triangulations/Conformal_metric.h>
#include <CGAL/Intrinsic_triangulations/Delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_path_network.h>
#include <CGAL/Intrinsic_triangulations/Geodesic_source.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Incremental_overlay.h>
#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/Large_vector.h>
#include <CGAL/Intrinsic_triangulations/Overlay.h>
#include <CGAL/Intrinsic_triangulations/Point_location.h>
#include <CGAL/Intrinsic_triangulations/Ptolemy_traits.h>
#include <CGAL/Intrinsic_triangulations/Simplification_map.h>
#include <CGAL/Intrinsic_triangulations/Simplified_distances.h>
#include <CGAL/Intrinsic_triangulations/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/Surface_with_barriers.h>
#include <CGAL/Intrinsic_triangulations/Tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/cut_along_path.h>
#include <CGAL/Intrinsic_triangulations/element_numbers.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/farthest_vertices.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distance_matrix.h>
#include <CGAL/Intrinsic_triangulations/geodesic_distances.h>
#include <CGAL/Intrinsic_triangulations/geodesic_path.h>
#include <CGAL/Intrinsic_triangulations/graph_traits_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/graph_traits_Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/insert_vertex.h>
#include <CGAL/Intrinsic_triangulations/intrinsic_Delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/isolines.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/nearest_source_point.h>
#include <CGAL/Intrinsic_triangulations/polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/refine_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/shortest_path.h>
#include <CGAL/Intrinsic_triangulations/shortest_path_on_triangles.h>
#include <CGAL/Intrinsic_triangulations/sides_of_curve.h>
#include <CGAL/Intrinsic_triangulations/simplify_surface.h>
#include <CGAL/Intrinsic_triangulations/straight_mesh.h>
#include <CGAL/Intrinsic_triangulations/surface_features.h>
#include <CGAL/Intrinsic_triangulations/tangent_vectors.h>
#include <CGAL/Intrinsic_triangulations/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/transfer.h>
#include <CGAL/Intrinsic_triangulations/triangulation_io.h>
#include <CGAL/Intrinsic_triangulations/validate_triangles.h>
#include <CGAL/Intrinsic_triangulations/verify_Delaunay.h>

#endif // CGAL_INTRINSIC_TRIANGULATIONS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What is compiled once of gluings of polygons.

#include <CGAL/Intrinsic_triangulations/internal/gluing/Faces_around_edge.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Faces_around_edge_impl.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Surface_gluer.h>
#include <CGAL/Intrinsic_triangulations/internal/gluing/Surface_gluer_impl.h>

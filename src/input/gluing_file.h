// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces without a place in space: files of triangles, gluings and lengths.

#ifndef IDT_GLUING_FILE_H
#define IDT_GLUING_FILE_H

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/Input_metric.h>

#include <string>
#include <vector>

namespace idt {

// Whether the name ends in `.gluing`, in letters of any case.
bool is_gluing_file(const std::string& path);

// Reads a file of either version. The lengths are there in any case: of squared lengths, the roots are rounded.
// \exception Invalid_surface_error if the file cannot be read or is no gluing; the
//            message begins with `path`
// \exception CGAL::Intrinsic_triangulations::Cancelled_error if `progress` returns false
CGAL::Intrinsic_triangulations::Exact_gluing
read_gluing_file(const std::string& path, const CGAL::Intrinsic_triangulations::Progress_function& progress = {});

// The lengths of edges, within a unit in the last place; infinite or zero where that is out of the range.
std::vector<double> rounded_lengths(const std::vector<CGAL::Intrinsic_triangulations::Rational>& squared_lengths);

} // namespace idt

#endif // IDT_GLUING_FILE_H

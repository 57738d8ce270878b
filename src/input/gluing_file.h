// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Surfaces without positions in space: files of triangles, gluings and lengths.

#ifndef IDT_GLUING_FILE_H
#define IDT_GLUING_FILE_H

#include <CGAL/Intrinsic_triangulations/untwist.h>
#include <CGAL/Intrinsic_triangulations/observer.h>
#include <CGAL/Intrinsic_triangulations/squared_lengths.h>

#include <string>
#include <vector>

namespace idt {

// Whether the name ends in `.gluing`, in any case.
bool is_gluing_file(const std::string& path);

// Reads a file of either version. Lengths are always set: from squared lengths, as rounded roots.
// \exception Invalid_surface_error if the file cannot be read or is not a gluing; the message begins with `path`
// \exception CGAL::Intrinsic_triangulations::Cancelled_error if `progress` returns false
CGAL::Intrinsic_triangulations::Exact_gluing
read_gluing_file(const std::string& path, const CGAL::Intrinsic_triangulations::Progress_function& progress = {});

// The lengths of edges, within a unit in the last place; infinite or zero if out of range.
std::vector<double> rounded_lengths(const std::vector<CGAL::Intrinsic_triangulations::Rational>& squared_lengths);

} // namespace idt

#endif // IDT_GLUING_FILE_H

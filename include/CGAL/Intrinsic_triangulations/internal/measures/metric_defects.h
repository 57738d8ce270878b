// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// The messages about points or lengths that are refused.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_DEFECTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_DEFECTS_H

#include <CGAL/Intrinsic_triangulations/Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

using Defect = Invalid_surface_error::Defect;

// Counts the offending elements and keeps the first.
struct Defect_tally
{
  void add(std::size_t element)
  {
    first = count == 0 ? element : first;
    ++count;
  }
  std::string and_more() const;
  // \exception Invalid_surface_error if there are any: the message names the first one by `subject`, its number and
  // `predicate`
  void refuse(Defect defect, const char* subject, const char* predicate, const char* advice = "") const;
  // The same for numbers that are too small.
  void refuse_underflow(const char* subject, const char* advice = "; remove the outliers") const;

  std::size_t first = 0;
  std::size_t count = 0;
};

// Refuses edges whose squared length is zero. \param is_coincident whether the ends of the first are at the same place
[[noreturn]] void throw_zero_length(const Delta_complex& complex, const Defect_tally& offenders, bool is_coincident);
// For an edge made by a flip.
[[noreturn]] void throw_no_length(const Delta_complex& complex, Edge_index e);

// Lengths of 1e-160 or 1e160 are well within the range of double, but their squares are not.
double area_in_input_unit(double area, int unit_exponent, Face_index f);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INTERNAL_MEASURES_METRIC_DEFECTS_H

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of metric_defects.h.

#include <CGAL/Intrinsic_triangulations/internal/measures/metric_defects.h>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

std::string Defect_tally::and_more() const
{
  return count > 1 ? " (and " + std::to_string(count - 1) + " more)" : std::string();
}

void Defect_tally::refuse(Defect defect, const char* subject, const char* predicate, const char* advice) const
{
  if (count > 0)
    throw Invalid_surface_error(defect, first, count,
                                subject + std::to_string(first) + predicate + and_more() + advice);
}

void Defect_tally::refuse_underflow(const char* subject, const char* advice) const
{
  refuse(Defect::OUT_OF_RANGE, subject,
         " underflows beside the size of the surface: the range of the number type does not hold both", advice);
}

void throw_zero_length(const Delta_complex& complex, const Defect_tally& offenders, bool is_coincident)
{
  const Halfedge_index h = complex.halfedge(Edge_index(std::uint32_t(offenders.first)));
  throw Invalid_surface_error(
    is_coincident ? Defect::ZERO_LENGTH_EDGE : Defect::OUT_OF_RANGE, offenders.first, offenders.count,
    "edge " + std::to_string(offenders.first) + " joins vertices " + std::to_string(complex.source(h).idx()) + " and " +
      std::to_string(complex.target(h).idx()) +
      (is_coincident ? ", which coincide: merge them first"
                     : ", whose squared distance underflows beside the size of the surface") +
      offenders.and_more());
}

void throw_no_length(const Delta_complex& complex, Edge_index e)
{
  const Halfedge_index h = complex.halfedge(e);
  const std::string source = std::to_string(complex.source(h).idx()), target = std::to_string(complex.target(h).idx());
  throw Invalid_surface_error(Defect::ZERO_LENGTH_EDGE, complex.source(h).idx(), 1,
                              complex.is_loop(e)
                                ? "a loop at vertex " + source +
                                    " has length zero: faces of zero area leave no room for triangles there; remove "
                                    "those around it, as repair_polygons() does"
                                : "vertices " + source + " and " + target +
                                    " coincide on the surface, as faces of zero area join them, though no edge does; "
                                    "merge them first, as repair_polygons() does");
}

double area_in_input_unit(double area, int unit_exponent, Face_index f)
{
  using Limits = std::numeric_limits<double>;
  const double result = std::ldexp(area, 2 * unit_exponent);
  if (result > (Limits::max)() || (result < (Limits::min)() && area >= (Limits::min)()))
    throw Invalid_surface_error(
      Defect::OUT_OF_RANGE, f.idx(), 1,
      "face " + std::to_string(f.idx()) +
        ": its area leaves the range of double; scale the surface, or remove the face if that does not help");
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

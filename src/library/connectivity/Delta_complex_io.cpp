// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Definitions of make_Delta_complex.h: gluings as text.

#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include "gluing_text.h"

#include <CGAL/assertions.h>

#include <istream>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

void write_gluing(std::ostream& os, const Delta_complex& complex, const std::vector<double>& lengths)
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  for (Edge_index e : complex.edges())
    if (!internal::is_positive_and_finite(lengths[e.idx()]))
      throw Invalid_surface_error(Invalid_surface_error::Defect::NOT_FINITE, e.idx(), 1,
                                  "the length of edge " + std::to_string(e.idx()) + " is not a positive finite number");
  internal::write_gluing_text(os, complex, 1, [&](std::ostream& text, Edge_index e) { text << lengths[e.idx()]; });
}

Gluing read_gluing(std::istream& is)
{
  internal::Gluing_reader reader(is);
  Gluing result;
  result.complex = reader.read();
  result.lengths = std::move(reader.lengths);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

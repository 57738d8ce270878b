// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/Triangulation_result.h"

#include "output/finite_weights.h"
#include "output/write_symmetric_matrix.h"

#include <CGAL/Intrinsic_triangulations/Laplace_Beltrami.h>

namespace idt {

namespace IT = CGAL::Intrinsic_triangulations;

void write_Laplacian(std::ostream& os, const Triangulation_result& result)
{
  const Outcome& outcome = result.outcome;
  require_finite_weights(result.surface, outcome.connectivity, outcome.numbers);
  write_symmetric_matrix(os, "Laplace-Beltrami operator: -(cot + cot)/2 off the diagonal, row sums zero",
                         IT::stiffness_matrix(outcome.connectivity, outcome.numbers.cotangent_weights));
}

void write_mass(std::ostream& os, const Triangulation_result& result)
{
  write_symmetric_matrix(os, "lumped mass: a third of the area of the faces at each vertex",
                         IT::lumped_mass_matrix(result.outcome.connectivity, result.outcome.numbers.areas));
}

} // namespace idt

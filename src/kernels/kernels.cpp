// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kernels/Kernel.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Uncertain.h>

#include <stdexcept>
#include <string>

namespace idt {
namespace {

Outcome dispatch(const Job& job)
{
  switch (job.options.number_type) {
  case Number_type::FILTERED:
    return run_filtered(job);
  case Number_type::DOUBLE:
    return run_double(job);
  case Number_type::FLOAT:
    return run_float(job);
  case Number_type::LONG_DOUBLE:
    return run_long_double(job);
  case Number_type::FLOAT128:
    return run_float128(job);
  case Number_type::INTERVAL:
    return run_interval(job);
  case Number_type::MPFR:
    return run_mpfr(job);
  case Number_type::CORE:
    return run_core(job);
  case Number_type::HALF_ANGLE_DOUBLE:
    return run_half_angle_double(job);
  case Number_type::HALF_ANGLE_CORE:
    return run_half_angle_core(job);
  }
  throw std::logic_error("there is no such number type");
}

} // namespace

Outcome run(const Job& job)
{
  // What is wrong may lie in the number type (a float holds less than a file can say),
  // so the message names both.
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  const std::string where =
    job.surface.path + ": as " + name(job.options.number_type) + ": ";
  try {
    return dispatch(job);
  } catch (const Invalid_surface_error& error) {
    const bool is_mollifiable = error.defect() == Invalid_surface_error::Defect::TRIANGLE_INEQUALITY;
    throw Invalid_surface_error(
      error.defect(), error.element(), error.count(),
      where + error.what() +
        (is_mollifiable ? "; the option --mollify of triangulate makes edges longer until it holds" : ""));
  } catch (const CGAL::Intrinsic_triangulations::Undecided_error& error) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(where + error.what());
  } catch (const CGAL::Uncertain_conversion_exception&) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(
      where + "a comparison that the construction needs cannot be decided");
  }
}

} // namespace idt

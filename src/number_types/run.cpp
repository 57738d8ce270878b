// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "number_types/run.h"

#include "number_types/Core_diagnostics.h"
#include "number_types/run_with.h"

#include <CGAL/Intrinsic_triangulations/Edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Half_angle_traits.h>
#include <CGAL/Intrinsic_triangulations/Mpfr_float.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>

#ifndef __SIZEOF_FLOAT128__
#include <boost/multiprecision/cpp_bin_float.hpp>
#endif

#include <stdexcept>
#include <string>

namespace idt {
namespace {

#ifdef __SIZEOF_FLOAT128__
using Float128 = __float128;
#else
using Float128 = boost::multiprecision::cpp_bin_float_quad; // the same numbers, slower
#endif
using Core_number = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

template <class Traits>
Outcome run_with_core(const Job& job)
{
  const Discarded_core_diagnostics discarded;
  return run_with<Traits>(job);
}

Outcome run_with_mpfr(const Job& job)
{
  // Numbers take the precision that is in force when they are made, so it must outlive them.
  const IT::Mpfr_precision precision(job.options.precision);
  return run_with<IT::Edge_length_traits<IT::Mpfr_float>>(job);
}

Outcome dispatch(const Job& job)
{
  switch (job.options.number_type) {
  case Number_type::FILTERED:
    return run_with<IT::Filtered_edge_length_traits>(job);
  case Number_type::DOUBLE:
    return run_with<IT::Edge_length_traits<double>>(job);
  case Number_type::FLOAT:
    return run_with<IT::Edge_length_traits<float>>(job);
  case Number_type::LONG_DOUBLE:
    return run_with<IT::Edge_length_traits<long double>>(job);
  case Number_type::FLOAT128:
    return run_with<IT::Edge_length_traits<Float128>>(job);
  case Number_type::INTERVAL:
    return run_with<IT::Edge_length_traits<CGAL::Interval_nt<>>>(job);
  case Number_type::MPFR:
    return run_with_mpfr(job);
  case Number_type::CORE:
    return run_with_core<IT::Edge_length_traits<Core_number>>(job);
  case Number_type::HALF_ANGLE_DOUBLE:
    return run_with<IT::Half_angle_traits<double>>(job);
  case Number_type::HALF_ANGLE_CORE:
    return run_with_core<IT::Half_angle_traits<Core_number>>(job);
  }
  throw std::logic_error("there is no such number type");
}

} // namespace

Outcome run(const Job& job)
{
  // What is wrong may lie in the number type (a float holds less than a file can say),
  // so the message names both.
  using CGAL::Intrinsic_triangulations::Invalid_surface_error;
  const std::string where = job.surface.path + ": as " + name(job.options.number_type) + ": ";
  try {
    return dispatch(job);
  } catch (const Invalid_surface_error& error) {
    const bool is_mollifiable = error.defect() == Invalid_surface_error::Defect::TRIANGLE_INEQUALITY;
    throw Invalid_surface_error(
      error.defect(), error.element(), error.count(),
      where + error.what() +
        (is_mollifiable ? "; the option --mollify of triangulate lengthens edges until it holds" : ""));
  } catch (const CGAL::Intrinsic_triangulations::Undecided_error& error) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(where + error.what());
  } catch (const CGAL::Uncertain_conversion_exception&) {
    throw CGAL::Intrinsic_triangulations::Undecided_error(where +
                                                          "a comparison that the construction needs cannot be decided");
  }
}

} // namespace idt

// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// How a long computation tells how far it is, and how it is stopped.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>

namespace CGAL {
namespace Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief a function that is called from time to time during a long computation, with the fraction that is
/// done, from 0 to 1; if it returns `false`, the computation throws `Cancelled_error`.
///
/// An empty function acts like one that always returns `true`. The flips have a richer interface,
/// `IntrinsicFlipVisitor`.
using Progress_function = std::function<bool(double fraction)>;

/// \cond SKIP_IN_MANUAL
namespace internal {

inline void report_progress(const Progress_function& progress, double fraction, const char* what)
{
  if (progress && !progress(fraction))
    throw Cancelled_error(std::string(what) + " was cancelled");
}

// For a computation that is the part from `begin` to `end` of another one.
inline Progress_function part_of_progress(const Progress_function& progress, double begin, double end)
{
  if (!progress)
    return {};
  return [&progress, begin, end](double fraction) { return progress(begin + (end - begin) * fraction); };
}

// How far an iteration is whose error falls from `first` to `tolerance`: the digits that it has.
inline double fraction_of_digits(double first, double error, double tolerance)
{
  const double all = std::log(first / tolerance);
  return all > 0 ? (std::max)(0., (std::min)(1., std::log(first / error) / all)) : 0;
}

// Asks at every so many of the elements of a loop, which is a part of the computation.
class Loop_progress
{
public:
  Loop_progress(const Progress_function& progress, const char* what, double begin, double end,
                std::size_t number_of_elements)
    : progress_(progress), what_(what), begin_(begin),
      step_((end - begin) / double(number_of_elements + 1))
  {}
  void at(std::size_t element) const
  {
    if (element % stride == 0)
      report_progress(progress_, begin_ + step_ * double(element), what_);
  }

private:
  static constexpr std::size_t stride = 4096;
  const Progress_function& progress_;
  const char* what_;
  double begin_, step_;
};

} // namespace internal
/// \endcond

} // namespace Intrinsic_triangulations
} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H

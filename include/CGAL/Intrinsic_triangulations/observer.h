// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Progress, events and cancellation of long computations: one visitor for all.

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H

#include <CGAL/Intrinsic_triangulations/Index.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/internal/named_parameters.h>
#include <CGAL/Intrinsic_triangulations/reports.h>

#include <CGAL/tags.h>

#include <boost/core/ref.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the progress of a computation. Each algorithm sets the members that it knows; the others are zero.
struct Progress
{
  double fraction = 0;          ///< the part that is done, from 0 to 1
  std::uint64_t tests = 0;      ///< Delaunay tests so far
  std::uint64_t flips = 0;      ///< flips so far
  std::uint64_t insertions = 0; ///< new vertices so far
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief the default of the named parameter `visitor`: it does nothing and never cancels.
///
/// \cgalModels{IntrinsicTriangulationVisitor}
struct Default_visitor
{
  /// is called from time to time: the algorithm throws `Cancelled_error` if it returns `false`.
  bool go_further(const Progress&) { return true; }
  /// is called after each flip.
  void after_flip(Edge_index) {}
  /// is called before each face is refined, with the remaining work.
  void before_step(const Refinement_progress&) {}
  /// is called after each insertion of a vertex by refinement, when the triangulation is Delaunay again; not for the
  /// last one if that is interrupted.
  void after_insertion(Vertex_index) {}
};

/// \ingroup PkgIntrinsicTriangulationsRef
/// \brief a function that is called from time to time during a long computation, with the fraction that is
/// done, from 0 to 1; if it returns `false`, the computation throws `Cancelled_error`.
///
/// An empty function acts like one that always returns `true`.
using Progress_function = std::function<bool(double fraction)>;

namespace internal {

// Whether a V can be passed to a generic lambda, whose return type states the requirements.
template <class V, class Call>
constexpr bool can_call(Call)
{
  return std::is_invocable<Call, V&>::value;
}

// Adapts the visitor given as a named parameter: a model of IntrinsicTriangulationVisitor, whose events may be missing,
// or a function of the progress, of its fraction, or without parameters; by value, or as a std::reference_wrapper.
template <class Given>
class Observer
{
  template <class T>
  static auto& unwrapped(T& visitor)
  {
    return boost::unwrap_ref(visitor);
  }
  template <class T>
  static T& unwrapped(std::reference_wrapper<T>& visitor)
  {
    return visitor.get();
  }

  using Visitor = std::remove_reference_t<decltype(unwrapped(std::declval<Given&>()))>;
  static constexpr bool is_visitor =
    can_call<Visitor>([](auto& v) -> decltype(void(v.go_further(std::declval<const Progress&>()))) {});
  static_assert(is_visitor || std::is_invocable_r_v<bool, Visitor&, const Progress&> ||
                  std::is_invocable_r_v<bool, Visitor&, double> || std::is_invocable_r_v<bool, Visitor&>,
                "a visitor needs a member function bool go_further(const Progress&), or is itself a function of a "
                "Progress, of a fraction or "
                "of nothing that returns bool");

public:
  using Is_silent = Boolean_tag<std::is_same<std::remove_const_t<Visitor>, Default_visitor>::value>;

  template <class Boolean>
  static constexpr bool sees_tests =
    can_call<Visitor>([](auto& v) -> decltype(void(v.after_test(Edge_index(), std::declval<Boolean>()))) {});

  explicit Observer(Given given) : given_(std::move(given)) {}

  bool go_further(const Progress& progress)
  {
    Visitor& visitor = unwrapped(given_);
    if constexpr (is_visitor)
      return visitor.go_further(progress);
    else if constexpr (std::is_same<std::remove_const_t<Visitor>, Progress_function>::value)
      return !visitor || visitor(progress.fraction);
    else if constexpr (std::is_invocable_r_v<bool, Visitor&, const Progress&>)
      return visitor(progress);
    else if constexpr (std::is_invocable_r_v<bool, Visitor&, double>)
      return visitor(progress.fraction);
    else
      return visitor();
  }
  bool go_further(std::uint64_t tests, std::uint64_t flips) { return go_further(Progress{0, tests, flips, 0}); }
  bool operator()() { return go_further(Progress()); }

  void after_flip([[maybe_unused]] Edge_index e)
  {
    if constexpr (can_call<Visitor>([](auto& v) -> decltype(void(v.after_flip(Edge_index()))) {}))
      unwrapped(given_).after_flip(e);
  }
  template <class Boolean>
  void after_test(Edge_index e, const Boolean& is_Delaunay)
  {
    unwrapped(given_).after_test(e, is_Delaunay);
  }
  void before_step([[maybe_unused]] const Refinement_progress& progress)
  {
    if constexpr (can_call<Visitor>(
                    [](auto& v) -> decltype(void(v.before_step(std::declval<const Refinement_progress&>()))) {}))
      unwrapped(given_).before_step(progress);
  }
  void after_insertion([[maybe_unused]] Vertex_index v)
  {
    if constexpr (can_call<Visitor>([](auto& v) -> decltype(void(v.after_insertion(Vertex_index()))) {}))
      unwrapped(given_).after_insertion(v);
  }

private:
  Given given_;
};

template <class NamedParameters>
auto observer_of(const NamedParameters& np)
{
  auto given = parameters::choose_parameter(parameters::get_parameter(np, internal_np::visitor), Default_visitor());
  return Observer<decltype(given)>(std::move(given));
}

// For functions that are compiled once. Empty if there is no visitor.
template <class NamedParameters>
Progress_function progress_function_of(const NamedParameters& np)
{
  using Given = decltype(observer_of(np));
  if constexpr (Given::Is_silent::value)
    return {};
  else
    return [observer = observer_of(np)](double fraction) mutable {
      return observer.go_further(Progress{fraction, 0, 0, 0});
    };
}
template <class NamedParameters>
std::function<bool()> go_further_function_of(const NamedParameters& np)
{
  if constexpr (decltype(observer_of(np))::Is_silent::value)
    return {};
  else
    return observer_of(np);
}

// While it lives, long exact decisions ask a function whether to go on, after the previous one; an empty function is
// not asked.
template <class Triangulation>
class Interruption_scope
{
public:
  Interruption_scope(Triangulation& triangulation, const std::function<bool()>& go_further)
    : triangulation_(triangulation)
  {
    if (!go_further)
      return;
    std::function<bool()> both = [this, go_further] { return (!before_ || before_()) && go_further(); };
    before_ = triangulation.set_interruption(std::move(both));
    is_set_ = true;
  }
  Interruption_scope(const Interruption_scope&) = delete;
  Interruption_scope& operator=(const Interruption_scope&) = delete;
  ~Interruption_scope()
  {
    if (is_set_)
      triangulation_.set_interruption(std::move(before_));
  }

private:
  Triangulation& triangulation_;
  std::function<bool()> before_;
  bool is_set_ = false;
};

inline void report_progress(const Progress_function& progress, double fraction, const char* what)
{
  if (progress && !progress(fraction))
    throw Cancelled_error(std::string(what) + " was cancelled");
}

// For a computation that is the part from `begin` to `end` of a larger one.
inline Progress_function part_of_progress(const Progress_function& progress, double begin, double end)
{
  if (!progress)
    return {};
  return [&progress, begin, end](double fraction) { return progress(begin + (end - begin) * fraction); };
}

// Asks once for every block of elements of a loop, which is a part of the computation.
class Loop_progress
{
public:
  Loop_progress(const Progress_function& progress, const char* what, double begin, double end,
                std::size_t number_of_elements)
    : progress_(progress), what_(what), begin_(begin), step_((end - begin) / double(number_of_elements + 1))
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

// The progress of an iteration whose error falls from `first` to `tolerance`, measured in digits.
inline double fraction_of_digits(double first, double error, double tolerance)
{
  const double all = std::log(first / tolerance);
  return all > 0 ? (std::max)(0., (std::min)(1., std::log(first / error) / all)) : 0;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_OBSERVER_H

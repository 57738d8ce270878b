// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Author(s)     : The Intrinsic_triangulations developers
//
// Raising lengths until the triangle inequality holds with a margin.

#include <CGAL/Intrinsic_triangulations/mollify.h>
#include <CGAL/Intrinsic_triangulations/errors.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Sums of lengths are rounded, so each condition is checked on the final doubles, as others will check it.
class Length_mollifier
{
public:
  Length_mollifier(const Delta_complex& complex, std::vector<double>& lengths, double delta)
    : complex_(complex), lengths_(lengths), delta_(delta)
  {}

  // The smallest number that satisfies every corner when it is added to every length.
  void add_to_all()
  {
    const std::vector<double> old = lengths_;
    double epsilon = 0;
    for (double missing = largest_deficit(); missing > 0; missing = largest_deficit()) {
      // Later rounds only make up for rounding.
      epsilon = (std::max)(epsilon + missing, next_up(epsilon));
      for (std::size_t e = 0; e < old.size(); ++e)
        lengths_[e] = old[e] + epsilon;
    }
  }

  // See mollify_lengths() for the scheme. A side that rounding raised beyond the length that determined it can require
  // a second sweep.
  void add_where_needed()
  {
    do
      sweep();
    while (largest_deficit() > 0);
  }

private:
  void sweep()
  {
    std::priority_queue<std::pair<double, std::uint32_t>> queue;
    for (Edge_index e : complex_.edges()) {
      double& l = length(e);
      if (l < delta_)
        l = delta_;
      queue.emplace(l, e.idx());
    }
    std::vector<std::uint8_t> is_final(lengths_.size(), 0);
    while (!queue.empty()) {
      const auto [l, index] = queue.top();
      queue.pop();
      const Edge_index e(index);
      if (is_final[index] || l != length(e))
        continue; // the entry is out of date
      is_final[index] = 1;
      const Halfedge_index h = complex_.halfedge(e);
      for (Halfedge_index side : {h, complex_.opposite(h)})
        if (!complex_.is_border(side))
          for (Edge_index raised : raise_other_sides(side))
            queue.emplace(length(raised), raised.idx());
    }
  }

  double& length(Edge_index e) { return lengths_[e.idx()]; }

  static double next_up(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

  // By how much `a + b >= c + delta` is violated; not positive if it holds.
  double deficit(double a, double b, double c) const
  {
    const double left = a + b, right = c + delta_;
    return left >= right ? 0 : (std::max)(right - left, next_up(right) - right);
  }

  double largest_deficit()
  {
    double result = 0;
    for (Halfedge_index h : complex_.halfedges())
      if (!complex_.is_border(h))
        result = (std::max)(result, deficit(length(complex_.edge(complex_.next(h))),
                                            length(complex_.edge(complex_.prev(h))), length(complex_.edge(h))));
    return result;
  }

  // Raises the shorter one of the two sides beside `h`, at most up to the longer one, then both, until the corner
  // opposite `h` is satisfied. Returns the raised sides.
  std::vector<Edge_index> raise_other_sides(Halfedge_index h)
  {
    const double c = length(complex_.edge(h));
    Edge_index a = complex_.edge(complex_.next(h)), b = complex_.edge(complex_.prev(h));
    if (length(a) < length(b))
      std::swap(a, b);
    if (deficit(length(a), length(b), c) <= 0)
      return {};
    const double old_a = length(a), half = c / 2 + delta_ / 2;
    length(b) = (std::max)(length(b), (std::min)(c + delta_ - old_a, half));
    length(a) = (std::max)(old_a, half > old_a ? half : length(a));
    while (deficit(length(a), length(b), c) > 0)
      length(length(b) <= length(a) ? b : a) = next_up((std::min)(length(a), length(b)));
    if (a == b || length(a) == old_a)
      return {b};
    return {a, b};
  }

  const Delta_complex& complex_;
  std::vector<double>& lengths_;
  double delta_;
};

Mollification_report mollify(const Delta_complex& complex, std::vector<double>& lengths, double delta_relative,
                             void (Length_mollifier::*lengthen)())
{
  CGAL_precondition(lengths.size() == complex.number_of_edges());
  const auto is_usable = [](double x) { return x >= 0 && x < std::numeric_limits<double>::infinity(); };
  double mean = 0;
  std::size_t first_bad = 0, number_of_bad = 0;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!is_usable(lengths[e]) && number_of_bad++ == 0)
      first_bad = e;
    mean += lengths[e] / double(lengths.size());
  }
  using Defect = Invalid_surface_error::Defect;
  if (number_of_bad > 0)
    throw Invalid_surface_error(Defect::NOT_FINITE, first_bad, number_of_bad,
                                "the length of edge " + std::to_string(first_bad) + " is negative or not finite" +
                                  (number_of_bad > 1 ? " (and " + std::to_string(number_of_bad - 1) + " more)" : ""));
  const double delta = delta_relative * mean;
  if (!is_usable(delta_relative) || !is_usable(delta))
    throw Invalid_surface_error(Defect::OUT_OF_RANGE, 0, 1,
                                "the margin of the mollification is negative or not finite");

  const std::vector<double> old = lengths;
  Length_mollifier mollifier(complex, lengths, delta);
  (mollifier.*lengthen)();

  Mollification_report report;
  report.delta = delta;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (lengths[e] == old[e])
      continue;
    ++report.number_of_changed_edges;
    const double added = lengths[e] - old[e];
    report.epsilon = (std::max)(report.epsilon, added);
    report.largest_relative_change =
      (std::max)(report.largest_relative_change, old[e] > 0 ? added / old[e] : std::numeric_limits<double>::infinity());
  }
  return report;
}

} // namespace internal

Mollification_report mollify_lengths(const Delta_complex& complex, std::vector<double>& lengths, double delta_relative)
{
  return internal::mollify(complex, lengths, delta_relative, &internal::Length_mollifier::add_to_all);
}

Mollification_report mollify_lengths_locally(const Delta_complex& complex, std::vector<double>& lengths,
                                             double delta_relative)
{
  return internal::mollify(complex, lengths, delta_relative, &internal::Length_mollifier::add_where_needed);
}

} // namespace CGAL::Intrinsic_triangulations

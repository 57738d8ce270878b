// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes a surface Delaunay with the package and with the reference, and holds every flip,
// every edge and every number of the one against the other.

#ifndef IDT_TEST_COMPARE_WITH_REFERENCE_H
#define IDT_TEST_COMPARE_WITH_REFERENCE_H

#include "Reference_triangulation.h"
#include "length_interval.h"

#include "samples/sample_surface_types.h"

#include <CGAL/Intrinsic_triangulations/Filtered_edge_length_traits.h>
#include <CGAL/Intrinsic_triangulations/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/errors.h>
#include <CGAL/Intrinsic_triangulations/flip_to_Delaunay.h>
#include <CGAL/Intrinsic_triangulations/make_Delta_complex.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace reference {

namespace IT = CGAL::Intrinsic_triangulations;

using Exact_triangulation = IT::Intrinsic_triangulation<IT::Filtered_edge_length_traits>;

struct Tessellation_edge
{
  Size a, b;     // a <= b
  double length; // rounded from the reference's
  friend bool operator==(const Tessellation_edge& x, const Tessellation_edge& y)
  {
    return x.a == y.a && x.b == y.b && x.length == y.length;
  }
};

struct Comparison
{
  std::vector<std::string> disagreements; // at most a few of each kind
  std::uint64_t flips = 0;                // of the package
  std::uint64_t reference_flips = 0;
  std::uint64_t ties = 0;                      // edges of the result whose opposite angles sum to pi
  IT::Stage_counts stages;                     // of the package's tests
  double worst_length = 0;                     // error of a length in units in the last place
  double worst_area = 0;                       // relative error of an area over 2^-50
  double worst_cotangent = 0;                  // error over 2^-50 (1 + |cot|)
  double worst_weight = 0;                     // error over 2^-49 (1 + the sum of |cot|)
  std::vector<Tessellation_edge> tessellation; // of the package's result
  double inconsistency = -std::numeric_limits<double>::infinity();    // log10 of the rounding error of the reference
  double smallest_sine = 0;                                           // log10 of the closest decision
  double largest_tie_sine = -std::numeric_limits<double>::infinity(); // log10 of the largest number taken for zero

  bool agrees() const { return disagreements.empty(); }
  std::string message() const
  {
    std::string text;
    for (const std::string& line : disagreements)
      text += line + "\n";
    return text;
  }
};

struct Comparison_options
{
  std::vector<char> is_constrained; // by edge; empty: none is
  std::uint64_t maximum_number_of_flips = 20000000;
  bool compare_numbers = true;      // areas, cotangents and weights, too
  bool run_reference = true;        // on its own, beside following the package's flips
  std::function<bool()> go_further; // asked before each test of the package
};

namespace detail {

struct Stop_watch_visitor
{
  const std::function<bool()>& ask;
  std::vector<IT::Edge_index> flipped;
  bool go_further(const IT::Progress& progress) { return !ask || progress.tests % 256 != 0 || ask(); }
  void after_flip(IT::Edge_index e) { flipped.push_back(e); }
};

struct Constraint_map
{
  using key_type = IT::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;
  const std::vector<char>* is_constrained;
  friend bool get(const Constraint_map& map, IT::Edge_index e)
  {
    return !map.is_constrained->empty() && (*map.is_constrained)[e.idx()];
  }
};

// Corners and edges of a face, from the corner with the smallest edge number (then vertex) on.
using Face_record = std::array<Size, 6>;

inline Face_record canonical(const std::array<Size, 3>& corners, const std::array<Size, 3>& edges)
{
  Face_record best{none, none, none, none, none, none};
  for (int c = 0; c < 3; ++c)
    best = (std::min)(best, Face_record{edges[c], corners[c], edges[(c + 1) % 3], corners[(c + 1) % 3],
                                        edges[(c + 2) % 3], corners[(c + 2) % 3]});
  return best;
}

inline std::vector<Face_record> faces_of(const IT::Delta_complex& complex)
{
  std::vector<Face_record> faces;
  for (IT::Face_index f : complex.faces()) {
    const IT::Halfedge_index h = complex.halfedge(f), n = complex.next(h), p = complex.prev(h);
    faces.push_back(canonical({complex.source(h).idx(), complex.source(n).idx(), complex.source(p).idx()},
                              {complex.edge(h).idx(), complex.edge(n).idx(), complex.edge(p).idx()}));
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

inline std::vector<Face_record> faces_of(const Sides& sides)
{
  std::vector<Face_record> faces;
  for (Size s = 0; s < sides.number_of_sides(); s += 3)
    faces.push_back(canonical({sides.corner[s], sides.corner[s + 1], sides.corner[s + 2]},
                              {sides.edge[s], sides.edge[s + 1], sides.edge[s + 2]}));
  std::sort(faces.begin(), faces.end());
  return faces;
}

// |x - exact| in units in the last place of the exact value.
template <class Real>
double error_in_ulp(double x, const Real& exact)
{
  if (!std::isfinite(x))
    return std::numeric_limits<double>::infinity();
  const double rounded = static_cast<double>(exact);
  int exponent = 0;
  if (rounded == 0 || !std::isfinite(rounded))
    return std::numeric_limits<double>::infinity();
  std::frexp(rounded, &exponent);
  const int ulp_exponent = (std::max)(exponent - 53, -1074);
  return static_cast<double>(ldexp(Real(abs(Real(x) - exact)), -ulp_exponent));
}

template <unsigned digits, class Metric>
class Comparer
{
  using Reference = Reference_triangulation<digits>;
  using Real = typename Reference::Real;
  using Edges = std::vector<typename Reference::Measured_edge>;

public:
  Comparer(const Sides& sides, const Metric& metric, const Comparison_options& options)
    : sides_(sides), metric_(metric), options_(options)
  {}

  // Runs both on `triangulation`, the package's copy of the surface.
  Comparison run(Exact_triangulation& triangulation)
  {
    if (faces_of(triangulation.connectivity()) != faces_of(sides_)) {
      complain("input", "the package built other faces or edges");
      return result_;
    }
    Stop_watch_visitor visitor{options_.go_further, {}};
    IT::Flip_report report;
    try {
      report =
        IT::flip_to_Delaunay(triangulation, CGAL::parameters::visitor(std::ref(visitor))
                                              .maximum_number(options_.maximum_number_of_flips)
                                              .edge_is_constrained_map(Constraint_map{&options_.is_constrained}));
    } catch (const IT::Cancelled_error&) {
      report.status = IT::Flip_status::BUDGET_EXHAUSTED;
      report.flips = visitor.flipped.size();
    }
    result_.flips = report.flips;
    if (report.status != IT::Flip_status::DELAUNAY)
      complain("status", "the package's run ended with status " + std::to_string(int(report.status)) + " after " +
                           std::to_string(report.flips) + " flips");
    if (report.flips != visitor.flipped.size())
      complain("report", "the number of flips is wrong");
    if (!triangulation.connectivity().is_valid())
      complain("validity", "the connectivity is not valid");

    Reference replay(sides_, metric_);
    replay_flips(replay, visitor.flipped);
    if (!result_.agrees() && report.status == IT::Flip_status::BUDGET_EXHAUSTED)
      return result_;
    if (faces_of(triangulation.connectivity()) != faces_of(replay.sides()))
      complain("connectivity", "the package's flips lead to another connectivity");
    else
      check_result(triangulation, replay);
    result_.stages = IT::internal::engine(triangulation).decisions().counts;

    const Edges package_edges = replay.unique_edges(options_.is_constrained);
    for (const auto& edge : package_edges)
      result_.tessellation.push_back({edge.a, edge.b, static_cast<double>(sqrt(edge.squared_length))});

    if (!options_.run_reference) {
      note_accuracy(replay);
      return result_;
    }
    Reference own(sides_, metric_);
    const Size flips = own.make_Delaunay(options_.is_constrained);
    result_.reference_flips = flips;
    if (flips == none)
      complain("reference", "the reference does not end");
    else
      compare_tessellations(package_edges, own.unique_edges(options_.is_constrained));
    note_accuracy(replay);
    note_accuracy(own);
    return result_;
  }

private:
  template <class... Text>
  void complain(const std::string& kind, const Text&... text)
  {
    if (++complaints_[kind] > 3)
      return;
    std::ostringstream line;
    line.precision(17);
    line << kind << ": ";
    (line << ... << text);
    result_.disagreements.push_back(line.str());
  }

  void note_accuracy(const Reference& reference)
  {
    result_.inconsistency = (std::max)(result_.inconsistency, reference.inconsistency());
    result_.smallest_sine = (std::min)(result_.smallest_sine, reference.smallest_sine());
    result_.largest_tie_sine = (std::max)(result_.largest_tie_sine, reference.largest_tie_sine());
    if (result_.inconsistency > -80)
      complain("reference", "the reference itself is inexact: 1e" + std::to_string(result_.inconsistency));
  }

  bool is_free(const Reference& replay, Size e) const
  {
    return replay.is_flippable(e) && (options_.is_constrained.empty() || !options_.is_constrained[e]);
  }

  void replay_flips(Reference& replay, const std::vector<IT::Edge_index>& flipped)
  {
    for (std::size_t n = 0; n < flipped.size(); ++n) {
      const Size e = flipped[n].idx();
      if (!is_free(replay, e)) {
        complain("flip", "flip ", n, " of edge ", e, ", which must not be flipped");
        return;
      }
      if (replay.circle_test(e) != Circle_test::NOT_DELAUNAY)
        complain("flip", "flip ", n, " of edge ", e, ", which is Delaunay");
      replay.flip(e);
    }
  }

  void check_result(const Exact_triangulation& triangulation, Reference& replay)
  {
    const IT::Delta_complex& complex = triangulation.connectivity();
    for (IT::Edge_index e : complex.edges()) {
      check_decision(triangulation, replay, e);
      const Real exact = replay.length(e.idx());
      const double length = triangulation.length(e);
      const double error = error_in_ulp(length, exact);
      result_.worst_length = (std::max)(result_.worst_length, error);
      if (!(error <= 1))
        complain("length", "edge ", e.idx(), " has length ", exact, ", the package says ", length);
      const CGAL::Interval_nt<> interval = length_interval(triangulation, e);
      const Real slack = exact * Real("1e-60"); // the reference is not exact either
      if (!(Real(interval.inf()) <= exact + slack && exact - slack <= Real(interval.sup())))
        complain("interval", "edge ", e.idx(), " has length ", exact, ", not in ", interval.inf(), " ... ",
                 interval.sup());
    }
    if (options_.compare_numbers)
      check_numbers(triangulation, replay);
  }

  void check_decision(const Exact_triangulation& triangulation, Reference& replay, IT::Edge_index e)
  {
    if (!replay.is_flippable(e.idx()))
      return;
    const Circle_test test = replay.circle_test(e.idx());
    result_.ties += test == Circle_test::TIE;
    if (test == Circle_test::NOT_DELAUNAY && is_free(replay, e.idx()))
      complain("decision", "edge ", e.idx(), " of the result is not Delaunay");
    const auto answer = triangulation.is_locally_Delaunay(e);
    if (!CGAL::is_certain(answer) || CGAL::certainly(answer) != (test != Circle_test::NOT_DELAUNAY))
      complain("decision", "is_locally_Delaunay() is wrong for edge ", e.idx());
  }

  // Sides of the reference by edge and starting corner are not unique (loops): a face of the
  // package is found by its record.
  void check_numbers(const Exact_triangulation& triangulation, Reference& replay)
  {
    const IT::Delta_complex& complex = triangulation.connectivity();
    std::map<Face_record, Size> side_of_face;
    const Sides& sides = replay.sides();
    for (Size s = 0; s < sides.number_of_sides(); s += 3)
      for (int c = 0; c < 3; ++c)
        side_of_face[record(sides, s + c)] = s + c;
    std::vector<Real> cotangent(complex.number_of_halfedges());
    std::vector<char> has_cotangent(complex.number_of_halfedges(), 0);
    for (IT::Face_index f : complex.faces()) {
      IT::Halfedge_index h = complex.halfedge(f);
      const IT::Halfedge_index n = complex.next(h), p = complex.prev(h);
      Size s = side_of_face.at({complex.edge(h).idx(), complex.source(h).idx(), complex.edge(n).idx(),
                                complex.source(n).idx(), complex.edge(p).idx(), complex.source(p).idx()});
      const Real exact = replay.double_area(s) / 2;
      const double area = triangulation.area(f);
      Real longest = 0;
      for (int c = 0; c < 3; ++c, s = Sides::next(s))
        longest = (std::max)(longest, replay.squared_length_of_side(s));
      if (exact < longest * Real("1e-300")) {
        if (!(area == 0))
          complain("area", "face ", f.idx(), " has no area, the package says ", area);
        continue;
      }
      if (exact < Real(0x1p-1020)) // the bound is meant for normalized numbers
        continue;
      note(result_.worst_area, abs(Real(area) - exact) / exact * Real(0x1p50), area, "area",
           [&] { complain("area", "face ", f.idx(), " has area ", exact, ", the package says ", area); });
      for (int c = 0; c < 3; ++c, s = Sides::next(s), h = complex.next(h)) {
        const Real cot = replay.cotangent(s);
        cotangent[h.idx()] = cot;
        has_cotangent[h.idx()] = 1;
        const double x = triangulation.cotangent(h);
        note(result_.worst_cotangent, abs(Real(x) - cot) / (1 + abs(cot)) * Real(0x1p50), x, "cotangent",
             [&] { complain("cotangent", "of halfedge ", h.idx(), " is ", cot, ", the package says ", x); });
      }
    }
    for (IT::Edge_index e : complex.edges()) {
      Real exact = 0, sum = 1;
      bool has_both = true;
      for (IT::Halfedge_index h : {complex.halfedge(e), complex.opposite(complex.halfedge(e))}) {
        if (complex.is_border(h))
          continue;
        has_both = has_both && has_cotangent[h.idx()];
        exact += cotangent[h.idx()];
        sum += abs(cotangent[h.idx()]);
      }
      if (!has_both)
        continue;
      const double weight = triangulation.cotangent_weight(e);
      note(result_.worst_weight, abs(Real(weight) - exact) / sum * Real(0x1p49), weight, "weight",
           [&] { complain("weight", "of edge ", e.idx(), " is ", exact, ", the package says ", weight); });
      if (!replay.is_flippable(e.idx()))
        continue;
      const Circle_test test = replay.circle_test(e.idx());
      if (test == Circle_test::TIE ? weight != 0 : test == Circle_test::DELAUNAY ? weight < 0 : weight > 0)
        complain("weight", "of edge ", e.idx(), " has another sign: ", weight, " for ", exact);
    }
  }

  template <class Complain>
  void note(double& worst, const Real& error, double x, const char*, Complain complain_about_it)
  {
    const double e = std::isfinite(x) ? static_cast<double>(error) : std::numeric_limits<double>::infinity();
    worst = (std::max)(worst, e);
    if (!(e <= 1))
      complain_about_it();
  }

  static Face_record record(const Sides& sides, Size s)
  {
    const Size n = Sides::next(s), p = Sides::prev(s);
    return {sides.edge[s], sides.corner[s], sides.edge[n], sides.corner[n], sides.edge[p], sides.corner[p]};
  }

  void compare_tessellations(const Edges& package, const Edges& own)
  {
    if (package.size() != own.size())
      complain("tessellation", "it has ", package.size(), " edges, not ", own.size());
    for (std::size_t n = 0; n < (std::min)(package.size(), own.size()); ++n)
      if (package[n].a != own[n].a || package[n].b != own[n].b ||
          abs(package[n].squared_length - own[n].squared_length) > own[n].squared_length * Real("1e-60")) {
        complain("tessellation", "differs in an edge from ", own[n].a, " to ", own[n].b);
        return;
      }
  }

  const Sides& sides_;
  const Metric& metric_;
  const Comparison_options& options_;
  Comparison result_;
  std::map<std::string, int> complaints_;
};

} // namespace detail

// The package's copy of a surface, as yet unflipped.
inline Exact_triangulation exact_triangulation(const samples::Indexed_triangles& surface)
{
  return Exact_triangulation(IT::make_Delta_complex_from_triangles(surface.points.size(), surface.triangles),
                             surface.points);
}
inline Exact_triangulation exact_triangulation(const samples::Glued_triangles& gluing)
{
  IT::Delta_complex complex = IT::make_Delta_complex_from_gluing(gluing.number_of_faces, gluing.glued_sides);
  const Sides sides = sides_of_gluing(gluing.number_of_faces, gluing.glued_sides);
  std::vector<double> lengths(complex.number_of_edges());
  for (Size s = 0; s < sides.number_of_sides(); ++s)
    lengths[sides.edge[s]] = gluing.side_lengths[s];
  return Exact_triangulation::from_lengths(std::move(complex), std::move(lengths));
}

// Compares the results for triangles in space. Errors of the package are passed on.
template <unsigned digits = 510>
Comparison compare(const samples::Indexed_triangles& surface, const Comparison_options& options = {})
{
  Exact_triangulation triangulation = exact_triangulation(surface);
  const Sides sides = sides_of_triangles(surface.triangles);
  return detail::Comparer<digits, std::vector<std::array<double, 3>>>(sides, surface.points, options)
    .run(triangulation);
}

// Compares the results for a surface given by lengths.
template <unsigned digits = 510>
Comparison compare(const samples::Glued_triangles& gluing, const Comparison_options& options = {})
{
  Exact_triangulation triangulation = exact_triangulation(gluing);
  const Sides sides = sides_of_gluing(gluing.number_of_faces, gluing.glued_sides);
  return detail::Comparer<digits, std::vector<double>>(sides, gluing.side_lengths, options).run(triangulation);
}

} // namespace reference

#endif // IDT_TEST_COMPARE_WITH_REFERENCE_H

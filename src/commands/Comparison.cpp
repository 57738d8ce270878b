// Copyright (c) 2026 The Intrinsic_triangulations developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/Comparison.h"

#include "system/Interruption.h"
#include "system/Stopwatch.h"
#include "system/child_process.h"
#include "number_types/run.h"
#include "input/repair.h"
#include "output/write_json.h"

#include <CGAL/Intrinsic_triangulations/errors.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace idt {
namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Json = nlohmann::ordered_json;

const char* status_text(IT::Flip_status status)
{
  switch (status) {
  case IT::Flip_status::DELAUNAY:
    return "done";
  case IT::Flip_status::NOT_FLIPPABLE:
    return "not flippable";
  case IT::Flip_status::INCONSISTENT:
    return "inconsistent";
  case IT::Flip_status::UNDECIDED:
    return "undecided";
  case IT::Flip_status::BUDGET_EXHAUSTED:
    return "flip budget";
  }
  return "";
}

// An edge as a geodesic: its ends, its crossings and its length. Loops and multiple edges differ in the latter two.
struct Geodesic
{
  std::uint32_t v, w;
  std::int64_t crossings;
  double length;

  std::tuple<std::uint32_t, std::uint32_t, std::int64_t> key() const { return {v, w, crossings}; }
  bool operator<(const Geodesic& other) const
  {
    return std::make_pair(key(), length) < std::make_pair(other.key(), other.length);
  }
};

template <class Predicate>
std::vector<Geodesic> sorted_geodesics(const Outcome& outcome, const Predicate& is_wanted)
{
  std::vector<Geodesic> result;
  for (IT::Edge_index e : outcome.connectivity.edges()) {
    if (!is_wanted(e))
      continue;
    const IT::Halfedge_index h = outcome.connectivity.halfedge(e);
    const std::uint32_t v = outcome.connectivity.source(h).idx(), w = outcome.connectivity.target(h).idx();
    result.push_back({(std::min)(v, w), (std::max)(v, w), outcome.crossings[e.idx()], outcome.exact_lengths[e.idx()]});
  }
  std::sort(result.begin(), result.end());
  return result;
}

// The interior edges that every Delaunay triangulation of the surface has.
std::vector<Geodesic> necessary_edges(const Outcome& exact)
{
  return sorted_geodesics(exact,
                          [&](IT::Edge_index e) { return !exact.connectivity.is_border(e) && !exact.is_tie[e.idx()]; });
}

// Both lengths are exact except for the last digits.
std::uint64_t count_missing(const std::vector<Geodesic>& necessary, const Outcome& outcome)
{
  const std::vector<Geodesic> found = sorted_geodesics(outcome, [](IT::Edge_index) { return true; });
  std::uint64_t missing = 0;
  auto candidate = found.begin();
  for (const Geodesic& edge : necessary) {
    const double tolerance = 1e-12 * edge.length;
    while (candidate != found.end() && (candidate->key() < edge.key() || (candidate->key() == edge.key() &&
                                                                          candidate->length < edge.length - tolerance)))
      ++candidate;
    if (candidate != found.end() && candidate->key() == edge.key() && candidate->length <= edge.length + tolerance)
      ++candidate;
    else
      ++missing;
  }
  return missing;
}

double largest_length_error(const Outcome& outcome)
{
  double result = 0;
  for (std::size_t e = 0; e < outcome.numbers.lengths.size(); ++e)
    if (outcome.exact_lengths[e] > 0) {
      const double error = std::abs(outcome.numbers.lengths[e] / outcome.exact_lengths[e] - 1);
      result = (std::max)(result, std::isfinite(error) ? error : (std::numeric_limits<double>::max)());
    }
  return result;
}

// Reorders them. \pre there is one
double median(std::vector<double>& numbers)
{
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

Run_options make_run_options(const Compared_type& type, const Requested_results& wanted)
{
  Run_options options;
  options.number_type = type.number_type;
  if (type.precision)
    options.precision = *type.precision;
  options.wanted = wanted;
  return options;
}

class Surface_comparer
{
public:
  Surface_comparer(const Surface& surface, const Comparison_options& options)
    : surface_(surface), options_(options), counts_wrong_decisions_(options.counts_wrong_decisions.value_or(
                                              surface.connectivity.number_of_edges() < large_number_of_edges))
  {}

  Surface_comparison run()
  {
    find_exact_result();
    for (const Compared_type& type : options_.types)
      result_.rows.push_back(examine(type));
    if (is_interrupted())
      throw IT::Undecided_error(surface_.path + ": cancelled");
    measure_times();
    return std::move(result_);
  }

private:
  // The reference for all results.
  void find_exact_result()
  {
    Requested_results wanted;
    wanted.crossings = wanted.tessellation = wanted.exact_lengths = true;
    const auto goes_on = [](std::uint64_t, std::uint64_t) { return !is_interrupted(); };
    const Outcome exact =
      idt::run({surface_, make_run_options({Number_type::FILTERED, {}}, wanted), goes_on, has_time_to_decide, {}});
    if (!exact.failure.empty())
      throw IT::Undecided_error(surface_.path + ": " + exact.failure);
    if (exact.report.status != IT::Flip_status::DELAUNAY)
      throw IT::Undecided_error(surface_.path + ": cancelled");
    necessary_edges_ = necessary_edges(exact);
    result_.path = surface_.path;
    result_.counts = count_elements(exact.connectivity);
    result_.ties = exact.tessellation->ties;
    result_.repairs = repairs(surface_);
    result_.warnings = surface_.warnings;
  }

  Outcome flip(const Compared_type& type, const Requested_results& wanted) const
  {
    const Stopwatch stopwatch;
    const auto goes_on = [&](std::uint64_t, std::uint64_t) {
      return !is_interrupted() && stopwatch.seconds() < options_.time_limit;
    };
    return idt::run({surface_, make_run_options(type, wanted), goes_on, has_time_to_decide, {}});
  }

  // Runs in a process of its own, because with some number types a decision can take forever, and so can the exact
  // check of a result that is far from right.
  Comparison_row examine(const Compared_type& type) const
  {
    Comparison_row row;
    row.type = type;
    const Child_result child =
      run_in_child_process([&](const Say_function& say) { examine(type, say); }, options_.time_limit + 1);
    for (const std::string& line : child.lines)
      take_over(Json::parse(line), row);
    if (row.status.empty())
      row.status = child.end == Child_result::End::DIED ? "crashed" : "time limit";
    return row;
  }

  void examine(const Compared_type& type, const Say_function& say) const
  {
    Comparison_row row;
    row.type = type;
    try {
      const Outcome outcome = flip(type, {});
      row.status = outcome.are_flips_cancelled ? "time limit" : status_text(outcome.report.status);
      row.flips = outcome.report.flips;
      row.tests = outcome.report.tests;
      row.seconds = outcome.build_seconds + outcome.flip_seconds;
    } catch (const IT::Invalid_surface_error&) {
      row.status = "refused";
    } catch (const IT::Undecided_error&) {
      row.status = "refused";
    } catch (const IT::Integer_overflow_error&) {
      row.status = "overflow";
    }
    say(to_json_value(row).dump());
    if (!row.has_ended())
      return;

    Requested_results wanted;
    wanted.lengths = wanted.crossings = wanted.verification = wanted.exact_lengths = true;
    const Outcome outcome = flip(type, wanted);
    // More flips than the time limit allowed, or more crossings than can be counted.
    if (outcome.report.flips != row.flips || !outcome.failure.empty())
      return;
    row.not_Delaunay = outcome.verification->not_Delaunay.size();
    row.inverted_faces = outcome.verification->inverted.size();
    row.missing_edges = count_missing(necessary_edges_, outcome);
    row.length_error = largest_length_error(outcome);
    say(to_json_value(row).dump());

    if (!counts_wrong_decisions_)
      return;
    wanted = {};
    wanted.wrong_decisions = true;
    const Outcome counted = flip(type, wanted);
    if (counted.report.tests == row.tests) {
      row.wrong_decisions = counted.wrong_decisions;
      say(to_json_value(row).dump());
    }
  }

  static void take_over(const Json& json, Comparison_row& row)
  {
    json.at("status").get_to(row.status);
    json.at("flips").get_to(row.flips);
    json.at("tests").get_to(row.tests);
    json.at("wrong_decisions").get_to(row.wrong_decisions);
    json.at("not_delaunay").get_to(row.not_Delaunay);
    json.at("inverted_faces").get_to(row.inverted_faces);
    json.at("missing_edges").get_to(row.missing_edges);
    json.at("length_error").get_to(row.length_error);
    json.at("seconds").get_to(row.seconds);
  }

  // The number types take turns, so that other load on the machine affects all alike. Those that cannot be interrupted
  // keep the time of their one run.
  void measure_times()
  {
    std::vector<std::vector<double>> times(result_.rows.size());
    std::vector<double> spent(result_.rows.size(), 0);
    const Stopwatch stopwatch;
    const int most = 20 * options_.repetitions;
    for (int round = 0; round < most && !is_interrupted(); ++round) {
      if (round >= options_.repetitions && stopwatch.seconds() > 0.1)
        break;
      for (std::size_t i = 0; i < times.size(); ++i) {
        const Comparison_row& row = result_.rows[i];
        const bool is_slow = row.type.number_type == Number_type::CORE ||
                             row.type.number_type == Number_type::HALF_ANGLE_CORE || spent[i] > options_.time_limit;
        if (!row.has_ended() || is_slow)
          continue;
        const Outcome outcome = flip(row.type, {});
        times[i].push_back(outcome.build_seconds + outcome.flip_seconds);
        spent[i] += times[i].back();
      }
    }
    for (std::size_t i = 0; i < times.size(); ++i)
      if (!times[i].empty())
        result_.rows[i].seconds = median(times[i]);
    for (const Comparison_row& base : result_.rows)
      if (base.type.number_type == Number_type::DOUBLE && base.seconds.value_or(0) > 0)
        for (Comparison_row& row : result_.rows)
          if (row.seconds && row.has_ended())
            row.ratio_to_double = *row.seconds / *base.seconds;
  }

  const Surface& surface_;
  const Comparison_options& options_;
  bool counts_wrong_decisions_;
  std::vector<Geodesic> necessary_edges_;
  Surface_comparison result_;
};

template <class T>
void add(T& sum, const std::optional<T>& summand)
{
  sum += summand.value_or(0);
}

} // namespace

std::string title(const Compared_type& type)
{
  const std::string text = name(type.number_type);
  return type.precision ? text + ' ' + std::to_string(*type.precision) : text;
}

bool Comparison_row::has_ended() const
{
  return status == "done" || status == "not flippable" || status == "inconsistent" || status == "undecided";
}

bool Comparison_row::is_wrong() const
{
  return not_Delaunay.value_or(0) + inverted_faces.value_or(0) + missing_edges.value_or(0) > 0;
}

Surface_comparison compare(const std::string& path, const Comparison_options& options)
{
  Surface surface = load_surface(path, options.repair);
  surface.saved.reset(); // all number types start from the same input
  return Surface_comparer(surface, options).run();
}

std::vector<Comparison_total> totals(const std::vector<Surface_comparison>& comparisons,
                                     const std::vector<Compared_type>& types)
{
  std::vector<Comparison_total> result;
  for (std::size_t i = 0; i < types.size(); ++i) {
    Comparison_total total;
    total.type = types[i];
    std::vector<double> ratios;
    for (const Surface_comparison& comparison : comparisons) {
      const Comparison_row& row = comparison.rows[i];
      ++total.surfaces;
      total.refused += row.was_refused();
      total.not_ended += !row.was_refused() && !row.has_ended();
      total.wrong += row.is_wrong();
      total.unnoticed += row.is_wrong() && row.status == "done";
      add(total.wrong_decisions, row.wrong_decisions);
      add(total.not_Delaunay, row.not_Delaunay);
      add(total.inverted_faces, row.inverted_faces);
      add(total.missing_edges, row.missing_edges);
      if (row.length_error)
        total.length_error = (std::max)(total.length_error.value_or(0), *row.length_error);
      if (row.ratio_to_double)
        ratios.push_back(*row.ratio_to_double);
    }
    if (!ratios.empty())
      total.ratio_to_double = median(ratios);
    result.push_back(total);
  }
  return result;
}

Json to_json_value(const Comparison_row& row)
{
  return {{"number_type", name(row.type.number_type)},
          {"precision", row.type.precision},
          {"status", row.status},
          {"ended", row.has_ended()},
          {"flips", row.flips},
          {"tests", row.tests},
          {"wrong_decisions", row.wrong_decisions},
          {"not_delaunay", row.not_Delaunay},
          {"inverted_faces", row.inverted_faces},
          {"missing_edges", row.missing_edges},
          {"length_error", row.length_error},
          {"seconds", row.seconds},
          {"ratio_to_double", row.ratio_to_double}};
}

Json to_json_value(const Surface_comparison& comparison)
{
  Json rows = Json::array();
  for (const Comparison_row& row : comparison.rows)
    rows.push_back(to_json_value(row));
  return {{"surface", comparison.path},       {"vertices", comparison.counts.vertices},
          {"edges", comparison.counts.edges}, {"faces", comparison.counts.faces},
          {"ties", comparison.ties},          {"repair", to_json_value(comparison.repairs)},
          {"warnings", comparison.warnings},  {"number_types", std::move(rows)}};
}

Json to_json_value(const Comparison_total& total)
{
  return {{"number_type", name(total.type.number_type)},
          {"precision", total.type.precision},
          {"surfaces", total.surfaces},
          {"refused", total.refused},
          {"not_ended", total.not_ended},
          {"wrong", total.wrong},
          {"unnoticed", total.unnoticed},
          {"wrong_decisions", total.wrong_decisions},
          {"not_delaunay", total.not_Delaunay},
          {"inverted_faces", total.inverted_faces},
          {"missing_edges", total.missing_edges},
          {"length_error", total.length_error},
          {"ratio_to_double", total.ratio_to_double}};
}

} // namespace idt
